#pragma once

#include <glm/glm.hpp>

namespace ew {

/// Where the tissue of the resting body (the one the recipe draws) is at one moment: breath, pulse, the probe's pressure, alone or
/// together. Smooth and one to one: no two places of the resting body meet. Safe to ask from several threads at once.
class Deformation {
 public:
  virtual ~Deformation();
  /// Place in the world, mm, of what rests at `rest_mm`.
  [[nodiscard]] virtual glm::dvec3 moved(const glm::dvec3& rest_mm) const = 0;
  /// The inverse of moved, within 0.01 mm.
  [[nodiscard]] virtual glm::dvec3 rest(const glm::dvec3& moved_mm) const = 0;
  /// No point of the body is further than this from where it rests, mm; 0 for the resting body.
  [[nodiscard]] virtual double reach_mm() const = 0;
};

/// The body at rest: nothing moves.
[[nodiscard]] const Deformation& restingBody();

/// One after the other: `first` moves the resting body, `second` what it has become. Both must outlive the result.
class DeformationChain final : public Deformation {
 public:
  DeformationChain(const Deformation& first, const Deformation& second) : first_(first), second_(second) {}
  [[nodiscard]] glm::dvec3 moved(const glm::dvec3& rest_mm) const override { return second_.moved(first_.moved(rest_mm)); }
  [[nodiscard]] glm::dvec3 rest(const glm::dvec3& moved_mm) const override { return first_.rest(second_.rest(moved_mm)); }
  [[nodiscard]] double reach_mm() const override { return first_.reach_mm() + second_.reach_mm(); }

 private:
  const Deformation& first_;
  const Deformation& second_;
};

}  // namespace ew
