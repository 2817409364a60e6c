#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <exception>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <string>
#include <vector>

#include "films/video_module.h"
#include "loudness.h"

struct EwLiveParts {
  std::string file;
  bool isFilm = false;
  cv::VideoCapture in;
  cv::Mat coloured, grey;
};

namespace {

bool openCamera(EwLive& live, int width_px, int height_px, double rate_hz) {
  if (!live.in.open(live.file, cv::CAP_V4L2)) return false;
  // Raw images of that size and rate are more than a USB 2 cable carries.
  live.in.set(cv::CAP_PROP_FOURCC, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'));
  live.in.set(cv::CAP_PROP_FRAME_WIDTH, width_px);
  live.in.set(cv::CAP_PROP_FRAME_HEIGHT, height_px);
  live.in.set(cv::CAP_PROP_FPS, rate_hz);
  live.in.set(cv::CAP_PROP_BUFFERSIZE, 2);
  return true;
}

void makeGrey(EwLive& live) {
  switch (live.coloured.channels()) {
    case 1:
      live.coloured.copyTo(live.grey);
      break;
    case 4:
      cv::cvtColor(live.coloured, live.grey, cv::COLOR_BGRA2GRAY);
      break;
    default:
      cv::cvtColor(live.coloured, live.grey, cv::COLOR_BGR2GRAY);
  }
}

int next(EwLive& live, double wait_s, EwLiveImage& image) {
  if (!live.isFilm) {
    // A read of a camera that was pulled out would wait for ten seconds.
    std::vector<int> ready;
    if (!cv::VideoCapture::waitAny({live.in}, ready, static_cast<std::int64_t>(wait_s * 1e9)) || ready.empty())
      return ::access(live.file.c_str(), F_OK) == 0 ? 0 : -1;
  }
  if (!live.in.grab()) return -1;
  image.arrival_s = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  image.stamp_s = live.in.get(cv::CAP_PROP_POS_MSEC) * 1e-3;
  // Half an image of a camera is no reason to give up: the next one may be whole.
  if (!live.in.retrieve(live.coloured) || live.coloured.empty() || live.coloured.depth() != CV_8U) return live.isFilm ? -1 : 0;
  makeGrey(live);
  image.grey = live.grey.data;
  image.width_px = live.grey.cols;
  image.height_px = live.grey.rows;
  image.stride_bytes = static_cast<std::ptrdiff_t>(live.grey.step[0]);
  return 1;
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) EwLiveOpen ewLiveOpen;
__attribute__((visibility("default"))) EwLiveNext ewLiveNext;
__attribute__((visibility("default"))) EwLiveClose ewLiveClose;

EwLive* ewLiveOpen(const char* file, int isFilm, int width_px, int height_px, double* rate_hz) {
  silence();
  try {
    auto live = std::make_unique<EwLive>();
    live->file = file;
    live->isFilm = isFilm != 0;
    if (live->isFilm ? !live->in.open(live->file) : !openCamera(*live, width_px, height_px, *rate_hz)) return nullptr;
    const double told_hz = live->in.get(cv::CAP_PROP_FPS);
    *rate_hz = std::isfinite(told_hz) && told_hz > 0.5 && told_hz < 1000.0 ? told_hz : 0.0;
    return live.release();
  } catch (const std::exception&) {
    return nullptr;
  }
}

int ewLiveNext(EwLive* live, double wait_s, EwLiveImage* image) {
  try {
    return next(*live, wait_s, *image);
  } catch (const std::exception&) {
    return -1;
  }
}

void ewLiveClose(EwLive* live) { delete live; }

}  // extern "C"
