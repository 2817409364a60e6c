#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "ew/controls/event.h"
#include "ew/core/result.h"

namespace ew::controls {

struct Device {
  enum class Bus { midi, hid };
  Bus bus = Bus::midi;
  std::string name;  ///< the same when it is plugged in again
  std::string path;  ///< how the backend finds it now
  int vendor = 0;    ///< USB, of HID devices
  int product = 0;
  bool operator==(const Device&) const = default;
};

/// A device that is being listened to, until it is destroyed. Destroying waits for a running `take`.
class Connection {
 public:
  virtual ~Connection();
  /// Gone: it was unplugged.
  [[nodiscard]] virtual bool isLost() const = 0;
};

/// A way to devices: MIDI through RtMidi, HID through hidapi, or made ones of a test. Called by one thread at a time.
class Backend {
 public:
  using Take = std::function<void(std::span<const std::uint8_t>)>;
  virtual ~Backend();
  /// What is plugged in. @error unsupported, notFound: why there can be none
  [[nodiscard]] virtual Result<std::vector<Device>> devices() = 0;
  /// @param take gets what the device sends, a message or a report at a time, on a thread of the backend's
  /// @error notReadable (permissions, taken by another program)
  [[nodiscard]] virtual Result<std::unique_ptr<Connection>> open(const Device& device, Take take) = 0;
  /// Of a HID device: whether its reports begin with their number.
  [[nodiscard]] virtual bool hasNumberedReports(const Device& device) const;
};

/// Those this program was built with; a bus it was built without gives its reason as the error of devices().
[[nodiscard]] std::vector<std::unique_ptr<Backend>> systemBackends();

/// Listens to devices on threads of its own: looks for them every two seconds, opens those that are wanted, and opens them again once they
/// are plugged in again.
class Hub {
 public:
  /// What there is, for a person.
  struct State {
    std::vector<Device> devices;
    std::vector<Error> problems;  ///< a bus that cannot be used, a device that cannot be opened
    bool operator==(const State&) const = default;
  };
  /// @param told called on any thread when there are events or another state; it must not wait for the thread that destroys the hub
  Hub(std::vector<std::unique_ptr<Backend>> backends, std::function<void()> told);
  ~Hub();
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;

  /// Which devices are listened to: these, or all when `all`; nothing wanted: nothing runs and nothing is looked for.
  void want(std::set<std::string> names, bool all);
  [[nodiscard]] std::vector<ControlEvent> takeEvents();
  [[nodiscard]] State state() const;
  /// Looks for devices at once and returns when that is done (tests).
  void lookNow();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace ew::controls
