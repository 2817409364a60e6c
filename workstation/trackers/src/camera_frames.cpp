#include "camera_frames.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <thread>
#include <utility>

#include "ew/io/live_video.h"

namespace ew {
namespace {

constexpr double kLongestWait_s = 0.2;

bool isNumber(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

std::string nodeOf(const std::string& device) { return isNumber(device) ? "/dev/video" + device : device; }

cv::Mat greyOf(const LiveVideo::DisplayImage& image) {
  cv::Mat grey(image.grey.height, image.grey.width, CV_8U);
  for (int y = 0; y < grey.rows; ++y) std::copy_n(image.grey.row(y), grey.cols, grey.ptr(y));
  return grey;
}

class LiveCamera final : public CameraFrames {
 public:
  explicit LiveCamera(std::unique_ptr<LiveVideo> video) : video_(std::move(video)) {}

  Next next(CameraFrame& image) override {
    LiveVideo::DisplayImage got;
    const LiveVideo::Next came = video_->next(kLongestWait_s, got);
    if (came != LiveVideo::Next::image) return came == LiveVideo::Next::gone ? Next::lost : Next::notYet;
    image.arrival_s = got.arrival_s;
    // The kernel stamps with the clock of steadyNow_s(); some drivers with another one, or not at all.
    const bool isSane = got.stamp_s > 0.0 && got.stamp_s <= image.arrival_s && image.arrival_s - got.stamp_s < 0.5;
    image.stamp_s = image.taken_s = isSane ? got.stamp_s : image.arrival_s;
    image.grey = greyOf(got);
    return Next::image;
  }

 private:
  std::unique_ptr<LiveVideo> video_;
};

class Film final : public CameraFrames {
 public:
  Film(std::unique_ptr<LiveVideo> video, const CameraSettings& settings)
      : settings_(settings),
        video_(std::move(video)),
        rate_hz_(video_->rate_hz() > 0.0 ? video_->rate_hz() : 30.0),
        begun_s_(steadyNow_s()) {}

  Next next(CameraFrame& image) override {
    if (settings_.filmSpeed > 0.0) {
      const double due_s = begun_s_ + static_cast<double>(count_) / rate_hz_ / settings_.filmSpeed;
      const double wait_s = due_s - steadyNow_s();
      if (wait_s > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(std::min(wait_s, kLongestWait_s)));
      if (wait_s > kLongestWait_s) return Next::notYet;
    }
    LiveVideo::DisplayImage got;
    if (video_->next(0.0, got) != LiveVideo::Next::image) {
      if (!settings_.filmLoops || countInRound_ == 0) return Next::over;
      countInRound_ = 0;
      auto again = LiveVideo::open({.file = settings_.device, .isFilm = true});
      if (!again || !*again) return Next::lost;
      video_ = std::move(*again);
      if (video_->next(0.0, got) != LiveVideo::Next::image) return Next::over;
    }
    image.stamp_s = static_cast<double>(count_) / rate_hz_;
    ++count_;
    ++countInRound_;
    image.grey = greyOf(got);
    image.arrival_s = image.taken_s = steadyNow_s();
    return Next::image;
  }

 private:
  CameraSettings settings_;
  std::unique_ptr<LiveVideo> video_;
  double rate_hz_ = 30.0, begun_s_ = 0.0;
  std::int64_t count_ = 0, countInRound_ = 0;
};

Message whyNoCamera(const std::string& node) {
  const int opened = ::open(node.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  const int problem = opened < 0 ? errno : 0;
  if (opened >= 0) ::close(opened);
  switch (problem) {
    case ENOENT:
    case ENODEV:
    case ENXIO:
      return say<"There is no camera at %1; plug it in, or choose another one. It is looked for again every second.">(node);
    case EACCES:
    case EPERM:
      return say<
          "The camera %1 may not be used by this user; an administrator can add the user to the group that owns it, usually “video”.">(
          node);
    case EBUSY:
      return say<"The camera %1 is used by another program; close that program. It is tried again every second.">(node);
    default:
      break;
  }
  return say<"The camera %1 delivers no images; another program may be using it, or it is no camera. It is tried again every second.">(
      node);
}

}  // namespace

bool isFilm(const std::string& device) { return !isNumber(device) && !device.starts_with("/dev/"); }

std::unique_ptr<CameraFrames> openImages(const CameraSettings& settings, Message& why) {
  const bool film = isFilm(settings.device);
  std::error_code ignored;
  if (film && !std::filesystem::exists(settings.device, ignored)) {
    why = say<"The film %1 is not there; choose another one.">(settings.device);
    return nullptr;
  }
  auto video = LiveVideo::open({.file = film ? settings.device : nodeOf(settings.device),
                                .isFilm = film,
                                .width_px = settings.width,
                                .height_px = settings.height,
                                .rate_hz = settings.frames_hz});
  if (!video) {
    why = video.error().message;
    return nullptr;
  }
  if (*video) {
    if (film) return std::make_unique<Film>(std::move(*video), settings);
    return std::make_unique<LiveCamera>(std::move(*video));
  }
  why =
      film ? say<"%1 cannot be read as a film; choose a file with moving images.">(settings.device) : whyNoCamera(nodeOf(settings.device));
  return nullptr;
}

}  // namespace ew
