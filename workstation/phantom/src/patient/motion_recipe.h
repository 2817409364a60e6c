#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ew/core/progress.h"
#include "ew/imaging/tissue_motion.h"
#include "patient/recipe.h"

namespace ew::phantom {

/// A share 0..1 on a coarse grid, three linear steps in between, beyond the grid as at its edge.
class ShareField {
 public:
  ShareField(const Bounds& box, double spacing_mm);
  [[nodiscard]] glm::ivec3 nodes() const { return nodes_; }
  [[nodiscard]] glm::dvec3 placeOf(const glm::ivec3& node) const { return origin_ + spacing_ * glm::dvec3(node); }
  [[nodiscard]] float& at(const glm::ivec3& node) { return values_[indexOf(node)]; }
  [[nodiscard]] double at(const glm::ivec3& node) const { return static_cast<double>(values_[indexOf(node)]); }
  [[nodiscard]] double operator()(const glm::dvec3& p_mm) const;
  /// The least that the derivative along `direction` can be anywhere.
  [[nodiscard]] double steepestFall(const glm::dvec3& direction) const;

 private:
  [[nodiscard]] std::size_t indexOf(const glm::ivec3& node) const {
    return static_cast<std::size_t>(node.x) + row_ * static_cast<std::size_t>(node.y) + slice_ * static_cast<std::size_t>(node.z);
  }
  glm::dvec3 origin_;
  double spacing_;
  glm::ivec3 nodes_;
  std::size_t row_;
  std::size_t slice_;
  std::vector<float> values_;
};

struct Breathing {
  BodyRhythm rhythm;
  double pause = 0.3;               ///< share of a cycle without motion, at the end of expiration
  double tidal = 1.0;               ///< of a quiet breath, as a share of full inspiration
  glm::dvec3 displacement_mm{0.0};  ///< of tissue that is free to move, at full inspiration
  std::shared_ptr<const ShareField> share;
};

/// A vessel that runs along z and widens with each beat.
struct PulsingVessel {
  std::vector<glm::dvec4> line_mm;  ///< by rising z: place and radius at rest
  double growth_mm = 0.0;           ///< of the diameter
  double reach_mm = 20.0;           ///< from the wall to where nothing is pushed any more
  double fade_mm = 15.0;            ///< over which the pulse comes up from both ends of the line
};

/// A chamber of a heart, an ellipsoid that narrows with each beat.
struct BeatingChamber {
  Ellipsoid wall;          ///< at rest: the end of diastole
  double inward_mm = 0.0;  ///< by which all three radii shorten, so that every place of the wall moves as far
  double reach_mm = 25.0;  ///< from the wall to where nothing is drawn along any more
};

struct Pulse {
  BodyRhythm rhythm;
  std::vector<PulsingVessel> vessels;
  std::vector<BeatingChamber> chambers;
};

/// Slow waves along the gut: within its organs tissue sways front to back, as far as `sway_mm` from one end to the other.
struct Bowel {
  BodyRhythm rhythm;
  std::vector<ShapePtr> organs;
  double sway_mm = 2.0;
  double wavelength_mm = 60.0;
  double fade_mm = 6.0;  ///< from an organ's surface inwards, to where it sways fully
};

struct Motion {
  std::optional<Breathing> breathing;
  std::optional<Pulse> pulse;
  std::optional<Bowel> bowel;
};

/// Reads "motion" of a recipe: null after a problem, unfinished after the wish to cancel. Motion that would fold tissue is refused.
[[nodiscard]] Motion readMotion(const JsonFields& motion, const Bounds& box, const ShapePtr& skin, const ShapesByName& shapes,
                                Progress& progress);

}  // namespace ew::phantom
