#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "ew/core/message.h"
#include "ew/tracking/tool_reading.h"

namespace ew {

enum class LinkState {
  off,         ///< not started, or stopped
  connecting,  ///< not there yet, or not there any more: it is tried again by itself
  connected,   ///< readings may come
  silent,      ///< connected, and nothing has come for half a second
  ended,       ///< nothing more will come: a recording at its end
};

/// A tracker as a person is told of it.
struct DeviceStatus {
  LinkState link = LinkState::off;
  Message sentence;                ///< what goes on and, where something is wrong, what to do
  std::vector<std::string> tools;  ///< that were heard of since it was started, in the order they came
  std::uint64_t readings = 0;      ///< since it was started
  std::uint64_t dropped = 0;       ///< readings that nobody took in time
  std::uint64_t refused = 0;       ///< messages, frames or numbers that could not be used
  Message lastRefusal;             ///< why the latest of them; empty: none
};

/// A source of readings on threads of its own: network, camera, recording. What it meets, it mends by itself: it goes on trying until it is
/// stopped.
class TrackerDevice {
 public:
  virtual ~TrackerDevice();  ///< stops
  /// Returns at once; does nothing while it runs.
  virtual void start() = 0;
  /// Ends its threads, within half a second; the readings that were not taken stay. May be started again.
  virtual void stop() = 0;
  /// The readings since the last call in the order they came. From any thread; each reading is given once.
  [[nodiscard]] virtual std::vector<ToolReading> take() = 0;
  [[nodiscard]] virtual DeviceStatus status() const = 0;
  /// Called on a thread of the device after readings came or the status changed; must return soon. Set before start().
  virtual void onNews(std::function<void()> callback) = 0;
};

/// What every device hands its readings over with: bounded, so that memory stays flat however fast they come and however long nobody takes
/// them. Safe from several threads.
class ReadingQueue {
 public:
  /// @param most readings that wait; the oldest go when more come
  explicit ReadingQueue(std::size_t most = 4096);
  void add(ToolReading reading);
  [[nodiscard]] std::vector<ToolReading> take();
  void setLink(LinkState link, Message sentence, double now_s = steadyNow_s());
  void refuse(Message why);
  /// As it is now; `silent` where it is connected and nothing came for `silentAfter_s`.
  [[nodiscard]] DeviceStatus status(double now_s = steadyNow_s(), double silentAfter_s = 0.5) const;
  /// Forgets counts, tools and readings, for another start.
  void begin();
  void onNews(std::function<void()> callback);

 private:
  void tell();
  std::size_t most_;
  mutable std::mutex mutex_;
  std::vector<ToolReading> waiting_;  ///< a ring while it is full: `first_` is the oldest
  std::size_t first_ = 0;
  DeviceStatus status_;
  double latest_s_ = 0.0;  ///< arrival of the latest reading, or when it was connected
  std::function<void()> news_;
};

}  // namespace ew
