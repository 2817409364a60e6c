// The inner loops of image formation: plain loops over floats that the compiler turns into vector code. Nothing is summed across lanes, so
// every width of vector gives the same bits.
#include "scanner/formation_kernels.h"

#include <cmath>

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__linux__) && !defined(__SANITIZE_THREAD__) && \
    !defined(__SANITIZE_ADDRESS__)
#define EW_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define EW_WIDE_VECTORS
#endif

namespace ew::phantom {
namespace {

inline float nearestWhole(float value) {
  constexpr float kMagic = 12582912.0F;  // 1.5 * 2^23: adding it leaves no room for a fraction
  return (value + kMagic) - kMagic;
}

/// Arc tangent for |h| <= 0.8, error below 1e-7 (least squares at Chebyshev points).
inline float arcTangent(float h) {
  const float u = h * h;
  float p = 0.015623872F;
  p = p * u - 0.053944063F;
  p = p * u + 0.097827117F;
  p = p * u - 0.140202142F;
  p = p * u + 0.199736924F;
  p = p * u - 0.333323335F;
  p = p * u + 0.999999937F;
  return p * h;
}

/// exp(-q) for 0 <= q <= 4, relative error below 1e-5.
inline float exponential(float q) {
  const float t = -0.125F * q;
  float p = 1.0F / 120.0F;
  p = p * t + 1.0F / 24.0F;
  p = p * t + 1.0F / 6.0F;
  p = p * t + 0.5F;
  p = p * t + 1.0F;
  p = p * t + 1.0F;
  const float p2 = p * p, p4 = p2 * p2;
  return p4 * p4;
}

}  // namespace

EW_WIDE_VECTORS
void moveAffine(const float* x, const float* y, const float* z, std::size_t count, const Trilinear& to, PointBatch& batch) {
  const glm::vec3 c0 = to[0], c1 = to[1], c2 = to[2], c3 = to[3];
  for (std::size_t n = 0; n < count; ++n) {
    batch.x[n] = c0.x + c1.x * x[n] + c2.x * y[n] + c3.x * z[n];
    batch.y[n] = c0.y + c1.y * x[n] + c2.y * y[n] + c3.y * z[n];
    batch.z[n] = c0.z + c1.z * x[n] + c2.z * y[n] + c3.z * z[n];
  }
}

EW_WIDE_VECTORS
void moveTrilinear(const float* x, const float* y, const float* z, std::size_t count, const Trilinear& to, PointBatch& batch) {
  const Trilinear c = to;
  for (std::size_t n = 0; n < count; ++n) {
    const float u = x[n], v = y[n], w = z[n];
    const float uv = u * v, uw = u * w, vw = v * w, uvw = uv * w;
    batch.x[n] = c[0].x + c[1].x * u + c[2].x * v + c[3].x * w + c[4].x * uv + c[5].x * uw + c[6].x * vw + c[7].x * uvw;
    batch.y[n] = c[0].y + c[1].y * u + c[2].y * v + c[3].y * w + c[4].y * uv + c[5].y * uw + c[6].y * vw + c[7].y * uvw;
    batch.z[n] = c[0].z + c[1].z * u + c[2].z * v + c[3].z * w + c[4].z * uv + c[5].z * uw + c[6].z * vw + c[7].z * uvw;
  }
}

EW_WIDE_VECTORS
void placeOnLines(const Gridding& grid, std::size_t count, PointBatch& batch) {
  const float apex = grid.apex_mm, scale = grid.rowsPerUnit, middle = grid.middleRow;
  if (!grid.sector) {
    for (std::size_t n = 0; n < count; ++n) {
      batch.row[n] = middle + scale * batch.x[n];
      batch.range_mm[n] = batch.y[n];
    }
    return;
  }
  for (std::size_t n = 0; n < count; ++n) {
    const float x = batch.x[n], y = batch.y[n] + apex;
    const float radius = std::sqrt(x * x + y * y);
    // tan(angle / 2): no quadrants to tell apart. Behind the apex it grows without end and the row falls off the grid.
    const float half = x / (radius + y + 1e-6F);
    const float clamped = half > 0.8F ? 0.8F : (half < -0.8F ? -0.8F : half);
    const float angle = 2.0F * arcTangent(clamped) + 16.0F * (half - clamped);
    batch.row[n] = middle + scale * angle;
    batch.range_mm[n] = radius - apex;
  }
}

EW_WIDE_VECTORS
void weigh(const Gridding& grid, std::size_t count, PointBatch& batch) {
  const float focus = grid.lensFocus_mm, near = grid.nearPerMm, far = grid.farPerMm, waist = grid.waistPerMm2, cut = grid.cut;
  const float strength = grid.weight, perMm = grid.columnsPerMm, first = grid.firstColumn, turnsPerMm = grid.turnsPerMm;
  const float lastRow = static_cast<float>(grid.rows) - 0.6F, lastColumn = static_cast<float>(grid.columns) - 2.1F;
  const std::int32_t columns = grid.columns, outside = grid.rows * grid.columns;
  for (std::size_t n = 0; n < count; ++n) {
    const float off = batch.range_mm[n] - focus;
    const float perRange = off < 0.0F ? near : far;
    const float q = off * perRange;
    const float widening = 1.0F + q * q;
    const float z2 = batch.z[n] * batch.z[n];
    const float exponent = z2 * waist / widening;
    // Range with the lens' wavefront: r + z^2 / 2R, R = (off^2 + range^2) / off.
    const float range = batch.range_mm[n] + 0.5F * z2 * q * perRange / widening;
    const float row = batch.row[n], column = first + perMm * range;
    const bool inside = (exponent < cut) & (row > -0.4F) & (row < lastRow) & (column > 1.1F) & (column < lastColumn);
    const float wholeRow = nearestWhole(inside ? row : 0.0F), wholeColumn = nearestWhole(inside ? column - 0.5F : 0.0F);
    batch.cell[n] = inside ? static_cast<std::int32_t>(wholeRow) * columns + static_cast<std::int32_t>(wholeColumn) : outside;

    batch.part[n] = inside ? column - wholeColumn : 0.0F;

    const float limited = inside ? exponent : 0.0F;
    const float weight = strength * batch.amplitude[n] * exponential(limited) / std::sqrt(std::sqrt(widening));
    const float turns = inside ? turnsPerMm * range : 0.0F;
    const float part = turns - nearestWhole(turns);  // -0.5 .. 0.5
    const float a = part * part;
    // sin and cos of pi * part, then of twice the angle.
    float s = -0.0073704309F;
    s = s * a + 0.0821458866F;
    s = s * a - 0.5992645293F;
    s = s * a + 2.5501640399F;
    s = s * a - 5.1677127800F;
    s = s * a + 3.1415926536F;
    s = s * part;
    float c = -0.0258068914F;
    c = c * a + 0.2353306304F;
    c = c * a - 1.3352627689F;
    c = c * a + 4.0587121264F;
    c = c * a - 4.9348022005F;
    c = c * a + 1.0F;
    const float kept = inside ? weight : 0.0F;
    batch.re[n] = kept * (1.0F - 2.0F * s * s);
    batch.im[n] = -kept * (2.0F * s * c);
  }
}

void deposit(std::size_t count, const PointBatch& batch, float* grid) {
  for (std::size_t n = 0; n < count; ++n) {
    float* cell = grid + 2 * static_cast<std::size_t>(batch.cell[n]);
    const float re = batch.re[n] * batch.part[n], im = batch.im[n] * batch.part[n];
    cell[0] += batch.re[n] - re;
    cell[1] += batch.im[n] - im;
    cell[2] += re;
    cell[3] += im;
  }
}

EW_WIDE_VECTORS
void accumulate(const float* in, const float* weight, std::size_t count, float* out) {
  for (std::size_t n = 0; n < count; ++n) out[n] += weight[n] * in[n];
}

EW_WIDE_VECTORS
void accumulate(const float* in, float weight, std::size_t count, float* out) {
  for (std::size_t n = 0; n < count; ++n) out[n] += weight * in[n];
}

}  // namespace ew::phantom
