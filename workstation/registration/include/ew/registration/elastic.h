#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/image.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/registration/deformation.h"
#include "ew/registration/rigid.h"
#include "ew/registration/verdict.h"

namespace ew::registration {

/// How much accuracy is paid for; each is a row of `echoweave bench register`.
enum class ElasticEffort { fast, balanced, accurate };

struct ElasticOptions {
  ElasticEffort effort = ElasticEffort::balanced;
  double finestNode_mm = 0.0;      ///< distance of control nodes at the last level; 0: as the effort says
  double finestVoxel_mm = 0.0;     ///< of the last level's images; 0: as the effort says
  double stiffness = 0.0;          ///< weight of the regulariser; 0: follows the measured correlation of the speckle
  double largestMotion_mm = 12.0;  ///< how far the wide search at the coarsest level looks; 0: no search
  double leastJacobian = 0.15;     ///< no cell of the result falls below, > 0
  double maxTime_s = 0.0;          ///< 0: no limit; reached: the best so far with StopReason::timeLimit
  int threads = 0;                 ///< 0: all cores; the result does not depend on it, bit for bit
};

struct ElasticResult {
  Verdict verdict = Verdict::cannotTell;
  Message reason;  ///< messageOf(remarks)
  std::vector<Remark> remarks;
  Deformation fixedToMoving;
  /// One per control node, 0..1: share of the node's value that the regulariser made up (1: no evidence there: flat, saturated, shadowed,
  /// outside). What lies above 1/2 is a guess from the surroundings.
  std::vector<float> uncertainty;
  Agreement before;
  Agreement after;
  JacobianSummary jacobian;
  double residualRms = 0.0;
  double stiffness = 0.0;         ///< that was used at the last level
  double largestMotion_mm = 0.0;  ///< of the control nodes
  double residualShare = 0.0;     ///< of small places that can tell: where tissue lies 2 mm and more from where the warp puts it
  std::vector<Level> levels;
  StopReason stop = StopReason::notRun;
  double seconds = 0.0;
};

[[nodiscard]] std::uint64_t forecastElastic_bytes(const Grid& fixed, const Grid& moving, const ElasticOptions& options);

/// Barber's gradient method in three dimensions: normal equations on a control grid, regularised on the total displacement, robust and
/// confidence-weighted, images normalised by local mean and deviation, coarse to fine in millimetres, free of folds. When the best result
/// agrees no better than the start does, the start is returned and the verdict says so.
/// Source: Barber, Phys. Med. Biol. 37, 1992 (gradient method with an intensity component).
/// @param start fixedToMoving, rigid
/// @error emptyVolume, badField, notRigid, tooLarge, cancelled (within 0.5 s)
[[nodiscard]] Result<ElasticResult> registerElastic(const Input& fixed, const Input& moving,
                                                    const Transform<frame::Moving, frame::Fixed>& start, const ElasticOptions& options,
                                                    Progress& progress, const OnLevel& onLevel = {});

/// The paper's own method on two-dimensional images.
struct Elastic2dOptions {
  std::vector<double> factors = {};  ///< node spacing per level in pixels, coarse to fine; the paper's 48, 24, 6; empty: chosen by size
  bool singleResolution = false;     ///< the paper's figure 8 (c): the finest level alone
  bool intensityTerm = true;         ///< Barber's extra component: a brightness offset that varies like the displacement
  bool shadows = true;               ///< dark columns down to the last row count little; off where y is not the beam's direction
  double stiffness = 0.0;            ///< 0: follows the measured correlation of the speckle
  double largestMotion_mm = 12.0;    ///< how far the coarsest level looks for a common shift; 0: no search
  int iterations = 12;               ///< at most, per level
  int threads = 1;
};

struct Elastic2dResult {
  Verdict verdict = Verdict::cannotTell;
  Message reason;
  int columns = 0;  ///< of the field, one vector per fixed pixel
  int rows = 0;
  std::vector<glm::vec2> displacement_mm;  ///< x, y: fixed pixel centre + displacement = moving point
  double correlationBefore = 0.0;          ///< of grey levels, over what both cover: the paper's figures
  double correlationAfter = 0.0;
  Agreement before;  ///< of the images made comparable: what the verdict rests on
  Agreement after;
  double smallestJacobian = 1.0;  ///< exact over the bilinear field through the pixels
  double largestMotion_mm = 0.0;
  double speckleCorrelation = 0.0;  ///< of the gradients at the last level: 1 the same speckle, 0 none of it in common
  double stiffness = 0.0;           ///< that was used at the last level
  std::vector<Level> levels;        ///< correlations of grey levels at the input's resolution
  StopReason stop = StopReason::notRun;
  double seconds = 0.0;
};

/// Barber's method: Gauss-Newton on the optical-flow equation of images normalised by local mean and deviation, with the mean of both
/// images' gradients and a brightness component; cubic B-splines on a lattice of nodes; bending and slope of the TOTAL displacement
/// regularised, the stiffer the less of the speckle the images share; coarse to fine. No step is taken that squeezes a cell below a
/// Jacobian of 0.1. Where less than 0.6 of the speckle is shared, the warp is fitted on halves of the plane and must agree on the other
/// halves; the share of the motion that does best there is kept. When the result agrees no better than doing nothing does, the displacement
/// is zero and the reason says so. Source: Barber, Phys. Med. Biol. 37, 1992; the pyramid: Aiger and Cohen-Or 1998. Ours departs from both
/// in normalisation, robust weights, splines, regulariser and the stiffness that follows the measured correlation.
/// @param fixed, moving grey levels of the same pixel size; 0 is outside the beam; the centres of their first pixels are one point
/// @param pixel_mm distance of pixels in x and y, > 0
/// @error emptyVolume, badField, cancelled
[[nodiscard]] Result<Elastic2dResult> registerElastic2d(ImageView<const std::uint8_t> fixed, ImageView<const std::uint8_t> moving,
                                                        glm::dvec2 pixel_mm, const Elastic2dOptions& options, Progress& progress,
                                                        const OnLevel& onLevel = {});

/// The paper's use of it: registers the tangent slices of two volumes (figures 6 and 7) and lets the warp fall off along the third axis.
struct TangentWarpOptions {
  Elastic2dOptions slices = {};
  double fallOff_mm = 20.0;  ///< the warp is gone this far from the tangent plane; lengthened to 2.5 times the largest motion
  double leastJacobian = 0.15;
};
struct TangentWarpResult {
  Elastic2dResult slices;
  Deformation fixedToMoving;  ///< on the fixed volume's frame
  JacobianSummary jacobian;
  double fallOff_mm = 0.0;  ///< that was used
  double share = 1.0;       ///< of the motion that was kept: below 1 where all of it would have squeezed a cell below leastJacobian
  Message reason;           ///< the slices' own, and what was lengthened or taken back
  GreyImage fixedSlice;     ///< the two tangent slices as they were registered; 0 outside
  GreyImage movingSlice;
  Grid slicePlane;  ///< where the slices' pixels lie in the fixed volume's frame, one voxel thick
};
/// The slices are cut with pixels of the fixed volume's smallest spacing, y along its j axis where that lies in the plane. The motion is in
/// the plane and falls off as the square of a cosine to both sides.
/// @param plane_mm, normal the tangent plane in the fixed volume's frame
/// @error as registerElastic2d; notRigid (start); badField (a plane outside the overlap, a normal without direction, a fall-off or least
/// Jacobian out of range)
[[nodiscard]] Result<TangentWarpResult> registerTangentSlices(const Input& fixed, const Input& moving,
                                                              const Transform<frame::Moving, frame::Fixed>& start,
                                                              const glm::dvec3& plane_mm, const glm::dvec3& normal,
                                                              const TangentWarpOptions& options, Progress& progress);

}  // namespace ew::registration
