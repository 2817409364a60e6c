#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "ew/trackers/hand_controller.h"

namespace ew {

/// What hand controllers share: a thread, and the axes, buttons and status it hands over.
class AxisDeviceThread : public AxisDevice {
 public:
  void start() override {
    if (thread_.joinable()) return;
    ends_ = false;
    thread_ = std::thread([this] { run(); });
  }
  void stop() override {
    {
      const std::scoped_lock lock(mutex_);
      ends_ = true;
    }
    changed_.notify_all();
    wake();
    if (!thread_.joinable()) return;
    thread_.join();
    rest({});
  }
  std::vector<double> axes() const override {
    const std::scoped_lock lock(mutex_);
    return axes_;
  }
  std::vector<bool> buttons() const override {
    const std::scoped_lock lock(mutex_);
    return buttons_;
  }
  AxisStatus status() const override {
    const std::scoped_lock lock(mutex_);
    return status_;
  }
  void onNews(std::function<void()> callback) override { news_ = std::move(callback); }

 protected:
  static constexpr std::size_t kAxes = 6;

  /// Until ends().
  virtual void run() = 0;
  /// Gets the thread out of whatever else than pause() it waits for.
  virtual void wake() {}

  [[nodiscard]] bool ends() const { return ends_; }
  void pause(double length_s) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, std::chrono::duration<double>(length_s), [this] { return ends_.load(); });
  }
  void put(std::vector<double> axes, std::vector<bool> buttons) {
    {
      const std::scoped_lock lock(mutex_);
      if (axes == axes_ && buttons == buttons_) return;
      axes_ = std::move(axes);
      buttons_ = std::move(buttons);
    }
    if (news_) news_();
  }
  void putStatus(AxisStatus status) {
    {
      const std::scoped_lock lock(mutex_);
      if (status == status_) return;
      status_ = std::move(status);
    }
    if (news_) news_();
  }
  /// Nobody pushes a controller that is not there.
  void rest(AxisStatus status) {
    put(std::vector<double>(kAxes, 0.0), {});
    putStatus(std::move(status));
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<bool> ends_ = false;
  std::vector<double> axes_ = std::vector<double>(kAxes, 0.0);
  std::vector<bool> buttons_;
  AxisStatus status_;
  std::function<void()> news_;
  std::thread thread_;
};

}  // namespace ew
