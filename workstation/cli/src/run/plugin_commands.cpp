#include "run/plugin_commands.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <ostream>
#include <utility>

#include "ew/door/door.h"
#include "ew/door/headless_host.h"

namespace ew::cli {
namespace {

/// The verdict with which a command ends as one without any.
constexpr std::string_view kGoodVerdict = "aligned";

/// The words that name existing files: what the command read, as far as can be seen from outside.
std::vector<std::string> existingFiles(const std::vector<std::string>& words) {
  std::vector<std::string> files;
  for (const auto& word : words) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(word, ignored)) files.push_back(word);
  }
  return files;
}

/// The plugins, and what one of them left to be called: gone before its code is.
struct Loaded {
  explicit Loaded(Progress& progress) : host(progress) {}
  door::HeadlessHost host;
  door::PluginList plugins;
  std::function<Result<void>()> putInPlace;
};

Result<int> runPluginCommand(const std::string& name, const std::vector<std::string>& words, bool help, Run& run) {
  const auto loaded = std::make_shared<Loaded>(run.progress);
  {
    const StepClock clock(run.report, "load plugins");
    loaded->plugins.openAll(loaded->host);
  }
  const auto* command = loaded->host.find(name);
  if (!command) {
    for (const auto& plugin : loaded->plugins.states())
      if (brings(plugin, name) && !plugin.message.empty())
        return failure(ErrorCode::notFound, say<"The plugin that brings '%1' cannot be used: %2">(name, plugin.message),
                       {{"plugin", plugin.title()}});
    return failure(ErrorCode::badUsage,
                   say<"'%1' is neither a command nor a case, volume or sweep that exists; 'echoweave --help' lists the commands.">(name));
  }
  if (help) {
    run.out() << "Usage: echoweave " << command->usage << "\n\nOptions all commands have:\n"
              << "  --report R.json   Write what was done as one JSON object\n"
              << "  --quiet           No progress and no remarks; errors are still told\n"
              << "  --simd SET        Instruction set of the kernels: best, avx3 (AVX-512), avx2, sse4 or scalar\n"
              << "  --verbose         After an error, a second line with its particulars\n";
    return kDone;
  }
  const auto readable = existingFiles(words);
  for (const auto& file : readable)
    if (auto kept = run.protect(file); !kept) return passOn(kept.error());
  const Message stopped = std::exchange(run.stopped, {});  // while it runs, a plugin says itself what it kept
  run.report.options["arguments"] = words;
  auto outcome = [&] {
    const StepClock clock(run.report, name);
    return command->run(words, run.progress);
  }();
  if (!outcome) return passOn(outcome.error());
  run.isPublished = !outcome->putInPlace;
  if (outcome->putInPlace) {
    run.stopped = stopped;
    loaded->putInPlace = std::move(outcome->putInPlace);
    run.putInPlace = [loaded] { return loaded->putInPlace(); };
  }
  for (const auto& file : readable)
    if (std::find(outcome->outputs.begin(), outcome->outputs.end(), file) == outcome->outputs.end()) run.report.inputs.push_back(file);
  run.report.outputs = outcome->outputs;
  for (const auto& [figure, value] : outcome->quality) run.report.quality[figure] = value;
  for (const auto& [step, seconds] : outcome->steps) run.report.addStep(step, 1e6 * seconds);
  for (const auto& note : outcome->notes) run.remark(note);
  for (const auto& file : outcome->outputs) run.say("Wrote " + file + ".");
  if (!outcome->verdict) return kDone;
  run.report.verdict = *outcome->verdict;
  if (!outcome->reason.empty()) run.report.details["reason"] = outcome->reason;
  if (*outcome->verdict == kGoodVerdict) return kDone;
  run.remark(say<"The verdict is \"%1\". %2">(*outcome->verdict, outcome->reason));
  return kVerdict;
}

}  // namespace

Result<void> selectPluginCommand(std::span<const std::string> args, Selection& selection) {
  const std::string name = args.empty() ? std::string() : args.front();
  std::vector<std::string> words;
  bool help = false;
  for (std::size_t at = 1; at < args.size(); ++at) {
    const std::string& word = args[at];
    if (word == "--quiet") {
      selection.quiet = true;
    } else if (word == "--verbose") {
      selection.verbose = true;
    } else if (word == "--help" || word == "-h") {
      help = true;
    } else if (word.starts_with("--report=")) {
      selection.reportFile = word.substr(9);
    } else if (word == "--report") {
      if (at + 1 == args.size()) return failure(ErrorCode::badUsage, say<"--report needs the name of a file to write.">());
      selection.reportFile = args[++at];
    } else if (word.starts_with("--simd=")) {
      selection.simd = word.substr(7);
    } else if (word == "--simd") {
      if (at + 1 == args.size()) return failure(ErrorCode::badUsage, say<"--simd needs an instruction set, such as avx2.">());
      selection.simd = args[++at];
    } else {
      words.push_back(word);
    }
  }
  selection.command = name;
  selection.work = [name, words, help](Run& run) { return runPluginCommand(name, words, help, run); };
  return {};
}

}  // namespace ew::cli
