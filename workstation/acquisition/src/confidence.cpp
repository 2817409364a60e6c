#include "ew/acquisition/confidence.h"

#include <algorithm>
#include <cmath>

#include "clip_spans.h"
#include "ew/core/numbers.h"
#include "ew/core/order_statistics.h"
#include "ew/core/parallel.h"
#include "random_walk.h"

namespace ew {
namespace {

/// The share of lines that may lie in shadow before the row itself counts as dark.
constexpr double kReferenceShare = 0.8;
/// The same for the walkers' probabilities, whose upper end is ragged.
constexpr double kWalkReferenceShare = 0.6;
/// Length of the average along a line, of the depth: longer than speckle, shorter than most shadows.
constexpr double kAlongShare = 0.05;
/// A row whose upper fifth is darker than this tells nothing about single lines.
constexpr float kDarkRow = 8.0F;
/// Where a row is so dark that `shadow_db` would leave nothing, half of its level counts instead.
constexpr double kHalfOfReference = 0.5;
/// Half of the lines averaged across, since one line alone is all speckle.
constexpr int kAcross = 2;

std::size_t indexOf(int x, int y, int width) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

void resize(Image<float>& image, int width, int height) {
  image.width = width;
  image.height = height;
  image.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

Result<void> checkOptions(const ConfidenceOptions& options) {
  struct Range {
    const char* option;
    double found, lowest, highest;
    const char* unit = "";
  };
  for (const Range& range :
       {Range{"dynamicRange_db", options.dynamicRange_db, 10.0, 200.0, " dB"}, Range{"shadow_db", options.shadow_db, 0.1, 100.0, " dB"},
        Range{"lines", static_cast<double>(options.lines), 8.0, 1024.0},
        Range{"samples", static_cast<double>(options.samples), 8.0, 4096.0}, Range{"alpha", options.alpha, 0.0, 20.0},
        Range{"beta", options.beta, 1.0, 1000.0}, Range{"gamma", options.gamma, 0.0, 1.0}})
    if (!(range.found >= range.lowest && range.found <= range.highest))
      return failure(ErrorCode::badField,
                     say<"The confidence option %1 is %2; choose %3 to %4.">(std::string(range.option), textOf(range.found),
                                                                             textOf(range.lowest), textOf(range.highest) + range.unit),
                     {{"field", range.option}});
  return {};
}

/// Mean of a window that is cut at the ends, along columns (rowStep = 1 row) by running sums.
void averageAlongColumns(const Image<float>& from, int half, Image<float>& to) {
  resize(to, from.width, from.height);
  std::vector<double> sums(static_cast<std::size_t>(from.width), 0.0);
  const auto add = [&](int y, double sign) {
    for (int x = 0; x < from.width; ++x)
      sums[static_cast<std::size_t>(x)] += sign * static_cast<double>(from.pixels[indexOf(x, y, from.width)]);
  };
  for (int y = 0; y < std::min(half, from.height); ++y) add(y, 1.0);
  for (int y = 0; y < from.height; ++y) {
    if (y + half < from.height) add(y + half, 1.0);
    if (y - half - 1 >= 0) add(y - half - 1, -1.0);
    const int count = std::min(y + half, from.height - 1) - std::max(y - half, 0) + 1;
    for (int x = 0; x < from.width; ++x)
      to.pixels[indexOf(x, y, from.width)] = static_cast<float>(sums[static_cast<std::size_t>(x)] / count);
  }
}

void averageAcross(const Image<float>& from, int half, Image<float>& to) {
  resize(to, from.width, from.height);
  for (int y = 0; y < from.height; ++y)
    for (int x = 0; x < from.width; ++x) {
      const int first = std::max(x - half, 0), last = std::min(x + half, from.width - 1);
      float sum = 0.0F;
      for (int n = first; n <= last; ++n) sum += from.pixels[indexOf(n, y, from.width)];
      to.pixels[indexOf(x, y, from.width)] = sum / static_cast<float>(last - first + 1);
    }
}

/// The value that a share of the row lies below.
float quantileOfRow(const Image<float>& image, int y, double share, std::vector<float>& sorted) {
  const auto begin = image.pixels.begin() + static_cast<std::ptrdiff_t>(indexOf(0, y, image.width));
  sorted.assign(begin, begin + image.width);
  return valueAtRank(std::span(sorted), static_cast<std::size_t>(share * (image.width - 1) + 0.5));
}

}  // namespace

struct ConfidenceScratch::Memory {
  Image<float> levels, across, along, probability, polarConfidence;
  GreyImage polar;
  std::vector<float> sorted;
  std::vector<float> references;
  RandomWalk walk;
};

ConfidenceScratch::ConfidenceScratch() : memory_(std::make_unique<Memory>()) {}
ConfidenceScratch::~ConfidenceScratch() = default;
ConfidenceScratch::ConfidenceScratch(ConfidenceScratch&&) noexcept = default;
ConfidenceScratch& ConfidenceScratch::operator=(ConfidenceScratch&&) noexcept = default;

namespace {

void beamwise(ImageView<const std::uint8_t> lines, const ConfidenceOptions& options, ConfidenceScratch::Memory& memory,
              Image<float>& confidence) {
  resize(memory.levels, lines.width, lines.height);
  for (int y = 0; y < lines.height; ++y)
    std::transform(lines.row(y), lines.row(y) + lines.width,
                   memory.levels.pixels.begin() + static_cast<std::ptrdiff_t>(indexOf(0, y, lines.width)),
                   [](std::uint8_t level) { return static_cast<float>(level); });
  averageAcross(memory.levels, kAcross, memory.across);
  averageAlongColumns(memory.across, std::max(1, static_cast<int>(0.5 * kAlongShare * lines.height)), memory.along);
  const double levelsPerDecibel = 255.0 / options.dynamicRange_db;
  // Below the last row with echoes nothing is known; the rows above decide.
  std::vector<double> least(static_cast<std::size_t>(lines.width), 1e9);
  for (int y = lines.height - 1; y >= 0; --y) {
    const float reference = quantileOfRow(memory.along, y, kReferenceShare, memory.sorted);
    const double half = std::min(options.shadow_db * levelsPerDecibel, kHalfOfReference * static_cast<double>(reference));
    for (int x = 0; x < lines.width; ++x) {
      double& ratio = least[static_cast<std::size_t>(x)];
      if (reference >= kDarkRow) {
        const auto shortfall = static_cast<double>(reference - memory.along.pixels[indexOf(x, y, lines.width)]);
        ratio = std::min(ratio, std::max(0.0, shortfall / half));
      }
      confidence.pixels[indexOf(x, y, lines.width)] = static_cast<float>(1.0 / (1.0 + std::min(std::pow(ratio, 6.0), 1e6)));
    }
  }
}

/// Block means, so that the graph stays small and speckle does not hold the walkers up.
void shrink(ImageView<const std::uint8_t> lines, int width, int height, Image<float>& to) {
  resize(to, width, height);
  for (int y = 0; y < height; ++y) {
    const int top = y * lines.height / height, bottom = std::max(top + 1, (y + 1) * lines.height / height);
    for (int x = 0; x < width; ++x) {
      const int left = x * lines.width / width, right = std::max(left + 1, (x + 1) * lines.width / width);
      double sum = 0.0;
      for (int v = top; v < bottom; ++v)
        for (int u = left; u < right; ++u) sum += lines.row(v)[u];
      to.pixels[indexOf(x, y, width)] = static_cast<float>(sum / (255.0 * (bottom - top) * (right - left)));
    }
  }
}

Result<void> randomWalk(ImageView<const std::uint8_t> lines, const ConfidenceOptions& options, ConfidenceScratch::Memory& memory,
                        Image<float>& confidence) {
  const int width = std::min(lines.width, options.lines), height = std::min(lines.height, options.samples);
  if (height < 3) {
    std::fill(confidence.pixels.begin(), confidence.pixels.end(), 1.0F);
    return {};
  }
  shrink(lines, width, height, memory.levels);
  if (!memory.walk.solve(memory.levels, {options.alpha, options.beta, options.gamma}, memory.probability))
    return failure(ErrorCode::internal, say<"The confidence of a frame could not be computed; use the beam-wise estimate.">());
  memory.references.resize(static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y)
    memory.references[static_cast<std::size_t>(y)] = quantileOfRow(memory.probability, y, kWalkReferenceShare, memory.sorted);
  const auto relative = [&](int x, int y) {
    const float reference = memory.references[static_cast<std::size_t>(y)];
    const float share = reference > 1e-6F ? std::min(1.0F, memory.probability.pixels[indexOf(x, y, width)] / reference) : 1.0F;
    return share * share / (share * share + (1.0F - share) * (1.0F - share));
  };
  // Rows next to the last one hold next to nothing, and the quotient of two such numbers says nothing: the last one that does stands for
  // it.
  const int lastRow = std::max(1, height - 2);
  for (int y = 0; y < lines.height; ++y) {
    const double v = std::clamp((y + 0.5) * height / lines.height - 0.5, 0.0, static_cast<double>(lastRow));
    const int v0 = std::min(static_cast<int>(v), lastRow - 1);
    const auto fv = static_cast<float>(v - v0);
    for (int x = 0; x < lines.width; ++x) {
      const double u = std::clamp((x + 0.5) * width / lines.width - 0.5, 0.0, static_cast<double>(width - 1));
      const int u0 = std::min(static_cast<int>(u), width - 2);
      const auto fu = static_cast<float>(u - u0);
      const float upper = (1.0F - fu) * relative(u0, v0) + fu * relative(u0 + 1, v0);
      const float lower = (1.0F - fu) * relative(u0, v0 + 1) + fu * relative(u0 + 1, v0 + 1);
      confidence.pixels[indexOf(x, y, lines.width)] = (1.0F - fv) * upper + fv * lower;
    }
  }
  return {};
}

/// A fan's pixels and scan lines: line l of `lines` at an angle, sample s at a radius.
struct Polar {
  ClipFan fan;
  int lines = 0;
  int samples = 0;

  [[nodiscard]] double left_rad() const { return std::min(fan.leftAngle_rad, fan.rightAngle_rad); }
  [[nodiscard]] double right_rad() const { return std::max(fan.leftAngle_rad, fan.rightAngle_rad); }
  [[nodiscard]] glm::dvec2 pixelAt(int line, int sample) const {
    const double angle = left_rad() + (right_rad() - left_rad()) * line / (lines - 1);
    const double radius = fan.startRadius_px + (fan.stopRadius_px - fan.startRadius_px) * sample / (samples - 1);
    return fan.origin_px + radius * glm::dvec2(std::sin(angle), std::cos(angle));
  }
  [[nodiscard]] glm::dvec2 lineAndSampleAt(int x, int y) const {
    const glm::dvec2 from = glm::dvec2(x, y) - fan.origin_px;
    return {(std::atan2(from.x, from.y) - left_rad()) / (right_rad() - left_rad()) * (lines - 1),
            (glm::length(from) - fan.startRadius_px) / (fan.stopRadius_px - fan.startRadius_px) * (samples - 1)};
  }
};

/// As many lines as there are pixels along the middle arc and samples as pixels along a line, each within sensible limits.
Polar polarOf(ClipFan fan, const ClipRectangle& rectangle) {
  const double farthest = std::hypot(std::max(std::abs(rectangle.left - fan.origin_px.x), std::abs(rectangle.right - fan.origin_px.x)),
                                     std::abs(rectangle.bottom - fan.origin_px.y));
  fan.stopRadius_px = std::min(fan.stopRadius_px, farthest);
  fan.startRadius_px = std::clamp(fan.startRadius_px, 0.0, fan.stopRadius_px - 2.0);
  const double arc = 0.5 * (fan.startRadius_px + fan.stopRadius_px) * std::abs(fan.rightAngle_rad - fan.leftAngle_rad);
  return {fan, std::clamp(static_cast<int>(arc / 2.0), 16, 256),
          std::clamp(static_cast<int>(fan.stopRadius_px - fan.startRadius_px), 16, 512)};
}

/// A frame without echoes: the probe is off the body.
bool isDark(const ImageView<const std::uint8_t>& lines) {
  std::size_t bright = 0;
  for (int y = 0; y < lines.height; ++y)
    bright += static_cast<std::size_t>(
        std::count_if(lines.row(y), lines.row(y) + lines.width, [](std::uint8_t level) { return static_cast<float>(level) >= kDarkRow; }));
  return 100 * bright < static_cast<std::size_t>(lines.width) * static_cast<std::size_t>(lines.height);
}

std::uint8_t levelOf(float confidence) { return static_cast<std::uint8_t>(std::clamp(confidence, 0.0F, 1.0F) * 255.0F + 0.5F); }

}  // namespace

Result<void> confidenceOfLines(ImageView<const std::uint8_t> lines, const ConfidenceOptions& options, ConfidenceScratch& scratch,
                               Image<float>& confidence) {
  if (auto checked = checkOptions(options); !checked) return checked;
  if (lines.width < 2 || lines.height < 2)
    return failure(ErrorCode::badField,
                   say<"A confidence map needs at least 2 scan lines of 2 samples; this frame has %1 x %2.">(lines.width, lines.height),
                   {{"field", "size"}});
  resize(confidence, lines.width, lines.height);
  if (isDark(lines)) {
    std::fill(confidence.pixels.begin(), confidence.pixels.end(), 0.0F);
    return {};
  }
  if (options.method == ConfidenceMethod::randomWalk) return randomWalk(lines, options, scratch.memory(), confidence);
  beamwise(lines, options, scratch.memory(), confidence);
  return {};
}

Result<void> confidenceOfFrame(ImageView<const std::uint8_t> frame, const Clip& clip, const ConfidenceOptions& options,
                               ConfidenceScratch& scratch, Image<std::uint8_t>& confidence) {
  const auto spans = ClipSpans::of(clip, frame.width, frame.height);
  if (!spans) return passOn(spans.error());
  ConfidenceScratch::Memory& memory = scratch.memory();
  confidence = Image<std::uint8_t>(frame.width, frame.height);
  if (!clip.fan) {
    const int left = spans->firstColumn(), top = spans->firstRow();
    int right = left;
    for (int y = top; y <= spans->lastRow(); ++y)
      for (const Span& span : spans->row(y)) right = std::max(right, span.end);
    const ImageView<const std::uint8_t> inside{frame.row(top) + left, right - left, spans->lastRow() - top + 1, frame.stride};
    if (auto done = confidenceOfLines(inside, options, scratch, memory.polarConfidence); !done) return done;
    for (int y = 0; y < inside.height; ++y)
      for (int x = 0; x < inside.width; ++x)
        confidence.pixels[indexOf(left + x, top + y, frame.width)] = levelOf(memory.polarConfidence.pixels[indexOf(x, y, inside.width)]);
    return {};
  }
  const Polar polar = polarOf(*clip.fan, spans->rectangle());
  memory.polar = GreyImage(polar.lines, polar.samples);
  for (int sample = 0; sample < polar.samples; ++sample)
    for (int line = 0; line < polar.lines; ++line) {
      const glm::dvec2 at = polar.pixelAt(line, sample);
      const int x = static_cast<int>(std::clamp(at.x + 0.5, 0.0, frame.width - 1.0));
      const int y = static_cast<int>(std::clamp(at.y + 0.5, 0.0, frame.height - 1.0));
      memory.polar.pixels[indexOf(line, sample, polar.lines)] = frame.row(y)[x];
    }
  if (auto done = confidenceOfLines(viewOf(std::as_const(memory.polar)), options, scratch, memory.polarConfidence); !done) return done;
  for (int y = spans->firstRow(); y <= spans->lastRow(); ++y)
    for (const Span& span : spans->row(y))
      for (int x = span.begin; x < span.end; ++x) {
        const glm::dvec2 at = polar.lineAndSampleAt(x, y);
        const int line = static_cast<int>(std::clamp(at.x + 0.5, 0.0, polar.lines - 1.0));
        const int sample = static_cast<int>(std::clamp(at.y + 0.5, 0.0, polar.samples - 1.0));
        confidence.pixels[indexOf(x, y, frame.width)] = levelOf(memory.polarConfidence.pixels[indexOf(line, sample, polar.lines)]);
      }
  return {};
}

Result<std::vector<Image<std::uint8_t>>> confidenceOfFrames(std::span<const TrackedFrame> frames, const Clip& clip,
                                                            const ConfidenceOptions& options, int threads, Progress& progress) {
  std::vector<Image<std::uint8_t>> maps(frames.size());
  std::vector<ConfidenceScratch> scratch(static_cast<std::size_t>(threadCount(threads)));
  std::vector<std::optional<Error>> problems(frames.size());
  const bool finished =
      forEachTask(static_cast<int>(frames.size()), threads, progress, say<"Estimating confidence">(), [&](int n, int worker, const auto&) {
        const auto at = static_cast<std::size_t>(n);
        if (auto done = confidenceOfFrame(frames[at].pixels, clip, options, scratch[static_cast<std::size_t>(worker)], maps[at]); !done)
          problems[at] = done.error();
      });
  for (auto& problem : problems)
    if (problem) return passOn(std::move(*problem));
  if (!finished) return failure(ErrorCode::cancelled, say<"Estimating the confidence was stopped.">());
  return maps;
}

}  // namespace ew
