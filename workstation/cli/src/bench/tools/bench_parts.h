#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/memory_watch.h"
#include "ew/core/order_statistics.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/imaging/knobs.h"

namespace ew {

/// A sum of products of cosines: known everywhere, no wavelength below 7 voxels, grey levels from 8 to 248.
class BenchField {
 public:
  explicit BenchField(int side);
  [[nodiscard]] double at(const glm::dvec3& p_voxel) const;
  /// The mean under a normal distribution along a line through p: `sigma_voxel` is its direction, as long as one standard deviation.
  /// Exact: each product is four plane waves, and a wave k keeps exp(-(k sigma)^2 / 2) of its height.
  [[nodiscard]] double meanAt(const glm::dvec3& p_voxel, const glm::dvec3& sigma_voxel) const;
  /// The field on a cube of `side` voxels of 1 mm, in large pages, as volumes from files are.
  /// @error cancelled
  [[nodiscard]] Result<Volume> volume(Progress& progress) const;

 private:
  static constexpr std::size_t kTerms = 6;
  static constexpr double kMean = 128.0;
  static constexpr double kAmplitude = 20.0;
  struct Term {
    std::array<double, 3> perVoxel{}, phase{};
    std::array<std::vector<float>, 3> table;
  };
  int side_;
  std::array<Term, kTerms> terms_;
};

/// One way of making a slice; the returned pixels stay valid until the next call.
using BenchSlicer = std::function<const std::uint8_t*(const Transform<frame::Voxel, frame::Image>&)>;

/// vtkImageReslice on one thread, with its optimisation on, reading the same voxels in the same memory. The volume must outlive it.
/// Quality::weave is VTK's nearest neighbour.
[[nodiscard]] BenchSlicer peerSlicer(Quality quality, const Volume& volume, int width, int height);

/// How a hand that rocks holds its probe at a moment.
[[nodiscard]] glm::dquat rockingTurn(double time_s);

/// Processor time of the thread that asks: what other programs take from it does not count.
[[nodiscard]] double threadTime_s();
/// Whether everything `work` did was done by the calling thread.
[[nodiscard]] bool runsOnThisThreadAlone(const std::function<void()>& work);
/// The value that `share` of them do not exceed; `none` when there are none.
[[nodiscard]] inline double shareOf(const std::vector<double>& values, double share, double none = 0.0) {
  return values.empty() ? none : quantileOf(values, share);
}
[[nodiscard]] std::string machineName();

/// Of a watch in a report: null where nobody says what a process takes.
[[nodiscard]] nlohmann::json peakOf(const MemoryWatch& watch);
[[nodiscard]] nlohmann::json heldOf(const MemoryWatch& watch);
/// A memory of a report in a table; empty where it is not known.
[[nodiscard]] std::string memoryIn(const nlohmann::json& row, const char* key, int decimals = 1);

}  // namespace ew
