#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/pose.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/imaging/flow_sampler.h"
#include "ew/imaging/layout_times.h"
#include "ew/imaging/scene.h"
#include "ew/imaging/slice_source.h"
#include "ew/imaging/tissue_maps.h"
#include "ew/imaging/tissue_motion.h"
#include "ew/io/mapped_volume.h"
#include "ew/library/case.h"
#include "ew/scanning/preset.h"
#include "ew/scanning/state.h"

namespace ew {
struct Provenance;
class FrameStack;

/// Voxels to scan, in the layout that slicing reads fastest. Copies share them; nobody changes them.
class ScanVoxels {
 public:
  ScanVoxels() = default;
  /// When bricks are made: with the volume, or when somebody reads slices of it (withBricks), and then only as long as somebody does.
  enum class Bricks { now, whenRead };
  /// Bricks are made beside the volume where they make some slices faster and at least half of the free memory stays free. Which layout
  /// is faster for which slices is timed at the first volume of about this size, which takes 0.15 s, and kept in the cache (decision 0030).
  /// @error cancelled
  [[nodiscard]] static Result<ScanVoxels> of(std::shared_ptr<const Volume> volume, Progress& progress = noProgress(),
                                             Bricks when = Bricks::now);
  /// The volume as it lies: for a few slices that are not worth the bricks.
  [[nodiscard]] static ScanVoxels asStored(std::shared_ptr<const Volume> volume);
  /// Bricks in `levels` resolutions beside the rows; each slice is read as `times` says, which nothing makes measure here and now.
  /// @error as bricksOf
  [[nodiscard]] static Result<ScanVoxels> inBothLayouts(std::shared_ptr<const Volume> volume, int levels,
                                                        const std::optional<LayoutTimes>& times, Progress& progress = noProgress());
  /// Bricks in `levels` resolutions for every slice, whatever they cost. @error as bricksOf
  [[nodiscard]] static Result<ScanVoxels> inBricks(std::shared_ptr<const Volume> volume, int levels, Progress& progress = noProgress());
  /// From here on slices read these recorded images, which lie among the voxels, and no voxels.
  void readFrom(std::shared_ptr<const FrameStack> frames) { frames_ = std::move(frames); }
  /// Null: slices read voxels.
  [[nodiscard]] const std::shared_ptr<const FrameStack>& frames() const { return frames_; }
  /// Voxels that stay in their file.
  [[nodiscard]] static ScanVoxels of(std::shared_ptr<const MappedVolume> mapped);

  [[nodiscard]] bool empty() const { return volume_ == nullptr && mapped_ == nullptr; }
  /// Too small for a layout to matter: a megabyte at most, which the processor keeps near.
  [[nodiscard]] static bool isSmall(const Volume& volume);
  /// What slices cost from either layout; nothing where that was not asked.
  [[nodiscard]] const std::optional<LayoutTimes>& layoutTimes() const { return layoutTimes_; }
  /// The grid of the voxels' own, before anybody placed them.
  [[nodiscard]] const Grid& grid() const;
  /// @param placed where they lie now, of the same dims as grid()
  /// @param pixel_mm of the image: zooming out may read a coarser level; 0: the finest whatever the image
  /// @return valid as long as these voxels are there; without the bricks that would have to be made (withBricks)
  [[nodiscard]] SliceSource source(const Grid& placed, double pixel_mm) const;
  /// Null when they stay in their file.
  [[nodiscard]] const std::shared_ptr<const Volume>& volume() const { return volume_; }
  /// Null when every slice reads them as they lie, and where bricks are made when slices are read.
  [[nodiscard]] const std::shared_ptr<const BrickVolume>& bricks() const { return bricks_; }
  /// Whether some slices are read from bricks, which may have to be made first.
  [[nodiscard]] bool readsBricks() const { return bricks_ != nullptr || neededBricks_ != nullptr; }
  /// The same with the bricks that slices of it are read from, for as long as somebody has a copy of what is returned: those that somebody
  /// else has already, or made now. As it is when there are none to be made, or no memory for them.
  [[nodiscard]] ScanVoxels withBricks() const;
  /// @error notReadable when a file they stay in was changed since
  [[nodiscard]] Result<void> unchanged() const;

 private:
  class BricksByNeed;
  std::shared_ptr<const Volume> volume_;
  std::shared_ptr<const BrickVolume> bricks_;
  std::shared_ptr<BricksByNeed> neededBricks_;  ///< null: those there are were made with the volume
  std::shared_ptr<const MappedVolume> mapped_;
  std::shared_ptr<const FrameStack> frames_;
  std::optional<LayoutTimes> layoutTimes_;
};

/// What is scanned: voxels, where they lie, and what is known of them. A value that is cheap to copy: voxels are shared, and placing it
/// elsewhere changes grids alone. Window, command line, cards and tests scan this and nothing else, so that they show the same.
struct ScanSubject {
  std::string title;  ///< as a trainee may read it
  ScanVoxels voxels;
  Grid placedGrid;                                         ///< where they lie; of the dims of their own grid
  std::shared_ptr<const Volume> labels = nullptr;          ///< which tissue each voxel is, on a grid of its own; null: grey levels decide
  Grid placedLabels = {};                                  ///< where the labels lie
  std::shared_ptr<const TissueMaps> tissue = nullptr;      ///< what live echoes are formed from; null: nothing is known but the voxels
  Grid placedTissue = {};                                  ///< where the maps of tissue lie
  std::shared_ptr<const TissueMotion> motion = nullptr;    ///< how that tissue moves, in the frame of its own grid; null: it does not
  std::shared_ptr<const FlowSampler> flow = nullptr;       ///< what its blood does, in the frame of its own grid; null: nobody knows
  Scene scene = {};                                        ///< what the case calls for, with the tissues of the labels
  std::vector<std::string> probes = {};                    ///< ids that may be used, the first is the default; empty: all
  std::vector<std::string> presets = {};                   ///< ids of the console's presets it offers; its scan begins with the first
  std::optional<Pose> startPose = {};                      ///< where whoever scans begins
  std::shared_ptr<const Provenance> provenance = nullptr;  ///< which frame each voxel came from; null: nobody knows
  bool isDraft = false;                                    ///< shown until the voxels that the case asks for are made

  /// A scene without what cannot be shown of this subject: live echoes where no tissue is known, motion where it does not move.
  [[nodiscard]] Scene known(Scene asked) const {
    if (!tissue) asked.liveEchoes.reset();
    if (!tissue || !motion) asked.motion.reset();
    return asked;
  }
  /// Whether a colour box shows anything, and there is a spectrum to be shown.
  [[nodiscard]] bool showsColour() const { return tissue && flow; }
  /// Whether images in such a scene change with the body. Motion is seen in live echoes alone.
  [[nodiscard]] bool movesIn(const Scene& asked) const { return tissue && motion && asked.liveEchoes && asked.motion; }
  /// Whether images show blood that flows: within a colour box or a sample volume.
  [[nodiscard]] bool flowsIn(const Knobs& knobs) const { return (knobs.colour || knobs.mode == DisplayMode::spectrum) && showsColour(); }
  /// Whether images change with the time alone: the body moves in such a scene, or blood flows.
  [[nodiscard]] bool changesIn(const Scene& asked, const Knobs& knobs) const { return movesIn(asked) || flowsIn(knobs); }

  /// The same without what could not be shown of it whatever were found out (recordedTissueOf).
  [[nodiscard]] Scene possible(Scene asked) const {
    if (!canFormEchoes()) asked.liveEchoes.reset();
    return asked;
  }

  /// Whether tissue is known, or can be known of the voxels (recordedTissueOf).
  [[nodiscard]] bool canFormEchoes() const { return tissue != nullptr || voxels.volume() != nullptr; }
  /// From here on live echoes are formed from these maps, which lie on the grid of the voxels' own.
  void know(std::shared_ptr<const TissueMaps> ofVoxels);

  /// Moves voxels, labels and maps of tissue to where `ownToWorld` (rigid, mm) takes the grids of their own.
  void place(const Transform<frame::World, frame::World>& ownToWorld);
};

/// What live echoes of a recorded volume are formed from: its level (imaging/tissue_level.h), made now, in seconds; as large as the volume.
/// @param scene whose recorded dynamic range its grey spans
/// @error as levelOf; unsupported: the voxels stay in their file
[[nodiscard]] Result<std::shared_ptr<const TissueMaps>> recordedTissueOf(const ScanVoxels& voxels, const Scene& scene, int threads,
                                                                         Progress& progress);

/// How the scan of a subject begins: probe and settings of its start preset (startPreset), else its first probe and neutral settings; its
/// start pose, the effects of its scene, everything touching. Without a start pose the probe stands across the middle of the front of its
/// voxels. Window, command line and cards begin so and nowhere else.
/// @param probes there are
/// @param presets there are
/// @return empty when the subject's first probe is not among them
[[nodiscard]] std::optional<ScanState> firstState(const ScanSubject& subject, const std::vector<Probe>& probes,
                                                  const std::vector<Preset>& presets);

/// A volume that belongs to no case, where its own coordinates say.
[[nodiscard]] ScanSubject subjectOf(ScanVoxels voxels, std::string title);

/// What a case's manifest names, read once. Title, placement, scene and probes may be edited afterwards: subjectOf takes them from the
/// case.
struct CaseContents {
  ScanVoxels voxels;
  std::shared_ptr<const Volume> labels;                   ///< null when the case has none
  std::shared_ptr<const TissueMaps> tissue;               ///< what live echoes are formed from; null when the case has none
  std::shared_ptr<const TissueMotion> motion = nullptr;   ///< of the tissue; null when it does not move
  std::shared_ptr<const FlowSampler> flow = nullptr;      ///< of its blood; null when nobody says how it flows
  std::vector<TissueAcoustics> tissues = {};              ///< of the labels, as the recipe has them
  Transform<frame::World, frame::File> fileToWorld = {};  ///< the grids are placed with it
  std::vector<Message> notes;
  bool isDraft = false;  ///< as of CaseEcho
};
/// @error as loadCaseVolume; cancelled
[[nodiscard]] Result<CaseContents> readContents(const Case& opened, Progress& progress, const PreparationOptions& options = {});

/// What frames ask of an echo's blood; null where it has none, or no tissue.
[[nodiscard]] std::shared_ptr<const FlowSampler> samplerOf(const CaseEcho& echo);

/// The labels that a case of a file names, on a grid in the frame of `contents`, which were read before the case named these; null: none.
/// @error as readLabelVolume, badField
[[nodiscard]] Result<std::shared_ptr<const Volume>> readLabelsFor(const Case& edited, const CaseContents& contents, Progress& progress);

/// Where a case as it stands puts the grids of its contents.
[[nodiscard]] Transform<frame::World, frame::World> ownToWorldOf(const Case& edited, const CaseContents& contents);

/// A case as it stands, with contents read from it, perhaps before it was edited.
[[nodiscard]] ScanSubject subjectOf(const Case& edited, const CaseContents& contents);

}  // namespace ew
