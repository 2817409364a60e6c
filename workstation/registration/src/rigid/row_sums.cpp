#include "row_sums.h"

#include <algorithm>

// The instruction sets left out would only repeat the code of a neighbour, or have vectors that cannot stand in arrays.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rigid/row_sums.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, as that asks for.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ew::registration::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void sumPoseRow(const PoseRow& job, PoseRowSums& out) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  const hn::Rebind<std::uint8_t, decltype(d)> du8;
  using V = hn::Vec<decltype(d)>;
  using VI = hn::Vec<decltype(di)>;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const V zero = hn::Zero(d);
  const V one = hn::Set(d, 1.0f);
  V count = zero, weight = zero, sf = zero, sm = zero, sff = zero, smm = zero, sfm = zero, srr = zero, srw = zero, sgfm = zero, sgff = zero,
    sgmm = zero;
  V moment[3][6];
  V right[2][3];
  for (auto& power : moment) {
    for (auto& v : power) v = zero;
  }
  for (auto& power : right) {
    for (auto& v : power) v = zero;
  }
  const VI topX = hn::Set(di, job.movingDims[0] - 2);
  const VI topY = hn::Set(di, job.movingDims[1] - 2);
  const VI topZ = hn::Set(di, job.movingDims[2] - 2);
  const VI rowStep = hn::Set(di, job.movingDims[0]);
  const VI planeStep = hn::Set(di, job.movingDims[0] * job.movingDims[1]);
  const VI zeroI = hn::Zero(di);
  const VI lowBits = hn::Set(di, 255);
  const VI oneI = hn::Set(di, 1);
  const V half = hn::Set(d, 0.5f);
  for (int i = job.begin; i < job.end; i += lanes) {
    const VI index = hn::Add(hn::Iota(di, 0), hn::Set(di, i));
    const V at = hn::ConvertTo(d, index);
    // Past the stretch the weight is nothing, and what is read there does not count. In the last rows of an image it may not be read.
    const bool atEnd = i + job.fixedPlane + lanes > job.room;
    const int inside = std::min(lanes, job.end - i);
    const auto load = [&](const float* from) HWY_ATTR {
      if (!atEnd) return hn::LoadU(d, from);
      HWY_ALIGN float some[hn::MaxLanes(d)] = {};
      std::copy_n(from, inside, some);
      return hn::Load(d, some);
    };
    const auto loadWeight = [&](const std::uint8_t* from) HWY_ATTR {
      if (!atEnd) return hn::LoadU(du8, from);
      HWY_ALIGN std::uint8_t some[hn::MaxLanes(d)] = {};
      std::copy_n(from, inside, some);
      return hn::LoadU(du8, some);
    };
    V w = hn::ConvertTo(d, hn::PromoteTo(di, loadWeight(job.fixedWeight + i)));
    w = hn::IfThenElseZero(hn::Lt(at, hn::Set(d, static_cast<float>(job.end))), w);
    if (hn::AllTrue(d, hn::Eq(w, zero))) continue;
    const V x = hn::MulAdd(at, hn::Set(d, job.step[0]), hn::Set(d, job.at[0]));
    const V y = hn::MulAdd(at, hn::Set(d, job.step[1]), hn::Set(d, job.at[1]));
    const V z = hn::MulAdd(at, hn::Set(d, job.step[2]), hn::Set(d, job.at[2]));
    const VI ix = hn::Min(hn::Max(hn::ConvertTo(di, hn::Floor(x)), zeroI), topX);
    const VI iy = hn::Min(hn::Max(hn::ConvertTo(di, hn::Floor(y)), zeroI), topY);
    const VI iz = hn::Min(hn::Max(hn::ConvertTo(di, hn::Floor(z)), zeroI), topZ);
    const V fx = hn::Sub(x, hn::ConvertTo(d, ix));
    const V fy = hn::Sub(y, hn::ConvertTo(d, iy));
    const V fz = hn::Sub(z, hn::ConvertTo(d, iz));
    const VI base = hn::Add(ix, hn::Add(hn::Mul(iy, rowStep), hn::Mul(iz, planeStep)));
    const V c000 = hn::GatherIndex(d, job.moving, base);
    const V c100 = hn::GatherIndex(d, job.moving, hn::Add(base, oneI));
    const VI up = hn::Add(base, rowStep);
    const V c010 = hn::GatherIndex(d, job.moving, up);
    const V c110 = hn::GatherIndex(d, job.moving, hn::Add(up, oneI));
    const VI over = hn::Add(base, planeStep);
    const V c001 = hn::GatherIndex(d, job.moving, over);
    const V c101 = hn::GatherIndex(d, job.moving, hn::Add(over, oneI));
    const VI both = hn::Add(over, rowStep);
    const V c011 = hn::GatherIndex(d, job.moving, both);
    const V c111 = hn::GatherIndex(d, job.moving, hn::Add(both, oneI));
    const auto bits = [&](V v) HWY_ATTR { return hn::And(hn::BitCast(di, v), lowBits); };
    const VI leastBits = hn::Min(hn::Min(hn::Min(bits(c000), bits(c100)), hn::Min(bits(c010), bits(c110))),
                                 hn::Min(hn::Min(bits(c001), bits(c101)), hn::Min(bits(c011), bits(c111))));
    w = hn::Mul(hn::Mul(w, hn::ConvertTo(d, leastBits)), hn::Set(d, 1.0f / (255.0f * 255.0f)));
    const auto valid = hn::Gt(w, zero);
    if (hn::AllFalse(d, valid)) continue;

    const V dx00 = hn::Sub(c100, c000);
    const V dx10 = hn::Sub(c110, c010);
    const V dx01 = hn::Sub(c101, c001);
    const V dx11 = hn::Sub(c111, c011);
    const V e00 = hn::MulAdd(fx, dx00, c000);
    const V e10 = hn::MulAdd(fx, dx10, c010);
    const V e01 = hn::MulAdd(fx, dx01, c001);
    const V e11 = hn::MulAdd(fx, dx11, c011);
    const V dy0 = hn::Sub(e10, e00);
    const V dy1 = hn::Sub(e11, e01);
    const V g0 = hn::MulAdd(fy, dy0, e00);
    const V g1 = hn::MulAdd(fy, dy1, e01);
    const V gz = hn::Sub(g1, g0);
    const V m = hn::MulAdd(fz, gz, g0);
    const V f = load(job.fixedValue + i);
    const V r = hn::Sub(f, m);
    count = hn::Add(count, hn::IfThenElseZero(valid, one));
    weight = hn::Add(weight, w);
    const V wf = hn::Mul(w, f);
    const V wm = hn::Mul(w, m);
    sf = hn::Add(sf, wf);
    sm = hn::Add(sm, wm);
    sff = hn::MulAdd(wf, f, sff);
    smm = hn::MulAdd(wm, m, smm);
    sfm = hn::MulAdd(wf, m, sfm);
    if (!job.derivatives) continue;

    const V rr = hn::Mul(r, r);
    const V robust = hn::Div(w, hn::MulAdd(rr, hn::Set(d, job.perLoss2), one));
    srr = hn::MulAdd(robust, rr, srr);
    srw = hn::Add(srw, robust);
    const V dx0 = hn::MulAdd(fy, hn::Sub(dx10, dx00), dx00);
    const V dx1 = hn::MulAdd(fy, hn::Sub(dx11, dx01), dx01);
    const V gx = hn::MulAdd(fz, hn::Sub(dx1, dx0), dx0);
    const V gy = hn::MulAdd(fz, hn::Sub(dy1, dy0), dy0);
    const float* fixed = job.fixedValue + i;
    const V ffx = hn::Mul(half, hn::Sub(load(fixed + 1), load(fixed - 1)));
    const V ffy = hn::Mul(half, hn::Sub(load(fixed + job.fixedRow), load(fixed - job.fixedRow)));
    const V ffz = hn::Mul(half, hn::Sub(load(fixed + job.fixedPlane), load(fixed - job.fixedPlane)));
    const auto turned = [&](int a) HWY_ATTR {
      const V sum = hn::Mul(hn::Set(d, job.turn[3 * a]), gx);
      return hn::MulAdd(hn::Set(d, job.turn[3 * a + 2]), gz, hn::MulAdd(hn::Set(d, job.turn[3 * a + 1]), gy, sum));
    };
    const V mmx = turned(0);
    const V mmy = turned(1);
    const V mmz = turned(2);
    sgfm = hn::MulAdd(robust, hn::MulAdd(ffx, mmx, hn::MulAdd(ffy, mmy, hn::Mul(ffz, mmz))), sgfm);
    sgff = hn::MulAdd(robust, hn::MulAdd(ffx, ffx, hn::MulAdd(ffy, ffy, hn::Mul(ffz, ffz))), sgff);
    sgmm = hn::MulAdd(robust, hn::MulAdd(mmx, mmx, hn::MulAdd(mmy, mmy, hn::Mul(mmz, mmz))), sgmm);
    const V ax = hn::Mul(half, hn::Add(ffx, mmx));
    const V ay = hn::Mul(half, hn::Add(ffy, mmy));
    const V az = hn::Mul(half, hn::Add(ffz, mmz));
    const V place = hn::Mul(hn::Sub(at, hn::Set(d, job.middle)), hn::Set(d, job.perMiddle));
    const V wx = hn::Mul(robust, ax);
    const V wy = hn::Mul(robust, ay);
    const V wz = hn::Mul(robust, az);
    const V products[6] = {hn::Mul(wx, ax), hn::Mul(wx, ay), hn::Mul(wx, az), hn::Mul(wy, ay), hn::Mul(wy, az), hn::Mul(wz, az)};
    for (int q = 0; q < 6; ++q) {
      moment[0][q] = hn::Add(moment[0][q], products[q]);
      const V once = hn::Mul(products[q], place);
      moment[1][q] = hn::Add(moment[1][q], once);
      moment[2][q] = hn::MulAdd(once, place, moment[2][q]);
    }
    const V rp = hn::Mul(r, place);
    right[0][0] = hn::MulAdd(wx, r, right[0][0]);
    right[0][1] = hn::MulAdd(wy, r, right[0][1]);
    right[0][2] = hn::MulAdd(wz, r, right[0][2]);
    right[1][0] = hn::MulAdd(wx, rp, right[1][0]);
    right[1][1] = hn::MulAdd(wy, rp, right[1][1]);
    right[1][2] = hn::MulAdd(wz, rp, right[1][2]);
  }
  const auto total = [&](V v) HWY_ATTR { return static_cast<double>(hn::GetLane(hn::SumOfLanes(d, v))); };
  out.count = total(count);
  out.weight = total(weight);
  out.f = total(sf);
  out.m = total(sm);
  out.ff = total(sff);
  out.mm = total(smm);
  out.fm = total(sfm);
  if (!job.derivatives) return;
  out.residual = total(srr);
  out.robustWeight = total(srw);
  out.bothGradients = total(sgfm);
  out.fixedGradient = total(sgff);
  out.movingGradient = total(sgmm);
  for (int p = 0; p < 3; ++p) {
    for (int q = 0; q < 6; ++q) out.moment[p][q] = total(moment[p][q]);
  }
  for (int p = 0; p < 2; ++p) {
    for (int q = 0; q < 3; ++q) out.right[p][q] = total(right[p][q]);
  }
}

}  // namespace ew::registration::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew::registration {
HWY_EXPORT(sumPoseRow);
void sumPoseRow(const PoseRow& job, PoseRowSums& sums) { HWY_DYNAMIC_DISPATCH(sumPoseRow)(job, sums); }
}  // namespace ew::registration
#endif
