#include "ew/imaging/effects/reverberation.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "effects/grey_scale.h"
#include "effects/reverberation_lines.h"

// The instruction sets left out would only repeat the code of a neighbour.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/reverberation.cpp"
#include "hwy/foreach_target.h"
//
#include "effects/powers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ew {
namespace HWY_NAMESPACE {
namespace {

/// Notes `y` for the lines that have no interface yet and reach `level` here. @return lines without interface are left
bool findInRow(const float* echoes, int y, float level, int* interfaces, int width) {
  bool someLeft = false;
  forColumns(width, [&](auto d, int x) HWY_ATTR {
    const hn::RebindToSigned<decltype(d)> di;
    const auto found = hn::LoadU(di, interfaces + x);
    const auto open = hn::Lt(found, hn::Zero(di));
    if (hn::AllFalse(di, open)) return;
    someLeft = true;
    const auto strong = hn::RebindMask(di, hn::Ge(hn::LoadU(d, echoes + x), hn::Set(d, level)));
    hn::StoreU(hn::IfThenElse(hn::And(open, strong), hn::Set(di, y), found), di, interfaces + x);
  });
  return someLeft;
}

/// Echoes of the columns [x, x + lanes) that came back once more, from row `lines.firstRow` on.
template <class D>
HWY_INLINE void repeatColumns(D d, const ReverberationLines& lines, ImageView<float> echoes, int x) {
  const hn::RebindToSigned<D> di;
  const auto interfaces = hn::LoadU(di, lines.interfaces + x);
  const auto has = hn::Gt(interfaces, hn::Set(di, -1));
  if (hn::AllFalse(di, has)) return;
  const auto end = hn::LoadU(di, lines.ends + x);
  const auto smooth = hn::Gt(hn::LoadU(di, lines.smooth + x), hn::Zero(di));
  const bool mirrors = !hn::AllFalse(di, smooth);
  const auto one = hn::Set(di, 1);
  const auto zero = hn::Zero(di);
  const auto column = hn::Iota(di, x);
  const auto stride = hn::Set(di, static_cast<int>(echoes.stride));
  const auto tooOften = hn::Set(di, lines.bounces + 1);
  const auto never = hn::Set(d, 1e9F);
  const auto perDoubling = hn::Set(d, lines.perDoubling);
  const auto doublings = hn::Set(d, 1.0F / lines.perDoubling);

  int begin = echoes.height;
  for (int n = x; n < x + static_cast<int>(hn::Lanes(d)); ++n)
    if (lines.interfaces[n] >= 0) begin = std::min(begin, lines.ends[n] + 1);

  auto source = hn::Set(di, begin);  // the row that comes back in this one; n times reflected at the face
  auto times = zero;
  for (int y = begin; y < echoes.height; ++y, source = hn::Add(source, one)) {
    const auto past = hn::And(has, hn::Gt(source, end));
    source = hn::IfThenElse(past, hn::Sub(source, interfaces), source);
    times = hn::IfThenElse(past, hn::Add(times, one), times);
    const auto comesBack = hn::And(hn::Gt(times, zero), hn::Lt(times, tooOften));
    const auto row = hn::Set(di, y);
    float* const out = echoes.data + y * echoes.stride + x;
    auto level = hn::LoadU(d, out);
    bool somethingLeft = false;
    if (!hn::AllFalse(di, comesBack)) {
      somethingLeft = true;
      const auto from = hn::Add(hn::Mul(hn::IfThenElseZero(comesBack, source), stride), column);
      const auto loss = hn::IfThenElse(hn::RebindMask(d, comesBack), hn::Mul(hn::ConvertTo(d, times), hn::Set(d, lines.bounceLoss)), never);
      level = addPowers(d, level, hn::Sub(hn::GatherIndex(d, echoes.data, from), loss), perDoubling, doublings);
    }
    if (mirrors) {
      const auto mirrored = hn::Sub(hn::Add(interfaces, interfaces), row);
      const auto shows = hn::And(smooth, hn::And(hn::Gt(row, end), hn::Gt(mirrored, hn::Set(di, lines.firstSample - 1))));
      if (!hn::AllFalse(di, shows)) {
        somethingLeft = true;
        const auto from = hn::Add(hn::Mul(hn::IfThenElseZero(shows, mirrored), stride), column);
        const auto loss = hn::IfThenElse(hn::RebindMask(d, shows), hn::Set(d, lines.mirrorLoss), never);
        level = addPowers(d, level, hn::Sub(hn::GatherIndex(d, echoes.data, from), loss), perDoubling, doublings);
      }
    }
    if (somethingLeft) hn::StoreU(level, d, out);
  }
}

void repeat(const ReverberationLines& lines, ImageView<float> echoes) {
  forColumns(echoes.width, [&](auto d, int x) HWY_ATTR { repeatColumns(d, lines, echoes, x); });
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace ew
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew {
namespace {

HWY_EXPORT(findInRow);
HWY_EXPORT(repeat);

constexpr int kSmoothSamples = 6;  // neighbouring interfaces of a mirror lie within so many samples

bool isNear(const std::vector<int>& interfaces, std::size_t n, std::size_t neighbour) {
  return neighbour < interfaces.size() && interfaces[neighbour] >= 0 && std::abs(interfaces[neighbour] - interfaces[n]) <= kSmoothSamples;
}

}  // namespace

int reverberate(const ReverberationEffect& effect, double greyPerDb, int firstSample, ImageView<float> echoes,
                ReverberationScratch& scratch) {
  EW_EXPECTS(greyPerDb > 0.0);
  EW_EXPECTS(echoes.stride * static_cast<std::ptrdiff_t>(echoes.height) <= std::ptrdiff_t{1} << 30);
  const auto lines = static_cast<std::size_t>(echoes.width);
  scratch.interfaces.assign(lines, -1);
  scratch.ends.resize(lines);
  scratch.smooth.resize(lines);
  const auto strong = static_cast<float>(effect.interfaceLevel);
  const int nearest = std::max(firstSample, 1);
  for (int y = nearest; y < echoes.height; ++y)
    if (!HWY_DYNAMIC_DISPATCH(findInRow)(echoes.row(y), y, strong, scratch.interfaces.data(), echoes.width)) break;

  int count = 0;
  for (std::size_t n = 0; n < lines; ++n) {
    int& interface = scratch.interfaces[n];
    if (interface < 0) continue;
    ++count;
    // The echo's brightest sample stands for the interface, its falling flank belongs to it.
    const auto levelAt = [&](int y) { return echoes.at(static_cast<int>(n), y); };
    int end = interface;
    while (end + 1 < echoes.height && levelAt(end + 1) >= strong) {
      ++end;
      if (levelAt(end) > levelAt(interface)) interface = end;
    }
    while (end + 1 < echoes.height && levelAt(end + 1) < levelAt(end) && levelAt(end + 1) > 0.5F * strong) ++end;
    scratch.ends[n] = end;
  }
  if (count == 0) return 0;
  for (std::size_t n = 0; n < lines; ++n) {
    const bool leftIsNear = n == 0 || isNear(scratch.interfaces, n, n - 1);
    const bool rightIsNear = n + 1 == lines || isNear(scratch.interfaces, n, n + 1);
    scratch.smooth[n] = effect.mirror && lines > 1 && scratch.interfaces[n] >= 0 && leftIsNear && rightIsNear ? 1 : 0;
  }
  ReverberationLines repeated;
  repeated.interfaces = scratch.interfaces.data();
  repeated.ends = scratch.ends.data();
  repeated.smooth = scratch.smooth.data();
  repeated.firstSample = nearest;
  repeated.bounces = effect.bounces;
  repeated.bounceLoss = static_cast<float>(effect.loss_dbPerBounce * greyPerDb);
  repeated.mirrorLoss = static_cast<float>(effect.mirrorLoss_db * greyPerDb);
  repeated.perDoubling = levelsPerDoubling(greyPerDb);
  HWY_DYNAMIC_DISPATCH(repeat)(repeated, echoes);
  return count;
}

}  // namespace ew
#endif
