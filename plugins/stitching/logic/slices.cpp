#include "logic/slices.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "ew/stitching/places.h"

namespace ew::stitching {
namespace {

glm::dmat4 turnAbout(const glm::dvec3& turn_deg, const glm::dvec3& pivot) {
  const double angle = glm::length(turn_deg);
  if (angle == 0.0) return glm::dmat4(1.0);
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), angle * std::numbers::pi / 180.0, turn_deg / angle);
  return glm::translate(glm::dmat4(1.0), pivot) * turn * glm::translate(glm::dmat4(1.0), -pivot);
}

/// Voxels of one volume, ready to be read between their centres.
class Reader {
 public:
  explicit Reader(const Volume& volume) : volume_(volume), toVoxel_(volume.grid.worldToVoxel().matrix) {}
  [[nodiscard]] const glm::dmat4& toVoxel() const { return toVoxel_; }

  /// -1 where nothing is known.
  [[nodiscard]] double at(const glm::dvec3& voxel) const {
    // A rounding error at a face must not lose the outermost layer of centres, nor a volume of a single layer.
    constexpr double kSlack = 1e-6;
    const glm::ivec3& dims = volume_.grid.dims;
    glm::ivec3 low{0};
    glm::dvec3 part{0.0};
    for (int a = 0; a < 3; ++a) {
      if (!(voxel[a] >= -kSlack && voxel[a] <= dims[a] - 1 + kSlack)) return -1.0;
      const double inside = std::clamp(voxel[a], 0.0, static_cast<double>(dims[a] - 1));
      low[a] = std::min(static_cast<int>(inside), std::max(0, dims[a] - 2));
      part[a] = inside - low[a];
    }
    if (!volume_.coverage.empty()) {
      const glm::ivec3 nearest = low + glm::ivec3(glm::greaterThanEqual(part, glm::dvec3(0.5)));
      if (volume_.coverage[volume_.grid.indexOf(nearest.x, nearest.y, nearest.z)] == 0) return -1.0;
    }
    double sum = 0.0;
    double weights = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::ivec3 step{corner & 1, (corner >> 1) & 1, corner >> 2};
      double weight = 1.0;
      for (int a = 0; a < 3; ++a) weight *= step[a] != 0 ? part[a] : 1.0 - part[a];
      if (weight == 0.0) continue;
      const std::size_t index = volume_.grid.indexOf(low.x + step.x, low.y + step.y, low.z + step.z);
      if (!volume_.coverage.empty() && volume_.coverage[index] == 0) continue;  // black beside the beam is no tissue
      sum += weight * volume_.echo[index];
      weights += weight;
    }
    return weights > 0.0 ? sum / weights : -1.0;
  }

 private:
  const Volume& volume_;
  glm::dmat4 toVoxel_;
};

std::uint8_t level(double value) { return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0l, 255l)); }

}  // namespace

Plane planeOf(Cut cut, const glm::dvec3& centre_mm, double pixel_mm) {
  switch (cut) {
    case Cut::axial:
      return {centre_mm, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, pixel_mm};
    case Cut::coronal:
      return {centre_mm, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, pixel_mm};
    case Cut::sagittal:
      return {centre_mm, {0.0, 1.0, 0.0}, {0.0, 0.0, -1.0}, pixel_mm};
  }
  return {};
}

glm::dvec3 pointAt(const Plane& plane, const glm::ivec2& size, const glm::dvec2& pixel) {
  const glm::dvec2 from = plane.pixel_mm * (pixel - 0.5 * (glm::dvec2(size) - 1.0));
  return plane.centre_mm + from.x * plane.right + from.y * plane.down;
}

glm::dvec2 pixelOf(const Plane& plane, const glm::ivec2& size, const glm::dvec3& p_mm) {
  const glm::dvec3 from = p_mm - plane.centre_mm;
  return glm::dvec2(glm::dot(from, plane.right), glm::dot(from, plane.down)) / plane.pixel_mm + 0.5 * (glm::dvec2(size) - 1.0);
}

double distanceTo(const Plane& plane, const glm::dvec3& p_mm) { return glm::dot(p_mm - plane.centre_mm, plane.normal()); }

Plane moved(const Plane& plane, const glm::dmat4& rigid) {
  const glm::dmat3 turn(rigid);
  return {carried(rigid, plane.centre_mm), turn * plane.right, turn * plane.down, plane.pixel_mm};
}

Plane turned(const Plane& plane, const glm::dvec3& about_mm, const glm::dvec3& turn_deg) {
  Plane result = plane;
  for (const int axis : {1, 0, 2}) {
    if (turn_deg[axis] == 0.0) continue;
    const glm::dvec3 about = axis == 0 ? result.right : axis == 1 ? result.down : result.normal();
    result = moved(result, turnAbout(turn_deg[axis] * about, about_mm));
  }
  // Hundreds of small turns must not shear the picture.
  result.right = glm::normalize(result.right);
  result.down = glm::normalize(result.down - glm::dot(result.down, result.right) * result.right);
  return result;
}

glm::dvec3 Mapping::operator()(const glm::dvec3& p_mm) const {
  glm::dvec3 p = carried(toBend, p_mm);
  if (bend != nullptr && !bend->displacement_mm.empty()) p += registration::displacementAt(*bend, p);
  return carried(toGrid, p);
}

GreyPicture sliced(const Volume& volume, const Plane& plane, const glm::ivec2& size, const Mapping& mapping) {
  GreyPicture picture{size, {}, {}};
  const std::size_t count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  picture.grey.assign(count, 0);
  picture.seen.assign(count, 0);
  if (volume.echo.size() != volume.grid.voxelCount() || volume.echo.empty()) return picture;
  const Reader reader(volume);
  const bool bends = mapping.bend != nullptr && !mapping.bend->displacement_mm.empty();
  const glm::dmat4 straight = reader.toVoxel() * mapping.toGrid * mapping.toBend;
  for (int y = 0; y < size.y; ++y) {
    const glm::dvec3 from = pointAt(plane, size, {0.0, y});
    const glm::dvec3 voxel = carried(straight, from);
    const glm::dvec3 step = glm::dmat3(straight) * (plane.pixel_mm * plane.right);
    for (int x = 0; x < size.x; ++x) {
      const double value = bends ? reader.at(carried(reader.toVoxel(), mapping(from + x * plane.pixel_mm * plane.right)))
                                 : reader.at(voxel + static_cast<double>(x) * step);
      if (value < 0.0) continue;
      const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
      picture.grey[at] = level(value);
      picture.seen[at] = 1;
    }
  }
  return picture;
}

ColourPicture overlaid(const GreyPicture& fixed, const GreyPicture& moving, const OverlayOptions& options) {
  ColourPicture picture{fixed.size, {}};
  picture.rgb.resize(fixed.grey.size());
  const int square = std::max(1, options.square_px);
  for (int y = 0; y < fixed.size.y; ++y) {
    for (int x = 0; x < fixed.size.x; ++x) {
      const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(fixed.size.x) + static_cast<std::size_t>(x);
      const int a = fixed.grey[at];
      const int b = moving.grey[at];
      std::array<int, 3> colour{0, 0, 0};
      if (options.kind == Overlay::flicker) {
        colour.fill(options.second ? b : a);
      } else if (fixed.seen[at] == 0 || moving.seen[at] == 0) {
        colour.fill((a + b) / 2);  // the one that sees nothing is 0
      } else if (options.kind == Overlay::checkerboard) {
        colour.fill((x / square + y / square) % 2 == 0 ? a : b);
      } else if (options.kind == Overlay::difference) {
        colour.fill((b - a + 256) / 2);
      } else {
        colour = {b, a, b};
      }
      for (std::size_t c = 0; c < 3; ++c) picture.rgb[at][c] = static_cast<std::uint8_t>(std::clamp(colour[c], 0, 255));
    }
  }
  return picture;
}

std::array<std::uint8_t, 3> colourOfLength(double length_mm, double longest_mm) {
  static constexpr std::array<glm::dvec3, 4> ramp = {glm::dvec3(22, 24, 48), {28, 92, 120}, {79, 179, 150}, {250, 224, 96}};
  const double share = longest_mm > 0.0 && std::isfinite(length_mm) ? std::clamp(length_mm / longest_mm, 0.0, 1.0) : 0.0;
  const double along = share * (ramp.size() - 1);
  const std::size_t first = std::min(static_cast<std::size_t>(along), ramp.size() - 2);
  const glm::dvec3 colour = glm::mix(ramp[first], ramp[first + 1], along - static_cast<double>(first));
  return {level(colour.r), level(colour.g), level(colour.b)};
}

std::vector<std::vector<glm::dvec2>> deformedLattice(const Plane& plane, const glm::ivec2& size, double spacing_mm,
                                                     const std::function<glm::dvec3(const glm::dvec3&)>& displaced) {
  std::vector<std::vector<glm::dvec2>> lines;
  const glm::dvec2 half = 0.5 * plane.pixel_mm * glm::dvec2(size);
  if (!(spacing_mm > 0.0) || half.x / spacing_mm > 500.0 || half.y / spacing_mm > 500.0) return lines;
  const glm::ivec2 reach = glm::ivec2(glm::ceil(half / spacing_mm));
  for (const int axis : {0, 1}) {
    for (int line = -reach[axis]; line <= reach[axis]; ++line) {
      std::vector<glm::dvec2> points;
      const int ends = 4 * reach[1 - axis];
      for (int n = -ends; n <= ends; ++n) {
        const double across = line * spacing_mm;
        const double along = n * spacing_mm / 4.0;
        const glm::dvec3 p = plane.centre_mm + (axis == 0 ? across : along) * plane.right + (axis == 0 ? along : across) * plane.down;
        points.push_back(pixelOf(plane, size, displaced(p)));
      }
      lines.push_back(std::move(points));
    }
  }
  return lines;
}

int viewAt(const SeamMap& seams, const glm::dvec3& p_world_mm) {
  if (seams.view.empty()) return -1;
  const glm::ivec3 cell = glm::ivec3(glm::round(carried(seams.cells.worldToVoxel().matrix, p_world_mm)));
  return seams.cells.contains(cell) ? seams.view[seams.cells.indexOf(cell.x, cell.y, cell.z)] - 1 : -1;
}

std::array<std::uint8_t, 3> colourOfView(std::size_t view) {
  // Okabe and Ito's set, told apart by people with any colour vision; black is the ground here, so light grey stands in for it.
  static constexpr std::array<std::array<std::uint8_t, 3>, 8> colours = {
      {{86, 180, 233}, {230, 159, 0}, {0, 158, 115}, {240, 228, 66}, {204, 121, 167}, {213, 94, 0}, {0, 114, 178}, {200, 200, 200}}};
  return colours[view % colours.size()];
}

ColourPicture seamPicture(const SeamMap& seams, std::span<const SeenView> views, const Plane& plane, const glm::ivec2& size,
                          const glm::dmat4& toWorld) {
  ColourPicture picture{size, {}};
  picture.rgb.assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), {0, 0, 0});
  if (seams.view.empty()) return picture;
  std::vector<Reader> readers;
  static const Volume nothing;
  for (const SeenView& view : views) readers.emplace_back(view.volume != nullptr ? *view.volume : nothing);
  const glm::dmat4 toCell = seams.cells.worldToVoxel().matrix * toWorld;
  std::vector<int> owner(picture.rgb.size(), -1);
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
      const glm::dvec3 p = pointAt(plane, size, {x, y});
      const glm::ivec3 cell = glm::ivec3(glm::round(carried(toCell, p)));
      if (!seams.cells.contains(cell)) continue;
      const int view = seams.view[seams.cells.indexOf(cell.x, cell.y, cell.z)] - 1;
      if (view < 0 || static_cast<std::size_t>(view) >= views.size()) continue;
      owner[at] = view;
      const auto v = static_cast<std::size_t>(view);
      const double grey =
          views[v].volume != nullptr ? std::max(0.0, readers[v].at(carried(readers[v].toVoxel(), views[v].fromPlane(p)))) : 0.0;
      const auto tint = colourOfView(v);
      for (std::size_t c = 0; c < 3; ++c) picture.rgb[at][c] = level(0.62 * grey + 0.22 * tint[c] * (0.35 + 0.65 * grey / 255.0));
    }
  }
  for (int y = 0; y + 1 < size.y; ++y) {
    for (int x = 0; x + 1 < size.x; ++x) {
      const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
      const auto differs = [&](std::size_t other) { return owner[at] >= 0 && owner[other] >= 0 && owner[at] != owner[other]; };
      if (differs(at + 1) || differs(at + static_cast<std::size_t>(size.x))) picture.rgb[at] = {235, 240, 242};
    }
  }
  return picture;
}

glm::dmat4 motionOf(const glm::dvec3& shift_mm, const glm::dvec3& turn_deg, const glm::dvec3& pivot_mm) {
  return glm::translate(glm::dmat4(1.0), shift_mm) * turnAbout(turn_deg, pivot_mm);
}

glm::dmat4 nudged(const glm::dmat4& fixedToMoving, const glm::dvec3& shift_mm, const glm::dvec3& turn_deg, const glm::dvec3& pivot_mm) {
  // What stood at p stands at motion(p) afterwards, so the point seen at q is the one that stood at motion^-1(q).
  return fixedToMoving * rigidInverse(motionOf(shift_mm, turn_deg, pivot_mm));
}

QuickAgreement quickAgreement(const Volume& fixed, const Volume& moving, const glm::dmat4& fixedToMoving, double step_mm) {
  QuickAgreement result;
  if (fixed.echo.empty() || moving.echo.empty() || !(step_mm > 0.0)) return result;
  const Reader reader(moving);
  const glm::ivec3 step = glm::max(glm::ivec3(1), glm::ivec3(glm::round(glm::dvec3(step_mm) / fixed.grid.spacing_mm)));
  const glm::dmat4 toVoxel = reader.toVoxel() * fixedToMoving * fixed.grid.voxelToWorld().matrix;
  std::size_t covered = 0;
  double a = 0.0, b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
  for (int k = 0; k < fixed.grid.dims.z; k += step.z) {
    for (int j = 0; j < fixed.grid.dims.y; j += step.y) {
      for (int i = 0; i < fixed.grid.dims.x; i += step.x) {
        const std::size_t index = fixed.grid.indexOf(i, j, k);
        if (fixed.coverageAt(index) == Coverage::absent) continue;
        ++covered;
        const double other = reader.at(carried(toVoxel, {i, j, k}));
        if (other < 0.0) continue;
        const double own = fixed.echo[index];
        ++result.points;
        a += own;
        b += other;
        aa += own * own;
        bb += other * other;
        ab += own * other;
      }
    }
  }
  if (covered > 0) result.overlapShare = static_cast<double>(result.points) / static_cast<double>(covered);
  if (result.points < 200) return result;
  const auto n = static_cast<double>(result.points);
  const double spread = (aa - a * a / n) * (bb - b * b / n);
  if (spread > 0.0) result.correlation = (ab - a * b / n) / std::sqrt(spread);
  return result;
}

}  // namespace ew::stitching
