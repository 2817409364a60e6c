#pragma once

#include <complex>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <span>
#include <vector>

#include "ew/core/image.h"
#include "ew/core/pose.h"
#include "ew/core/volume.h"
#include "ew/imaging/beam_grid.h"
#include "ew/imaging/display.h"
#include "ew/imaging/display_image.h"
#include "ew/imaging/effects/persistence.h"
#include "ew/imaging/flow_memory.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/m_mode.h"
#include "ew/imaging/probe.h"
#include "ew/imaging/scene.h"
#include "ew/imaging/slicing.h"
#include "ew/imaging/spectrogram.h"
#include "ew/imaging/tissue_maps.h"
#include "ew/imaging/tissue_motion.h"

namespace ew {

class FlowSampler;

/// One thing a frame has to do, in the order it is done.
enum class StepKind {
  scatterers,  ///< live echoes: the field of the scatterers in the slice, under the beams
  sampleWeave,
  sampleLinear,
  sampleCubic,
  zoomStretch,      ///< the paper's interleaved stretches of a weave that zooms in
  elevationPlanes,  ///< the planes beside the middle one, and their mean
  labels,           ///< which tissue each sample lies in
  contact,
  attenuation,
  reverberation,
  focusStretch,
  focusKernel,
  black,  ///< recorded black, opened for a gain in decibels
  noise,
  envelope,  ///< of live echoes: pulse, looks, logarithm
  compound,  ///< the steps so far along lines of other directions, and the mean of all
  ownGrain,  ///< of a recorded volume, blended into live echoes
  gain,      ///< gain, TGC and dynamic range in decibels
  mMode,
  scanConversion,
  edges,
  persistence,
  table,     ///< the paper's gain, DGC and dynamic range; grey map
  spectrum,  ///< the sample volume from the last frame to this one, and its spectra
  colour,    ///< the box's packets, wall filter and sums; over the image in colours
};
/// In plans, reports and benchmarks.
const char* nameOf(StepKind kind);
/// In a window: English, translatable in the context "ew::StepKind".
const char* labelOf(StepKind kind);
struct Step {
  StepKind kind = StepKind::sampleLinear;
  double estimated_us = 0.0;  ///< from the counts of pixels and samples, on a machine of 2023; not part of comparison
  bool operator==(const Step& other) const { return kind == other.kind; }
};

/// What frames are made of beside the volume.
struct FrameParts {
  bool labels = false;
  bool tissue = false;    ///< maps: then a scene with live echoes forms them, and samples no volume
  bool recorded = false;  ///< these are of a recorded volume (TissueMaps::isRecorded), whose own grain may be kept
  bool flow = false;      ///< and what its blood does: then knobs with a colour box show it
  bool operator==(const FrameParts&) const = default;
};

/// What a frame runs, in order. Neutral steps are not in it. Printable ("beams: linear + focus + scan conversion"), comparable.
struct Plan {
  std::vector<Step> steps;
  bool onBeams = false;  ///< sampled on the beam grid and scan-converted; otherwise the display grid is sampled directly
  bool operator==(const Plan&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Plan& plan);

/// The steps that this setting calls for. Left out are: every effect the scene does not have, a table that changes nothing, knobs at their
/// neutral setting, noise that cannot be seen, contact while everything touches; and beams, when no step needs them (a linear array that
/// steers or fans out does not: the display grid is clipped to its fan; M-mode does not: its beam is sampled alone). Gain, DGC, dynamic
/// range and grey map are one table; in decibels all but the grey map are a step on beams.
/// @param hasGaps   whether parts of the face are off the skin, beyond what gel fills
[[nodiscard]] Plan makePlan(const Probe& probe, const Knobs& knobs, const Scene& scene, const DisplayGeometry& geometry, const Grid& grid,
                            const FrameParts& parts = {}, bool hasGaps = false);

/// Time of one step of one frame.
struct StepTime {
  StepKind kind = StepKind::sampleLinear;
  double measured_us = 0.0;
};

/// Everything that changes from frame to frame. Someone else owns voxels and gaps until the frame is made.
struct FrameInput {
  SliceSource echo;         ///< its grid's place in the world may differ from the one configured (a moved volume needs no new tables)
  SliceSource labels = {};  ///< of the tissues of the scene, on any grid; empty: grey levels decide
  const TissueMaps* tissue = nullptr;  ///< from which live echoes are formed
  std::uint64_t tissueVersion = 0;     ///< the same number, the same tissue: what was made of it is kept for the next frame; 0: nothing is
  Grid tissueGrid = {};                ///< its place in the world
  const TissueMotion* motion = nullptr;  ///< of `tissue`, in the frame of its own grid; a scene with motion moves it
  BodyState body = {};                   ///< where it stands
  const FlowSampler* flow = nullptr;     ///< blood of `tissue`, in the frame of its own grid
  Pose pose = {};
  std::span<const float> gaps_mm =
      {};                    ///< skin to face, from the face's -x end to its +x end (effects/contact.h); empty: everything touches
  double time_s = 0.0;       ///< of the M-mode strip and of the blood's beats
  std::uint64_t number = 0;  ///< of the noise: the same number, the same noise
};

/// What shows of earlier frames in later ones: persistence's levels, the strip of the M-mode, and of colour its persistence and where probe
/// and body stood. Empty where none of them runs.
struct FrameMemory {
  PersistenceMemory persistence;
  MModeStrip strip;
  ColourMemory colour;
  std::shared_ptr<const SpectrumMemory> spectrum = nullptr;  ///< null: none ran
  FrameBefore before;
};

/// Makes frames of one probe and one setting after another; owns the tables and scratch memory, so that a frame allocates nothing.
class FrameMaker {
 public:
  /// @param threads that work on one frame; 0: one per processor. Images do not depend on it.
  explicit FrameMaker(int threads = 1);
  ~FrameMaker();
  FrameMaker(FrameMaker&&) noexcept;
  FrameMaker& operator=(FrameMaker&&) noexcept;

  /// Rebuilds what depends on these values, and only when they changed.
  /// @param pan what a zoomed image shows; the viewer's, not the machine's: it is no knob
  void configure(const Probe& probe, const Knobs& knobs, const Scene& scene, const Grid& grid, int width, int height,
                 const FrameParts& parts = {}, const Pan& pan = {});

  /// The image for one pose: black outside the fan and outside the volume. Its views stay valid until the next call.
  /// A pose that is not PoseStatus::ok, or whose matrix checkRigid refuses, gives a black image; lastStatus() tells which happened.
  DisplayImage make(const FrameInput& input);
  /// The same with everything touching, no labels, frame number 0.
  DisplayImage make(const VolumeView<const std::uint8_t>& volume, const Pose& pose);

  /// The strip of the M-mode or the spectrum, as wide and high as the image; width 0 when the mode has none.
  [[nodiscard]] ImageView<const std::uint8_t> strip() const;
  [[nodiscard]] int stripCursor() const;
  /// The same with its clock.
  [[nodiscard]] const MModeStrip& mMode() const;
  /// Forgets earlier frames: persistence and M-mode start afresh.
  void forget();
  /// What it remembers after the last frame, to be recalled by any maker.
  [[nodiscard]] FrameMemory memory() const;
  /// As if the frame after which `memory` was taken had been made last. Expects that maker's configuration; a memory of another size is
  /// as good as none.
  void recall(const FrameMemory& memory);

  /// What the last frame ran; before the first one, what a frame runs that touches everywhere.
  [[nodiscard]] const Plan& plan() const;
  [[nodiscard]] const DisplayGeometry& geometry() const;
  /// What the last frame's steps took, in the order of the plan; empty when the frame was black for want of a pose.
  [[nodiscard]] const std::vector<StepTime>& lastTimes() const;
  /// The status of the last pose, PoseStatus::invalid when its matrix was refused, PoseStatus::missing before the first frame.
  [[nodiscard]] PoseStatus lastStatus() const;
  [[nodiscard]] const Spans& spans() const;
  /// Where the lines and samples of the last frame lie; no line when its plan needs no beams.
  [[nodiscard]] const BeamGrid& beamGrid() const;
  /// Its levels as the last step on beams left them, on beamGrid(): not rounded, before grey map and scan conversion. To measure with.
  [[nodiscard]] const BeamImage& beamLevels() const;
  /// Spectra of the sample volume; null without one. Their strip is strip().
  [[nodiscard]] const Spectrogram* spectrogram() const;
  /// What the sample volume gave in the last frame, a complex number a pulse, behind the wall filter: what is heard. Positive Doppler
  /// shifts are towards the probe. Valid until the next frame.
  [[nodiscard]] std::span<const std::complex<float>> dopplerSamples() const;
  /// Where lines and gates of the colour box lie, from the face to its lower edge; no line without one. What was measured there is in
  /// memory().colour.
  [[nodiscard]] const BeamGrid& colourGrid() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace ew
