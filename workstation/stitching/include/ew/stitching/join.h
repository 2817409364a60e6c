#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ew/core/beams.h"
#include "ew/core/compounding.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/registration/deformation.h"
#include "ew/stitching/common_grid.h"

namespace ew::stitching {

/// What is added to the grey levels of a view at a depth: gain and depth gain are offsets after log compression. 0 stays 0.
struct GreyCorrection {
  std::optional<Beams> beams = {};  ///< along which depth grows, in the view's own frame; none: the same correction everywhere
  double firstKnot_mm = 0.0;        ///< depth (beams->depth_mm) of grey[0]
  double knot_mm = 15.0;
  std::vector<double> grey;  ///< empty: none
  [[nodiscard]] double at(const glm::dvec3& p_mm) const;
  bool operator==(const GreyCorrection&) const = default;
};

/// A subvolume as it goes into the whole: where it lies, how it warps, how its grey levels are corrected, how far it is to be believed.
struct View {
  const Volume* volume = nullptr;                     ///< never null
  std::span<const std::uint8_t> confidence;           ///< voxelCount() values, 255 for 1; empty: 1 wherever covered
  Transform<frame::World, frame::View> toWorld = {};  ///< rigid
  const registration::ControlGrid* warp = nullptr;    ///< in the world: world point p shows the view's world point p + u(p); null: none
  GreyCorrection correction;
  std::string name;
};

/// "Here prefer this view": a ball painted by hand, in the world.
struct SeamStroke {
  std::size_t view = 0;
  glm::dvec3 at_mm{0.0};
  double radius_mm = 5.0;
  bool operator==(const SeamStroke&) const = default;
};

struct SeamOptions {
  SeamMethod method = SeamMethod::graphCut;
  double cell_mm = 1.5;   ///< voxels on which the cut is sought, never finer than the result's
  double blend_mm = 3.0;  ///< half width of the blend on either side of the seam; its weights keep the speckle's deviation
  /// Half width over which the views' local means pass over into each other, of a cut with a blend; 0: with the blend, in less memory.
  double levelBlend_mm = 0.0;
  double confidenceWeight = 1.0;  ///< how much a view that saw nothing there is shunned: a shadow is filled from another view
  double distanceWeight = 0.1;    ///< how much the middle of a view is preferred to its border
  std::vector<SeamStroke> strokes;
  int threads = 0;
  bool operator==(const SeamOptions&) const = default;
};

/// Which view each cell of the result takes: what the seam step finds, the seam editor shows and the join reads.
struct SeamMap {
  Grid cells;
  std::vector<std::uint8_t> view;  ///< 1 + index of the view; 0: no view covers the cell
  /// What is added to a view's grey levels near seams (SeamOptions::levelBlend_mm), on a box of the cells; linear between their middles.
  struct Levels {
    glm::ivec3 begin{0};
    glm::ivec3 size{0};
    std::vector<std::int16_t> offset;  ///< kOffsetUnit grey levels
    bool operator==(const Levels&) const = default;
  };
  static constexpr double kOffsetUnit = 1.0 / 64.0;
  std::vector<Levels> levels;  ///< one per view, or none
  double cutCost = 0.0;        ///< mean difference of the views over the seam's faces, grey levels
  std::size_t seamFaces = 0;
  bool operator==(const SeamMap&) const = default;
};

/// @param result grid of the whole (forecastStitch gives it)
/// @error emptyVolume, badField, tooLarge, cancelled (within 0.5 s)
[[nodiscard]] Result<SeamMap> findSeams(std::span<const View> views, const Grid& result, const SeamOptions& options, Progress& progress);

/// How visible the seam is, along the surface between two views; each 1 (or 0 dB) when nothing shows.
struct SeamVisibility {
  double derivativeRatio = 1.0;  ///< mean |derivative| across the seam over that across the 10 parallel surfaces beside it
  double speckleRatio = 1.0;     ///< deviation of speckle within the blend over that outside
  double meanStep_db = 0.0;      ///< step of the local mean across the seam that patches of 24 mm have in common, at a range of 60 dB
  std::size_t voxels = 0;        ///< beside a seam
};

struct JoinOptions {
  StitchOptions grid;  ///< spacing, axes, threads, maxBytes; feather width for SeamMethod::feather
  SeamOptions seam;
  int block = 128;  ///< side of the blocks in voxels when the result is made in pieces; the voxels do not depend on it
};

/// Receives the result block by block: in memory, or in files larger than memory.
class BlockSink {
 public:
  virtual ~BlockSink();
  /// @param corner first voxel of the block in the whole; the spans hold size.x * size.y * size.z values, i fastest
  [[nodiscard]] virtual Result<void> put(const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> echo,
                                         std::span<const std::uint8_t> coverage, std::span<const std::uint8_t> source) = 0;
};

struct JoinReport {
  Grid grid;
  std::vector<Contribution> contributions;  ///< one per view
  SeamVisibility seam;           ///< as seamVisibility, but the step is that between the views in the blend, which no tissue can feign
  double overlapShare = 0.0;     ///< of the covered voxels, those to which two or more views contributed; with seams counted cell by cell
  double disagreementRms = 0.0;  ///< grey levels: spread of the views about their blend where they were blended; 0 where none was
  std::vector<Message> notes;    ///< what the user should know: a view that touches no other, one that contributed nothing
  double seconds = 0.0;
};

/// Memory at the peak for making the result in blocks, the views themselves not counted.
[[nodiscard]] Result<StitchForecast> forecastJoin(std::span<const GridPlacement> views, const JoinOptions& options);

/// Makes the whole, block by block: a blocked result equals the whole one, bit for bit. The seam's visibility is then measured within
/// blocks: what reaches over a block's edge is left out.
/// @param seams of findSeams for this result; not looked at by SeamMethod::feather
/// @error as findSeams, and what the sink says
[[nodiscard]] Result<JoinReport> join(std::span<const View> views, const SeamMap& seams, const Grid& result, const JoinOptions& options,
                                      BlockSink& sink, Progress& progress);
/// The same in memory.
struct JoinResult {
  Volume volume;                     ///< with coverage: measured where a measured voxel contributed
  std::vector<std::uint8_t> source;  ///< per voxel 1 + index of the view that weighed most (the earlier one of equals); 0: absent
  JoinReport report;
};
[[nodiscard]] Result<JoinResult> join(std::span<const View> views, const SeamMap& seams, const Grid& result, const JoinOptions& options,
                                      Progress& progress);

/// Measures a seam in any joined volume with its sources (ours or another program's). An edge of tissue along which the seam runs on
/// purpose counts as a step: only who has the views can tell the two apart.
[[nodiscard]] SeamVisibility seamVisibility(const Volume& joined, std::span<const std::uint8_t> source, double blend_mm);

}  // namespace ew::stitching
