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

using PoseFloats = hn::ScalableTag<float>;
using PoseInts = hn::RebindToSigned<PoseFloats>;
using PoseBytes = hn::Rebind<std::uint8_t, PoseFloats>;
using PoseV = hn::Vec<PoseFloats>;
using PoseVI = hn::Vec<PoseInts>;

// Everything below is inlined into the one loop at the end: the sums stay in vectors over a whole row.

/// Reads fixed voxels. Past the stretch the weight is nothing, and what is read there does not count; in the last rows of an image it may
/// not be read.
struct PoseReader {
  bool atEnd;
  int inside;

  HWY_INLINE PoseV values(const float* from) const {
    const PoseFloats d;
    if (!atEnd) return hn::LoadU(d, from);
    HWY_ALIGN float some[hn::MaxLanes(d)] = {};
    std::copy_n(from, inside, some);
    return hn::Load(d, some);
  }
  HWY_INLINE PoseV weights(const std::uint8_t* from) const {
    const PoseFloats d;
    const PoseInts di;
    const PoseBytes du8;
    if (!atEnd) return hn::ConvertTo(d, hn::PromoteTo(di, hn::LoadU(du8, from)));
    HWY_ALIGN std::uint8_t some[hn::MaxLanes(d)] = {};
    std::copy_n(from, inside, some);
    return hn::ConvertTo(d, hn::PromoteTo(di, hn::LoadU(du8, some)));
  }
};

/// The eight moving voxels around each place, and the place among them.
struct PoseCell {
  PoseV fx, fy, fz;
  PoseV c000, c100, c010, c110, c001, c101, c011, c111;

  HWY_INLINE PoseCell(const PoseRow& job, PoseV at) {
    const PoseFloats d;
    const PoseInts di;
    const PoseV x = hn::MulAdd(at, hn::Set(d, job.step[0]), hn::Set(d, job.at[0]));
    const PoseV y = hn::MulAdd(at, hn::Set(d, job.step[1]), hn::Set(d, job.at[1]));
    const PoseV z = hn::MulAdd(at, hn::Set(d, job.step[2]), hn::Set(d, job.at[2]));
    const PoseVI ix = lowOf(x, job.movingDims[0]);
    const PoseVI iy = lowOf(y, job.movingDims[1]);
    const PoseVI iz = lowOf(z, job.movingDims[2]);
    fx = hn::Sub(x, hn::ConvertTo(d, ix));
    fy = hn::Sub(y, hn::ConvertTo(d, iy));
    fz = hn::Sub(z, hn::ConvertTo(d, iz));
    const PoseVI one = hn::Set(di, 1);
    const PoseVI row = hn::Set(di, job.movingDims[0]);
    const PoseVI plane = hn::Set(di, job.movingDims[0] * job.movingDims[1]);
    const PoseVI base = hn::Add(ix, hn::Add(hn::Mul(iy, row), hn::Mul(iz, plane)));
    c000 = hn::GatherIndex(d, job.moving, base);
    c100 = hn::GatherIndex(d, job.moving, hn::Add(base, one));
    const PoseVI up = hn::Add(base, row);
    c010 = hn::GatherIndex(d, job.moving, up);
    c110 = hn::GatherIndex(d, job.moving, hn::Add(up, one));
    const PoseVI over = hn::Add(base, plane);
    c001 = hn::GatherIndex(d, job.moving, over);
    c101 = hn::GatherIndex(d, job.moving, hn::Add(over, one));
    const PoseVI both = hn::Add(over, row);
    c011 = hn::GatherIndex(d, job.moving, both);
    c111 = hn::GatherIndex(d, job.moving, hn::Add(both, one));
  }

  /// The least of the corners' weights, which stand in the lowest bits of their values; 0..255.
  [[nodiscard]] HWY_INLINE PoseV leastWeight() const {
    const PoseFloats d;
    return hn::ConvertTo(d, hn::Min(hn::Min(hn::Min(weightOf(c000), weightOf(c100)), hn::Min(weightOf(c010), weightOf(c110))),
                                    hn::Min(hn::Min(weightOf(c001), weightOf(c101)), hn::Min(weightOf(c011), weightOf(c111)))));
  }

 private:
  static HWY_INLINE PoseVI lowOf(PoseV place, int dims) {
    const PoseInts di;
    return hn::Min(hn::Max(hn::ConvertTo(di, hn::Floor(place)), hn::Zero(di)), hn::Set(di, dims - 2));
  }
  static HWY_INLINE PoseVI weightOf(PoseV corner) {
    const PoseInts di;
    return hn::And(hn::BitCast(di, corner), hn::Set(di, 255));
  }
};

/// The moving image between the voxels of a cell: trilinear, its derivatives those of the interpolation.
struct PoseMate {
  PoseV dx00, dx10, dx01, dx11, dy0, dy1, dz;
  PoseV value;

  HWY_INLINE explicit PoseMate(const PoseCell& c) {
    dx00 = hn::Sub(c.c100, c.c000);
    dx10 = hn::Sub(c.c110, c.c010);
    dx01 = hn::Sub(c.c101, c.c001);
    dx11 = hn::Sub(c.c111, c.c011);
    const PoseV e00 = hn::MulAdd(c.fx, dx00, c.c000);
    const PoseV e10 = hn::MulAdd(c.fx, dx10, c.c010);
    const PoseV e01 = hn::MulAdd(c.fx, dx01, c.c001);
    const PoseV e11 = hn::MulAdd(c.fx, dx11, c.c011);
    dy0 = hn::Sub(e10, e00);
    dy1 = hn::Sub(e11, e01);
    const PoseV g0 = hn::MulAdd(c.fy, dy0, e00);
    const PoseV g1 = hn::MulAdd(c.fy, dy1, e01);
    dz = hn::Sub(g1, g0);
    value = hn::MulAdd(c.fz, dz, g0);
  }
};

/// A gradient along the fixed axes.
struct PoseGradient {
  PoseV x, y, z;

  [[nodiscard]] HWY_INLINE PoseV dot(const PoseGradient& o) const { return hn::MulAdd(x, o.x, hn::MulAdd(y, o.y, hn::Mul(z, o.z))); }
};

/// Of the moving image, turned from its own axes to the fixed ones.
HWY_INLINE PoseGradient movingGradient(const PoseRow& job, const PoseCell& c, const PoseMate& m) {
  const PoseFloats d;
  const PoseV dx0 = hn::MulAdd(c.fy, hn::Sub(m.dx10, m.dx00), m.dx00);
  const PoseV dx1 = hn::MulAdd(c.fy, hn::Sub(m.dx11, m.dx01), m.dx01);
  const PoseV gx = hn::MulAdd(c.fz, hn::Sub(dx1, dx0), dx0);
  const PoseV gy = hn::MulAdd(c.fz, hn::Sub(m.dy1, m.dy0), m.dy0);
  const auto turned = [&](std::ptrdiff_t a) HWY_ATTR {
    const PoseV sum = hn::Mul(hn::Set(d, job.turn[3 * a]), gx);
    return hn::MulAdd(hn::Set(d, job.turn[3 * a + 2]), m.dz, hn::MulAdd(hn::Set(d, job.turn[3 * a + 1]), gy, sum));
  };
  return {turned(0), turned(1), turned(2)};
}

/// Central differences.
HWY_INLINE PoseGradient fixedGradient(const PoseRow& job, const float* fixed, const PoseReader& read) {
  const PoseFloats d;
  const PoseV half = hn::Set(d, 0.5F);
  return {hn::Mul(half, hn::Sub(read.values(fixed + 1), read.values(fixed - 1))),
          hn::Mul(half, hn::Sub(read.values(fixed + job.fixedRow), read.values(fixed - job.fixedRow))),
          hn::Mul(half, hn::Sub(read.values(fixed + job.fixedPlane), read.values(fixed - job.fixedPlane)))};
}

HWY_INLINE double poseTotal(PoseV v) {
  const PoseFloats d;
  return static_cast<double>(hn::GetLane(hn::SumOfLanes(d, v)));
}

/// Sums of weights, values and their products.
struct PoseValueSums {
  PoseV count, weight, f, m, ff, mm, fm;

  HWY_INLINE PoseValueSums() { count = weight = f = m = ff = mm = fm = hn::Zero(PoseFloats()); }
  template <class Mask>
  HWY_INLINE void add(Mask valid, PoseV w, PoseV fixed, PoseV moving) {
    count = hn::Add(count, hn::IfThenElseZero(valid, hn::Set(PoseFloats(), 1.0F)));
    weight = hn::Add(weight, w);
    const PoseV wf = hn::Mul(w, fixed);
    const PoseV wm = hn::Mul(w, moving);
    f = hn::Add(f, wf);
    m = hn::Add(m, wm);
    ff = hn::MulAdd(wf, fixed, ff);
    mm = hn::MulAdd(wm, moving, mm);
    fm = hn::MulAdd(wf, moving, fm);
  }
  HWY_INLINE void total(PoseRowSums& out) const {
    out.count = poseTotal(count);
    out.weight = poseTotal(weight);
    out.f = poseTotal(f);
    out.m = poseTotal(m);
    out.ff = poseTotal(ff);
    out.mm = poseTotal(mm);
    out.fm = poseTotal(fm);
  }
};

/// Sums of gradients and residuals under the robust weight w / (1 + r^2 / lossScale^2). The Jacobian of a voxel is its lever, linear in the
/// place t along the row, times the mean a of both gradients: moments of a a^T and a r with powers of t are all a row has to hand over, and
/// normal_equations.cpp puts the levers to them. resources/docs/science/registration.md, "By the images", "Refining".
struct PoseGradientSums {
  PoseV residual, robust, both, fixed, moving;
  PoseV moment[3][6];
  PoseV right[2][3];

  HWY_INLINE PoseGradientSums() {
    const PoseV zero = hn::Zero(PoseFloats());
    residual = robust = both = fixed = moving = zero;
    for (auto& power : moment) {
      for (auto& v : power) v = zero;
    }
    for (auto& power : right) {
      for (auto& v : power) v = zero;
    }
  }
  /// @param place along the row, times perMiddle
  HWY_INLINE void add(const PoseRow& job, PoseV place, PoseV w, PoseV r, const PoseGradient& f, const PoseGradient& m) {
    const PoseFloats d;
    const PoseV half = hn::Set(d, 0.5F);
    const PoseV rr = hn::Mul(r, r);
    const PoseV weight = hn::Div(w, hn::MulAdd(rr, hn::Set(d, job.perLoss2), hn::Set(d, 1.0F)));
    residual = hn::MulAdd(weight, rr, residual);
    robust = hn::Add(robust, weight);
    both = hn::MulAdd(weight, f.dot(m), both);
    fixed = hn::MulAdd(weight, f.dot(f), fixed);
    moving = hn::MulAdd(weight, m.dot(m), moving);
    const PoseV ax = hn::Mul(half, hn::Add(f.x, m.x));
    const PoseV ay = hn::Mul(half, hn::Add(f.y, m.y));
    const PoseV az = hn::Mul(half, hn::Add(f.z, m.z));
    const PoseV wx = hn::Mul(weight, ax);
    const PoseV wy = hn::Mul(weight, ay);
    const PoseV wz = hn::Mul(weight, az);
    const PoseV products[6] = {hn::Mul(wx, ax), hn::Mul(wx, ay), hn::Mul(wx, az), hn::Mul(wy, ay), hn::Mul(wy, az), hn::Mul(wz, az)};
    for (int q = 0; q < 6; ++q) {
      moment[0][q] = hn::Add(moment[0][q], products[q]);
      const PoseV once = hn::Mul(products[q], place);
      moment[1][q] = hn::Add(moment[1][q], once);
      moment[2][q] = hn::MulAdd(once, place, moment[2][q]);
    }
    const PoseV rp = hn::Mul(r, place);
    right[0][0] = hn::MulAdd(wx, r, right[0][0]);
    right[0][1] = hn::MulAdd(wy, r, right[0][1]);
    right[0][2] = hn::MulAdd(wz, r, right[0][2]);
    right[1][0] = hn::MulAdd(wx, rp, right[1][0]);
    right[1][1] = hn::MulAdd(wy, rp, right[1][1]);
    right[1][2] = hn::MulAdd(wz, rp, right[1][2]);
  }
  HWY_INLINE void total(PoseRowSums& out) const {
    out.residual = poseTotal(residual);
    out.robustWeight = poseTotal(robust);
    out.bothGradients = poseTotal(both);
    out.fixedGradient = poseTotal(fixed);
    out.movingGradient = poseTotal(moving);
    for (int p = 0; p < 3; ++p) {
      for (int q = 0; q < 6; ++q) out.moment[p][q] = poseTotal(moment[p][q]);
    }
    for (int p = 0; p < 2; ++p) {
      for (int q = 0; q < 3; ++q) out.right[p][q] = poseTotal(right[p][q]);
    }
  }
};

void sumPoseRow(const PoseRow& job, PoseRowSums& out) {
  const PoseFloats d;
  const PoseInts di;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const PoseV zero = hn::Zero(d);
  PoseValueSums values;
  PoseGradientSums gradients;
  for (int i = job.begin; i < job.end; i += lanes) {
    const PoseV at = hn::ConvertTo(d, hn::Add(hn::Iota(di, 0), hn::Set(di, i)));
    const PoseReader read{.atEnd = i + job.fixedPlane + lanes > job.room, .inside = std::min(lanes, job.end - i)};
    PoseV w = read.weights(job.fixedWeight + i);
    w = hn::IfThenElseZero(hn::Lt(at, hn::Set(d, static_cast<float>(job.end))), w);
    if (hn::AllTrue(d, hn::Eq(w, zero))) continue;
    const PoseCell cell(job, at);
    w = hn::Mul(hn::Mul(w, cell.leastWeight()), hn::Set(d, 1.0F / (255.0F * 255.0F)));
    const auto valid = hn::Gt(w, zero);
    if (hn::AllFalse(d, valid)) continue;
    const PoseMate mate(cell);
    const PoseV fixed = read.values(job.fixedValue + i);
    values.add(valid, w, fixed, mate.value);
    if (!job.derivatives) continue;
    const PoseV place = hn::Mul(hn::Sub(at, hn::Set(d, job.middle)), hn::Set(d, job.perMiddle));
    gradients.add(job, place, w, hn::Sub(fixed, mate.value), fixedGradient(job, job.fixedValue + i, read), movingGradient(job, cell, mate));
  }
  values.total(out);
  if (job.derivatives) gradients.total(out);
}

}  // namespace ew::registration::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew::registration {
HWY_EXPORT(sumPoseRow);
void sumPoseRow(const PoseRow& job, PoseRowSums& sums) { HWY_DYNAMIC_DISPATCH(sumPoseRow)(job, sums); }
}  // namespace ew::registration
#endif
