#include "screen_marks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <span>

#include "ew/core/order_statistics.h"

namespace ew::detail {
namespace {

template <class Pixel>
cv::Mat matOf(const Image<Pixel>& image, int type) {
  cv::Mat mat(image.height, image.width, type);
  std::copy(image.pixels.begin(), image.pixels.end(), mat.ptr<Pixel>());
  return mat;
}
cv::Mat matOf(const GreyImage& image) { return matOf(image, CV_8U); }
cv::Mat matOf(const Image<float>& image) { return matOf(image, CV_32F); }

PixelRect rectOf(const cv::Rect& rect) { return {rect.x, rect.y, rect.width, rect.height}; }
cv::Rect rectOf(const PixelRect& rect) { return {rect.x, rect.y, rect.width, rect.height}; }

cv::Rect grown(const cv::Rect& rect, int by, const cv::Size& size) {
  return cv::Rect(rect.x - by, rect.y - by, rect.width + 2 * by, rect.height + 2 * by) & cv::Rect({0, 0}, size);
}

struct Component {
  int label = 0;
  cv::Rect rect;
  int area = 0;
};

std::vector<Component> componentsOf(const cv::Mat& mask, cv::Mat& labels) {
  cv::Mat facts, centres;
  const int count = cv::connectedComponentsWithStats(mask, labels, facts, centres, 8);
  std::vector<Component> found;
  for (int n = 1; n < count; ++n)
    found.push_back({n,
                     {facts.at<int>(n, cv::CC_STAT_LEFT), facts.at<int>(n, cv::CC_STAT_TOP), facts.at<int>(n, cv::CC_STAT_WIDTH),
                      facts.at<int>(n, cv::CC_STAT_HEIGHT)},
                     facts.at<int>(n, cv::CC_STAT_AREA)});
  return found;
}

/// The lowest level with the scan carried on beyond its edge, so that the edge is no rim of a stroke. What is carried on is the median
/// along the edge, so that text across the edge ends where it ends.
cv::Mat carriedOn(const cv::Mat& lowest, const cv::Mat& inside, int reach) {
  // Two pixels within the edge nothing is half scan, half background.
  cv::Mat whole, core, nearest, labels;
  cv::copyMakeBorder(inside, whole, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::erode(whole, whole, cv::getStructuringElement(cv::MORPH_RECT, {5, 5}));
  whole = whole(cv::Rect({1, 1}, inside.size())).clone();
  if (cv::countNonZero(whole) == 0) return lowest.clone();
  cv::erode(whole, core, cv::getStructuringElement(cv::MORPH_RECT, {3, 3}), {-1, -1}, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::distanceTransform(whole == 0, nearest, labels, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
  std::vector<std::uint8_t> level(1 + static_cast<std::size_t>(cv::countNonZero(whole)));
  std::vector<std::uint8_t> along;
  for (int y = 0; y < whole.rows; ++y)
    for (int x = 0; x < whole.cols; ++x) {
      if (whole.at<std::uint8_t>(y, x) == 0 || core.at<std::uint8_t>(y, x) != 0) continue;
      const cv::Rect around = grown({x, y, 1, 1}, reach, whole.size());
      along.clear();
      for (int v = around.y; v < around.br().y; ++v)
        for (int u = around.x; u < around.br().x; ++u)
          if (whole.at<std::uint8_t>(v, u) != 0 && core.at<std::uint8_t>(v, u) == 0) along.push_back(lowest.at<std::uint8_t>(v, u));
      level[static_cast<std::size_t>(labels.at<int>(y, x))] = upperMedianOf(std::span(along));
    }
  cv::Mat result = lowest.clone();
  for (int y = 0; y < whole.rows; ++y)
    for (int x = 0; x < whole.cols; ++x)
      if (whole.at<std::uint8_t>(y, x) == 0)
        result.at<std::uint8_t>(y, x) = std::max(result.at<std::uint8_t>(y, x), level[static_cast<std::size_t>(labels.at<int>(y, x))]);
  return result;
}

/// The mean of a map over the scan around each pixel.
cv::Mat meanInside(const cv::Mat& map, const cv::Mat& inside, int size) {
  cv::Mat mask, values, sums, counts;
  inside.convertTo(mask, CV_32F);
  cv::boxFilter(map.mul(mask), sums, CV_32F, {size, size}, {-1, -1}, false, cv::BORDER_CONSTANT);
  cv::boxFilter(mask, counts, CV_32F, {size, size}, {-1, -1}, false, cv::BORDER_CONSTANT);
  return sums / cv::max(counts, 1.0);
}

constexpr double kCodecNoise = 2.5;  ///< levels by which a codec lets what stands still deviate

/// Thin strokes that stand still and stand out: what text over a scan is made of.
struct Strokes {
  cv::Mat lowest;     ///< over time: a scan that moves is dark here, text is not
  cv::Mat deviation;  ///< over time
  cv::Mat height;     ///< of the lowest above its surroundings, wider than strokes are
  cv::Mat rim;        ///< steepest gradient of the lowest within 2 pixels: text has sharp rims, and a stroke is at most 5 pixels thick
  cv::Mat inside;     ///< the scan
  cv::Mat sure;       ///< 1: a stroke
  cv::Mat weak;       ///< 1: may belong to one
  cv::Mat moving;     ///< mean deviation of the scan around: text is still beside it
};

Strokes strokesOf(const ScreenStatistics& statistics, const FanOutline& outline) {
  Strokes s;
  const int scale = std::max(statistics.width_px(), statistics.height_px());
  s.deviation = matOf(statistics.deviation());
  s.inside = matOf(maskOf(outline, statistics.width_px(), statistics.height_px()));
  // A stroke is at most this thick.
  const int reach = std::clamp(scale / 60, 9, 31) | 1;
  s.lowest = carriedOn(matOf(statistics.lowest()), s.inside, reach);
  const cv::Mat box = cv::getStructuringElement(cv::MORPH_RECT, {reach, reach});
  cv::morphologyEx(s.lowest, s.height, cv::MORPH_TOPHAT, box);
  cv::morphologyEx(s.lowest, s.rim, cv::MORPH_GRADIENT, cv::getStructuringElement(cv::MORPH_RECT, {3, 3}));
  cv::dilate(s.rim, s.rim, cv::getStructuringElement(cv::MORPH_RECT, {5, 5}));
  s.moving = meanInside(s.deviation, s.inside, std::max(31, scale / 16) | 1);
  const cv::Mat still = cv::max(0.25 * s.moving, kCodecNoise);
  const cv::Mat sure = (s.height > 40) & (s.deviation < still);
  const cv::Mat weak = (s.height > 20) & (s.deviation < 3.0 * still);
  // Coloured pixels of a grey scan that stay are graphics however dark (blue has a luminance of 29).
  const cv::Mat coloured = matOf(statistics.colouredShare()), changes = matOf(statistics.activity());
  const cv::Mat hue = (coloured > 0.9F) & (changes < 0.1F) & (s.deviation < 2.0 * still);
  // A colour flow box is coloured too, but it changes and is no stroke.
  cv::Mat broad;
  cv::morphologyEx(hue, broad, cv::MORPH_OPEN, box);
  const cv::Mat thin = hue & ~broad;
  s.sure = (sure | thin) / 255;
  // Only close to what is sure: a few grains of speckle stand still by chance.
  cv::Mat close;
  cv::dilate(s.sure, close, cv::getStructuringElement(cv::MORPH_RECT, {7, 7}));
  s.weak = ((weak | thin) / 255) & close;
  return s;
}

/// Strokes and what hangs together with them.
cv::Mat grownStrokes(const Strokes& s) {
  cv::Mat labels;
  cv::Mat all = s.weak | s.sure;
  const auto components = componentsOf(all, labels);
  std::vector<std::uint8_t> keep(components.size() + 1, 0);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (s.sure.at<std::uint8_t>(y, x) != 0) keep[static_cast<std::size_t>(labels.at<int>(y, x))] = 1;
  for (int y = 0; y < all.rows; ++y)
    for (int x = 0; x < all.cols; ++x) all.at<std::uint8_t>(y, x) = keep[static_cast<std::size_t>(labels.at<int>(y, x))];
  return all;
}

/// Whether a component may be a character or a part of one, by size and by how sharp its rim is.
bool isCharacter(const Component& one, const cv::Mat& labels, const Strokes& s, const FanOutline& outline, int scale) {
  const int highest = std::max(14, scale / 12), widest = std::max(24, scale / 4);
  const int height = one.rect.height, width = one.rect.width;
  if (one.area < 3 || height > highest || width > widest) return false;
  std::vector<float> rims, levels, shakes, around;
  double nearest = 1e9, farthest = -1e9;
  int sure = 0;
  for (int y = one.rect.y; y < one.rect.br().y; ++y)
    for (int x = one.rect.x; x < one.rect.br().x; ++x) {
      if (labels.at<int>(y, x) != one.label) continue;
      rims.push_back(static_cast<float>(s.rim.at<std::uint8_t>(y, x)));
      levels.push_back(static_cast<float>(s.height.at<std::uint8_t>(y, x)));
      shakes.push_back(s.deviation.at<float>(y, x));
      around.push_back(s.moving.at<float>(y, x));
      sure += s.sure.at<std::uint8_t>(y, x);
      const double depth = outline.shape == FanShape::linear ? y : glm::distance(glm::dvec2(x, y), outline.apex_px);
      nearest = std::min(nearest, depth);
      farthest = std::max(farthest, depth);
    }
  // A line on the screen, or one across the beams: an echo of what is the same for all of them.
  if (std::min<double>(height, farthest - nearest + 1.0) < 4.0 && width > 18) return false;
  // Of text a good part is sure; a few sure grains among many that are not are scan.
  if (5 * sure < one.area) return false;
  const auto ranked = [](std::vector<float>& values, std::size_t quarters) {
    std::sort(values.begin(), values.end());
    return values[(values.size() - 1) * quarters / 4];
  };
  // Of a thin stroke most pixels are half text, half scan: the stillest quarter is its middle.
  const float rim = ranked(rims, 2), level = ranked(levels, 2), shake = ranked(shakes, 1), moving = ranked(around, 2);
  // Echoes that do not move are spread by the beam: their rims are slopes.
  return rim > 0.6F * level && shake < std::max(static_cast<float>(kCodecNoise), 0.35F * moving);
}

/// The static part of what lies outside the scan.
cv::Mat standing(const ScreenStatistics& statistics, const FanOutline& outline, float background, int margin) {
  const cv::Mat mean = matOf(statistics.mean()), deviation = matOf(statistics.deviation());
  cv::Mat inside = matOf(maskOf(outline, statistics.width_px(), statistics.height_px()));
  if (margin > 0) cv::dilate(inside, inside, cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * margin + 1, 2 * margin + 1}));
  cv::Mat away;
  cv::absdiff(mean, cv::Scalar(static_cast<double>(background)), away);
  return ((away > 30.0F) & (deviation < 6.0F) & (inside == 0)) / 255;
}

/// The evenly spaced run through most of `ys`: places first + k spacing. Ticks may be hidden, other marks may stand between them.
struct EvenRun {
  double first = 0.0, spacing = 0.0, residual = 0.0;
  std::vector<std::size_t> members;
};
EvenRun bestRun(const std::vector<double>& ys) {
  EvenRun best;
  double bestScore = 0.0;
  for (std::size_t a = 0; a < ys.size(); ++a)
    for (std::size_t b = a + 1; b < std::min(ys.size(), a + 4); ++b) {
      const double rough = ys[b] - ys[a];
      if (rough < 5.0) continue;
      // The spacing of a pair is half a pixel wrong at both ends; it is made better while the run grows.
      double spacing = rough, first = ys[a];
      std::vector<std::pair<double, std::size_t>> members;  // which place, which mark
      double sk = 0, sy = 0, skk = 0, sky = 0;
      for (std::size_t n = a; n < ys.size(); ++n) {
        const double k = std::round((ys[n] - first) / spacing);
        if (std::abs(ys[n] - first - k * spacing) > 1.3 || (!members.empty() && k == members.back().first)) continue;
        if (!members.empty() && k - members.back().first > 4.0) break;
        members.emplace_back(k, n);
        sk += k, sy += ys[n], skk += k * k, sky += k * ys[n];
        const auto count = static_cast<double>(members.size());
        const double turn = count * skk - sk * sk;
        if (turn > 0.0) {
          spacing = (count * sky - sk * sy) / turn;
          first = (sy - spacing * sk) / count;
        }
      }
      if (members.size() < 4) continue;
      const double places = members.back().first - members.front().first + 1.0;
      // Members count, places without a mark count against.
      const double score = static_cast<double>(members.size()) - 0.7 * (places - static_cast<double>(members.size()));
      if (score <= bestScore) continue;
      bestScore = score;
      best = {first + members.front().first * spacing, spacing, 0.0, {}};
      double squares = 0.0;
      for (const auto& [k, n] : members) {
        best.members.push_back(n);
        const double off = ys[n] - first - k * spacing;
        squares += off * off;
      }
      best.residual = std::sqrt(squares / static_cast<double>(members.size()));
    }
  return best;
}

/// Every so many marks of a run are longer; 1: all are alike.
int longerEvery(const std::vector<int>& lengths) {
  if (lengths.size() < 5) return 1;
  const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
  if (*longest < *shortest + 2 || 4 * *longest < 5 * *shortest) return 1;
  const double limit = 0.5 * (*shortest + *longest);
  std::vector<std::size_t> at;
  for (std::size_t n = 0; n < lengths.size(); ++n)
    if (lengths[n] > limit) at.push_back(n);
  if (at.size() < 2) return 1;
  const std::size_t every = at[1] - at[0];
  for (std::size_t n = 1; n < at.size(); ++n)
    if (at[n] - at[n - 1] != every) return 1;
  return static_cast<int>(every);
}

bool overlaps(const PixelRect& a, const PixelRect& b) { return (rectOf(a) & rectOf(b)).area() > 0; }

/// A filled box whose levels run one way along its longer side.
bool isBar(const cv::Mat& mean, const cv::Rect& rect) {
  const bool upright = rect.height > rect.width;
  const int length = std::max(rect.width, rect.height), width = std::min(rect.width, rect.height);
  if (length < 40 || width < 4 || length < 3 * width) return false;
  std::vector<double> levels;
  for (int n = 2; n + 2 < length; ++n) {
    const cv::Mat line = upright ? mean(cv::Rect(rect.x, rect.y + n, rect.width, 1)) : mean(cv::Rect(rect.x + n, rect.y, 1, rect.height));
    levels.push_back(cv::mean(line)[0]);
  }
  double up = 0.0, down = 0.0;
  for (std::size_t n = 1; n < levels.size(); ++n) (levels[n] > levels[n - 1] ? up : down) += std::abs(levels[n] - levels[n - 1]);
  const double run = std::abs(levels.back() - levels.front());
  return run > 60.0 && std::min(up, down) < 0.15 * std::max(up, down);
}

}  // namespace

std::vector<PixelRect> withoutOverlap(std::vector<PixelRect> boxes) {
  for (bool again = true; again;) {
    again = false;
    for (std::size_t a = 0; a < boxes.size() && !again; ++a)
      for (std::size_t b = a + 1; b < boxes.size() && !again; ++b)
        if (overlaps(boxes[a], boxes[b])) {
          boxes[a] = rectOf(rectOf(boxes[a]) | rectOf(boxes[b]));
          boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(b));
          again = true;
        }
  }
  std::sort(boxes.begin(), boxes.end(), [](const PixelRect& a, const PixelRect& b) { return std::pair(a.y, a.x) < std::pair(b.y, b.x); });
  return boxes;
}

std::vector<PixelRect> findText(const ScreenStatistics& statistics, const FanOutline& outline) {
  const int scale = std::max(statistics.width_px(), statistics.height_px());
  const Strokes s = strokesOf(statistics, outline);
  const cv::Mat strokes = grownStrokes(s);
  cv::Mat labels;
  cv::Mat letters = cv::Mat::zeros(strokes.size(), CV_8U);
  for (const Component& one : componentsOf(strokes, labels)) {
    if (!isCharacter(one, labels, s, outline, scale)) continue;
    cv::Mat part = letters(one.rect);
    part.setTo(1, labels(one.rect) == one.label);
  }
  // Letters of a line stand closer than they are high; dots and accents hang on theirs.
  const int gap = std::max(7, scale / 70) | 1;
  cv::Mat lines;
  cv::morphologyEx(letters, lines, cv::MORPH_CLOSE, cv::getStructuringElement(cv::MORPH_RECT, {gap, std::max(3, gap / 3) | 1}));
  std::vector<PixelRect> boxes;
  cv::Mat lineLabels;
  for (const Component& line : componentsOf(lines, lineLabels)) {
    const int ink = cv::countNonZero(letters(line.rect)), sure = cv::countNonZero(letters(line.rect) & s.sure(line.rect));
    const double share = static_cast<double>(ink) / line.rect.area();
    // A small letter is ten sure pixels, or half as many with their soft rims.
    if (ink + sure < 16 || line.rect.height < 5 || share > 0.92) continue;
    const int margin = std::clamp(line.rect.height / 5, 3, 6);
    const cv::Rect box = grown(line.rect, margin, strokes.size());
    if (cv::countNonZero(s.inside(box)) == 0) continue;
    boxes.push_back(rectOf(box));
  }
  return withoutOverlap(std::move(boxes));
}

std::optional<DepthTicks> findTicks(const ScreenStatistics& statistics, const FanOutline& outline, float background) {
  cv::Mat marks = standing(statistics, outline, background, 0);
  // The line that ticks stand on goes; ticks are a few pixels high.
  cv::Mat upright;
  cv::morphologyEx(marks, upright, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_RECT, {1, 13}));
  marks = marks & (upright == 0);
  cv::Mat labels;
  struct Mark {
    int left, right;
    double y;
  };
  std::vector<Mark> found;
  for (const Component& one : componentsOf(marks, labels))
    if (one.rect.height <= 5 && one.rect.width >= 2 && one.rect.width <= 40 && one.area * 10 >= 7 * one.rect.area())
      found.push_back({one.rect.x, one.rect.br().x - 1, one.rect.y + 0.5 * (one.rect.height - 1)});
  std::optional<DepthTicks> best;
  // Aligned at their left or at their right ends.
  for (const bool byLeft : {true, false}) {
    std::map<int, std::vector<Mark>> columns;
    for (const Mark& mark : found) columns[byLeft ? mark.left : mark.right].push_back(mark);
    for (auto& [x, column] : columns) {
      if (column.size() < 4 || column.size() > 500) continue;
      std::sort(column.begin(), column.end(), [](const Mark& a, const Mark& b) { return a.y < b.y; });
      std::vector<double> ys;
      for (const Mark& mark : column) ys.push_back(mark.y);
      const EvenRun run = bestRun(ys);
      // A scale goes along the scan; rows of text do not.
      const double length = run.spacing * static_cast<double>(run.members.size());
      if (run.members.size() < 4 || run.residual > 0.8 || length < 0.3 * outline.depth_px()) continue;
      if (best && static_cast<int>(run.members.size()) <= best->count) continue;
      std::vector<int> lengths;
      for (const std::size_t n : run.members) lengths.push_back(column[n].right - column[n].left + 1);
      best = DepthTicks{static_cast<double>(x), run.first,   run.spacing, static_cast<int>(run.members.size()),
                        longerEvery(lengths),   run.residual};
    }
  }
  return best;
}

std::vector<ScreenPart> findBeside(const ScreenStatistics& statistics, const FanOutline& outline, float background,
                                   const std::optional<DepthTicks>& ticks) {
  const cv::Mat mean = matOf(statistics.mean());
  cv::Mat marks = standing(statistics, outline, background, 3);
  const int scale = std::max(marks.cols, marks.rows), gap = std::max(9, scale / 60) | 1;
  cv::Mat joined, labels;
  cv::morphologyEx(marks, joined, cv::MORPH_CLOSE, cv::getStructuringElement(cv::MORPH_RECT, {gap, std::max(3, gap / 4) | 1}));
  std::vector<ScreenPart> parts;
  std::vector<PixelRect> rest;
  for (const Component& one : componentsOf(joined, labels)) {
    if (one.area < 6) continue;
    const bool filled = one.area * 10 >= 7 * one.rect.area();
    if (filled && isBar(mean, one.rect))
      parts.push_back({rectOf(one.rect), ScreenPartKind::bar});
    else
      rest.push_back(rectOf(one.rect));
  }
  if (ticks) {
    const double end = ticks->first_px + ticks->spacing_px * ticks->count;
    PixelRect scaleRect;
    for (const PixelRect& rect : rest) {
      const double y = rect.y + 0.5 * rect.height;
      const bool there = std::abs(rect.x - ticks->x_px) <= 2.0 || std::abs(rect.x + rect.width - 1 - ticks->x_px) <= 2.0;
      if (!there || y < ticks->first_px - 3.0 || y > end || rect.width > 60) continue;
      scaleRect = scaleRect.width == 0 ? rect : rectOf(rectOf(scaleRect) | rectOf(rect));
    }
    if (scaleRect.width > 0) {
      std::erase_if(rest, [&](const PixelRect& rect) { return (rectOf(rect) & rectOf(scaleRect)).area() == rectOf(rect).area(); });
      parts.push_back({scaleRect, ScreenPartKind::scale});
    }
  }
  for (const PixelRect& rect : withoutOverlap(std::move(rest))) parts.push_back({rect, ScreenPartKind::outside});
  return parts;
}

}  // namespace ew::detail
