#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "ew/core/result.h"
#include "ew/reports/report_document.h"

namespace ew {

struct ImageFile {
  std::string mediaType;  ///< "image/png" or "image/jpeg"
  std::string bytes;
};
/// A stored image as it lies there, up to 16 MiB. What its first bytes do not say is a PNG or JPEG is none; a link is not followed, for
/// it may lead to what is not the attempt's.
/// @error notFound, notReadable, tooLarge, unsupported: the sentence names the file without its folder
[[nodiscard]] Result<ImageFile> readReportImage(const std::filesystem::path& file);

/// That of a report: its bytes, or else its file. @error as readReportImage
[[nodiscard]] Result<ImageFile> imageOf(const ReportImage& image);

/// RFC 4648, with padding.
[[nodiscard]] std::string base64Of(std::string_view bytes);

}  // namespace ew
