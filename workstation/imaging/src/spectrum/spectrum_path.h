#pragma once

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

#include "ew/imaging/effects/attenuation.h"
#include "ew/imaging/flow_sampler.h"
#include "ew/imaging/frame.h"
#include "ew/imaging/spectrogram.h"
#include "flow/relative_motion.h"
#include "plan/change_detector.h"
#include "spectrum/high_pass.h"
#include "spectrum/sample_volume.h"

namespace ew {

/// Of a spectrum that goes on: what is shown, and where everything in the sample volume is.
struct SpectrumMemory {
  Spectrogram spectrogram;
  std::vector<detail::SampleVolume> volumes;  ///< the gate's, and those that answer as well
  detail::HighPass wallFilter;
  std::complex<double> tissue{1.0, 0.0};
  bool runs = false;
  double start_s = 0.0;      ///< of the first sample
  std::int64_t samples = 0;  ///< since then
};

namespace detail {

/// The sample volume of a frame: from the last frame's time to this one's a sample for every pulse, of scatterers that move with the blood,
/// of the tissue that the volume holds, and of noise; wall filter; spectra.
class SpectrumPath {
 public:
  /// @param knobs with spectral; the strip is as large as the image
  void configure(const Probe& probe, const Knobs& knobs, const Scene& scene, const DisplayGeometry& geometry);
  /// @param motion of the image's echoes; null: nothing moves @param before the frame before
  void run(const FrameInput& input, const EchoMotion* motion, const FrameBefore& before);
  void clear();

  [[nodiscard]] const SpectrumMemory& memory() const { return memory_; }
  /// Of a strip of another size: as good as none.
  void recall(const SpectrumMemory& memory);
  [[nodiscard]] const Spectrogram& spectrogram() const { return memory_.spectrogram; }
  /// Of the last frame, behind the wall filter.
  [[nodiscard]] std::span<const std::complex<float>> samples() const { return samples_; }

 private:
  /// Powers at a volume.
  struct Way {
    double blood = 0.0, tissue = 0.0;
  };
  [[nodiscard]] Way wayTo(const FrameInput& input, double depth_mm, const RelativeMotion::At& seen);
  void addVolume(std::size_t n, const FrameInput& input, const Transform<frame::Probe, frame::World>& ownToProbe, double first_s);
  void addNoise();

  Knobs knobs_;
  Scene scene_;
  Probe probe_;
  SpectralGate gate_;
  ChangeDetector<Probe, Knobs, Scene, DisplayGeometry> from_;
  std::vector<double> depths_mm_;  ///< of all volumes
  std::vector<VolumeSize> sizes_;
  double noise_ = 0.0;
  TissueLosses losses_;
  double step_mm_ = 0.5;
  SpectrumMemory memory_;
  RelativeMotion motion_;
  FlowMoment moment_;
  GreyImage labels_;
  BeamImage lost_;
  std::vector<float> scratch_, touch_;
  std::vector<std::complex<float>> samples_, volume_;
};

}  // namespace detail
}  // namespace ew
