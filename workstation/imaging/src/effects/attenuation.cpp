#include "ew/imaging/effects/attenuation.h"

#include <algorithm>
#include <cmath>

// The instruction sets left out would only repeat the code of a neighbour.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/attenuation.cpp"
#include "hwy/foreach_target.h"
//
#include "effects/attenuation_rows.h"
#include "effects/powers-inl.h"
#include "probes/sound.h"

HWY_BEFORE_NAMESPACE();
namespace ew {
namespace HWY_NAMESPACE {
namespace {

template <class D>
HWY_INLINE hn::Vec<D> ramp(D d, hn::Vec<D> x, float from, float slope) {
  const auto t = hn::Mul(hn::Sub(x, hn::Set(d, from)), hn::Set(d, slope));
  return hn::Min(hn::Max(t, hn::Zero(d)), hn::Set(d, 1.0F));
}

template <class D>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> labelsAt(D /*d*/, const std::uint8_t* labels) {
  const hn::RebindToSigned<D> di;
  const hn::Rebind<std::uint8_t, D> du8;
  return hn::PromoteTo(di, hn::LoadU(du8, labels));
}

/// One row of samples. kLabels: tissues decide where they are known; kGrey: some samples need their grey level looked at.
template <bool kLabels, bool kGrey>
void row(const AttenuationRows& rows, const std::uint8_t* labels, const std::uint8_t* labelsAbove, bool first, float* echoes, int width) {
  // Trapezoid rule: half of the first sample's loss lies before the face.
  const float before = first ? 0.0F : 0.5F;
  const float after = first ? 0.5F : 1.0F;
  forColumns(width, [&](auto d, int x) HWY_ATTR {
    const auto echo = hn::LoadU(d, echoes + x);
    auto own = hn::Zero(d);
    auto waiting = hn::LoadU(d, rows.waiting + x);
    if constexpr (kGrey) {
      auto smooth = hn::LoadU(d, rows.smooth + x);
      smooth = hn::Add(smooth, hn::Mul(hn::Sub(echo, smooth), hn::Set(d, first ? 1.0F : rows.smoothing)));
      hn::StoreU(smooth, d, rows.smooth + x);
      const auto tissue = ramp(d, smooth, rows.fluidLevel, rows.fluidSlope);
      const auto seen = hn::Max(hn::LoadU(d, rows.seen + x), tissue);
      hn::StoreU(seen, d, rows.seen + x);
      const auto reflecting = hn::Mul(ramp(d, echo, rows.interfaceFrom, rows.interfaceSlope), hn::Set(d, rows.interfaceStep_db));
      const auto fluid = hn::Mul(hn::Sub(seen, tissue), hn::Set(d, rows.expectedStep_db));
      own = hn::Sub(reflecting, fluid);
    }
    if constexpr (kLabels) {
      const auto label = labelsAt(d, labels + x);
      const auto known = hn::GatherIndex(d, rows.perSample_db, label);
      own = kGrey ? hn::IfThenElse(hn::Lt(known, hn::Set(d, 0.5F * AttenuationRows::kUnknown)), own, known) : known;
      const auto above = labelsAt(d, labelsAbove + x);
      const hn::RebindToSigned<decltype(d)> di;
      if (!hn::AllFalse(di, hn::Ne(label, above))) {
        // Between tissues that sound alike there is nothing to enter, whatever their labels.
        const auto reflected = hn::GatherIndex(d, rows.onEntering_db, label);
        const auto entered = hn::Or(hn::Ne(reflected, hn::GatherIndex(d, rows.onEntering_db, above)),
                                    hn::Ne(known, hn::GatherIndex(d, rows.perSample_db, above)));
        waiting = hn::Add(waiting, hn::IfThenElseZero(entered, reflected));
      }
    }
    const auto least = hn::Set(d, -rows.largestEnhancement_db);
    const auto lossBefore = hn::LoadU(d, rows.loss + x);
    const auto loss = hn::Max(hn::Add(lossBefore, hn::Mul(own, hn::Set(d, before))), least);
    const auto released = hn::Mul(waiting, hn::Set(d, rows.release));
    hn::StoreU(hn::Max(hn::Add(hn::Add(lossBefore, hn::Mul(own, hn::Set(d, after))), released), least), d, rows.loss + x);
    if constexpr (kLabels) hn::StoreU(hn::Sub(waiting, released), d, rows.waiting + x);

    // Level 0 stands for everything below the recorded range, so that a gain comes in over the lowest levels.
    const auto greyLoss = hn::Mul(loss, hn::Set(d, rows.greyPerDb));
    const auto visible =
        ramp(d, echo, AttenuationRows::kNoGainLevel, 1.0F / (AttenuationRows::kFullGainLevel - AttenuationRows::kNoGainLevel));
    const auto taken = hn::Max(greyLoss, hn::Zero(d));
    const auto given = hn::Mul(hn::Min(greyLoss, hn::Zero(d)), visible);
    hn::StoreU(hn::Sub(hn::Sub(echo, taken), given), d, echoes + x);
  });
}

void rowByTissue(const AttenuationRows& rows, const std::uint8_t* labels, const std::uint8_t* above, bool first, float* echoes, int width) {
  row<true, false>(rows, labels, above, first, echoes, width);
}
void rowByBoth(const AttenuationRows& rows, const std::uint8_t* labels, const std::uint8_t* above, bool first, float* echoes, int width) {
  row<true, true>(rows, labels, above, first, echoes, width);
}
void rowByGrey(const AttenuationRows& rows, bool first, float* echoes, int width) {
  row<false, true>(rows, nullptr, nullptr, first, echoes, width);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace ew
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew {
namespace {

HWY_EXPORT(rowByTissue);
HWY_EXPORT(rowByBoth);
HWY_EXPORT(rowByGrey);

constexpr double kSmoothing_mm = 2.0;        // of the grey level that is compared with a fluid's
constexpr float kInterfaceSoftness = 40.0F;  // grey levels below interfaceLevel over which an interface's loss comes in

/// What a sample's length there and back is worth to an attenuation in dB/(cm MHz).
double path_cmMhz(double carrier_hz, double sampleSpacing_mm) { return 2.0 * 0.1 * sampleSpacing_mm * 1e-6 * carrier_hz; }

/// Share of what is waiting that a sample releases when `length_mm` is the 1/e length.
float shareOfSample(double sampleSpacing_mm, double length_mm) { return static_cast<float>(1.0 - std::exp(-sampleSpacing_mm / length_mm)); }

}  // namespace

TissueLosses makeTissueLosses(const Scene& scene, double carrier_hz, double sampleSpacing_mm) {
  EW_EXPECTS(carrier_hz > 0.0 && sampleSpacing_mm > 0.0);
  TissueLosses losses;
  const double expected_dbPerCmMhz = scene.attenuation.value_or(AttenuationEffect{}).expected_dbPerCmMhz;
  const double sample_cmMhz = path_cmMhz(carrier_hz, sampleSpacing_mm);
  for (const TissueAcoustics& tissue : scene.tissues) {
    if (tissue.label < 0 || tissue.label > 255) continue;
    const auto label = static_cast<std::size_t>(tissue.label);
    losses.perSample_db[label] = static_cast<float>((tissue.attenuation_dbPerCmMhz - expected_dbPerCmMhz) * sample_cmMhz);
    losses.onEntering_db[label] = static_cast<float>(tissue.reflection_db);
    losses.known[label] = true;
  }
  return losses;
}

void attenuate(const AttenuationEffect& effect, const TissueLosses& losses, ImageView<const std::uint8_t> labels, double greyPerDb,
               double carrier_hz, double sampleSpacing_mm, ImageView<float> echoes, std::vector<float>& scratch) {
  EW_EXPECTS(greyPerDb > 0.0 && carrier_hz > 0.0 && sampleSpacing_mm > 0.0);
  const bool hasLabels = labels.data != nullptr && labels.width > 0;
  EW_EXPECTS(!hasLabels || (labels.width == echoes.width && labels.height == echoes.height));
  const auto lines = static_cast<std::size_t>(echoes.width);
  scratch.resize(256 + 4 * lines);
  std::fill(scratch.begin(), scratch.end(), 0.0F);
  bool allKnown = true;
  if (hasLabels)
    for (std::size_t label = 0; label < 256; ++label) {
      scratch[label] = losses.known[label] ? losses.perSample_db[label] : AttenuationRows::kUnknown;
      allKnown = allKnown && losses.known[label];
    }

  AttenuationRows rows;
  rows.perSample_db = scratch.data();
  rows.onEntering_db = losses.onEntering_db.data();
  rows.loss = scratch.data() + 256;
  rows.waiting = rows.loss + lines;
  rows.smooth = rows.waiting + lines;
  rows.seen = rows.smooth + lines;
  rows.greyPerDb = static_cast<float>(greyPerDb);
  rows.largestEnhancement_db = static_cast<float>(effect.largestEnhancement_db);
  rows.smoothing = shareOfSample(sampleSpacing_mm, kSmoothing_mm);
  rows.release = shareOfSample(sampleSpacing_mm, detail::kSpeedOfSound_mmPerS / carrier_hz);
  rows.interfaceFrom = static_cast<float>(effect.interfaceLevel) - kInterfaceSoftness;
  rows.interfaceSlope = 1.0F / kInterfaceSoftness;
  rows.interfaceStep_db = static_cast<float>(effect.interface_dbPerMm * sampleSpacing_mm);
  rows.fluidLevel = static_cast<float>(effect.fluidLevel);
  rows.fluidSlope = 1.0F / std::max(0.5F * rows.fluidLevel, 1.0F);
  rows.expectedStep_db = static_cast<float>(effect.expected_dbPerCmMhz * path_cmMhz(carrier_hz, sampleSpacing_mm));

  for (int y = 0; y < echoes.height; ++y) {
    float* echo = echoes.row(y);
    const bool first = y == 0;
    if (!hasLabels) {
      HWY_DYNAMIC_DISPATCH(rowByGrey)(rows, first, echo, echoes.width);
      continue;
    }
    const std::uint8_t* here = labels.row(y);
    const std::uint8_t* above = labels.row(std::max(y - 1, 0));
    if (allKnown)
      HWY_DYNAMIC_DISPATCH(rowByTissue)(rows, here, above, first, echo, echoes.width);
    else
      HWY_DYNAMIC_DISPATCH(rowByBoth)(rows, here, above, first, echo, echoes.width);
  }
}

}  // namespace ew
#endif
