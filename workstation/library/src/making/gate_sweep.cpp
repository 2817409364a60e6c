#include "ew/library/gate_sweep.h"

#include <limits>
#include <string_view>

#include "ew/io/gating_fields.h"

namespace ew {
namespace {

Result<Cycles> byEcg(const Sequence& sequence) {
  const auto signal = recordedSignal(sequence, fields::kEcg);
  if (!signal) return passOn(signal.error());
  return findHeartBeats(*signal);
}

Result<Cycles> byRespiration(const Sequence& sequence) {
  const auto signal = recordedSignal(sequence, fields::kRespiration);
  if (!signal) return passOn(signal.error());
  return findBreaths(*signal);
}

Result<Cycles> byImages(const Sequence& sequence, std::span<const double> time_s, const GateOptions& options, Progress& progress) {
  std::vector<ImageView<const std::uint8_t>> images;
  for (std::size_t n = 0; n < sequence.frames.size(); ++n)
    images.push_back({sequence.framePixels(n).data(), sequence.width, sequence.height, sequence.width});
  ImageGateOptions gating;
  gating.rhythm = options.rhythm;
  gating.threads = options.threads;
  return findCyclesInImages(images, time_s, gating, progress);
}

bool carries(const Sequence& sequence, std::string_view field) {
  for (const SequenceFrame& frame : sequence.frames)
    for (const auto& [name, value] : frame.otherFields)
      if (name == field) return true;
  return false;
}

}  // namespace

Result<SweepGate> gateSweep(const SweepInput& opened, const GateOptions& options, Progress& progress) {
  const Sequence& sequence = opened.sequence;
  std::vector<double> time_s, posed_s;
  for (std::size_t n = 0; n < sequence.frames.size(); ++n) {
    time_s.push_back(sequence.frames[n].time_s.value_or(std::numeric_limits<double>::quiet_NaN()));
    if (opened.poses.imageToWorld[n]) posed_s.push_back(time_s.back());
  }
  SweepGate gate;
  std::optional<Cycles> cycles;
  const auto take = [&](GateBy by, Result<Cycles> found) -> std::optional<Error> {
    if (!found) return found.error();
    gate.by = by;
    cycles = *std::move(found);
    return std::nullopt;
  };
  const bool automatic = options.by == GateBy::automatic;
  if (options.by == GateBy::ecg || (automatic && carries(sequence, fields::kEcg)))
    if (auto problem = take(GateBy::ecg, byEcg(sequence))) {
      if (!automatic) return passOn(std::move(*problem));
      gate.notes.push_back(std::move(problem->message));
    }
  if (!cycles && (options.by == GateBy::respiration || (automatic && carries(sequence, fields::kRespiration))))
    if (auto problem = take(GateBy::respiration, byRespiration(sequence))) {
      if (!automatic) return passOn(std::move(*problem));
      gate.notes.push_back(std::move(problem->message));
    }
  if (!cycles)
    if (auto problem = take(GateBy::images, byImages(sequence, time_s, options, progress))) return passOn(std::move(*problem));

  gate.cycles = *std::move(cycles);
  gate.notes.insert(gate.notes.end(), gate.cycles.notes.begin(), gate.cycles.notes.end());
  gate.frames = phasesOf(gate.cycles, posed_s);
  for (const FramePhase& frame : gate.frames) {
    gate.accepted += frame.verdict == FrameVerdict::accepted ? 1 : 0;
    gate.outside += frame.verdict == FrameVerdict::outside ? 1 : 0;
    gate.irregular += frame.verdict == FrameVerdict::irregular ? 1 : 0;
  }
  return gate;
}

Result<Grid> importPhases(const SweepInput& opened, const SweepGate& gate, int phases, const KeepPhase& keep, Progress& progress) {
  if (!opened.plan.fits)
    return failure(ErrorCode::tooLarge,
                   say<"A volume of this sweep needs more memory than allowed; use a coarser spacing or allow more memory.">(),
                   {{"bytes", std::to_string(opened.plan.bytes)}});
  const auto lists = framesOfPhase(gate.frames, phases);
  if (!lists) return passOn(lists.error());
  const bool weighing = opened.plan.reconstruct.compounding == Compounding::weighted;
  PartOfProgress before(progress, 0.0, weighing ? 0.3 : 0.0), making(progress, weighing ? 0.3 : 0.0, 1.0);
  const auto weighed = weighedFrames(opened, before);
  if (!weighed) return passOn(weighed.error());
  return reconstructPhases(weighed->frames, *lists, opened.plan.reconstruct, keep, making);
}

}  // namespace ew
