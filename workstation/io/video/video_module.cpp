#include "video_module.h"
#include "why_not.h"

#include <exception>
#include <filesystem>
#include <memory>
#include <opencv2/videoio.hpp>

#include "ew/core/ending.h"

struct EwClipParts {
  int width_px = 0;
  cv::VideoWriter writer;
  cv::Mat blueGreenRed;
};

extern "C" {

__attribute__((visibility("default"))) EwClipOpen ewClipOpen;
__attribute__((visibility("default"))) EwClipAdd ewClipAdd;
__attribute__((visibility("default"))) EwClipClose ewClipClose;

EwClip* ewClipOpen(const char* file, int width_px, int height_px, double rate_hz, char* why, std::size_t room) {
  try {
    auto clip = std::make_unique<EwClip>();
    clip->width_px = width_px;
    const cv::Size size(width_px & ~1, height_px & ~1);
    const bool isAvi = ew::hasEnding(file, ".avi");
    // OpenCV writes Motion JPEG itself, without any other library.
    const int back = isAvi ? static_cast<int>(cv::CAP_OPENCV_MJPEG) : static_cast<int>(cv::CAP_ANY);
    const int code = isAvi ? cv::VideoWriter::fourcc('M', 'J', 'P', 'G') : cv::VideoWriter::fourcc('m', 'p', '4', 'v');
    if (!clip->writer.open(file, back, code, rate_hz, size, true)) return nullptr;
    clip->writer.set(cv::VIDEOWRITER_PROP_QUALITY, 95.0);
    clip->blueGreenRed.create(size, CV_8UC3);
    return clip.release();
  } catch (const std::exception& problem) {
    tell(problem.what(), why, room);
    return nullptr;
  }
}

bool ewClipAdd(EwClip* clip, const unsigned char* rgb, char* why, std::size_t room) {
  try {
    cv::Mat& out = clip->blueGreenRed;
    for (int y = 0; y < out.rows; ++y) {
      const unsigned char* in = rgb + static_cast<std::ptrdiff_t>(y) * 3 * clip->width_px;
      auto* const to = out.ptr<cv::Vec3b>(y);
      for (int x = 0; x < out.cols; ++x, in += 3) to[x] = {in[2], in[1], in[0]};
    }
    clip->writer.write(out);
    return true;
  } catch (const std::exception& problem) {
    tell(problem.what(), why, room);
    return false;
  }
}

void ewClipClose(EwClip* clip) { delete clip; }

}  // extern "C"
