#include "ew/cli/run_command.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <ostream>

#include "ew/core/guarded.h"
#include "ew/core/printable.h"
#include "ew/core/simd.h"
#include "ew/io/safe_file.h"
#include "ew/library/kept_examination.h"
#include "run/access_gate.h"
#include "run/command.h"
#include "run/command_line.h"
#include "run/input_files.h"
#include "run/passphrase_input.h"
#include "run/plugin_commands.h"

namespace ew::cli {
namespace {

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
    tellError(surroundings.err, *run.answered(), selection.verbose);
    return *status;
  }
  tellError(surroundings.err, forTheUser(status.error(), run), selection.verbose);
  return status.error().code == ErrorCode::badUsage ? kWrongUsage : kFailed;
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

int runCommand(std::span<const std::string> args, const Surroundings& surroundings) {
  return runCommandLine(args, surroundings, addAllCommands);
}

int runCommandLine(std::span<const std::string> args, const Surroundings& surroundings, AddCommands* add) {
  Selection selection;
  if (isBuiltIn(args)) {
    if (const auto status = understand(args, surroundings, add, selection)) return *status;
  } else if (auto selected = selectPluginCommand(args, selection); !selected) {
    tellError(surroundings.err, selected.error(), false);
    return kWrongUsage;
  }
  return finish(selection, surroundings);
}

}  // namespace ew::cli
