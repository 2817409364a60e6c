#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "ew/core/pose.h"
#include "ew/tracking/hand.h"
#include "made_tools.h"

namespace ew::test {

/// What a person does with a probe besides scanning, as poses of 30 a second: slides, presses harder and softer, stands still, lifts the
/// probe, carries it over the body to another place, lays it down. What is not measured of life: tremor and a coat of gel are noise here.
class MadeHand {
 public:
  MadeHand(const Skin& skin, std::uint64_t seed, double noise_mm) : skin_(skin), dice_(seed), noise_mm_(noise_mm) {
    hold_.contact = skin.nearest({0.0, -300.0, -60.0});
  }

  [[nodiscard]] std::vector<Pose> scanFor(double seconds) {
    while (time_s_ < seconds) {
      const double what = dice_.between(0.0, 1.0);
      if (what < 0.55)
        slide(dice_.between(1.0, 6.0));
      else if (what < 0.75)
        stay(dice_.between(0.5, 5.0));
      else if (what < 0.9)
        carry();
      else
        layDown(dice_.between(2.0, 10.0));
    }
    return poses_;
  }

 private:
  static constexpr double kStep_s = 1.0 / 30.0;

  void keep(Pose pose) {
    pose.time_s = time_s_;
    pose.probeToWorld = shaken(pose.probeToWorld, dice_, noise_mm_, 0.003);
    poses_.push_back(pose);
    time_s_ += kStep_s;
  }
  void press() { hold_.press_mm = std::clamp(hold_.press_mm + dice_.normal(0.25), 0.0, 8.0); }
  void slide(double seconds) {
    const double speed_mmps = dice_.between(8.0, 50.0), heading = dice_.between(0.0, 6.28), rocking = dice_.normal(0.15);
    for (const double end_s = time_s_ + seconds; time_s_ < end_s;) {
      press();
      hold_ = turned(slid(hold_, skin_, speed_mmps * kStep_s * std::cos(heading), speed_mmps * kStep_s * std::sin(heading)), 0.0,
                     rocking * kStep_s, 0.0);
      keep(poseOf(hold_));
    }
  }
  void stay(double seconds) {
    const double tilt = dice_.normal(0.1);
    for (const double end_s = time_s_ + seconds; time_s_ < end_s;) {
      press();
      hold_ = turned(hold_, 0.0, 0.0, tilt * kStep_s);
      keep(poseOf(hold_));
    }
  }
  /// Up, over and down again, at a height of 20 to 60 mm and 100 to 300 mm a second.
  void carry() {
    const Pose from = poseOf(hold_);
    Hold there = slid(hold_, skin_, dice_.between(-150.0, 150.0), dice_.between(-150.0, 150.0));
    there.press_mm = 1.0;
    const Pose to = poseOf(there);
    const double height_mm = dice_.between(20.0, 60.0),
                 seconds =
                     std::max(0.8, glm::distance(from.probeToWorld.matrix[3], to.probeToWorld.matrix[3]) / dice_.between(100.0, 300.0));
    const glm::dvec3 up = glm::normalize(hold_.contact.outward + there.contact.outward);
    for (const double begin_s = time_s_; time_s_ < begin_s + seconds;) {
      const double share = (time_s_ - begin_s) / seconds, lifted = std::min(1.0, 4.0 * std::min(share, 1.0 - share));
      Pose pose = share < 0.5 ? from : to;
      pose.probeToWorld.matrix[3] =
          (1.0 - share) * from.probeToWorld.matrix[3] + share * to.probeToWorld.matrix[3] + glm::dvec4(height_mm * lifted * up, 0.0);
      keep(pose);
    }
    hold_ = there;
  }
  /// Away to the side, where it lies still, and back.
  void layDown(double seconds) {
    const Pose from = poseOf(hold_);
    for (const double begin_s = time_s_; time_s_ < begin_s + seconds;) {
      const double gone = std::min({1.0, (time_s_ - begin_s) / 0.8, (begin_s + seconds - time_s_) / 0.8});
      Pose pose = from;
      pose.probeToWorld.matrix[3] +=
          gone * glm::dvec4(300.0, 50.0, 0.0, 0.0) + 160.0 * gone * (1.0 - gone) * glm::dvec4(hold_.contact.outward, 0.0);
      keep(pose);
    }
  }

  const Skin& skin_;
  Dice dice_;
  double noise_mm_;
  Hold hold_;
  std::vector<Pose> poses_;
  double time_s_ = 0.0;
};

}  // namespace ew::test
