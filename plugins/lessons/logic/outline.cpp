#include "logic/outline.h"

#include <array>
#include <cmath>

#include "ew/imaging/display.h"

namespace ew::lessons {
namespace {

constexpr float kOutside = -1.0F;

/// How much of a label lies at a place, 0 to 1: between the middles of eight voxels, so that its border has no steps.
class LabelShare {
 public:
  LabelShare(const sdk::Scanned& scanned, int label)
      : labels_(*scanned.labels),
        dims_(scanned.placedLabels.dims),
        worldToVoxel_(inverse(scanned.placedLabels.voxelToWorld())),
        label_(label) {}

  [[nodiscard]] float at(const glm::dvec3& at_mm) const {
    const glm::dvec3 p = (worldToVoxel_ * Point<frame::World>{at_mm}).at;
    const glm::dvec3 low = glm::floor(p), part = p - low;
    double share = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::ivec3 way(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
      const glm::ivec3 voxel = glm::ivec3(low) + way;
      if (glm::any(glm::lessThan(voxel, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(voxel, dims_))) continue;
      if (labels_.echo[labels_.grid.indexOf(voxel.x, voxel.y, voxel.z)] != label_) continue;
      const glm::dvec3 weight = glm::mix(1.0 - part, part, glm::dvec3(way));
      share += weight.x * weight.y * weight.z;
    }
    return static_cast<float>(share);
  }

 private:
  const Volume& labels_;
  glm::ivec3 dims_;
  Transform<frame::Voxel, frame::World> worldToVoxel_;
  int label_;
};

/// The lines in which a cell's four corners, in order around it, are passed through by the border at a half.
void addCell(const std::array<glm::dvec2, 4>& corners, const std::array<float, 4>& shares,
             std::vector<sdk::OverlayLine<frame::Probe>>& lines) {
  constexpr float kBorder = 0.5F;
  std::array<glm::dvec2, 4> crossings;
  std::size_t count = 0;
  for (std::size_t n = 0; n < 4; ++n) {
    const float here = shares[n], next = shares[(n + 1) % 4];
    if (here < 0.0F || next < 0.0F) return;
    if ((here >= kBorder) == (next >= kBorder)) continue;
    crossings[count++] = glm::mix(corners[n], corners[(n + 1) % 4], static_cast<double>((kBorder - here) / (next - here)));
  }
  for (std::size_t n = 0; n + 1 < count; n += 2) {
    sdk::OverlayLine<frame::Probe> line;
    line.points = {{{crossings[n], 0.0}}, {{crossings[n + 1], 0.0}}};
    line.role = sdk::OverlayRole::expert;
    lines.push_back(std::move(line));
  }
}

}  // namespace

bool isInFan(const Probe& probe, double depth_mm, const glm::dvec2& p_mm) {
  if (!isSector(probe.kind)) return std::abs(p_mm.x) <= faceHalfWidth_mm(probe) && p_mm.y >= 0.0 && p_mm.y <= depth_mm;
  const double radius_mm = std::hypot(p_mm.x, p_mm.y + probe.radius_mm);
  return std::abs(std::atan2(p_mm.x, p_mm.y + probe.radius_mm)) <= probe.halfAngle_rad && radius_mm >= probe.radius_mm &&
         radius_mm <= probe.radius_mm + depth_mm;
}

std::vector<sdk::OverlayLine<frame::Probe>> outlineOf(const sdk::Scanned& scanned, int label, const ScanState& image, double step_mm) {
  std::vector<sdk::OverlayLine<frame::Probe>> lines;
  if (!scanned.labels || label == 0) return lines;
  const double depth_mm = resolvedDepth_mm(image.probe, image.knobs);
  const double half_mm =
      isSector(image.probe.kind) ? (image.probe.radius_mm + depth_mm) * std::sin(image.probe.halfAngle_rad) : faceHalfWidth_mm(image.probe);
  const int columns = static_cast<int>(2.0 * half_mm / step_mm) + 2, rows = static_cast<int>(depth_mm / step_mm) + 2;
  const auto at = [&](int column, int row) { return glm::dvec2(-half_mm + column * step_mm, row * step_mm); };
  const LabelShare share(scanned, label);
  // Outside of the fan nothing is known, so that no line runs along its border.
  std::vector<float> shares(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), kOutside);
  const auto of = [&](int column, int row) -> float& {
    return shares[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)];
  };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const glm::dvec2 p = at(column, row);
      if (isInFan(image.probe, depth_mm, p)) of(column, row) = share.at((image.pose.probeToWorld * Point<frame::Probe>{{p, 0.0}}).at);
    }
  for (int row = 0; row + 1 < rows; ++row)
    for (int column = 0; column + 1 < columns; ++column)
      addCell({at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)},
              {of(column, row), of(column + 1, row), of(column + 1, row + 1), of(column, row + 1)}, lines);
  return lines;
}

}  // namespace ew::lessons
