#include "elastic/planar_registration.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "ew/core/order_statistics.h"

namespace ew::registration {
namespace {

/// Moving values where the field leads, and how far they may be believed.
struct Warped {
  std::vector<float> value;
  std::vector<float> weight;
};

void warpRows(const PlanarPair& pair, const std::vector<float>& ux, const std::vector<float>& uy, Warped& out) {
  const PlanarImage &fixed = pair.fixed, &moving = pair.moving;
  const float perX = static_cast<float>(1.0 / moving.pixel_mm.x), perY = static_cast<float>(1.0 / moving.pixel_mm.y);
  const float lastX = static_cast<float>(moving.width - 1), lastY = static_cast<float>(moving.height - 1);
  const std::ptrdiff_t stride = moving.width;
  const std::ptrdiff_t right = moving.width > 1 ? 1 : 0, below = moving.height > 1 ? stride : 0;
  for (int y = 0; y < fixed.height; ++y) {
    const float y_mm = static_cast<float>((y + 0.5) * fixed.pixel_mm.y);
    for (int x = 0; x < fixed.width; ++x) {
      const std::size_t n = static_cast<std::size_t>(y) * static_cast<std::size_t>(fixed.width) + static_cast<std::size_t>(x);
      const float x_mm = (static_cast<float>(x) + 0.5F) * static_cast<float>(fixed.pixel_mm.x);
      const float mx = (x_mm + ux[n]) * perX - 0.5F, my = (y_mm + uy[n]) * perY - 0.5F;
      const float cx = std::clamp(mx, 0.0F, lastX), cy = std::clamp(my, 0.0F, lastY);
      const int ix = std::min(static_cast<int>(cx), std::max(0, moving.width - 2)),
                iy = std::min(static_cast<int>(cy), std::max(0, moving.height - 2));
      const float fx = cx - static_cast<float>(ix), fy = cy - static_cast<float>(iy);
      const std::ptrdiff_t at = iy * stride + ix;
      const float* v = moving.value.data() + at;
      const float* w = moving.weight.data() + at;
      const float top = v[0] + fx * (v[right] - v[0]), bottom = v[below] + fx * (v[below + right] - v[below]);
      const float wTop = w[0] + fx * (w[right] - w[0]), wBottom = w[below] + fx * (w[below + right] - w[below]);
      const bool inside = mx >= -0.01F && my >= -0.01F && mx <= lastX + 0.01F && my <= lastY + 0.01F;
      out.value[n] = top + fy * (bottom - top);
      out.weight[n] = inside ? fixed.weight[n] * (wTop + fy * (wBottom - wTop)) : 0.0F;
    }
  }
}

/// Central differences, one-sided at the border, per mm.
void gradients(const std::vector<float>& v, int width, int height, double pixelX_mm, double pixelY_mm, std::vector<float>& gx,
               std::vector<float>& gy) {
  const float halfX = static_cast<float>(0.5 / pixelX_mm), halfY = static_cast<float>(0.5 / pixelY_mm);
  for (int y = 0; y < height; ++y) {
    const float* row = v.data() + static_cast<std::ptrdiff_t>(y) * width;
    const float* above = y > 0 ? row - width : row;
    const float* below = y + 1 < height ? row + width : row;
    const float scaleY = y > 0 && y + 1 < height ? halfY : 2.0F * halfY;
    float* toX = gx.data() + static_cast<std::ptrdiff_t>(y) * width;
    float* toY = gy.data() + static_cast<std::ptrdiff_t>(y) * width;
    for (int x = 0; x < width; ++x) toY[x] = (below[x] - above[x]) * scaleY;
    for (int x = 1; x + 1 < width; ++x) toX[x] = (row[x + 1] - row[x - 1]) * halfX;
    toX[0] = width > 1 ? (row[1] - row[0]) * 2.0F * halfX : 0.0F;
    toX[width - 1] = width > 1 ? (row[width - 1] - row[width - 2]) * 2.0F * halfX : 0.0F;
  }
}

float medianMagnitude(const std::vector<float>& values, const std::vector<float>& weight, std::vector<float>& scratch) {
  scratch.clear();
  const std::size_t step = values.size() > 20000 ? 3 : 1;
  for (std::size_t n = 0; n < values.size(); n += step)
    if (weight[n] > 0.0F) scratch.push_back(std::abs(values[n]));
  if (scratch.empty()) return 0.0F;
  return upperMedianOf(std::span(scratch));
}

}  // namespace

double smallestJacobian(const std::vector<float>& ux, const std::vector<float>& uy, int width, int height, double pixelX_mm,
                        double pixelY_mm) {
  if (width < 2 || height < 2) return 1.0;
  const float perX = static_cast<float>(1.0 / pixelX_mm), perY = static_cast<float>(1.0 / pixelY_mm);
  float least = 1e30F;
  for (int y = 0; y + 1 < height; ++y) {
    const float *a = ux.data() + static_cast<std::ptrdiff_t>(y) * width, *b = uy.data() + static_cast<std::ptrdiff_t>(y) * width;
    const float *c = a + width, *d = b + width;
    for (int x = 0; x + 1 < width; ++x) {
      // The determinant of a bilinear map is linear in each direction: its extremes are at the corners of the cell.
      const float xxTop = 1.0F + (a[x + 1] - a[x]) * perX, yxTop = (b[x + 1] - b[x]) * perX;
      const float xxBottom = 1.0F + (c[x + 1] - c[x]) * perX, yxBottom = (d[x + 1] - d[x]) * perX;
      const float xyLeft = (c[x] - a[x]) * perY, yyLeft = 1.0F + (d[x] - b[x]) * perY;
      const float xyRight = (c[x + 1] - a[x + 1]) * perY, yyRight = 1.0F + (d[x + 1] - b[x + 1]) * perY;
      const float first = std::min(xxTop * yyLeft - xyLeft * yxTop, xxTop * yyRight - xyRight * yxTop);
      const float second = std::min(xxBottom * yyLeft - xyLeft * yxBottom, xxBottom * yyRight - xyRight * yxBottom);
      least = std::min(least, std::min(first, second));
    }
  }
  return static_cast<double>(least);
}

PlanarPair planarPair(const PlanarImage& fixed, const PlanarImage& moving, double scale, const PlanarSettings& settings) {
  const auto at = [&](const PlanarImage& image) {
    // Pixels are made as square as the input allows.
    const double finest = std::min(image.pixel_mm.x, image.pixel_mm.y);
    const glm::dvec2 times{std::max(1.0, scale * finest / image.pixel_mm.x), std::max(1.0, scale * finest / image.pixel_mm.y)};
    const auto blur = [&](double t) { return t > 1.01 ? 0.5 * t : 0.0; };
    PlanarImage level = scale > 1.01 ? shrunk(image, times, {blur(times.x), blur(times.y)}) : image;
    normaliseLocally(level, settings.window_mm, settings.floor_grey);
    return level;
  };
  return {at(fixed), at(moving)};
}

PlanarAgreement planarAgreement(const PlanarPair& pair, const std::vector<float>& ux, const std::vector<float>& uy) {
  const int width = pair.fixed.width, height = pair.fixed.height;
  const std::size_t count = pair.fixed.value.size();
  Warped moved{std::vector<float>(count), std::vector<float>(count)};
  warpRows(pair, ux, uy, moved);
  double sw = 0.0, sf = 0.0, sm = 0.0;
  for (std::size_t n = 0; n < count; ++n) {
    const double w = static_cast<double>(moved.weight[n]);
    sw += w;
    sf += w * static_cast<double>(pair.fixed.value[n]);
    sm += w * static_cast<double>(moved.value[n]);
  }
  if (!(sw > 0.0)) return {};
  const double meanF = sf / sw, meanM = sm / sw;
  double ff = 0.0, mm = 0.0, fm = 0.0;
  // Likeness of neighbours: products of both images' own correlations one pixel apart.
  double ffX = 0.0, mmX = 0.0, ffY = 0.0, mmY = 0.0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t n = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      const double w = static_cast<double>(moved.weight[n]);
      const double f = static_cast<double>(pair.fixed.value[n]) - meanF, m = static_cast<double>(moved.value[n]) - meanM;
      ff += w * f * f;
      mm += w * m * m;
      fm += w * f * m;
      if (x + 1 < width) {
        ffX += w * f * (static_cast<double>(pair.fixed.value[n + 1]) - meanF);
        mmX += w * m * (static_cast<double>(moved.value[n + 1]) - meanM);
      }
      if (y + 1 < height) {
        ffY += w * f * (static_cast<double>(pair.fixed.value[n + static_cast<std::size_t>(width)]) - meanF);
        mmY += w * m * (static_cast<double>(moved.value[n + static_cast<std::size_t>(width)]) - meanM);
      }
    }
  }
  PlanarAgreement out;
  out.weight = sw;
  if (!(ff > 1e-4 * sw) || !(mm > 1e-4 * sw)) return out;  // a hundredth of a deviation: rounding, not tissue
  out.correlation = std::clamp(fm / std::sqrt(ff * mm), -1.0, 1.0);
  const auto fewer = [](double likeness) {
    const double a = std::clamp(likeness, 0.0, 0.98);
    return (1.0 - a) / (1.0 + a);
  };
  out.independent = sw * fewer(ffX / ff * mmX / mm) * fewer(ffY / ff * mmY / mm);
  return out;
}

glm::dvec2 commonShift_mm(const PlanarPair& pair, double reach_mm) {
  const PlanarImage &fixed = pair.fixed, &moving = pair.moving;
  const int reachX = std::min(static_cast<int>(reach_mm / fixed.pixel_mm.x), fixed.width - 1);
  const int reachY = std::min(static_cast<int>(reach_mm / fixed.pixel_mm.y), fixed.height - 1);
  double best = 0.0, atRest = 0.0;
  glm::ivec2 where{0};
  for (int dy = -reachY; dy <= reachY; ++dy) {
    for (int dx = -reachX; dx <= reachX; ++dx) {
      double fm = 0.0, ff = 0.0, mm = 0.0, weights = 0.0;
      for (int y = std::max(0, -dy); y < std::min(fixed.height, moving.height - dy); ++y) {
        const std::ptrdiff_t from = static_cast<std::ptrdiff_t>(y) * fixed.width,
                             to = static_cast<std::ptrdiff_t>(y + dy) * moving.width + dx;
        float rowFm = 0.0F, rowFf = 0.0F, rowMm = 0.0F, rowWeights = 0.0F;
        for (int x = std::max(0, -dx); x < std::min(fixed.width, moving.width - dx); ++x) {
          const float f = fixed.value.data()[from + x], m = moving.value.data()[to + x];
          const float w = fixed.weight.data()[from + x] * moving.weight.data()[to + x];
          rowFm += w * f * m;
          rowFf += w * f * f;
          rowMm += w * m * m;
          rowWeights += w;
        }
        fm += static_cast<double>(rowFm);
        ff += static_cast<double>(rowFf);
        mm += static_cast<double>(rowMm);
        weights += static_cast<double>(rowWeights);
      }
      if (!(ff > 0.0) || !(mm > 0.0) || weights < 0.1 * static_cast<double>(fixed.value.size())) continue;
      // Fisher's z times the root of the samples: a higher correlation over less overlap is no better.
      const double score = std::atanh(std::min(0.999, fm / std::sqrt(ff * mm))) * std::sqrt(weights);
      if (dx == 0 && dy == 0) atRest = score;
      if (score > best) {
        best = score;
        where = {dx, dy};
      }
    }
  }
  if (best < 1.05 * atRest) where = glm::ivec2(0);
  return {where.x * fixed.pixel_mm.x, where.y * fixed.pixel_mm.y};
}

namespace {

/// What is summed over the samples of one comparison, in row sums of floats that double ones collect.
struct PlanarEvidence {
  double together = 0.0;  ///< products of both images' gradients, robustly weighted
  double apart = 0.0;     ///< mean squares of each
  double squares = 0.0;   ///< of residuals
  double weights = 0.0;
  double strength = 0.0;  ///< squares of the mean gradient per axis
  double cost = 0.0;      ///< robust squares of residuals
};

/// Gauss-Newton on one level. resources/docs/science/registration.md, "Bending two images, and two tangent slices".
class PlanarDescent {
 public:
  PlanarDescent(const PlanarPair& pair, const PlanarLevel& level, const PlanarSettings& settings, PlanarState& state);
  /// @return false when cancelled
  bool run(Progress& progress);

 private:
  void compare();
  [[nodiscard]] PlanarEvidence linearise();
  void measure(const PlanarEvidence& evidence, int iteration);
  [[nodiscard]] Regulariser regulariser(const PlanarEvidence& evidence) const;
  bool take(const PlanarField& step);
  [[nodiscard]] double shareWithoutFold(double share, double& least);
  [[nodiscard]] double smallestJacobianOf(const std::vector<float>& ux, const std::vector<float>& uy) const {
    return smallestJacobian(ux, uy, pair_.fixed.width, pair_.fixed.height, pair_.fixed.pixel_mm.x, pair_.fixed.pixel_mm.y);
  }

  const PlanarPair& pair_;
  const PlanarLevel& level_;
  const PlanarSettings& settings_;
  PlanarState& state_;
  std::size_t count_;  ///< of samples; all below hold one value each
  double pixel_mm_;
  std::vector<float> ux_, uy_, brightness_;
  std::vector<float> stepX_, stepY_, nextX_, nextY_;
  Warped moved_;
  std::vector<float> fixedX_, fixedY_, movedX_, movedY_;  ///< gradients
  Linearised data_;
  std::vector<float> scratch_;
  PlanarEquations equations_;
};

PlanarDescent::PlanarDescent(const PlanarPair& pair, const PlanarLevel& level, const PlanarSettings& settings, PlanarState& state)
    : pair_(pair),
      level_(level),
      settings_(settings),
      state_(state),
      count_(pair.fixed.value.size()),
      pixel_mm_(std::sqrt(pair.fixed.pixel_mm.x * pair.fixed.pixel_mm.y)),
      nextX_(count_),
      nextY_(count_),
      moved_{std::vector<float>(count_), std::vector<float>(count_)},
      fixedX_(count_),
      fixedY_(count_),
      movedX_(count_),
      movedY_(count_),
      data_{std::vector<float>(count_), std::vector<float>(count_), std::vector<float>(count_), std::vector<float>(count_)},
      equations_(state.x, state.y, settings.brightnessTerm) {
  gradients(pair.fixed.value, pair.fixed.width, pair.fixed.height, pair.fixed.pixel_mm.x, pair.fixed.pixel_mm.y, fixedX_, fixedY_);
  evaluate(state.x, state.y, state.field.part[0], ux_);
  evaluate(state.x, state.y, state.field.part[1], uy_);
}

bool PlanarDescent::run(Progress& progress) {
  state_.stop = StopReason::iterationLimit;
  state_.smallestJacobian = smallestJacobianOf(ux_, uy_);
  for (int iteration = 0; iteration < settings_.iterations; ++iteration) {
    if (progress.cancelRequested()) return false;
    compare();
    const PlanarEvidence evidence = linearise();
    if (!(evidence.weights > 0.02 * static_cast<double>(count_)) || !(evidence.strength > 0.0)) {
      state_.stop = evidence.weights > 0.0 ? StopReason::singular : StopReason::noOverlap;
      return true;
    }
    measure(evidence, iteration);
    if (!equations_.assemble(data_, settings_.threads, progress)) return false;
    equations_.regularise(regulariser(evidence), state_.field);
    state_.iterations = iteration + 1;
    if (!take(equations_.solve(60, 1e-2))) break;
  }
  return true;
}

/// The moving image where the field puts it, and what is left of the fixed one.
void PlanarDescent::compare() {
  const PlanarImage& fixed = pair_.fixed;
  if (settings_.brightnessTerm) evaluate(state_.x, state_.y, state_.field.part[2], brightness_);
  warpRows(pair_, ux_, uy_, moved_);
  gradients(moved_.value, fixed.width, fixed.height, fixed.pixel_mm.x, fixed.pixel_mm.y, movedX_, movedY_);
  for (std::size_t n = 0; n < count_; ++n) data_.residual[n] = fixed.value[n] - moved_.value[n];
  if (settings_.brightnessTerm)
    for (std::size_t n = 0; n < count_; ++n) data_.residual[n] -= brightness_[n];
}

/// Robust weights and the mean of both gradients, sample by sample.
PlanarEvidence PlanarDescent::linearise() {
  const int width = pair_.fixed.width, height = pair_.fixed.height;
  const float scale = 3.0F * medianMagnitude(data_.residual, moved_.weight, scratch_) + 1e-4F;
  const float perScale = 1.0F / (scale * scale);
  const float *fixedX = fixedX_.data(), *fixedY = fixedY_.data(), *movedX = movedX_.data(), *movedY = movedY_.data();
  PlanarEvidence sum;
  for (int y = 0; y < height; ++y) {  // rows one by one keep the float sums short
    float together = 0.0F, apart = 0.0F, squares = 0.0F, weights = 0.0F, strength = 0.0F, cost = 0.0F;
    const std::size_t begin = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    for (std::size_t n = begin; n < begin + static_cast<std::size_t>(width); ++n) {
      const float r = data_.residual[n];
      const float robust = moved_.weight[n] / (1.0F + r * r * perScale);
      const float gx = 0.5F * (fixedX[n] + movedX[n]), gy = 0.5F * (fixedY[n] + movedY[n]);
      data_.gradientX[n] = gx;
      data_.gradientY[n] = gy;
      data_.weight[n] = robust;
      together += robust * (fixedX[n] * movedX[n] + fixedY[n] * movedY[n]);
      apart += 0.5F * robust * (fixedX[n] * fixedX[n] + movedX[n] * movedX[n] + fixedY[n] * fixedY[n] + movedY[n] * movedY[n]);
      squares += moved_.weight[n] * r * r;
      cost += robust * r * r;
      weights += moved_.weight[n];
      strength += 0.5F * robust * (gx * gx + gy * gy);
    }
    sum.together += static_cast<double>(together);
    sum.apart += static_cast<double>(apart);
    sum.squares += static_cast<double>(squares);
    sum.weights += static_cast<double>(weights);
    sum.strength += static_cast<double>(strength);
    sum.cost += static_cast<double>(cost);
  }
  return sum;
}

void PlanarDescent::measure(const PlanarEvidence& evidence, int iteration) {
  state_.residualRms = std::sqrt(evidence.squares / evidence.weights);
  state_.cost = evidence.cost / evidence.weights;
  const double measured = evidence.apart > 0.0 ? std::clamp(evidence.together / evidence.apart, 0.0, 1.0) : 0.0;
  // The first look at a level still carries the coarser level's error.
  state_.coherence = iteration == 0 ? std::max(state_.coherence, measured) : measured;
  state_.stiffness = settings_.stiffness > 0.0 ? settings_.stiffness
                                               : std::clamp(level_.firmness / (state_.coherence * state_.coherence + 1e-6),
                                                            level_.leastStiffness, level_.mostStiffness);
}

Regulariser PlanarDescent::regulariser(const PlanarEvidence& evidence) const {
  const double energy = state_.stiffness * evidence.strength / evidence.weights;  // per mm^2 where everything is seen
  const double m = settings_.slope_mm * settings_.slope_mm, b = std::pow(settings_.bending_mm, 4.0);
  return {energy * m, energy * b, settings_.brightness_mm * settings_.brightness_mm, settings_.brightnessRidge};
}

/// As much of a step as this level's gradients vouch for and folds nothing.
/// @return false when it was the last
bool PlanarDescent::take(const PlanarField& step) {
  evaluate(state_.x, state_.y, step.part[0], stepX_);
  evaluate(state_.x, state_.y, step.part[1], stepY_);
  float largest = 0.0F;
  for (std::size_t n = 0; n < count_; ++n) largest = std::max(largest, stepX_[n] * stepX_[n] + stepY_[n] * stepY_[n]);
  const double longest_mm = std::sqrt(static_cast<double>(largest)), most_mm = 2.0 * pixel_mm_;
  double least = 0.0;
  const double share = shareWithoutFold(std::min(1.0, most_mm / std::max(1e-9, longest_mm)), least);
  if (share == 0.0) {
    state_.stop = StopReason::noImprovement;
    return false;
  }
  state_.smallestJacobian = least;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t n = 0; n < step.part[k].size(); ++n)
      state_.field.part[k][n] += static_cast<float>(k < 2 ? share : 1.0) * step.part[k][n];
  ux_.swap(nextX_);
  uy_.swap(nextY_);
  if (longest_mm >= 0.03 * pixel_mm_) return true;
  state_.stop = StopReason::converged;
  return false;
}

/// Never towards a fold: the step is shortened until no cell is squeezed below the limit. What it leads to is left in nextX_ and nextY_.
/// @param least their smallest Jacobian
/// @return 0 where even a 64th of it would
double PlanarDescent::shareWithoutFold(double share, double& least) {
  for (int halving = 0;; ++halving) {
    const float s = static_cast<float>(share);
    for (std::size_t n = 0; n < count_; ++n) {
      nextX_[n] = ux_[n] + s * stepX_[n];
      nextY_[n] = uy_[n] + s * stepY_[n];
    }
    least = smallestJacobianOf(nextX_, nextY_);
    if (least >= settings_.leastJacobian || least >= state_.smallestJacobian) return share;
    if (halving == 6) return 0.0;
    share *= 0.5;
  }
}

}  // namespace

bool refinePlanar(const PlanarPair& pair, const PlanarLevel& level, const PlanarSettings& settings, PlanarState& state,
                  Progress& progress) {
  return PlanarDescent(pair, level, settings, state).run(progress);
}

}  // namespace ew::registration
