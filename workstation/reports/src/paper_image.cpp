#include "paper_image.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "ew/library/plain_image.h"

namespace ew::reports {
namespace {

constexpr double kMostPixels = 64e6;

unsigned byteAt(std::string_view bytes, std::size_t at) { return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0u; }
unsigned twoAt(std::string_view bytes, std::size_t at) { return byteAt(bytes, at) << 8 | byteAt(bytes, at + 1); }

/// Of the header chunk, which is the first one.
std::optional<glm::dvec2> sizeOfPng(std::string_view bytes) {
  constexpr std::size_t kWidth = 16, kHeight = 20;
  const auto fourAt = [&](std::size_t at) { return 65536.0 * twoAt(bytes, at) + twoAt(bytes, at + 2); };
  if (bytes.size() < kHeight + 4) return {};
  return glm::dvec2(fourAt(kWidth), fourAt(kHeight));
}

/// Of the frame header (ITU-T T.81, B.2.2).
std::optional<glm::dvec2> sizeOfJpeg(std::string_view bytes) {
  for (std::size_t at = 2; at + 9 < bytes.size();) {
    const unsigned kind = byteAt(bytes, at + 1);
    if (byteAt(bytes, at) != 0xFFu) return {};
    if (kind == 0xFFu) {  // may be filled up
      ++at;
      continue;
    }
    const bool isFrame = kind >= 0xC0u && kind <= 0xCFu && kind != 0xC4u && kind != 0xC8u && kind != 0xCCu;
    if (isFrame) return glm::dvec2(twoAt(bytes, at + 7), twoAt(bytes, at + 5));
    at += 2 + twoAt(bytes, at + 2);
  }
  return {};
}

struct Reading {
  std::string_view rest;
};
cairo_status_t readOn(void* reading, unsigned char* data, unsigned int length) {
  std::string_view& rest = static_cast<Reading*>(reading)->rest;
  if (rest.size() < length) return CAIRO_STATUS_READ_ERROR;
  std::memcpy(data, rest.data(), length);
  rest.remove_prefix(length);
  return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t* surfaceOfPng(std::string_view bytes) {
  Reading reading{bytes};
  return cairo_image_surface_create_from_png_stream(readOn, &reading);
}

/// Empty pixels that carry the file: cairo writes that and not them.
cairo_surface_t* surfaceOfJpeg(std::string_view bytes, const glm::dvec2& size) {
  cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(size.x), static_cast<int>(size.y));
  auto* copy = new std::string(bytes);
  const auto forget = [](void* text) { delete static_cast<std::string*>(text); };
  if (cairo_surface_set_mime_data(surface, CAIRO_MIME_TYPE_JPEG, reinterpret_cast<const unsigned char*>(copy->data()), copy->size(), forget,
                                  copy) != CAIRO_STATUS_SUCCESS)
    forget(copy);
  return surface;
}

}  // namespace

Result<PaperImage> paperImage(const ImageFile& file, const std::string& name) {
  const auto damaged = [&] { return failure(ErrorCode::badHeader, say<"The image '%1' is damaged.">(name)); };
  std::string ending;
  const auto bytes = plainImage(file.bytes, ending);  // nobody looks for names and places in a printed image
  if (!bytes) return damaged();
  const bool isPng = ending == ".png";
  const auto size = isPng ? sizeOfPng(*bytes) : sizeOfJpeg(*bytes);
  if (!size || size->x < 1.0 || size->y < 1.0 || size->x * size->y > kMostPixels) return damaged();
  const std::shared_ptr<cairo_surface_t> surface(isPng ? surfaceOfPng(*bytes) : surfaceOfJpeg(*bytes, *size), cairo_surface_destroy);
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) return damaged();
  return PaperImage{surface, *size};
}

}  // namespace ew::reports
