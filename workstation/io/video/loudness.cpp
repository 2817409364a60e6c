#include "loudness.h"

extern "C" {
#include <libavutil/log.h>
}
#include <tiffio.h>

#include <mutex>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/videoio.hpp>

/// Libraries below write to the error stream what this program says itself. OpenCV sets FFmpeg's loudness when it first meets a file, and
/// may set it again: a listener that says nothing is not asked for its loudness.
void silence() {
  static std::once_flag once;
  std::call_once(once, [] {
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    cv::VideoCapture().open("/nonexistent/film.mp4", cv::CAP_FFMPEG);
    av_log_set_level(AV_LOG_QUIET);
    av_log_set_callback([](void*, int, const char*, va_list) {});
    TIFFSetErrorHandler(nullptr);
    TIFFSetWarningHandler(nullptr);
  });
}
