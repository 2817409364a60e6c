#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/assessment/compass.h"
#include "ew/assessment/judging.h"
#include "ew/assessment/organ_voxels.h"
#include "ew/assessment/scannable_region.h"
#include "ew/library/attempt.h"
#include "ew/library/case_truth.h"
#include "ew/library/lesson.h"

namespace ew {

enum class ExerciseKind { findPlane, pointAtOrgan, measure };
/// "plane", "point", "measure".
[[nodiscard]] std::string_view wordOf(ExerciseKind kind);

/// A task that the program makes of what a case knows of itself.
struct Exercise {
  std::string id;  ///< stays the same: case, kind and target ("neck-carotid-thyroid/plane/along the carotid fork")
  std::string caseId;
  ExerciseKind kind = ExerciseKind::findPlane;
  std::string target;           ///< name of the plane, structure or measurement
  bool revealsFinding = false;  ///< its name gives a finding away: for those who know the case already
  bool operator==(const Exercise&) const = default;
};

/// Why an exercise that could be thought of is not offered: nobody could solve it, or anybody.
struct WithheldExercise {
  Exercise exercise;
  Message why;
  bool operator==(const WithheldExercise&) const = default;
};

struct ExerciseList {
  std::vector<Exercise> offered;
  std::vector<WithheldExercise> withheld;
};

/// What the exercises of a case stand on.
struct ExerciseGround {
  CaseTruth truth;
  std::shared_ptr<const Skin> skin;
  ScannableRegion region;
  Probe probe;
  double depth_mm = 0.0;                 ///< of the image; 0: the probe's default
  std::shared_ptr<const Volume> labels;  ///< null: no organs are pointed at
  [[nodiscard]] Fan fan() const { return {probe, depth_mm > 0.0 ? depth_mm : probe.defaultDepth_mm}; }
};

inline constexpr int kExerciseLevels = 5;
/// From calipers that a hand sets half a millimetre beside: below, a measurement is luck.
inline constexpr double kFinestTolerance_mm = 1.0;
/// Of random clicks in images from random poses: an organ that more of them hit is not asked for.
inline constexpr double kMostByChance = 0.03;

/// How hard a level is. 1: all aids, loose, near; 5: none, strict, far, and against the clock.
struct ExerciseDifficulty {
  LessonAids aids;
  double toleranceFactor = 1.0;           ///< of the case's tolerances
  double pointMargin_mm = 1.0;            ///< beside an organ that still counts
  std::optional<double> startsWithin_mm;  ///< of the target's contact; absent: anywhere that can be scanned
  std::optional<double> time_s;
};
/// @param level 1..kExerciseLevels, brought to the nearer end
[[nodiscard]] ExerciseDifficulty difficultyOf(int level);

/// All exercises that a case gives, in the order of its targets: those that can be solved and not by chance. Planes have to be reachable
/// from the skin. Organs have to come into an image somewhere, be away from it somewhere else, and fill at most kMostByChance of the
/// images of random hands. Measurements have to have points that calipers can be set to, a tolerance of at least kFinestTolerance_mm,
/// and a reading at those points within half of it.
/// @param edited the case of the truth, for its id and for what reveals a finding
/// @param seed of the random hands; the same list for the same seed
[[nodiscard]] ExerciseList exercisesOf(const Case& edited, const ExerciseGround& ground, std::uint64_t seed = 1);

/// Parts of `ground` by an exercise's target. @return null when the case does not know it any more
[[nodiscard]] const ReferencePlane* planeOf(const Exercise& exercise, const CaseTruth& truth);
[[nodiscard]] const ReferenceStructure* structureOf(const Exercise& exercise, const CaseTruth& truth);
[[nodiscard]] const ReferenceMeasurement* measurementOf(const Exercise& exercise, const CaseTruth& truth);

/// Where a trainee begins: on skin that can be scanned, never with the plane nearly found nor the organ in the image. Measurements of a
/// plane begin near it on levels 1 and 2.
/// @return nothing when 300 tries met no such place, or the target is not known
[[nodiscard]] std::optional<Hold> startOf(const Exercise& exercise, const ExerciseGround& ground, int level, std::uint64_t seed);

/// Where an organ is seen well: of many holds that aim at its middle, the one with its largest section in the image.
/// @return nothing when it comes into none
[[nodiscard]] std::optional<Hold> viewOfOrgan(const ExerciseGround& ground, int label, std::uint64_t seed = 1);

/// What a trainee hands in.
struct ExerciseAnswer {
  Pose pose;                          ///< of a plane: where the probe is held
  std::vector<glm::dvec3> points_mm;  ///< world; of an organ one, of a measurement its calipers as readingOf takes them
  std::optional<double> value;        ///< of a measurement, in its unit; absent: the calipers' reading
};

/// The exercise's judgement at a level. An answer of the wrong kind (no point clicked, a target that the case lost) fails, with a remark.
[[nodiscard]] StepResult judgeExercise(const Exercise& exercise, const ExerciseGround& ground, int level, const ExerciseAnswer& answer);

}  // namespace ew
