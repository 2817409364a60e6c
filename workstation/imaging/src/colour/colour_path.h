#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "colour/colour_lines.h"
#include "echoes/echo_beams.h"
#include "ew/imaging/bands.h"
#include "ew/imaging/beam_grid.h"
#include "ew/imaging/display_image.h"
#include "ew/imaging/doppler.h"
#include "ew/imaging/effects/attenuation.h"
#include "ew/imaging/flow_memory.h"
#include "ew/imaging/flow_sampler.h"
#include "ew/imaging/frame.h"
#include "ew/imaging/scan_conversion.h"
#include "flow/relative_motion.h"
#include "plan/change_detector.h"

namespace ew::detail {

/// What one place of a colour box sends back. Powers over full white's; velocities along the beam, towards the probe, and spreads in units
/// of the Nyquist velocity, not wrapped.
struct GateEchoes {
  float blood = 0.0F, bloodVelocity = 0.0F, bloodSpread = 0.0F;
  float tissue = 0.0F, tissueVelocity = 0.0F, tissueSpread = 0.0F;
  float noise = 0.0F;
};

/// The colour box of a frame. For each gate of each line a packet is made with the statistics that moving scatterers give it (blood and
/// tissue by PacketSource, each around its own velocity, with speckle that neighbours share as far as their beams and pulses overlap, and
/// noise), the wall filter takes out what is slow, and R0 and R1 are averaged over neighbours and frames, and turned into colours on the
/// image's pixels.
/// Velocities of a gate are means over seven places of its resolution cell, weighted by the power of the two-way beam; their scatter,
/// turbulence and the time that blood takes through beam and pulse are its spread.
/// Source: Kasai et al. 1985 for the estimator; transit time as of a Gaussian beam, L v / (4 pi sqrt(2) sigma) for a velocity v across an
/// amplitude of standard deviation sigma, with the wavelength L. Levels of blood are ours (colour_path.cpp).
class ColourPath {
 public:
  /// @param knobs with colour
  void configure(const Probe& probe, const Knobs& knobs, const Scene& scene, const DisplayGeometry& geometry);
  /// Sums of every gate.
  /// @param motion of the image's echoes; null: nothing moves
  /// @param before the frame before
  void form(const FrameInput& input, const EchoMotion* motion, const FrameBefore& before, ColourMemory& memory, Bands& bands);
  /// Their colours, over an image of that size.
  void draw(ImageView<const std::uint8_t> grey, const ColourMemory& memory, Bands& bands);
  [[nodiscard]] ImageView<const Rgba> image() const { return viewOf(image_); }

  [[nodiscard]] const BeamGrid& grid() const { return grid_; }
  [[nodiscard]] const ColourBox& box() const { return box_; }
  /// Of the last frame, (lines x samples), as PacketSums over the level that is shown just so.
  struct Region {
    int firstLine = 0, lastLine = 0, firstGate = 0, lastGate = 0;
  };
  [[nodiscard]] const Region& region() const { return region_; }

 private:
  struct Scratch {
    std::vector<std::complex<float>> white, packet, sum;
    std::vector<float> attenuation;
  };
  [[nodiscard]] std::size_t indexOf(int line, int gate) const {
    return static_cast<std::size_t>(gate) * grid_.lines.size() + static_cast<std::size_t>(line);
  }
  void layPixels(const Probe& probe, const Knobs& knobs, const DisplayGeometry& geometry);
  void layColours();
  void findMotion();
  [[nodiscard]] RelativeMotion::At motionAt(int line, double depth_mm) const;
  void findLosses(const FrameInput& input, Bands& bands);
  void findEchoes(const FrameInput& input, const glm::dmat4& probeToOwn, Bands& bands);
  [[nodiscard]] GateEchoes echoesAt(const FrameInput& input, const glm::dmat4& probeToOwn, const glm::dmat4& probeToLevel, int line,
                                    int gate) const;
  void addPackets(std::uint64_t number, Bands& bands);
  void addSpeckle(std::uint64_t key, int line, int gate, std::span<std::complex<float>> white) const;
  void average(ColourMemory& memory, Bands& bands);

  Knobs knobs_;
  ColourDoppler colour_;
  Scene scene_;
  Probe probe_;
  ColourBox box_;
  BeamGrid grid_;
  Region region_;
  std::optional<WallFilter> filter_;
  std::optional<PacketSource> source_;
  int packet_ = 0;
  ScanConversionTable conversion_;
  ChangeDetector<Probe, Knobs, Scene, DisplayGeometry> from_;
  ChangeDetector<Probe, double, double, bool, BeamGrid, DisplayGeometry, glm::dvec4> pixelsFrom_;
  std::vector<float> shown_;   ///< by gate: the power that is just shown
  std::vector<float> noise_;   ///< by gate: its power before the wall filter
  double noiseOfShown_ = 0.0;  ///< of the noise that passes the filter, over what is just shown
  struct Cell {
    float lateralSigma_mm = 0.5F, elevationalSigma_mm = 0.5F;  ///< of the two-way amplitude
    float acrossLines = 0.0F;                                  ///< weight of a neighbouring line's draws, of the own's
  };
  std::vector<Cell> cells_;  ///< by gate
  double axialSigma_mm_ = 0.3;
  float acrossGates_ = 0.0F;
  double wavelength_mm_ = 0.3;
  double blood_ = 0.0;                 ///< power of its echo
  std::vector<float> filterResponse_;  ///< by velocity, 0..1 in 256 steps
  TissueLosses losses_;

  FlowMoment moment_;
  RelativeMotion motion_;
  std::vector<RelativeMotion::At> nodes_;  ///< by row of depths, by column of lines
  int columns_ = 0, rows_ = 0;
  std::vector<Scratch> scratch_;
  std::vector<float> touch_;  ///< by line
  GreyImage labels_;          ///< (lines x samples)
  BeamImage lost_;            ///< likewise
  std::vector<GateEchoes> echoes_;
  std::vector<float> sums_, averaged_;  ///< as ColourMemory::sums
  std::vector<Rgba> colours_;           ///< by velocity, and by spread where it shows
  Image<Rgba> image_;
};

}  // namespace ew::detail
