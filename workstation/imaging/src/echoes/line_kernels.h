#pragma once

#include <cstdint>

namespace ew::detail {

/// What a tile of added-up scatterers becomes: one row of complex numbers for each line.
struct LateralTask {
  std::int32_t* tile = nullptr;  ///< its first column; its bits are turned into floats in place
  std::int64_t stride = 0;       ///< of a row
  int rows = 0;
  int width = 0;  ///< of the tile, real and imaginary parts together
  float unit = 1.0F;
  const float* weights = nullptr;  ///< (reach + 1) x width
  int reach = 0;
  int firstRow = 0;  ///< of the first line
  int rowsPerLine = 1;
  int lines = 0;
  float* out = nullptr;
  std::int64_t outStride = 0;
};
/// Every kernel here gives the same bits on every instruction set.
void filterLaterally(const LateralTask& task);

/// out[n] = in[n] * factor[n / 2]: complex numbers times real ones.
void scaleComplex(const float* factor, int count, float* inOut);

/// out += weight * i^quarter * in, complex numbers.
void addTurned(const float* in, float weight, int quarter, int count, float* out);

/// inOut += strength[n] times a complex number whose parts are nearly normal with deviation 1, hashed from key and n.
void addComplexNoise(std::uint64_t key, const float* strength, int count, float* inOut);

/// out = in times turn, complex numbers.
void turnComplex(const float* in, const float* turn, int count, float* out);

/// out[s] += share |sum over t of pulse[|t|] in[s + t]|, complex numbers of which `reach` are there on both sides of in[0 .. samples - 1].
void addEnvelope(const float* in, const float* pulse, int reach, float share, int samples, float* out);

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

/// out += weight ((in before + 2 in + in after) / 4)^2.
/// @param in count values, and one more on each side
void addSquares(const float* in, float weight, int count, float* out);

}  // namespace ew::detail
