#pragma once

#include <array>
#include <glm/glm.hpp>
#include <utility>
#include <vector>

#include "ew/core/image.h"

namespace ew {

struct Probe;
struct Knobs;

/// What the colours of a box tell.
enum class ColourShows {
  velocity,          ///< the mean velocity along the beam
  variance,          ///< the same, and where it spreads (turbulence) a second hue
  power,             ///< how much blood moves, whatever its direction and speed
  directionalPower,  ///< the same in two hues
};

/// What is taken for tissue and left out: the polynomial of this order through each packet (WallFilter).
enum class WallFilterSetting { low, medium, high };

inline constexpr int kMostPacket = 32;

/// A colour box and its part of the console. Zero velocity has no colour; towards the probe is red and away is blue until inverted.
struct ColourDoppler {
  ColourShows shows = ColourShows::velocity;
  double boxMiddle = 0.0;     ///< across the face: -1 at its -x end .. +1
  double boxWidth = 0.5;      ///< share of the face, 0.1..1
  double boxMiddle_mm = 0.0;  ///< depth of its middle; 0: half of the image's
  double boxHeight_mm = 0.0;  ///< along the lines; 0: two fifths of the image's depth
  double steering_rad = 0.0;  ///< linear probes: of the box's lines, towards +x, at most kMostColourSteering_rad and the probe's largest
  double carrier_hz = 0.0;    ///< sent for colour, 1e6..2e7; 0: two thirds of the image's own
  double prf_hz = 4000.0;     ///< pulses a second, 100..20000; no more than the box's lower edge lets come back
  int packet = 10;            ///< pulses of one line, 2..32
  WallFilterSetting wallFilter = WallFilterSetting::medium;
  double baseline = 0.0;     ///< share of the range that is moved from away to towards, -0.9..0.9: 0.5 shows -vN / 2 .. 3 vN / 2
  double gain_db = 0.0;      ///< -30..30
  double priority = 0.5;     ///< echoes of this grey and above are tissue, as a share of white, 0..1
  double reject = 0.03;      ///< slower than this share of the Nyquist velocity has no colour, 0..0.5
  double persistence = 0.3;  ///< share of the last box that stays, 0..0.95
  int everyLine = 2;         ///< image lines for each line of colour, 1..4
  int smoothing = 1;         ///< neighbours on either side that are averaged, 0..3
  bool invert = false;       ///< towards is blue
  bool operator==(const ColourDoppler&) const = default;
};
inline constexpr double kMostColourSteering_rad = 0.3490658503988659;  // 20 degrees

/// A box as it comes out of settings, probe and depth: what acts.
struct ColourBox {
  double left = -0.5, right = 0.5;       ///< across the face, -1..1
  double top_mm = 0.0, bottom_mm = 0.0;  ///< along the lines, from the face
  double steering_rad = 0.0;
  double carrier_hz = 0.0;
  double prf_hz = 0.0;
  double nyquist_mmPerS = 0.0;   ///< along the beam
  double wallEdge_mmPerS = 0.0;  ///< slower blood loses half of its power or more
  int packet = 10;
  int filterOrder = 1;   ///< of the polynomial
  int lines = 0;         ///< of colour within the box
  double frame_s = 0.0;  ///< that a machine needs for the box: lines x packet / prf
  /// What is shown, towards the probe positive: from the first to the second.
  std::pair<double, double> shown_mmPerS{0.0, 0.0};
};
/// @param knobs with colour (Knobs::colour); brought within limits
[[nodiscard]] ColourBox colourBoxOf(const Probe& probe, const Knobs& knobs);
/// Its outline in the probe's x-y plane, mm, closed: left edge down, lower edge, right edge up, upper edge.
[[nodiscard]] std::vector<glm::dvec2> colourBoxOutline_mm(const Probe& probe, const Knobs& knobs);
/// The knobs with the box's middle at a point of the image plane, as far as the box stays within the fan.
[[nodiscard]] Knobs withColourBoxAt(const Probe& probe, const Knobs& knobs, const glm::dvec2& p_mm);

/// Where a point of the image plane lies for the box: across the face, -1..1 within the fan, and along the box's lines from the face.
struct ColourPlace {
  double across = 0.0;
  double depth_mm = 0.0;
};
/// @param knobs with colour
[[nodiscard]] ColourPlace colourPlaceOf(const Probe& probe, const Knobs& knobs, const glm::dvec2& p_mm);
/// The knobs with the box's middle at a place, as far as the box stays within the fan.
[[nodiscard]] Knobs withColourBoxMiddle(const Probe& probe, const Knobs& knobs, const ColourPlace& middle);
/// Edges of a box; left is towards the face's -x end.
struct ColourEdges {
  bool left = false, right = false, top = false, bottom = false;
  bool operator==(const ColourEdges&) const = default;
};
/// The knobs with these edges of the box at a place, as far as it stays within the fan and is not too small; the other edges stay.
[[nodiscard]] Knobs withColourEdgesAt(const Probe& probe, const Knobs& knobs, const ColourEdges& edges, const ColourPlace& place);

/// Colours of what is shown.
/// @param value velocities: -1..1 from the lowest shown to the highest; power: 0..1; directional power: -1..1
/// @param spread 0..1 of the Nyquist velocity; of ColourShows::variance alone
[[nodiscard]] Rgb colourOf(const ColourDoppler& colour, double value, double spread = 0.0);
/// The bar beside the image: (width x height), what is highest at the top; with variance, spread grows to the right.
[[nodiscard]] RgbImage colourBar(const ColourDoppler& colour, int width, int height);

}  // namespace ew
