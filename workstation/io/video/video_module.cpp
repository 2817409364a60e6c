#include "films/video_module.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <opencv2/videoio.hpp>

#include "clip_parts.h"
#include "ew/core/ending.h"
#include "loudness.h"
#include "why_not.h"

namespace {

/// Motion JPEG, which OpenCV writes itself, without any other library. Of even size, as openMp4.
class Avi final : public EwClipParts {
 public:
  Avi(int width_px, int height_px) : width_px_(width_px), height_px_(height_px) {}
  bool open(const char* file, double rate_hz) {
    file_ = file;
    const cv::Size size((width_px_ + 1) & ~1, (height_px_ + 1) & ~1);
    if (!writer_.open(file, cv::CAP_OPENCV_MJPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), rate_hz, size, true)) return false;
    writer_.set(cv::VIDEOWRITER_PROP_QUALITY, 95.0);
    blueGreenRed_.create(size, CV_8UC3);
    return true;
  }
  bool add(const unsigned char* rgb, std::string&) override {
    cv::Mat& out = blueGreenRed_;
    for (int y = 0; y < out.rows; ++y) {
      const unsigned char* in = rgb + static_cast<std::ptrdiff_t>(std::min(y, height_px_ - 1)) * 3 * width_px_;
      auto* const to = out.ptr<cv::Vec3b>(y);
      for (int x = 0; x < width_px_; ++x, in += 3) to[x] = {in[2], in[1], in[0]};
      if (width_px_ < out.cols) to[width_px_] = to[width_px_ - 1];
    }
    writer_.write(out);
    return true;
  }
  /// OpenCV tells nobody that it could not write. The length in the file's beginning comes last, and not at all after something failed.
  bool finish(std::string&) override {
    writer_.release();
    constexpr std::uintmax_t kBeforeLength_bytes = 8;
    std::array<unsigned char, kBeforeLength_bytes> head{};
    std::ifstream(file_, std::ios::binary).read(reinterpret_cast<char*>(head.data()), head.size());
    std::uintmax_t length_bytes = 0;
    for (std::size_t n = head.size(); n-- > 4;) length_bytes = length_bytes << 8 | head[n];
    std::error_code ignored;
    return length_bytes > 0 && std::filesystem::file_size(file_, ignored) == kBeforeLength_bytes + length_bytes;
  }

 private:
  std::filesystem::path file_;
  int width_px_, height_px_;
  cv::VideoWriter writer_;
  cv::Mat blueGreenRed_;
};

std::unique_ptr<EwClipParts> openAvi(const char* file, int width_px, int height_px, double rate_hz) {
  auto clip = std::make_unique<Avi>(width_px, height_px);
  if (!clip->open(file, rate_hz)) return nullptr;
  return clip;
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) EwClipOpen ewClipOpen;
__attribute__((visibility("default"))) EwClipAdd ewClipAdd;
__attribute__((visibility("default"))) EwClipFinish ewClipFinish;
__attribute__((visibility("default"))) EwClipClose ewClipClose;

EwClip* ewClipOpen(const char* file, int width_px, int height_px, double rate_hz, char* why, std::size_t room) {
  try {
    silence();
    std::string reason;
    auto clip =
        ew::hasEnding(file, ".avi") ? openAvi(file, width_px, height_px, rate_hz) : openMp4(file, width_px, height_px, rate_hz, reason);
    if (!clip && !reason.empty()) tell(reason.c_str(), why, room);
    return clip.release();
  } catch (const std::exception& problem) {
    tell(problem.what(), why, room);
    return nullptr;
  }
}

bool ewClipAdd(EwClip* clip, const unsigned char* rgb, char* why, std::size_t room) {
  try {
    std::string reason;
    const bool isAdded = clip->add(rgb, reason);
    if (!isAdded && !reason.empty()) tell(reason.c_str(), why, room);
    return isAdded;
  } catch (const std::exception& problem) {
    tell(problem.what(), why, room);
    return false;
  }
}

bool ewClipFinish(EwClip* clip, char* why, std::size_t room) {
  try {
    std::string reason;
    const bool isWhole = clip->finish(reason);
    if (!isWhole && !reason.empty()) tell(reason.c_str(), why, room);
    return isWhole;
  } catch (const std::exception& problem) {
    tell(problem.what(), why, room);
    return false;
  }
}

void ewClipClose(EwClip* clip) { delete clip; }

}  // extern "C"
