#include "run/command_line.h"

#include <algorithm>
#include <ostream>

#include "ew/core/printable.h"
#include "ew/core/version.h"
#include "run/arguments.h"
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
  return {"import",   "screen",  "reconstruct", "register", "slice",   "level",   "surfaces", "scan",
          "replay",   "phantom", "case",        "lesson",   "assess",  "key",     "access",   "measure",
          "criteria", "preset",  "send",        "records",  "tracker", "plugins", kBench};
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

}  // namespace

void tellError(std::ostream& terminal, const Error& error, bool verbose) {
  PrintableStream err(terminal);
  err << "echoweave: " << printableLine(error.sentence()) << "\n";
  if (verbose) {
    err << "  " << nameOf(error.code);
    for (const auto& [name, value] : error.context) err << "; " << name << ": " << printableLine(value);
    err << "\n";
  }
  err << std::flush;
}

CLI::App& addCommandOf(CLI::App& parent, Selection& selection, const std::string& name, const std::string& description,
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

bool isBuiltIn(std::span<const std::string> args) {
  if (args.empty() || args.front().starts_with("-") || args.front() == "help") return true;
  const auto names = builtInNames();
  return std::find(names.begin(), names.end(), args.front()) != names.end();
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

std::optional<int> understand(std::span<const std::string> args, const Surroundings& surroundings, AddCommands* add, Selection& selection) {
  CLI::App root(kDescription, "echoweave");
  root.set_version_flag("--version", std::string("echoweave ") + kVersion, "The program's version");
  root.require_subcommand(1);
  root.get_formatter()->column_width(34);
  add(root, selection);
  root.footer(kFooter);  // last, because groups of commands inherit what the root has when they are made
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
    tellError(surroundings.err, {ErrorCode::badUsage, verbatim(sentenceOf(error, selectedName(root), root)), {}}, false);
    return kWrongUsage;
  }
  return std::nullopt;
}

}  // namespace ew::cli
