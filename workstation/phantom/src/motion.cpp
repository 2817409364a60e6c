#include "ew/phantom/motion.h"

namespace ew {
namespace {

class Still final : public Deformation {
  [[nodiscard]] glm::dvec3 moved(const glm::dvec3& rest_mm) const override { return rest_mm; }
  [[nodiscard]] glm::dvec3 rest(const glm::dvec3& moved_mm) const override { return moved_mm; }
  [[nodiscard]] double reach_mm() const override { return 0.0; }
};

}  // namespace

// No recipe can describe motion yet, so every patient lies still.
bool moves(const Patient& /*patient*/) { return false; }

BodyState stateAt(const Patient& /*patient*/, double /*time_s*/) { return {}; }

double ecgAt_mv(const Patient& /*patient*/, double /*time_s*/) { return 0.0; }

std::unique_ptr<Deformation> bodyMotion(const Patient& /*patient*/, const BodyState& /*state*/) { return std::make_unique<Still>(); }

}  // namespace ew
