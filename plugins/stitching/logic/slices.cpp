#include "logic/slices.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "ew/imaging/point_levels.h"

namespace ew::stitching {
namespace {

glm::dmat4 turnAbout(const glm::dvec3& rotation_deg, const glm::dvec3& pivot) {
  const double angle = glm::length(rotation_deg);
  if (angle == 0.0) return glm::dmat4(1.0);
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), angle * std::numbers::pi / 180.0, rotation_deg / angle);
  return glm::translate(glm::dmat4(1.0), pivot) * turn * glm::translate(glm::dmat4(1.0), -pivot);
}

std::uint8_t level(double value) { return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0l, 255l)); }

/// What a volume shows along rows of points of the plane's frame: the rows of an image.
class Rows {
 public:
  Rows(const Volume& volume, const Mapping& mapping)
      : volume_(volume), mapping_(mapping), fromWarp_(volume.grid.toVoxel<frame::View>() * mapping.toGrid) {}

  /// The levels (levelsAt) of `count` points from `start_mm` on; they stay until the next call.
  std::span<const float> at(const glm::dvec3& start_mm, const glm::dvec3& step_mm, int count) {
    points_.resize(static_cast<std::size_t>(count));
    levels_.resize(static_cast<std::size_t>(count));
    if (mapping_.warp != nullptr && !mapping_.warp->displacement_mm.empty()) {
      fill(mapping_.toWarp, start_mm, step_mm);
      registration::displace(*mapping_.warp, points_);
      for (glm::dvec3& p : points_) p = carried(fromWarp_, p);
    } else {
      fill(fromWarp_ * mapping_.toWarp, start_mm, step_mm);
    }
    levelsAt(volume_, points_, levels_);
    return levels_;
  }

 private:
  template <class Own, class Frame>
  void fill(const Transform<Own, Frame>& fromPlane, const glm::dvec3& start_mm, const glm::dvec3& step_mm) {
    const glm::dvec3 start = carried(fromPlane, start_mm);
    const glm::dvec3 step = glm::dmat3(fromPlane.matrix) * step_mm;
    for (std::size_t n = 0; n < points_.size(); ++n) points_[n] = start + static_cast<double>(n) * step;
  }

  const Volume& volume_;
  const Mapping& mapping_;
  Transform<frame::Voxel, frame::World> fromWarp_;
  std::vector<glm::dvec3> points_;
  std::vector<float> levels_;
};

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

Plane turned(const Plane& plane, const glm::dvec3& about_mm, const glm::dvec3& rotation_deg) {
  Plane result = plane;
  for (const int axis : {1, 0, 2}) {
    if (rotation_deg[axis] == 0.0) continue;
    const glm::dvec3 about = axis == 0 ? result.right : axis == 1 ? result.down : result.normal();
    result = moved(result, Transform<frame::View, frame::View>{turnAbout(rotation_deg[axis] * about, about_mm)});
  }
  // Hundreds of small turns must not shear the image.
  result.right = glm::normalize(result.right);
  result.down = glm::normalize(result.down - glm::dot(result.down, result.right) * result.right);
  return result;
}

glm::dvec3 Mapping::operator()(const glm::dvec3& p_mm) const {
  glm::dvec3 p = carried(toWarp, p_mm);
  if (warp != nullptr && !warp->displacement_mm.empty()) p += registration::displacementAt(*warp, p);
  return carried(toGrid, p);
}

GreySlice sliced(const Volume& volume, const Plane& plane, const glm::ivec2& size, const Mapping& mapping) {
  GreySlice image{size, {}, {}};
  const std::size_t count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  image.grey.assign(count, 0);
  image.seen.assign(count, 0);
  Rows rows(volume, mapping);
  for (int y = 0; y < size.y; ++y) {
    std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x);
    for (const float seen : rows.at(pointAt(plane, size, {0.0, y}), plane.pixel_mm * plane.right, size.x)) {
      if (seen >= 0.0F) {
        image.grey[at] = static_cast<std::uint8_t>(seen + 0.5F);
        image.seen[at] = 1;
      }
      ++at;
    }
  }
  return image;
}

ColourSlice overlaid(const GreySlice& fixed, const GreySlice& moving, const OverlayOptions& options) {
  ColourSlice image{fixed.size, {}};
  image.rgb.resize(fixed.grey.size());
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
      for (std::size_t c = 0; c < 3; ++c) image.rgb[at][c] = static_cast<std::uint8_t>(std::clamp(colour[c], 0, 255));
    }
  }
  return image;
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
  const glm::ivec3 cell = glm::ivec3(glm::round(carried(seams.cells.worldToVoxel(), p_world_mm)));
  return seams.cells.contains(cell) ? seams.view[seams.cells.indexOf(cell.x, cell.y, cell.z)] - 1 : -1;
}

std::array<std::uint8_t, 3> colourOfView(std::size_t view) {
  // Okabe and Ito's set, told apart by people with any colour vision; black is the ground here, so light grey stands in for it.
  static constexpr std::array<std::array<std::uint8_t, 3>, 8> colours = {
      {{86, 180, 233}, {230, 159, 0}, {0, 158, 115}, {240, 228, 66}, {204, 121, 167}, {213, 94, 0}, {0, 114, 178}, {200, 200, 200}}};
  return colours[view % colours.size()];
}

ColourSlice seamImage(const SeamMap& seams, std::span<const WorldView> views, const Plane& plane, const glm::ivec2& size,
                      const Transform<frame::World, frame::Fixed>& planeToWorld) {
  ColourSlice image{size, {}};
  image.rgb.assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), {0, 0, 0});
  if (seams.view.empty()) return image;
  const auto indexOf = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
  };
  const auto toCell = seams.cells.worldToVoxel() * planeToWorld;
  std::vector<int> owner(image.rgb.size(), -1);
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const glm::ivec3 cell = glm::ivec3(glm::round(carried(toCell, pointAt(plane, size, {x, y}))));
      if (!seams.cells.contains(cell)) continue;
      const int view = seams.view[seams.cells.indexOf(cell.x, cell.y, cell.z)] - 1;
      if (view < static_cast<int>(views.size())) owner[indexOf(x, y)] = view;
    }
  }
  static const Volume nothing;
  std::vector<Rows> rows;
  for (const WorldView& view : views) rows.emplace_back(view.volume != nullptr ? *view.volume : nothing, view.fromPlane);
  for (int y = 0; y < size.y; ++y) {
    for (int begin = 0, end = 0; begin < size.x; begin = end) {
      const int view = owner[indexOf(begin, y)];
      while (end < size.x && owner[indexOf(end, y)] == view) ++end;
      if (view < 0) continue;
      const auto tint = colourOfView(static_cast<std::size_t>(view));
      std::size_t at = indexOf(begin, y);
      for (const float seen :
           rows[static_cast<std::size_t>(view)].at(pointAt(plane, size, {begin, y}), plane.pixel_mm * plane.right, end - begin)) {
        const double grey = std::max(0.0F, seen);
        for (std::size_t c = 0; c < 3; ++c) image.rgb[at][c] = level(0.62 * grey + 0.22 * tint[c] * (0.35 + 0.65 * grey / 255.0));
        ++at;
      }
    }
  }
  for (int y = 0; y + 1 < size.y; ++y) {
    for (int x = 0; x + 1 < size.x; ++x) {
      const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
      const auto differs = [&](std::size_t other) { return owner[at] >= 0 && owner[other] >= 0 && owner[at] != owner[other]; };
      if (differs(at + 1) || differs(at + static_cast<std::size_t>(size.x))) image.rgb[at] = {235, 240, 242};
    }
  }
  return image;
}

template <class Frame>
Transform<Frame, Frame> motionOf(const glm::dvec3& shift_mm, const glm::dvec3& rotation_deg, const glm::dvec3& pivot_mm) {
  return {glm::translate(glm::dmat4(1.0), shift_mm) * turnAbout(rotation_deg, pivot_mm)};
}
template Transform<frame::Fixed, frame::Fixed> motionOf(const glm::dvec3&, const glm::dvec3&, const glm::dvec3&);
template Transform<frame::World, frame::World> motionOf(const glm::dvec3&, const glm::dvec3&, const glm::dvec3&);

Transform<frame::Moving, frame::Fixed> nudged(const Transform<frame::Moving, frame::Fixed>& fixedToMoving, const glm::dvec3& shift_mm,
                                              const glm::dvec3& rotation_deg, const glm::dvec3& pivot_mm) {
  // What stood at p stands at motion(p) afterwards, so the point seen at q is the one that stood at motion^-1(q).
  return fixedToMoving * rigidInverse(motionOf<frame::Fixed>(shift_mm, rotation_deg, pivot_mm));
}

QuickAgreement quickAgreement(const Volume& fixed, const Volume& moving, const Transform<frame::Moving, frame::Fixed>& fixedToMoving,
                              double step_mm) {
  QuickAgreement result;
  if (fixed.echo.empty() || moving.echo.empty() || !(step_mm > 0.0)) return result;
  const glm::ivec3 step = glm::max(glm::ivec3(1), glm::ivec3(glm::round(glm::dvec3(step_mm) / fixed.grid.spacing_mm)));
  const auto toFixed = fixed.grid.voxelTo<frame::Fixed>();
  const Mapping mapping{{}, nullptr, renamed<frame::View, frame::World>(fixedToMoving)};
  Rows rows(moving, mapping);
  std::size_t covered = 0;
  double a = 0.0, b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
  for (int k = 0; k < fixed.grid.dims.z; k += step.z) {
    for (int j = 0; j < fixed.grid.dims.y; j += step.y) {
      const auto others = rows.at(carried(toFixed, {0, j, k}), static_cast<double>(step.x) * glm::dvec3(toFixed.matrix[0]),
                                  (fixed.grid.dims.x + step.x - 1) / step.x);
      for (int i = 0; i < fixed.grid.dims.x; i += step.x) {
        const std::size_t index = fixed.grid.indexOf(i, j, k);
        if (fixed.coverageAt(index) == Coverage::absent) continue;
        ++covered;
        const double other = others[static_cast<std::size_t>(i / step.x)];
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
