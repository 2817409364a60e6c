#include "loudness.h"

#include <dlfcn.h>
#include <link.h>
#include <tiffio.h>

#include <cstring>
#include <mutex>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/videoio.hpp>

namespace {

using SetLoudness = void(int);

/// FFmpeg's own switch. This module is loaded with names of its own, so the library that has it is looked for among those that are there.
SetLoudness* loudnessOfFfmpeg() {
  SetLoudness* found = nullptr;
  dl_iterate_phdr(
      [](dl_phdr_info* library, std::size_t, void* result) {
        if (std::strstr(library->dlpi_name, "libavutil") == nullptr) return 0;
        void* const there = dlopen(library->dlpi_name, RTLD_LAZY | RTLD_NOLOAD);
        if (there == nullptr) return 0;
        *static_cast<SetLoudness**>(result) = reinterpret_cast<SetLoudness*>(dlsym(there, "av_log_set_level"));
        dlclose(there);
        return 1;
      },
      &found);
  return found;
}

}  // namespace

/// Libraries below write to the error stream what this program says itself. OpenCV sets FFmpeg's loudness when it first meets a file.
void silence() {
  static std::once_flag once;
  std::call_once(once, [] {
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    cv::VideoCapture().open("/nonexistent/film.mp4", cv::CAP_FFMPEG);
    if (auto* const set = loudnessOfFfmpeg()) set(-8);  // AV_LOG_QUIET
    TIFFSetErrorHandler(nullptr);
    TIFFSetWarningHandler(nullptr);
  });
}
