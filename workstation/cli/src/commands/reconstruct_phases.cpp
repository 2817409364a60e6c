#include "commands/reconstruct_phases.h"

#include <cmath>

#include "ew/core/numbers.h"
#include "ew/core/word_table.h"
#include "ew/io/volume_file.h"
#include "ew/library/gate_sweep.h"
#include "run/arguments.h"

namespace ew::cli {
namespace {

GateBy gateOf(const std::string& word) {
  if (word == "ecg") return GateBy::ecg;
  if (word == "respiration") return GateBy::respiration;
  return word == "images" ? GateBy::images : GateBy::automatic;
}

constexpr WordTable<GateBy, 4> kGateByWords{
    {{"ecg", GateBy::ecg}, {"respiration", GateBy::respiration}, {"images", GateBy::images}, {"automatic", GateBy::automatic}}};
const char* nameOf(GateBy by) { return wordIn(kGateByWords, by); }

}  // namespace

Result<void> applyTo(SweepImportOptions& options, const AcquisitionArguments& arguments, Run& run) {
  if (!arguments.phases && (arguments.gate != "automatic" || arguments.rhythm != "heart"))
    return failure(ErrorCode::badUsage, say<"--gate and --rhythm say how to find phases; give --phases N with them.">());
  options.motor = arguments.motor;
  if (arguments.motor != kRecordedMotor)
    if (auto kept = run.input(arguments.motor); !kept) return kept;
  if (arguments.timeOffset == "estimate") {
    options.estimatePoseDelay = true;
  } else if (!arguments.timeOffset.empty()) {
    const auto delay_s = parseNumber(arguments.timeOffset);
    // The clocks of two files may count from any moment, as from 1970.
    const double largest_s = options.poses.empty() ? 1000.0 : 1e11;
    if (!delay_s || !(std::abs(*delay_s) <= largest_s))
      return failure(
          ErrorCode::badUsage,
          say<"The time offset '%1' is neither a number of seconds nor the word estimate; give one of them.">(arguments.timeOffset));
    options.poseDelay_s = *delay_s;
  }
  return {};
}

bool delayUntold(const ImportPlan& plan, Run& run) {
  if (!plan.poseDelay) return false;
  run.report.details["pose_delay"] = {{"delay_s", plan.poseDelay->delay_s},
                                      {"uncertainty_s", plan.poseDelay->uncertainty_s},
                                      {"correlation", plan.poseDelay->correlation},
                                      {"seen_by", plan.poseDelay->seenBy.english()}};
  if (plan.poseDelay->verdict == DelayVerdict::found) return false;
  run.report.verdict = "cannot tell";
  run.say("Nothing was written. Give the offset in seconds, or 0, to go on without.");
  return true;
}

Result<void> announcePhases(Run& run, const std::string& output, const std::string& coverage, int phases) {
  const auto count = static_cast<std::size_t>(phases);
  for (std::size_t k = 0; k < count; ++k) {
    if (auto announced = run.output(numbered(output, k, count), ".mha .mhd"); !announced) return passOn(announced.error());
    if (coverage.empty()) continue;
    if (auto announced = run.output(numbered(coverage, k, count), ".mha .mhd"); !announced) return passOn(announced.error());
  }
  return {};
}

Result<int> writePhases(const SweepInput& opened, const AcquisitionArguments& arguments, const std::string& output,
                        const std::string& coverage, Run& run, Progress& progress) {
  GateOptions gating;
  gating.by = gateOf(arguments.gate);
  gating.rhythm = arguments.rhythm == "breath" ? Rhythm::breath : Rhythm::heart;
  gating.threads = opened.plan.reconstruct.threads;
  PartOfProgress looking(progress, 0.0, 0.2), making(progress, 0.2, 1.0);
  const auto gate = [&] {
    const StepClock clock(run.report, "gate");
    return gateSweep(opened, gating, looking);
  }();
  if (!gate) return passOn(gate.error());
  for (const auto& note : gate->notes) run.remark(note);

  const int phases = arguments.phases.value_or(1);
  const auto count = static_cast<std::size_t>(phases);
  const auto keep = [&](std::size_t k, const ReconstructResult& made) -> Result<void> {
    run.report.addStep("paste", made.pasteSeconds * 1e6);
    const StepClock clock(run.report, "write");
    if (auto written = writeVolume(made.volume, run.outputs.staged(numbered(output, k, count)), noProgress()); !written)
      return passOn(written.error());
    if (coverage.empty()) return {};
    return writeCoverage(made.volume, run.outputs.staged(numbered(coverage, k, count)), noProgress());
  };
  const auto grid = importPhases(opened, *gate, phases, keep, making);
  if (!grid) return passOn(grid.error());
  run.report.quality = {{"frames_total", opened.plan.frames.total},
                        {"frames_used", gate->accepted},
                        {"frames_outside_cycles", gate->outside},
                        {"frames_in_irregular_cycles", gate->irregular},
                        {"rate_per_min", gate->cycles.rate_perMin},
                        {"cycles", gate->cycles.regular.size()},
                        {"cycles_irregular", gate->cycles.irregular},
                        {"gate_confidence", gate->cycles.confidence},
                        {"voxels", grid->voxelCount()}};
  run.report.details["gated_by"] = nameOf(gate->by);
  run.say("Wrote " + counted(count, "volume") + ", " + numbered(output, 0, count).filename().string() + " first: phases of " +
          counted(gate->cycles.regular.size(), "cycle") + " at " + rounded(gate->cycles.rate_perMin, 1) + " a minute, by " +
          nameOf(gate->by) + " (confidence " + rounded(gate->cycles.confidence, 2) + ").");
  run.say("Used " + std::to_string(gate->accepted) + " of " + counted(gate->frames.size(), "frame") + "; " + std::to_string(gate->outside) +
          " lie outside full cycles and " + std::to_string(gate->irregular) + " in irregular ones.");
  return kDone;
}

}  // namespace ew::cli
