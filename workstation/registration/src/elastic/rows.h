#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace ew::registration {

/// Displacement (mm along the fixed axes) and brightness along a row: at a sample of cell c, low[c] + share * rise[c].
struct RowField {
  std::array<const float*, 4> low{};  ///< x, y, z, brightness; one float per cell
  std::array<const float*, 4> rise{};
  const int* cell = nullptr;     ///< per sample
  const float* share = nullptr;  ///< per sample
};

/// The moving image and where a fixed row lies in it.
struct RowSource {
  const float* values = nullptr;   ///< at sample (0, 0, 0)
  const float* weights = nullptr;  ///< null: 1 everywhere inside
  int dims[3] = {1, 1, 1};
  int rowStride = 0;
  int sliceStride = 0;
  float first[3] = {0, 0, 0};  ///< index of the row's sample 0 without displacement
  float step[3] = {0, 0, 0};   ///< from sample to sample
  float perMm[9] = {0};        ///< index along axis r per mm of displacement along axis c, at 3 r + c
};

/// Writes the moving image (trilinear, plus brightness) at `count` displaced samples, and how far it is believed there: 0 outside.
/// Writes whole vectors: up to kOverrun floats beyond are touched.
void sampleRow(const RowField& field, const RowSource& source, int count, float* values, float* weights);

inline constexpr int kProducts = 10;  ///< of gradient and 1: xx xy xz x yy yz y zz z 1
inline constexpr int kSums = 16;

/// What the rows of one line of cells add up to before they are gathered along x: products times (1-t)^2, t(1-t), t^2 of the row's place
/// between the nodes below and above it, right-hand sides times 1-t and t.
struct RowSums {
  float* products = nullptr;  ///< 3 x kProducts rows of `stride` floats
  float* right = nullptr;     ///< 2 x 4 rows
  int stride = 0;
};

/// Sums over samples: weight, cost, f, w, ff, ww, fw, rr, r r(x+1), r r(y+1), r r(z+1), grad f grad w, (|grad f|^2 + |grad w|^2) / 2,
/// robust weight, robust weight rr.
using Sums = std::array<float, kSums>;

struct RowPair {
  const float* fixed = nullptr;
  const float* fixedNear[4] = {};  ///< rows at y - 1, y + 1, z - 1, z + 1, or the row itself at a border
  const float* moved = nullptr;
  const float* movedNear[4] = {};
  const float* fixedWeights = nullptr;  ///< null: 1
  const float* movedWeights = nullptr;
  float slope[3] = {0, 0, 0};  ///< what turns a difference of neighbours into a derivative per mm
  float share = 0.0F;          ///< of the node above
  float perScale2 = 1.0F;      ///< 1 / c^2 of the robust weight 1 / (1 + r^2 / c^2)^2
  float ofFixed = 0.5F;        ///< share of the fixed image's gradient in the normal equations
};

/// Adds rows of `count` samples to `sums`, and writes what they add up to into `rows`, whole vectors: up to kOverrun floats beyond.
void accumulateRows(std::span<const RowPair> pairs, int count, const RowSums& rows, Sums& sums);

/// Cost and correlations only: no products.
void sumRows(std::span<const RowPair> pairs, int count, Sums& sums);

/// Adds the rows' sums over samples [begin, end) of a cell to its moments. `along` holds (1-s)^2, s(1-s), s^2, 1-s and s per sample, in
/// 5 rows of `stride` floats.
/// @param products 3 (x) x 3 (y) x kProducts, @param right 2 (x) x 2 (y) x 4
void gatherCell(const RowSums& rows, const float* along, int begin, int end, float* products, float* right);

inline constexpr int kMoments = 6;

/// Adds, per sample, what correlations are made of: weight, f, m, ff, mm, fm, each but the first times the weight.
/// @param fixedWeights null: 1. @param moments kMoments rows of `stride` floats. Whole vectors: up to kOverrun floats beyond are touched,
/// which stay as they are.
void addMoments(const float* fixed, const float* fixedWeights, const float* moved, const float* movedWeights, int count, float* moments,
                int stride);

}  // namespace ew::registration
