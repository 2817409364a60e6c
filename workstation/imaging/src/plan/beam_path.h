#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "change_detector.h"
#include "compound.h"
#include "echoes/live_echoes.h"
#include "ew/imaging/bands.h"
#include "ew/imaging/beam_grid.h"
#include "ew/imaging/effects/attenuation.h"
#include "ew/imaging/effects/beam_gain.h"
#include "ew/imaging/effects/focus.h"
#include "ew/imaging/effects/reverberation.h"
#include "ew/imaging/effects/slice_thickness.h"
#include "ew/imaging/frame.h"
#include "ew/imaging/scan_conversion.h"
#include "own_grain.h"

namespace ew::detail {

/// What a thread needs for itself.
struct ThreadScratch {
  SliceScratch slicing;
  std::vector<float> row;
  double slicing_us = 0.0;  ///< of the frame in work, and what of it went into sampling before a stretch
  double zoomSampling_us = 0.0;
};

/// The steps of a frame that work along or across scan lines: their tables, the levels between them, and how they are shared between
/// threads. What goes along depth is shared by lines, what goes across by depths. Each step leaves what the next one takes.
class BeamPath {
 public:
  /// Makes the tables that the steps of `plan` need, and again only when what they depend on changed.
  /// @param look_rad how far lines are steered beyond what the knobs ask: a direction of a compound image
  void configure(const Plan& plan, const Probe& probe, const Knobs& knobs, const Scene& scene, const DisplayGeometry& geometry,
                 double spacing_mm, double look_rad = 0.0);

  /// From here on the frame is seen from this place.
  void place(const Transform<frame::Voxel, frame::Probe>& probeToVoxel) { probeToVoxel_ = probeToVoxel; }
  /// Live echoes: their field, and their envelope as the levels that all other steps take.
  void scatter(const FrameInput& input, Bands& bands);
  void takeEnvelope(Bands& bands);
  /// Blends the grain of the recorded volume that the maps are of into live echoes.
  void keepOwnGrain(const SliceSource& echo, const TissueMaps& maps, const Grid& placed,
                    const Transform<frame::World, frame::Probe>& probeToWorld, Bands& bands, std::span<ThreadScratch> scratch);
  void sample(const SliceSource& echo, Bands& bands, std::span<ThreadScratch> scratch);
  void addElevationPlanes(const SliceSource& echo, Bands& bands, std::span<ThreadScratch> scratch);
  /// Without labels the effects go by grey level.
  void sampleLabels(const SliceSource& labels, const Transform<frame::Voxel, frame::Probe>& probeToLabel, Bands& bands,
                    std::span<ThreadScratch> scratch);
  /// How well each line touches. @return whether any does not
  bool findContact(std::span<const float> gaps_mm);
  void loseContact(Bands& bands, std::span<ThreadScratch> scratch);
  /// Of live echoes by labels while their field is there, otherwise of levels.
  void attenuate(const FrameInput& input, Bands& bands, std::span<ThreadScratch> scratch);
  /// @param labels of live echoes, whose tissues are known
  void reverberate(const SliceSource& labels, const Transform<frame::Voxel, frame::Probe>& probeToLabel, Bands& bands);
  void focusByRows(Bands& bands, std::span<ThreadScratch> scratch);
  void focusByKernels(Bands& bands, std::span<ThreadScratch> scratch);
  void openBlack(Bands& bands);
  void addNoise(std::uint64_t frameNumber, Bands& bands);
  void amplify(Bands& bands);
  /// The mean with levels of other directions.
  void compound(const CompoundTable& table, std::span<BeamPath> asides, Bands& bands);
  void convert(Bands& bands, ImageView<std::uint8_t> image) const;

  /// One line of the levels as they are now, rounded; `beam` holds one value a sample.
  void takeLine(int line, std::span<std::uint8_t> beam) const;
  /// The same line straight from the volume, when no step needs beams.
  void sampleLine(int line, const SliceSource& echo, ThreadScratch& scratch, std::span<std::uint8_t> beam);

  [[nodiscard]] const BeamGrid& grid() const { return grid_; }
  [[nodiscard]] const BeamImage& levels() const { return echoes_; }
  /// Of live echoes in the frame in work; null: there are none.
  [[nodiscard]] const EchoMotion* motion() const { return isLive_ ? &live_.motion() : nullptr; }

 private:
  void layMiddlePlane(const Transform<frame::Voxel, frame::Probe>& probeToVoxel);
  void layPlane(const ElevationPlane& plane);
  void sampleRowsOf(const SliceSource& source, Quality quality, Bands& bands, std::span<ThreadScratch> scratch);
  void accumulate(float weight, bool isFirst, Bands& bands);
  [[nodiscard]] ImageView<float> lines(int first, int count);
  [[nodiscard]] ImageView<float> depths(int first, int count);

  Probe probe_;
  Knobs knobs_;
  Scene scene_;
  double greyPerDb_ = 0.0;

  BeamGrid grid_;
  ChangeDetector<Probe, double, bool, double, double, double> gridFrom_;
  ScanConversionTable conversion_;
  ChangeDetector<BeamGrid, DisplayGeometry> conversionFrom_;
  std::vector<ElevationPlane> planes_;
  ChangeDetector<BeamGrid, SliceThicknessEffect, double, int> planesFrom_;
  LateralKernels kernels_;
  ChangeDetector<BeamGrid, BeamModel> kernelsFrom_;
  std::vector<int> samplesOfRow_;
  ChangeDetector<BeamGrid, BeamModel> samplesOfRowFrom_;
  std::vector<float> noise_;
  ChangeDetector<BeamGrid, NoiseEffect, double, double> noiseFrom_;
  BeamGain gain_;
  BeamGainSetting gainSetting_;
  ChangeDetector<BeamGrid, BeamGainSetting> gainFrom_;
  TissueLosses losses_;
  LiveEchoes live_;
  ChangeDetector<Probe, EchoBeams, Scene, BeamGrid, double, bool, double, int> liveFrom_;
  bool isLive_ = false;
  bool hasField_ = false;   ///< live echoes whose envelope was not taken yet
  bool hasLabels_ = false;  ///< of the frame in work

  Transform<frame::Voxel, frame::Probe> probeToVoxel_;
  std::vector<SampleRow> rows_;    ///< of the plane in work, piece of depth after piece
  std::vector<int> firstSamples_;  ///< where each piece begins
  std::vector<SampleRow> planeRows_;
  std::vector<SampleRow> lineRow_;
  BeamGrid lineGrid_;  ///< one line alone
  GreyImage linesAsRows_;
  GreyImage labels_;  ///< (lines x samples)
  GreyImage own_;     ///< what the volume recorded, lines as rows
  OwnGrain ownGrain_;
  BeamImage echoes_;  ///< (lines x samples)
  std::vector<float> contact_;
  ReverberationScratch reverberation_;
};

}  // namespace ew::detail
