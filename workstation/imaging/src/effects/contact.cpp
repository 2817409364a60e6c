#include "ew/imaging/effects/contact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "effects/grey_scale.h"

// The instruction sets left out would only repeat the code of a neighbour.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/contact.cpp"
#include "hwy/foreach_target.h"
//
#include "effects/powers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ew {
namespace HWY_NAMESPACE {
namespace {

void ringDownRow(float perDoubling, float bar, const float* drop, const float* ring, float* echoes, int width) {
  forColumns(width, [&](auto d, int x) HWY_ATTR {
    const auto left = hn::Sub(hn::LoadU(d, echoes + x), hn::LoadU(d, drop + x));
    const auto ringing = hn::Add(hn::LoadU(d, ring + x), hn::Set(d, bar));
    hn::StoreU(addPowers(d, left, ringing, hn::Set(d, perDoubling), hn::Set(d, 1.0F / perDoubling)), d, echoes + x);
  });
}

void dropRow(const float* drop, float* echoes, int width) {
  forColumns(width, [&](auto d, int x) HWY_ATTR { hn::StoreU(hn::Sub(hn::LoadU(d, echoes + x), hn::LoadU(d, drop + x)), d, echoes + x); });
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace ew
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew {
namespace {

HWY_EXPORT(ringDownRow);
HWY_EXPORT(dropRow);

constexpr double kGelEdge_mm = 1.0;  // beyond the gel's reach the film thins out over this distance

double touchOf(const ContactEffect& effect, float gap_mm) {
  const double touch = (effect.gel_mm + kGelEdge_mm - static_cast<double>(gap_mm)) / kGelEdge_mm;
  return touch > 0.0 ? std::min(touch, 1.0) : 0.0;  // NaN compares false
}

/// Integral from 0 to `at` (0..points - 1) of the polygon through touch(0), touch(1), ...
class TouchIntegral {
 public:
  TouchIntegral(const ContactEffect& effect, std::span<const float> gaps_mm)
      : effect_(effect), gaps_mm_(gaps_mm), left_(touchOf(effect, gaps_mm[0])), right_(touchOf(effect, gaps_mm[1])) {}
  /// Calls must not go backwards.
  double upTo(double at) {
    while (at > static_cast<double>(piece_ + 1) && piece_ + 2 < gaps_mm_.size()) {
      sum_ += 0.5 * (left_ + right_);
      ++piece_;
      left_ = right_;
      right_ = touchOf(effect_, gaps_mm_[piece_ + 1]);
    }
    const double t = at - static_cast<double>(piece_);
    return sum_ + t * (left_ + 0.5 * t * (right_ - left_));
  }

 private:
  const ContactEffect& effect_;
  std::span<const float> gaps_mm_;
  double left_;
  double right_;
  std::size_t piece_ = 0;
  double sum_ = 0.0;
};

constexpr double kLeastContact = 1e-4;  // 160 dB: dark at every dynamic range
constexpr double kBarSpacing_mm = 1.5;
constexpr double kBarDepth_db = 18.0;  // between bars
constexpr double kFade_db = 60.0;      // over the ring-down's length

}  // namespace

void contactOfLines(const ContactEffect& effect, std::span<const float> gaps_mm, double faceWidth_mm, double aperture_mm,
                    std::span<float> contact) {
  EW_EXPECTS(gaps_mm.empty() || gaps_mm.size() >= 2);
  EW_EXPECTS(faceWidth_mm > 0.0 && aperture_mm >= 0.0);
  const auto touches = [&](float gap_mm) { return touchOf(effect, gap_mm) >= 1.0; };
  if (std::all_of(gaps_mm.begin(), gaps_mm.end(), touches)) {
    std::fill(contact.begin(), contact.end(), 1.0F);
    return;
  }
  const double pieces = static_cast<double>(gaps_mm.size() - 1);
  // An aperture of no width would divide by 0: a thousandth of the face stands for it.
  const double half = 0.5 * pieces * std::clamp(aperture_mm / faceWidth_mm, 1e-3, 2.0);
  TouchIntegral upToLeft(effect, gaps_mm);
  TouchIntegral upToRight(effect, gaps_mm);
  for (std::size_t n = 0; n < contact.size(); ++n) {
    const double middle = contact.size() > 1 ? pieces * static_cast<double>(n) / static_cast<double>(contact.size() - 1) : 0.5 * pieces;
    const double left = std::max(middle - half, 0.0);
    const double right = std::min(middle + half, pieces);
    const double mean = (upToRight.upTo(right) - upToLeft.upTo(left)) / (right - left);
    contact[n] = mean > 1.0 - 1e-6 ? 1.0F : static_cast<float>(std::max(mean, 0.0));
  }
}

void loseContact(const ContactEffect& effect, std::span<const float> contact, double greyPerDb, double sampleSpacing_mm,
                 ImageView<float> echoes, std::vector<float>& scratch) {
  EW_EXPECTS(contact.size() == static_cast<std::size_t>(echoes.width));
  EW_EXPECTS(greyPerDb > 0.0 && sampleSpacing_mm > 0.0);
  if (std::all_of(contact.begin(), contact.end(), [](float share) { return share >= 1.0F; })) return;
  const std::size_t lines = contact.size();
  scratch.resize(2 * lines);
  float* drop = scratch.data();
  float* ring = scratch.data() + lines;
  for (std::size_t n = 0; n < lines; ++n) {
    const double share = contact[n] > 0.0F ? std::min(static_cast<double>(contact[n]), 1.0) : 0.0;
    drop[n] = share < 1.0 ? static_cast<float>(-40.0 * greyPerDb * std::log10(std::max(share, kLeastContact))) : 0.0F;
    ring[n] = static_cast<float>(255.0 + 40.0 * greyPerDb * std::log10(std::max(1.0 - share, kLeastContact)));
    // Full contact takes nothing and rings at nothing: addPowers then leaves the echo as it is.
    if (share >= 1.0) ring[n] = -1e9F;
  }
  const float perDoubling = levelsPerDoubling(greyPerDb);
  for (int y = 0; y < echoes.height; ++y) {
    const double depth_mm = y * sampleSpacing_mm;
    if (depth_mm > effect.ringDown_mm) {
      HWY_DYNAMIC_DISPATCH(dropRow)(drop, echoes.row(y), echoes.width);
      continue;
    }
    const double wave = std::sin(std::numbers::pi * depth_mm / kBarSpacing_mm);
    const double fade_db = effect.ringDown_mm > 0.0 ? kFade_db * depth_mm / effect.ringDown_mm : 0.0;
    const auto bar = static_cast<float>(-greyPerDb * (fade_db + kBarDepth_db * wave * wave));
    HWY_DYNAMIC_DISPATCH(ringDownRow)(perDoubling, bar, drop, ring, echoes.row(y), echoes.width);
  }
}

}  // namespace ew
#endif
