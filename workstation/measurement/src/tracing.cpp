#include "ew/measurement/tracing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <opencv2/imgproc/segmentation.hpp>

#include "edge_band.h"
#include "ew/core/contract.h"
#include "ew/core/guarded.h"
#include "ew/measurement/ellipse.h"

namespace ew::measurement {
namespace {

constexpr int kSmallest = 8;
constexpr double kMostPixels = 64e6;
constexpr double kRoughEllipse = 0.35;  // of the reach: how far clicks on an ellipse lie beside it
constexpr double kFarClicks = 8.0;      // of the reach

Error openCvFailed(const Thrown& thrown) {
  if (thrown.noMemory) return {ErrorCode::tooLarge, say<"There is not enough memory to trace in this image.">(), {}};
  return {ErrorCode::internal, say<"The edges of the image could not be traced (%1).">(thrown.reason), {}};
}

ImageView<const std::uint8_t> viewOf(const cv::Mat& grey) {
  return {grey.ptr<std::uint8_t>(), grey.cols, grey.rows, static_cast<std::ptrdiff_t>(grey.step[0])};
}

/// Places of a path `spacing` apart, without its ends.
std::vector<glm::dvec2> resampledOpen(const std::vector<glm::dvec2>& path, double spacing) {
  std::vector<glm::dvec2> points;
  double since = 0.0;
  for (std::size_t n = 1; n + 1 < path.size(); ++n) {
    since += glm::length(path[n] - path[n - 1]);
    if (since < spacing) continue;
    points.push_back(path[n]);
    since = 0.0;
  }
  return points;
}

}  // namespace

struct EdgeTracer::Impl {
  cv::Mat grey;  // as it came
  ImageGeometry geometry;
  TracingOptions options;
  cv::segmentation::IntelligentScissorsMB scissors;

  [[nodiscard]] ImageView<const std::uint8_t> view() const { return viewOf(grey); }
  [[nodiscard]] cv::Point pixelOf(const glm::dvec2& p_mm) const {
    const glm::dvec2 p = glm::round(geometry.toPixel(p_mm));
    return {static_cast<int>(std::clamp(p.x, 0.0, grey.cols - 1.0)), static_cast<int>(std::clamp(p.y, 0.0, grey.rows - 1.0))};
  }
  /// The way along edges from one point to another, pixel by pixel, both ends included.
  [[nodiscard]] std::vector<glm::dvec2> pathBetween(const glm::dvec2& from_mm, const glm::dvec2& to_mm) {
    std::vector<cv::Point> pixels;
    scissors.buildMap(pixelOf(from_mm));
    scissors.getContour(pixelOf(to_mm), pixels);
    std::vector<glm::dvec2> points;
    for (const cv::Point& pixel : pixels) points.push_back(geometry.toMm({pixel.x, pixel.y}));
    return points;
  }
  /// A closed line to begin with. Clicks about an ellipse err less together than each alone.
  [[nodiscard]] std::vector<glm::dvec2> lineAbout(std::span<const glm::dvec2> clicks_mm) {
    if (clicks_mm.size() >= 5) {
      const auto fit = fitEllipse(clicks_mm);
      if (fit && fit->residualRms_mm < kRoughEllipse * options.snap.reach_mm)
        return pointsOn(fit->ellipse,
                        std::max(64, static_cast<int>(2.0 * std::numbers::pi * fit->ellipse.semiMajor_mm / options.spacing_mm)));
    }
    // Between clicks that lie near each other a smooth curve leads to the edge; farther apart it is followed from one to the next.
    const double far_mm = kFarClicks * options.snap.reach_mm;
    std::vector<glm::dvec2> way;
    for (std::size_t n = 0; n < clicks_mm.size(); ++n) {
      const glm::dvec2 &here = clicks_mm[n], &next = clicks_mm[(n + 1) % clicks_mm.size()];
      way.push_back(here);
      if (glm::length(next - here) <= far_mm) continue;
      const auto piece = resampledOpen(pathBetween(here, next), far_mm / 4.0);
      way.insert(way.end(), piece.begin(), piece.end());
    }
    return closedCurveThrough(way, options.spacing_mm);
  }
};

EdgeTracer::EdgeTracer() : impl_(std::make_unique<Impl>()) {}
EdgeTracer::~EdgeTracer() = default;
EdgeTracer::EdgeTracer(EdgeTracer&&) noexcept = default;
EdgeTracer& EdgeTracer::operator=(EdgeTracer&&) noexcept = default;

bool EdgeTracer::hasImage() const { return !impl_->grey.empty(); }

Result<void> EdgeTracer::setImage(ImageView<const std::uint8_t> image, const ImageGeometry& geometry, const TracingOptions& options) {
  EW_EXPECTS(geometry.pixel_mm.x > 0.0 && geometry.pixel_mm.y > 0.0 && options.spacing_mm > 0.0);
  if (image.width < kSmallest || image.height < kSmallest)
    return failure(ErrorCode::badField, say<"The image is too small to trace in: %1 x %2 pixels.">(image.width, image.height));
  if (static_cast<double>(image.width) * image.height > kMostPixels)
    return failure(ErrorCode::tooLarge, say<"The image is too large to trace in: %1 x %2 pixels.">(image.width, image.height));
  return guarded(
      [&] {
        auto made = std::make_unique<Impl>();
        made->geometry = geometry;
        made->options = options;
        made->grey.create(image.height, image.width, CV_8UC1);
        for (int y = 0; y < image.height; ++y) std::copy_n(image.row(y), image.width, made->grey.ptr<std::uint8_t>(y));
        cv::Mat even = made->grey;
        if (options.blur_mm > 0.0)
          cv::GaussianBlur(made->grey, even, {}, options.blur_mm / geometry.pixel_mm.x, options.blur_mm / geometry.pixel_mm.y);
        made->scissors.setEdgeFeatureCannyParameters(10.0, 30.0, 3, true);
        made->scissors.setGradientMagnitudeMaxLimit(200.0F);
        made->scissors.applyImage(even);
        impl_ = std::move(made);
      },
      openCvFailed);
}

Result<std::vector<glm::dvec2>> EdgeTracer::traceAround(std::span<const glm::dvec2> clicks_mm) {
  if (!hasImage()) return failure(ErrorCode::badField, say<"There is no image to trace in; freeze one first.">());
  if (clicks_mm.size() < 3)
    return failure(ErrorCode::badField, say<"An outline needs at least three clicks; there are %1.">(clicks_mm.size()));
  return guarded(
      [&] {
        const TracingOptions& options = impl_->options;
        const auto even = [&](const std::vector<glm::dvec2>& line) {
          const double deviation = options.smoothing_mm / options.spacing_mm;
          auto points = resampled(line, options.spacing_mm);
          return deviation > 0.0 ? smoothed(points, deviation) : points;
        };
        const auto curve = impl_->lineAbout(clicks_mm);
        if (curve.size() < 3) return std::vector<glm::dvec2>(clicks_mm.begin(), clicks_mm.end());
        const auto onEdge = broughtToEdge(impl_->view(), impl_->geometry, even(curve), options);
        return resampled(even(onEdge), options.spacing_mm);
      },
      openCvFailed);
}

}  // namespace ew::measurement
