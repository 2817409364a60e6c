#include "ew/imaging/panorama.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

#include "../probes/fan_shape.h"
#include "ew/core/contract.h"
#include "ew/core/word_table.h"

namespace ew {
namespace {

constexpr std::size_t kMostImages = std::numeric_limits<std::uint32_t>::max() / (255U * 255U);  // sums stay within 32 bits
constexpr double kFarEnd = 0.1;                                                                 // of the depth, where weights fall
constexpr double kMargin = 0.02;                                                                // of an image, on each side
constexpr int kMostPerPixel = 8;

/// From mm of the probe's plane to pixels.
glm::dvec2 pixelOf(const DisplayGeometry& geometry, const glm::dvec2& p_mm) {
  const glm::dvec2 along(geometry.markerLeft ? -p_mm.x : p_mm.x, geometry.upsideDown ? -p_mm.y : p_mm.y);
  return geometry.face_px + along / geometry.pixel_mm;
}

/// A transform of the plane, as what it does to pixels.
glm::dmat2 directionsOf(const DisplayGeometry& geometry) {
  return {geometry.markerLeft ? -geometry.pixel_mm : geometry.pixel_mm, 0.0, 0.0,
          geometry.upsideDown ? -geometry.pixel_mm : geometry.pixel_mm};
}

int floorDiv(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

constexpr WordTable<Woven, 6> kWovenWords{{{"woven", Woven::woven},
                                           {"no pose", Woven::noPose},
                                           {"tilted out of the plane", Woven::tilted},
                                           {"beside the plane", Woven::offPlane},
                                           {"too fast", Woven::tooFast},
                                           {"full", Woven::full}}};

}  // namespace

const char* nameOf(Woven outcome) { return wordIn(kWovenWords, outcome); }

std::ostream& operator<<(std::ostream& out, Woven outcome) { return out << nameOf(outcome); }

std::size_t Panorama::bytes() const {
  return tiles_.size() * sizeof(Tile) + track_.capacity() * sizeof(Place) + weights_.pixels.capacity();
}

void Panorama::takeWeights(const DisplayGeometry& geometry, const Probe& probe, const Knobs& knobs) {
  Fan fan{probe, knobs.steering_rad, knobs.trapezoid, geometry};
  if (fan_ == fan) return;
  fan_ = std::move(fan);
  const detail::FanShape shape = detail::fanShapeOf(probe, knobs);
  weights_ = GreyImage(geometry.width, geometry.height);
  const Spans spans = fanSpans(probe, knobs, geometry);
  used_ = {{geometry.width, geometry.height}, {0, 0}};
  for (int y = 0; y < geometry.height; ++y) {
    std::uint8_t* row = viewOf(weights_).row(y);
    for (const RowSpan& run : spans[static_cast<std::size_t>(y)]) {
      used_.low = glm::min(used_.low, glm::ivec2(run.begin, y));
      used_.high = glm::max(used_.high, glm::ivec2(run.end, y + 1));
      for (int x = run.begin; x < run.end; ++x) {
        const detail::FanShape::Place place = shape.placeOf(geometry.probePoint_mm(x, y));
        const double sideways = 1.0 - std::min(1.0, std::abs(place.across));
        const double along = std::clamp((1.0 - place.depth_mm / geometry.depth_mm) / kFarEnd, 0.0, 1.0);
        const double near = sideways * along;
        row[x] = static_cast<std::uint8_t>(1.0 + std::round(254.0 * near * near * near * near));
      }
    }
  }
  halfFace_mm = std::max(faceHalfWidth_mm(probe), 5.0);
  halfBottom_mm = std::max(shape.box(geometry.depth_mm).halfWidth_mm, 5.0);
}

bool Panorama::isNear(const Place& at) const {
  return std::any_of(track_.begin(), track_.end(), [&](const Place& each) {
    return glm::distance(each.face, at.face) <= halfFace_mm && glm::distance(each.bottom, at.bottom) <= halfBottom_mm;
  });
}

bool Panorama::hasRoom(const Box& box) const {
  if (imageCount_ >= kMostImages) return false;
  std::size_t tiles = tiles_.size();
  for (int row = floorDiv(box.low.y, kTile_px); row <= floorDiv(box.high.y - 1, kTile_px); ++row)
    for (int column = floorDiv(box.low.x, kTile_px); column <= floorDiv(box.high.x - 1, kTile_px); ++column)
      tiles += tiles_.contains({column, row}) ? 0 : 1;
  return tiles * sizeof(Tile) <= options_.bytes;
}

Woven Panorama::add(ImageView<const std::uint8_t> grey, const DisplayGeometry& geometry, const Probe& probe, const Knobs& knobs,
                    const Pose& pose) {
  EW_EXPECTS(grey.width == geometry.width && grey.height == geometry.height && geometry.pixel_mm > 0.0);
  if (pose.status != PoseStatus::ok || !checkRigid(pose.probeToWorld)) return Woven::noPose;
  const bool isFirst = empty();
  if (isFirst) {
    wideToWorld_ = renamed<frame::World, frame::Wide>(pose.probeToWorld);
    worldToWide_ = rigidInverse(wideToWorld_);
    first_ = geometry;
    woven_ = {};
  }
  const Transform<frame::Wide, frame::Probe> probeToWide =
      isFirst ? Transform<frame::Wide, frame::Probe>{} : worldToWide_ * pose.probeToWorld;
  const glm::dmat4& matrix = probeToWide.matrix;
  if (matrix[2].z < std::cos(options_.mostTilt_rad)) return Woven::tilted;
  if (std::abs(matrix[3].z) > options_.mostOff_mm) return Woven::offPlane;

  takeWeights(geometry, probe, knobs);
  if (used_.low.x >= used_.high.x) return Woven::woven;  // the image shows nothing of the fan
  const glm::dvec2 face(matrix[3]);
  const Place at{face, face + geometry.depth_mm * glm::dvec2(matrix[1])};
  if (!isFirst && !isNear(at)) return Woven::tooFast;

  // Pixels of the image to those of the wide image, along the plane's normal; and back.
  const glm::dmat2 inPlane{glm::dvec2(matrix[0]), glm::dvec2(matrix[1])};
  const glm::dmat2 toWide = glm::inverse(directionsOf(first_)) * inPlane * directionsOf(geometry);
  const glm::dvec2 faceAt = pixelOf(first_, face);
  ToImage toImage;
  if (isFirst) {
    toImage = {};
  } else {
    toImage.linear = glm::inverse(toWide);
    toImage.offset = geometry.face_px - toImage.linear * faceAt;
  }
  glm::dvec2 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
  for (const glm::dvec2 corner : {glm::dvec2(used_.low), glm::dvec2(used_.high.x - 1, used_.low.y),
                                  glm::dvec2(used_.low.x, used_.high.y - 1), glm::dvec2(used_.high - 1)}) {
    const glm::dvec2 there = toWide * (corner - geometry.face_px) + faceAt;
    low = glm::min(low, there);
    high = glm::max(high, there);
  }
  constexpr double kFarthest_px = 1e6;
  if (glm::any(glm::lessThan(low, glm::dvec2(-kFarthest_px))) || glm::any(glm::greaterThan(high, glm::dvec2(kFarthest_px))))
    return Woven::full;
  const Box box{glm::ivec2(glm::floor(low - 0.5)), glm::ivec2(glm::ceil(high + 0.5)) + 1};
  if (!hasRoom(box)) return Woven::full;
  weave(grey, toImage, box);
  ++imageCount_;
  constexpr double kApart_mm = 1.0;
  if (std::none_of(track_.begin(), track_.end(), [&](const Place& each) {
        return glm::distance(each.face, at.face) < kApart_mm && glm::distance(each.bottom, at.bottom) < kApart_mm;
      }))
    track_.push_back(at);
  return Woven::woven;
}

void Panorama::weave(ImageView<const std::uint8_t> grey, const ToImage& toImage, const Box& box) {
  for (int row = floorDiv(box.low.y, kTile_px); row <= floorDiv(box.high.y - 1, kTile_px); ++row)
    for (int column = floorDiv(box.low.x, kTile_px); column <= floorDiv(box.high.x - 1, kTile_px); ++column) {
      const glm::ivec2 corner(column * kTile_px, row * kTile_px);
      weaveTile(grey, toImage, {glm::max(box.low, corner), glm::min(box.high, corner + kTile_px)}, {column, row});
    }
}

void Panorama::weaveTile(ImageView<const std::uint8_t> grey, const ToImage& toImage, const Box& part, std::pair<int, int> key) {
  const auto known = tiles_.find(key);
  Tile* tile = known != tiles_.end() ? known->second.get() : nullptr;
  const ImageView<const std::uint8_t> weights = viewOf(std::as_const(weights_));
  for (int y = part.low.y; y < part.high.y; ++y) {
    for (int x = part.low.x; x < part.high.x; ++x) {
      const glm::dvec2 from = toImage(x, y);
      const int nearX = static_cast<int>(std::floor(from.x + 0.5)), nearY = static_cast<int>(std::floor(from.y + 0.5));
      if (nearX < 0 || nearY < 0 || nearX >= grey.width || nearY >= grey.height) continue;
      const std::uint32_t weight = weights.data[nearY * weights.stride + nearX];
      if (weight == 0) continue;
      std::uint32_t level = grey.data[nearY * grey.stride + nearX];
      // Linear in steps of 1/256, and only between pixels of the fan: what lies beside it is no echo.
      const auto fineX = static_cast<int>(std::lround((from.x) * 256.0)), fineY = static_cast<int>(std::lround(from.y * 256.0));
      const int left = fineX >> 8, top = fineY >> 8;
      const auto shareX = static_cast<std::uint32_t>(fineX & 255), shareY = static_cast<std::uint32_t>(fineY & 255);
      const int right = left + (shareX != 0 ? 1 : 0), bottom = top + (shareY != 0 ? 1 : 0);
      if (left >= 0 && top >= 0 && right < grey.width && bottom < grey.height) {
        const std::uint8_t *upper = weights.data + top * weights.stride, *lower = weights.data + bottom * weights.stride;
        if (upper[left] != 0 && upper[right] != 0 && lower[left] != 0 && lower[right] != 0) {
          const std::uint8_t *above = grey.data + top * grey.stride, *below = grey.data + bottom * grey.stride;
          const std::uint32_t first = above[left] * (256U - shareX) + above[right] * shareX;
          const std::uint32_t second = below[left] * (256U - shareX) + below[right] * shareX;
          level = (first * (256U - shareY) + second * shareY + 32768U) >> 16;
        }
      }
      if (tile == nullptr) tile = (tiles_[key] = std::make_unique<Tile>()).get();
      const auto n = static_cast<std::size_t>((y - key.second * kTile_px) * kTile_px + (x - key.first * kTile_px));
      tile->levels[n] += weight * level;
      tile->weights[n] += weight;
      if (woven_.low == woven_.high) woven_ = {{x, y}, {x + 1, y + 1}};
      woven_.low = glm::min(woven_.low, glm::ivec2(x, y));
      woven_.high = glm::max(woven_.high, glm::ivec2(x + 1, y + 1));
    }
  }
}

const Panorama::Tile* Panorama::tileAt(int x, int y) const {
  const auto found = tiles_.find({floorDiv(x, kTile_px), floorDiv(y, kTile_px)});
  return found != tiles_.end() ? found->second.get() : nullptr;
}

std::optional<std::uint8_t> Panorama::levelAt(int x, int y) const {
  const Tile* tile = tileAt(x, y);
  if (tile == nullptr) return {};
  const auto n = static_cast<std::size_t>((y & (kTile_px - 1)) * kTile_px + (x & (kTile_px - 1)));
  const std::uint32_t weight = tile->weights[n];
  if (weight == 0) return {};
  return static_cast<std::uint8_t>((std::uint64_t{tile->levels[n]} + weight / 2) / weight);
}

std::uint8_t Panorama::between(double x, double y) const {
  const double left = std::floor(x), top = std::floor(y);
  const double shareX = x - left, shareY = y - top;
  const auto nearest = levelAt(static_cast<int>(std::floor(x + 0.5)), static_cast<int>(std::floor(y + 0.5)));
  if (!nearest) return 0;
  const int x0 = static_cast<int>(left), y0 = static_cast<int>(top);
  const auto a = levelAt(x0, y0), b = levelAt(x0 + 1, y0), c = levelAt(x0, y0 + 1), d = levelAt(x0 + 1, y0 + 1);
  if (!a || !b || !c || !d) return *nearest;
  return static_cast<std::uint8_t>(
      std::lround((*a * (1.0 - shareX) + *b * shareX) * (1.0 - shareY) + (*c * (1.0 - shareX) + *d * shareX) * shareY));
}

DisplayGeometry Panorama::geometry() const {
  EW_EXPECTS(!empty());
  DisplayGeometry whole = first_;
  whole.width = std::max(1, woven_.high.x - woven_.low.x);
  whole.height = std::max(1, woven_.high.y - woven_.low.y);
  whole.face_px = first_.face_px - glm::dvec2(woven_.low);
  return whole;
}

Pan Panorama::panWithin(double zoom, const Pan& pan) const {
  const DisplayGeometry whole = geometry();
  const double free = zoom > 1.0 ? 1.0 - 1.0 / std::min(zoom, 8.0) : 0.0;
  const auto within = [](double asked_mm, double most_mm) {
    return std::isfinite(asked_mm) ? std::clamp(asked_mm, -most_mm, most_mm) : 0.0;
  };
  return {within(pan.lateral_mm, 0.5 * free * whole.width * whole.pixel_mm),
          within(pan.axial_mm, 0.5 * free * whole.height * whole.pixel_mm)};
}

DisplayGeometry Panorama::fit(int width, int height, double zoom, const Pan& pan) const {
  EW_EXPECTS(width >= 1 && height >= 1);
  const DisplayGeometry whole = geometry();
  DisplayGeometry shown = whole;
  shown.width = width;
  shown.height = height;
  const double usable = 1.0 - 2.0 * kMargin;
  const double magnified = zoom > 1.0 ? std::min(zoom, 8.0) : 1.0;
  shown.pixel_mm = std::max(whole.width / (usable * width), whole.height / (usable * height)) * whole.pixel_mm / magnified;
  const Pan part = panWithin(zoom, pan);
  const glm::dvec2 across(whole.markerLeft ? -1.0 : 1.0, whole.upsideDown ? -1.0 : 1.0);
  // From the middle of what was woven to the face, in the image's directions.
  const glm::dvec2 toFace_mm = (whole.face_px - 0.5 * glm::dvec2(whole.width - 1, whole.height - 1)) * whole.pixel_mm;
  shown.face_px =
      0.5 * glm::dvec2(width - 1, height - 1) + (toFace_mm - across * glm::dvec2(part.lateral_mm, part.axial_mm)) / shown.pixel_mm;
  return shown;
}

GreyImage Panorama::render(const DisplayGeometry& shown) const {
  EW_EXPECTS(!empty() && shown.markerLeft == first_.markerLeft && shown.upsideDown == first_.upsideDown);
  GreyImage made(shown.width, shown.height);
  const double ratio = shown.pixel_mm / first_.pixel_mm;
  const int perPixel = std::clamp(static_cast<int>(std::ceil(ratio - 1e-9)), 1, kMostPerPixel);
  const bool isMagnified = ratio < 1.0 - 1e-9;
  for (int y = 0; y < shown.height; ++y) {
    std::uint8_t* row = viewOf(made).row(y);
    const double fromY = first_.face_px.y + (y - shown.face_px.y) * ratio;
    for (int x = 0; x < shown.width; ++x) {
      const double fromX = first_.face_px.x + (x - shown.face_px.x) * ratio;
      if (isMagnified) {
        row[x] = between(fromX, fromY);
        continue;
      }
      int sum = 0, count = 0;
      for (int j = 0; j < perPixel; ++j)
        for (int i = 0; i < perPixel; ++i) {
          const double atX = fromX + ((i + 0.5) / perPixel - 0.5) * ratio, atY = fromY + ((j + 0.5) / perPixel - 0.5) * ratio;
          if (const auto level = levelAt(static_cast<int>(std::floor(atX + 0.5)), static_cast<int>(std::floor(atY + 0.5)))) {
            sum += *level;
            ++count;
          }
        }
      // Where less than half of a pixel was seen there is nothing: a rim that is drawn would be wider than what was scanned.
      if (2 * count >= perPixel * perPixel && count > 0) row[x] = static_cast<std::uint8_t>((sum + count / 2) / count);
    }
  }
  return made;
}

}  // namespace ew
