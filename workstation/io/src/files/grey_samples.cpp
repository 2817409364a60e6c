#include "files/grey_samples.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>

#include "ew/core/figures.h"
#include "ew/core/large_pages.h"
#include "ew/core/numbers.h"
#include "files/byte_source.h"

namespace ew::detail {
namespace {

constexpr std::size_t kSampleChunk = 1u << 20;

/// Where sentences go: all that was decided, and of these what makes a result doubtful.
struct GreyNotes {
  std::vector<Message>& notes;
  std::vector<Message>& warnings;
};

Result<void> checkSizes(const ImageHeader& header, const SampleRequest& request, const ReaderLimits& limits) {
  const std::uint64_t perPixel = header.channels * bytesOf(header.type);
  const std::array<std::uint64_t, 3> factors{request.promised, header.channels, bytesOf(header.type)};
  const auto promised = productOf(factors);
  const bool direct = header.type == SampleType::u8 && header.channels == 1;
  // Samples that must be converted stand beside their 8 bit result for a moment.
  const std::array<std::uint64_t, 2> needs{request.pixels, direct ? 1 : perPixel + 1};
  const auto needed = productOf(needs);
  if (!promised || !needed || *needed > limits.maxBytes)
    return failure(
        ErrorCode::tooLarge,
        say<"The header of %1 promises %2 samples, for which %3 bytes of memory would be needed, but the limit is %4; check that the file "
            "is undamaged, or cut it into parts.">(quoted(header.file), sizesText(header.sizes), countText(needed), limits.maxBytes),
        {{"file", header.file.string()}, {"needed", countText(needed).english()}, {"limit", std::to_string(limits.maxBytes)}});
  return {};
}

Result<void> fill(const ImageHeader& header, ByteSource& source, std::span<std::uint8_t> target, const Message& what, Progress& progress) {
  std::size_t filled = 0;
  while (filled < target.size()) {
    if (progress.cancelRequested()) return stopped(header.file);
    const auto part = target.subspan(filled, std::min(kSampleChunk, target.size() - filled));
    const auto got = source.read(part);
    if (!got) {
      Error error = got.error();
      error.context.emplace_back("promised", std::to_string(target.size()));
      const auto unpacked =
          std::find_if(error.context.begin(), error.context.end(), [](const auto& fact) { return fact.first == "unpacked"; });
      if (unpacked != error.context.end())
        error.message = say<"The compressed samples of %1 break off after %2 of the %3 bytes the header promises; get the file again.">(
            quoted(header.dataFile), unpacked->second, target.size());
      return passOn(std::move(error));
    }
    filled += *got;
    if (*got < part.size())
      return failure(ErrorCode::truncated,
                     say<"%1 is too short: its header promises %2 bytes of samples, the file has %3; get the file again.">(
                         quoted(header.dataFile), target.size(), filled),
                     {{"file", header.dataFile.string()}, {"promised", std::to_string(target.size())}, {"found", std::to_string(filled)}});
    progress.report(what, 0.9 * static_cast<double>(filled) / static_cast<double>(target.size()));
  }
  return {};
}

/// After the last promised byte: nothing may follow in a packed stream, and its checksum must hold.
Result<void> checkEnd(const ImageHeader& header, ByteSource& source, std::uint64_t promisedBytes, Progress& progress,
                      std::vector<Message>& notes) {
  constexpr std::uint64_t worthCounting = 64u << 20;
  std::vector<std::uint8_t> rest(64u << 10);
  std::uint64_t extra = 0;
  for (;;) {
    if (progress.cancelRequested()) return stopped(header.file);
    const auto got = source.read(rest);
    if (!got) return passOn(got.error());
    extra += *got;
    if (*got < rest.size() || extra > worthCounting) break;
  }
  if (extra == 0) return {};
  const auto amount = [&](std::uint64_t bytes) {
    return extra > worthCounting ? say<"more than %1">(bytes) : verbatim(std::to_string(bytes));
  };
  if (header.packing == Packing::raw) {
    notes.push_back(say<"%1 has %2 bytes after its samples, which were not read.">(quoted(header.dataFile), amount(extra)));
    return {};
  }
  const Message found = amount(promisedBytes + extra);
  return failure(
      ErrorCode::badHeader,
      say<"The header of %1 promises %2 bytes of samples, but %3 are there; correct the header's sizes or export the file again.">(
          quoted(header.file), promisedBytes, found),
      {{"file", header.file.string()}, {"promised", std::to_string(promisedBytes)}, {"found", found.english()}});
}

template <class T>
T sampleAt(const std::uint8_t* bytes, bool swap) {
  std::array<std::uint8_t, sizeof(T)> copy;
  std::memcpy(copy.data(), bytes, sizeof(T));
  if (swap) std::reverse(copy.begin(), copy.end());
  return std::bit_cast<T>(copy);
}

/// The value of a pixel: its one channel, or the luminance of red, green and blue (ITU-R BT.601 weights; alpha is left out).
template <class T>
double valueOf(const std::uint8_t* pixel, std::uint64_t channels, bool swap, double slope, double intercept) {
  double value = static_cast<double>(sampleAt<T>(pixel, swap));
  if (channels >= 3)
    value = 0.299 * value + 0.587 * static_cast<double>(sampleAt<T>(pixel + sizeof(T), swap)) +
            0.114 * static_cast<double>(sampleAt<T>(pixel + 2 * sizeof(T), swap));
  return slope * value + intercept;
}

/// What echoes that still carry their wave look like: they swing about 0, as far below as above, and brightness does not.
struct Swing {
  double sum = 0.0, squares = 0.0;
  std::uint64_t count = 0;
  void add(double value) {
    sum += value;
    squares += value * value;
    ++count;
  }
  /// Lines of echoes (RF), or their two demodulated parts (IQ), have no mean beside their spread, however uneven their ends are.
  [[nodiscard]] bool looksLikeRf(double lowest, double highest) const {
    if (count < 2 || !(lowest < 0.0 && highest > 0.0)) return false;
    const double below = -lowest, above = highest;
    if (std::min(below, above) < 0.2 * std::max(below, above)) return false;
    if (std::max(below, above) < 1.25 * std::min(below, above)) return true;
    const double mean = sum / static_cast<double>(count);
    return std::abs(mean) < 0.15 * std::sqrt(std::max(0.0, squares / static_cast<double>(count) - mean * mean));
  }
};

template <class T>
Result<void> toGrey(const ImageHeader& header, const std::vector<std::uint8_t>& stored, std::vector<std::uint8_t>& grey, bool rescale,
                    Progress& progress, GreyNotes& told) {
  std::vector<Message>& notes = told.notes;
  const bool swap = header.bigEndian != (std::endian::native == std::endian::big);
  const std::size_t step = static_cast<std::size_t>(header.channels) * sizeof(T);
  const std::size_t wanted = static_cast<std::size_t>(header.wantedChannel.value_or(0)) * sizeof(T);
  const std::uint64_t together = header.wantedChannel ? 1 : header.channels;
  const auto value = [&](std::size_t pixel) {
    return valueOf<T>(stored.data() + pixel * step + wanted, together, swap, header.slope, header.intercept);
  };
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  std::uint64_t notFinite = 0;
  Swing swing;
  for (std::size_t pixel = 0; pixel < grey.size(); ++pixel) {
    if (pixel % kSampleChunk == 0 && progress.cancelRequested()) return stopped(header.file);
    const double here = value(pixel);
    if (!std::isfinite(here)) {
      ++notFinite;
      continue;
    }
    lowest = std::min(lowest, here);
    highest = std::max(highest, here);
    swing.add(here);
  }
  if (!rescale) {
    lowest = 0.0;
    highest = 255.0;
  }
  // Halves keep the width finite when the values span the whole range of a double.
  const double width = highest * 0.5 - lowest * 0.5;
  for (std::size_t pixel = 0; pixel < grey.size(); ++pixel) {
    if (pixel % kSampleChunk == 0 && progress.cancelRequested()) return stopped(header.file);
    const double here = value(pixel);
    const double share = width > 0.0 && std::isfinite(here) ? (here * 0.5 - lowest * 0.5) / width : 0.0;
    grey[pixel] = static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
  }
  if (notFinite > 0)
    notes.push_back(
        counted<"%1 sample is not a finite number and became 0.", "%1 samples are not finite numbers and became 0.">(notFinite));
  if (rescale && swing.looksLikeRf(lowest, highest)) {
    told.warnings.push_back(say<"The samples swing about 0, as those of radio frequency lines (RF) or of their demodulated parts (IQ) do; "
                                "if they are, the grey "
                                "levels made of them are no brightness: export the B-mode volume instead.">());
    notes.push_back(told.warnings.back());
  }
  if (rescale && width > 0.0)
    notes.push_back(say<"The samples are %1: values from %2 to %3 were mapped to 0 to 255.">(nameOf(header.type), figureText(lowest, 6),
                                                                                             figureText(highest, 6)));
  else if (rescale && lowest <= highest)
    notes.push_back(say<"The samples are %1 and all have the value %2; they became 0.">(nameOf(header.type), figureText(lowest, 6)));
  return {};
}

Result<void> convert(const ImageHeader& header, const std::vector<std::uint8_t>& stored, std::vector<std::uint8_t>& grey, bool rescale,
                     Progress& progress, GreyNotes& notes) {
  switch (header.type) {
    case SampleType::u8:
      return toGrey<std::uint8_t>(header, stored, grey, rescale, progress, notes);
    case SampleType::i8:
      return toGrey<std::int8_t>(header, stored, grey, rescale, progress, notes);
    case SampleType::u16:
      return toGrey<std::uint16_t>(header, stored, grey, rescale, progress, notes);
    case SampleType::i16:
      return toGrey<std::int16_t>(header, stored, grey, rescale, progress, notes);
    case SampleType::u32:
      return toGrey<std::uint32_t>(header, stored, grey, rescale, progress, notes);
    case SampleType::i32:
      return toGrey<std::int32_t>(header, stored, grey, rescale, progress, notes);
    case SampleType::u64:
      return toGrey<std::uint64_t>(header, stored, grey, rescale, progress, notes);
    case SampleType::i64:
      return toGrey<std::int64_t>(header, stored, grey, rescale, progress, notes);
    case SampleType::f32:
      return toGrey<float>(header, stored, grey, rescale, progress, notes);
    case SampleType::f64:
      return toGrey<double>(header, stored, grey, rescale, progress, notes);
    case SampleType::none:
      break;
  }
  return failure(ErrorCode::unsupported, say<"%1 has samples of no known type; export it as 8 bit samples.">(quoted(header.file)));
}

Result<std::vector<std::uint8_t>> readGreyOrThrow(const ImageHeader& header, const SampleRequest& request, const ReaderLimits& limits,
                                                  Progress& progress, GreyNotes& told) {
  std::vector<Message>& notes = told.notes;
  const bool woven = header.wantedChannel.has_value();
  const bool severalValues = header.channels > 1 && !woven;
  if (severalValues && header.channels != 3 && header.channels != 4)
    return failure(ErrorCode::unsupported,
                   say<"%1 has %2 values per sample, but one value or a colour is needed; export the echo levels alone.">(
                       quoted(header.file), header.channels),
                   {{"file", header.file.string()}, {"channels", std::to_string(header.channels)}});
  // Colours have 8 or 16 bits; three numbers with a sign or a point are a vector, as of a motion, and have no luminance.
  if (severalValues && !header.coloursNamed && header.type != SampleType::u8 && header.type != SampleType::u16)
    return failure(
        ErrorCode::unsupported,
        say<"%1 has %2 components of %3 per sample, as vectors of a motion have; they are no echo level and no time steps: export "
            "the echo levels alone.">(quoted(header.file), header.channels, nameOf(header.type)),
        {{"file", header.file.string()}, {"channels", std::to_string(header.channels)}});
  if (const auto sizes = checkSizes(header, request, limits); !sizes) return passOn(sizes.error());
  const std::uint64_t perPixel = header.channels * bytesOf(header.type);
  const std::uint64_t promisedBytes = request.promised * perPixel;
  auto opened = openSamples(header, promisedBytes, progress);
  if (!opened) return passOn(opened.error());
  const auto fits = checkAgainstFile(header, promisedBytes, request.promised * header.channels, opened->packedBytes);
  if (!fits) return passOn(fits.error());

  progress.report(request.what, 0.0);
  std::vector<std::uint8_t> stored = zerosInLargePages(static_cast<std::size_t>(request.pixels * perPixel));
  if (const auto filled = fill(header, *opened->source, stored, request.what, progress); !filled) return passOn(filled.error());
  if (request.pixels == request.promised)
    if (const auto ended = checkEnd(header, *opened->source, promisedBytes, progress, notes); !ended) return passOn(ended.error());

  const bool scaled = header.slope != 1.0 || header.intercept != 0.0;
  if (severalValues) notes.push_back(say<"The samples are colours; their luminance became the echo level.">());
  if (header.type == SampleType::u8 && header.channels == 1 && header.slope > 0.0) {
    if (scaled) notes.push_back(say<"The header's rescaling (slope and intercept) was left out: the 8 bit levels are used as stored.">());
    return stored;
  }
  std::vector<std::uint8_t> grey = zerosInLargePages(static_cast<std::size_t>(request.pixels));
  const bool rescale = header.type != SampleType::u8 || scaled;
  if (const auto converted = convert(header, stored, grey, rescale, progress, told); !converted) return passOn(converted.error());
  return grey;
}

}  // namespace

tl::unexpected<Error> stopped(const std::filesystem::path& file) {
  return failure(ErrorCode::cancelled, say<"Work on %1 was stopped as you asked; nothing was changed.">(quoted(file)),
                 {{"file", file.string()}});
}

Result<std::vector<std::uint8_t>> readGrey(const ImageHeader& header, const SampleRequest& request, const ReaderLimits& limits,
                                           Progress& progress, std::vector<Message>& notes, std::vector<Message>* warnings) {
  try {
    std::vector<Message> unasked;
    GreyNotes told{notes, warnings != nullptr ? *warnings : unasked};
    return readGreyOrThrow(header, request, limits, progress, told);
  } catch (const std::bad_alloc&) {
    return failure(ErrorCode::tooLarge,
                   say<"There is not enough memory for the %1 samples of %2; close other programs, or cut the file into parts.">(
                       request.pixels, quoted(header.file)),
                   {{"file", header.file.string()}});
  }
}

}  // namespace ew::detail
