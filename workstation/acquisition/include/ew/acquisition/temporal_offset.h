#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/image.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew {

/// Poses of a recording's frames; empty where a pose cannot be used.
using FramePoses = std::vector<std::optional<Transform<frame::World, frame::Image>>>;

/// The poses at the moments time_s + delay_s, between those recorded at time_s: the image's middle moves along a line, the image turns by
/// the shortest way (slerp). Never across a frame without a pose, nor between poses further apart than `longestGap_s`, nor beyond the ends;
/// there the result is empty. With delay 0 every pose stays as it is.
/// @param time_s           one per pose; of equal times the first counts
/// @param delay_s          poses lag behind images by this much
/// @param centre_px        the pixel whose way is a line
/// @param longestGap_s     0: three times the median time between frames
/// @error badField (sizes that differ, times that are not finite or run backwards, a delay that is not finite)
[[nodiscard]] Result<FramePoses> posesDelayedBy(double delay_s, std::span<const double> time_s, const FramePoses& poses,
                                                const glm::dvec2& centre_px, double longestGap_s = 0.0);

struct PoseDelayOptions {
  double largest_s = 0.5;         ///< delays from -largest_s to largest_s are tried
  double leastCorrelation = 0.6;  ///< of movement in images and poses
  double longestGap_s = 0.0;      ///< see posesDelayedBy
  int threads = 0;                ///< 0: all cores; the result does not depend on it
};

enum class DelayVerdict { found, cannotTell };

/// By how much poses lag behind images.
struct PoseDelay {
  DelayVerdict verdict = DelayVerdict::cannotTell;
  double delay_s = 0.0;        ///< give it to posesDelayedBy
  double uncertainty_s = 0.0;  ///< standard deviation, from leaving out each eighth of the sweep in turn
  double correlation = 0.0;    ///< of movement seen and movement tracked at this delay
  Message seenBy = {};         ///< what the images were watched for: "shift along the beam", "shift across the beam", "change"
  Message why = {};            ///< cannotTell: a sentence
};

/// Compares how images move and change from frame to frame with how the poses say they should, at every delay.
/// Three signals are tried and the one with the smallest uncertainty among those that correlate well is taken: the shift of the images' row
/// means (along the beam) and column means (across), against the shift that two poses give the image's content; and the change
/// sqrt(-2 ln r), r the correlation of two successive images, against the way of the image's middle, to which it is proportional while
/// speckle decorrelates like a Gaussian. Delays are tried in steps of an eighth of a frame, with a parabola through the best.
/// Cannot tell when: the probe moves too evenly, nothing correlates, another delay does about as well (a regular to and fro), or the best
/// lies at the end of the range.
/// @param frames, time_s, poses one each per frame, in order
/// @error badField (sizes that differ, times), cancelled
[[nodiscard]] Result<PoseDelay> estimatePoseDelay(std::span<const ImageView<const std::uint8_t>> frames, std::span<const double> time_s,
                                                  const FramePoses& poses, const PoseDelayOptions& options, Progress& progress);

}  // namespace ew
