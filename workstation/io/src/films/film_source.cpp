#include <algorithm>
#include <cmath>
#include <utility>

#include "dicom/dicom_pixels.h"
#include "ew/core/numbers.h"
#include "files/image_header.h"
#include "films/cine_source.h"
#include "films/video_loader.h"
#include "images/png_pixels.h"

namespace ew::detail {
namespace {
namespace fs = std::filesystem;

/// A data set counts frames of which no decoder may give the last ones back.
constexpr double kFewMissing = 2.0;
/// A film may end before its duration by so many frames or by this share of it, as containers round it, but by no more than this time; or
/// by its longest pause so far, as its last frame may stand long.
constexpr double kFramesShort = 3.0, kShareShort = 0.02, kMostShort_s = 0.5;

/// What a pixel is said to be wider than high, where that can be.
double usableAspect(double aspect) { return std::isfinite(aspect) && aspect > 0.125 && aspect < 8.0 ? aspect : 1.0; }

struct FilmSource final : CineReader::Source {
  fs::path file;
  fs::path shown;
  FilmStream stream;
  EwFilm* film = nullptr;
  EwFilmFacts said = {};  ///< with a pixelAspect that can be used
  double duration_s = 0.0, longestPause_s = 0.0, before_s = 0.0;
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
    film = (*videoModule()->openFilm)(file.c_str(), info.kind == CineKind::pages ? ewFilmOfPages : ewFilmOfVideo, stream.container,
                                      stream.codecs, &facts, why.data(), why.size());
    if (film == nullptr && facts.isOtherCodec != 0)
      return failure(ErrorCode::badHeader,
                     say<"%1 says that its film is %2, but it is %3; export it again.">(quoted(shown), stream.says, verbatim(why.data())),
                     {{"file", shown.string()}});
    if (film == nullptr)
      return failure(
          ErrorCode::badHeader,
          info.kind == CineKind::pages
              ? say<"%1 is a TIFF that cannot be read: it is damaged or packed in a way that is not known; save it again.">(quoted(shown))
              : say<"%1 is a film of which nothing can be read: its index is missing (the recording was not ended), it is "
                    "damaged, or its codec is not installed; record or export it again.">(quoted(shown)),
          {{"file", shown.string()}, {"reason", why.data()}});
    facts.pixelAspect = usableAspect(facts.pixelAspect);
    said = facts;
    info.width_px = facts.width_px;
    info.height_px = facts.height_px;
    info.frames = static_cast<std::uint64_t>(facts.frames);
    info.framesGuessed = facts.framesAreGuess != 0;
    info.rate_hz = facts.rate_hz;
    duration_s = facts.duration_s;
    longestPause_s = before_s = 0.0;
    takeShape(facts);
    return {};
  }
  void takeShape(const EwFilmFacts& facts) {
    info.pixelAspect = facts.pixelAspect;
    info.orientation = orientationOfTag(facts.orientationTag).value_or(Orientation{});
    const auto& matrix = facts.matrix;
    if (std::all_of(std::begin(matrix), std::end(matrix), [](double value) { return value == 0.0; })) return;
    if (const auto stated = orientationOfMatrix(matrix[0], matrix[1], matrix[2], matrix[3]))
      info.orientation = *stated;
    else if (info.notes.empty())
      info.notes.push_back(say<"The film says that its images are to be turned by no whole quarter, which is not done; turn it before.">());
  }
  void breakOff(ErrorCode code, Message message) {
    brokenOff = Error{code, std::move(message), {{"file", shown.string()}, {"frames", std::to_string(given)}}};
  }
  Result<bool> read(CineFrame& frame, const Progress&) override {
    if (film == nullptr) return changed();  // the last rewind failed
    double time_s = -1.0;
    Reason why{};
    const int got = (*videoModule()->nextOfFilm)(film, rgb.data(), &time_s, why.data(), why.size());
    if (got == 1) {
      take(frame, time_s);
      longestPause_s = std::max(longestPause_s, frame.time_s - std::exchange(before_s, frame.time_s));
      return true;
    }
    if (got == -2) {
      breakOff(ErrorCode::badField,
               say<"Frame %1 of %2 has another size than those before it; the %3 before it were read.">(given + 1, quoted(shown), given));
    } else if (given == 0) {
      return failure(ErrorCode::truncated, say<"No frame of %1 can be read; get the file again, or record it once more.">(quoted(shown)),
                     {{"file", shown.string()}});
    } else if (info.kind != CineKind::film) {
      if (got == -1 || static_cast<double>(info.frames) > static_cast<double>(given) + kFewMissing)
        breakOff(ErrorCode::truncated,
                 say<"%1 ends early or is damaged: of %2 frames the first %3 were read; get the file again if the others are needed.">(
                     quoted(shown), info.frames, given));
    } else {
      judgeEnd(got, time_s);
    }
    return false;
  }
  /// Whether a film was read to its end, by its times: the count that a container promises is a guess for films of varying rate, and counts
  /// what an edit list leaves out.
  void judgeEnd(int got, double reached_s) {
    const double last_s = std::max(before_s, reached_s);
    // As many as were counted, not guessed, are all, whatever the times say. More are those of fragments, which the count knows nothing of.
    const bool hasAll = !info.framesGuessed && info.frames > 0 && given == info.frames;
    if (got == -1 || (!hasAll && duration_s > last_s + std::max(mostShort_s(), longestPause_s)))
      return breakOff(
          ErrorCode::truncated,
          say<"%1 ends early or is damaged: of its %2 s the first %3 s were read, %4 frames; get the file again if the others are needed.">(
              quoted(shown), numeral(rounded(duration_s)), numeral(rounded(before_s)), given));
    if (const int faults = (*videoModule()->faultsOfFilm)(film); faults > 0)
      breakOff(ErrorCode::truncated,
               say<"%1 is damaged: at %2 places no frame could be read, and %3 frames were; get the file again if the others are needed.">(
                   quoted(shown), faults, given));
  }
  /// The mean step of the frames that were read counts before the promised rate, which may be no rate of frames (1000 Hz).
  double mostShort_s() const {
    const double step_s = given > 1 && before_s > 0.0 ? before_s / static_cast<double>(given - 1)
                          : info.rate_hz > 0.0        ? 1.0 / info.rate_hz
                                                      : kMostShort_s;
    // Half a step more, so that no rounding of three of them decides.
    return std::min(kMostShort_s, std::max((kFramesShort + 0.5) * step_s, kShareShort * duration_s));
  }
  static std::string rounded(double seconds) { return textOf(std::round(seconds * 100.0) / 100.0); }
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
    // Some films give every frame the time 0, and some frames none, which comes here as a time before the first.
    frame.time_s = info.kind != CineKind::pages && std::isfinite(time_s) && time_s > 0.0 ? time_s : counted_s;
  }
  tl::unexpected<Error> changed() const {
    return failure(ErrorCode::notReadable, say<"%1 was changed while it was in use; open it again.">(quoted(shown)),
                   {{"file", shown.string()}});
  }
  /// Buffers, and what was found in the images, were made for the film that was opened: another one under its name is none of theirs.
  Result<void> rewind() override {
    const EwFilmFacts opened = said;
    const CineInfo before = info;
    if (auto begun = begin(); !begun) return begun;
    if (said == opened) return {};
    close();
    said = opened;
    info = before;
    return changed();
  }
};

}  // namespace

Result<std::unique_ptr<CineReader::Source>> openFilm(const fs::path& file, const fs::path& shown, CineKind kind, const FilmStream& stream,
                                                     const ReaderLimits& limits) {
  auto source = std::make_unique<FilmSource>();
  source->file = fs::absolute(file);
  source->shown = shown;
  source->stream = stream;
  source->info.kind = kind;
  if (auto begun = source->begin(); !begun) return passOn(begun.error());
  CineInfo& info = source->info;
  const std::uint64_t pixels = static_cast<std::uint64_t>(info.width_px) * static_cast<std::uint64_t>(info.height_px);
  if (pixels > (1ull << 28) || pixels * 8 > limits.maxBytes)
    return failure(ErrorCode::tooLarge,
                   say<"The images of %1 have %2 x %3 pixels, more than are read; record a smaller part of the screen.">(
                       quoted(shown), info.width_px, info.height_px),
                   {{"file", shown.string()}});
  source->rgb.resize(3 * pixels);
  info.timesKnown = kind != CineKind::pages && info.rate_hz > 0.0;
  return std::unique_ptr<CineReader::Source>(std::move(source));
}

}  // namespace ew::detail
