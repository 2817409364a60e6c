#include "camera_pictures.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <thread>

namespace ew {
namespace {

constexpr double kLongestWait_s = 0.2;

bool isNumber(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

std::string nodeOf(const std::string& device) { return isNumber(device) ? "/dev/video" + device : device; }

cv::Mat greyOf(const cv::Mat& picture) {
  cv::Mat grey;
  if (picture.channels() == 1)
    grey = picture.clone();
  else
    cv::cvtColor(picture, grey, picture.channels() == 4 ? cv::COLOR_BGRA2GRAY : cv::COLOR_BGR2GRAY);
  return grey;
}

/// What this program has to say it says itself.
void silenceOpenCv() {
  static std::once_flag once;
  std::call_once(once, [] { cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT); });
}

class LiveCamera final : public CameraPictures {
 public:
  bool open(const CameraSettings& settings) {
    const std::string node = nodeOf(settings.device);
    if (!capture_.open(node, cv::CAP_V4L2)) return false;
    // Raw pictures of that size and rate are more than a USB 2 cable carries.
    capture_.set(cv::CAP_PROP_FOURCC, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'));
    capture_.set(cv::CAP_PROP_FRAME_WIDTH, settings.width);
    capture_.set(cv::CAP_PROP_FRAME_HEIGHT, settings.height);
    capture_.set(cv::CAP_PROP_FPS, settings.frames_hz);
    capture_.set(cv::CAP_PROP_BUFFERSIZE, 2);
    node_ = node;
    return true;
  }

  Next next(CameraPicture& picture) override {
    // A read of a camera that was pulled out would wait for ten seconds.
    std::vector<int> ready;
    if (!cv::VideoCapture::waitAny({capture_}, ready, static_cast<std::int64_t>(kLongestWait_s * 1e9)) || ready.empty())
      return ::access(node_.c_str(), F_OK) == 0 ? Next::notYet : Next::lost;
    if (!capture_.grab()) return Next::lost;
    picture.arrival_s = steadyNow_s();
    // The kernel stamps with the clock of steadyNow_s(); some drivers with another one, or not at all.
    const double stamp_s = capture_.get(cv::CAP_PROP_POS_MSEC) * 1e-3;
    const bool isSane = stamp_s > 0.0 && stamp_s <= picture.arrival_s && picture.arrival_s - stamp_s < 0.5;
    picture.stamp_s = picture.taken_s = isSane ? stamp_s : picture.arrival_s;
    cv::Mat colours;
    if (!capture_.retrieve(colours) || colours.empty()) return Next::notYet;  // half a picture; the next one may be whole
    picture.grey = greyOf(colours);
    return Next::picture;
  }

 private:
  cv::VideoCapture capture_;
  std::string node_;
};

class Film final : public CameraPictures {
 public:
  bool open(const CameraSettings& settings) {
    settings_ = settings;
    if (!capture_.open(settings.device)) return false;
    const double rate_hz = capture_.get(cv::CAP_PROP_FPS);
    rate_hz_ = std::isfinite(rate_hz) && rate_hz > 0.5 && rate_hz < 1000.0 ? rate_hz : 30.0;
    begun_s_ = steadyNow_s();
    return true;
  }

  Next next(CameraPicture& picture) override {
    if (settings_.filmSpeed > 0.0) {
      const double due_s = begun_s_ + static_cast<double>(count_) / rate_hz_ / settings_.filmSpeed;
      const double wait_s = due_s - steadyNow_s();
      if (wait_s > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(std::min(wait_s, kLongestWait_s)));
      if (wait_s > kLongestWait_s) return Next::notYet;
    }
    cv::Mat colours;
    if (!capture_.read(colours) || colours.empty()) {
      if (!settings_.filmLoops || countInRound_ == 0) return Next::over;
      countInRound_ = 0;
      capture_.release();
      if (!capture_.open(settings_.device)) return Next::lost;
      if (!capture_.read(colours) || colours.empty()) return Next::over;
    }
    picture.stamp_s = static_cast<double>(count_) / rate_hz_;
    ++count_;
    ++countInRound_;
    picture.grey = greyOf(colours);
    picture.arrival_s = picture.taken_s = steadyNow_s();
    return Next::picture;
  }

 private:
  CameraSettings settings_;
  cv::VideoCapture capture_;
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
  return say<"The camera %1 delivers no pictures; another program may be using it, or it is no camera. It is tried again every second.">(
      node);
}

}  // namespace

bool isFilm(const std::string& device) { return !isNumber(device) && !device.starts_with("/dev/"); }

std::unique_ptr<CameraPictures> openPictures(const CameraSettings& settings, Message& why) {
  silenceOpenCv();
  try {
    if (isFilm(settings.device)) {
      std::error_code ignored;
      if (!std::filesystem::exists(settings.device, ignored)) {
        why = say<"The film %1 is not there; choose another one.">(settings.device);
        return nullptr;
      }
      auto film = std::make_unique<Film>();
      if (film->open(settings)) return film;
      why = say<"%1 cannot be read as a film; choose a file with moving pictures.">(settings.device);
      return nullptr;
    }
    auto camera = std::make_unique<LiveCamera>();
    if (camera->open(settings)) return camera;
  } catch (const cv::Exception&) {
    // said below: for a person it is a camera that does not work
  }
  why = whyNoCamera(nodeOf(settings.device));
  return nullptr;
}

}  // namespace ew
