#include "ew/library/body_skin.h"

#include <algorithm>
#include <cmath>

#include "ew/core/contract.h"
#include "ew/phantom/body_shape.h"

namespace ew {
namespace {

constexpr double kSmoothing_mm = 9.0;   // half of what a mesh's normals are averaged over, for a difference takes it both ways
constexpr double kOnSurface_mm = 0.01;  // a body's distance is first order, so it is approached in steps
constexpr int kMostSteps = 30;

class BodySkin final : public Skin {
 public:
  explicit BodySkin(std::unique_ptr<BodyShape> body) : body_(std::move(body)) {
    const Bounds box = body_->bounds();
    middle_mm_ = 0.5 * (box.lowest_mm + box.highest_mm);
    reach_mm_ = glm::length(box.highest_mm - box.lowest_mm);
  }

  [[nodiscard]] std::optional<Contact> hit(const glm::dvec3& from_mm, const glm::dvec3& direction) const override {
    const double length = glm::length(direction);
    EW_EXPECTS(length > 0.0);
    const glm::dvec3 along = direction / length;
    const double middle_mm = glm::dot(middle_mm_ - from_mm, along);
    double at_mm = std::max(0.0, middle_mm - reach_mm_);
    const double end_mm = middle_mm + reach_mm_;
    // Far off the distance is an estimate, so that steps are shorter than it says and never longer than a limb is thick.
    double before_mm = at_mm;
    bool outside = body_->signedDistance_mm(from_mm + at_mm * along) > 0.0;
    while (at_mm < end_mm) {
      const double distance_mm = body_->signedDistance_mm(from_mm + at_mm * along);
      if ((distance_mm > 0.0) != outside) {
        double lower = before_mm;
        double upper = at_mm;
        for (int n = 0; n < 40; ++n) {
          const double half = 0.5 * (lower + upper);
          ((body_->signedDistance_mm(from_mm + half * along) > 0.0) == outside ? lower : upper) = half;
        }
        return contactAt(from_mm + upper * along);
      }
      before_mm = at_mm;
      at_mm += std::clamp(0.7 * std::abs(distance_mm), 0.5, 20.0);
      outside = distance_mm > 0.0;
    }
    return std::nullopt;
  }

  [[nodiscard]] Contact nearest(const glm::dvec3& p_mm) const override {
    // To the surface, then along it towards the foot of p, over and over: converges to a point whose normal passes through p.
    glm::dvec3 at = onSurface(p_mm);
    for (int n = 0; n < 8; ++n) {
      const glm::dvec3 normal = outwardNormal(*body_, at);
      const glm::dvec3 away = p_mm - at;
      const glm::dvec3 along = away - glm::dot(away, normal) * normal;
      if (glm::length(along) < kOnSurface_mm) break;
      const glm::dvec3 next = onSurface(at + along);
      if (glm::distance(next, p_mm) >= glm::distance(at, p_mm)) break;
      at = next;
    }
    return contactAt(at);
  }

 private:
  [[nodiscard]] glm::dvec3 onSurface(glm::dvec3 p_mm) const {
    for (int n = 0; n < kMostSteps; ++n) {
      const double distance_mm = body_->signedDistance_mm(p_mm);
      if (std::abs(distance_mm) < 0.5 * kOnSurface_mm) break;
      p_mm -= distance_mm * outwardNormal(*body_, p_mm);
    }
    return p_mm;
  }
  [[nodiscard]] Contact contactAt(const glm::dvec3& at_mm) const { return {at_mm, outwardNormal(*body_, at_mm, kSmoothing_mm)}; }

  std::unique_ptr<BodyShape> body_;
  glm::dvec3 middle_mm_{0.0};
  double reach_mm_ = 0.0;
};

}  // namespace

Result<std::shared_ptr<const Skin>> readBodySkin(const std::filesystem::path& recipe) {
  auto body = readBodyShape(recipe);
  if (!body) return passOn(body.error());
  return std::make_shared<const BodySkin>(*std::move(body));
}

}  // namespace ew
