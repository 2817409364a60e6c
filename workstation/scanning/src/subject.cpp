#include "ew/scanning/subject.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "ew/core/contract.h"
#include "ew/core/memory.h"
#include "ew/imaging/tissue_level.h"
#include "ew/io/volume_file.h"
#include "ew/library/case_start.h"
#include "ew/tracking/hand.h"
#include "kept_layouts.h"

namespace ew {
namespace {

constexpr int kLevels = 4;  // the coarsest an eighth as fine as the volume
constexpr std::size_t kSmall_bytes = std::size_t{1} << 20;

/// Whether bricks leave at least half of the free memory free.
bool bricksFit(const Volume& volume) {
  const auto free_bytes = availableMemory_bytes();
  return !free_bytes || bricksForecast_bytes(volume.grid.dims, kLevels) <= *free_bytes / 2;
}

}  // namespace

/// Bricks of a volume that are there as long as somebody reads them. Known to all copies of its voxels, on any thread.
class ScanVoxels::BricksByNeed {
 public:
  /// @return null when there is no memory for them
  [[nodiscard]] std::shared_ptr<const BrickVolume> of(const Volume& volume) {
    const std::lock_guard lock(guard_);
    if (auto there = made_.lock()) return there;
    if (!bricksFit(volume)) return nullptr;
    auto bricks = bricksOf(volume.view(), kLevels, 0, noProgress());
    if (!bricks) return nullptr;
    auto made = std::make_shared<const BrickVolume>(std::move(*bricks));
    made_ = made;
    return made;
  }

 private:
  std::mutex guard_;
  std::weak_ptr<const BrickVolume> made_;
};

ScanVoxels ScanVoxels::withBricks() const {
  ScanVoxels held = *this;
  if (neededBricks_ && !bricks_) held.bricks_ = neededBricks_->of(*volume_);
  return held;
}

ScanVoxels ScanVoxels::asStored(std::shared_ptr<const Volume> volume) {
  EW_EXPECTS(volume != nullptr);
  ScanVoxels voxels;
  voxels.volume_ = std::move(volume);
  return voxels;
}

Result<ScanVoxels> ScanVoxels::inBricks(std::shared_ptr<const Volume> volume, int levels, Progress& progress) {
  ScanVoxels voxels = asStored(std::move(volume));
  auto bricks = bricksOf(voxels.volume_->view(), levels, 0, progress);
  if (!bricks) return passOn(bricks.error());
  voxels.bricks_ = std::make_shared<const BrickVolume>(std::move(*bricks));
  return voxels;
}

Result<ScanVoxels> ScanVoxels::inBothLayouts(std::shared_ptr<const Volume> volume, int levels, const std::optional<LayoutTimes>& times,
                                             Progress& progress) {
  auto voxels = inBricks(std::move(volume), levels, progress);
  if (voxels) voxels->layoutTimes_ = times ? *times : timeLayouts(voxels->volume_->view(), *voxels->bricks_);
  return voxels;
}

Result<ScanVoxels> ScanVoxels::of(std::shared_ptr<const Volume> volume, Progress& progress, Bricks when) {
  EW_EXPECTS(volume != nullptr);
  if (isSmall(*volume) || !bricksFit(*volume)) return asStored(std::move(volume));
  const std::optional<LayoutTimes> times = readLayoutTimes(cacheFolder(), volume->echo.size());
  ScanVoxels stored = asStored(volume);
  stored.layoutTimes_ = times;
  if (times && times->choice().none()) return stored;
  if (times && when == Bricks::whenRead) {
    stored.neededBricks_ = std::make_shared<BricksByNeed>();
    return stored;
  }
  auto both = inBothLayouts(volume, kLevels, times, progress);
  if (!both) {
    if (both.error().code == ErrorCode::cancelled) return both;
    return stored;  // memory ran out after all
  }
  if (!times) keepLayoutTimes(cacheFolder(), volume->echo.size(), *both->layoutTimes_);
  stored.layoutTimes_ = both->layoutTimes_;
  if (both->layoutTimes_->choice().none()) return stored;
  if (when == Bricks::now) return both;
  stored.neededBricks_ = std::make_shared<BricksByNeed>();
  return stored;
}

bool ScanVoxels::isSmall(const Volume& volume) { return volume.echo.size() <= kSmall_bytes; }

ScanVoxels ScanVoxels::of(std::shared_ptr<const MappedVolume> mapped) {
  EW_EXPECTS(mapped != nullptr);
  ScanVoxels voxels;
  voxels.mapped_ = std::move(mapped);
  return voxels;
}

const Grid& ScanVoxels::grid() const {
  EW_EXPECTS(!empty());
  return mapped_ ? mapped_->grid() : volume_->grid;
}

SliceSource ScanVoxels::source(const Grid& placed, double pixel_mm) const {
  EW_EXPECTS(!empty() && placed.dims == grid().dims);
  const VolumeView<const std::uint8_t> rows{mapped_ ? mapped_->view().data : volume_->echo.data(), placed};
  if (frames_) {  // zoomed out as well: an image has no coarser levels, and its grain is its own
    SliceSource recorded = rows;
    recorded.frames = frames_.get();
    return recorded;
  }
  if (!bricks_) return rows;
  const SliceSource fitting = bricks_->sourceFor(placed, pixel_mm);
  if (fitting.layout == VoxelLayout::linear) return fitting;  // a coarser level
  return ew::inBothLayouts(rows, *bricks_, layoutTimes_ ? layoutTimes_->choice() : LayoutChoice().set());
}

Result<void> ScanVoxels::unchanged() const { return mapped_ ? mapped_->unchanged() : Result<void>(); }

void ScanSubject::know(std::shared_ptr<const TissueMaps> ofVoxels) {
  EW_EXPECTS(ofVoxels != nullptr && ofVoxels->grid == voxels.grid());
  tissue = std::move(ofVoxels);
  placedTissue = placedGrid;
}

Result<std::shared_ptr<const TissueMaps>> recordedTissueOf(const ScanVoxels& voxels, const Scene& scene, int threads, Progress& progress) {
  if (!voxels.volume())
    return failure(ErrorCode::unsupported,
                   say<"Live echoes need the volume in memory, and this one stays in its file; leave out --map.">());
  return recordedMapsOf(*voxels.volume(), progress,
                        {.recordedDynamicRange_db = limited(scene).recordedDynamicRange_db, .threads = threads});
}

void ScanSubject::place(const Transform<frame::World, frame::World>& ownToWorld) {
  placedGrid = placed(voxels.grid(), ownToWorld);
  if (labels) placedLabels = placed(labels->grid, ownToWorld);
  if (tissue) placedTissue = placed(tissue->grid, ownToWorld);
}

std::optional<ScanState> firstState(const ScanSubject& subject, const std::vector<Probe>& probes, const std::vector<Preset>& presets) {
  const auto probe =
      std::find_if(probes.begin(), probes.end(), [&](const Probe& p) { return subject.probes.empty() || p.id == subject.probes.front(); });
  if (probe == probes.end()) return std::nullopt;
  ScanState state;
  state.probe = *probe;
  if (const Preset* start = startPreset(subject.presets, presets, usableOf(subject.probes, probes))) {
    state.probe = *std::find_if(probes.begin(), probes.end(), [&](const Probe& p) { return p.id == start->probe; });
    state.knobs = applied(*start, state.knobs);
  }
  state.scene = subject.scene;
  if (subject.startPose) {
    state.pose = *subject.startPose;
  } else {
    const Bounds bounds = boundsOf(subject.placedGrid);
    Hold hold;
    hold.contact.point_mm = (bounds.lowest_mm + bounds.highest_mm) / 2.0;
    hold.contact.point_mm.y = bounds.lowest_mm.y;
    hold.contact.outward = {0.0, -1.0, 0.0};
    state.pose = poseOf(hold);
  }
  return state;
}

ScanSubject subjectOf(ScanVoxels voxels, std::string title) {
  ScanSubject subject;
  subject.title = std::move(title);
  subject.placedGrid = voxels.grid();
  subject.voxels = std::move(voxels);
  return subject;
}

std::shared_ptr<const FlowSampler> samplerOf(const CaseEcho& echo) {
  return echo.tissue && echo.flow ? std::make_shared<const FlowSampler>(*echo.flow) : nullptr;
}

Result<CaseContents> readContents(const Case& opened, Progress& progress, const PreparationOptions& options) {
  PartOfProgress reading(progress, 0.0, 0.95), bricking(progress, 0.95, 1.0);
  auto echo = loadCaseVolume(opened, reading, options);
  if (!echo) return passOn(echo.error());
  auto volume = std::make_shared<const Volume>(std::move(echo->volume));
  // Nothing slices voxels where there are the images they were made of, nor those of a drawn patient as long as echoes are formed anew.
  const bool formsEchoes = opened.scene.liveEchoes && echo->tissue && !echo->tissue->isRecorded;
  const auto when = formsEchoes ? ScanVoxels::Bricks::whenRead : ScanVoxels::Bricks::now;
  auto voxels =
      echo->frames ? Result<ScanVoxels>(ScanVoxels::asStored(std::move(volume))) : ScanVoxels::of(std::move(volume), bricking, when);
  if (!voxels) return passOn(voxels.error());
  voxels->readFrom(std::move(echo->frames));
  auto flow = samplerOf(*echo);
  CaseContents contents{.voxels = std::move(*voxels),
                        .labels = {},
                        .tissue = std::move(echo->tissue),
                        .motion = std::move(echo->motion),
                        .flow = std::move(flow),
                        .tissues = std::move(echo->tissues),
                        .fileToWorld = opened.volume.fileToWorld,
                        .notes = std::move(echo->notes),
                        .isDraft = echo->isDraft};
  if (echo->labels) contents.labels = std::make_shared<const Volume>(std::move(*echo->labels));
  return contents;
}

Result<std::shared_ptr<const Volume>> readLabelsFor(const Case& edited, const CaseContents& contents, Progress& progress) {
  if (edited.volume.labels.empty()) return std::shared_ptr<const Volume>();
  auto file = fileOfCase(edited.folder, edited.volume.labels, "volume.labels");
  if (!file) return passOn(file.error());
  auto read = readLabelVolume(*file, progress);
  if (!read) return passOn(read.error());
  read->volume.grid = placed(read->volume.grid, contents.fileToWorld);
  return std::make_shared<const Volume>(std::move(read->volume));
}

Transform<frame::World, frame::World> ownToWorldOf(const Case& edited, const CaseContents& contents) {
  // Where it was read it lies to the last bit: an examination, placed when it was made, shows the same pixels.
  if (edited.volume.fileToWorld == contents.fileToWorld) return {};
  return edited.volume.fileToWorld * inverse(contents.fileToWorld);
}

ScanSubject subjectOf(const Case& edited, const CaseContents& contents) {
  ScanSubject subject = subjectOf(contents.voxels, titleForTrainees(edited));
  subject.labels = contents.labels;
  subject.tissue = contents.tissue;
  subject.motion = contents.motion;
  subject.flow = contents.flow;
  subject.scene = subject.known(sceneWithTissues(edited.scene, contents.tissues));
  subject.probes = edited.probes;
  subject.presets = presetsOf(edited);
  subject.startPose = edited.startPose;
  subject.isDraft = contents.isDraft;
  subject.place(ownToWorldOf(edited, contents));
  return subject;
}

}  // namespace ew
