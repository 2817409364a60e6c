#include "commands/phantom_sweep.h"

#include <algorithm>

#include "ew/core/numbers.h"
#include "ew/core/parallel.h"
#include "ew/io/safe_file.h"
#include "ew/library/case.h"
#include "ew/phantom/virtual_sweep.h"
#include "run/arguments.h"

namespace ew::cli {
namespace {

Result<Probe> probeOf(const SweepRecipe& recipe) {
  const auto probes = shippedProbes();
  if (!probes) return passOn(probes.error());
  std::string ids;
  for (const auto& probe : *probes) {
    if (probe.id == recipe.probe) return probe;
    ids += (ids.empty() ? "" : ", ") + probe.id;
  }
  return failure(ErrorCode::badField, say<"The sweep is made with the probe '%1', but there are only %2.">(recipe.probe, ids),
                 {{"field", "probe"}, {"found", recipe.probe}, {"expected", ids}});
}

/// One pose a line, as `--pose` reads them.
std::string posesText(const VirtualSweep& sweep) {
  std::string text = "# Where the probe truly was, frame by frame: probe to world, 16 numbers row by row, mm, LPS.\n";
  for (const auto& pose : sweep.trueProbeToWorld) {
    std::string line;
    for (const double number : rowsOf(pose.matrix)) line += (line.empty() ? "" : " ") + textOf(number);
    text += line + "\n";
  }
  return text;
}

std::size_t invalidFrames(const Sequence& sequence) {
  const auto lost = [](const SequenceFrame& frame) {
    return std::any_of(frame.transforms.begin(), frame.transforms.end(),
                       [](const FrameTransform& transform) { return transform.status != PoseStatus::ok; });
  };
  return static_cast<std::size_t>(std::count_if(sequence.frames.begin(), sequence.frames.end(), lost));
}

}  // namespace

Result<void> announceSweep(const SweepArguments& arguments, Run& run) {
  if (arguments.sweep.empty()) {
    if (!arguments.output.empty() || !arguments.truePoses.empty() || !arguments.deviceSet.empty())
      return failure(ErrorCode::badUsage,
                     say<"--output, --truth-poses and --device-set belong to a sweep; give its file with --sweep SWEEP.json.">());
    return {};
  }
  if (arguments.output.empty()) return failure(ErrorCode::badUsage, say<"Say where to write the sweep: -o SWEEP.igs.mha.">());
  if (auto kept = run.input(arguments.sweep); !kept) return kept;
  if (auto announced = run.output(arguments.output, ".mha"); !announced) return announced;
  if (!arguments.truePoses.empty())
    if (auto announced = run.output(arguments.truePoses); !announced) return announced;
  if (!arguments.deviceSet.empty())
    if (auto announced = run.output(arguments.deviceSet, ".xml"); !announced) return announced;
  return {};
}

Result<void> makeSweep(const SweepArguments& arguments, const std::shared_ptr<const Patient>& patient, int threads, Run& run,
                       Progress& progress) {
  const auto recipe = readSweepRecipe(arguments.sweep);
  if (!recipe) return passOn(recipe.error());
  const auto probe = probeOf(*recipe);
  if (!probe) return passOn(probe.error());
  const auto forecast = forecastSweep(*patient, *probe, *recipe);
  if (!forecast) return passOn(forecast.error());
  PartOfProgress recording(progress, 0.0, 0.95);
  auto sweep = [&] {
    const StepClock clock(run.report, "record");
    return recordSweep(patient, *probe, *recipe, threads, recording);
  }();
  if (!sweep) return passOn(sweep.error());
  const Sequence& sequence = sweep->sequence;

  const StepClock clock(run.report, "write");
  PartOfProgress writing(progress, 0.95, 1.0);
  if (auto written = writeSequence(sequence, run.outputs.staged(arguments.output), writing); !written) return written;
  if (!arguments.truePoses.empty())
    if (auto written = writeFileSafely(run.outputs.staged(arguments.truePoses), posesText(*sweep)); !written) return written;
  if (!arguments.deviceSet.empty())
    if (auto written = writeDeviceSet(sweep->deviceSet, run.outputs.staged(arguments.deviceSet)); !written) return written;

  const std::size_t invalid = invalidFrames(sequence);
  run.report.quality["frames"] = sequence.frames.size();
  run.report.quality["frames_invalid"] = invalid;
  run.report.quality["width_px"] = sequence.width;
  run.report.quality["height_px"] = sequence.height;
  run.report.quality["pixel_mm"] = sweep->imageToProbe[0][0];
  run.report.quality["forecast_mib"] = static_cast<double>(forecast->bytes) / 1048576.0;
  run.report.details["sweep"] = {{"name", recipe->name}, {"probe", probe->id}, {"scatterer_seed", recipe->seed}};
  std::string made = "Wrote " + arguments.output + ": " + counted(sequence.frames.size(), "frame") + " of " +
                     std::to_string(sequence.width) + " x " + std::to_string(sequence.height) +
                     (recipe->scanLines ? " samples and lines" : " pixels of " + rounded(sweep->imageToProbe[0][0], 3) + " mm");
  if (invalid > 0) made += ", " + std::to_string(invalid) + " with an INVALID pose";
  run.say(made + ".");
  if (!arguments.truePoses.empty()) run.say("Wrote " + arguments.truePoses + ".");
  if (!arguments.deviceSet.empty()) run.say("Wrote " + arguments.deviceSet + ".");
  return {};
}

}  // namespace ew::cli
