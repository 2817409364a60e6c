#include "ew/phantom/deformation.h"

namespace ew {

Deformation::~Deformation() = default;

const Deformation& restingBody() {
  class Resting final : public Deformation {
    [[nodiscard]] glm::dvec3 moved(const glm::dvec3& rest_mm) const override { return rest_mm; }
    [[nodiscard]] glm::dvec3 rest(const glm::dvec3& moved_mm) const override { return moved_mm; }
    [[nodiscard]] double reach_mm() const override { return 0.0; }
  };
  static const Resting resting;
  return resting;
}

}  // namespace ew
