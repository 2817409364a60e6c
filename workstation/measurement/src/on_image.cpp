#include "ew/measurement/on_image.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "ew/imaging/resolution.h"
#include "ew/measurement/ellipse.h"

namespace ew::measurement {
namespace {

constexpr double kUsual_mm = 60.0;  // what the usual options are for
constexpr double kClosest = 0.2;

/// Paths wander no farther from where they lead, for the usual size; what lies beyond would only be searched.
constexpr double kAround_mm = 15.0;

struct Bounds {
  glm::dvec2 low{0.0}, high{0.0};
};
Bounds boundsOf(std::span<const glm::dvec2> points) {
  if (points.empty()) return {};
  Bounds bounds{points[0], points[0]};
  for (const glm::dvec2& point : points) {
    bounds.low = glm::min(bounds.low, point);
    bounds.high = glm::max(bounds.high, point);
  }
  return bounds;
}

double closenessFor(std::span<const glm::dvec2> clicks_mm) {
  const Bounds bounds = boundsOf(clicks_mm);
  return std::clamp(std::max(bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y) / kUsual_mm, kClosest, 1.0);
}

struct Cut {
  ImageView<const std::uint8_t> image;
  glm::ivec2 at_px{0};
};

/// The part of an image around points, in pixels. Of one that lies nowhere near them the whole.
Cut cutAround(ImageView<const std::uint8_t> image, std::span<const glm::dvec2> points_px, double around_px) {
  if (points_px.empty()) return {image, {}};
  const auto [low, high] = boundsOf(points_px);
  const auto within = [](double value, int size) { return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(size))); };
  const glm::ivec2 from(within(std::floor(low.x - around_px), image.width), within(std::floor(low.y - around_px), image.height));
  const glm::ivec2 to(within(std::ceil(high.x + around_px), image.width), within(std::ceil(high.y + around_px), image.height));
  if (to.x - from.x < 8 || to.y - from.y < 8) return {image, {}};
  return {{image.row(from.y) + from.x, to.x - from.x, to.y - from.y, image.stride}, from};
}

}  // namespace

UncertaintyAt uncertaintyOn(const Probe& probe, const Knobs& knobs, const Scene& scene, const DisplayGeometry& geometry) {
  const auto map = std::make_shared<const ResolutionMap>(probe, knobs, scene, geometry.depth_mm);
  return [map, pixel_mm = geometry.pixel_mm](int, const glm::dvec2& p) {
    const Resolution there = map->at(p);
    return PointUncertainty{glm::dvec2(pixel_mm), there.axial_mm, there.lateral_mm, there.beam_rad};
  };
}

TracingOptions tracingOptionsFor(std::span<const glm::dvec2> clicks_mm) {
  const double closeness = closenessFor(clicks_mm);
  TracingOptions options;
  for (double* length_mm : {&options.blur_mm, &options.smoothing_mm, &options.spacing_mm, &options.snap.reach_mm, &options.snap.blur_mm,
                            &options.snap.across_mm})
    *length_mm *= closeness;
  return options;
}

Result<std::vector<glm::dvec2>> traceOnImage(ImageView<const std::uint8_t> image, const DisplayGeometry& geometry,
                                             std::span<const glm::dvec2> clicks_mm) {
  // The tracer's image is not mirrored: its mm count to the right and downwards from the middle of the face.
  const glm::dvec2 side(geometry.markerLeft ? -1.0 : 1.0, geometry.upsideDown ? -1.0 : 1.0);
  std::vector<glm::dvec2> shown, pixels;
  for (const glm::dvec2& click : clicks_mm) {
    shown.push_back(side * click);
    pixels.push_back(geometry.face_px + shown.back() / geometry.pixel_mm);
  }
  const Cut cut = cutAround(image, pixels, closenessFor(clicks_mm) * kAround_mm / geometry.pixel_mm);
  const glm::dvec2 origin_mm = (glm::dvec2(cut.at_px) - geometry.face_px) * geometry.pixel_mm;
  EdgeTracer tracer;
  if (auto set = tracer.setImage(cut.image, {glm::dvec2(geometry.pixel_mm), origin_mm}, tracingOptionsFor(clicks_mm)); !set)
    return passOn(set.error());
  auto outline = tracer.traceAround(shown);
  if (!outline) return passOn(outline.error());
  for (glm::dvec2& point : *outline) point *= side;
  return std::move(*outline);
}

Result<std::vector<glm::dvec2>> ellipseOnImage(ImageView<const std::uint8_t> image, const DisplayGeometry& geometry,
                                               std::span<const glm::dvec2> clicks_mm) {
  constexpr std::size_t kMostPoints = 64;
  auto outline = traceOnImage(image, geometry, clicks_mm);
  if (!outline) return passOn(outline.error());
  std::vector<glm::dvec2> points;
  const std::size_t every = std::max<std::size_t>(1, outline->size() / kMostPoints);
  for (std::size_t n = 0; n < outline->size(); n += every) points.push_back((*outline)[n]);
  auto fit = fitEllipse(points);
  if (!fit) return passOn(fit.error());
  return pointsOn(fit->ellipse, static_cast<int>(clicks_mm.size()));
}

}  // namespace ew::measurement
