#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ew/core/message.h"
#include "ew/tracking/rate_hand.h"
#include "ew/tracking/tracker_device.h"

namespace ew {

/// How it stands with a hand controller.
struct AxisStatus {
  LinkState link = LinkState::off;  ///< connected: a controller is there; connecting: it is looked for
  Message sentence;                 ///< what goes on and, where something is wrong, what to do
  std::string name;                 ///< of the controller, as it calls itself; empty: none
  bool operator==(const AxisStatus&) const = default;
};

/// A hand controller: axes that spring back to 0. It has a thread of its own, and finds the controller again once it is plugged in again.
class AxisDevice {
 public:
  virtual ~AxisDevice();  ///< stops
  /// Returns at once; does nothing while it runs.
  virtual void start() = 0;
  /// Ends its thread, within half a second. May be started again.
  virtual void stop() = 0;
  /// As they are now, -1..1 each; all 0 while no controller is there. Their order: spaceMouseOptions(), gameControllerOptions().
  [[nodiscard]] virtual std::vector<double> axes() const = 0;
  /// Which buttons are down.
  [[nodiscard]] virtual std::vector<bool> buttons() const = 0;
  [[nodiscard]] virtual AxisStatus status() const = 0;
  /// Called on the device's thread after axes, buttons or status changed; must return soon. Set before start().
  virtual void onNews(std::function<void()> callback) = 0;
};

/// A SpaceMouse through the program spacenavd. There is one connection to it in a program: a second device waits until the first stops.
[[nodiscard]] std::unique_ptr<AxisDevice> makeSpaceMouse();

/// The first game controller that is plugged in, through SDL 2; where it is pulled out, the next.
[[nodiscard]] std::unique_ptr<AxisDevice> makeGameController();

enum class HandControllerKind { spaceMouse, gameController };
struct HandControllerSettings {
  HandControllerKind kind = HandControllerKind::spaceMouse;
  RateHandOptions hand = spaceMouseOptions();
  bool operator==(const HandControllerSettings&) const = default;
};
[[nodiscard]] std::unique_ptr<AxisDevice> makeHandController(HandControllerKind kind);

}  // namespace ew
