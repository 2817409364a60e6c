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
  const auto one = hn::Set(di, 1);
  const auto zero = hn::Zero(di);
  const auto column = hn::Iota(di, x);
  const auto stride = hn::Set(di, static_cast<int>(echoes.stride));
  const auto tooOften = hn::Add(hn::LoadU(di, lines.bounces + x), one);
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
    if (lines.mirror) {
      const auto mirrored = hn::Sub(hn::Add(interfaces, interfaces), row);
      const auto shows = hn::And(has, hn::And(hn::Gt(row, end), hn::Gt(mirrored, hn::Set(di, lines.firstSample - 1))));
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

constexpr int kReach = 6;            // samples between the interfaces of neighbouring lines
constexpr int kLeastLines = 9;       // fewer lines side by side are speckle
constexpr int kChord = 4;            // lines to each side over which an interface's curvature is measured
constexpr double kMostBulge = 1.0;   // samples: a surface that bulges more towards the probe scatters the sound away
constexpr int kMostTilt = 1;         // samples a line: a steeper surface sends the sound past the face
constexpr float kWeakShare = 0.75F;  // of the strong level: an interface goes on beside a strong part of it down to here

/// The brightest sample of a line within reach of its neighbour's interface; -1 when it is too dark or there is none.
int interfaceBeside(ImageView<const float> echoes, int line, int neighbour, int firstSample, float level) {
  if (neighbour < 0) return -1;
  int best = -1;
  for (int y = std::max(neighbour - kReach, firstSample); y <= std::min(neighbour + kReach, echoes.height - 1); ++y)
    if (echoes.at(line, y) >= level && (best < 0 || echoes.at(line, y) > echoes.at(line, best))) best = y;
  return best;
}

/// The brighter of two samples of a line, the nearer when they are alike; -1 stands for none.
int stronger(ImageView<const float> echoes, int line, int a, int b) {
  if (a < 0 || b < 0) return std::max(a, b);
  const float levelA = echoes.at(line, a), levelB = echoes.at(line, b);
  if (levelA == levelB) return std::min(a, b);
  return levelA > levelB ? a : b;
}

/// Takes away what is no interface: too few lines side by side, or a small body that bulges towards the probe.
void keepInterfaces(std::vector<int>& interfaces) {
  const auto lines = static_cast<int>(interfaces.size());
  const auto at = [&](int n) { return interfaces[static_cast<std::size_t>(n)]; };
  for (int begin = 0; begin < lines;) {
    int end = begin + 1;
    if (at(begin) < 0) {
      begin = end;
      continue;
    }
    while (end < lines && at(end) >= 0 && std::abs(at(end) - at(end - 1)) <= kReach) ++end;
    int bulge = 0;  // twice the sum of how far the ends of a chord lie behind its middle
    for (int n = begin + kChord; n + kChord < end; ++n) bulge += at(n - kChord) + at(n + kChord) - 2 * at(n);
    const int chords = std::max(end - begin - 2 * kChord, 0);
    if (end - begin < std::min(lines, kLeastLines) || bulge > 2.0 * kMostBulge * chords)
      std::fill(interfaces.begin() + begin, interfaces.begin() + end, -1);
    begin = end;
  }
}

/// Whether the interface about a line is too steep for its echo to meet the face again.
bool isTilted(const std::vector<int>& interfaces, int line) {
  const auto at = [&](int n) { return interfaces[static_cast<std::size_t>(n)]; };
  const auto goesOn = [&](int n, int next) {
    return next >= 0 && next < static_cast<int>(interfaces.size()) && at(next) >= 0 && std::abs(at(next) - at(n)) <= kReach;
  };
  int left = line, right = line;
  while (line - left < kChord && goesOn(left, left - 1)) --left;
  while (right - line < kChord && goesOn(right, right + 1)) ++right;
  return std::abs(at(right) - at(left)) > kMostTilt * (right - left);
}

}  // namespace

int reverberate(const ReverberationEffect& effect, double greyPerDb, int firstSample, ImageView<float> echoes,
                ReverberationScratch& scratch) {
  EW_EXPECTS(greyPerDb > 0.0);
  EW_EXPECTS(echoes.stride * static_cast<std::ptrdiff_t>(echoes.height) <= std::ptrdiff_t{1} << 30);
  const auto lines = static_cast<std::size_t>(echoes.width);
  scratch.interfaces.assign(lines, -1);
  scratch.ends.resize(lines);
  scratch.bounces.resize(lines);
  const auto strong = static_cast<float>(effect.interfaceLevel);
  const int nearest = std::max(firstSample, 1);
  for (int y = nearest; y < echoes.height; ++y)
    if (!HWY_DYNAMIC_DISPATCH(findInRow)(echoes.row(y), y, strong, scratch.interfaces.data(), echoes.width)) break;

  const auto levelAt = [&](std::size_t n, int y) { return echoes.at(static_cast<int>(n), y); };
  bool found = false;
  for (std::size_t n = 0; n < lines; ++n) {
    int& interface = scratch.interfaces[n];
    if (interface < 0) continue;
    found = true;
    // The echo's brightest sample stands for the interface.
    for (int y = interface + 1; y < echoes.height && levelAt(n, y) >= strong; ++y)
      if (levelAt(n, y) > levelAt(n, interface)) interface = y;
  }
  if (!found) return 0;
  // From both sides on their own, so that a mirrored image has the mirrored interfaces.
  const float weak = kWeakShare * strong;
  scratch.fromRight = scratch.interfaces;
  for (std::size_t n = 1; n < lines; ++n)
    if (scratch.interfaces[n] < 0)
      scratch.interfaces[n] = interfaceBeside(echoes, static_cast<int>(n), scratch.interfaces[n - 1], nearest, weak);
  for (std::size_t n = lines - 1; n-- > 0;)
    if (scratch.fromRight[n] < 0)
      scratch.fromRight[n] = interfaceBeside(echoes, static_cast<int>(n), scratch.fromRight[n + 1], nearest, weak);
  for (std::size_t n = 0; n < lines; ++n)
    scratch.interfaces[n] = stronger(echoes, static_cast<int>(n), scratch.interfaces[n], scratch.fromRight[n]);
  keepInterfaces(scratch.interfaces);

  int count = 0;
  for (std::size_t n = 0; n < lines; ++n) {
    int end = scratch.interfaces[n];
    if (end < 0) continue;
    ++count;
    // What stays as bright and the falling flank behind it belong to the interface's own echo.
    while (end + 1 < echoes.height && levelAt(n, end + 1) >= strong) ++end;
    while (end + 1 < echoes.height && levelAt(n, end + 1) < levelAt(n, end) && levelAt(n, end + 1) > 0.5F * strong) ++end;
    scratch.ends[n] = end;
    scratch.bounces[n] = isTilted(scratch.interfaces, static_cast<int>(n)) ? 0 : effect.bounces;
  }
  if (count == 0) return 0;

  ReverberationLines repeated;
  repeated.interfaces = scratch.interfaces.data();
  repeated.ends = scratch.ends.data();
  repeated.mirror = effect.mirror;
  repeated.firstSample = nearest;
  repeated.bounces = scratch.bounces.data();
  repeated.bounceLoss = static_cast<float>(effect.loss_dbPerBounce * greyPerDb);
  repeated.mirrorLoss = static_cast<float>(effect.mirrorLoss_db * greyPerDb);
  repeated.perDoubling = levelsPerDoubling(greyPerDb);
  HWY_DYNAMIC_DISPATCH(repeat)(repeated, echoes);
  return count;
}

}  // namespace ew
#endif
