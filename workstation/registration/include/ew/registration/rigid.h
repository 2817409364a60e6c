#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/registration/remark.h"
#include "ew/registration/verdict.h"

namespace ew::registration {

/// 6 x 6, row major: three translations (mm) then three rotations (rad) about the centre of the overlap in the fixed frame.
using PoseCovariance = std::array<double, 36>;

/// What happened at one level of a coarse-to-fine run; for a curve that grows while it runs.
struct Level {
  double voxel_mm = 0.0;  ///< of the images at this level
  double node_mm = 0.0;   ///< of the control grid; 0 for rigid
  int iterations = 0;
  double correlationBefore = 0.0;
  double correlationAfter = 0.0;
  double seconds = 0.0;
};
using OnLevel = std::function<void(const Level&)>;  ///< called on the working thread when a level ends

struct RefineOptions {
  double coarsest_mm = 3.0;  ///< voxels of the first level
  double finest_mm = 0.75;   ///< of the last; never finer than the finer input
  int iterations = 25;       ///< at most, per level
  /// Where descending from the start does not end aligned, poses turned by up to this much from it are searched as matchPartial does, all
  /// shifts; 0: not. Costs the time and memory of matchPartial, and only then.
  double searchRotation_deg = 0.0;
  /// A pose that search finds further than this from the start (at the middle of the overlap) is not taken: the start is believed so far.
  double searchShift_mm = 30.0;
  int threads = 0;  ///< 0: all cores; the result does not depend on it, bit for bit
};

struct RigidResult {
  Verdict verdict = Verdict::cannotTell;
  Message reason;  ///< sentences a user can act on: messageOf(remarks)
  std::vector<Remark> remarks;
  Transform<frame::Moving, frame::Fixed> fixedToMoving = {};  ///< rigid
  Agreement before;                                           ///< at the start
  Agreement after;
  std::optional<PoseCovariance> covariance;  ///< of the pose error; absent when the normal equations are singular
  glm::dvec3 centre_mm{0.0};                 ///< the centre of the overlap that the covariance is about, in the fixed frame
  double conditioning = 0.0;                 ///< smallest over largest eigenvalue of the normal equations in mm and mm at 50 mm lever
  double halvesDisagree_mm = 0.0;            ///< independent halves of the overlap refined apart: how far they differ at its corners
  double residualRms = 0.0;                  ///< in units of the local deviation
  std::vector<Level> levels;
  StopReason stop = StopReason::notRun;
  double seconds = 0.0;
};

/// Refines a rigid transform by the images: coarse to fine, on images free of gain and tolerant to speckle, weighted by confidence and by a
/// robust loss, over what both beams covered and nothing else (black outside a sector is no tissue). With searchRotation_deg a search about
/// the start takes over where descending is led astray, as by wires or vessels with nothing between them that draws.
/// @param start fixedToMoving, rigid
/// @error emptyVolume, badField (confidence of another size, an option out of range), notRigid (start), cancelled
[[nodiscard]] Result<RigidResult> refineRigid(const Input& fixed, const Input& moving, const Transform<frame::Moving, frame::Fixed>& start,
                                              const RefineOptions& options, Progress& progress, const OnLevel& onLevel = {});

struct PartialOptions {
  double maxRotation_deg = 30.0;   ///< rotations searched in every direction, 0..180
  double stepRotation_deg = 10.0;  ///< between rotations of the first search
  double cell_mm = 3.0;            ///< voxels of the first search
  double leastOverlap = 0.08;      ///< of the smaller side's covered volume
  int hypotheses = 8;              ///< refined after the search
  RefineOptions refine;
  int threads = 0;
};

/// A place where the search found agreement.
struct Hypothesis {
  Transform<frame::Moving, frame::Fixed> fixedToMoving = {};
  double significance = 0.0;  ///< Fisher z of the correlation times the root of the independent samples: standard deviations above chance
  double correlation = 0.0;
  double overlapShare = 0.0;
};

struct PartialResult {
  RigidResult best;                    ///< with the verdict over everything
  std::vector<Hypothesis> hypotheses;  ///< refined, best first, each different from those before by more than 10 degrees or 10 mm
  double margin = 0.0;                 ///< significance of the best over that of the runner-up; 1: no difference
  int poses = 0;                       ///< rotations searched, each over all translations
  double seconds = 0.0;
};

/// Memory the search will take at its peak, the inputs not counted.
[[nodiscard]] std::uint64_t forecastPartial_bytes(const Grid& fixed, const Grid& moving, const PartialOptions& options);

/// Finds how two partly overlapping subvolumes lie to each other without any start: all translations (masked correlation by Fourier
/// transform) times a grid of rotations, scored by significance so that small overlaps are treated fairly; the best hypotheses refined.
/// Verdict from the margin over the runner-up, the overlap, and independent halves.
/// Source: Padfield, IEEE TIP 21(5), 2012, equations 24-27 (masked correlation); significance as in facts of Fisher (1915).
/// @error emptyVolume, badField, tooLarge, cancelled (within 0.5 s)
[[nodiscard]] Result<PartialResult> matchPartial(const Input& fixed, const Input& moving, const PartialOptions& options, Progress& progress,
                                                 const OnLevel& onLevel = {});

}  // namespace ew::registration
