#include "elastic/planar_image.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "ew/core/order_statistics.h"

namespace ew::registration {
namespace {

/// What the samples of a smaller line are made of.
struct Gathering {
  std::vector<int> first;     ///< of the pixels that count
  std::vector<int> begin;     ///< of their weights; one more than there are samples
  std::vector<float> weight;  ///< those inside the line; of all pixels, also those outside, they would sum to 1
};
Gathering gather(int from, int count, double sigma) {
  Gathering line;
  line.begin.push_back(0);
  const double reach = std::max(0.5, 2.5 * sigma);
  for (int n = 0; n < count; ++n) {
    const double centre = (n + 0.5) * from / count - 0.5;
    const int lowest = static_cast<int>(std::ceil(centre - reach - 1e-9)), highest = static_cast<int>(std::floor(centre + reach + 1e-9));
    double sum = 0.0;
    const auto bell = [&](int k) { return sigma > 0.0 ? std::exp(-0.5 * (k - centre) * (k - centre) / (sigma * sigma)) : 1.0; };
    for (int k = lowest; k <= highest; ++k) sum += bell(k);
    line.first.push_back(std::max(0, lowest));
    for (int k = std::max(0, lowest); k <= std::min(from - 1, highest); ++k) line.weight.push_back(static_cast<float>(bell(k) / sum));
    line.begin.push_back(static_cast<int>(line.weight.size()));
  }
  return line;
}

/// Running means of `radius` pixels to both sides along one line, outside counting as 0.
void meanLine(const float* in, float* out, int n, std::ptrdiff_t stride, int radius) {
  const float scale = 1.0F / static_cast<float>(2 * radius + 1);
  double sum = 0.0;
  for (int k = 0; k < std::min(n, radius); ++k) sum += static_cast<double>(in[k * stride]);
  for (int x = 0; x < n; ++x) {
    if (x + radius < n) sum += static_cast<double>(in[(x + radius) * stride]);
    out[x * stride] = static_cast<float>(sum) * scale;
    if (x - radius >= 0) sum -= static_cast<double>(in[(x - radius) * stride]);
  }
}

/// The same down all columns at once, which runs along memory.
void meanColumns(const std::vector<float>& in, std::vector<float>& out, int width, int height, int radius) {
  const float scale = 1.0F / static_cast<float>(2 * radius + 1);
  std::vector<float> sums(static_cast<std::size_t>(width), 0.0F);
  const auto row = [&](int y) { return in.data() + static_cast<std::ptrdiff_t>(y) * width; };
  for (int y = 0; y < std::min(height, radius); ++y)
    for (int x = 0; x < width; ++x) sums[static_cast<std::size_t>(x)] += row(y)[x];
  for (int y = 0; y < height; ++y) {
    float* to = out.data() + static_cast<std::ptrdiff_t>(y) * width;
    if (y + radius < height) {
      const float* add = row(y + radius);
      for (int x = 0; x < width; ++x) sums[static_cast<std::size_t>(x)] += add[x];
    }
    for (int x = 0; x < width; ++x) to[x] = sums[static_cast<std::size_t>(x)] * scale;
    if (y - radius >= 0) {
      const float* take = row(y - radius);
      for (int x = 0; x < width; ++x) sums[static_cast<std::size_t>(x)] -= take[x];
    }
  }
}

/// Three running means of this radius together have about this deviation.
int radiusFor(double sigma) { return std::max(0, static_cast<int>(std::lround(0.5 * (std::sqrt(4.0 * sigma * sigma + 1.0) - 1.0)))); }

}  // namespace

PlanarImage planarImageOf(ImageView<const std::uint8_t> grey, glm::dvec2 pixel_mm) {
  PlanarImage image{grey.width, grey.height, pixel_mm, {}, {}};
  const std::size_t count = static_cast<std::size_t>(grey.width) * static_cast<std::size_t>(grey.height);
  image.value.resize(count);
  image.weight.assign(count, 1.0F);
  std::size_t zeros = 0;
  for (int y = 0; y < grey.height; ++y) {
    const std::uint8_t* from = grey.row(y);
    float* to = image.value.data() + static_cast<std::ptrdiff_t>(y) * grey.width;
    for (int x = 0; x < grey.width; ++x) {
      to[x] = static_cast<float>(from[x]);
      zeros += from[x] == 0 ? 1 : 0;
    }
  }
  if (zeros == 0) return image;
  std::vector<int> across(count);
  const auto at = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(grey.width) + static_cast<std::size_t>(x);
  };
  for (int y = 0; y < grey.height; ++y) {
    const std::uint8_t* from = grey.row(y);
    for (int x = 0; x < grey.width; ++x) {
      int lit = 0;
      for (int k = -2; k <= 2; ++k) lit += from[std::clamp(x + k, 0, grey.width - 1)] != 0 ? 1 : 0;
      across[at(x, y)] = lit;
    }
  }
  for (int y = 0; y < grey.height; ++y) {
    for (int x = 0; x < grey.width; ++x) {
      int lit = 0;
      for (int k = -2; k <= 2; ++k) lit += across[at(x, std::clamp(y + k, 0, grey.height - 1))];
      if (lit <= 12) image.weight[at(x, y)] = 0.0F;
    }
  }
  return image;
}

void doubtShadows(PlanarImage& image) {
  constexpr float kDark = 35.0F;  // grey levels below the median of the depth; 55 dB over 255 levels: 7.5 dB
  constexpr double kMean_mm = 1.0, kShortest_mm = 6.0, kBorder_mm = 1.5;
  const int width = image.width, height = image.height;
  if (width < 8 || height < 8) return;
  const std::size_t count = image.value.size();
  std::vector<float> mean(count), total = image.weight;
  for (std::size_t n = 0; n < count; ++n) mean[n] = image.value[n] * image.weight[n];
  smoothWide(mean, width, height, kMean_mm / image.pixel_mm.x, kMean_mm / image.pixel_mm.y);
  smoothWide(total, width, height, kMean_mm / image.pixel_mm.x, kMean_mm / image.pixel_mm.y);
  std::vector<float> usual(static_cast<std::size_t>(height), 0.0F), row;
  for (int y = 0; y < height; ++y) {
    row.clear();
    for (int x = 0; x < width; ++x) {
      const std::size_t n = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      mean[n] = total[n] > 1e-3F ? mean[n] / total[n] : 0.0F;
      if (image.weight[n] > 0.0F) row.push_back(mean[n]);
    }
    if (row.empty()) continue;
    usual[static_cast<std::size_t>(y)] = upperMedianOf(std::span(row));
  }
  std::vector<float> trust(count, 1.0F);
  const int shortest = static_cast<int>(std::ceil(kShortest_mm / image.pixel_mm.y));
  bool any = false;
  for (int x = 0; x < width; ++x) {
    const auto at = [&](int y) { return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x); };
    int bottom = height - 1;
    while (bottom >= 0 && image.weight[at(bottom)] <= 0.0F) --bottom;
    int top = bottom + 1;
    while (top > 0 && usual[static_cast<std::size_t>(top - 1)] - mean[at(top - 1)] > kDark) --top;
    if (bottom + 1 - top < shortest) continue;
    any = true;
    for (int y = top; y <= bottom; ++y) trust[at(y)] = 0.0F;
  }
  if (!any) return;
  smoothWide(trust, width, height, kBorder_mm / image.pixel_mm.x, kBorder_mm / image.pixel_mm.y);
  std::vector<float> inside(count, 1.0F);
  smoothWide(inside, width, height, kBorder_mm / image.pixel_mm.x, kBorder_mm / image.pixel_mm.y);
  for (std::size_t n = 0; n < count; ++n) {
    const float t = std::clamp((trust[n] / inside[n] - 0.75F) * 4.0F, 0.0F, 1.0F);  // the penumbra counts as shadow
    image.weight[n] *= t;
  }
}

PlanarImage shrunk(const PlanarImage& image, glm::dvec2 times, glm::dvec2 sigma_pixels) {
  PlanarImage out;
  out.width = std::max(1, static_cast<int>(std::lround(image.width / times.x)));
  out.height = std::max(1, static_cast<int>(std::lround(image.height / times.y)));
  out.pixel_mm = image.pixel_mm * glm::dvec2(static_cast<double>(image.width) / out.width, static_cast<double>(image.height) / out.height);
  const Gathering alongX = gather(image.width, out.width, sigma_pixels.x), alongY = gather(image.height, out.height, sigma_pixels.y);
  const std::size_t narrow = static_cast<std::size_t>(out.width) * static_cast<std::size_t>(image.height);
  std::vector<float> value(narrow), weight(narrow);
  for (int y = 0; y < image.height; ++y) {
    const float* from = image.value.data() + static_cast<std::ptrdiff_t>(y) * image.width;
    const float* trust = image.weight.data() + static_cast<std::ptrdiff_t>(y) * image.width;
    const std::size_t start = static_cast<std::size_t>(y) * static_cast<std::size_t>(out.width);
    for (std::size_t x = 0; x < static_cast<std::size_t>(out.width); ++x) {
      float sum = 0.0F, sumOfWeights = 0.0F;
      int at = alongX.first[x];
      for (int k = alongX.begin[x]; k < alongX.begin[x + 1]; ++k, ++at) {
        const float w = alongX.weight[static_cast<std::size_t>(k)] * trust[at];
        sum += w * from[at];
        sumOfWeights += w;
      }
      value[start + x] = sum;
      weight[start + x] = sumOfWeights;
    }
  }
  const std::size_t count = static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height);
  out.value.assign(count, 0.0F);
  out.weight.assign(count, 0.0F);
  for (std::size_t y = 0; y < static_cast<std::size_t>(out.height); ++y) {
    float* to = out.value.data() + y * static_cast<std::size_t>(out.width);
    float* trust = out.weight.data() + y * static_cast<std::size_t>(out.width);
    int at = alongY.first[y];
    for (int k = alongY.begin[y]; k < alongY.begin[y + 1]; ++k, ++at) {
      const float w = alongY.weight[static_cast<std::size_t>(k)];
      const float* fromValue = value.data() + static_cast<std::ptrdiff_t>(at) * out.width;
      const float* fromWeight = weight.data() + static_cast<std::ptrdiff_t>(at) * out.width;
      for (int x = 0; x < out.width; ++x) to[x] += w * fromValue[x];
      for (int x = 0; x < out.width; ++x) trust[x] += w * fromWeight[x];
    }
    for (int x = 0; x < out.width; ++x) {
      if (trust[x] > 1e-3F) to[x] /= trust[x];
      trust[x] = std::min(1.0F, trust[x]);
    }
  }
  return out;
}

void smoothWide(std::vector<float>& values, int width, int height, double sigmaX_pixels, double sigmaY_pixels) {
  // Three passes of radius r have the variance r (r + 1): each pass a third of it, times three.
  const int radiusX = radiusFor(sigmaX_pixels), radiusY = radiusFor(sigmaY_pixels);
  std::vector<float> other(values.size());
  for (int pass = 0; pass < 3 && radiusX > 0; ++pass) {
    for (int y = 0; y < height; ++y) {
      const std::ptrdiff_t start = static_cast<std::ptrdiff_t>(y) * width;
      meanLine(values.data() + start, other.data() + start, width, 1, radiusX);
    }
    values.swap(other);
  }
  for (int pass = 0; pass < 3 && radiusY > 0; ++pass) {
    meanColumns(values, other, width, height, radiusY);
    values.swap(other);
  }
}

void normaliseLocally(PlanarImage& image, double window_mm, float floor) {
  const double sigmaX = window_mm / image.pixel_mm.x, sigmaY = window_mm / image.pixel_mm.y;
  const std::size_t count = image.value.size();
  std::vector<float> sumOfWeights = image.weight, mean(count), square(count);
  for (std::size_t n = 0; n < count; ++n) {
    const float v = image.value[n] - 128.0F;  // sums of squares around mid grey lose less to rounding
    mean[n] = image.weight[n] * v;
    square[n] = image.weight[n] * v * v;
  }
  smoothWide(sumOfWeights, image.width, image.height, sigmaX, sigmaY);
  smoothWide(mean, image.width, image.height, sigmaX, sigmaY);
  smoothWide(square, image.width, image.height, sigmaX, sigmaY);
  for (std::size_t n = 0; n < count; ++n) {
    const float total = sumOfWeights[n];
    if (!(total > 1e-3F) || image.weight[n] <= 0.0F) {
      image.value[n] = 0.0F;
      image.weight[n] = 0.0F;
      continue;
    }
    const float mu = mean[n] / total;
    const float variance = std::max(0.0F, square[n] / total - mu * mu);
    image.value[n] = (image.value[n] - 128.0F - mu) / (std::sqrt(variance) + floor);
  }
}

}  // namespace ew::registration
