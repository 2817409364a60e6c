#include "ew/acquisition/gating.h"

#include <algorithm>
#include <cmath>

#include "ew/core/numbers.h"

namespace ew {

Result<BodySignal> recordedSignal(const Sequence& sequence, std::string_view field) {
  BodySignal signal;
  const std::string name(field);
  std::optional<double> before_s;
  for (std::size_t n = 0; n < sequence.frames.size(); ++n) {
    const SequenceFrame& frame = sequence.frames[n];
    const auto found = std::find_if(frame.otherFields.begin(), frame.otherFields.end(), [&](const auto& f) { return f.first == field; });
    if (found != frame.otherFields.end()) {
      const auto values = parseNumbers(found->second);
      if (!values || !frame.time_s)
        return failure(
            ErrorCode::badField,
            values ? say<"Frame %1 has no time for its field %2; gating needs numbers and the frames' times.">(n, name)
                   : say<"Frame %1 has \"%2\" for its field %3; gating needs numbers and the frames' times.">(n, found->second, name),
            {{"field", name}, {"frame", std::to_string(n)}});
      const auto count = static_cast<double>(values->size());
      for (std::size_t v = 0; v < values->size(); ++v) {
        if (values->size() > 1 && !before_s) continue;
        const double share = static_cast<double>(v + 1) / count;
        signal.time_s.push_back(values->size() == 1 ? *frame.time_s : *before_s + share * (*frame.time_s - *before_s));
        signal.value.push_back((*values)[v]);
      }
    }
    if (frame.time_s) before_s = frame.time_s;
  }
  if (signal.time_s.empty())
    return failure(ErrorCode::badField, say<"The recording carries no field %1; gate by another signal or by the images.">(name),
                   {{"field", name}});
  return signal;
}

std::vector<FramePhase> phasesOf(const Cycles& cycles, std::span<const double> time_s) {
  std::vector<FramePhase> phases;
  phases.reserve(time_s.size());
  for (const double t_s : time_s) {
    FramePhase frame;
    if (!std::isfinite(t_s)) {
      frame.verdict = FrameVerdict::noTime;
    } else if (const auto next = std::upper_bound(cycles.starts_s.begin(), cycles.starts_s.end(), t_s);
               next != cycles.starts_s.begin() && next != cycles.starts_s.end()) {
      const auto cycle = static_cast<std::size_t>(next - cycles.starts_s.begin()) - 1;
      const double begin_s = cycles.starts_s[cycle], end_s = *next;
      frame.cycle = static_cast<int>(cycle);
      frame.phase = std::min((t_s - begin_s) / (end_s - begin_s), std::nextafter(1.0, 0.0));
      frame.verdict = cycles.regular[cycle] ? FrameVerdict::accepted : FrameVerdict::irregular;
    }
    phases.push_back(frame);
  }
  return phases;
}

Result<std::vector<std::vector<std::size_t>>> framesOfPhase(std::span<const FramePhase> frames, int phases) {
  const auto accepted = std::count_if(frames.begin(), frames.end(), [](const auto& f) { return f.verdict == FrameVerdict::accepted; });
  if (phases < 1 || phases > accepted)
    return failure(
        ErrorCode::badField,
        say<"%1 phases cannot be made of %2 gated frames; ask for at least 1 and at most as many as there are frames.">(phases, accepted),
        {{"field", "phases"}, {"found", std::to_string(phases)}, {"frames", std::to_string(accepted)}});
  std::vector<std::vector<std::size_t>> lists(static_cast<std::size_t>(phases));
  for (std::size_t n = 0; n < frames.size(); ++n) {
    if (frames[n].verdict != FrameVerdict::accepted) continue;
    const auto bin = static_cast<std::size_t>(frames[n].phase * phases);
    lists[std::min(bin, lists.size() - 1)].push_back(n);
  }
  for (std::size_t k = 0; k < lists.size(); ++k)
    if (lists[k].empty())
      return failure(ErrorCode::badField, say<"Phase %1 of %2 has no frame; ask for fewer phases.">(k + 1, phases),
                     {{"field", "phases"}, {"found", std::to_string(phases)}});
  return lists;
}

Result<Grid> reconstructPhases(std::span<const TrackedFrame> frames, std::span<const std::vector<std::size_t>> framesOfPhases,
                               const ReconstructOptions& options, const KeepPhase& keep, Progress& progress) {
  const auto grid = gridFor(frames, options);
  if (!grid) return passOn(grid.error());
  std::vector<TrackedFrame> part;
  for (std::size_t k = 0; k < framesOfPhases.size(); ++k) {
    part.clear();
    for (const std::size_t n : framesOfPhases[k]) {
      if (n >= frames.size())
        return failure(ErrorCode::badField, say<"Phase %1 names frame %2, which the sweep does not have.">(k + 1, n),
                       {{"field", "frames"}});
      part.push_back(frames[n]);
    }
    const auto count = static_cast<double>(framesOfPhases.size());
    PartOfProgress own(progress, static_cast<double>(k) / count, static_cast<double>(k + 1) / count);
    auto made = reconstructOnto(*grid, part, options, own);
    if (!made) return passOn(made.error());
    if (const auto stored = keep(k, std::move(*made)); !stored) return passOn(stored.error());
  }
  return *grid;
}

}  // namespace ew
