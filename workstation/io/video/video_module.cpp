#include "video_module.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <memory>
#include <opencv2/videoio.hpp>

#include "ew/core/ending.h"
#include "loudness.h"
#include "why_not.h"

struct EwClipParts {
  int width_px = 0, height_px = 0;
  cv::VideoWriter writer;
  cv::Mat blueGreenRed;
};

extern "C" {

__attribute__((visibility("default"))) EwClipOpen ewClipOpen;
__attribute__((visibility("default"))) EwClipAdd ewClipAdd;
__attribute__((visibility("default"))) EwClipClose ewClipClose;

EwClip* ewClipOpen(const char* file, int width_px, int height_px, double rate_hz, char* why, std::size_t room) {
  try {
    silence();
    auto clip = std::make_unique<EwClip>();
    clip->width_px = width_px;
    clip->height_px = height_px;
    const cv::Size size((width_px + 1) & ~1, (height_px + 1) & ~1);  // players ask for even ones
    const bool isAvi = ew::hasEnding(file, ".avi");
    const auto begin = [&](cv::VideoCaptureAPIs back, int code) { return clip->writer.open(file, back, code, rate_hz, size, true); };
    // OpenCV writes Motion JPEG itself, without any other library. Browsers play H.264, but not every build of FFmpeg writes it.
    const bool isBegun = isAvi ? begin(cv::CAP_OPENCV_MJPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'))
                               : begin(cv::CAP_FFMPEG, cv::VideoWriter::fourcc('a', 'v', 'c', '1')) ||
                                     begin(cv::CAP_ANY, cv::VideoWriter::fourcc('m', 'p', '4', 'v'));
    if (!isBegun) return nullptr;
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
      // Beyond an odd size the last row and column come once more: black there would spread into the picture.
      const unsigned char* in = rgb + static_cast<std::ptrdiff_t>(std::min(y, clip->height_px - 1)) * 3 * clip->width_px;
      auto* const to = out.ptr<cv::Vec3b>(y);
      for (int x = 0; x < clip->width_px; ++x, in += 3) to[x] = {in[2], in[1], in[0]};
      if (clip->width_px < out.cols) to[clip->width_px] = to[clip->width_px - 1];
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
