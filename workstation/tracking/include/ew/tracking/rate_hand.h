#pragma once

#include <array>
#include <optional>
#include <span>

#include "ew/tracking/hand.h"

namespace ew {

/// The six ways a hand controller moves a probe on the skin, in the order of RateHandOptions::axes.
enum class HandMotion { slideLateral, slideElevational, press, rotation, rock, tilt };
inline constexpr std::size_t kHandMotions = 6;

enum class RateMode {
  rate,        ///< how far an axis is pushed is how fast the probe moves; released, it stays where it is
  springBack,  ///< how far an axis is pushed is how far the probe is from where it was; released, it goes back
};

/// Which axis of a controller does one motion, and how much of it.
struct RateAxis {
  int axis = -1;          ///< of the device; -1: none
  bool reversed = false;  ///< pushed the other way
  double full = 0.0;      ///< for an axis pushed all the way: mm/s or rad/s; in springBack mm or rad
  bool operator==(const RateAxis&) const = default;
};

struct RateHandOptions {
  RateMode mode = RateMode::rate;
  double deadZone = 0.08;  ///< share of an axis's way that is none yet, 0..0.9
  double curve = 1.8;      ///< what is left, to this power: fine near the middle, fast at the end; 1..4
  std::array<RateAxis, kHandMotions> axes{};
  bool operator==(const RateHandOptions&) const = default;
};

/// For a SpaceMouse (axes: right, up, away from you, and turns about them): push it and the probe slides, press it down and the probe is
/// pressed in, twist it and the probe rotates, tip it and the probe rocks and tilts.
[[nodiscard]] RateHandOptions spaceMouseOptions(RateMode mode = RateMode::rate);
/// For a game controller (axes: left stick right and down, right stick right and down, right less left trigger, right less left shoulder
/// button): left stick slides, right stick rocks and tilts, triggers press, shoulder buttons rotate.
[[nodiscard]] RateHandOptions gameControllerOptions(RateMode mode = RateMode::rate);

/// What an axis says after dead zone and curve, -1..1; 0 for what is not finite. Steady, odd, and 1 at 1.
[[nodiscard]] double shapedAxis(double axis, double deadZone, double curve);

/// Moves a hold as a hand controller asks. What comes out depends on the axes over time and not on how often it is asked: each step is
/// taken in parts of at most 10 ms, and both halves of a slide lie around the turn between them.
class RateHand {
 public:
  explicit RateHand(const RateHandOptions& options) : options_(options) {}

  /// The hold after `dt_s` with the axes as they are.
  /// @param hold as it is now; one that is not what step() gave last (the mouse moved it) is where springing back ends from now on
  /// @param axes of the device, -1..1 each; missing ones are 0
  /// @param dt_s since the last step, >= 0; of more than a quarter second (a window that hung) the quarter counts
  [[nodiscard]] Hold step(const Hold& hold, const Skin& skin, std::span<const double> axes, double dt_s);
  /// Nothing would move: all axes are in their dead zone, and nothing is left to spring back from.
  [[nodiscard]] bool isAtRest(std::span<const double> axes) const;

  void setOptions(const RateHandOptions& options);
  [[nodiscard]] const RateHandOptions& options() const { return options_; }

 private:
  using Motions = std::array<double, kHandMotions>;
  [[nodiscard]] Motions motionsOf(std::span<const double> axes) const;
  [[nodiscard]] Hold drivenBy(const Hold& hold, const Skin& skin, const Motions& rates, double dt_s) const;
  [[nodiscard]] Hold sprungBy(const Hold& hold, const Skin& skin, const Motions& reach, double dt_s);

  RateHandOptions options_;
  std::optional<Hold> base_;  ///< that springing back ends at
  std::optional<Hold> given_;
  Motions away_{};  ///< how far from the base, on the way to what the axes say
};

}  // namespace ew
