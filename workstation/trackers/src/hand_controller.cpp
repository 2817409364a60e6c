#include "ew/trackers/hand_controller.h"

namespace ew {

AxisDevice::~AxisDevice() = default;

std::unique_ptr<AxisDevice> makeHandController(HandControllerKind kind) {
  return kind == HandControllerKind::spaceMouse ? makeSpaceMouse() : makeGameController();
}

}  // namespace ew
