#include "patient/distance_cache.h"

#include <cmath>

#include "ew/core/contract.h"
#include "ew/core/parallel.h"

namespace ew::phantom {
namespace {

class DistanceCache final : public Shape {
 public:
  DistanceCache(std::shared_ptr<const BodyShape> body, const Bounds& box, double spacing) : body_(std::move(body)), spacing_(spacing) {
    bounds_ = body_->bounds();
    origin_ = box.lowest_mm;
    cells_ = glm::ivec3(glm::ceil((box.highest_mm - box.lowest_mm) / spacing));
    cells_ = glm::max(cells_, glm::ivec3(1));
    const glm::ivec3 nodes = cells_ + 1;
    row_ = static_cast<std::size_t>(nodes.x);
    slice_ = row_ * static_cast<std::size_t>(nodes.y);
    values_.resize(slice_ * static_cast<std::size_t>(nodes.z));
  }
  /// @return false when cancelled
  [[nodiscard]] bool sample(Progress& progress) {
    const glm::ivec3 nodes = cells_ + 1;
    return forEachTask(nodes.z, 0, progress, say<"Reading the patient">(), [&](int k, int /*worker*/, const auto& stopped) {
      auto out = static_cast<std::size_t>(k) * slice_;
      for (int j = 0; j < nodes.y && !stopped(); ++j)
        for (int i = 0; i < nodes.x; ++i) values_[out++] = body_->signedDistance_mm(origin_ + spacing_ * glm::dvec3(i, j, k));
    });
  }
  double distance_mm(const glm::dvec3& p_mm) const override {
    const glm::dvec3 at = (p_mm - origin_) / spacing_;
    const glm::dvec3 floor = glm::floor(at);
    if (!(floor.x >= 0.0 && floor.y >= 0.0 && floor.z >= 0.0 && floor.x < cells_.x && floor.y < cells_.y && floor.z < cells_.z))
      return body_->signedDistance_mm(p_mm);
    const glm::dvec3 t = at - floor;
    const auto i = static_cast<std::size_t>(floor.x), j = static_cast<std::size_t>(floor.y), k = static_cast<std::size_t>(floor.z);
    const double* v = values_.data() + k * slice_ + j * row_ + i;
    const auto along = [&](const double* from) { return from[0] + t.x * (from[1] - from[0]); };
    const double near0 = along(v), near1 = along(v + row_), far0 = along(v + slice_), far1 = along(v + slice_ + row_);
    const double nearer = near0 + t.y * (near1 - near0), farther = far0 + t.y * (far1 - far0);
    return nearer + t.z * (farther - nearer);
  }

 private:
  std::shared_ptr<const BodyShape> body_;
  double spacing_;
  glm::dvec3 origin_;
  glm::ivec3 cells_;
  std::size_t row_ = 0;
  std::size_t slice_ = 0;
  std::vector<double> values_;
};

}  // namespace

ShapePtr keepDistance(std::shared_ptr<const BodyShape> body, const Bounds& box, double spacing_mm, Progress& progress) {
  EW_EXPECTS(body && spacing_mm > 0.0);
  auto kept = std::make_shared<DistanceCache>(std::move(body), box, spacing_mm);
  return kept->sample(progress) ? kept : nullptr;
}

}  // namespace ew::phantom
