#include "dicom/plane_stack.h"

#include <algorithm>
#include <cmath>

#include "ew/core/numbers.h"
#include "files/grey_samples.h"
#include "files/image_header.h"

namespace ew::detail {
namespace fs = std::filesystem;

Result<PlaneStack> stackOf(std::vector<VolumePlane>& planes, int columns, int rows, const fs::path& file, const ReaderLimits& limits,
                           std::vector<Message>& notes) {
  const VolumePlane first = planes.front();
  if (planes.size() < 2)
    return failure(ErrorCode::emptyVolume, say<"%1 holds a single plane, not a volume; import it as an image.">(quoted(file)),
                   {{"file", file.string()}});
  const glm::dvec3 right = glm::normalize(first.across_mm), down = glm::normalize(first.down_mm), normal = glm::cross(right, down);
  for (const VolumePlane& plane : planes)
    if (glm::length(plane.across_mm - first.across_mm) > 1e-3 * glm::length(first.across_mm) ||
        glm::length(plane.down_mm - first.down_mm) > 1e-3 * glm::length(first.down_mm))
      return failure(ErrorCode::unsupported,
                     say<"The planes of %1 are not parallel or differ in size, so that they are no regular grid; import them as a "
                         "sequence, which keeps the place of each, and reconstruct it.">(quoted(file)),
                     {{"file", file.string()}, {"ask", "sequence"}});
  std::sort(planes.begin(), planes.end(),
            [&](const VolumePlane& a, const VolumePlane& b) { return glm::dot(a.origin_mm, normal) < glm::dot(b.origin_mm, normal); });
  PlaneStack stack;
  for (const VolumePlane& plane : planes) stack.along_mm.push_back(glm::dot(plane.origin_mm - planes.front().origin_mm, normal));
  const std::size_t last = planes.size() - 1;
  const glm::dvec3 step_mm = (planes[last].origin_mm - planes[0].origin_mm) / static_cast<double>(last);
  const double mean_mm = stack.along_mm[last] / static_cast<double>(last);
  if (!(mean_mm > 1e-6))
    return failure(ErrorCode::badField,
                   say<"The planes of %1 lie in one plane, so that there is no volume; export it again.">(quoted(file)),
                   {{"file", file.string()}, {"field", "Image Position (Volume)"}});
  double smallest_mm = mean_mm;
  for (std::size_t n = 0; n < planes.size(); ++n) {
    const glm::dvec3 off_mm = planes[n].origin_mm - planes[0].origin_mm - step_mm * static_cast<double>(n);
    const double along_mm = std::abs(glm::dot(off_mm, normal));
    // A hundredth of a voxel is rounding in the file.
    if (along_mm > 0.01 * mean_mm) stack.even = false;
    const double aside_mm = glm::length(off_mm - normal * glm::dot(off_mm, normal));
    if (aside_mm > 0.05 * std::min(glm::length(first.across_mm), glm::length(first.down_mm)))
      return failure(ErrorCode::unsupported,
                     say<"The planes of %1 are shifted sideways against each other unevenly, so that they are no regular grid; import them "
                         "as a sequence, which keeps the place of each, and reconstruct it.">(quoted(file)),
                     {{"file", file.string()}, {"ask", "sequence"}});
    if (n > 0) smallest_mm = std::min(smallest_mm, stack.along_mm[n] - stack.along_mm[n - 1]);
  }
  if (!(smallest_mm > 1e-6 * mean_mm))
    return failure(ErrorCode::badField, say<"Two planes of %1 lie in the same place; export the volume again.">(quoted(file)),
                   {{"file", file.string()}, {"field", "Image Position (Volume)"}});
  std::size_t slices = planes.size();
  glm::dvec3 between_mm = step_mm;
  if (!stack.even) {
    const double wanted = std::floor(stack.along_mm[last] / smallest_mm + 1e-6);
    const double voxels = (wanted + 1.0) * static_cast<double>(columns) * rows;
    if (!(voxels < static_cast<double>(limits.maxBytes)) || wanted > 65536.0)
      return failure(
          ErrorCode::tooLarge,
          say<"The planes of %1 lie so unevenly that a regular grid would be too large; import them as a sequence and reconstruct it.">(
              quoted(file)),
          {{"file", file.string()}, {"ask", "sequence"}});
    slices = static_cast<std::size_t>(wanted) + 1;
    between_mm = step_mm * (stack.along_mm[last] / wanted / mean_mm);
    notes.push_back(say<"The planes lie unevenly, %1 mm apart at the closest; they were resampled linearly to %2 even ones.">(
        textOf(std::round(smallest_mm * 1000.0) / 1000.0), slices));
  }
  stack.grid.dims = {columns, rows, static_cast<int>(slices)};
  stack.grid.spacing_mm = {glm::length(first.across_mm), glm::length(first.down_mm), glm::length(between_mm)};
  stack.grid.origin_mm = planes[0].origin_mm;
  stack.grid.directions = glm::dmat3(right, down, glm::normalize(between_mm));
  if (auto usable = checkGrid(stack.grid); !usable) return passOn(usable.error());
  if (glm::length(glm::cross(glm::normalize(between_mm), normal)) > 0.01)
    notes.push_back(say<"The planes are shifted against each other evenly: the axes are not at right angles and were kept as they are.">());
  return stack;
}

Result<std::vector<std::uint8_t>> echoOnto(const PlaneStack& stack, std::vector<std::uint8_t> planes, const fs::path& file,
                                           const Progress& progress) {
  if (stack.even) return planes;
  const std::size_t pixels = static_cast<std::size_t>(stack.grid.dims.x) * static_cast<std::size_t>(stack.grid.dims.y);
  std::vector<std::uint8_t> echo(stack.grid.voxelCount());
  const double step_mm = stack.along_mm.back() / (stack.grid.dims.z - 1);
  std::size_t below = 0;
  for (int k = 0; k < stack.grid.dims.z; ++k) {
    if (progress.cancelRequested()) return stopped(file);
    const double at_mm = step_mm * k;
    while (below + 2 < stack.along_mm.size() && stack.along_mm[below + 1] <= at_mm) ++below;
    const double share = std::clamp((at_mm - stack.along_mm[below]) / (stack.along_mm[below + 1] - stack.along_mm[below]), 0.0, 1.0);
    const std::uint8_t* const a = planes.data() + below * pixels;
    const std::uint8_t* const b = a + pixels;
    std::uint8_t* const out = echo.data() + static_cast<std::size_t>(k) * pixels;
    for (std::size_t p = 0; p < pixels; ++p) out[p] = static_cast<std::uint8_t>(std::lround((1.0 - share) * a[p] + share * b[p]));
  }
  return echo;
}

}  // namespace ew::detail
