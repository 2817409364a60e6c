#include <algorithm>
#include <cmath>
#include <utility>

#include "cine_source.h"
#include "dicom_pixels.h"
#include "image_header.h"
#include "png_pixels.h"
#include "video_loader.h"

namespace ew::detail {
namespace {
namespace fs = std::filesystem;

/// Containers count frames from an index that may have a few that no decoder gives back (edit lists, a delayed last one).
constexpr double kFewMissing = 2.0;

struct FilmSource final : CineReader::Source {
  fs::path file;
  fs::path shown;
  EwFilm* film = nullptr;
  std::vector<unsigned char> rgb;

  FilmSource() = default;
  FilmSource(const FilmSource&) = delete;
  FilmSource& operator=(const FilmSource&) = delete;
  ~FilmSource() override { close(); }
  void close() {
    if (film != nullptr) (*videoModule()->closeFilm)(std::exchange(film, nullptr));
  }
  Result<void> begin() {
    if (!videoModule()) return passOn(videoModule().error());
    close();
    Reason why{};
    EwFilmFacts facts{};
    film = (*videoModule()->openFilm)(file.c_str(), info.kind == CineKind::pages ? ewFilmOfPages : ewFilmOfVideo, &facts, why.data(),
                                      why.size());
    if (film == nullptr)
      return failure(
          ErrorCode::badHeader,
          info.kind == CineKind::pages
              ? say<"%1 is a TIFF that cannot be read: it is damaged or packed in a way that is not known; save it again.">(quoted(shown))
              : say<"%1 is a film of which nothing can be read: its index is missing (the recording was not ended), it is "
                    "damaged, or its codec is not installed; record or export it again.">(quoted(shown)),
          {{"file", shown.string()}, {"reason", why.data()}});
    info.width_px = facts.width_px;
    info.height_px = facts.height_px;
    info.frames = static_cast<std::uint64_t>(facts.frames);
    info.rate_hz = facts.rate_hz;
    return {};
  }
  void breakOff(ErrorCode code, Message message) {
    brokenOff = Error{code, std::move(message), {{"file", shown.string()}, {"frames", std::to_string(given)}}};
  }
  Result<bool> read(CineFrame& frame, const Progress&) override {
    double time_s = -1.0;
    Reason why{};
    const int got = (*videoModule()->nextOfFilm)(film, rgb.data(), &time_s, why.data(), why.size());
    if (got == 1) {
      take(frame, time_s);
      return true;
    }
    if (got == -2) {
      breakOff(ErrorCode::badField,
               say<"Frame %1 of %2 has another size than those before it; the %3 before it were read.">(given + 1, quoted(shown), given));
    } else if (got == -1 || static_cast<double>(info.frames) > static_cast<double>(given) + kFewMissing) {
      if (given == 0)
        return failure(ErrorCode::truncated, say<"No frame of %1 can be read; get the file again, or record it once more.">(quoted(shown)),
                       {{"file", shown.string()}});
      breakOff(ErrorCode::truncated,
               say<"%1 ends early or is damaged: of %2 frames the first %3 were read; get the file again if the others are needed.">(
                   quoted(shown), info.frames, given));
    }
    return false;
  }
  void take(CineFrame& frame, double time_s) {
    const std::size_t pixels = static_cast<std::size_t>(info.width_px) * static_cast<std::size_t>(info.height_px);
    frame.level.width = frame.colour.width = info.width_px;
    frame.level.height = frame.colour.height = info.height_px;
    frame.level.pixels.resize(pixels);
    frame.coloured.resize(pixels);
    frame.colour.pixels.resize(pixels);
    bool any = false;
    const unsigned char* from = rgb.data();
    for (std::size_t n = 0; n < pixels; ++n, from += 3) {
      const auto [lowest, highest] = std::minmax({from[0], from[1], from[2]});
      const bool coloured = highest - lowest > FrameReader::kColourStep;
      any = any || coloured;
      frame.level.pixels[n] = luminanceOf(from[0], from[1], from[2]);
      frame.coloured[n] = coloured ? 1 : 0;
      frame.colour.pixels[n] = Rgb(from[0], from[1], from[2]);
    }
    if (!any) {
      frame.coloured.clear();
      frame.colour = {};
    }
    const double rate_hz = info.rate_hz > 0.0 ? info.rate_hz : 25.0;
    const double counted_s = static_cast<double>(given) / rate_hz;
    // Some films give every frame the time 0.
    frame.time_s = info.kind != CineKind::pages && std::isfinite(time_s) && (time_s > 0.0 || given == 0) ? time_s : counted_s;
  }
  Result<void> rewind() override { return begin(); }
};

}  // namespace

Result<std::unique_ptr<CineReader::Source>> openFilm(const fs::path& file, const fs::path& shown, CineKind kind, const ReadLimits& limits) {
  auto source = std::make_unique<FilmSource>();
  // A name of the command line would do as well, but "file:..." and the like mean something to FFmpeg.
  source->file = fs::absolute(file);
  source->shown = shown;
  source->info.kind = kind;
  if (auto begun = source->begin(); !begun) return passOn(begun.error());
  CineInfo& info = source->info;
  const std::uint64_t pixels = static_cast<std::uint64_t>(info.width_px) * static_cast<std::uint64_t>(info.height_px);
  if (pixels > (1ull << 28) || pixels * 8 > limits.maxBytes)
    return failure(ErrorCode::tooLarge,
                   say<"The pictures of %1 have %2 x %3 pixels, more than are read; record a smaller part of the screen.">(
                       quoted(shown), info.width_px, info.height_px),
                   {{"file", shown.string()}});
  source->rgb.resize(3 * pixels);
  info.timesKnown = kind != CineKind::pages && info.rate_hz > 0.0;
  return std::unique_ptr<CineReader::Source>(std::move(source));
}

}  // namespace ew::detail
