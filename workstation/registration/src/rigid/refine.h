#pragma once

#include <optional>
#include <vector>

#include "../comparable.h"
#include "ew/registration/rigid.h"
#include "pose_search.h"

namespace ew::registration {

/// Both sides at every level, coarse first, ready for descents.
struct PairLevels {
  std::vector<ComparableImage> fixed;
  std::vector<ComparableImage> moving;  ///< values and weights of the levels nobody searches are given up after packing
  std::vector<KernelImage> packedMoving;
  std::size_t agreement = 0;     ///< the level figures of agreement are taken from: the finest of 1.4 mm or coarser, else the coarsest
  double voxelsPerSample = 1.0;  ///< there
  double fixedCovered_mm3 = 0.0;
  double movingCovered_mm3 = 0.0;
};
/// @error as comparableImages; tooLarge
[[nodiscard]] Result<PairLevels> preparePair(const Input& fixed, const Input& moving, const std::vector<double>& voxel_mm, int threads,
                                             Progress& progress);
[[nodiscard]] std::uint64_t forecastPair_bytes(const Grid& fixed, const Grid& moving, const std::vector<double>& voxel_mm);

/// Why nothing can be said about this pair whatever the pose, or nothing.
[[nodiscard]] std::optional<Remark> whyNothingCanBeSaid(const PairLevels& pair);

/// Agreement at a pose, and its significance.
struct Evidence {
  Agreement agreement;
  double samples = 0.0;       ///< independent ones in the overlap
  double significance = 0.0;  ///< Fisher z times the root of the samples
};
/// RemarkCode::… with the figures before, and behind them those of the agreement.
[[nodiscard]] Remark remarkWith(RemarkCode what, std::vector<double> figures, const Evidence& evidence);
/// What a good agreement (kGoodCorrelation) over as many samples would reach.
[[nodiscard]] double mostSignificance(const Evidence& evidence);
/// @return false when cancelled
[[nodiscard]] bool evidenceAt(const PairLevels& pair, std::size_t level, const Transform<frame::Moving, frame::Fixed>& fixedToMoving,
                              double voxelsPerSample, int threads, Progress& progress, Evidence& evidence);

/// From `start` through levels [first, last]; fills everything of the result but verdict, reason, before, after and halves.
/// @return false when cancelled
[[nodiscard]] bool refineThrough(const PairLevels& pair, std::size_t first, std::size_t last,
                                 const Transform<frame::Moving, frame::Fixed>& start, const RefineOptions& options, int threads,
                                 Progress& progress, const OnLevel& onLevel, RigidResult& result);

/// Gives up the pose that refineThrough found for `kept`, which agrees better at the level of agreement. What was found is another reading
/// of the same images: the stated error grows by how far the two are apart.
void keepInstead(const Transform<frame::Moving, frame::Fixed>& kept, RigidResult& result);

/// Which way streaks may run: given with the inputs or found in their images, best first.
struct Streaks {
  std::vector<Beams> fixed;
  std::vector<Beams> moving;
  bool found = false;  ///< at least one was, so that `pair` still shows it
};
[[nodiscard]] Streaks streaksOf(const Input& fixed, const Input& moving, const PairLevels& pair, int threads, Progress& progress);

/// How a pose fares where streaks were taken out.
struct WithoutStreaks {
  Transform<frame::Moving, frame::Fixed> fixedToMoving;  ///< where it goes
  PoseDifference moved;                                  ///< by how much, at the middle of the overlap
  Evidence evidence;                                     ///< there
  bool rests = false;                                    ///< the pose rested on the streaks: it goes elsewhere, or is no longer believed
};
/// Takes streaks out and sees how `pose` fares by descending through `first` to the level of agreement. When it rested on them and there is
/// doubt which way they run, `pair` becomes that without them which agrees best elsewhere.
/// @param pair replaced
/// @param sure significance a pose is believed from
/// @error as preparePair
[[nodiscard]] Result<WithoutStreaks> fareWithoutStreaks(const Input& fixed, const Input& moving, const Streaks& streaks,
                                                        const std::vector<double>& voxel_mm, std::size_t first,
                                                        const Transform<frame::Moving, frame::Fixed>& pose, double sure, int threads,
                                                        Progress& progress, PairLevels& pair);

/// Why that is reason not to tell.
[[nodiscard]] Remark onlyStreaks(const WithoutStreaks& fare, double sure);

/// Halves of the overlap (two colours of a checkerboard) refined apart from `start`: largest distance between where they take the corners
/// of the overlap. Infinite when one has nothing to go by.
/// @return false when cancelled
[[nodiscard]] bool halvesApart(const PairLevels& pair, std::size_t first, std::size_t last,
                               const Transform<frame::Moving, frame::Fixed>& start, int threads, Progress& progress, double& disagree_mm);

/// As matchPartial, with turns searched about the turn of `start` instead of none.
[[nodiscard]] Result<PartialResult> matchAbout(const Input& fixed, const Input& moving, const Transform<frame::Moving, frame::Fixed>& start,
                                               const PartialOptions& options, Progress& progress, const OnLevel& onLevel);

/// @error badField
[[nodiscard]] Result<void> checkOptions(const RefineOptions& options);

// Where verdicts change; resources/docs/science/registration.md says how far true and false pairs stay away from them.
constexpr double kChanceOfSearch = 8.0;   ///< significance the best of a whole search may reach without common tissue
constexpr double kSureOfSearch = 13.0;    ///< and above which a found pose is believed
constexpr double kChanceOfDescent = 6.0;  ///< the same of one descent from a given start
constexpr double kSureOfDescent = 9.0;
constexpr double kLeastMargin = 1.8;  ///< over the runner-up
constexpr double kHalvesApart_mm = 3.0;
constexpr double kStreaksMove_mm = 3.0;  ///< a pose that taking streaks out moves further rests on them
constexpr double kStreaksTurn_deg = 3.0;
[[nodiscard]] inline bool elsewhere(const PoseDifference& moved) {
  return moved.shift_mm > kStreaksMove_mm || moved.rotation_deg > kStreaksTurn_deg;
}

}  // namespace ew::registration
