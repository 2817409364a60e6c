#include "measures/compass_words.h"

#include <cmath>

namespace ew::assessment {
namespace {

Message towards(PatientSide side) {
  switch (side) {
    case PatientSide::left:
      return say<"towards the patient's left">();
    case PatientSide::right:
      return say<"towards the patient's right">();
    case PatientSide::head:
      return say<"towards the patient's head">();
    case PatientSide::feet:
      return say<"towards the patient's feet">();
    case PatientSide::front:
      return say<"towards the patient's front">();
    case PatientSide::back:
      return say<"towards the patient's back">();
  }
  return {};
}

}  // namespace

Message sentenceOf(const CompassAdvice& advice) {
  const long amount = std::lround(std::abs(advice.amount));
  switch (advice.movement) {
    case HandMovement::stay:
      return say<"You are there: hold the probe still.">();
    case HandMovement::slide:
      return say<"Slide %1 mm %2.">(amount, towards(advice.towards));
    case HandMovement::rotate:
      return advice.amount > 0.0 ? say<"Rotate clockwise by %1 degrees.">(amount) : say<"Rotate anticlockwise by %1 degrees.">(amount);
    case HandMovement::turnRound:
      return say<"The marker points the wrong way: turn the probe round.">();
    case HandMovement::tilt:
      return say<"Tilt the beam by %1 degrees %2.">(amount, towards(advice.towards));
    case HandMovement::rock:
      return say<"Rock the beam by %1 degrees %2.">(amount, towards(advice.towards));
    case HandMovement::press:
      return advice.amount > 0.0 ? say<"Press the probe in by %1 mm.">(amount) : say<"Lift the probe by %1 mm.">(amount);
    case HandMovement::none:
      return say<"This plane cannot be reached from the skin; choose another one.">();
  }
  return {};
}

}  // namespace ew::assessment
