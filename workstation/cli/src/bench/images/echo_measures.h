#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/volume.h"
#include "ew/imaging/beam_grid.h"
#include "ew/imaging/scene.h"
#include "ew/imaging/tissue_maps.h"

namespace ew {

/// Echoes of one frame on its beams, as powers: 1 is full white.
struct EchoFrame {
  BeamGrid grid;
  std::vector<float> power;  ///< (lines x samples), a row for each sample
  [[nodiscard]] float at(int line, int sample) const {
    return power[static_cast<std::size_t>(sample) * grid.lines.size() + static_cast<std::size_t>(line)];
  }
};
/// @param amplitudes (lines x samples), as VirtualScanner::envelope gives them
[[nodiscard]] EchoFrame frameOfAmplitudes(const BeamGrid& grid, const Image<float>& amplitudes);
/// @param levels (lines x samples), as FrameMaker::beamLevels gives them
[[nodiscard]] EchoFrame frameOfLevels(const BeamGrid& grid, const BeamImage& levels, double dynamicRange_db);

/// What is known of the tissue, on its grids in the world.
struct EchoTruth {
  const TissueMaps& maps;
  const Grid& mapsGrid;
  const Volume& volume;  ///< its coverage tells the body from the air
  const Grid& volumeGrid;
  const Volume* labels = nullptr;
  const Grid& labelsGrid;
  std::array<float, 256> reflection_db{};   ///< by label
  std::array<float, 256> excess_dbPerMm{};  ///< by label, both ways: attenuation that depth gain does not make up for
  std::array<bool, 256> isUneven{};         ///< by label: speckle that is not fully developed, or a texture too fine for the maps
};

inline constexpr double kEchoStep_mm = 0.5;  ///< of the truth along a line

/// A piece of the image a few resolution cells wide, of which it is known what lies there.
struct EchoPatch {
  int firstLine = 0, lines = 0;
  double from_mm = 0.0, to_mm = 0.0;
  bool isOpen = false;    ///< at least half of it tissue, nothing reflecting in front of it
  bool isEven = false;    ///< open, without great steps of level, dense with scatterers: fully developed speckle
  bool isShaded = false;  ///< at least half of it tissue, half of its lines in a shadow; its sides may reach in
  /// By line and step of kEchoStep_mm the tissue's level by the maps; 0: no tissue or a surface near, left out.
  std::vector<std::uint8_t> levels;
  std::vector<std::uint8_t> evenLevels;  ///< of these, 0 also where other tissue is near: what is thinner than a voxel of the maps
  [[nodiscard]] std::uint8_t valueAt(const std::vector<std::uint8_t>& values, int line, double depth_mm) const;
  [[nodiscard]] double middle_mm() const { return 0.5 * (from_mm + to_mm); }
};

/// Divides the fan into patches and asks the truth about each, in five planes of the slice.
/// @param elevationalSigma_mm of the beam, by whole mm of depth
[[nodiscard]] std::vector<EchoPatch> patchesOf(const EchoTruth& truth, const BeamGrid& grid, const std::vector<double>& elevationalSigma_mm,
                                               const Transform<frame::World, frame::Probe>& probeToWorld);

/// Mean power of a patch, dB below full white.
[[nodiscard]] double levelOf_db(const EchoFrame& frame, const EchoPatch& patch);

inline constexpr int kEchoBands = 4;  ///< of depth, equally deep

/// Sums over patches of fully developed speckle, each divided by its own mean.
class SpeckleSums {
 public:
  /// @param axialWidth_mm, lateralWidth_mm of the resolution cell at the patch: lags are about half of them
  void add(const EchoFrame& frame, const EchoPatch& patch, double axialWidth_mm, double lateralWidth_mm);
  [[nodiscard]] double signalToNoise() const;  ///< mean of the envelope over its standard deviation; 0 without patches
  struct Lengths {
    double axial_mm = 0.0;  ///< full width at half maximum of the intensity's autocovariance, taken for a Gaussian; 0: too few patches
    double lateral_mm = 0.0;
    int patches = 0;
  };
  [[nodiscard]] Lengths lengths(int band) const;

 private:
  struct Band {
    double variance = 0.0, axial = 0.0, lateral = 0.0;  ///< sums of products
    double axialLag2_mm2 = 0.0, lateralLag2_mm2 = 0.0;  ///< of squared lags, weighted as the products
    double axialCount = 0.0, lateralCount = 0.0, count = 0.0;
    int patches = 0;
  };
  double amplitude_ = 0.0, square_ = 0.0, count_ = 0.0;
  std::array<Band, kEchoBands> bands_;
};

/// Correlation of the intensities of two views of one place.
class ViewCorrelation {
 public:
  /// Powers of `moved` where the patch of `still` lies in it.
  /// @param stillToMoved where a point of one probe's frame lies in the other's; points that leave the image plane are taken in it
  void add(const EchoFrame& still, const EchoFrame& moved, const EchoPatch& patch,
           const Transform<frame::Probe, frame::Probe>& stillToMoved, const Probe& probe);
  [[nodiscard]] double value() const;  ///< 1 for the same, 0 without patches
  [[nodiscard]] int patches() const { return patches_; }

 private:
  double aa_ = 0.0, bb_ = 0.0, ab_ = 0.0;
  int patches_ = 0;
};

}  // namespace ew
