#pragma once

#include <vector>

#include "echo_layout.h"

namespace ew::detail {

/// Carries losses along the rays by which the aperture sees each place, so that the shadow of a thing has soft sides and a thing much
/// narrower than the aperture hardly any shadow far behind it. One way, in amplitude,
///   left(l, z) = mean over rays q of the product of 10^(-loss / 40) along the ray
/// A ray is straight; q is its slope against the lines of a linear probe, or its distance from the point where the lines of a fan meet.
/// It takes part at depth z as long as it comes from the aperture min(aperture, z / 2) (Szabo, Diagnostic Ultrasound Imaging, ch. 6).
class EchoRays {
 public:
  /// @param steps >= 2
  void configure(const EchoLayout& layout, const Probe& probe, int steps, double step_mm);

  struct Scratch {
    std::vector<float> left;  ///< by ray and line of the face
    std::vector<float> kept, sum;
  };
  void begin(Scratch& scratch) const;
  /// The next step of all rays.
  /// @param loss_log2 of each line in this step, one way; negative: enhancement, until 2^-sum is `most`
  /// @param gain      += weight left^2, a little blurred across the lines
  void pass(int step, const float* loss_log2, float most, float weight, Scratch& scratch, float* gain) const;

 private:
  struct Ray {
    std::vector<int> line;      ///< by step: how many lines it has gone to the side
    std::vector<float> weight;  ///< by step
    int lastStep = -1;          ///< that counts
    int before = 0, after = 0;  ///< lines beside the fan from which it comes in
  };
  std::vector<Ray> rays_;
  int lines_ = 0, padding_ = 0;
};

}  // namespace ew::detail
