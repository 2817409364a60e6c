#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ew/assessment/hand_path.h"
#include "ew/assessment/random_numbers.h"
#include "ew/scanning/events.h"
#include "ew/simulated_people/skin_distance.h"
#include "ew/simulated_people/trainee_habits.h"

namespace ew::assessment {

/// One seed for a part of something that has a seed.
[[nodiscard]] inline std::uint64_t seedOf(std::uint64_t seed, std::uint64_t part) {
  RandomNumbers whole(seed);
  return RandomNumbers(whole.bits() ^ (0x9E3779B97F4A7C15ULL * (part + 1))).bits();
}

/// A random motion within a band of frequencies, standard deviation 1: a sum of waves, one in each twelfth of the band, so that it is the
/// same at whatever moments one looks.
class BandNoise {
 public:
  BandNoise(RandomNumbers& random, double lowest_hz, double highest_hz);
  [[nodiscard]] double at(double time_s) const;

 private:
  static constexpr int kWaves = 12;
  std::array<double, kWaves> radPerS_{};
  std::array<double, kWaves> phase_rad_{};
};

/// From one hold to another: over the skin, by places in between where no straight way leads, through the air where none does.
class Route {
 public:
  Route(const Hold& from, const Hold& to, const Skin& skin);
  /// @param share of the way, 0..1
  [[nodiscard]] Pose at(double share, const Skin& skin) const;
  [[nodiscard]] double length_mm() const { return length_mm_; }
  /// As HandPath::turn_rad; of several legs the sum of their angles about no axis in particular.
  [[nodiscard]] const glm::dvec3& turn_rad() const { return turn_rad_; }

 private:
  struct Leg {
    Hold from, to;
    std::optional<HandPath> path;  ///< nothing: through the air
    double length_mm = 0.0;
  };
  void add(const Hold& from, const Hold& to, const Skin& skin, int mostStops);
  std::vector<Leg> legs_;
  double length_mm_ = 0.0;
  glm::dvec3 turn_rad_{0.0};
};

/// What a hand means to do in a step: movements of least jerk, rests, and turns of knobs on the scan's clock.
class HandPlan {
 public:
  HandPlan(const Hold& from, double begin_s) : begin_s_(begin_s), end_s_(begin_s), now_(from) {}
  void move(std::shared_ptr<const Route> route, const Hold& to, double seconds);
  void rest(double seconds);
  void set(double time_s, const Probe& probe, const Knobs& knobs) { settings_.push_back({time_s, probe, knobs}); }

  struct Part {
    double begin_s = 0.0, end_s = 0.0;
    std::shared_ptr<const Route> route;  ///< null: rests
    Pose still;
  };
  struct Setting {
    double time_s = 0.0;
    Probe probe;
    Knobs knobs;
  };
  [[nodiscard]] const Hold& now() const { return now_; }
  [[nodiscard]] double begin_s() const { return begin_s_; }
  [[nodiscard]] double end_s() const { return end_s_; }
  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }
  [[nodiscard]] const std::vector<Setting>& settings() const { return settings_; }

 private:
  double begin_s_, end_s_;
  Hold now_;
  std::vector<Part> parts_;
  std::vector<Setting> settings_;  ///< by rising time
};

/// What a hand does without meaning to: tremor, wobble, pressure that drifts.
struct HandNoise {
  explicit HandNoise(RandomNumbers& random);
  std::array<BandNoise, 5> tremor;  ///< x, z; about x, y, z
  std::array<BandNoise, 2> wobble;  ///< x, z
  BandNoise press;
};

/// When the probe is off the skin: less than half of its face touches.
class Liftings {
 public:
  /// @param share of the time between both moments, 0..0.5
  Liftings(double share, double begin_s, double end_s, RandomNumbers& random);
  /// Of the height at which contact is lost: 0 on the skin, above 1 contact is lost, at most 2.
  [[nodiscard]] double at(double time_s) const;

 private:
  double each_s_ = 0.0;  ///< without contact
  double rise_s_ = 0.0;
  std::vector<double> begins_s_;
};

/// The frames of a plan at an even rate, as the window would make them.
class Filming {
 public:
  Filming(const Skin& skin, const SkinDistance& distance, double rate_hz, const HandNoise& noise)
      : skin_(skin), distance_(distance), rate_hz_(rate_hz), noise_(noise) {}
  /// @param state probe, knobs, scene and number of the images; afterwards as of the last image
  /// @param until_s no frame from there on
  void film(const HandPlan& plan, const TraineeHabits& habits, const Liftings& liftings, double until_s, ScanState& state, ScanLog& log,
            const std::function<bool()>& stopped = {}) const;

 private:
  [[nodiscard]] Pose disturbed(const Pose& meant, double speed_mmPerS, double time_s, const TraineeHabits& habits) const;
  [[nodiscard]] Pose lifted(const Probe& probe, const Pose& pose, double lifting) const;

  const Skin& skin_;
  const SkinDistance& distance_;
  double rate_hz_;
  const HandNoise& noise_;
};

}  // namespace ew::assessment
