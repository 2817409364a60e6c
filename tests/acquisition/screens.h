#pragma once

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>
#include <string>
#include <vector>

#include "ew/acquisition/screen.h"
#include "ew/io/sequence.h"

namespace ew::test {

/// A text as the test drew it.
struct DrawnText {
  std::string text;
  int font = 0;
  double scale = 1.0;
  int thickness = 1;
  int line = cv::LINE_AA;
  cv::Point at;   ///< left end of its base line
  cv::Rect rect;  ///< of its ink
  bool over = false;
};

/// A screen drawn by a test, with what is true of it.
struct DrawnScreen {
  FanOutline truth;
  double pixel_mm = 0.2;
  double tick_mm = 5.0;
  cv::Rect scale;
  cv::Rect bar;
  std::vector<DrawnText> texts;
  std::vector<cv::Mat> frames;  ///< 8 bit, blue green red
  std::vector<cv::Mat> bare;    ///< the same without any text over the scan
};

inline double uniform(std::mt19937& random, double from, double to) { return from + (to - from) * (random() / 4294967296.0); }

/// Two fields of noise whose sum of squares is speckle; a frame takes a piece of each, so that grain moves and changes.
class Speckle {
 public:
  Speckle(int width, int height, unsigned seed) : width_(width), height_(height) {
    cv::RNG random(seed);
    for (cv::Mat* field : {&real_, &imaginary_}) {
      field->create(height + 128, width + 128, CV_32F);
      random.fill(*field, cv::RNG::NORMAL, 0.0, 1.0);
      cv::GaussianBlur(*field, *field, {0, 0}, 2.0, 1.2);
      cv::Scalar mean, deviation;
      cv::meanStdDev(*field, mean, deviation);
      *field /= deviation[0];
    }
  }
  /// Log of the magnitude in decibels, about 0 in the mean.
  [[nodiscard]] cv::Mat decibels(int frame) const {
    const cv::Mat a = real_(cv::Rect(frame * 3 % 128, frame * 2 % 128, width_, height_));
    const cv::Mat b = imaginary_(cv::Rect(frame * 2 % 128, 127 - frame * 3 % 128, width_, height_));
    cv::Mat power = a.mul(a) + b.mul(b) + 1e-4F, log;
    cv::log(power, log);
    return log * (10.0 / std::log(10.0));
  }

 private:
  int width_, height_;
  cv::Mat real_, imaginary_;
};

/// Mean level of the tissue in decibels: cysts, a shadow, less with depth, and none outside.
inline cv::Mat tissue(const FanOutline& fan, const cv::Size& size, std::mt19937& random) {
  cv::Mat level(size, CV_32F, cv::Scalar(-1000.0));
  const auto bounds = fan.bounds_px();
  const glm::dvec2 extent = bounds[1] - bounds[0];
  struct Cyst {
    glm::dvec2 at;
    double radius;
  };
  std::vector<Cyst> cysts;
  for (int n = 0; n < 4; ++n)
    cysts.push_back(
        {bounds[0] + extent * glm::dvec2(uniform(random, 0.2, 0.8), uniform(random, 0.2, 0.9)), uniform(random, 0.03, 0.09) * extent.x});
  const double shadow = uniform(random, 0.2, 0.8), from = uniform(random, 0.3, 0.7), loss = uniform(random, 5.0, 18.0);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const glm::dvec2 p(x, y);
      if (!fan.contains(p)) continue;
      double across, depth;
      if (fan.shape == FanShape::linear) {
        depth = (p.y - fan.corners_px[0].y) / (fan.corners_px[3].y - fan.corners_px[0].y);
        const double left = fan.corners_px[0].x + depth * (fan.corners_px[3].x - fan.corners_px[0].x);
        across = (p.x - left) / (fan.corners_px[1].x - fan.corners_px[0].x);
      } else {
        const glm::dvec2 d = p - fan.apex_px;
        depth = (glm::length(d) - fan.near_px) / (fan.far_px - fan.near_px);
        across = (std::atan2(d.x, d.y) - fan.left_rad) / (fan.right_rad - fan.left_rad);
      }
      double value = -18.0 - loss * depth;
      for (const Cyst& cyst : cysts)
        if (glm::distance(p, cyst.at) < cyst.radius) value -= 40.0;
      if (std::abs(across - shadow) < 0.06 && depth > from) value -= 22.0;
      if (depth < 0.02) value += 12.0;
      level.at<float>(y, x) = static_cast<float>(value);
    }
  return level;
}

/// The scan of one moment as grey levels: 60 dB on 255.
inline cv::Mat scanOf(const cv::Mat& level, const Speckle& speckle, int frame) {
  const cv::Mat sum = level + speckle.decibels(frame);
  cv::Mat grey;
  sum.convertTo(grey, CV_8U, 255.0 / 60.0, 255.0);
  cv::Mat outside = level < -500.0F;
  grey.setTo(0, outside);
  return grey;
}

inline cv::Rect inkOf(const DrawnText& text) {
  int base = 0;
  const cv::Size size = cv::getTextSize(text.text, text.font, text.scale, text.thickness, &base);
  return {text.at.x - 1, text.at.y - size.height - 1, size.width + 2, size.height + base / 2 + 2};
}

inline void draw(cv::Mat& canvas, const DrawnText& text, const cv::Scalar& colour) {
  cv::putText(canvas, text.text, text.at, text.font, text.scale, colour, text.thickness, text.line);
}

/// Texts, scale, bar, logo, and what else a machine puts around a scan.
struct Furniture {
  std::vector<std::pair<DrawnText, cv::Scalar>> texts;
  cv::Rect bar, colourBar, scale;
  double first_px = 0.0, spacing_px = 0.0;
  int ticks = 0, major = 5, x = 0;
  bool ticksToLeft = false;
  bool counter = false, ecg = false;
  int logo = 0;
};

/// @param overScan false: texts over the scan are left out
inline void drawFurniture(cv::Mat& canvas, const Furniture& f, int frame, bool overScan = true) {
  const int width = canvas.cols, height = canvas.rows;
  for (int y = 0; y < f.bar.height; ++y) {
    const int level = 255 - 255 * y / std::max(1, f.bar.height - 1);
    cv::line(canvas, {f.bar.x, f.bar.y + y}, {f.bar.x + f.bar.width - 1, f.bar.y + y}, cv::Scalar(level, level, level));
  }
  // Colour bar: towards the probe red to yellow, away from it blue to cyan, black between them.
  for (int y = 0; y < f.colourBar.height; ++y) {
    const double share = 1.0 - 2.0 * y / std::max(1, f.colourBar.height - 1), strong = 255.0 * std::min(1.0, 1.6 * std::abs(share));
    const double second = 255.0 * std::max(0.0, 2.0 * std::abs(share) - 1.0);
    const cv::Scalar colour = share > 0.0 ? cv::Scalar(0, second, strong) : cv::Scalar(strong, second, 0);
    cv::line(canvas, {f.colourBar.x, f.colourBar.y + y}, {f.colourBar.x + f.colourBar.width - 1, f.colourBar.y + y}, colour);
  }
  for (int n = 0; n < f.ticks; ++n) {
    const int y = static_cast<int>(std::lround(f.first_px + n * f.spacing_px)), length = n % f.major == 0 ? 12 : 6;
    cv::line(canvas, {f.x, y}, {f.ticksToLeft ? f.x - length : f.x + length, y}, cv::Scalar(230, 230, 230));
    if (n % f.major == 0 && n > 0)
      cv::putText(canvas, std::to_string(n / f.major), {f.ticksToLeft ? f.x + 6 : f.x + 16, y + 4}, cv::FONT_HERSHEY_SIMPLEX, 0.35,
                  cv::Scalar(230, 230, 230), 1, cv::LINE_AA);
  }
  if (f.logo == 1) cv::circle(canvas, {width - 40, 36}, 18, cv::Scalar(200, 120, 20), -1, cv::LINE_AA);
  if (f.logo == 2) cv::rectangle(canvas, {width - 70, 12}, {width - 20, 44}, cv::Scalar(30, 160, 240), 3);
  if (f.counter)
    cv::putText(canvas, std::to_string(100 + frame) + "/240", {width - 120, height - 12}, cv::FONT_HERSHEY_SIMPLEX, 0.45,
                cv::Scalar(200, 200, 200), 1, cv::LINE_AA);
  if (f.ecg) {
    std::vector<cv::Point> line;
    for (int x = 20; x < width - 140; x += 2) {
      const double phase = (x + 37 * frame) % 160 / 160.0;
      const double beat = phase > 0.45 && phase < 0.5 ? -22.0 : phase >= 0.5 && phase < 0.53 ? 8.0 : 3.0 * std::sin(6.28 * phase);
      line.emplace_back(x, height - 40 + static_cast<int>(beat));
    }
    cv::polylines(canvas, line, false, cv::Scalar(60, 220, 60), 1, cv::LINE_AA);
  }
  for (const auto& [text, colour] : f.texts)
    if (overScan || !text.over) draw(canvas, text, colour);
}

/// One more moment of a screen.
inline void addFrame(DrawnScreen& screen, const cv::Mat& scan, const Furniture& furniture, int frame) {
  for (const bool overScan : {true, false}) {
    cv::Mat canvas = scan.clone();
    drawFurniture(canvas, furniture, frame, overScan);
    (overScan ? screen.frames : screen.bare).push_back(canvas);
  }
}

/// Texts over the scan, at most so large that their boxes are about half a percent of it, and around it; bar, scale and the rest.
inline Furniture furnish(const FanOutline& fan, const cv::Size& size, double pixel_mm, double tick_mm, std::mt19937& random,
                         bool overScan = true) {
  Furniture f;
  const std::array<int, 7> fonts{cv::FONT_HERSHEY_SIMPLEX,
                                 cv::FONT_HERSHEY_PLAIN,
                                 cv::FONT_HERSHEY_DUPLEX,
                                 cv::FONT_HERSHEY_COMPLEX,
                                 cv::FONT_HERSHEY_TRIPLEX,
                                 cv::FONT_HERSHEY_COMPLEX_SMALL,
                                 cv::FONT_HERSHEY_SIMPLEX | cv::FONT_ITALIC};
  const std::array<cv::Scalar, 5> colours{cv::Scalar(255, 255, 255), cv::Scalar(0, 235, 255), cv::Scalar(90, 255, 90),
                                          cv::Scalar(255, 230, 80), cv::Scalar(210, 210, 210)};
  const auto any = [&](const auto& list) { return list[random() % list.size()]; };
  const auto text = [&](const std::string& words, cv::Point at, double scale, int thickness, bool over) {
    DrawnText one{words, any(fonts), scale, thickness, random() % 3 == 0 ? cv::LINE_8 : cv::LINE_AA, at, {}, over};
    if (one.font == cv::FONT_HERSHEY_PLAIN || one.font == cv::FONT_HERSHEY_COMPLEX_SMALL) one.scale *= 1.5;
    one.rect = inkOf(one);
    return one;
  };
  const GreyImage mask = maskOf(fan, size.width, size.height);
  const auto area = static_cast<double>(std::count(mask.pixels.begin(), mask.pixels.end(), 1));
  const std::array<std::string, 10> words{"MI 1.1", "FR 24", "L", "D 8.2", "Liver", "AC", "Nr 7", "TIS", "45 BPM", "RUQ"};
  double used = 0.0;
  const auto bounds = fan.bounds_px();
  for (int attempt = 0; overScan && attempt < 200 && used < 0.0055 * area; ++attempt) {
    const glm::dvec2 p = bounds[0] + (bounds[1] - bounds[0]) * glm::dvec2(uniform(random, 0.05, 0.9), uniform(random, 0.08, 0.95));
    DrawnText one =
        text(any(words), {static_cast<int>(p.x), static_cast<int>(p.y)}, uniform(random, 0.38, 0.8), random() % 4 == 0 ? 2 : 1, true);
    const cv::Rect grown(one.rect.x - 12, one.rect.y - 12, one.rect.width + 24, one.rect.height + 24);
    if ((grown & cv::Rect({0, 0}, size)) != grown) continue;
    // Inside, or a good part of it: some cross the edge.
    int inside = 0;
    for (int y = one.rect.y; y < one.rect.br().y; ++y)
      for (int x = one.rect.x; x < one.rect.br().x; ++x) inside += viewOf(mask).at(x, y);
    const double box = (one.rect.width + 8.0) * (one.rect.height + 8.0);
    const bool crosses = random() % 5 == 0;
    if (inside < (crosses ? one.rect.area() / 3 : one.rect.area()) || used + box > 0.0075 * area) continue;
    bool free = true;
    for (const auto& [other, colour] : f.texts) free = free && (grown & other.rect).area() == 0;
    if (!free) continue;
    used += box;
    f.texts.emplace_back(one, any(colours));
  }
  const int left = 14;
  for (const auto& [line, y] : {std::pair("DOE, JANE", 24), std::pair("1970-01-31 F", 46), std::pair("St. Elsewhere", 68),
                                std::pair("ABD", 120), std::pair("4.5 MHz", 142), std::pair("G 62%", 164)})
    f.texts.emplace_back(text(line, {left, y}, uniform(random, 0.4, 0.6), 1, false), any(colours));
  // What lies beside must not lie over: drop what meets the scan.
  std::erase_if(f.texts, [&](const auto& entry) {
    const DrawnText& one = entry.first;
    if (one.over) return false;
    const cv::Rect r = cv::Rect(one.rect.x - 4, one.rect.y - 4, one.rect.width + 8, one.rect.height + 8) & cv::Rect({0, 0}, size);
    for (int y = r.y; y < r.br().y; ++y)
      for (int x = r.x; x < r.br().x; ++x)
        if (viewOf(mask).at(x, y) != 0) return true;
    return false;
  });
  f.bar = {size.width - 26, 90, 12, 180};
  f.colourBar = {size.width - 26, 300, 12, 120};
  f.spacing_px = tick_mm / pixel_mm;
  f.x = std::min(size.width - 60, static_cast<int>(bounds[1].x) + 12);
  const double top = fan.shape == FanShape::linear ? fan.corners_px[0].y : fan.apex_px.y + fan.near_px;
  f.first_px = std::max(4.0, top);
  f.ticks = 1 + static_cast<int>(fan.depth_px() / f.spacing_px);
  f.major = random() % 2 == 0 ? 5 : 2;
  f.ticksToLeft = random() % 2 == 0;
  f.counter = random() % 2 == 0;
  f.ecg = random() % 3 == 0;
  f.logo = static_cast<int>(random() % 3);
  return f;
}

/// A fan of one of the shapes that fits the screen.
inline FanOutline fanFor(FanShape shape, const cv::Size& size, std::mt19937& random) {
  FanOutline fan;
  fan.shape = shape;
  const double top = uniform(random, 30.0, 50.0), depth = size.height - 100.0 - top - uniform(random, 0.0, 40.0);
  const double middle = 0.5 * size.width + uniform(random, -20.0, 20.0);
  if (shape == FanShape::linear) {
    const double half = uniform(random, 0.18, 0.26) * size.width;
    double leftSlant = 0.0, rightSlant = 0.0;
    const auto kind = random() % 3;
    if (kind == 1) leftSlant = rightSlant = uniform(random, -0.2, 0.2);  // steered
    if (kind == 2) leftSlant = -(rightSlant = uniform(random, 0.08, 0.2));
    fan.corners_px = {glm::dvec2(middle - half, top), glm::dvec2(middle + half, top),
                      glm::dvec2(middle + half + depth * rightSlant, top + depth),
                      glm::dvec2(middle - half + depth * leftSlant, top + depth)};
    return fan;
  }
  const double half = uniform(random, 27.0, 36.0) * 0.017453292519943295, lean = uniform(random, -1.0, 1.0) * 0.017453292519943295;
  fan.left_rad = -half + lean;
  fan.right_rad = half + lean;
  fan.near_px = shape == FanShape::convex ? uniform(random, 0.25, 0.45) * depth : uniform(random, 0.0, 0.05) * depth;
  fan.far_px = fan.near_px + depth - fan.near_px * (1.0 - std::cos(half));
  fan.apex_px = {middle, top - fan.near_px * std::cos(half)};
  return fan;
}

/// A whole made screen.
inline DrawnScreen madeScreen(unsigned seed, int frames = 12, bool overScan = true) {
  std::mt19937 random(seed);
  const std::array<cv::Size, 3> sizes{cv::Size(800, 600), cv::Size(1024, 768), cv::Size(960, 640)};
  const cv::Size size = sizes[seed % 3];
  DrawnScreen screen;
  screen.truth = fanFor(std::array{FanShape::convex, FanShape::sector, FanShape::linear}[random() % 3], size, random);
  screen.pixel_mm = uniform(random, 120.0, 180.0) / screen.truth.depth_px();
  if (screen.truth.shape == FanShape::linear) screen.pixel_mm = uniform(random, 35.0, 60.0) / screen.truth.depth_px();
  screen.tick_mm = screen.truth.shape == FanShape::linear ? 5.0 : 10.0;
  const cv::Mat level = tissue(screen.truth, size, random);
  const Speckle speckle(size.width, size.height, seed);
  const Furniture furniture = furnish(screen.truth, size, screen.pixel_mm, screen.tick_mm, random, overScan);
  for (const auto& [text, colour] : furniture.texts) screen.texts.push_back(text);
  screen.bar = furniture.bar;
  for (int n = 0; n < frames; ++n) {
    cv::Mat canvas;
    cv::cvtColor(scanOf(level, speckle, n), canvas, cv::COLOR_GRAY2BGR);
    addFrame(screen, canvas, furniture, n);
  }
  return screen;
}

/// Where screenAround() puts the upper left pixel of a recording.
inline const cv::Point kScanAt(110, 40);

/// The images of a recording in a screen, with furniture around and over them. @param truth in pixels of the recording
inline DrawnScreen screenAround(const Sequence& recording, const FanOutline& truth, double pixel_mm, unsigned seed,
                                std::size_t mostFrames = 30) {
  std::mt19937 random(seed);
  DrawnScreen screen;
  const cv::Size size(std::max(1024, recording.width + 260), std::max(768, recording.height + 100));
  screen.truth = truth.movedBy({kScanAt.x, kScanAt.y});
  screen.pixel_mm = pixel_mm;
  screen.tick_mm = pixel_mm < 0.12 ? 5.0 : 10.0;
  const Furniture furniture = furnish(screen.truth, size, pixel_mm, screen.tick_mm, random);
  for (const auto& [text, colour] : furniture.texts) screen.texts.push_back(text);
  const std::size_t every = std::max<std::size_t>(1, recording.frames.size() / mostFrames);
  for (std::size_t n = 0; n < recording.frames.size(); n += every) {
    const auto pixels = recording.framePixels(n);
    const cv::Mat image(recording.height, recording.width, CV_8U, const_cast<std::uint8_t*>(pixels.data()));
    cv::Mat canvas = cv::Mat::zeros(size, CV_8UC3);
    cv::Mat place = canvas(cv::Rect(kScanAt, image.size()));
    cv::cvtColor(image, place, cv::COLOR_GRAY2BGR);
    addFrame(screen, canvas, furniture, static_cast<int>(n));
  }
  return screen;
}

/// Of ../shared/data/liver-sweep, in its pixels. Apex, angles and near radius as stored with the sweep. The far radius stored is 724.35,
/// but its images go on: along the beams the highest level is 27 at 732 pixels and 3 at 734.
inline FanOutline liverSweepOutline() {
  constexpr double degree = 0.017453292519943295;
  FanOutline truth;
  truth.shape = FanShape::convex;
  truth.apex_px = {369.0, 22.01 - 161.34};
  truth.left_rad = -30.28 * degree;
  truth.right_rad = 30.28 * degree;
  truth.near_px = 161.34;
  truth.far_px = 733.0;
  return truth;
}
inline constexpr double kLiverSweepPixel_mm = 0.314818;

inline CineFrame frameOf(const cv::Mat& canvas, double time_s = 0.0) {
  CineFrame frame;
  frame.time_s = time_s;
  frame.level = GreyImage(canvas.cols, canvas.rows);
  frame.colour = RgbImage(canvas.cols, canvas.rows);
  frame.coloured.resize(frame.level.pixels.size());
  for (int y = 0; y < canvas.rows; ++y)
    for (int x = 0; x < canvas.cols; ++x) {
      const auto& p = canvas.at<cv::Vec3b>(y, x);
      const std::size_t n = static_cast<std::size_t>(y) * static_cast<std::size_t>(canvas.cols) + static_cast<std::size_t>(x);
      frame.level.pixels[n] = static_cast<std::uint8_t>(std::lround(0.299 * p[2] + 0.587 * p[1] + 0.114 * p[0]));
      frame.colour.pixels[n] = Rgb(p[2], p[1], p[0]);
      frame.coloured[n] = std::max({p[0], p[1], p[2]}) - std::min({p[0], p[1], p[2]}) > 24 ? 1 : 0;
    }
  return frame;
}

inline ScreenStatistics statisticsOf(const DrawnScreen& screen) {
  ScreenStatistics statistics(screen.frames.front().cols, screen.frames.front().rows);
  for (const cv::Mat& canvas : screen.frames) statistics.add(frameOf(canvas));
  return statistics;
}

/// How well the best place around a character looks like it: normalised cross-correlation, 1 for the same. Dots and dashes look like
/// speckle and are left out.
inline double readability(const GreyImage& clean, const PixelRect& kept, const DrawnText& text) {
  cv::Mat canvas(clean.height, clean.width, CV_8U, const_cast<std::uint8_t*>(clean.pixels.data()));
  double best = 0.0;
  int base = 0;
  for (std::size_t n = 0; n < text.text.size(); ++n) {
    const std::string letter(1, text.text[n]);
    if (letter.find_first_of(" .,-/'") != std::string::npos) continue;
    const cv::Size whole = cv::getTextSize(letter, text.font, text.scale, text.thickness, &base);
    cv::Mat glyph = cv::Mat::zeros(whole.height + base + 8, whole.width + 8, CV_8U);
    cv::putText(glyph, letter, {4, whole.height + 4}, text.font, text.scale, cv::Scalar(255), text.thickness, text.line);
    const cv::Rect ink = cv::boundingRect(glyph);
    const cv::Rect rim = cv::Rect(ink.x - 2, ink.y - 2, ink.width + 4, ink.height + 4) & cv::Rect({0, 0}, glyph.size());
    const cv::Mat pattern = glyph(rim);
    // Where this letter of the word stands, and 5 pixels around.
    const int before = cv::getTextSize(text.text.substr(0, n), text.font, text.scale, text.thickness, &base).width;
    cv::Rect around(text.at.x + before - 8 - kept.x, text.rect.y - 6 - kept.y, pattern.cols + 16, text.rect.height + 14);
    around &= cv::Rect(0, 0, canvas.cols, canvas.rows);
    if (around.width < pattern.cols || around.height < pattern.rows) continue;
    cv::Mat found;
    cv::matchTemplate(canvas(around), pattern, found, cv::TM_CCOEFF_NORMED);
    cv::patchNaNs(found, 0.0);
    double highest = 0.0;
    for (int y = 0; y < found.rows; ++y)
      for (int x = 0; x < found.cols; ++x)
        if (std::isfinite(found.at<float>(y, x)) && found.at<float>(y, x) <= 1.01F)
          highest = std::max(highest, static_cast<double>(found.at<float>(y, x)));
    best = std::max(best, highest);
  }
  return best;
}

/// What may be looked at for text that was left: a moment at the beginning and at the end, and mean and minimum over time, in which a scan
/// that moves fades and text does not.
inline std::array<GreyImage, 4> lookedAt(const ScreenCleaner& cleaner, const std::vector<cv::Mat>& frames) {
  std::array<GreyImage, 4> images;
  std::vector<double> sum;
  GreyImage clean, lowest;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    cleaner.clean(frameOf(frames[n]).level, clean);
    if (n == 0) {
      images[0] = lowest = clean;
      sum.resize(clean.pixels.size());
    }
    for (std::size_t p = 0; p < sum.size(); ++p) {
      sum[p] += clean.pixels[p];
      lowest.pixels[p] = std::min(lowest.pixels[p], clean.pixels[p]);
    }
  }
  images[1] = images[2] = clean;
  for (std::size_t p = 0; p < sum.size(); ++p)
    images[2].pixels[p] = static_cast<std::uint8_t>(std::lround(sum[p] / static_cast<double>(frames.size())));
  images[3] = lowest;
  return images;
}

/// The largest difference of two images wherever readability looks for a text.
inline int largestDifference(const GreyImage& a, const GreyImage& b, const PixelRect& kept, const DrawnText& text) {
  const cv::Rect around = cv::Rect(text.rect.x - 16 - kept.x, text.rect.y - 16 - kept.y, text.rect.width + 40, text.rect.height + 32) &
                          cv::Rect(0, 0, a.width, a.height);
  int largest = 0;
  for (int y = around.y; y < around.br().y; ++y)
    for (int x = around.x; x < around.br().x; ++x) largest = std::max(largest, std::abs(viewOf(a).at(x, y) - viewOf(b).at(x, y)));
  return largest;
}

}  // namespace ew::test
