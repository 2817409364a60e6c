#pragma once

#include <cstdint>
#include <span>

#include "echo_layout.h"

namespace ew::detail {

/// What a tile of added-up scatterers becomes: one row of complex numbers for each line.
struct LateralTask {
  std::int32_t* tile = nullptr;  ///< its first column
  std::int64_t stride = 0;       ///< of a row
  int width = 0;                 ///< of the tile, real and imaginary parts together
  int cleared = 0;               ///< how much of each row is emptied: the last tile has more
  float unit = 1.0F;
  const float* weights = nullptr;  ///< (reach + 1) x width
  int reach = 0;
  int firstRow = 0;  ///< of the first line
  int rowsPerLine = 1;
  int beginLine = 0;
  int endLine = 0;
  int beginCleared = 0;  ///< rows that are emptied
  int endCleared = 0;
  float* out = nullptr;
  std::int64_t outStride = 0;
};
/// Every kernel here gives the same bits on every instruction set.
void filterLaterally(const LateralTask& task);

/// Factors at even steps, of which `first + n perColumn` is that of the n-th complex number: it is scaled by what lies between the two
/// steps around it, the outermost ones beyond.
struct GainSteps {
  const float* ofSteps = nullptr;  ///< steps, and kBeyond more that are read but do not count
  int steps = 2;
  float first = 0.0F;
  float perColumn = 1.0F;
  static constexpr int kBeyond = 64;
};
void scaleComplex(const GainSteps& gain, int count, float* inOut);

/// A complex row, `weight` as strong and a quarter of a turn on `quarter` times.
struct QuarterTurnRow {
  const float* in = nullptr;
  float weight = 0.0F;
  int quarter = 0;
};
/// out += weight * i^quarter * in, row after row.
/// @param rows kMostQuarterTurnRows at most
void addTurned(const QuarterTurnRow* rows, int rowCount, int count, float* out);
inline constexpr int kMostQuarterTurnRows = 8;

/// inOut += strength[n] times a complex number whose parts are nearly normal with deviation 1, hashed from key and n.
void addComplexNoise(std::uint64_t key, const float* strength, int count, float* inOut);

/// What the pulse makes of a line: the weighted sum of its looks' envelopes.
struct EnvelopeTask {
  const float* pulse = nullptr;  ///< reach + 1 weights, by distance
  int reach = 0;
  float middleShare = 0.0F;  ///< of |sum over t of pulse[|t|] in[s + t]|; 0: there is none
  std::span<const LookPair> pairs;
};
/// @param in      complex numbers, of which `reach` are there on both sides of in[0 .. samples - 1]
/// @param levels  one for each sample
void envelopeOf(const EnvelopeTask& task, const float* in, int samples, float* levels);

/// out = 255 + perDoubling log2(in, of which each neighbour adds `aside`), amplitudes below 1e-9 counting as that.
/// @param in count values, and one more on each side
void toLevels(const float* in, float aside, float perDoubling, int count, float* out);

/// inOut = 2^((inOut - 255) perLevel), exponents beyond 100 counting as that: the inverse of fromAmplitudes.
void toAmplitudes(float perLevel, int count, float* inOut);
/// inOut = 255 + perDoubling log2(inOut), as toLevels without neighbours.
void fromAmplitudes(float perDoubling, int count, float* inOut);

/// kept = 2^-loss.
void keptOf(const float* loss_log2, int count, float* kept);

/// left = left kept, not above `most` nor below 1e-12.
void passRay(const float* kept, float most, int count, float* left);

/// out += weight in.
void addWeighted(const float* in, float weight, int count, float* out);

/// out += weight factor[n / 2] in, complex numbers times real ones.
void addFalling(const float* in, const float* factor, float weight, int count, float* out);

/// out += weight ((in before + 2 in + in after) / 4)^2.
/// @param in count values, and one more on each side
void addSquares(const float* in, float weight, int count, float* out);

}  // namespace ew::detail
