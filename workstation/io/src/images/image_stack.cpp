#include "ew/io/image_stack.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>

#include "dicom/dicom_pixels.h"
#include "dicom/stack_image.h"
#include "ew/core/file_errors.h"
#include "ew/core/numbers.h"
#include "ew/io/orientation.h"
#include "files/content_kind.h"
#include "files/grey_samples.h"
#include "files/header_fields.h"
#include "files/image_header.h"
#include "images/png_pixels.h"

namespace ew {
namespace {
using namespace detail;
namespace fs = std::filesystem;

constexpr std::uint64_t kMostStackPixels = 1ull << 28;
constexpr std::uint64_t kLargestFile = 256u << 20;

bool isImage(const fs::path& file) {
  const std::string ending = lowerCase(file.extension().string());
  return ending == ".png" || ending == ".jpg" || ending == ".jpeg" || ending == ".pgm";
}

/// A name taken apart at its last number.
struct Numbered {
  std::string before;
  std::string digits;
  std::string after;
};
Numbered numbered(const std::string& name) {
  const std::size_t last = name.find_last_of("0123456789");
  if (last == std::string::npos) return {name, "", ""};
  const std::size_t before = name.find_last_not_of("0123456789", last);
  const std::size_t first = before == std::string::npos ? 0 : before + 1;
  return {name.substr(0, first), name.substr(first, last - first + 1), name.substr(last + 1)};
}

/// By their numbers, "2" before "10", then by name.
bool earlier(const fs::path& a, const fs::path& b) {
  const Numbered x = numbered(a.filename().string()), y = numbered(b.filename().string());
  if (x.before != y.before) return x.before < y.before;
  const auto significant = [](const std::string& digits) {
    const std::size_t first = digits.find_first_not_of('0');
    return first == std::string::npos ? std::string() : digits.substr(first);
  };
  const std::string n = significant(x.digits), m = significant(y.digits);
  if (n.size() != m.size()) return n.size() < m.size();
  if (n != m) return n < m;
  return a.filename() < b.filename();
}

tl::unexpected<Error> damaged(const fs::path& file, const Message& why) {
  return failure(ErrorCode::badHeader, say<"%1 is not an image that can be read (%2); save it again.">(quoted(file), why),
                 {{"file", file.string()}});
}

Result<JpegGrey> readPngImage(Bytes bytes, const fs::path& file) {
  auto png = readPngPixels(bytes, file, kMostStackPixels);
  if (!png) return passOn(png.error());
  JpegGrey image;
  image.width = png->width;
  image.height = png->height;
  if (!png->inColour) {
    image.level = std::move(png->samples);
    return image;
  }
  const std::size_t pixels = png->samples.size() / 3;
  image.level.resize(pixels);
  image.coloured.resize(pixels);
  for (std::size_t n = 0; n < pixels; ++n) {
    const std::uint8_t r = png->samples[3 * n], g = png->samples[3 * n + 1], b = png->samples[3 * n + 2];
    image.level[n] = luminanceOf(r, g, b);
    image.coloured[n] = std::max({r, g, b}) - std::min({r, g, b}) > FrameReader::kColourStep ? 1 : 0;
  }
  return image;
}

/// Portable grey map, binary, 8 bits.
Result<JpegGrey> readPgm(Bytes bytes, const fs::path& file) {
  std::size_t at = 2;
  const auto number = [&]() -> std::optional<std::uint64_t> {
    while (at < bytes.size() && (bytes[at] == ' ' || (bytes[at] >= '\t' && bytes[at] <= '\r') || bytes[at] == '#')) {
      if (bytes[at] == '#')
        while (at < bytes.size() && bytes[at] != '\n') ++at;
      else
        ++at;
    }
    std::uint64_t value = 0;
    const std::size_t first = at;
    while (at < bytes.size() && bytes[at] >= '0' && bytes[at] <= '9' && at - first < 9) value = value * 10 + (bytes[at++] - '0');
    return at == first ? std::nullopt : std::optional(value);
  };
  if (bytes.size() < 8 || bytes[0] != 'P' || bytes[1] != '5') return damaged(file, say<"no binary PGM">());
  const auto width = number(), height = number(), largest = number();
  if (!width || !height || !largest || *width < 1 || *height < 1 || *largest != 255 || *width * *height > kMostStackPixels)
    return damaged(file, say<"no 8 bit PGM">());
  ++at;
  const std::size_t pixels = *width * *height;
  if (at > bytes.size() || bytes.size() - at < pixels) return damaged(file, say<"it ends early">());
  JpegGrey image;
  image.width = static_cast<int>(*width);
  image.height = static_cast<int>(*height);
  const Bytes samples = bytes.subspan(at, pixels);
  image.level.assign(samples.begin(), samples.end());
  return image;
}

/// What an image's own header can say beside what is read of it.
constexpr std::array kImageFields{
    FieldTableRow{"pHYs", FieldTouches::geometry}, FieldTableRow{"JFIF density", FieldTouches::geometry},
    FieldTableRow{"gAMA", FieldTouches::levels},   FieldTableRow{"iCCP", FieldTouches::levels},
    FieldTableRow{"acTL", FieldTouches::count},
};

/// Chunks of a PNG, or the density of a JPEG, that state something a stack does not use.
std::vector<Message> unusedOf(Bytes file) {
  HeaderFields fields(kImageFields);
  const auto number = [&](std::size_t at, std::size_t bytes) {
    std::uint32_t value = 0;
    for (std::size_t n = 0; n < bytes; ++n) value = value << 8 | file[at + n];
    return value;
  };
  constexpr std::string_view png = "\x89PNG\r\n\x1A\n";
  if (file.size() > png.size() && std::equal(png.begin(), png.end(), reinterpret_cast<const char*>(file.data()))) {
    for (std::size_t at = png.size(); file.size() - at >= 12;) {
      const std::uint32_t length = number(at, 4);
      const std::string name(reinterpret_cast<const char*>(file.data()) + at + 4, 4);
      if (name == "IDAT" || length > file.size() - at - 12) break;
      if (name == "pHYs" && length == 9)
        fields.meet(
            name, std::to_string(number(at + 8, 4)) + " x " + std::to_string(number(at + 12, 4)) + (file[at + 16] == 1 ? " a metre" : ""));
      else if (name == "gAMA" && length == 4)
        fields.meet(name, textOf(number(at + 8, 4) / 100000.0));
      else if (name == "acTL" && length == 8)
        fields.meet(name, std::to_string(number(at + 8, 4)));
      else if (name == "iCCP")
        fields.meet(name, "...");
      at += 12 + length;
    }
  } else if (file.size() > 18 && number(0, 4) == 0xFFD8FFE0u && number(6, 4) == 0x4A464946u) {
    const std::uint32_t unit = file[13], across = number(14, 2), down = number(16, 2);
    // Without a unit it is a shape; 72 and 96 an inch are what programs write when they know no better.
    if (unit == 0 ? across != down : across != down || (across != 72 && across != 96 && across > 1))
      fields.meet("JFIF density", std::to_string(across) + " x " + std::to_string(down) +
                                      (unit == 1   ? " an inch"
                                       : unit == 2 ? " a cm"
                                                   : ""));
  }
  return fields.unused();
}

/// An image as its camera says that it is to be seen.
void putUpright(JpegGrey& image, const Orientation& orientation) {
  if (orientation.isUpright()) return;
  std::vector<std::uint8_t> upright;
  for (std::vector<std::uint8_t>* plane : {&image.level, &image.coloured}) {
    if (plane->empty()) continue;
    ew::putUpright(*plane, image.width, image.height, orientation, upright);
    plane->swap(upright);
  }
  if (orientation.swapsSides()) std::swap(image.width, image.height);
}

}  // namespace

Result<JpegGrey> detail::readStackImage(const fs::path& file, const Progress& progress) {
  if (const auto fits = checkContent(file); !fits) return passOn(fits.error());
  const auto bytes = readWholeFile(file, kLargestFile);
  if (!bytes) return passOn(bytes.error());
  const std::string ending = lowerCase(file.extension().string());
  auto image = ending == ".png"   ? readPngImage(*bytes, file)
               : ending == ".pgm" ? readPgm(*bytes, file)
                                  : readJpeg(*bytes, file, kMostStackPixels, progress);
  if (image) putUpright(*image, orientationOfImage(*bytes));
  return image;
}

double detail::pixelAspectOfImage(const fs::path& file) {
  const auto bytes = readWholeFile(file, kLargestFile);
  if (!bytes) return 1.0;
  const double stored = pixelAspectOfPng(*bytes);
  return orientationOfImage(*bytes).swapsSides() ? 1.0 / stored : stored;
}

Result<void> detail::settleStackColours(std::uint64_t colouredPixels, std::uint64_t pixels, ColourRule rule, const fs::path& named,
                                        std::vector<Message>& notes) {
  const double share = static_cast<double>(colouredPixels) / static_cast<double>(pixels);
  const std::string coloured = textOf(std::round(share * 10000.0) / 100.0) + " %";
  if (share > 0.0005 && rule == ColourRule::ask)
    return failure(ErrorCode::unsupported,
                   say<"In %1 %2 of the pixels are coloured, as by Doppler, and echo levels cannot show that; say whether to keep them as "
                       "grey or to drop them.">(quoted(named), coloured),
                   {{"file", named.string()}, {"ask", "colour"}});
  if (colouredPixels > 0)
    notes.push_back(rule == ColourRule::dropColour
                        ? say<"%1 of the pixels are coloured; they were made black.">(coloured)
                        : say<"%1 of the pixels are coloured; their luminance became the echo level.">(coloured));
  return {};
}

Result<std::vector<fs::path>> stackFiles(const fs::path& folderOrImage) {
  std::error_code ec;
  const bool folder = fs::is_directory(folderOrImage, ec);
  if (!folder)
    if (const auto status = checkIsFile(folderOrImage); !status) return passOn(status.error());
  const fs::path where = folder ? folderOrImage : folderOrImage.has_parent_path() ? folderOrImage.parent_path() : fs::path(".");
  const Numbered like = numbered(folderOrImage.filename().string());
  std::vector<fs::path> files;
  fs::directory_iterator entries(where, ec);
  if (ec) return notListed(where, ec.value());
  for (const auto& entry : entries) {
    if (!isImage(entry.path()) || !entry.is_regular_file(ec)) continue;
    const Numbered here = numbered(entry.path().filename().string());
    if (folder || (!like.digits.empty() ? here.before == like.before && here.after == like.after && !here.digits.empty()
                                        : entry.path().filename() == folderOrImage.filename()))
      files.push_back(entry.path());
  }
  if (files.empty())
    return failure(ErrorCode::unsupported, say<"%1 holds no images (.png, .jpg, .pgm); choose a folder that does.">(quoted(folderOrImage)),
                   {{"file", folderOrImage.string()}});
  std::sort(files.begin(), files.end(), earlier);
  return files;
}

Result<StackImage> readFirstOfStack(const fs::path& folderOrImage) try {
  const auto files = stackFiles(folderOrImage);
  if (!files) return passOn(files.error());
  auto image = readStackImage(files->front(), noProgress());
  if (!image) return passOn(image.error());
  StackImage first;
  first.level.width = image->width;
  first.level.height = image->height;
  first.level.pixels = std::move(image->level);
  first.coloured = std::move(image->coloured);
  return first;
} catch (const std::bad_alloc&) {
  return failure(ErrorCode::tooLarge, say<"There is not enough memory for an image of %1; close other programs.">(quoted(folderOrImage)),
                 {{"file", folderOrImage.string()}});
}

Result<StackVolume> readImageStack(const fs::path& folderOrImage, const StackOptions& options, Progress& progress,
                                   const ReaderLimits& limits) try {
  const auto files = stackFiles(folderOrImage);
  if (!files) return passOn(files.error());
  if (const auto fits = checkContent(files->front()); !fits) return passOn(fits.error());
  if (!options.spacing_mm)
    return failure(ErrorCode::missingCalibration,
                   say<"Images do not say how large a pixel is and how far apart they lie; give the spacing in mm.">(),
                   {{"file", folderOrImage.string()}, {"ask", "spacing"}});
  StackVolume made;
  if (const auto first = readWholeFile(files->front(), kLargestFile)) made.notes = unusedOf(*first);
  Volume& volume = made.volume;
  std::uint64_t colouredPixels = 0;
  for (std::size_t n = 0; n < files->size(); ++n) {
    if (progress.cancelRequested()) return stopped(folderOrImage);
    auto image = readStackImage((*files)[n], progress);
    if (!image) return passOn(image.error());
    if (n == 0) {
      volume.grid.dims = {image->width, image->height, static_cast<int>(files->size())};
      volume.grid.spacing_mm = *options.spacing_mm;
      if (auto usable = checkGrid(volume.grid); !usable) return passOn(usable.error());
      if (volume.grid.voxelCount() > limits.maxBytes)
        return failure(ErrorCode::tooLarge,
                       say<"The images would need %1 bytes of memory, but the limit is %2; take fewer or smaller ones.">(
                           volume.grid.voxelCount(), limits.maxBytes),
                       {{"file", folderOrImage.string()}});
      volume.echo.reserve(volume.grid.voxelCount());
    } else if (image->width != volume.grid.dims.x || image->height != volume.grid.dims.y) {
      return failure(ErrorCode::badField,
                     say<"%1 has %2 x %3 pixels, the first image %4 x %5; put images of one size into the folder.">(
                         quoted((*files)[n]), image->width, image->height, volume.grid.dims.x, volume.grid.dims.y),
                     {{"file", (*files)[n].string()}});
    }
    blank(image->coloured, image->width, image->height, options.blank);
    made.removed.pixelsPerFrame = blank(image->level, image->width, image->height, options.blank);
    colouredPixels += static_cast<std::uint64_t>(std::count(image->coloured.begin(), image->coloured.end(), 1));
    if (options.colour == ColourRule::dropColour)
      for (std::size_t p = 0; p < image->coloured.size(); ++p)
        if (image->coloured[p] != 0) image->level[p] = 0;
    volume.echo.insert(volume.echo.end(), image->level.begin(), image->level.end());
    progress.report(say<"Reading images">(), static_cast<double>(n + 1) / static_cast<double>(files->size()));
  }
  made.removed.blanked = options.blank;
  if (auto settled = settleStackColours(colouredPixels, volume.echo.size(), options.colour, folderOrImage, made.notes); !settled)
    return passOn(settled.error());
  made.notes.push_back(say<"%1 images were read in the order of their numbers: x to the right, y down, z from image to image, the "
                           "origin in the first pixel of the first; which way they lie in the patient is not known.">(files->size()));
  made.notes.push_back(say<"Images may have text burned in; check that they name nobody.">());
  return made;
} catch (const std::bad_alloc&) {
  return failure(ErrorCode::tooLarge, say<"There is not enough memory for the images of %1; close other programs.">(quoted(folderOrImage)),
                 {{"file", folderOrImage.string()}});
}

}  // namespace ew
