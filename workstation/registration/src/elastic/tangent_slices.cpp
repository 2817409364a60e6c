#include <algorithm>
#include <cmath>
#include <numbers>

#include "ew/core/figures.h"
#include "ew/registration/elastic.h"

namespace ew::registration {
namespace {

constexpr int kLongest = 1024;      ///< pixels of a slice along an axis
constexpr double kPerMotion = 2.5;  ///< fall-off over largest motion, at least: a shear of 2/5 on average
constexpr int kLayers = 8;          ///< of nodes on each side of the plane

Result<void> check(const Input& side, const Message& name) {
  if (side.volume == nullptr || side.volume->echo.empty())
    return failure(ErrorCode::emptyVolume, say<"The %1 volume has no voxels.">(name));
  if (auto usable = checkGrid(side.volume->grid); !usable) return passOn(usable.error());
  if (side.volume->echo.size() != side.volume->grid.voxelCount())
    return failure(ErrorCode::badField, say<"The %1 volume holds another number of voxels than its grid says; write it anew.">(name));
  if (!side.confidence.empty() && side.confidence.size() != side.volume->echo.size())
    return failure(ErrorCode::badField, say<"The %1 volume's confidence has another size than the volume.">(name),
                   {{"field", "confidence"}});
  return {};
}

/// The plane's grid: as large as the fixed volume's shadow on it.
Grid planeGrid(const Grid& fixed, const glm::dvec3& plane_mm, const glm::dvec3& normal) {
  // y follows the beam, which runs along j; where the plane stands across the beam, the volume's k.
  glm::dvec3 down = fixed.directions[1] - normal * glm::dot(normal, fixed.directions[1]);
  if (glm::length(down) < 0.3) down = fixed.directions[2] - normal * glm::dot(normal, fixed.directions[2]);
  down = glm::normalize(down);
  const glm::dvec3 across = glm::cross(down, normal);
  glm::dvec2 low(1e300), high(-1e300);
  for (int n = 0; n < 8; ++n) {
    glm::dvec3 corner = fixed.origin_mm;
    for (int axis = 0; axis < 3; ++axis)
      if ((n >> axis & 1) != 0) corner += fixed.directions[axis] * (fixed.spacing_mm[axis] * (fixed.dims[axis] - 1));
    const glm::dvec2 at{glm::dot(corner - plane_mm, across), glm::dot(corner - plane_mm, down)};
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  const double finest = std::min({fixed.spacing_mm.x, fixed.spacing_mm.y, fixed.spacing_mm.z});
  const double pixel = std::max(finest, std::max(high.x - low.x, high.y - low.y) / (kLongest - 1));
  Grid grid;
  grid.dims = {static_cast<int>(std::floor((high.x - low.x) / pixel)) + 1, static_cast<int>(std::floor((high.y - low.y) / pixel)) + 1, 1};
  grid.spacing_mm = glm::dvec3(pixel);
  grid.origin_mm = plane_mm + across * low.x + down * low.y;
  grid.directions = glm::dmat3(across, down, normal);
  return grid;
}

/// Grey levels where the volume covers the plane (at least 1), 0 elsewhere; doubtful voxels count as not covered.
/// @param side the moving volume, or with the identity the fixed one as its own mate
Result<GreyImage> sliceOf(const Input& side, const Transform<frame::Moving, frame::Fixed>& toSide, const Grid& plane, int threads,
                          Progress& progress) {
  auto cut = warped(*side.volume, {toSide, {}}, plane, threads, progress);
  if (!cut) return passOn(cut.error());
  GreyImage image(plane.dims.x, plane.dims.y);
  const auto toVoxel = side.volume->grid.toVoxel<frame::Moving>() * toSide * plane.voxelTo<frame::Fixed>();
  for (std::size_t n = 0; n < image.pixels.size(); ++n) {
    if (cut->coverageAt(n) == Coverage::absent) continue;
    if (!side.confidence.empty()) {
      const glm::dvec3 pixel(n % static_cast<std::size_t>(image.width), n / static_cast<std::size_t>(image.width), 0.0);
      const glm::ivec3 nearest = glm::clamp(glm::ivec3(glm::round(carried(toVoxel, pixel))), glm::ivec3(0), side.volume->grid.dims - 1);
      if (side.confidence[side.volume->grid.indexOf(nearest.x, nearest.y, nearest.z)] < 0.1F) continue;
    }
    image.pixels[n] = std::max<std::uint8_t>(1, cut->echo[n]);
  }
  return image;
}

/// The slices' motion at nodes in the plane, fading along the normal.
ControlGrid fading(const Elastic2dResult& slices, const Grid& plane, double fallOff_mm, double share) {
  ControlGrid control;
  const double node_mm = std::max(2.0 * plane.spacing_mm.x, 2.0);
  control.nodes = plane;
  for (int axis = 0; axis < 2; ++axis) {
    const double extent = plane.spacing_mm[axis] * (plane.dims[axis] - 1);
    control.nodes.dims[axis] = std::max(1, static_cast<int>(std::ceil(extent / node_mm))) + 1;
    control.nodes.spacing_mm[axis] = std::max(1e-3, extent / (control.nodes.dims[axis] - 1));
  }
  control.nodes.dims.z = 2 * kLayers + 1;
  control.nodes.spacing_mm.z = fallOff_mm / kLayers;
  control.nodes.origin_mm = plane.origin_mm - plane.directions[2] * fallOff_mm;
  control.displacement_mm.reserve(control.nodes.voxelCount());
  for (int k = -kLayers; k <= kLayers; ++k) {
    const double fade = share * 0.5 * (1.0 + std::cos(std::numbers::pi * k / kLayers));
    for (int j = 0; j < control.nodes.dims.y; ++j) {
      for (int i = 0; i < control.nodes.dims.x; ++i) {
        const double x = std::min<double>(i * control.nodes.spacing_mm.x / plane.spacing_mm.x, plane.dims.x - 1);
        const double y = std::min<double>(j * control.nodes.spacing_mm.y / plane.spacing_mm.y, plane.dims.y - 1);
        const int left = std::min(static_cast<int>(x), std::max(0, plane.dims.x - 2)),
                  top = std::min(static_cast<int>(y), std::max(0, plane.dims.y - 2));
        const auto at = [&](int a, int b) {
          const int column = std::min(left + a, plane.dims.x - 1), row = std::min(top + b, plane.dims.y - 1);
          return glm::dvec2(slices.displacement_mm[static_cast<std::size_t>(row) * static_cast<std::size_t>(slices.columns) +
                                                   static_cast<std::size_t>(column)]);
        };
        const glm::dvec2 u = glm::mix(glm::mix(at(0, 0), at(1, 0), x - left), glm::mix(at(0, 1), at(1, 1), x - left), y - top) * fade;
        control.displacement_mm.emplace_back(plane.directions[0] * u.x + plane.directions[1] * u.y);
      }
    }
  }
  return control;
}

Message tenths(double value) { return fixedNumeral(value, 1); }

}  // namespace

Result<TangentWarpResult> registerTangentSlices(const Input& fixed, const Input& moving,
                                                const Transform<frame::Moving, frame::Fixed>& start, const glm::dvec3& plane_mm,
                                                const glm::dvec3& normal, const TangentWarpOptions& options, Progress& progress) {
  if (auto usable = check(fixed, say<"fixed">()); !usable) return passOn(usable.error());
  if (auto usable = check(moving, say<"moving">()); !usable) return passOn(usable.error());
  if (auto rigid = checkRigid(start); !rigid) return passOn(rigid.error());
  const double length = glm::length(normal);
  if (!std::isfinite(length) || length < 1e-6)
    return failure(ErrorCode::badField, say<"The tangent plane needs a normal with a direction; this one has none.">(),
                   {{"field", "normal"}});
  if (!std::isfinite(plane_mm.x) || !std::isfinite(plane_mm.y) || !std::isfinite(plane_mm.z))
    return failure(ErrorCode::badField, say<"The tangent plane's point is not a number.">(), {{"field", "plane_mm"}});
  if (!(options.fallOff_mm > 0.0) || !std::isfinite(options.fallOff_mm))
    return failure(ErrorCode::badField, say<"The warp must fall off over more than 0 mm.">(), {{"field", "fallOff_mm"}});
  if (!(options.leastJacobian > 0.0) || !(options.leastJacobian < 1.0))
    return failure(ErrorCode::badField, say<"The least Jacobian must lie between 0 and 1.">(), {{"field", "leastJacobian"}});

  TangentWarpResult result;
  result.slicePlane = planeGrid(fixed.volume->grid, plane_mm, normal / length);
  PartOfProgress cutting(progress, 0.0, 0.2), bending(progress, 0.2, 0.9);
  auto fixedSlice = sliceOf(fixed, {}, result.slicePlane, options.slices.threads, cutting);
  if (!fixedSlice) return passOn(fixedSlice.error());
  auto movingSlice = sliceOf(moving, start, result.slicePlane, options.slices.threads, cutting);
  if (!movingSlice) return passOn(movingSlice.error());
  std::size_t both = 0;
  for (std::size_t n = 0; n < fixedSlice->pixels.size(); ++n) both += fixedSlice->pixels[n] != 0 && movingSlice->pixels[n] != 0 ? 1 : 0;
  if (both < 64)
    return failure(ErrorCode::badField, say<"The tangent plane cuts nothing that both volumes cover: move it into their overlap.">(),
                   {{"field", "plane_mm"}});
  result.fixedSlice = std::move(*fixedSlice);
  result.movingSlice = std::move(*movingSlice);
  const glm::dvec2 pixel_mm{result.slicePlane.spacing_mm.x, result.slicePlane.spacing_mm.y};
  auto slices = registerElastic2d(viewOf(result.fixedSlice), viewOf(result.movingSlice), pixel_mm, options.slices, bending);
  if (!slices) return passOn(slices.error());
  result.slices = std::move(*slices);
  result.reason = result.slices.reason;
  result.fixedToMoving.rigid = start;
  result.fallOff_mm = options.fallOff_mm;
  if (result.slices.largestMotion_mm <= 0.0) return result;

  if (result.fallOff_mm < kPerMotion * result.slices.largestMotion_mm) {
    result.fallOff_mm = kPerMotion * result.slices.largestMotion_mm;
    result.reason = joined({result.reason, say<"The fall-off was lengthened from %1 to %2 mm, 2.5 times the largest motion.">(
                                               tenths(options.fallOff_mm), tenths(result.fallOff_mm))});
  }
  result.fixedToMoving.control = fading(result.slices, result.slicePlane, result.fallOff_mm, 1.0);
  result.jacobian = jacobianOf(result.fixedToMoving.control);
  while (result.jacobian.smallest < options.leastJacobian && result.share > 0.05) {
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The registration was cancelled.">());
    result.share *= 0.9;
    result.fixedToMoving.control = fading(result.slices, result.slicePlane, result.fallOff_mm, result.share);
    result.jacobian = jacobianOf(result.fixedToMoving.control);
  }
  if (result.share < 1.0)
    result.reason =
        joined({result.reason,
                say<"Only %1 % of the motion was kept: all of it would have squeezed the tissue too far.">(tenths(100.0 * result.share))});
  progress.report(say<"Registering">(), 1.0);
  return result;
}

}  // namespace ew::registration
