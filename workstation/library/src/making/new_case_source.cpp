#include "making/new_case_source.h"

#include <algorithm>
#include <utility>

#include "ew/acquisition/recorded_images.h"
#include "ew/core/ending.h"
#include "ew/imaging/tissue_level.h"
#include "ew/io/safe_file.h"
#include "ew/io/volume_file.h"
#include "ew/library/content_name.h"
#include "ew/stitching/chain.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using stitching::StitchProject;

/// A volume in memory and what is known about it, before it is put into a case.
struct VolumeDraft {
  Volume volume;
  fs::path level;  // a file that has it already
  std::optional<SweepAxes> axes;
  std::optional<SweepCounts> frames;
  std::vector<Message> notes;
  std::optional<Sequence> images = {};  // recorded ones that are kept beside the volume
};

constexpr std::uint64_t kMostVoxelsToLookAt = 256ull << 20;
constexpr int kSeenEdge = 96;  // of what is shown to whoever says where the probe was

Message nameInWords(VolumeSide side) {
  switch (side) {
    case VolumeSide::front:
      return say<"front">();
    case VolumeSide::back:
      return say<"back">();
    case VolumeSide::left:
      return say<"left">();
    case VolumeSide::right:
      return say<"right">();
    case VolumeSide::upper:
      return say<"upper side">();
    case VolumeSide::lower:
      return say<"lower side">();
  }
  return say<"front">();
}

Message assumedSide(const ProbeSide& side) {
  if (side.certainty >= 0.5)
    return say<
        "Nobody says from which side the volume was scanned. Its %1 was taken, from which echoes grow fainter or the image wider; "
        "look at it before anybody learns from it.">(nameInWords(volumeSideOf(side.axes)));
  return say<
      "Nobody says from which side the volume was scanned, and its voxels do not tell. Its %1 was taken; look at it before anybody "
      "learns from it.">(nameInWords(volumeSideOf(side.axes)));
}

/// The axes that a person said, where they did.
template <class Source>
std::optional<SweepAxes> saidAxes(const Source& given, const Grid& own) {
  return given.probeSide ? std::optional(axesFrom(own, *given.probeSide)) : std::nullopt;
}

void lookForSide(NewCasePlan& plan, const Volume& volume) {
  plan.asksForSide = true;
  plan.proposedSide = proposedProbeSide(volume);
  plan.seen = thinned(volume, kSeenEdge);
}

SweepImportOptions importOptionsFor(const SweepFile& sweep) {
  SweepImportOptions options;
  if (!sweep.calibration.empty()) options.calibrations = {sweep.calibration};
  // Shadows count less: every echo is weighed by the confidence in it.
  options.usual = {.spacing = !sweep.spacing_mm, .interpolation = true, .compounding = false, .fillReach = true};
  options.reconstruct.compounding = Compounding::weighted;
  if (sweep.spacing_mm) options.reconstruct.spacing_mm = *sweep.spacing_mm;
  options.clipFromCalibration = !sweep.clip;
  if (sweep.clip) options.reconstruct.clip = *sweep.clip;
  options.looksForFan = !sweep.clip && sweep.looksForFan;
  options.acceptsSmall = sweep.acceptsSmall;
  return options;
}

Result<void> checkSpacing(const SweepFile& sweep) {
  if (!sweep.spacing_mm || (*sweep.spacing_mm >= 0.1 && *sweep.spacing_mm <= 10.0)) return {};
  return failure(ErrorCode::badField, say<"The spacing of a voxel must be from 0.1 to 10 mm.">(), {{"field", "spacing"}});
}

Result<VolumeDraft> madeOf(const VolumeFile& given, const fs::path&, Progress& progress) {
  auto imported = importFile(given.file, given.answers, progress);
  if (!imported) return passOn(imported.error());
  if (!imported->volume)
    return failure(ErrorCode::unsupported,
                   say<"'%1' holds images one by one and no volume; a case needs a volume, a recording with poses, or a stitched result.">(
                       given.file.filename()),
                   {{"file", given.file.string()}});
  const auto axes = saidAxes(given, imported->volume->grid);
  return VolumeDraft{*std::move(imported->volume), {}, axes, {}, std::move(imported->notes)};
}

Result<VolumeDraft> madeOf(const VolumeAtHand& given, const fs::path&, Progress&) {
  return VolumeDraft{*given.volume, {}, given.axes ? given.axes : saidAxes(given, given.volume->grid), {}, {}};
}

Result<VolumeDraft> madeOf(const SweepFile& given, const fs::path&, Progress& progress) {
  if (auto usable = checkSpacing(given); !usable) return passOn(usable.error());
  PartOfProgress opening(progress, 0.0, 0.3), pasting(progress, 0.3, 1.0);
  auto opened = openSweep(given.file, importOptionsFor(given), opening);
  if (!opened) return passOn(opened.error());
  VolumeDraft made;
  made.notes = opened->plan.notes;
  made.axes = sweepAxesOf(posedFrames(*opened));
  made.frames = opened->plan.frames;
  if (given.framesEvery > 0) {
    auto images = recordedImages(*opened, given.framesEvery);
    if (!images) return passOn(images.error());
    made.images = *std::move(images);
  }
  auto imported = importSweep(*std::move(opened), pasting);
  if (!imported) return passOn(imported.error());
  made.volume = std::move(imported->reconstruction.volume);
  return made;
}

/// A folder that stitching wrote, by its name or that of the volume in it.
fs::path resultFolderOf(const fs::path& named) {
  std::error_code ignored;
  return fs::is_directory(named, ignored) ? named : named.parent_path();
}

Result<VolumeDraft> readStitched(const fs::path& folder, Progress& progress) {
  auto read = readVolume(folder / "volume.mha", progress);
  if (!read) return passOn(read.error());
  VolumeDraft made{std::move(read->volume), {}, {}, {}, std::move(read->notes)};
  std::error_code ignored;
  if (fs::is_regular_file(folder / "coverage.mha", ignored))
    if (auto covered = readCoverageInto(made.volume, folder / "coverage.mha"); !covered) return passOn(covered.error());
  if (fs::is_regular_file(folder / "level.mha", ignored)) made.level = folder / "level.mha";
  return made;
}

Result<StitchProject> readProject(const fs::path& file) {
  const auto text = readTextFile(file);
  if (!text) return passOn(text.error());
  return stitching::parseProject(*text, fs::absolute(file).parent_path());
}

Result<VolumeDraft> stitchedOf(const StitchingResult& given, const fs::path& scratch, Progress& progress) {
  if (!hasEnding(given.file, ".json")) return readStitched(resultFolderOf(given.file), progress);
  const auto project = readProject(given.file);
  if (!project) return passOn(project.error());
  PartOfProgress stitching(progress, 0.0, 0.95), reading(progress, 0.95, 1.0);
  stitching::ChainOptions options;
  options.keepVolumes = false;
  options.isFolderOwn = true;
  const auto state = runChain(*project, scratch, options, stitching);
  if (!state) return passOn(state.error());
  if (state->volume.empty())
    return failure(ErrorCode::unsupported, say<"The project '%1' was not stitched into one volume: %2">(given.file, state->reason),
                   {{"file", given.file.string()}});
  auto made = readStitched(scratch, reading);
  if (!made) return made;
  made->notes.insert(made->notes.end(), state->notes.begin(), state->notes.end());
  if (state->verdict != registration::Verdict::aligned && !state->reason.empty()) made->notes.push_back(state->reason);
  return made;
}

Result<VolumeDraft> madeOf(const StitchingResult& given, const fs::path& scratch, Progress& progress) {
  auto made = stitchedOf(given, scratch, progress);
  if (made) made->axes = saidAxes(given, made->volume.grid);
  return made;
}

Result<VolumeDraft> madeOf(const std::monostate&, const fs::path&, Progress&) {
  return failure(ErrorCode::badUsage, say<"No volume is named; choose a volume, a recording or a stitched result.">());
}

Result<std::string> addLevel(const VolumeDraft& made, const fs::path& caseFolder, Progress& progress) {
  if (!made.level.empty()) return addVolumeFile(made.level, caseFolder, progress);
  PartOfProgress levelling(progress, 0.0, 0.8), writing(progress, 0.8, 1.0);
  auto level = levelOf(made.volume, {}, levelling);
  if (!level) return passOn(level.error());
  return addVolume(Volume{made.volume.grid, *std::move(level), {}}, caseFolder, writing);
}

NewCasePlan planOfGrid(const Grid& grid, bool makesLevel) {
  NewCasePlan plan;
  plan.grid = grid;
  const std::uint64_t voxels = grid.voxelCount();
  // Echoes and coverage; the level, and what levelling holds beside them.
  plan.bytes = 2 * voxels + (makesLevel ? voxels + levelForecast_bytes(grid, {}) : 0);
  plan.disk_bytes = (makesLevel ? 2 : 1) * voxels + (64u << 10);
  plan.seconds = 0.5 + (makesLevel ? 3.5e-7 : 0.5e-7) * static_cast<double>(voxels);
  return plan;
}

/// Of volumes that can be looked at before without much memory: voxels tell which side to propose.
Result<void> lookAtFile(NewCasePlan& plan, const VolumeFile& given, Progress& progress) {
  plan.asksForSide = !given.probeSide;
  if (!plan.asksForSide || plan.grid.voxelCount() > kMostVoxelsToLookAt) return {};
  const auto made = madeOf(given, {}, progress);
  if (!made) return passOn(made.error());
  lookForSide(plan, made->volume);
  plan.notes = made->notes;
  return {};
}

Result<NewCasePlan> planned(const VolumeFile& given, bool makesLevel, Progress& progress) {
  const auto kind = given.answers.raw ? Result<FileKind>(FileKind::raw) : kindOfFile(given.file);
  if (!kind) return passOn(kind.error());
  if (*kind == FileKind::volume) {
    const auto series = volumeOf(given.file, given.answers);
    if (!series) return passOn(series.error());
    NewCasePlan plan = planOfGrid(*series, makesLevel);
    if (auto seen = lookAtFile(plan, given, progress); !seen) return passOn(seen.error());
    return plan;
  }
  const auto made = madeOf(given, {}, progress);
  if (!made) return passOn(made.error());
  NewCasePlan plan = planOfGrid(made->volume.grid, makesLevel);
  if (!given.probeSide) lookForSide(plan, made->volume);
  plan.notes = made->notes;
  return plan;
}

Result<NewCasePlan> planned(const VolumeAtHand& given, bool makesLevel, Progress&) {
  NewCasePlan plan = planOfGrid(given.volume->grid, makesLevel);
  if (given.axes)
    plan.axes = *given.axes;
  else if (!given.probeSide)
    lookForSide(plan, *given.volume);
  return plan;
}

Result<NewCasePlan> planned(const SweepFile& given, bool makesLevel, Progress& progress) {
  if (auto usable = checkSpacing(given); !usable) return passOn(usable.error());
  const auto opened = openSweep(given.file, importOptionsFor(given), progress);
  if (!opened) return passOn(opened.error());
  if (auto meant = checkMeant(*opened); !meant) return passOn(meant.error());
  NewCasePlan plan = planOfGrid(opened->plan.grid, makesLevel);
  plan.bytes = std::max(plan.bytes, opened->plan.bytes);
  if (const auto axes = sweepAxesOf(posedFrames(*opened))) plan.axes = *axes;
  const Sequence& sequence = opened->sequence;
  plan.seconds += opened->readSeconds + 1.2e-7 * static_cast<double>(opened->plan.frames.used) * sequence.width * sequence.height;
  if (given.framesEvery > 0)
    plan.disk_bytes += (opened->plan.frames.used / static_cast<std::size_t>(given.framesEvery) + 1) *
                       static_cast<std::uint64_t>(sequence.width) * static_cast<std::uint64_t>(sequence.height);
  plan.notes = opened->plan.notes;
  return plan;
}

Result<NewCasePlan> planned(const StitchingResult& given, bool makesLevel, Progress& progress) {
  if (!hasEnding(given.file, ".json")) {
    const fs::path file = resultFolderOf(given.file) / "volume.mha";
    const auto header = readVolumeHeader(file);
    if (!header) return passOn(header.error());
    NewCasePlan plan = planOfGrid(header->grid, makesLevel);
    if (auto seen = lookAtFile(plan, VolumeFile{.file = file, .answers = {}, .probeSide = given.probeSide}, progress); !seen)
      return passOn(seen.error());
    return plan;
  }
  const auto project = readProject(given.file);
  if (!project) return passOn(project.error());
  const auto forecast = stitching::forecastChain(*project, cacheFolder() / "no-such-folder", {});
  if (!forecast) return passOn(forecast.error());
  NewCasePlan plan;
  plan.bytes = forecast->peak_bytes;
  for (const auto& step : forecast->steps) plan.seconds += step.seconds;
  return plan;
}

Result<NewCasePlan> planned(const std::monostate&, bool, Progress&) { return NewCasePlan{}; }

}  // namespace

Result<CaseSource> sourceOf(const fs::path& file) {
  std::error_code ignored;
  if (hasEnding(file, ".json") && fs::is_regular_file(file, ignored)) return CaseSource(StitchingResult{file});
  if (fs::is_directory(file, ignored) && fs::is_regular_file(file / "volume.mha", ignored)) return CaseSource(StitchingResult{file});
  if (file.filename() == "volume.mha" && fs::is_regular_file(file.parent_path() / "provenance.json", ignored))
    return CaseSource(StitchingResult{file});
  const auto kind = kindOfFile(file);
  if (!kind) return passOn(kind.error());
  if (*kind == FileKind::sweep) return CaseSource(SweepFile{.file = file});
  if (*kind == FileKind::film || *kind == FileKind::dicomImages)
    return failure(ErrorCode::unsupported,
                   say<"'%1' holds images one by one and no volume; a case needs a volume, a recording with poses, or a stitched result.">(
                       file.filename()),
                   {{"file", file.string()}});
  return CaseSource(VolumeFile{.file = file});
}

Result<SourceInCase> putSource(const CaseSource& source, bool makesLevel, const fs::path& caseFolder, const fs::path& scratch,
                               Progress& progress) {
  PartOfProgress making(progress, 0.0, 0.6), writing(progress, 0.6, 0.75), levelling(progress, 0.75, 1.0);
  auto made = std::visit([&](const auto& given) { return madeOf(given, scratch, making); }, source);
  if (!made) return passOn(made.error());
  const auto file = addVolume(made->volume, caseFolder, writing);
  if (!file) return passOn(file.error());
  const auto level = makesLevel ? addLevel(*made, caseFolder, levelling) : Result<std::string>(std::string());
  if (!level) return passOn(level.error());
  std::string images;
  if (made->images) {
    auto added = addSequence(*made->images, caseFolder, noProgress());
    if (!added) return passOn(added.error());
    images = std::move(*added);
  }
  SourceInCase put{*file, *level, std::move(images), made->axes, false, {}, made->frames, std::move(made->notes)};
  if (!put.axes) {
    const ProbeSide side = proposedProbeSide(made->volume);
    put.axes = side.axes;
    put.assumesAxes = true;
    put.notes.push_back(assumedSide(side));
  }
  put.shape = placingShapeOf(made->volume, *put.axes);
  return put;
}

Result<NewCasePlan> planSource(const CaseSource& source, bool makesLevel, Progress& progress) {
  return std::visit([&](const auto& given) { return planned(given, makesLevel, progress); }, source);
}

DefaultPlacement choosePlace(const PlacingShape& shape, const std::string& mannequin, const fs::path& caseFolder, const std::string& region,
                             const std::optional<Transform<frame::World, frame::File>>& given) {
  DefaultPlacement place;
  const auto skin = skinOfMannequin(mannequin, caseFolder);
  if (given) {
    place.fileToWorld = *given;
  } else {
    const auto known = landmarksOf(mannequin);
    const PlacingSite* site = known ? siteFor(*known, region) : nullptr;
    if (!skin || site == nullptr) {
      place.notes.push_back(say<"The volume lies where its file says; place it on the body by hand.">());
      return place;
    }
    if (!region.empty() && !knowsRegion(*known, region))
      place.notes.push_back(
          say<"There is no usual place for '%1' on this mannequin; the volume lies on the %2. Place it by hand.">(region, site->region));
    place.fileToWorld = firstPlacement(shape, **skin, *site);
  }
  if (skin) place.contact = contactOf(shape, place.fileToWorld, **skin);
  return place;
}

}  // namespace ew
