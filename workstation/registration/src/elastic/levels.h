#pragma once

#include <functional>
#include <vector>

#include "elastic/level_pair.h"
#include "ew/registration/elastic.h"

namespace ew::registration {

/// Everything that can be tuned in the elastic registration; ElasticOptions choose among these.
struct ElasticSettings {
  struct Step {
    double voxel_mm = 1.0;
    int iterations = 10;
  };
  std::vector<Step> steps;  ///< coarse to fine
  double node_mm = 8.0;
  double window_mm = 6.0;              ///< standard deviation of the normalisation's window
  Prior prior{1e-3, 1.0, 1e-2, 1e-3};  ///< of an ordinary field; its first two are multiplied by ElasticState::stiffness
  double trustWindow_mm = 8.0;         ///< of the local correlation by which samples count after the first level; 0: all alike
  double trustLeast = 0.1;
  double trustPower = 2.0;
  bool measureStiffness = true;  ///< by the evidence; false: ElasticState::stiffness stays
  double robust = 3.0;           ///< c of the robust cost in standard deviations of the residual
  double converged = 1.0;        ///< a level ends when an iteration gains less of the energy, which is a negative log-likelihood
  double longestStep_voxels = 2.0;
  double leastJacobian = 0.15;
  double leastCommon = 0.25;  ///< the matrix is scaled by the common share of the gradients, no lower than this
  double evidence = 1.5;      ///< what an independent residual counts, see resources/docs/science/registration.md
  double solveTolerance = 0.03;
  int solveIterations = 40;
};

/// A field being found, and what is known of it.
struct ElasticState {
  NodeGrid nodes;
  NodeValues values;
  double noise = 1.0;            ///< variance of the residual, in units of the normalised images
  double independent_mm3 = 1.0;  ///< volume of one independent residual
  double stiffness = 1.0;        ///< what the prior of the settings is multiplied by
};

[[nodiscard]] NodeGrid nodesFor(const Grid& fixed, double node_mm);

struct LevelOutcome {
  int iterations = 0;
  double correlationBefore = 0.0;
  double correlationAfter = 0.0;
  double decided = 0.0;            ///< free parameters the images decided, as far as measured
  double worth = 0.0;              ///< at the end: log-likelihood of the correlation less the prior's energy, comparable between starts
  std::vector<float> uncertainty;  ///< per node, as in ElasticResult
  bool singular = false;
  bool noOverlap = false;
  bool cancelled = false;
  bool timeUp = false;
};

/// What is known when a level begins.
enum class Placed {
  roughly,  ///< every sample counts
  nearly,   ///< samples count by how well the images agree around them
  closely   ///< shadows are told from tissue in the wrong place, too
};

/// Gauss-Newton on one level from where `state` stands. `outOfTime` is asked once an iteration.
[[nodiscard]] LevelOutcome refineLevel(const LevelImage& fixed, const LevelImage& moving, const AxesTransform& transform, int iterations,
                                       Placed placed, const ElasticSettings& settings, int threads, const std::function<bool()>& outOfTime,
                                       ElasticState& state, Progress& progress);

/// Pulls nodes of cells whose Jacobian would fall below `least` towards their neighbours until none does.
/// @return whether that could be done
[[nodiscard]] bool unfold(const NodeGrid& nodes, double least, NodeValues& values);
[[nodiscard]] double leastJacobianOf(const NodeGrid& nodes, const NodeValues& values);

}  // namespace ew::registration
