#pragma once

#include <vector>

#include "echo_layout.h"
#include "ew/core/image.h"
#include "ew/imaging/bands.h"

namespace ew::detail {

/// The filter of a machine that flattens speckle and leaves what stands out of it: with m the mean of the level about a sample, a Gaussian
/// of kMean_mm in both directions, and d = level - m,
///   level' = m + d (1 - r (1 - s)),  s rising from 0 at 8 dB of |d| to 1 at 14 dB,  r = LiveEchoesEffect::speckleReduction
/// so that walls, dashes and the edges of vessels keep their contrast. Grain keeps its size and loses r of its deviation. Levels far below
/// black count as kBlackest in the mean.
/// Measured: the grain of a recorded liver deviates by 8 to 10 grey levels, that of three looks without a filter by 12 to 14.
/// Source: the idea of adaptive speckle reduction (Loupas et al., IEEE Trans. Circuits Syst. 36(1), 1989); the formula is ours.
class SpeckleReduction {
 public:
  void configure(const EchoLayout& layout);
  /// @param greyPerDb of the levels
  /// @param levels    (lines x samples), in place
  void run(double greyPerDb, Bands& bands, ImageView<float> levels);

 private:
  /// Axially, of cells in which samples are averaged first.
  void averageCells(int first, int count, ImageView<const float> levels);
  void smoothCells(int first, int count, std::vector<float>& row);
  void flatten(int first, int count, double greyPerDb, ImageView<float> levels) const;

  double reduction_ = 0.0;
  int lines_ = 0;
  int samples_ = 0;
  int samplesPerCell_ = 1;
  int cells_ = 0;
  std::vector<float> axial_;                 ///< weight by distance in cells
  std::vector<std::vector<float>> lateral_;  ///< by cell: weight by distance in lines
  std::vector<float> averages_;              ///< cells x lines
  std::vector<float> means_;                 ///< likewise
  std::vector<std::vector<float>> rows_;     ///< by thread
};

}  // namespace ew::detail
