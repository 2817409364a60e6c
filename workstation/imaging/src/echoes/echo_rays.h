#pragma once

#include <array>
#include <vector>

#include "echo_layout.h"

namespace ew::detail {

/// Carries losses along the rays by which the aperture sees each place, so that the shadow of a thing has soft sides and a thing much
/// narrower than the aperture hardly any shadow far behind it. One way, in amplitude,
///   left(l, z) = mean over rays q of the product of 10^(-loss / 40) along the ray
/// A ray is straight; q is its slope against the lines of a linear probe, or its distance from the point where the lines of a fan meet.
/// It takes part at depth z as long as it comes from the aperture A = min(aperture, z / 2) and from the face, weighing 0.35 + 0.65 cos(pi u
/// / A) at u from the middle, which widens a focus as beams are widened here (Szabo, Diagnostic Ultrasound Imaging, ch. 6).
class EchoRays {
 public:
  /// @param steps >= 2
  void configure(const EchoLayout& layout, const Probe& probe, int steps, double step_mm);

  struct Scratch {
    std::vector<float> left;                 ///< by ray and line of the face
    std::array<std::vector<float>, 3> kept;  ///< of rays that stay on their line, come from the line before, from the line after
    std::vector<float> loss, sum;
  };
  void begin(Scratch& scratch) const;
  /// What the lines meet in a step, one way, as powers of 2.
  struct Step {
    const float* loss;  ///< of each line; negative: enhancement
    /// Of the tissue each line was in a step before: a ray that changes to it from a neighbour pays what it reflects more than the
    /// neighbour's.
    const float* reflectionBefore;
  };
  /// The next step of all rays.
  /// @param most to which enhancement rises
  /// @param gain += weight left^2, a little blurred across the lines
  void pass(int step, const Step& met, float most, float weight, Scratch& scratch, float* gain) const;

 private:
  struct Ray {
    std::vector<int> line;      ///< by step: how many lines it has gone to the side
    std::vector<float> weight;  ///< by step
    int lastStep = -1;          ///< that counts
    int before = 0, after = 0;  ///< lines beside the fan from which it comes in
  };
  [[nodiscard]] bool comesFromFace(int line) const { return !endsWithFace_ || (line >= 0 && line < lines_); }
  [[nodiscard]] std::size_t indexOf(int step, int line) const {
    return static_cast<std::size_t>(step) * static_cast<std::size_t>(lines_) + static_cast<std::size_t>(line);
  }
  /// What the lines keep in a step, into one of scratch.kept.
  const float* keep(const float* loss_log2, std::vector<float>& kept) const;

  std::vector<Ray> rays_;
  std::vector<float> share_;  ///< by step, line: 1 / what rays from the face weigh
  bool endsWithFace_ = true;  ///< no rays come from beside the outermost lines
  int lines_ = 0, padding_ = 0;
};

}  // namespace ew::detail
