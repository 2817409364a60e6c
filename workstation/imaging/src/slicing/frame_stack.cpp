#include "ew/imaging/frame_stack.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "ew/core/order_statistics.h"
#include "ew/imaging/slicing.h"

namespace ew {
namespace {

/// Samples between two places that are worked out; between them the stack is as good as straight: a probe that is rocked about a point
/// 50 mm away bends 5 mm of a row by 0.06 mm.
constexpr int kSegment = 16;
constexpr std::uint32_t kParts = 256;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kBeyondEnds = 0.5;     // images that the first and the last one reach outwards
constexpr double kNearestWithin = 1.5;  // steps between images, of a point between planes that cross

/// Weights of Keys' cubic convolution (a = -1/2) over four pixels, in 1024ths, at each of kParts places between the middle two.
constexpr std::int32_t kWhole = 1024;
constexpr auto kKeys = [] {
  std::array<std::array<std::int32_t, 4>, kParts> table{};
  for (std::uint32_t n = 0; n < kParts; ++n) {
    const double t = static_cast<double>(n) / kParts;
    const double exact[4] = {((-0.5 * t + 1.0) * t - 0.5) * t, (1.5 * t - 2.5) * t * t + 1.0, ((-1.5 * t + 2.0) * t + 0.5) * t,
                             (0.5 * t - 0.5) * t * t};
    std::int32_t sum = 0;
    for (std::size_t k : {std::size_t{0}, std::size_t{2}, std::size_t{3}}) {
      table[n][k] = static_cast<std::int32_t>(exact[k] * kWhole + (exact[k] < 0.0 ? -0.5 : 0.5));
      sum += table[n][k];
    }
    table[n][1] = kWhole - sum;  // an even grey stays as it is
  }
  return table;
}();

/// Around the pixel at `corner`, in 256ths of a grey level. @param line pixels of a row
std::int32_t cubicAt(const std::uint8_t* corner, std::size_t line, std::uint32_t u, std::uint32_t v) {
  const auto &across = kKeys[u], &down = kKeys[v];
  const std::uint8_t* row = corner - line - 1;
  std::int32_t sum = 0;
  for (std::size_t n = 0; n < 4; ++n, row += line)
    sum += down[n] * ((across[0] * row[0] + across[1] * row[1] + across[2] * row[2] + across[3] * row[3]) / 16);
  return sum / (kWhole * kWhole / 16 / 256);
}

glm::dvec4 rowOf(const glm::dmat4& matrix, int row) { return {matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]}; }

bool isUsable(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(matrix[column][row])) return false;
  return std::abs(glm::determinant(matrix)) > 1e-12;
}

}  // namespace

Result<FrameStack> FrameStack::make(std::vector<std::uint8_t> pixels, int width, int height,
                                    std::span<const Transform<frame::Voxel, frame::Image>> imageToVoxel) {
  const auto refused = [](Message expected) {
    return failure(ErrorCode::badField, say<"The recorded images of a volume cannot be sliced: %1.">(std::move(expected)),
                   {{"field", "volume.frames"}});
  };
  const std::size_t count = imageToVoxel.size();
  if (count < 2) return refused(say<"there are fewer than two">());
  if (width < 2 || height < 2 || pixels.size() < count * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    return refused(say<"they have too few pixels">());
  FrameStack stack;
  stack.width_ = width;
  stack.height_ = height;
  stack.pixels_ = std::move(pixels);
  const glm::dvec4 middle(0.5 * (width - 1), 0.5 * (height - 1), 0.0, 1.0);
  for (const auto& each : imageToVoxel) {
    if (!isUsable(each.matrix)) return refused(say<"one of them lies nowhere">());
    glm::dmat4 upright = each.matrix;
    const glm::dvec3 normal = glm::cross(glm::dvec3(upright[0]), glm::dvec3(upright[1]));
    if (glm::length(normal) < 1e-9) return refused(say<"one of them is flat">());
    upright[2] = glm::dvec4(glm::normalize(normal), 0.0);
    const glm::dmat4 voxelToImage = glm::inverse(upright);
    stack.frames_.push_back({rowOf(voxelToImage, 0), rowOf(voxelToImage, 1), rowOf(voxelToImage, 2)});
  }
  // Ahead is where the next image lies, of each by itself: a file may turn its planes' normals either way.
  std::vector<double> steps;
  for (std::size_t n = 0; n < count; ++n) {
    const bool isLast = n + 1 == count;
    const glm::dvec4 other = imageToVoxel[isLast ? n - 1 : n + 1].matrix * middle;
    const double step = glm::dot(stack.frames_[n].ahead, other) * (isLast ? -1.0 : 1.0);
    if (step < 0.0) stack.frames_[n].ahead = -stack.frames_[n].ahead;
    if (!isLast) steps.push_back(std::abs(step));
  }
  stack.usual_ = std::max(1e-6, upperMedianOf(steps));
  return stack;
}

glm::dvec3 FrameStack::nearest(const glm::dvec4& point, int& near) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < frames_.size(); ++n)
    if (const double off = std::abs(glm::dot(frames_[n].ahead, point)); off < least) {
      least = off;
      near = static_cast<int>(n);
    }
  if (least > kNearestWithin * usual_) return {0.0, 0.0, kNone};
  const Frame& frame = frames_[static_cast<std::size_t>(near)];
  return {glm::dot(frame.x, point), glm::dot(frame.y, point), static_cast<double>(near)};
}

glm::dvec3 FrameStack::at(const glm::dvec3& point_voxel, int& near) const {
  const glm::dvec4 point(point_voxel, 1.0);
  const int last = static_cast<int>(frames_.size()) - 1;
  near = std::clamp(near, 0, last - 1);
  const auto ahead = [&](int n) { return glm::dot(frames_[static_cast<std::size_t>(n)].ahead, point); };
  double before = ahead(near), after = ahead(near + 1);
  for (int tried = 0; tried < last && after >= 0.0 && before >= 0.0 && near + 1 < last; ++tried)
    before = std::exchange(after, ahead(++near + 1));
  for (int tried = 0; tried < last && before < 0.0 && after < 0.0 && near > 0; ++tried) after = std::exchange(before, ahead(--near));
  const double step = before - after;
  if (step < 0.2 * usual_) return nearest(point, near);  // planes that meet or cross here
  const double share = before / step;
  if (near + share < -kBeyondEnds || near + share > last + kBeyondEnds) return {0.0, 0.0, kNone};
  const double held = std::clamp(share, 0.0, 1.0);
  const Frame &lower = frames_[static_cast<std::size_t>(near)], &upper = frames_[static_cast<std::size_t>(near + 1)];
  return {glm::mix(glm::dot(lower.x, point), glm::dot(upper.x, point), held),
          glm::mix(glm::dot(lower.y, point), glm::dot(upper.y, point), held), near + held};
}

std::uint8_t FrameStack::greyAt(Quality quality, const glm::vec3& p) const {
  const std::size_t line = static_cast<std::size_t>(width_), image = line * static_cast<std::size_t>(height_);
  if (quality == Quality::weave) {
    const auto x = static_cast<std::size_t>(p.x + 0.5F), y = static_cast<std::size_t>(p.y + 0.5F), z = static_cast<std::size_t>(p.z + 0.5F);
    return pixels_[z * image + y * line + x];
  }
  // Parts in 256ths: half a grey level at most where greys of 0 and 255 meet.
  const auto x = static_cast<std::uint32_t>(p.x * kParts), y = static_cast<std::uint32_t>(p.y * kParts),
             z = static_cast<std::uint32_t>(p.z * kParts);
  const std::uint32_t u = x % kParts, v = y % kParts, w = z % kParts, i = x / kParts, j = y / kParts;
  const std::uint8_t* corner = pixels_.data() + (z / kParts) * image + j * line + i;
  const auto width = static_cast<std::uint32_t>(width_), height = static_cast<std::uint32_t>(height_);
  if (quality == Quality::cubic && i > 0 && j > 0 && i + 2 < width && j + 2 < height) {
    const auto blend = static_cast<std::int32_t>(w), parts = static_cast<std::int32_t>(kParts);
    const std::int32_t first = cubicAt(corner, line, u, v), other = blend == 0 ? first : cubicAt(corner + image, line, u, v);
    return static_cast<std::uint8_t>(std::clamp((first * (parts - blend) + other * blend + parts * parts / 2) / (parts * parts), 0, 255));
  }
  const auto along = [u](const std::uint8_t* at) { return at[0] * (kParts - u) + at[1] * u; };
  const auto inImage = [&](const std::uint8_t* at) { return (along(at) * (kParts - v) + along(at + line) * v) / kParts; };
  return static_cast<std::uint8_t>((inImage(corner) * (kParts - w) + inImage(corner + image) * w + kParts * kParts / 2) /
                                   (kParts * kParts));
}

void FrameStack::sampleRow(Quality quality, const glm::dvec3& start_voxel, const glm::dvec3& step_voxel, const RowSpan& span,
                           std::uint8_t* row) const {
  // The last pixels and the last image are blended with those before them.
  const glm::dvec3 last(width_ - 1, height_ - 1, static_cast<double>(frames_.size()) - 1.0), most = last - 1e-3;
  const auto isWithin = [&](const glm::dvec3& p) {
    return p.x >= 0.0 && p.y >= 0.0 && p.z >= 0.0 && p.x <= most.x && p.y <= most.y && p.z <= most.z;  // false for NaN
  };
  const auto nearEdge = [&](const glm::dvec3& p) {
    const bool isRecorded = p.x >= -0.5 && p.y >= -0.5 && p.x < last.x + 0.5 && p.y < last.y + 0.5 && !std::isnan(p.z);
    return isRecorded ? greyAt(quality, glm::vec3(glm::clamp(p, glm::dvec3(0.0), most))) : std::uint8_t{0};
  };
  const auto placeOf = [&](int n) { return start_voxel + static_cast<double>(n) * step_voxel; };
  int near = static_cast<int>(frames_.size()) / 2;
  glm::dvec3 from = at(placeOf(span.begin), near);
  for (int begin = span.begin; begin < span.end; begin += kSegment) {
    const int count = std::min(kSegment, span.end - begin);
    int own = near;
    const glm::dvec3 to = at(placeOf(begin + count), near);
    const bool isStraight = std::abs(to.z - from.z) < static_cast<double>(count);  // false for NaN
    const glm::dvec3 step = (to - from) / static_cast<double>(count);
    if (isStraight && isWithin(from) && isWithin(to)) {
      const glm::vec3 first(from), each(step);
      for (int n = 0; n < count; ++n) row[begin + n] = greyAt(quality, first + static_cast<float>(n) * each);
    } else {
      // Where an end lies outside, every sample is asked for itself.
      for (int n = 0; n < count; ++n)
        row[begin + n] = nearEdge(isStraight ? from + static_cast<double>(n) * step : at(placeOf(begin + n), own));
    }
    from = to;
  }
}

}  // namespace ew
