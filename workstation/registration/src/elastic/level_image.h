#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/volume.h"
#include "ew/registration/verdict.h"

namespace ew::registration {

struct LevelImage;

/// Smooth values over an image, kept on blocks of samples and linear between their centres.
struct BlockMap {
  glm::ivec3 size{1};    ///< samples in a block
  glm::ivec3 blocks{0};  ///< 0: no map
  std::vector<float> values;

  BlockMap() = default;
  BlockMap(const LevelImage& image, double block_mm);
  [[nodiscard]] std::size_t indexOf(int i, int j, int k) const { return sampleIndex(blocks, i, j, k); }
  [[nodiscard]] std::size_t count() const { return samplesIn(blocks); }
  /// Linear between the centres of blocks at a place in samples; negative values are unknown, and so is a place more than half among them.
  [[nodiscard]] float at(const glm::dvec3& sample) const;
  [[nodiscard]] glm::dvec3 centreOf(int i, int j, int k) const { return (glm::dvec3(i, j, k) + 0.5) * glm::dvec3(size) - 0.5; }
  /// Values along the row (j, k) of the image it was made for; `line` is scratch.
  void row(int j, int k, int width, std::vector<float>& line, float* out) const;
};
/// An image of one level of the pyramid: what a volume looks like at some millimetres a voxel, free of gain: (v - m) / (s + floor), with m
/// and s the mean and deviation of a window of the millimetres around. Rows have one sample of continuation on either side, so that a
/// central difference needs no special case, and whole vectors may be read from any of them.
struct LevelImage {
  glm::ivec3 dims{0};
  glm::dvec3 spacing_mm{1.0};
  glm::dvec3 first_mm{0.0};    ///< of sample (0, 0, 0), along the volume's axes from the centre of its voxel (0, 0, 0)
  int stride = 0;              ///< floats from row to row; sample i of a row stands at 1 + i
  std::vector<float> values;   ///< 0 where nothing is known
  std::vector<float> weights;  ///< 0..1, 0 on the continuation; empty: 1 everywhere
  BlockMap brightness;         ///< mean grey level of 2 mm around; negative where nothing is known

  [[nodiscard]] std::size_t rowOf(int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(dims.y) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(stride) +
           1;
  }
  [[nodiscard]] std::size_t floats() const;
};

/// Floats in a row of `width` samples, and beyond the last row so that vectors may overrun.
[[nodiscard]] int strideOf(int width);
inline constexpr std::size_t kOverrun = 80;

/// Gaussian blur of values on blocks, in place, not normalised: sums of windows.
void blurBlocks(std::vector<double>& values, const BlockMap& map, const glm::dvec3& spacing_mm, double sigma_mm);

/// How far each voxel is believed, 0..255, from coverage, confidence, and, where coverage says nothing, from black that reaches the border
/// of the volume (outside a sector). Empty: everything equally.
[[nodiscard]] std::vector<std::uint8_t> beliefOf(const Input& input);

/// @param voxel_mm  of the level; never finer than the volume's own
/// @param window_mm standard deviation of the window of mean and deviation
/// @param along     what runs along these beams of the volume is taken out first (not of the brightness); null: nothing is
/// @return false when cancelled
[[nodiscard]] bool makeLevel(const Input& input, const std::vector<std::uint8_t>& belief, double voxel_mm, double window_mm, int threads,
                             Progress& progress, LevelImage& level, const Beams* along = nullptr);

}  // namespace ew::registration
