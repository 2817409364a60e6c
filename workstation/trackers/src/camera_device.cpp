#include "ew/trackers/camera_device.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <stop_token>
#include <thread>

#include "camera_frames.h"
#include "ew/core/guarded.h"
#include "ew/core/order_statistics.h"

namespace ew {
namespace {

constexpr int kPreviewWidth = 640;
constexpr std::size_t kRemembered = 31;

double medianOrZero(const std::deque<double>& values) { return values.empty() ? 0.0 : upperMedianOf(values); }

void remember(std::deque<double>& values, double value) {
  values.push_back(value);
  if (values.size() > kRemembered) values.pop_front();
}

GreyImage imageOf(const cv::Mat& grey) {
  GreyImage image(grey.cols, grey.rows);
  for (int y = 0; y < grey.rows; ++y) std::copy_n(grey.ptr(y), grey.cols, viewOf(image).row(y));
  return image;
}

/// What is to be looked for, and the tracker that does.
struct WhatToTrack {
  std::optional<CameraModel> model;
  std::vector<MarkerBody> bodies;
  CameraTrackingOptions options;
  std::uint64_t revision = 0;
};

WhatToTrack whatToTrack(std::optional<CameraModel> model, const std::optional<MarkerBody>& probe, const std::optional<MarkerBody>& board,
                        const CameraTrackingOptions& options) {
  WhatToTrack what{std::move(model), {}, options, 0};
  if (probe) what.bodies.push_back(*probe);
  if (board) what.bodies.push_back(*board);
  return what;
}

/// One thread takes images and keeps the newest alone, so that none waits behind another; a second one works on it.
class Camera final : public CameraDevice {
 public:
  explicit Camera(const CameraSettings& settings)
      : settings_(settings), what_(whatToTrack(settings.model, settings.probe, settings.board, settings.tracking)) {}
  ~Camera() override { halt(); }

  void start() override;
  void stop() override { halt(); }
  [[nodiscard]] std::vector<ToolReading> take() override { return queue_.take(); }
  [[nodiscard]] DeviceStatus status() const override;
  void onNews(std::function<void()> callback) override {
    queue_.onNews(callback);
    news_ = std::move(callback);
  }
  [[nodiscard]] CameraView view() const override;
  [[nodiscard]] GreyImage image() const override;
  void setTracking(std::optional<CameraModel> model, std::optional<MarkerBody> probe, std::optional<MarkerBody> board,
                   const CameraTrackingOptions& options) override;

 private:
  void halt();
  void captureUntil(const std::stop_token& stopped);
  void captureFrom(CameraFrames& images, const std::stop_token& stopped);
  void hand(CameraFrame image, const std::stop_token& stopped);
  void workUntil(const std::stop_token& stopped);
  void work(const CameraFrame& image);
  [[nodiscard]] CameraSight look(const CameraFrame& image);
  void prepareTracker(const WhatToTrack& what, int width, int height);
  void addReadings(const CameraFrame& image, const CameraSight& sight);
  void waitASecond(const std::stop_token& stopped);

  const CameraSettings settings_;
  ReadingQueue queue_;
  std::function<void()> news_;
  std::mutex running_;  ///< of start and stop
  std::jthread capturing_, working_;

  mutable std::mutex handover_;
  std::condition_variable_any handed_;
  std::optional<CameraFrame> newest_;
  bool isWorking_ = false;
  std::uint64_t leftOut_ = 0;
  std::deque<double> arrivals_s_;

  mutable std::mutex shown_;
  CameraView view_;
  cv::Mat whole_;
  double worked_s_ = -1e9;
  std::deque<double> processing_ms_, latency_ms_;
  Message notTracking_;  ///< why images come and no poses

  std::mutex asked_;
  WhatToTrack what_;

  // of the working thread alone
  std::optional<CameraTracker> tracker_;
  std::vector<std::string> names_;
  std::uint64_t revision_ = std::numeric_limits<std::uint64_t>::max();
  cv::Size size_;
};

void Camera::start() {
  const std::scoped_lock lock(running_);
  if (capturing_.joinable()) return;
  // OpenCV's own threads would take the processors from the image that is being formed; a frame needs half of one.
  cv::setNumThreads(1);
  queue_.begin();
  queue_.setLink(LinkState::connecting, say<"The camera is being opened.">());
  {
    const std::scoped_lock also(handover_);
    newest_.reset();
    leftOut_ = 0;
    arrivals_s_.clear();
  }
  {
    const std::scoped_lock also(shown_);
    view_ = {};
    whole_.release();
    processing_ms_.clear();
    latency_ms_.clear();
  }
  if (tracker_) tracker_->forget();
  working_ = std::jthread([this](const std::stop_token& stopped) { workUntil(stopped); });
  capturing_ = std::jthread([this](const std::stop_token& stopped) { captureUntil(stopped); });
}

void Camera::halt() {
  const std::scoped_lock lock(running_);
  if (!capturing_.joinable()) return;
  capturing_.request_stop();
  working_.request_stop();
  capturing_.join();
  working_.join();
  capturing_ = {};
  working_ = {};
  queue_.setLink(LinkState::off, say<"The camera is off.">());
}

void Camera::waitASecond(const std::stop_token& stopped) {
  std::unique_lock lock(handover_);
  handed_.wait_for(lock, stopped, std::chrono::seconds(1), [] { return false; });
}

void Camera::captureUntil(const std::stop_token& stopped) {
  while (!stopped.stop_requested()) {
    Message why;
    const auto images = openImages(settings_, why);
    if (images == nullptr) {
      queue_.setLink(LinkState::connecting, why);
      waitASecond(stopped);
      continue;
    }
    auto captured = guarded([&] { captureFrom(*images, stopped); },
                            [](const Thrown& thrown) {
                              return Error{ErrorCode::internal, say<"The camera's driver failed: %1.">(thrown.reason), {}};
                            });
    if (captured) {
      if (queue_.status().link == LinkState::ended) return;
    } else {
      queue_.setLink(LinkState::connecting, captured.error().message);
    }
    if (!stopped.stop_requested()) waitASecond(stopped);
  }
}

void Camera::captureFrom(CameraFrames& images, const std::stop_token& stopped) {
  bool isConnected = false;
  while (!stopped.stop_requested()) {
    CameraFrame image;
    switch (images.next(image)) {
      case CameraFrames::Next::notYet:
        continue;
      case CameraFrames::Next::over:
        queue_.setLink(LinkState::ended, say<"The film has come to its end.">());
        return;
      case CameraFrames::Next::lost:
        queue_.setLink(LinkState::connecting,
                       say<"The camera has stopped delivering images; check its cable. It is tried again every second.">());
        return;
      case CameraFrames::Next::image:
        break;
    }
    if (!isConnected) queue_.setLink(LinkState::connected, say<"The camera delivers images.">());
    isConnected = true;
    hand(std::move(image), stopped);
  }
}

void Camera::hand(CameraFrame image, const std::stop_token& stopped) {
  std::unique_lock lock(handover_);
  if (isFilm(settings_.device) && settings_.filmSpeed <= 0.0)  // nothing is left out
    handed_.wait(lock, stopped, [&] { return !newest_ && !isWorking_; });
  if (newest_) ++leftOut_;
  arrivals_s_.push_back(image.arrival_s);
  while (arrivals_s_.size() > 2 && image.arrival_s - arrivals_s_.front() > 1.0) arrivals_s_.pop_front();
  newest_ = std::move(image);
  handed_.notify_all();
}

void Camera::workUntil(const std::stop_token& stopped) {
  for (;;) {
    CameraFrame image;
    {
      std::unique_lock lock(handover_);
      if (!handed_.wait(lock, stopped, [&] { return newest_.has_value(); })) return;
      image = *std::move(newest_);
      newest_.reset();
      isWorking_ = true;
    }
    const auto worked =
        guarded([&] { work(image); },
                [](const Thrown& thrown) {
                  return Error{ErrorCode::internal, say<"An image of the camera could not be worked on: %1.">(thrown.reason), {}};
                });
    if (!worked) queue_.refuse(worked.error().message);
    {
      const std::scoped_lock lock(handover_);
      isWorking_ = false;
    }
    handed_.notify_all();
  }
}

void Camera::prepareTracker(const WhatToTrack& what, int width, int height) {
  revision_ = what.revision;
  size_ = {width, height};
  tracker_.reset();
  names_.clear();
  Message why;
  if (what.model && !what.bodies.empty()) {
    auto model = what.model->width == width && what.model->height == height ? Result<CameraModel>(*what.model)
                                                                            : scaledTo(*what.model, width, height);
    auto tracker = model ? CameraTracker::make(*model, what.bodies, what.options) : Result<CameraTracker>(passOn(model.error()));
    if (tracker) {
      tracker_ = *std::move(tracker);
      for (const MarkerBody& body : what.bodies) names_.push_back(body.id);
    } else {
      why = tracker.error().message;
      queue_.refuse(why);
    }
  } else if (!what.model) {
    why = say<"The camera has not been calibrated yet, so it cannot measure; calibrate it.">();
  }
  const std::scoped_lock lock(shown_);
  notTracking_ = why;
}

CameraSight Camera::look(const CameraFrame& image) {
  {
    const std::scoped_lock lock(asked_);
    if (what_.revision != revision_ || size_ != image.grey.size()) prepareTracker(what_, image.grey.cols, image.grey.rows);
  }
  if (!tracker_) return {};
  return tracker_->track({image.grey.data, image.grey.cols, image.grey.rows, static_cast<std::ptrdiff_t>(image.grey.step)}, image.stamp_s);
}

void Camera::addReadings(const CameraFrame& image, const CameraSight& sight) {
  for (std::size_t n = 0; n < sight.bodies.size(); ++n) {
    const BodySight& body = sight.bodies[n];
    ToolReading reading;
    reading.tool = names_[n];
    reading.toolToTracker = renamed<frame::Tracker, frame::Tool>(body.bodyToCamera);
    reading.state = body.state;
    reading.device_s = image.stamp_s;
    reading.arrival_s = image.arrival_s;
    reading.spread_mm = body.spread_mm;
    reading.spread_rad = body.spread_rad;
    queue_.add(std::move(reading));
  }
}

void Camera::work(const CameraFrame& image) {
  const double begun_s = steadyNow_s();
  CameraSight sight = look(image);
  addReadings(image, sight);
  const double done_s = steadyNow_s();
  const double scale = std::min(1.0, static_cast<double>(kPreviewWidth) / image.grey.cols);
  cv::Mat preview;
  cv::resize(image.grey, preview, cv::Size(), scale, scale, cv::INTER_AREA);
  std::uint64_t leftOut = 0;
  double frames_hz = 0.0;
  {
    const std::scoped_lock lock(handover_);
    leftOut = leftOut_;
    if (arrivals_s_.size() > 1)
      frames_hz = static_cast<double>(arrivals_s_.size() - 1) / std::max(1e-3, arrivals_s_.back() - arrivals_s_.front());
  }
  {
    const std::scoped_lock lock(shown_);
    remember(processing_ms_, 1e3 * (done_s - begun_s));
    remember(latency_ms_, 1e3 * (done_s - image.taken_s));
    view_.preview = imageOf(preview);
    view_.scale = scale;
    ++view_.number;
    view_.names = names_;
    view_.light = cv::mean(preview)[0];
    view_.blur_px = 0.0;
    for (const BodySight& body : sight.bodies) view_.blur_px = std::max(view_.blur_px, body.blur_px);
    view_.sight = std::move(sight);
    view_.frames_hz = frames_hz;
    view_.processing_ms = medianOrZero(processing_ms_);
    view_.latency_ms = medianOrZero(latency_ms_);
    view_.leftOut = leftOut;
    view_.width = image.grey.cols;
    view_.height = image.grey.rows;
    whole_ = image.grey;
    worked_s_ = done_s;
  }
  if (!tracker_ && news_) news_();  // readings say it themselves
}

DeviceStatus Camera::status() const {
  DeviceStatus status = queue_.status();
  const std::scoped_lock lock(shown_);
  if (status.link == LinkState::connected || status.link == LinkState::silent) {
    if (!notTracking_.empty()) status.sentence = notTracking_;
    // Without a model there are images and no readings.
    if (status.link == LinkState::silent && steadyNow_s() - worked_s_ < 0.5) status.link = LinkState::connected;
  }
  return status;
}

CameraView Camera::view() const {
  const std::scoped_lock lock(shown_);
  return view_;
}

GreyImage Camera::image() const {
  cv::Mat latest;
  {
    const std::scoped_lock lock(shown_);
    latest = whole_;
  }
  return latest.empty() ? GreyImage{} : imageOf(latest);
}

void Camera::setTracking(std::optional<CameraModel> model, std::optional<MarkerBody> probe, std::optional<MarkerBody> board,
                         const CameraTrackingOptions& options) {
  const std::scoped_lock lock(asked_);
  const std::uint64_t revision = what_.revision + 1;
  what_ = whatToTrack(std::move(model), probe, board, options);
  what_.revision = revision;
}

}  // namespace

std::unique_ptr<CameraDevice> makeCamera(const CameraSettings& settings) { return std::make_unique<Camera>(settings); }

}  // namespace ew
