#pragma once

#include <complex>
#include <vector>

#include "ew/imaging/flow_field.h"

namespace ew::detail {

/// Of a velocity along a vessel, both in units of flow over area.
struct ProfileValue {
  double velocity = 0.0;
  double within = 0.0;  ///< flow within y
};

/// The undisturbed profile of a stream at one phase of its wave: steady part and Womersley's harmonics.
class WaveProfile {
 public:
  /// @param alpha of the first harmonic
  WaveProfile(const FlowStream& stream, double alpha, double phase);
  [[nodiscard]] ProfileValue at(double y) const;
  [[nodiscard]] double flow() const { return flow_; }  ///< over the stream's own

 private:
  double bluntness_, steady_, flow_, alpha_;
  std::vector<std::complex<double>> harmonics_;  ///< turned to the phase
};

/// Behind and within a stenosis, for a flow of 1: blunt in the jet, backwards beside it, 0 at the wall, and 1 on average.
class JetProfile {
 public:
  /// @param radius of the jet, 0..1; @param backflow beside it, 0..1
  JetProfile(double radius, double backflow);
  /// How far a jet of that radius takes the place of the undisturbed profile.
  [[nodiscard]] static double share(double radius);
  [[nodiscard]] ProfileValue at(double y) const;

 private:
  [[nodiscard]] double raw(double y) const;
  double radius_, forward_ = 1.0, back_ = 0.0;
};

}  // namespace ew::detail
