#include "shapes/uneven_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ew/core/contract.h"
#include "ew/phantom/speckle.h"

namespace ew::phantom {
namespace {

constexpr double kNoiseRms = 0.40;   // of valueNoise
constexpr double kNoiseSlope = 2.0;  // where it is steep
constexpr double kEverywhere_mm = 1e5;
constexpr double kAround_mm = 110.0;  // radius at which angles around the body are measured
constexpr std::uint64_t kGapSeed = 0x6761707321212121ull;

double evenAtPlace(std::uint64_t seed, std::int64_t i, std::int64_t j, std::int64_t k, int which) {
  return static_cast<double>((hashOfPlace(seed, i, j, k) >> (21 * which)) & 0x1FFFFFu) / 2097152.0;
}

/// The value of valueNoise that about this share of space lies above.
double levelAbove(double share) { return kNoiseRms * 2.75 * (0.5 - share); }

class Rough final : public Shape {
 public:
  Rough(ShapePtr of, const Roughness& r) : of_(std::move(of)), roughness_(r) {
    countPart(*of_);
    bounds_ = {of_->bounds().lowest_mm - r.amplitude_mm, of_->bounds().highest_mm + r.amplitude_mm};
    const double slope = kNoiseSlope * r.amplitude_mm / r.length_mm;
    perSlope_ = 1.0 / std::sqrt(1.0 + slope * slope);
  }
  double distance_mm(const glm::dvec3& p_mm) const override { return roughened(p_mm, of_->distance_mm(p_mm)); }
  double distanceUpTo_mm(const glm::dvec3& p_mm, double most_mm) const override {
    const double far = most_mm / perSlope_ + roughness_.amplitude_mm, d = of_->distanceUpTo_mm(p_mm, far);
    return d < far ? roughened(p_mm, d) : (d - roughness_.amplitude_mm) * perSlope_;
  }
  double atLeast_mm(const glm::dvec3& p_mm) const override {
    return std::max(0.0, (of_->atLeast_mm(p_mm) - roughness_.amplitude_mm) * perSlope_);
  }

 private:
  [[nodiscard]] double roughened(const glm::dvec3& p_mm, double d) const {
    const double a = roughness_.amplitude_mm;
    const double near = std::clamp(2.0 - std::abs(d) / (2.0 * a), 0.0, 1.0);
    if (near <= 0.0) return d * perSlope_;
    return (d - a * near * valueNoise(roughness_.seed, p_mm / roughness_.length_mm)) * perSlope_;
  }

  ShapePtr of_;
  Roughness roughness_;
  double perSlope_ = 1.0;
};

class SheetsBelow final : public Shape {
 public:
  SheetsBelow(ShapePtr below, const Sheets& s) : below_(std::move(below)), sheets_(s) {
    countPart(*below_);
    reach_ = s.undulation_mm / kNoiseRms;
    const double slope = s.undulation_mm * kNoiseSlope / s.length_mm;
    perSlope_ = 1.0 / std::sqrt(1.0 + slope * slope);
    bounds_ = {below_->bounds().lowest_mm + (s.fromDepth_mm < 0.0 ? s.fromDepth_mm : 0.0),
               below_->bounds().highest_mm - (s.fromDepth_mm < 0.0 ? s.fromDepth_mm : 0.0)};
    // Log-normal gaps by the sum of even numbers, whose bell is near enough to the normal one.
    constexpr double kSpread = 0.47;
    double depth = s.fromDepth_mm;
    for (int n = 0; depth <= s.toDepth_mm && depths_.size() < 200; ++n) {
      depths_.push_back(depth);
      double bell = -6.0;
      for (int k = 0; k < 12; ++k) bell += evenAtPlace(s.seed, n, k, 7, 0);
      depth += std::max(0.1 * s.spacing_mm, s.spacing_mm * std::exp(kSpread * bell - 0.5 * kSpread * kSpread));
    }
    solids_ += static_cast<double>(depths_.size());
  }
  double distance_mm(const glm::dvec3& p_mm) const override { return nearest(p_mm).distance_mm; }
  double sheetThickness_mm() const override { return sheets_.thickness_mm; }
  double middle_mm(const glm::dvec3& p_mm) const override { return nearest(p_mm).middle_mm; }

 private:
  struct Nearest {
    double distance_mm;
    double middle_mm;  ///< above it positive
  };
  [[nodiscard]] Nearest nearest(const glm::dvec3& p_mm) const {
    const double depth = -below_->distance_mm(p_mm), far = reach_ + 1.0;
    if (depth < depths_.front() - far) return {depths_.front() - depth - reach_, depths_.front() - depth};
    if (depth > depths_.back() + far) return {depth - depths_.back() - reach_, depths_.back() - depth};
    const glm::dvec3 at = p_mm / sheets_.length_mm;
    const double together = 0.6 * reach_ * valueNoise(sheets_.seed, at);
    constexpr double kNowhere = std::numeric_limits<double>::infinity();
    Nearest found{kNowhere, kNowhere};
    const auto ask = [&](std::size_t n) {
      const double away = std::abs(depth - depths_[n]) - 2.0 * reach_;
      if (away > found.distance_mm && away > std::abs(found.middle_mm)) return false;
      const double own = 0.8 * reach_ * valueNoise(sheets_.seed + 1 + n, at);
      const double above = depths_[n] + together + own - depth;
      if (std::abs(above) * perSlope_ < std::abs(found.middle_mm)) found.middle_mm = above * perSlope_;
      if (away > found.distance_mm) return true;
      double d = (std::abs(above) - 0.5 * sheets_.thickness_mm) * perSlope_;
      if (sheets_.missing > 0.0 && d < found.distance_mm) {
        const double length = 1.6 * sheets_.length_mm;
        const double gap = levelAbove(1.0 - sheets_.missing) - valueNoise((sheets_.seed + 1 + n) ^ kGapSeed, p_mm / length);
        d = std::max(d, gap * length / (2.0 * kNoiseSlope));
      }
      found.distance_mm = std::min(found.distance_mm, d);
      return true;
    };
    // From this depth outwards: beyond a sheet that is too far all are.
    auto deeper = static_cast<std::size_t>(std::lower_bound(depths_.begin(), depths_.end(), depth) - depths_.begin());
    std::size_t shallower = deeper;
    bool goesDeeper = deeper < depths_.size();
    bool goesShallower = shallower > 0;
    while (goesDeeper || goesShallower) {
      if (goesDeeper) goesDeeper = ask(deeper) && ++deeper < depths_.size();
      if (goesShallower) goesShallower = ask(shallower - 1) && --shallower > 0;
    }
    return found;
  }

  ShapePtr below_;
  Sheets sheets_;
  std::vector<double> depths_;
  double reach_ = 0.0;
  double perSlope_ = 1.0;
};

class SeptaBelow final : public Shape {
 public:
  SeptaBelow(ShapePtr below, const Septa& s) : below_(std::move(below)), septa_(s) {
    countPart(*below_);
    const double outside = std::max(0.0, -s.fromDepth_mm);
    bounds_ = {below_->bounds().lowest_mm - outside, below_->bounds().highest_mm + outside};
    solids_ += 27.0;
  }
  double distance_mm(const glm::dvec3& p_mm) const override {
    const double skin = below_->distance_mm(p_mm);
    const double layer = std::max(skin + septa_.fromDepth_mm, -skin - septa_.toDepth_mm);
    if (layer > 1.0) return layer;
    return std::max(layer, std::abs(wall_mm(unrolled(p_mm, skin))) - 0.5 * septa_.thickness_mm);
  }
  double sheetThickness_mm() const override { return septa_.thickness_mm; }
  double middle_mm(const glm::dvec3& p_mm) const override { return wall_mm(unrolled(p_mm, below_->distance_mm(p_mm))); }

 private:
  [[nodiscard]] static glm::dvec3 unrolled(const glm::dvec3& p_mm, double skin_mm) {
    return {kAround_mm * std::atan2(p_mm.x, -p_mm.y), -skin_mm, p_mm.z};
  }
  /// Signed distance to the nearest face between two lobules: positive in the one that comes first along x, y and z.
  [[nodiscard]] double wall_mm(const glm::dvec3& p) const {
    const glm::dvec3 scale = 1.0 / septa_.lobule_mm, q = p * scale, floor = glm::floor(q);
    const auto i = static_cast<std::int64_t>(floor.x), j = static_cast<std::int64_t>(floor.y), k = static_cast<std::int64_t>(floor.z);
    std::array<glm::dvec3, 27> centres;
    std::size_t count = 0, own = 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (int dk = -1; dk <= 1; ++dk)
      for (int dj = -1; dj <= 1; ++dj)
        for (int di = -1; di <= 1; ++di) {
          const std::uint64_t hash = hashOfPlace(septa_.seed, i + di, j + dj, k + dk);
          const auto jitter = [&](int shift) { return 0.1 + 0.8 * static_cast<double>((hash >> shift) & 0xFFFFu) / 65536.0; };
          const glm::dvec3 centre = floor + glm::dvec3(di + jitter(0), dj + jitter(16), dk + jitter(32));
          const glm::dvec3 away = centre - q;
          const double d = glm::dot(away, away);
          if (d < nearest) {
            nearest = d;
            own = count;
          }
          centres[count++] = centre;
        }
    double wall2 = std::numeric_limits<double>::infinity();
    bool isFirst = true;
    for (std::size_t n = 0; n < count; ++n) {
      if (n == own) continue;
      const glm::dvec3 across = centres[n] - centres[own];
      const double beyond = std::max(0.0, glm::dot(0.5 * (centres[n] + centres[own]) - q, across));
      const glm::dvec3 slope = across * scale;
      const double here2 = beyond * beyond / glm::dot(slope, slope);
      if (here2 >= wall2) continue;
      wall2 = here2;
      isFirst = own < n;
    }
    return isFirst ? std::sqrt(wall2) : -std::sqrt(wall2);
  }

  ShapePtr below_;
  Septa septa_;
};

class PatchesEverywhere final : public Shape {
 public:
  explicit PatchesEverywhere(const Patches& p) : patches_(p), level_(levelAbove(p.share)) {
    bounds_ = {glm::dvec3(-kEverywhere_mm), glm::dvec3(kEverywhere_mm)};
    perSlope_ = std::min(p.size_mm.x, std::min(p.size_mm.y, p.size_mm.z)) / kNoiseSlope;
  }
  double distance_mm(const glm::dvec3& p_mm) const override {
    return (level_ - valueNoise(patches_.seed, p_mm / patches_.size_mm)) * perSlope_;
  }

 private:
  Patches patches_;
  double level_;
  double perSlope_;
};

}  // namespace

ShapePtr makeRough(ShapePtr of, const Roughness& roughness) {
  EW_EXPECTS(of && roughness.amplitude_mm > 0.0 && roughness.amplitude_mm <= 0.5 * roughness.length_mm);
  return std::make_shared<Rough>(std::move(of), roughness);
}
ShapePtr makeSheets(ShapePtr below, const Sheets& sheets) {
  EW_EXPECTS(below && sheets.fromDepth_mm < sheets.toDepth_mm && sheets.spacing_mm > 0.0 && sheets.length_mm > 0.0);
  return std::make_shared<SheetsBelow>(std::move(below), sheets);
}
ShapePtr makeSepta(ShapePtr below, const Septa& septa) {
  EW_EXPECTS(below && septa.fromDepth_mm < septa.toDepth_mm);
  return std::make_shared<SeptaBelow>(std::move(below), septa);
}
ShapePtr makePatches(const Patches& patches) { return std::make_shared<PatchesEverywhere>(patches); }

}  // namespace ew::phantom
