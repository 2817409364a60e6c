#pragma once

#include "ew/assessment/compass.h"

/// Holds and targets for the tests of the compass.
namespace ew::test {

/// On the front of a trunk, the marker to the patient's right.
inline Hold frontHold(const Skin& skin) {
  Hold hold;
  hold.contact = skin.nearest({0.0, -500.0, 0.0});
  hold.press_mm = 4.0;
  return hold;
}

inline CompassTarget targetAt(const Hold& hold, const Skin& skin, const PlaneTolerance& tolerance = {}) {
  return compassTargetOf({poseOf(hold).probeToWorld, {0.0, 60.0}}, tolerance, skin);
}

}  // namespace ew::test
