#include "ew/reports/image_file.h"

#include "ew/io/safe_file.h"

namespace ew {
namespace {

constexpr std::size_t kLargestImage_bytes = 16u << 20;

bool isRegularFile(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(std::filesystem::symlink_status(file, ignored));
}

Result<ImageFile> withItsType(std::string bytes, const std::string& name) {
  constexpr std::string_view kPng("\x89PNG\r\n\x1a\n", 8), kJpeg("\xff\xd8\xff", 3);
  if (bytes.starts_with(kPng)) return ImageFile{"image/png", std::move(bytes)};
  if (bytes.starts_with(kJpeg)) return ImageFile{"image/jpeg", std::move(bytes)};
  return failure(ErrorCode::unsupported, say<"The image '%1' is neither a PNG nor a JPEG file.">(name));
}

}  // namespace

Result<ImageFile> readReportImage(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  if (!isRegularFile(file)) return failure(ErrorCode::notFound, say<"The image '%1' is not in the attempt's folder.">(name));
  auto bytes = readTextFile(file, kLargestImage_bytes);
  if (!bytes) return failure(bytes.error().code, say<"The image '%1' cannot be read, or is too large.">(name));
  return withItsType(std::move(*bytes), name);
}

Result<ImageFile> imageOf(const ReportImage& image) {
  return image.bytes.empty() ? readReportImage(image.file) : withItsType(image.bytes, image.file.filename().string());
}

std::string base64Of(std::string_view bytes) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byteAt = [&](std::size_t n) { return n < bytes.size() ? static_cast<unsigned char>(bytes[n]) : 0u; };
  std::string made;
  made.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t n = 0; n < bytes.size(); n += 3) {
    const unsigned three = byteAt(n) << 16 | byteAt(n + 1) << 8 | byteAt(n + 2);
    made += kLetters[three >> 18];
    made += kLetters[three >> 12 & 63u];
    made += n + 1 < bytes.size() ? kLetters[three >> 6 & 63u] : '=';
    made += n + 2 < bytes.size() ? kLetters[three & 63u] : '=';
  }
  return made;
}

}  // namespace ew
