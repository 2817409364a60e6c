#pragma once

#include <deque>
#include <glm/glm.hpp>
#include <optional>

namespace ew::ui {

/// Whether a hand holds a point still: all its places of the last second lie close together.
class TrackerStill {
 public:
  static constexpr double kHold_s = 1.0;
  static constexpr double kWithin_mm = 2.0;  ///< a hand that rests on skin trembles by less
  static constexpr double kAway_mm = 25.0;   ///< that it moves before it can be taken to rest anew

  void add(const glm::dvec3& at_mm, double time_s);
  void forget();
  /// The mean of the last second, once it was held that long; given again only after the hand has moved away.
  [[nodiscard]] std::optional<glm::dvec3> taken();
  /// The mean of what there is of the last second, however it moved; empty: nothing.
  [[nodiscard]] std::optional<glm::dvec3> mean() const;
  [[nodiscard]] double spread_mm() const;  ///< largest distance from the mean
  [[nodiscard]] double heldFor_s() const;
  /// What was just taken otherwise is not taken again by itself.
  void rest() { takenAt_ = mean(); }

 private:
  struct Place {
    glm::dvec3 at_mm;
    double time_s;
  };
  std::deque<Place> places_;
  std::optional<glm::dvec3> takenAt_;
};

}  // namespace ew::ui
