#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <iosfwd>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/image.h"
#include "ew/core/pose.h"
#include "ew/imaging/display.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"

namespace ew {

namespace frame {
struct Wide {};  ///< plane of a wide image: the probe frame of its first image; mm
}  // namespace frame

struct WideOptions {
  double mostTilt_rad = 12.0 * std::numbers::pi / 180.0;  ///< between an image's plane and that of the first one
  double mostOff_mm = 8.0;                                ///< of an image's face from the plane of the first one
  std::size_t bytes = std::size_t{64} << 20;              ///< of all that is held
};

/// What became of an image.
enum class Woven {
  woven,
  noPose,    ///< its pose is not PoseStatus::ok, or no rigid one
  tilted,    ///< out of the plane of the first one, by more than WideOptions::mostTilt_rad
  offPlane,  ///< beside that plane, by more than mostOff_mm
  tooFast,   ///< more than half a width of the fan from every image that was woven: there would be a gap between them
  full,      ///< there is no room for it
};
const char* nameOf(Woven outcome);
std::ostream& operator<<(std::ostream& out, Woven outcome);

/// One image from many of a probe that slides along its own plane ("panoramic", extended field of view), woven from their poses.
///
/// Each image is projected along the plane's normal onto the plane of the first one, whose pixels the wide image has: in size, direction
/// and place, so that images from one pose give that image, to the bit. A level is the mean over the images that see the place, weighted by
/// how near the middle of its fan each of them sees it: 1 at the fan's sides and far end, where a new image begins without an edge, 255 in
/// its middle, by the fourth power between them, so that most of a level comes from the few images that were right above it and little is
/// blurred. The newest image instead of the mean would leave a seam wherever the gain with depth differs from one angle to the next, and
/// would show what was last seen at the side of a fan over what was seen in its middle. Weights and sums are whole numbers: the image
/// does not depend on the order of the images behind the first. Tissue that moves from image to image is blurred as in any mean.
///
/// No thread of its own; not for several at once. Cost: one bilinear reading of each pixel of the fan for each image.
class Panorama {
 public:
  explicit Panorama(const WideOptions& options = {}) : options_(options) {}

  /// Weaves an image in, or leaves everything as it is. The first one with a pose makes the plane.
  /// @param grey  of geometry.width x height
  /// @param knobs what shapes the fan: steering, trapezoid
  Woven add(ImageView<const std::uint8_t> grey, const DisplayGeometry& geometry, const Probe& probe, const Knobs& knobs, const Pose& pose);

  [[nodiscard]] bool empty() const { return imageCount_ == 0; }
  [[nodiscard]] std::size_t imageCount() const { return imageCount_; }
  [[nodiscard]] std::size_t bytes() const;
  [[nodiscard]] const WideOptions& options() const { return options_; }
  /// Place of the plane. Expects an image.
  [[nodiscard]] const Transform<frame::World, frame::Wide>& wideToWorld() const { return wideToWorld_; }

  /// All that was woven, in pixels of the first image. Points of "probe" are mm of frame::Wide here. Expects an image.
  [[nodiscard]] DisplayGeometry geometry() const;
  /// All that was woven in an image of this size, zoomed (1..8) about its middle and panned, not farther than there is something.
  [[nodiscard]] DisplayGeometry fit(int width, int height, double zoom = 1.0, const Pan& pan = {}) const;
  /// The same, as fit() understands it.
  [[nodiscard]] Pan panWithin(double zoom, const Pan& pan) const;
  /// Levels at this geometry, 0 where nothing was woven. Magnified: linear between pixels; made smaller: the mean of up to 8 x 8 of them.
  /// At geometry() the levels as they are. Expects an image, and the directions of geometry().
  [[nodiscard]] GreyImage render(const DisplayGeometry& shown) const;

 private:
  static constexpr int kTile_px = 128;
  static constexpr std::size_t kTilePixels = std::size_t{kTile_px} * kTile_px;
  struct Tile {
    std::array<std::uint32_t, kTilePixels> levels{};  ///< sums of weight * level
    std::array<std::uint32_t, kTilePixels> weights{};
  };
  /// From pixels of the wide image to those of an image.
  struct ToImage {
    glm::dmat2 linear{1.0};
    glm::dvec2 offset{0.0};
    [[nodiscard]] glm::dvec2 operator()(double x, double y) const { return linear * glm::dvec2(x, y) + offset; }
  };
  struct Place {  ///< where an image was woven, mm of frame::Wide
    glm::dvec2 face, bottom;
  };
  struct Box {
    glm::ivec2 low{0}, high{0};  ///< pixels of the first image, high excluded
  };
  void takeWeights(const DisplayGeometry& geometry, const Probe& probe, const Knobs& knobs);
  [[nodiscard]] bool isNear(const Place& at) const;
  [[nodiscard]] bool hasRoom(const Box& box) const;
  void weave(ImageView<const std::uint8_t> grey, const ToImage& toImage, const Box& box);
  void weaveTile(ImageView<const std::uint8_t> grey, const ToImage& toImage, const Box& part, std::pair<int, int> key);
  [[nodiscard]] const Tile* tileAt(int x, int y) const;
  /// Empty where nothing was woven.
  [[nodiscard]] std::optional<std::uint8_t> levelAt(int x, int y) const;
  [[nodiscard]] std::uint8_t between(double x, double y) const;

  WideOptions options_;
  Transform<frame::World, frame::Wide> wideToWorld_;
  Transform<frame::Wide, frame::World> worldToWide_;
  DisplayGeometry first_;
  std::map<std::pair<int, int>, std::unique_ptr<Tile>> tiles_;  ///< by column and row
  Box woven_;
  std::vector<Place> track_;  ///< at least a millimetre apart
  std::size_t imageCount_ = 0;

  // Of the latest fan.
  struct Fan {
    Probe probe;
    double steering_rad = 0.0;
    bool trapezoid = false;
    DisplayGeometry geometry;
    bool operator==(const Fan&) const = default;
  };
  std::optional<Fan> fan_;
  GreyImage weights_;  ///< of its image; 0 outside
  Box used_;           ///< pixels of its image within the fan
  double halfFace_mm = 0.0, halfBottom_mm = 0.0;
};

}  // namespace ew
