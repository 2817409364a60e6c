#include "ew/io/cine_reader.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <new>

#include "dicom/dicom_fields.h"
#include "dicom/dicom_pixels.h"
#include "dicom/stack_image.h"
#include "ew/core/numbers.h"
#include "ew/core/word_table.h"
#include "ew/io/dicom.h"
#include "ew/io/dicom_stack.h"
#include "ew/io/image_stack.h"
#include "ew/io/sequence.h"
#include "files/grey_samples.h"
#include "files/image_header.h"
#include "films/cine_source.h"

namespace ew {

CineReader::Source::~Source() = default;

namespace {
using namespace detail;
namespace fs = std::filesystem;
using SourceResult = Result<std::unique_ptr<CineReader::Source>>;

/// Of a recording that breaks off.
Message framesBefore(std::uint64_t count) {
  return counted<"The %1 frame before it was read.", "The %1 frames before it were read.">(count);
}

constexpr double kUnknownRate_hz = 25.0;

std::vector<std::uint8_t> beginningOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::vector<std::uint8_t> beginning(600);
  in.read(reinterpret_cast<char*>(beginning.data()), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return beginning;
}

bool standsAt(std::span<const std::uint8_t> bytes, std::size_t at, std::string_view text) {
  return bytes.size() >= at + text.size() && std::memcmp(bytes.data() + at, text.data(), text.size()) == 0;
}

bool beginsAsMp4(std::span<const std::uint8_t> bytes) {
  using namespace std::string_view_literals;
  constexpr std::array boxes{"ftyp"sv, "moov"sv, "mdat"sv, "wide"sv, "free"sv, "skip"sv};
  return std::any_of(boxes.begin(), boxes.end(), [&](std::string_view box) { return standsAt(bytes, 4, box); });
}
bool beginsAsTransportStream(std::span<const std::uint8_t> bytes) {
  return bytes.size() > 376 && bytes[0] == 0x47 && bytes[188] == 0x47 && bytes[376] == 0x47;
}
/// Zeros and a start code: how streams of MPEG without a container begin. @return the byte behind the code
std::optional<std::uint8_t> firstStartCode(std::span<const std::uint8_t> bytes) {
  const auto zeros =
      static_cast<std::size_t>(std::find_if(bytes.begin(), bytes.end(), [](auto byte) { return byte != 0; }) - bytes.begin());
  if (zeros < 2 || zeros + 1 >= bytes.size() || bytes[zeros] != 1) return std::nullopt;
  return bytes[zeros + 1];
}

/// How a film is to be opened, by content alone: a play list by the name of a film could make a decoder open other files.
FilmStream streamOfFilm(std::span<const std::uint8_t> bytes) {
  using namespace std::string_view_literals;
  if (beginsAsMp4(bytes)) return {.container = "mov"};
  if (standsAt(bytes, 0, "RIFF"sv) && standsAt(bytes, 8, "AVI "sv)) return {.container = "avi"};
  if (standsAt(bytes, 0, "\x1A\x45\xDF\xA3"sv)) return {.container = "matroska"};
  if (standsAt(bytes, 0, "\x00\x00\x01\xBA"sv)) return {.container = "mpeg"};
  if (standsAt(bytes, 0, "\x00\x00\x01\xB3"sv)) return {.container = "mpegvideo"};
  if (standsAt(bytes, 0, "\x30\x26\xB2\x75"sv)) return {.container = "asf"};
  if (beginsAsTransportStream(bytes)) return {.container = "mpegts"};
  return {};
}
bool beginsAsFilm(std::span<const std::uint8_t> bytes) { return *streamOfFilm(bytes).container != '\0'; }

bool beginsAsTiff(std::span<const std::uint8_t> bytes) {
  using namespace std::string_view_literals;
  for (const std::string_view start : {"II\x2A\x00"sv, "MM\x00\x2A"sv, "II\x2B\x00"sv, "MM\x00\x2B"sv})
    if (standsAt(bytes, 0, start)) return true;
  return false;
}

void keepColourWhereItIs(CineFrame& frame) {
  if (std::find(frame.coloured.begin(), frame.coloured.end(), 1) != frame.coloured.end()) return;
  frame.coloured.clear();
  frame.colour = {};
}

/// Times of the frames by the data set. A note that there are none is for those who then store none: here they are counted all the same,
/// and what is left to say is what the file has instead.
std::vector<double> timesByDataSet(const DicomItem& data, std::uint64_t frames, std::vector<Message>& notes) {
  std::vector<Message> found;
  auto times_s = frameTimes(data, frames, found);
  if (times_s.empty() && !found.empty()) {
    const std::vector<Message> said = found.back().arguments();
    found.pop_back();
    if (said.size() > 1) found.push_back(say<"The file gives no usable times of its %1 frames: it has %2.">(said[0], said[1]));
  }
  notes.insert(notes.end(), found.begin(), found.end());
  return times_s;
}

/// DICOM whose frames are unpacked one by one.
struct DicomSource final : CineReader::Source {
  DicomFile dicom;
  PixelLayout layout;
  std::optional<FrameReader> reader;
  std::vector<double> times_s;
  std::vector<std::int32_t> levels;
  std::int32_t lowest = 0, highest = 255;

  Result<bool> read(CineFrame& frame, const Progress& progress) override {
    if (given >= layout.frames) return false;
    std::vector<Rgb>& colour = frame.colour.pixels;
    if (auto got = reader->read(given, levels, frame.coloured, progress, &colour); !got) {
      if (got.error().code == ErrorCode::cancelled || given == 0) return passOn(got.error());
      brokenOff = got.error();
      brokenOff->message = joined({brokenOff->message, framesBefore(given)});
      return false;
    }
    frame.level.width = frame.colour.width = info.width_px;
    frame.level.height = frame.colour.height = info.height_px;
    frame.level.pixels.resize(levels.size());
    const bool inverted = layout.photometric == "MONOCHROME1";
    const std::int32_t span = std::max(1, highest - lowest);
    for (std::size_t n = 0; n < levels.size(); ++n) {
      const auto value = (static_cast<std::int64_t>(std::clamp(levels[n], lowest, highest)) - lowest) * 255 / span;
      frame.level.pixels[n] = static_cast<std::uint8_t>(inverted ? 255 - value : value);
    }
    frame.time_s = given < times_s.size() ? times_s[given] : static_cast<double>(given) / kUnknownRate_hz;
    keepColourWhereItIs(frame);
    return true;
  }
  Result<void> rewind() override { return {}; }
};

/// The smallest and largest of deep samples, which a frame alone does not know.
Result<void> findRange(DicomSource& source, Progress& progress) {
  if (source.layout.inColour() || (source.layout.bitsStored == 8 && !source.layout.isSigned)) return {};
  source.lowest = std::numeric_limits<std::int32_t>::max();
  source.highest = std::numeric_limits<std::int32_t>::min();
  std::vector<std::uint8_t> coloured;
  for (std::uint64_t n = 0; n < source.layout.frames; ++n) {
    if (progress.cancelRequested()) return stopped(source.dicom.file);
    if (auto got = source.reader->read(n, source.levels, coloured, progress); !got) {
      if (got.error().code == ErrorCode::cancelled || n == 0) return passOn(got.error());
      return {};
    }
    const auto [low, high] = std::minmax_element(source.levels.begin(), source.levels.end());
    source.lowest = std::min(source.lowest, *low);
    source.highest = std::max(source.highest, *high);
    progress.report(say<"Reading frames">(), static_cast<double>(n + 1) / static_cast<double>(source.layout.frames));
  }
  source.info.notes.push_back(say<"The samples have %1 bits: values from %2 to %3 were mapped to 0 to 255.">(
      source.layout.bitsStored, source.lowest, source.highest));
  return {};
}

constexpr std::string_view kMpegSyntaxes = "1.2.840.10008.1.2.4.10";

bool isMpeg(const std::string& transferSyntax) {
  // MPEG-2 (.100, .101 and their fragmentable ones), H.264 (.102 to .106), HEVC (.107, .108).
  return transferSyntax.starts_with(kMpegSyntaxes) && transferSyntax.size() > kMpegSyntaxes.size();
}

/// How the stream of a data set is to be opened: its transfer syntax decides, and what the bytes look like only among what that one allows
/// (PS3.5, 8.2.5 to 8.2.8): elementary, program or transport stream of MPEG-2; MP4, transport or elementary stream of H.264 and HEVC.
FilmStream streamOfDicom(const std::string& transferSyntax, std::span<const std::uint8_t> bytes) {
  const char kind = transferSyntax[kMpegSyntaxes.size()];
  const auto code = firstStartCode(bytes);
  if (kind == '0' || kind == '1') {
    FilmStream stream{.codecs = "mpeg2video,mpeg1video", .says = "MPEG-2"};
    if (beginsAsTransportStream(bytes))
      stream.container = "mpegts";
    else if (code)
      stream.container = *code == 0xBA ? "mpeg" : "mpegvideo";
    return stream;
  }
  const bool isHevc = kind == '7' || kind == '8';
  FilmStream stream{.codecs = isHevc ? "hevc" : "h264", .says = isHevc ? "HEVC" : "H.264"};
  if (beginsAsMp4(bytes))
    stream.container = "mov";
  else if (beginsAsTransportStream(bytes))
    stream.container = "mpegts";
  else if (code)
    stream.container = stream.codecs;
  return stream;
}

/// What a data set says of the size and shape of its pixels, as an import takes it: of all calibrated B-mode regions, else by Pixel
/// Spacing, else the shape alone. Parts of different shapes leave the images as they are.
void takeScale(const DicomItem& data, CineInfo& info) {
  const DicomScale scale =
      scaleOf(data, static_cast<std::uint64_t>(std::max(info.width_px, 1)), static_cast<std::uint64_t>(std::max(info.height_px, 1)));
  info.notes.insert(info.notes.end(), scale.notes.begin(), scale.notes.end());
  const bool anyStale =
      std::any_of(scale.regions.begin(), scale.regions.end(), [](const UltrasoundRegion& region) { return region.stale; });
  for (std::size_t n = 0; n < scale.regions.size(); ++n) {
    const UltrasoundRegion& region = scale.regions[n];
    // Beside a B-mode, traces, bars and colour flow have no scale of a scan to lose.
    const bool couldBeScan = region.spatialFormat <= 1 && region.dataType <= 1;
    if (region.stale || (!region.usable() && (couldBeScan || scale.bModes.empty())))
      info.notes.push_back(say<"Region %1 was not used for the scale.">(region.describe(n + 1)));
  }
  if (anyStale && !scale.bModes.empty())
    info.notes.push_back(say<"The other regions may have been made for another size of the images as well, so none was used.">());
  for (const std::size_t n : scale.bModes) info.scales.push_back({scale.regions[n].rect, scale.regions[n].pixel_mm()});
  if (anyStale) info.scales.clear();  // made for another size, and so may be the others
  if (info.scales.empty() && scale.spacing_mm) info.scales.push_back({{0, 0, info.width_px, info.height_px}, *scale.spacing_mm});
  constexpr double kAlike = 1e-3;
  const auto shapeOf = [](const PixelScale& part) { return part.pixel_mm.x / part.pixel_mm.y; };
  const auto alike = [&](const PixelScale& part) { return std::abs(shapeOf(part) / shapeOf(info.scales.front()) - 1.0) < kAlike; };
  double shape = scale.heightByWidth ? 1.0 / *scale.heightByWidth : 1.0;
  if (!info.scales.empty()) {
    shape = shapeOf(info.scales.front());
    if (!std::all_of(info.scales.begin(), info.scales.end(), alike)) {
      info.notes.push_back(say<"The file has parts whose pixels differ in shape, so the images were left as they are; state the depth.">());
      info.scales.clear();
      shape = 1.0;
    }
  }
  if (shape > 0.125 && shape < 8.0) info.pixelAspect = shape;
  const auto pixel_mm = info.scales.empty() ? std::optional<glm::dvec2>() : std::optional(info.scales.front().pixel_mm);
  for (Message& note : unusedFields(data, pixel_mm ? pixel_mm : glm::dvec2(shape, 1.0))) info.notes.push_back(std::move(note));
}

/// A film inside DICOM: its stream lies in memory under a name of its own, so that nothing of a patient is written anywhere.
struct DicomFilmSource final : CineReader::Source {
  int memory = -1;
  std::unique_ptr<CineReader::Source> film;
  std::vector<double> times_s;

  DicomFilmSource() = default;
  DicomFilmSource(const DicomFilmSource&) = delete;
  DicomFilmSource& operator=(const DicomFilmSource&) = delete;
  ~DicomFilmSource() override {
    film.reset();
    if (memory >= 0) close(memory);
  }
  Result<bool> read(CineFrame& frame, const Progress& progress) override {
    film->given = given;
    auto got = film->read(frame, progress);
    brokenOff = film->brokenOff;
    if (got && *got && given < times_s.size()) frame.time_s = times_s[given];
    return got;
  }
  Result<void> rewind() override {
    film->brokenOff.reset();
    auto begun = film->rewind();
    film->info.frames = info.frames;
    return begun;
  }
};

/// Number of Frames, where that can be: 0 when it is not stated, is more than is read of any DICOM file (pixelLayoutOf), or more than the
/// stream has bytes. Nothing else holds the stream to what a data set says of it, and times take memory for every frame.
std::uint64_t framesByDataSet(const DicomItem& data, const DicomElement& pixels, std::vector<Message>& notes) {
  constexpr std::uint64_t kMost = 1u << 24;
  const std::uint64_t frames = data.count(0x00280008u).value_or(0);
  std::uint64_t stream_bytes = 0;
  for (std::size_t n = 1; n < pixels.fragments.size(); ++n) stream_bytes += pixels.fragments[n].size();
  if (frames <= std::min(kMost, stream_bytes)) return frames;
  notes.push_back(say<"The file says that it has %1 frames, more than its film can have; those that are in it count.">(frames));
  return 0;
}

SourceResult openDicomFilm(const fs::path& file, const DicomFile& dicom, const ReaderLimits& limits) {
  const DicomElement* const pixels = dicom.data.find(0x7FE00010u);
  if (pixels == nullptr || pixels->fragments.size() < 2)
    return failure(ErrorCode::badHeader, say<"%1 says it holds a film, but has none; export it again.">(quoted(file)),
                   {{"file", file.string()}});
  auto source = std::make_unique<DicomFilmSource>();
  source->memory = memfd_create("film", MFD_CLOEXEC);
  bool written = source->memory >= 0;
  for (std::size_t n = 1; written && n < pixels->fragments.size(); ++n)
    for (Bytes rest = pixels->fragments[n]; written && !rest.empty();) {
      const ssize_t count = write(source->memory, rest.data(), rest.size());
      written = count > 0;
      if (written) rest = rest.subspan(static_cast<std::size_t>(count));
    }
  if (!written)
    return failure(ErrorCode::tooLarge, say<"There is not enough memory for the film in %1; close other programs.">(quoted(file)),
                   {{"file", file.string()}});
  const FilmStream stream = streamOfDicom(dicom.transferSyntax, beginningOf("/proc/self/fd/" + std::to_string(source->memory)));
  if (*stream.container == '\0')
    return failure(ErrorCode::badHeader,
                   say<"%1 says that its film is %2, but its stream is of another kind; export it again.">(quoted(file), stream.says),
                   {{"file", file.string()}});
  auto film = openFilm("/proc/self/fd/" + std::to_string(source->memory), file, CineKind::dicomFilm, stream, limits);
  if (!film) return passOn(film.error());
  source->film = *std::move(film);
  source->info = source->film->info;  // its shape as well
  source->info.removed = identifyingFields(dicom.data);
  const double ofStream = source->info.pixelAspect;
  takeScale(dicom.data, source->info);
  if (source->info.scales.empty() && source->info.pixelAspect == 1.0) source->info.pixelAspect = ofStream;  // the data set says nothing
  // Streams without a container guess their length; the data set knows it.
  source->info.frames = source->film->info.frames = framesByDataSet(dicom.data, *pixels, source->info.notes);
  source->info.framesGuessed = false;
  source->times_s = timesByDataSet(dicom.data, source->info.frames, source->info.notes);
  source->info.timesKnown = source->info.timesKnown || !source->times_s.empty();
  return std::unique_ptr<CineReader::Source>(std::move(source));
}

SourceResult openDicom(const fs::path& file, Progress& progress, const ReaderLimits& limits) {
  auto dicom = readDicomFile(file, limits.maxBytes, progress);
  if (!dicom) return passOn(dicom.error());
  if (isMpeg(dicom->transferSyntax)) return openDicomFilm(file, *dicom, limits);
  auto source = std::make_unique<DicomSource>();
  source->dicom = *std::move(dicom);
  const auto layout = pixelLayoutOf(source->dicom, limits);
  if (!layout) return passOn(layout.error());
  source->layout = *layout;
  auto reader = FrameReader::open(source->dicom, source->layout);
  if (!reader) return passOn(reader.error());
  source->reader = *std::move(reader);
  CineInfo& info = source->info;
  info.kind = CineKind::dicom;
  info.width_px = static_cast<int>(layout->columns);
  info.height_px = static_cast<int>(layout->rows);
  info.frames = layout->frames;
  info.notes = layout->notes;
  info.removed = identifyingFields(source->dicom.data);
  takeScale(source->dicom.data, info);
  source->times_s = timesByDataSet(source->dicom.data, layout->frames, info.notes);
  info.timesKnown = !source->times_s.empty();
  if (auto found = findRange(*source, progress); !found) return passOn(found.error());
  return std::unique_ptr<CineReader::Source>(std::move(source));
}

struct SequenceSource final : CineReader::Source {
  Sequence sequence;
  Result<bool> read(CineFrame& frame, const Progress&) override {
    if (given >= sequence.frames.size()) return false;
    const auto pixels = sequence.framePixels(given);
    frame.level.width = info.width_px;
    frame.level.height = info.height_px;
    frame.level.pixels.assign(pixels.begin(), pixels.end());
    frame.coloured.clear();
    frame.colour = {};
    frame.time_s = sequence.frames[given].time_s.value_or(static_cast<double>(given) / kUnknownRate_hz);
    return true;
  }
  Result<void> rewind() override { return {}; }
};

SourceResult openSequence(const fs::path& file, Progress& progress, const ReaderLimits& limits) {
  auto sequence = readSequence(file, progress, limits);
  if (!sequence) return passOn(sequence.error());
  if (sequence->pixels.empty())
    return failure(ErrorCode::unsupported, say<"%1 holds poses without images; choose a recording with images.">(quoted(file)),
                   {{"file", file.string()}});
  auto source = std::make_unique<SequenceSource>();
  source->info.kind = CineKind::sequence;
  source->info.width_px = sequence->width;
  source->info.height_px = sequence->height;
  source->info.frames = sequence->frames.size();
  source->info.timesKnown =
      std::all_of(sequence->frames.begin(), sequence->frames.end(), [](const SequenceFrame& frame) { return frame.time_s.has_value(); });
  source->info.notes = sequence->notes;
  const auto untimed =
      std::count_if(sequence->frames.begin(), sequence->frames.end(), [](const SequenceFrame& frame) { return !frame.time_s; });
  if (untimed > 0 && static_cast<std::size_t>(untimed) < sequence->frames.size())
    source->info.notes.push_back(say<"Frames without a time: %1 of %2.">(untimed, sequence->frames.size()));
  source->sequence = *std::move(sequence);
  return std::unique_ptr<CineReader::Source>(std::move(source));
}

struct ImagesSource final : CineReader::Source {
  std::vector<fs::path> files;
  Result<bool> read(CineFrame& frame, const Progress& progress) override {
    if (given >= files.size()) return false;
    auto image = readStackImage(files[given], progress);
    if (!image) {
      if (image.error().code == ErrorCode::cancelled || given == 0) return passOn(image.error());
      brokenOff = image.error();
      brokenOff->message = joined({brokenOff->message, framesBefore(given)});
      return false;
    }
    if (image->width != info.width_px || image->height != info.height_px) {
      brokenOff = Error{
          ErrorCode::badField,
          say<"Frame %1 of %2 has another size than those before it; the %3 before it were read.">(given + 1, quoted(files[given]), given),
          {{"file", files[given].string()}}};
      return false;
    }
    frame.level.width = image->width;
    frame.level.height = image->height;
    frame.level.pixels = std::move(image->level);
    frame.coloured = std::move(image->coloured);
    frame.colour = {};
    if (std::find(frame.coloured.begin(), frame.coloured.end(), 1) == frame.coloured.end()) frame.coloured.clear();
    frame.time_s = static_cast<double>(given) / kUnknownRate_hz;
    return true;
  }
  Result<void> rewind() override { return {}; }
};

SourceResult openImages(const fs::path& file) {
  auto files = stackFiles(file);
  if (!files && files.error().code == ErrorCode::unsupported && !dicomFilesIn(file).empty())
    return failure(ErrorCode::unsupported,
                   say<"%1 is a folder of DICOM stills, which are not cleaned together; make a volume of them with echoweave import, or "
                       "choose one of the files.">(quoted(file)),
                   {{"file", file.string()}});
  if (!files) return passOn(files.error());
  auto source = std::make_unique<ImagesSource>();
  source->files = *std::move(files);
  const auto first = readStackImage(source->files.front(), noProgress());
  if (!first) return passOn(first.error());
  source->info.width_px = first->width;
  source->info.height_px = first->height;
  source->info.kind = CineKind::images;
  source->info.pixelAspect = pixelAspectOfImage(source->files.front());
  source->info.frames = source->files.size();
  return std::unique_ptr<CineReader::Source>(std::move(source));
}

SourceResult openAny(const fs::path& file, Progress& progress, const ReaderLimits& limits) {
  std::error_code ec;
  if (fs::is_directory(file, ec)) return openImages(file);
  if (const auto there = checkIsFile(file); !there) return passOn(there.error());
  const auto beginning = beginningOf(file);
  // The free bytes before "DICM" may be those of another format.
  if (standsAt(beginning, 128, "DICM")) return openDicom(file, progress, limits);
  if (beginsAsTiff(beginning)) return openFilm(file, file, CineKind::pages, {}, limits);
  if (beginsAsFilm(beginning)) return openFilm(file, file, CineKind::film, streamOfFilm(beginning), limits);
  if (looksLikeDicom(Bytes(beginning).first(std::min<std::size_t>(beginning.size(), 256)))) return openDicom(file, progress, limits);
  const std::string ending = lowerCase(file.extension().string());
  if (ending == ".mha" || ending == ".mhd" || ending == ".nrrd" || ending == ".nhdr") return openSequence(file, progress, limits);
  if (ending == ".png" || ending == ".jpg" || ending == ".jpeg" || ending == ".pgm") return openImages(file);
  return failure(ErrorCode::unsupported,
                 say<"%1 is no film, DICOM cine, TIFF, sequence or image that is known, or its beginning is damaged.">(quoted(file)),
                 {{"file", file.string()}});
}

/// Says how the frames are timed where the file does not say it, or a person said it. Films have times in their streams.
void settleTimes(CineReader::Source& source) {
  CineInfo& info = source.shown;
  const auto shown = [](double rate_hz) { return numeral(textOf(std::round(rate_hz * 1e3) / 1e3)); };
  if (source.statedRate_hz) {
    if (info.timesKnown)
      info.notes.push_back(
          say<"The rate of the images was stated, %1 a second; the times in the file were not used.">(shown(*source.statedRate_hz)));
    info.rate_hz = *source.statedRate_hz;
    info.timesKnown = true;
    return;
  }
  if (info.timesKnown || info.frames == 1 || info.kind == CineKind::film || info.kind == CineKind::dicomFilm) return;
  info.assumedRate_hz = info.kind == CineKind::pages && info.rate_hz > 0.0 ? info.rate_hz : kUnknownRate_hz;
  info.notes.push_back(say<"The file does not say when its images were recorded; %1 a second were assumed.">(shown(info.assumedRate_hz)));
}

/// Says what becomes of the images, and makes ready for it.
Result<void> prepare(CineReader::Source& source, const Orientation& asked, const fs::path& file, const ReaderLimits& limits) {
  const CineInfo& stored = source.info;
  source.shaper.emplace(stored, asked);
  source.shown = stored;
  source.shown.width_px = source.shaper->width_px();
  source.shown.height_px = source.shaper->height_px();
  for (PixelScale& part : source.shown.scales)
    part = {source.shaper->shaped(part.rect), glm::dvec2(std::min(part.pixel_mm.x, part.pixel_mm.y))};
  settleTimes(source);
  auto& notes = source.shown.notes;
  const auto pixels = static_cast<std::uint64_t>(source.shown.width_px) * static_cast<std::uint64_t>(source.shown.height_px);
  if (pixels > (1ull << 28) || pixels * 8 > limits.maxBytes)
    return failure(ErrorCode::tooLarge,
                   say<"The images of %1 have %2 x %3 pixels, more than are read; record a smaller part of the screen.">(
                       quoted(file), source.shown.width_px, source.shown.height_px),
                   {{"file", file.string()}});
  if (const Orientation& stated = stored.orientation; !stated.isUpright())
    notes.push_back(!stated.mirrored
                        ? say<"The file says how its images are seen upright: they were turned clockwise by %1 degrees.">(stated.degrees())
                    : stated.quarterTurns == 0
                        ? say<"The file says how its images are seen upright: they were mirrored, left to right.">()
                        : say<"The file says how its images are seen upright: they were turned clockwise by %1 degrees, then mirrored.">(
                              stated.degrees()));
  if (source.shaper->stretches())
    notes.push_back(
        say<"The file says that its pixels are %1 times as wide as high: images of %2 x %3 were stretched to %4 x %5 square ones.">(
            numeral(textOf(std::round(stored.pixelAspect * 1e4) / 1e4)), stored.width_px, stored.height_px, source.shaper->squareWidth_px(),
            source.shaper->squareHeight_px()));
  return {};
}

constexpr WordTable<CineKind, 6> kCineKindWords{{{"film", CineKind::film},
                                                 {"film in DICOM", CineKind::dicomFilm},
                                                 {"DICOM images", CineKind::dicom},
                                                 {"TIFF", CineKind::pages},
                                                 {"sequence", CineKind::sequence},
                                                 {"pictures", CineKind::images}}};

}  // namespace

const char* nameOf(CineKind kind) { return wordIn(kCineKindWords, kind); }

bool isFilm(const fs::path& file) { return checkIsFile(file) && beginsAsFilm(beginningOf(file)); }
bool isTiff(const fs::path& file) { return checkIsFile(file) && beginsAsTiff(beginningOf(file)); }
bool isDicomFilm(const fs::path& file) {
  if (!isDicom(file)) return false;
  const auto dicom = readDicomFile(file, ReaderLimits{}.maxBytes, noProgress());
  return dicom && isMpeg(dicom->transferSyntax);
}

CineReader::CineReader(std::unique_ptr<Source> source) : source_(std::move(source)) {}
CineReader::~CineReader() = default;
CineReader::CineReader(CineReader&&) noexcept = default;
CineReader& CineReader::operator=(CineReader&&) noexcept = default;

Result<CineReader> CineReader::open(const fs::path& file, Progress& progress, const ReaderLimits& limits, const Orientation& asked,
                                    const std::optional<double>& rate_hz) try {
  auto source = openAny(file, progress, limits);
  if (!source) return passOn(source.error());
  (*source)->statedRate_hz = rate_hz;
  if (auto there = prepare(**source, asked, file, limits); !there) return passOn(there.error());
  return CineReader(*std::move(source));
} catch (const std::bad_alloc&) {
  return failure(ErrorCode::tooLarge, say<"There is not enough memory for the frames of %1; close other programs.">(quoted(file)),
                 {{"file", file.string()}});
}

const CineInfo& CineReader::info() const { return source_->shown; }
std::uint64_t CineReader::given() const { return source_->given; }
const std::optional<Error>& CineReader::brokenOff() const { return source_->brokenOff; }

Result<bool> CineReader::next(CineFrame& frame, const Progress& progress) {
  if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Reading the frames was stopped.">());
  if (source_->brokenOff) return false;
  const double before_s = frame.time_s;
  auto got = source_->read(frame, progress);
  if (!got) return passOn(got.error());
  if (!*got) return false;
  source_->shaper->shape(frame);
  if (source_->statedRate_hz) frame.time_s = static_cast<double>(source_->given) / *source_->statedRate_hz;
  if (source_->given > 0) frame.time_s = std::max(frame.time_s, before_s);
  ++source_->given;
  return true;
}

Result<void> CineReader::rewind() {
  if (auto begun = source_->rewind(); !begun) return begun;
  source_->given = 0;
  source_->brokenOff.reset();
  return {};
}

}  // namespace ew
