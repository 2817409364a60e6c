#include <tiffio.h>

#include <cstdint>
#include <vector>

#include "film_parts.h"

namespace {

class Pages final : public EwFilmParts {
 public:
  ~Pages() override {
    if (in_ != nullptr) TIFFClose(in_);
  }
  bool open(const char* file, std::string& why) {
    in_ = TIFFOpen(file, "rm");
    if (in_ == nullptr) return false;
    if (!size(facts.width_px, facts.height_px, why)) return false;
    std::uint16_t tag = 0;
    if (TIFFGetField(in_, TIFFTAG_ORIENTATION, &tag) != 0) facts.orientationTag = tag;
    float across = 0.0F, down = 0.0F;  // pixels in a unit of length
    if (TIFFGetField(in_, TIFFTAG_XRESOLUTION, &across) != 0 && TIFFGetField(in_, TIFFTAG_YRESOLUTION, &down) != 0 && across > 0.0F)
      facts.pixelAspect = static_cast<double>(down) / static_cast<double>(across);
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
    // Asked for by its own orientation it comes as it is stored: the library itself mirrors and never turns.
    std::uint16_t tag = ORIENTATION_TOPLEFT;
    if (TIFFGetField(in_, TIFFTAG_ORIENTATION, &tag) == 0 || tag < ORIENTATION_TOPLEFT || tag > ORIENTATION_LEFTBOT)
      tag = ORIENTATION_TOPLEFT;
    if (TIFFReadRGBAImageOriented(in_, w, h, pixels_.data(), tag, 1) == 0) return -1;
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

std::unique_ptr<EwFilmParts> openPages(const char* file, std::string& why) {
  auto pages = std::make_unique<Pages>();
  if (!pages->open(file, why)) return nullptr;
  return pages;
}
