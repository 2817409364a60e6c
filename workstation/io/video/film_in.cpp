#include <tiffio.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <memory>
#include <opencv2/videoio.hpp>
#include <string>
#include <vector>

#include "loudness.h"
#include "video_module.h"
#include "why_not.h"

struct EwFilmParts {
  EwFilmParts() = default;
  EwFilmParts(const EwFilmParts&) = delete;
  EwFilmParts& operator=(const EwFilmParts&) = delete;
  virtual ~EwFilmParts() = default;
  virtual int next(unsigned char* rgb, double& time_s) = 0;
  EwFilmFacts facts{};
};

namespace {

class Video final : public EwFilmParts {
 public:
  bool open(const char* file) {
    // FFmpeg first; OpenCV reads Motion JPEG itself where FFmpeg is not there.
    if (!in_.open(file, cv::CAP_FFMPEG) && !in_.open(file, cv::CAP_OPENCV_MJPEG)) return false;
    facts.width_px = static_cast<int>(in_.get(cv::CAP_PROP_FRAME_WIDTH));
    facts.height_px = static_cast<int>(in_.get(cv::CAP_PROP_FRAME_HEIGHT));
    const double frames = in_.get(cv::CAP_PROP_FRAME_COUNT), rate_hz = in_.get(cv::CAP_PROP_FPS);
    facts.frames = std::isfinite(frames) && frames > 0.0 && frames < 1e9 ? frames : 0.0;
    facts.rate_hz = std::isfinite(rate_hz) && rate_hz > 0.01 && rate_hz < 10000.0 ? rate_hz : 0.0;
    return facts.width_px > 0 && facts.height_px > 0;
  }
  int next(unsigned char* rgb, double& time_s) override {
    if (!in_.read(frame_)) return 0;
    if (frame_.cols != facts.width_px || frame_.rows != facts.height_px) return -2;
    const int channels = frame_.channels();
    if (frame_.depth() != CV_8U || (channels != 3 && channels != 1)) return -1;
    for (int y = 0; y < frame_.rows; ++y) {
      const unsigned char* from = frame_.ptr(y);
      for (int x = 0; x < frame_.cols; ++x, from += channels, rgb += 3) {
        rgb[0] = from[channels - 1];
        rgb[1] = from[channels / 2];
        rgb[2] = from[0];
      }
    }
    time_s = in_.get(cv::CAP_PROP_POS_MSEC) * 0.001;
    return 1;
  }

 private:
  cv::VideoCapture in_;
  cv::Mat frame_;
};

class Pages final : public EwFilmParts {
 public:
  ~Pages() override {
    if (in_ != nullptr) TIFFClose(in_);
  }
  bool open(const char* file, std::string& why) {
    in_ = TIFFOpen(file, "rm");
    if (in_ == nullptr) return false;
    if (!size(facts.width_px, facts.height_px, why)) return false;
    TIFF* const counted = TIFFOpen(file, "rm");
    if (counted != nullptr) {
      facts.frames = TIFFNumberOfDirectories(counted);
      TIFFClose(counted);
    }
    return true;
  }
  int next(unsigned char* rgb, double& time_s) override {
    if (begun_ && TIFFReadDirectory(in_) == 0) return 0;
    begun_ = true;
    int width = 0, height = 0;
    std::string why;
    if (!size(width, height, why)) return -1;
    if (width != facts.width_px || height != facts.height_px) return -2;
    const auto w = static_cast<std::uint32_t>(width), h = static_cast<std::uint32_t>(height);
    pixels_.resize(static_cast<std::size_t>(w) * h);
    if (TIFFReadRGBAImageOriented(in_, w, h, pixels_.data(), ORIENTATION_TOPLEFT, 1) == 0) return -1;
    for (const std::uint32_t pixel : pixels_) {
      *rgb++ = static_cast<unsigned char>(TIFFGetR(pixel));
      *rgb++ = static_cast<unsigned char>(TIFFGetG(pixel));
      *rgb++ = static_cast<unsigned char>(TIFFGetB(pixel));
    }
    time_s = -1.0;
    return 1;
  }

 private:
  bool size(int& width, int& height, std::string& why) {
    std::uint32_t w = 0, h = 0;
    if (TIFFGetField(in_, TIFFTAG_IMAGEWIDTH, &w) == 0 || TIFFGetField(in_, TIFFTAG_IMAGELENGTH, &h) == 0) return false;
    char reason[1024] = "";
    if (TIFFRGBAImageOK(in_, reason) == 0) {
      why = reason;
      return false;
    }
    constexpr std::uint64_t most = 1u << 28;
    if (w == 0 || h == 0 || static_cast<std::uint64_t>(w) * h > most) return false;
    width = static_cast<int>(w);
    height = static_cast<int>(h);
    return true;
  }

  TIFF* in_ = nullptr;
  bool begun_ = false;
  std::vector<std::uint32_t> pixels_;
};

}  // namespace

extern "C" {

__attribute__((visibility("default"))) EwFilmOpen ewFilmOpen;
__attribute__((visibility("default"))) EwFilmNext ewFilmNext;
__attribute__((visibility("default"))) EwFilmClose ewFilmClose;

EwFilm* ewFilmOpen(const char* file, int kind, EwFilmFacts* facts, char* why, std::size_t room) {
  try {
    silence();
    std::unique_ptr<EwFilm> opened;
    if (kind == ewFilmOfPages) {
      auto pages = std::make_unique<Pages>();
      std::string reason;
      if (!pages->open(file, reason)) {
        if (!reason.empty()) tell(reason.c_str(), why, room);
        return nullptr;
      }
      opened = std::move(pages);
    } else {
      auto video = std::make_unique<Video>();
      if (!video->open(file)) return nullptr;
      opened = std::move(video);
    }
    *facts = opened->facts;
    return opened.release();
  } catch (const std::exception& problem) {
    tell(problem.what(), why, room);
    return nullptr;
  }
}

int ewFilmNext(EwFilm* film, unsigned char* rgb, double* time_s, char* why, std::size_t room) {
  try {
    return film->next(rgb, *time_s);
  } catch (const std::exception& problem) {
    tell(problem.what(), why, room);
    return -1;
  }
}

void ewFilmClose(EwFilm* film) { delete film; }

}  // extern "C"
