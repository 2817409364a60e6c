#include "ew/cli/run_command.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <ostream>

#include "ew/core/guarded.h"
#include "ew/core/printable.h"
#include "ew/core/simd.h"
#include "ew/core/version.h"
#include "ew/io/safe_file.h"
#include "ew/library/kept_examination.h"
#include "run/access_gate.h"
#include "run/arguments.h"
#include "run/command.h"
#include "run/command_line.h"
#include "run/input_files.h"
#include "run/passphrase_input.h"
#include "run/plugin_commands.h"

namespace ew::cli {
namespace {

constexpr const char* kDescription =
    "EchoWeave, an ultrasound training workstation. Without a command it opens the window; with one it works without a display.\n"
    "Simulation, not for diagnosis.";

constexpr const char* kFooter =
    "The window:\n"
    "  echoweave [CASE|VOLUME|SWEEP]              opens it there\n"
    "  echoweave --screenshot OUT.png             saves an image of the window and ends\n"
    "  echoweave CASE --lesson ID                 opens a case and begins a lesson of it\n"
    "  echoweave --theme dark|light  --workspace explore|author  --start-page  --size WxH\n"
    "\n"
    "Lengths are mm, coordinates LPS (patient left, posterior, superior). 'echoweave COMMAND --help' explains a command.\n"
    "Exit status: 0 done, 1 it could not be done, 2 wrong usage, 3 done with the answer 'no' or 'cannot tell'.";

std::vector<std::string> builtInNames() {
  return {"import", "screen", "reconstruct", "register", "slice",  "level", "scan",    "replay",  "phantom", "case", "lesson",
          "assess", "key",    "access",      "measure",  "preset", "send",  "records", "tracker", "plugins", kBench};
}

/// What CLI11 did not expect, in the order it was given: CLI11 lists it from the back.
std::string unexpected(const CLI::App& root) {
  std::string listed;
  const auto left = root.remaining(true);
  for (const std::string& word : left) listed += (listed.empty() ? "'" : ", '") + word + "'";
  return listed;
}

/// CLI11's messages, as one sentence with a full stop.
std::string sentenceOf(const CLI::ParseError& error, const std::string& command, const CLI::App& root) {
  std::string text = error.what();
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError))
    if (const std::string words = unexpected(root); !words.empty()) text = "Not expected: " + words;
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  if (text.empty()) text = "The command line could not be understood";
  if (text.front() >= 'a' && text.front() <= 'z') text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text + "; 'echoweave " + (command.empty() ? "" : command + " ") + "--help' shows how.";
}

std::string selectedName(const CLI::App& root) {
  std::string name;
  for (auto chosen = root.get_subcommands(); !chosen.empty(); chosen = chosen.front()->get_subcommands())
    name += (name.empty() ? "" : " ") + chosen.front()->get_name();
  return name;
}

void tell(std::ostream& terminal, const Error& error, bool verbose) {
  PrintableStream err(terminal);
  err << "echoweave: " << printableLine(error.sentence()) << "\n";
  if (verbose) {
    err << "  " << nameOf(error.code);
    for (const auto& [name, value] : error.context) err << "; " << name << ": " << printableLine(value);
    err << "\n";
  }
  err << std::flush;
}

/// Turns whatever a library throws into an Error: nothing leaves the program as an exception.
Result<int> runGuarded(const Work& work, Run& run) {
  return guarded(
      [&] { return work(run); },
      [](const Thrown& thrown) -> Error {
        if (thrown.noMemory)
          return {ErrorCode::tooLarge, say<"There is not enough memory for this; use a coarser spacing or a smaller size.">(), {}};
        return {ErrorCode::internal,
                say<"The program met a problem it did not foresee (%1); please report it with the command you gave.">(thrown.reason),
                {}};
      });
}

/// What the user reads: outputs by the names they were given, and one sentence for every way a library says that it was stopped.
Error forTheUser(Error error, const Run& run) {
  if (error.code == ErrorCode::cancelled && !run.stopped.empty()) error.message = run.stopped;
  return run.outputs.inGivenNames(std::move(error));
}

Result<int> execute(const Selection& selection, Run& run) {
  spdlog::set_level(selection.quiet ? spdlog::level::err : spdlog::level::warn);  // what plugins say while they work
  run.report.command = selection.command;
  const bool asked = !selection.simd.empty();
  if (auto chosen = useSimd(asked ? selection.simd : simdOfEnvironment()); !chosen)
    return failure(chosen.error().code, asked ? say<"--simd cannot be used. %1">(chosen.error().message)
                                              : say<"ECHOWEAVE_SIMD cannot be used. %1">(chosen.error().message));
  AccessPolicy policy = AccessPolicy::of(libraryFolder());
  if (auto passed = passGate(selection.command, selection.unlockFrom, policy); !passed) return passOn(passed.error());
  const bool wantsReport = !selection.reportFile.empty();
  if (wantsReport) {
    if (auto kept = keepsExamination(selection.reportFile); !kept) return passOn(kept.error());
    if (auto announced = run.outputs.announce(selection.reportFile); !announced) return passOn(announced.error());
  }
  auto status = runGuarded(selection.work, run);
  if (!status) return status;
  if (run.progress.cancelRequested() && !run.isPublished) return failure(ErrorCode::cancelled, run.stopped);
  if (wantsReport) {
    const std::string text = run.report.toJson().dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    if (auto written = writeFileSafely(run.outputs.staged(selection.reportFile), text); !written) return passOn(written.error());
  }
  if (auto committed = run.outputs.commit(run.putInPlace); !committed) return passOn(committed.error());
  run.progress.clear();
  run.tellWhatWasDone();
  return status;
}

int finish(const Selection& selection, const Surroundings& surroundings) {
  Run run(surroundings, selection.quiet);
  const auto status = execute(selection, run);
  if (status && !run.answered()) return *status;
  run.progress.clear();
  if (status) {
    tell(surroundings.err, *run.answered(), selection.verbose);
    return *status;
  }
  tell(surroundings.err, forTheUser(status.error(), run), selection.verbose);
  return status.error().code == ErrorCode::badUsage ? kWrongUsage : kFailed;
}

/// The benches are a program of their own; here they have their place among the commands, and a sentence where that program is missing.
void nameBenches(CLI::App& root, Selection& selection) {
  auto& app = *root.add_subcommand(kBench, kBenchDescription);
  app.set_help_flag();  // the program of the benches has it
  app.prefix_command();
  app.callback([&selection] {
    selection.command = kBench;
    selection.work = [](Run&) -> Result<int> {
      return failure(ErrorCode::notFound, say<"The program of the benches, echoweave-bench, is not here; install EchoWeave again.">());
    };
  });
}

void addCommands(CLI::App& root, Selection& selection) {
  addImport(root, selection);
  addScreen(root, selection);
  addReconstruct(root, selection);
  addRegister(root, selection);
  addSlice(root, selection);
  addLevel(root, selection);
  addScan(root, selection);
  addReplay(root, selection);
  addPhantom(root, selection);
  addCase(root, selection);
  addLesson(root, selection);
  addAssess(root, selection);
  addKey(root, selection);
  addAccess(root, selection);
  addMeasure(root, selection);
  addPreset(root, selection);
  addSend(root, selection);
  addRecords(root, selection);
  addTracker(root, selection);
  addPlugins(root, selection);
  nameBenches(root, selection);
}

}  // namespace

void Run::say(const std::string& line) { said_.push_back(line); }

void Run::tellWhatWasDone() {
  if (!quiet_)
    for (const auto& line : said_) out_ << printableLine(line) << "\n";
  out_ << std::flush;
  said_.clear();
}

void Run::remark(const Message& line) {
  if (quiet_) return;
  progress.clear();
  err_ << "note: " << printableLine(line.english()) << "\n" << std::flush;
}

int Run::answer(Error error) {
  answer_ = std::move(error);
  return kFailed;
}

Result<void> Run::input(const std::filesystem::path& file) {
  if (!file.empty()) report.inputs.push_back(file.string());
  return protect(file);
}

Result<void> Run::protect(const std::filesystem::path& file) {
  for (const auto& read : filesBehind(file))
    if (auto kept = outputs.protect(read); !kept) return kept;
  return {};
}

Result<void> Run::output(const std::filesystem::path& file, std::string_view endings) {
  if (auto own = checkSamplesAreItsOwn(file); !own) return own;
  if (auto kept = keepsExamination(file); !kept) return kept;
  auto announced = outputs.announce(file, endings);
  if (announced) report.outputs.push_back(file.string());
  return announced;
}

CLI::App& addCommand(CLI::App& parent, Selection& selection, const std::string& name, const std::string& description,
                     const std::vector<std::string>& examples, Work work) {
  CLI::App& app = *parent.add_subcommand(name, description);
  app.add_option("--report", selection.reportFile,
                 "Write what was done as one JSON object: inputs, outputs, options, seconds, steps, quality, memory")
      ->type_name("R.json");
  app.add_flag("--quiet", selection.quiet, "No progress and no remarks; errors are still told");
  app.add_option(
         "--simd", selection.simd,
         "Instruction set of the kernels: best, avx3 (AVX-512), avx2, sse4 or scalar; the same results, to measure what others get. "
         "Without it ECHOWEAVE_SIMD is asked")
      ->type_name("SET");
  app.add_option("--unlock", selection.unlockFrom, "Where an instructor's passphrase comes from while the library is locked for trainees")
      ->type_name(kPassphraseSource);
  app.add_flag("--verbose", selection.verbose, "After an error, a second line with its particulars");
  std::string footer;
  for (const auto& example : examples) footer += (footer.empty() ? "Examples:\n  echoweave " : "\n  echoweave ") + example;
  app.footer(footer);
  const std::string parentName = parent.get_name();
  const std::string fullName = parentName.empty() || parentName == "echoweave" ? name : parentName + " " + name;
  app.callback([&selection, work = std::move(work), fullName] {
    selection.command = fullName;
    selection.work = work;
  });
  return app;
}

bool isHeadless(std::span<const std::string> args) {
  if (args.empty()) return false;
  const std::string& first = args.front();
  const auto names = builtInNames();
  if (std::find(names.begin(), names.end(), first) != names.end()) return true;
  for (const char* word : {"--help", "-h", "--version", "help"})
    if (first == word) return true;
  return isPluginCommand(first);
}

bool isBench(std::span<const std::string> args) {
  const auto asksForHelp = [](const std::string& word) { return word == "--help" || word == "-h" || word == "help"; };
  const auto first = std::find_if_not(args.begin(), args.end(), asksForHelp);
  return first != args.end() && *first == kBench;
}

int runCommand(std::span<const std::string> args, const Surroundings& surroundings) {
  return runCommandLine(args, surroundings, addCommands);
}

int runCommandLine(std::span<const std::string> args, const Surroundings& surroundings, void (*add)(CLI::App& root, Selection& selection)) {
  Selection selection;
  CLI::App root(kDescription, "echoweave");
  root.set_version_flag("--version", std::string("echoweave ") + kVersion, "The program's version");
  root.require_subcommand(1);
  root.get_formatter()->column_width(34);
  add(root, selection);
  root.footer(kFooter);  // last, because groups of commands inherit what the root has when they are made

  const auto builtIn = builtInNames();
  const bool ours = args.empty() || args.front().starts_with("-") || args.front() == "help" ||
                    std::find(builtIn.begin(), builtIn.end(), args.front()) != builtIn.end();
  if (!ours) {
    if (auto selected = selectPluginCommand(args, selection); !selected) {
      tell(surroundings.err, selected.error(), false);
      return kWrongUsage;
    }
    return finish(selection, surroundings);
  }
  describePluginCommands(root);
  try {
    std::vector<std::string> words = joinNumberLists(args);
    if (!words.empty() && words.front() == "help") words.front() = "--help";
    std::reverse(words.begin(), words.end());  // CLI11 takes the words from the back
    root.parse(words);
  } catch (const CLI::Success& wish) {
    PrintableStream out(surroundings.out), err(surroundings.err);  // plugins describe their commands themselves
    root.exit(wish, out, err);
    out.flush();
    return kDone;
  } catch (const CLI::ParseError& error) {
    tell(surroundings.err, {ErrorCode::badUsage, verbatim(sentenceOf(error, selectedName(root), root)), {}}, false);
    return kWrongUsage;
  }
  return finish(selection, surroundings);
}

}  // namespace ew::cli
