#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"

namespace ew {

/// Tissue without end for measuring registration: layers, organs and vessels of different echo, and scatterers fixed in it, all hashed from
/// a seed. Quick to image from anywhere (no beams, no shadows but one that is asked for), unlike a virtual patient.
class SpeckleTissue {
 public:
  /// @param organ_mm mean distance of organs, > 0
  explicit SpeckleTissue(std::uint64_t seed, double organ_mm = 18.0) : seed_(seed), organ_mm_(organ_mm) {}

  /// Mean echo, dB.
  [[nodiscard]] double echo_db(const glm::dvec3& p_mm) const;
  /// The scatterers' sum under a smooth beam of about 1 mm: complex, mean power 1 everywhere. `view` 0 are the tissue's own; other numbers
  /// give speckle that has nothing to do with it.
  [[nodiscard]] glm::dvec2 field(const glm::dvec3& p_mm, std::uint64_t view) const;

 private:
  std::uint64_t seed_;
  double organ_mm_;
};

/// How a view of the tissue is taken.
struct TissueView {
  Grid grid;
  std::function<glm::dvec3(const glm::dvec3&)> toTissue;  ///< from the grid's mm; empty: the same point
  double shared = 1.0;                                    ///< 0..1: how much of the speckle is the tissue's own, the rest is the view's
  std::uint64_t view = 1;                                 ///< names the rest
  double gain_db = 0.0;
  double dynamicRange_db = 60.0;
  bool shadow = false;  ///< a band along y, 25 dB down
};

/// Echo levels of the tissue in a view: envelope of echo times speckle, log compressed. The same on every machine and for any number of
/// threads.
/// @error as checkGrid, cancelled
[[nodiscard]] Result<Volume> imageOf(const SpeckleTissue& tissue, const TissueView& view, int threads, Progress& progress);

}  // namespace ew
