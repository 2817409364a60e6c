#include "ew/acquisition/screen.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ew/core/contract.h"
#include "ew/core/numbers.h"
#include "ew/core/order_statistics.h"
#include "ew/core/word_table.h"
#include "fan_finder.h"
#include "screen_marks.h"

namespace ew {
namespace {

double areaOf(const PixelRect& rect) { return static_cast<double>(rect.width) * rect.height; }
double commonArea(const PixelRect& a, const PixelRect& b) {
  const int width = std::min(a.x + a.width, b.x + b.width) - std::max(a.x, b.x);
  const int height = std::min(a.y + a.height, b.y + b.height) - std::max(a.y, b.y);
  return width > 0 && height > 0 ? static_cast<double>(width) * height : 0.0;
}

/// The part of a stretch of pixels that lies in an image.
struct Stretch {
  int from = 0, length = 0;
};
Stretch within(long long from, long long length, long long most) {
  const long long begin = std::clamp(from, 0LL, most), end = std::clamp(from + length, begin, most);
  return {static_cast<int>(begin), static_cast<int>(end - begin)};
}
PixelRect within(const PixelRect& rect, int width_px, int height_px) {
  const Stretch across = within(rect.x, rect.width, width_px), down = within(rect.y, rect.height, height_px);
  return {across.from, down.from, across.length, down.length};
}

constexpr double kMostUnderText = 0.05;  ///< of a scan: with more, what was taken for text is still scan

/// The share of the outline under boxes that do not overlap.
double shareUnder(const std::vector<PixelRect>& boxes, const FanOutline& outline, int width_px, int height_px) {
  const GreyImage inside = maskOf(outline, width_px, height_px);
  const auto whole = std::count(inside.pixels.begin(), inside.pixels.end(), std::uint8_t{1});
  std::ptrdiff_t under = 0;
  for (const PixelRect& box : boxes)
    for (int y = box.y; y < box.y + box.height; ++y) {
      const std::uint8_t* const row = viewOf(inside).row(y) + box.x;
      under += std::count(row, row + box.width, std::uint8_t{1});
    }
  return whole == 0 ? 0.0 : static_cast<double>(under) / static_cast<double>(whole);
}

/// Levels by which half of the echoes deviate over time. Five images of a tank have 5, scans that move 12 to 30.
constexpr float kHardlyMoves = 7.0F;

/// Whether half of what a scan shows is as still as text over it: then sharp echoes cannot be told from characters.
bool hardlyMoves(const ScreenStatistics& statistics, const FanOutline& outline) {
  constexpr float kEcho = 16.0F;  // levels above black, which is still in every scan
  if (statistics.frames() < 3) return true;
  const GreyImage inside = maskOf(outline, statistics.width_px(), statistics.height_px());
  const Image<float> mean = statistics.mean(), deviation = statistics.deviation();
  std::vector<float> echoes;
  for (std::size_t n = 0; n < inside.pixels.size(); ++n)
    if (inside.pixels[n] != 0 && mean.pixels[n] > kEcho) echoes.push_back(deviation.pixels[n]);
  if (echoes.empty()) return true;
  return upperMedianOf(std::move(echoes)) < kHardlyMoves;
}

Error badStated(const char* field, Message message) { return {ErrorCode::badField, std::move(message), {{"field", field}}}; }

constexpr double kSameScale = 0.01;  ///< parts whose pixels differ by less have one scale

std::string rounded(double mm) { return textOf(std::round(mm * 1e4) / 1e4); }
bool differ(const PixelScale& a, const PixelScale& b) { return std::abs(a.pixel_mm.x / b.pixel_mm.x - 1.0) > kSameScale; }

/// Of the recording's own scales that of the part where its scan is; the others are those of another size.
struct OwnScale {
  const PixelScale* part = nullptr;
  std::vector<const PixelScale*> others = {};
  bool spansOthers = false;  ///< the outline reaches over a part of another scale
  double covered = 1.0;      ///< share of the outline's box that lies in parts of that scale, or, where there is none, in any part
  PixelRect outlined = {};   ///< the outline's box
};

/// The part that holds the middle of the outline, or the only one there is.
OwnScale ownScaleOf(const ScreenAnalysis& found, const std::optional<FanOutline>& outline) {
  constexpr double kSpans = 0.1;  // of the outline's box: less is how roughly regions are drawn
  OwnScale own;
  if (!outline) {
    if (found.scales.size() == 1) own.part = &found.scales.front();
    return own;
  }
  const auto bounds = outline->bounds_px();
  const glm::dvec2 middle = 0.5 * (bounds[0] + bounds[1]), size = bounds[1] - bounds[0];
  const auto holdsMiddle = [middle](const PixelRect& rect) {
    return middle.x >= rect.x && middle.y >= rect.y && middle.x < rect.x + rect.width && middle.y < rect.y + rect.height;
  };
  for (const PixelScale& part : found.scales)
    if (own.part == nullptr && holdsMiddle(part.rect)) own.part = &part;
  const PixelRect box{static_cast<int>(std::floor(bounds[0].x)), static_cast<int>(std::floor(bounds[0].y)),
                      static_cast<int>(std::ceil(size.x)), static_cast<int>(std::ceil(size.y))};
  own.outlined = box;
  own.covered = 0.0;
  for (const PixelScale& part : found.scales) {
    const bool isOther = own.part != nullptr && differ(part, *own.part);
    if (!isOther) own.covered += commonArea(part.rect, box) / std::max(1.0, areaOf(box));
    if (!isOther) continue;
    own.others.push_back(&part);
    own.spansOthers = own.spansOthers || commonArea(part.rect, box) > kSpans * areaOf(box);
  }
  return own;
}

Message describe(const PixelScale& part) {
  return say<"%1 mm at (%2, %3), %4 x %5 pixels">(numeral(rounded(part.pixel_mm.x)), part.rect.x, part.rect.y, part.rect.width,
                                                  part.rect.height);
}
Message describe(const std::vector<const PixelScale*>& parts) {
  std::vector<Message> each;
  for (const PixelScale* const part : parts) each.push_back(describe(*part));
  return joined(std::move(each), "; ");
}

/// Says so where the outline and the parts whose scale the recording states have little or nothing in common: one of them is wrong.
void noteApart(const ScreenAnalysis& found, const OwnScale& own, std::vector<Message>& notes) {
  constexpr double kLeastCovered = 0.5;
  if (found.scales.empty() || own.outlined == PixelRect{} || (own.part != nullptr && own.covered >= kLeastCovered)) return;
  std::vector<const PixelScale*> all;
  for (const PixelScale& part : found.scales) all.push_back(&part);
  const PixelRect& box = own.outlined;
  const Message outlined = say<"(%1, %2), %3 x %4 pixels">(box.x, box.y, box.width, box.height);
  const auto percent = std::lround(100.0 * std::min(1.0, own.covered));
  if (own.part != nullptr)
    notes.push_back(
        say<"Only %1 % of the scan as outlined, at %2, lies in the part for which the recording states the size of a pixel (%3); check the "
            "outline.">(percent, outlined, describe(*own.part)));
  else if (own.covered > 0.0)
    notes.push_back(
        say<"The recording states the size of a pixel for a part alone (%1), but only %2 % of the scan as outlined, at %3, lies there, so "
            "that this size does not count; check the outline.">(describe(all), percent, outlined));
  else
    notes.push_back(
        say<"The recording states the size of a pixel for a part alone (%1), but the scan as outlined, at %2, lies beside it, so that this "
            "size does not count; check the outline.">(describe(all), outlined));
}

/// What was stated counts before the recording's own scale, and is held against it.
void settleScale(const ScreenAnalysis& found, ScreenGeometry& geometry) {
  const OwnScale own = ownScaleOf(found, geometry.outline);
  if (!own.spansOthers) noteApart(found, own, geometry.notes);
  if (own.part == nullptr) return;
  const double own_mm = own.part->pixel_mm.x;
  const auto shown = [](double mm) { return numeral(rounded(mm)); };
  if (own.spansOthers) {
    if (!geometry.pixel_mm)
      geometry.notes.push_back(
          say<"The outline reaches over parts of the recording whose pixels differ in size (%1; %2), so none of its scales was used; put "
              "the outline around one part, or state the depth.">(describe(*own.part), describe(own.others)));
    return;
  }
  if (!geometry.pixel_mm) {
    geometry.pixel_mm = own_mm;
    geometry.notes.push_back(
        own.others.empty()
            ? say<"The size of a pixel is that of the recording's own scale, %1 mm.">(shown(own_mm))
            : say<"The recording has several scales; the size of a pixel is that of the part where the middle of the scan lies, %1. The "
                  "others: %2. Check that it is the right one.">(describe(*own.part), describe(own.others)));
  } else if (std::abs(*geometry.pixel_mm / own_mm - 1.0) > 0.03) {
    geometry.notes.push_back(
        say<"By the recording's own scale a pixel has %1 mm, by the stated depth or ticks %2 mm; what was stated counts. Check both.">(
            shown(own_mm), shown(*geometry.pixel_mm)));
  }
}

constexpr WordTable<ScreenPartKind, 5> kScreenPartKindWords{{{"text", ScreenPartKind::text},
                                                             {"possible text", ScreenPartKind::possibleText},
                                                             {"outside", ScreenPartKind::outside},
                                                             {"bar", ScreenPartKind::bar},
                                                             {"scale", ScreenPartKind::scale}}};

}  // namespace

const char* nameOf(ScreenPartKind kind) { return wordIn(kScreenPartKindWords, kind); }

ScreenAnalysis findScreen(const ScreenStatistics& statistics, const std::optional<FanOutline>& outline) {
  ScreenAnalysis found;
  found.width_px = statistics.width_px();
  found.height_px = statistics.height_px();
  found.frames = statistics.frames();
  if (outline) {
    found.outline = outline;
    found.quality = 1.0;
  } else if (const auto fit = detail::findFan(statistics)) {
    found.quality = fit->quality;
    if (fit->quality >= kLeastQuality) found.outline = fit->outline;
  }
  if (found.frames < 3)
    found.notes.push_back(say<"Nothing moves in the recording, so scan and screen were told apart by brightness alone; look closely.">());
  if (!found.outline) {
    found.notes.push_back(say<"The outline of the scan was not found; state it in a correction.">());
    return found;
  }
  if (found.quality < kSureQuality)
    found.notes.push_back(
        say<"The outline of the scan was found with doubt; compare it with an image, and correct it where it is wrong.">());
  const float background = detail::backgroundOf(statistics);
  found.ticks = detail::findTicks(statistics, *found.outline, background);
  const auto text = detail::findText(statistics, *found.outline);
  if (shareUnder(text, *found.outline, found.width_px, found.height_px) > kMostUnderText)
    found.notes.push_back(
        say<"Too much of the scan stands still for text over it to be told from echoes; look for text and add its boxes.">());
  else if (!text.empty() && hardlyMoves(statistics, *found.outline)) {
    found.notes.push_back(
        say<"The scan hardly moves, so text over it cannot be told from sharp echoes. Places that may be text, and are kept as they are "
            "until somebody says that they are: %1.">(text.size()));
    for (const PixelRect& rect : text) found.parts.push_back({rect, ScreenPartKind::possibleText});
  } else {
    for (const PixelRect& rect : text) found.parts.push_back({rect, ScreenPartKind::text});
  }
  const auto beside = detail::findBeside(statistics, *found.outline, background, found.ticks);
  found.parts.insert(found.parts.end(), beside.begin(), beside.end());
  return found;
}

Result<ScreenGeometry> corrected(const ScreenAnalysis& found, const ScreenCorrection& correction) {
  ScreenGeometry geometry;
  geometry.width_px = found.width_px;
  geometry.height_px = found.height_px;
  geometry.outline = correction.outline ? correction.outline : found.outline;
  if (geometry.outline) {
    const GreyImage mask = maskOf(*geometry.outline, found.width_px, found.height_px);
    if (!(geometry.outline->depth_px() > 1.0) || std::count(mask.pixels.begin(), mask.pixels.end(), 1) < 64)
      return tl::unexpected(badStated("outline", say<"The stated outline holds no part of the images; correct it.">()));
  }
  const auto usable = [](double mm) { return std::isfinite(mm) && mm > 0.0 && mm < 1e4; };
  for (const auto& [field, value] : {std::pair("depth_mm", correction.depth_mm), std::pair("tick_mm", correction.tick_mm)})
    if (value && !usable(*value)) return tl::unexpected(badStated(field, say<"A stated depth or distance of ticks must be above 0 mm.">()));
  if (correction.tick_mm) {
    if (!found.ticks && !correction.depth_mm)
      return tl::unexpected(
          badStated("tick_mm", say<"The distance of ticks was stated, but none were found; state the depth of the scan instead.">()));
    if (found.ticks) geometry.pixel_mm = *correction.tick_mm / found.ticks->spacing_px;
  }
  if (correction.depth_mm && geometry.outline) {
    const double byDepth = *correction.depth_mm / geometry.outline->depth_px();
    if (geometry.pixel_mm && std::abs(byDepth / *geometry.pixel_mm - 1.0) > 0.03)
      geometry.notes.push_back(
          say<"The stated depth (%1 mm a pixel) and the stated ticks (%2 mm a pixel) do not agree; the depth counts. Check both.">(
              numeral(textOf(std::round(byDepth * 1e4) / 1e4)), numeral(textOf(std::round(*geometry.pixel_mm * 1e4) / 1e4))));
    geometry.pixel_mm = byDepth;
  }
  settleScale(found, geometry);
  if (found.outline && !found.ticks && !geometry.pixel_mm)  // without an outline nobody looked for them
    geometry.notes.push_back(say<"No evenly spaced marks of a depth scale were found; the depth has to be stated.">());
  std::vector<PixelRect> text;
  for (const ScreenPart& part : found.parts) {
    if (part.kind != ScreenPartKind::text) continue;
    const bool isNone = std::any_of(correction.removed.begin(), correction.removed.end(), [&](const PixelRect& removed) {
      return commonArea(part.rect, removed) >= 0.5 * std::min(areaOf(part.rect), areaOf(removed));
    });
    if (!isNone) text.push_back(part.rect);
  }
  for (const PixelRect& rect : correction.added)
    if (const PixelRect inside = within(rect, found.width_px, found.height_px); areaOf(inside) > 0.0) text.push_back(inside);
  geometry.text = detail::withoutOverlap(std::move(text));
  return geometry;
}

ScreenCleaner::ScreenCleaner(const ScreenGeometry& geometry, const CleaningOptions& options) {
  EW_EXPECTS(geometry.outline || options.keepOutside);
  const int width = geometry.width_px, height = geometry.height_px;
  GreyImage inside(width, height, 1);
  if (geometry.outline) inside = maskOf(*geometry.outline, width, height);
  kept_ = {0, 0, width, height};
  if (!options.keepOutside) {
    const auto bounds = geometry.outline->bounds_px();
    const int x = std::max(0, static_cast<int>(std::floor(bounds[0].x))), y = std::max(0, static_cast<int>(std::floor(bounds[0].y)));
    kept_ =
        within({x, y, static_cast<int>(std::ceil(bounds[1].x)) + 1 - x, static_cast<int>(std::ceil(bounds[1].y)) + 1 - y}, width, height);
  }
  mask_ = GreyImage(kept_.width, kept_.height);
  GreyImage under(width, height);
  for (const PixelRect& box : geometry.text)
    for (int y = box.y; y < box.y + box.height; ++y)
      for (int x = box.x; x < box.x + box.width; ++x) viewOf(under).at(x, y) = 1;
  for (int y = 0; y < kept_.height; ++y)
    for (int x = 0; x < kept_.width; ++x) {
      const bool in = viewOf(inside).at(x + kept_.x, y + kept_.y) != 0, text = viewOf(under).at(x + kept_.x, y + kept_.y) != 0;
      viewOf(mask_).at(x, y) = (in || options.keepOutside) && !text ? 1 : 0;
      inside_ += in ? 1 : 0;
      filled_ += in && text ? 1 : 0;
    }
  if (options.fill == TextFill::black) return;
  const auto taken = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < kept_.width && y < kept_.height && viewOf(mask_).at(x, y) != 0 &&
           viewOf(inside).at(x + kept_.x, y + kept_.y) != 0;
  };
  constexpr std::array<glm::ivec2, 4> ways{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
  for (int y = 0; y < kept_.height; ++y)
    for (int x = 0; x < kept_.width; ++x) {
      if (viewOf(under).at(x + kept_.x, y + kept_.y) == 0 || viewOf(inside).at(x + kept_.x, y + kept_.y) == 0) continue;
      Fill fill;
      fill.to = static_cast<std::uint32_t>(y * kept_.width + x);
      float sum = 0.0F;
      for (std::size_t way = 0; way < ways.size(); ++way) {
        glm::ivec2 at(x, y);
        int distance = 0;
        do {
          at += ways[way];
          ++distance;
        } while (at.x >= 0 && at.y >= 0 && at.x < kept_.width && at.y < kept_.height && !taken(at.x, at.y) &&
                 viewOf(inside).at(at.x + kept_.x, at.y + kept_.y) != 0);
        if (!taken(at.x, at.y)) continue;
        fill.from[way] = static_cast<std::uint32_t>(at.y * kept_.width + at.x);
        fill.weight[way] = 1.0F / static_cast<float>(distance);
        sum += fill.weight[way];
      }
      if (sum <= 0.0F) continue;
      for (float& weight : fill.weight) weight /= sum;
      fills_.push_back(fill);
    }
}

void ScreenCleaner::clean(const GreyImage& image, GreyImage& clean) const {
  clean.width = kept_.width;
  clean.height = kept_.height;
  clean.pixels.resize(mask_.pixels.size());
  for (int y = 0; y < kept_.height; ++y) {
    const std::uint8_t* const from = viewOf(image).row(y + kept_.y) + kept_.x;
    const std::uint8_t* const takes = viewOf(mask_).row(y);
    std::uint8_t* const to = viewOf(clean).row(y);
    for (int x = 0; x < kept_.width; ++x) to[x] = takes[x] != 0 ? from[x] : std::uint8_t{0};
  }
  for (const Fill& fill : fills_) {
    float value = 0.0F;
    // Five pixels along the rim, so that one grain of speckle does not become a streak.
    for (std::size_t way = 0; way < 4; ++way) {
      if (fill.weight[way] <= 0.0F) continue;
      const auto across = way < 2 ? static_cast<std::int64_t>(kept_.width) : 1;
      float sum = 0.0F, count = 0.0F;
      for (std::int64_t aside = -2; aside <= 2; ++aside) {
        const std::int64_t at = static_cast<std::int64_t>(fill.from[way]) + aside * across;
        if (at < 0 || at >= static_cast<std::int64_t>(mask_.pixels.size()) || mask_.pixels[static_cast<std::size_t>(at)] == 0) continue;
        sum += clean.pixels[static_cast<std::size_t>(at)];
        count += 1.0F;
      }
      value += fill.weight[way] * (count > 0.0F ? sum / count : 0.0F);
    }
    clean.pixels[fill.to] = static_cast<std::uint8_t>(std::lround(value));
  }
}

}  // namespace ew
