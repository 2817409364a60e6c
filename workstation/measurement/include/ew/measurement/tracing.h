#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "ew/core/image.h"
#include "ew/core/result.h"

namespace ew::measurement {

/// How pixels of an image lie in the plane: pixel (i, j) at origin_mm + (i, j) * pixel_mm.
struct ImageGeometry {
  glm::dvec2 pixel_mm{1.0};   ///< both > 0
  glm::dvec2 origin_mm{0.0};  ///< centre of the first pixel
  [[nodiscard]] glm::dvec2 toPixel(const glm::dvec2& p_mm) const { return (p_mm - origin_mm) / pixel_mm; }
  [[nodiscard]] glm::dvec2 toMm(const glm::dvec2& p_pixel) const { return origin_mm + p_pixel * pixel_mm; }
  bool operator==(const ImageGeometry&) const = default;
};

/// Which side of an edge is bright, along the direction of the search.
enum class EdgeSide { any, darkToBright, brightToDark };

struct SnapOptions {
  double reach_mm = 5.0;   ///< to either side of the point
  double blur_mm = 0.8;    ///< standard deviation of the Gaussian whose derivative finds the edge: about that of speckle
  double across_mm = 2.5;  ///< profiles are averaged over this far to either side, along the edge: speckle is not an edge
  EdgeSide side = EdgeSide::any;
  double weakest = 3.0;  ///< grey levels a mm: below this nothing is an edge
};

/// What a point snapped to.
struct Snapped {
  bool isFound = false;
  glm::dvec2 at_mm{0.0};          ///< the edge; the point itself when none was found
  double moved_mm = 0.0;          ///< along the direction, signed
  double strength = 0.0;          ///< steepness, grey levels a mm
  EdgeSide side = EdgeSide::any;  ///< which side was bright
  bool operator==(const Snapped&) const = default;
};

/// The steepest place of the grey profile through a point along a direction, to a fraction of a pixel (the top of a parabola through the
/// derivative). Outside of the image there is no edge. Cost: some thousand samples.
/// @param direction any length above 0
[[nodiscard]] Snapped snapToEdge(ImageView<const std::uint8_t> image, const ImageGeometry& geometry, glm::dvec2 p_mm, glm::dvec2 direction,
                                 const SnapOptions& options = {});

struct TracingOptions {
  double blur_mm = 1.0;       ///< the image is smoothed by a Gaussian of this standard deviation before edges are looked for
  double smoothing_mm = 2.0;  ///< an outline is smoothed along itself by this standard deviation: a path of pixels is a staircase
  double spacing_mm = 0.5;    ///< of the points of an outline
  SnapOptions snap = {};      ///< of clicks onto the edge, and of the outline to a fraction of a pixel
};

/// Assisted tracing: an outline that follows edges between clicks (intelligent scissors: Mortensen & Barrett, Graphical Models and Image
/// Processing 60, 1998, as in OpenCV's IntelligentScissorsMB), on a grey image in mm of its plane. Not for several threads.
class EdgeTracer {
 public:
  EdgeTracer();
  ~EdgeTracer();
  EdgeTracer(EdgeTracer&&) noexcept;
  EdgeTracer& operator=(EdgeTracer&&) noexcept;

  /// Copies the image and finds its edges: a frozen image. Cost: a few passes over it.
  /// @error tooLarge (beyond 64 megapixels), badField (narrower than 8 pixels), internal (OpenCV's words)
  [[nodiscard]] Result<void> setImage(ImageView<const std::uint8_t> image, const ImageGeometry& geometry,
                                      const TracingOptions& options = {});
  [[nodiscard]] bool hasImage() const;

  /// A closed outline about clicks around it. It begins as the ellipse of the clicks where they lie about one, else as a smooth line
  /// through them (paths join those that lie far apart), and is brought to the edge that keeps one side and lies evenly about the clicks,
  /// at a fraction of a pixel, and smoothed. Where the edge fades, it goes on between what is seen. Of a bright wall the border is meant,
  /// not the flank that logarithmic compression draws beyond it. Points at even distances, the first one not repeated.
  /// @param clicks_mm at least 3 @error badField (too few, no image yet)
  [[nodiscard]] Result<std::vector<glm::dvec2>> traceAround(std::span<const glm::dvec2> clicks_mm);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ew::measurement
