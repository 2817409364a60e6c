#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ew/core/image.h"
#include "ew/core/result.h"
#include "ew/imaging/beam_grid.h"
#include "ew/imaging/probe.h"
#include "ew/phantom/deformation.h"
#include "ew/phantom/patient.h"

namespace ew {

/// Gain at a depth; between two of them in a straight line, beyond the outermost as there.
struct DepthGain {
  double depth_mm = 0.0;
  double gain_db = 0.0;
  bool operator==(const DepthGain&) const = default;
};

/// How the virtual machine forms its image. Neutral settings leave an effect out.
struct FormationOptions {
  double depth_mm = 0.0;     ///< 0: the probe's default
  double focus_mm = 0.0;     ///< transmit focus; 0: half of the depth. Receive focus follows the depth
  double carrier_hz = 0.0;   ///< 0: the probe's
  double pulseCycles = 2.0;  ///< length of the pulse's envelope (full width at half maximum of the amplitude), in periods, 0.5..10
  int looks = 1;  ///< sub-bands of the pulse whose envelopes are averaged, 1..5: less grain, a pulse (looks + 1) / 2 times as long
  double assumedSpeed_mPerS = 1540;  ///< turns time into depth
  bool attenuation = true;           ///< tissue attenuation, losses at interfaces, and so shadows
  bool penumbra = true;              ///< shadows have soft sides, as the aperture sees around what throws them
  bool specular = true;              ///< bright interfaces by angle and impedance
  bool speedOfSound = false;         ///< tissue speeds displace echoes along the line
  double noise_db = -92.0;           ///< electronic noise below full white, before depth gain; -200 and below: none
  double dynamicRange_db = 60.0;     ///< what grey levels 0..255 span, 20..120
  double gain_db = 0.0;              ///< of the whole image
  std::vector<DepthGain> tgc =
      {};  ///< gain over depth; empty: what `expected_dbPerCmMhz` loses both ways, up to `largestTgc_db` (without attenuation none)
  double expected_dbPerCmMhz = 0.5;
  double largestTgc_db = 60.0;
  std::uint64_t noiseSeed = 1;
  bool operator==(const FormationOptions&) const = default;
};

/// Width of the point spread function (full width at half maximum of the amplitude of two-way beams), mm, at a depth.
struct PointSpread {
  double axial_mm = 0.0;
  double lateral_mm = 0.0;
  double elevational_mm = 0.0;
};

/// A machine with a probe held to a virtual patient. Scatterers are fixed in the resting body, hashed from seed and place, so every view
/// and every run meets the same ones; they are seen through a point spread function that changes with depth.
/// It shares no code with imaging/effects: a defect of one cannot hide in the other.
/// Safe to use from several threads at once, each with its own Scratch.
class VirtualScanner {
 public:
  class Scratch {
   public:
    virtual ~Scratch();
    std::function<bool()> stopped;  ///< asked every few milliseconds of work when there is one; once it says true the frame is given up
  };
  virtual ~VirtualScanner();

  [[nodiscard]] virtual const FormationOptions& options() const = 0;  ///< with every 0 replaced by what it stands for
  [[nodiscard]] virtual const Probe& probe() const = 0;
  /// Where lines and samples lie in the probe frame.
  [[nodiscard]] virtual const BeamGrid& grid() const = 0;
  [[nodiscard]] virtual PointSpread pointSpreadAt(double depth_mm) const = 0;
  [[nodiscard]] virtual std::unique_ptr<Scratch> makeScratch() const = 0;

  /// Envelope of the echoes of one frame, noise and depth gain included; amplitude 1 is full white (255), 0 dB.
  /// @param frame    changes the electronic noise, nothing else
  /// @param envelope resized to (samples x lines): width = lines, height = samples, as BeamImage; empty when the frame was given up
  virtual void envelope(const Transform<frame::World, frame::Probe>& probeToWorld, const Deformation& deformation, std::uint64_t frame,
                        Scratch& scratch, Image<float>& envelope) const = 0;
};

/// @param seed of the scatterers
/// @error badField (options out of range, depth beyond the probe's)
[[nodiscard]] Result<std::unique_ptr<VirtualScanner>> makeVirtualScanner(std::shared_ptr<const Patient> patient, const Probe& probe,
                                                                         const FormationOptions& options, std::uint64_t seed = 1);

/// Log compression: 255 + 255 / dynamicRange_db * 20 log10(envelope), clamped to 0..255, rounded.
void compressEnvelope(const Image<float>& envelope, double dynamicRange_db, Image<std::uint8_t>& levels);

}  // namespace ew
