#include "ew/io/retention.h"

#include <cmath>
#include <string>

#include "ew/core/numbers.h"
#include "files/image_header.h"

namespace ew {
namespace {

bool isSmallPart(std::uint64_t kept, std::uint64_t of) {
  return of > 0 && static_cast<double>(kept) < kLeastKeptShare * static_cast<double>(of);
}

}  // namespace

Message questionAbout(const Retention& kept, const std::filesystem::path& name) {
  if (isSmallPart(kept.pixels, kept.pixelsOf)) {
    const double percent = 100.0 * static_cast<double>(kept.pixels) / static_cast<double>(kept.pixelsOf);
    // Two digits that count: 0.083 % is not 0.1 %.
    const double scale = percent > 0.0 ? std::pow(10.0, 1.0 - std::floor(std::log10(percent))) : 1.0;
    return say<
        "Only %1 % of the pixels of each image of %2 would be kept; check clip, fan, region and depth, or say that so little is "
        "meant.">(textOf(std::round(percent * scale) / scale), detail::quoted(name));
  }
  if (isSmallPart(kept.frames, kept.framesOf))
    return say<"Only %1 of the %2 frames of %3 would be used; check their poses and times, or say that so few are meant.">(
        kept.frames, kept.framesOf, detail::quoted(name));
  return {};
}

Result<void> checkKept(const Retention& kept, bool accepted, const std::filesystem::path& name) {
  if (accepted) return {};
  Message question = questionAbout(kept, name);
  if (question.empty()) return {};
  return failure(ErrorCode::unsupported, std::move(question), {{"file", name.string()}, {"ask", "accept-small"}});
}

}  // namespace ew
