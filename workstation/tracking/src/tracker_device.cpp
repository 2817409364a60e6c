#include "ew/tracking/tracker_device.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "ew/core/contract.h"

namespace ew {

double steadyNow_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

TrackerDevice::~TrackerDevice() = default;

ReadingQueue::ReadingQueue(std::size_t most) : most_(most) { EW_EXPECTS(most > 0); }

void ReadingQueue::add(ToolReading reading) {
  {
    const std::scoped_lock lock(mutex_);
    ++status_.readings;
    latest_s_ = reading.arrival_s;
    if (std::find(status_.tools.begin(), status_.tools.end(), reading.tool) == status_.tools.end()) {
      constexpr std::size_t kMostTools = 64;  // a stream of made-up names must not fill the memory
      if (status_.tools.size() < kMostTools) status_.tools.push_back(reading.tool);
    }
    if (waiting_.size() < most_) {
      waiting_.push_back(std::move(reading));
    } else {
      ++status_.dropped;
      waiting_[first_] = std::move(reading);
      first_ = (first_ + 1) % most_;
    }
  }
  tell();
}

std::vector<ToolReading> ReadingQueue::take() {
  const std::scoped_lock lock(mutex_);
  std::rotate(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(first_), waiting_.end());
  first_ = 0;
  return std::exchange(waiting_, {});
}

void ReadingQueue::setLink(LinkState link, Message sentence, double now_s) {
  {
    const std::scoped_lock lock(mutex_);
    if (link == LinkState::connected && status_.link != LinkState::connected) latest_s_ = now_s;
    status_.link = link;
    status_.sentence = std::move(sentence);
  }
  tell();
}

void ReadingQueue::refuse(Message why) {
  const std::scoped_lock lock(mutex_);
  ++status_.refused;
  status_.lastRefusal = std::move(why);
}

DeviceStatus ReadingQueue::status(double now_s, double silentAfter_s) const {
  const std::scoped_lock lock(mutex_);
  DeviceStatus status = status_;
  if (status.link == LinkState::connected && now_s - latest_s_ > silentAfter_s) status.link = LinkState::silent;
  return status;
}

void ReadingQueue::begin() {
  const std::scoped_lock lock(mutex_);
  waiting_.clear();
  first_ = 0;
  status_ = {};
}

void ReadingQueue::onNews(std::function<void()> callback) {
  const std::scoped_lock lock(mutex_);
  news_ = std::move(callback);
}

void ReadingQueue::tell() {
  std::function<void()> news;
  {
    const std::scoped_lock lock(mutex_);
    news = news_;
  }
  if (news) news();
}

}  // namespace ew
