#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ew/acquisition/reconstruct.h"
#include "ew/core/image.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/io/sequence.h"

namespace ew {

/// A signal of the body, sampled evenly or not. Values that are not finite are left out; of equal times the first counts.
struct BodySignal {
  std::vector<double> time_s;
  std::vector<double> value;  ///< one per time
};

/// The signal that a recording carries beside its frames (see ew/io/gating_fields.h). A frame may carry several values: they lie evenly
/// between the frame before and this one, the last at this one.
/// @error badField (no frame has this field, frames without times, or a value that is no number)
[[nodiscard]] Result<BodySignal> recordedSignal(const Sequence& sequence, std::string_view field);

/// Cycles of heart or breath: cycle n runs from starts_s[n] to starts_s[n + 1].
struct Cycles {
  std::vector<double> starts_s;  ///< rising
  std::vector<bool> regular;     ///< starts_s.size() - 1: whether a cycle is about as long as those around it
  double rate_perMin = 0.0;      ///< of the median regular cycle
  double confidence = 0.0;       ///< 0..1: how far what was found stands out of what was not, and how regular it is
  bool inverted = false;         ///< ECG: R peaks point downwards
  std::size_t irregular = 0;     ///< cycles that are not regular: gaps, extra beats
  std::size_t bridged = 0;       ///< starts put in evenly where the signal missed one to three
  std::vector<Message> notes;
};

struct EcgOptions {
  double lowest_perMin = 30.0;
  double highest_perMin = 220.0;
  double irregularShare = 0.2;      ///< a cycle that differs more from the median of its neighbours is irregular
  bool bridgeMissedBeats = true;    ///< a cycle of two to four usual lengths is taken as beats missed
  double leastSignalToNoise = 4.0;  ///< median R peak over the spread of the band-passed signal between beats
  double leastSamplesPerSecond = 25.0;
};

/// R peaks of an electrocardiogram of either polarity; a cycle begins at each. Band-pass of 5 to 15 Hz without delay, squared slope, mean
/// over 150 ms, thresholds that follow signal and noise, refractory time of 200 ms, T waves told by their slope, search back for missed
/// beats; the peak's time is that of the band-passed extremum, between samples by a parabola.
/// Source: Pan & Tompkins, IEEE Trans. Biomed. Eng. 32(3), 1985. Ours differs: filters run both ways, starting thresholds come from the
/// whole record, one peak moves a threshold by at most three times its height, polarity is found, and noise is refused.
/// @error badField (sizes that differ, time that runs backwards), unsupported with the reason: constant, too few samples a second, no R
///        peaks that stand out, fewer than two beats
[[nodiscard]] Result<Cycles> findHeartBeats(const BodySignal& ecg, const EcgOptions& options = {});

struct BreathOptions {
  double lowest_perMin = 4.0;
  double highest_perMin = 45.0;
  double irregularShare = 0.35;
  double leastConfidence = 0.5;
  bool fallsWithInspiration = false;  ///< of a belt or sensor that is mounted the other way round
};

/// Breaths of a respiration signal; a cycle begins at full inspiration, the sharper end of a breath. The period is the first high peak of
/// the autocorrelation, drift is what the mean over one period says, and a breath is a maximum above it.
/// @error as findHeartBeats
[[nodiscard]] Result<Cycles> findBreaths(const BodySignal& respiration, const BreathOptions& options = {});

enum class Rhythm { heart, breath };

struct ImageGateOptions {
  Rhythm rhythm = Rhythm::heart;
  double lowest_perMin = 0.0;   ///< 0: 40 for the heart, 5 for the breath
  double highest_perMin = 0.0;  ///< 0: 180 for the heart, 40 for the breath
  double irregularShare = 0.35;
  double leastConfidence = 0.6;
  int threads = 0;  ///< 0: all cores; the result does not depend on it
};

/// Cycles seen in the images alone. Frames are reduced to 24 x 24 cells. The rhythm is the tone that stands out of its neighbours in the
/// power spectrum of all cells: a moved probe, whose speckle flickers at every rate, makes a broad spectrum and no tone. Around it, with
/// slow change taken away, one principal component is followed through overlapping windows, which are joined by what they share; the
/// joined signal's maxima begin the cycles. Which moment of heart or breath phase 0 is, images do not say; it is the same one throughout.
/// The signal's sign is chosen so that it rises faster than it falls, as a pulse does.
/// Confidence is the smallest of: the share of the tone's power that its neighbours do not have, and the correlation of the followed
/// signal with itself one period later, in windows and as a whole. A probe that is moved to and fro at a heart's rate cannot be told from
/// a heart.
/// @param frames one size, one per time
/// @param time_s rising; of equal times the first counts
/// @error badField (sizes, time that runs backwards or is not finite), unsupported with the reason: images that do not change, fewer than
///        three cycles of the slowest rhythm, too few frames a second, no periodic signal; cancelled
[[nodiscard]] Result<Cycles> findCyclesInImages(std::span<const ImageView<const std::uint8_t>> frames, std::span<const double> time_s,
                                                const ImageGateOptions& options, Progress& progress);

enum class FrameVerdict {
  accepted,
  outside,    ///< before the first or after the last start: nobody knows how long that cycle is
  irregular,  ///< in an irregular cycle
  noTime      ///< the frame has no time
};

struct FramePhase {
  double phase = 0.0;  ///< [0, 1): share of the cycle that has passed, in time
  int cycle = -1;      ///< index into Cycles::starts_s; -1 when outside
  FrameVerdict verdict = FrameVerdict::outside;
  bool operator==(const FramePhase&) const = default;
};

/// Phase of each frame; a time that is not finite is none.
[[nodiscard]] std::vector<FramePhase> phasesOf(const Cycles& cycles, std::span<const double> time_s);

/// Indices of the accepted frames of each phase: phase k holds [k / phases, (k + 1) / phases) of the cycle.
/// @error badField (phases below 1 or more than there are accepted frames, a phase without a frame)
[[nodiscard]] Result<std::vector<std::vector<std::size_t>>> framesOfPhase(std::span<const FramePhase> frames, int phases);

/// Called with each volume in turn; an Error stops the work and is passed on.
using KeepPhase = std::function<Result<void>(std::size_t phase, ReconstructResult made)>;

/// One volume per phase, all on the grid of all frames together, so that voxel by voxel they are the same place. One volume is in memory
/// at a time: the forecast is that of one reconstruction.
/// @param framesOfPhases indices into `frames`, each list not empty
/// @error as reconstruct, and what `keep` returns
[[nodiscard]] Result<Grid> reconstructPhases(std::span<const TrackedFrame> frames, std::span<const std::vector<std::size_t>> framesOfPhases,
                                             const ReconstructOptions& options, const KeepPhase& keep, Progress& progress);

}  // namespace ew
