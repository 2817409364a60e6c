#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "echo_layout.h"
#include "echo_losses.h"
#include "echo_motion.h"
#include "echo_reverberation.h"
#include "echo_surfaces.h"
#include "ew/imaging/bands.h"
#include "ew/imaging/beam_grid.h"
#include "ew/imaging/slice_source.h"
#include "line_kernels.h"
#include "scatterers.h"
#include "speckle_reduction.h"

namespace ew::detail {

/// Forms the echoes of a frame anew from scatterers that are fixed in the tissue: complex field on the fine grid, beams, losses, noise,
/// pulse, envelope, logarithm. Its steps are called in this order; between them the field lies as one row of complex numbers a line.
/// Source: scatterers seen through a separable point spread function, as resources/docs/science/forward-model.md; no code is shared with
/// it.
class LiveEchoes {
 public:
  /// @param grid made with echoSpacing_mm and this look
  void configure(const Probe& probe, const Knobs& knobs, const Scene& scene, const EchoBeams& beams, const BeamGrid& grid, double look_rad);

  /// What the steps after it show of the tissue's motion.
  /// @param motion null: nothing moves
  /// @param strength of it, 0..1
  /// @param motionToProbe from the frame of its grids, rigid
  /// @param giving level of tissue that gives way to the face; null: it stands still
  void move(const TissueMotion* motion, const BodyState& body, double strength, const Transform<frame::Probe, frame::World>& motionToProbe,
            const SliceSource* giving, const Transform<frame::Voxel, frame::Probe>& probeToGiving, Bands& bands);
  /// @param version FrameInput::tissueVersion of the maps
  /// @param placed  where the maps lie now
  void scatter(const TissueMaps& maps, std::uint64_t version, const Grid& placed, const Transform<frame::World, frame::Probe>& probeToWorld,
               Bands& bands);
  void lose(const SliceSource& labels, const Transform<frame::Voxel, frame::Probe>& probeToLabel, const SliceSource& level,
            const Transform<frame::Voxel, frame::Probe>& probeToLevel, Bands& bands);
  void reverberate(const SliceSource& labels, const Transform<frame::Voxel, frame::Probe>& probeToLabel, Bands& bands);
  void addNoise(const NoiseEffect& noise, std::uint64_t frameNumber, Bands& bands);
  /// @param greyPerDb of the levels
  /// @param echoes (lines x samples)
  void takeEnvelope(double greyPerDb, Bands& bands, ImageView<float> echoes);
  /// Of the last frame.
  [[nodiscard]] const EchoMotion& motion() const { return motion_; }

 private:
  /// Where scatterers and fragments of a frame lie.
  struct ScatterPlaces {
    EchoPlace scatterers, fragments;
    const SliceSource& level;
    ScatterTask task;
  };
  struct Scratch {
    std::vector<ScatterBlock> blocks;
    BlockShifts shifts;
    EchoReverberation::Scratch reverberation;
    std::vector<float> line, levels, gains;
  };
  [[nodiscard]] float* lineAt(int line) { return field_.data() + static_cast<std::ptrdiff_t>(line) * stride_; }
  void addPiece(const ScatterPlaces& places, int piece, PartOfPiece part, int slot);
  void filter(Bands& bands);
  void filterTile(int tile, int part, int parts);
  /// Without its lines.
  [[nodiscard]] LateralTask lateralOf(int tile);
  /// Rows that lines on both sides of a border ask: of the last lines before `line` and of the first from there on.
  struct Rows {
    int begin = 0, end = 0;
  };
  [[nodiscard]] Rows rowsAbout(int line, int tile) const;
  void addHaze(int line, std::span<float> out);
  void layHaze(double haze_db);

  EchoLayout layout_;
  EchoSurfaces surfaces_;
  EchoLosses losses_;
  EchoReverberation reverberation_;
  SpeckleReduction reduction_;
  EchoMotion motion_;
  double carrier_hz_ = 3.5e6;
  std::vector<Scratch> scratch_;
  std::vector<ScattererStore> stores_;  ///< by piece and part of it: they are one thread's each
  std::uint64_t storesOf_ = 0;          ///< version of the maps they are of, seen by this task
  ScatterTask storedTask_;
  std::vector<float> field_;  ///< lines x columns complex numbers, padded to whole tiles
  std::ptrdiff_t stride_ = 0;
  std::vector<std::int32_t> fine_;  ///< the fine grid: rows x columns complex numbers, and one column more; 0 between frames
  std::ptrdiff_t fineStride_ = 0;
  std::vector<float> noise_;            ///< strength by column
  std::optional<NoiseEffect> noiseOf_;  ///< that it is of; none: it has not been made
  std::optional<std::uint64_t> noiseKey_;
  struct Lobe {
    float weight = 0.0F;
    int quarter = 0;
    std::vector<int> offset;  ///< in lines, by tile
  };
  std::vector<Lobe> lobes_;
};

}  // namespace ew::detail
