#pragma once

#include <algorithm>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

#include "ew/tracking/tracker_device.h"

namespace ew::test {

/// A tracker that reads what a test says, when it says so. Safe from several threads, as devices are.
class ScriptedTracker final : public TrackerDevice {
 public:
  void start() override { setLink(LinkState::connected); }
  void stop() override { setLink(LinkState::off); }
  [[nodiscard]] std::vector<ToolReading> take() override {
    const std::lock_guard lock(mutex_);
    return std::exchange(waiting_, {});
  }
  [[nodiscard]] DeviceStatus status() const override {
    const std::lock_guard lock(mutex_);
    return status_;
  }
  void onNews(std::function<void()> callback) override { news_ = std::move(callback); }

  void setLink(LinkState link, Message sentence = {}) {
    {
      const std::lock_guard lock(mutex_);
      status_.link = link;
      status_.sentence = std::move(sentence);
    }
    if (news_) news_();
  }
  void read(ToolReading reading) {
    {
      const std::lock_guard lock(mutex_);
      if (status_.tools.empty()) status_.tools.push_back(reading.tool);
      ++status_.readings;
      waiting_.push_back(std::move(reading));
    }
    if (news_) news_();
  }

 private:
  mutable std::mutex mutex_;
  std::vector<ToolReading> waiting_;
  DeviceStatus status_;
  std::function<void()> news_;
};

}  // namespace ew::test
