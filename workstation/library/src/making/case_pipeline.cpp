#include "making/case_pipeline.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "case/kept_maps.h"
#include "case/kept_motion.h"
#include "ew/acquisition/import.h"
#include "ew/acquisition/sweep_volume.h"
#include "ew/core/quiet_progress.h"
#include "ew/imaging/tissue_level.h"
#include "ew/io/content_key.h"
#include "ew/io/volume_file.h"
#include "ew/library/case_truth.h"
#include "ew/phantom/label_grid.h"
#include "ew/phantom/motion.h"
#include "ew/phantom/patient.h"
#include "ew/stitching/chain.h"
#include "files/machine_speed.h"
#include "files/private_folder.h"
#include "making/case_truth_file.h"
#include "making/draft_maps.h"
#include "making/old_results.h"
#include "making/piece_journal.h"
#include "making/preparation_clock.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using PatientPtr = std::shared_ptr<const Patient>;

tl::unexpected<Error> stopped() { return failure(ErrorCode::cancelled, say<"Preparing the case was stopped.">()); }

/// Keeps the promise that fractions never move backwards where work turns out to have to be done again.
class MonotonicProgress final : public Progress {
 public:
  explicit MonotonicProgress(Progress& whole) : whole_(whole) {}
  void report(const Message& what, double fraction) override {
    furthest_ = std::max(furthest_, fraction);
    whole_.report(what, furthest_);
  }
  [[nodiscard]] bool cancelRequested() const override { return whole_.cancelRequested(); }

 private:
  Progress& whole_;
  double furthest_ = 0.0;
};

constexpr const char* kJoins = "joins";  ///< of the cache: a folder for each chain that is at work
Message notKept(const Error& error) {
  return say<"The prepared volume could not be kept for the next start; set ECHOWEAVE_CACHE to a folder you may write to. %1">(
      error.message);
}
Message waiting() { return say<"Waiting for another EchoWeave that prepares the same case">(); }

/// One case's way from recipe to volume.
class Preparation {
 public:
  enum class Home { cache, passing };  ///< passing: gone with all that is in it once the case is prepared
  /// @param store shared, of `home`: the cache, or a folder of its own when that cannot be written
  Preparation(const Case& opened, const CasePlan& plan, Home kind, fs::path home, const StepStore& store, const PreparationOptions& options,
              Progress& progress, std::vector<Message>& notes)
      : case_(opened),
        plan_(plan),
        isPassing_(kind == Home::passing),
        home_(std::move(home)),
        store_(store),
        options_(options),
        notes_(notes),
        clock_(progress, stepsOf(opened, plan, store)),
        silent_(progress) {}

  Result<Prepared> run() { return plan_.sweeps.empty() ? voxelised() : joined(); }

  /// Whether what could not be written is the folder somebody named for the recordings.
  [[nodiscard]] bool isNamedFolderInTheWay() const { return isNamedFolderInTheWay_; }

  [[nodiscard]] static std::vector<PreparationClock::Step> stepsOf(const Case& opened, const CasePlan& plan, const StepStore& store) {
    const MachineSpeed speed = readMachineSpeed(cacheFolder());
    std::vector<PreparationClock::Step> steps;
    const auto add = [&](PreparationStep kind, double work) { steps.push_back({static_cast<int>(kind), speed.of(kind) * work}); };
    if (plan.sweeps.empty()) {
      add(PreparationStep::patient, 1.0);
      add(PreparationStep::voxelise, voxeliseWork(plan, opened.volume.recipeSpacing_mm));
      return steps;
    }
    bool hasPatient = false;
    for (const CaseSweep& sweep : plan.sweeps) {
      if (store.find(kVolumes, plan.volume) || store.find(kSweeps, sweep.volume)) continue;
      if (!store.find(kRecordings, sweep.recording)) {
        if (!hasPatient) add(PreparationStep::patient, 1.0);
        hasPatient = true;
        add(PreparationStep::record, sweep.work);
      }
      add(PreparationStep::reconstruct, sweep.work);
    }
    add(PreparationStep::stitch, stitchWork(plan, opened.volume.reconstruct));
    return steps;
  }

 private:
  void begin(PreparationStep kind, Message what) { clock_.begin(static_cast<int>(kind), std::move(what)); }

  Result<Prepared> joined() {
    Prepared made;
    auto kept = readKeptVolume(store_, kVolumes, plan_.volume, silent_);  // there when it was killed before it labelled
    if (!kept && kept.error().code == ErrorCode::cancelled) return passOn(kept.error());
    if (kept) {
      begin(PreparationStep::stitch, say<"Labelling the tissues">());
    } else {
      for (const CaseSweep& sweep : plan_.sweeps)
        if (auto swept = makeSweep(sweep); !swept) return passOn(swept.error());
      begin(PreparationStep::stitch, say<"Stitching">());
      kept = stitchedVolume();
      if (!kept) return passOn(kept.error());
    }
    made.volume = std::move(*kept);
    auto labels = labelsOf(made.volume.grid);
    if (!labels) return passOn(labels.error());
    made.labels = std::move(*labels);
    auto maps = recordedLevel(made.volume);
    if (!maps) return passOn(maps.error());
    made.maps = std::move(*maps);
    restWhereKept(store_, kVolumes, plan_.volume, made);
    restWhereKept(store_, kLabels, plan_.labels, made);
    restWhereKept(store_, kMaps, plan_.maps, *made.maps);
    keepMachineSpeed(cacheFolder(), PreparationStep::stitch, stitchWork(plan_, case_.volume.reconstruct), clock_.sinceBegin_s());
    return made;
  }

  Result<Prepared> voxelised() {
    auto patient = patientOf();
    if (!patient) return passOn(patient.error());
    if (auto moves = makeMotion(); !moves) return passOn(moves.error());
    // What was there before motion was kept beside it is not made anew.
    if (auto there = readPrepared(plan_, store_, silent_)) return there;
    begin(PreparationStep::voxelise, say<"Building the virtual patient">());
    PartOfProgress most(clock_, 0.0, 0.9);
    double painted = 1.0;
    const fs::path folder = home_ / kJoins / plan_.volume;  // of what is painted so far; gone when the volume is kept
    auto voxels = [&] {
      std::optional<PieceJournal> pieces;
      if (!isPassing_)  // nobody would go on with them
        pieces.emplace(folder / "pieces", [&](double share) {
          painted = 1.0 - share;
          clock_.goOn(share);
        });
      return voxelise(**patient,
                      {.spacing_mm = case_.volume.recipeSpacing_mm,
                       .threads = options_.threads,
                       .maxBytes = options_.maxBytes,
                       .maps = true,
                       .pieces = pieces ? &*pieces : nullptr},
                      most);
    }();
    if (!voxels) return passOn(voxels.error());
    // What an earlier run has left took no time; a small rest says nothing of the machine's speed.
    if (painted > 0.5)
      keepMachineSpeed(cacheFolder(), PreparationStep::voxelise, painted * voxeliseWork(plan_, case_.volume.recipeSpacing_mm),
                       clock_.sinceBegin_s());
    Prepared made{std::move(voxels->volume), {}};
    made.labels = {made.volume.grid, std::move(voxels->labels), {}};
    if (voxels->maps) made.maps = std::make_shared<TissueMaps>(std::move(*voxels->maps));
    if (!plan_.motion.empty()) made.motion = std::move(motion_);
    if (isPassing_) return made;
    PartOfProgress rest(clock_, 0.9, 1.0);
    auto kept = keepVoxels(made, rest);
    if (!kept && kept.error().code != ErrorCode::notWritable) return passOn(kept.error());
    // All of it is in memory: where there is no room for it twice, the pieces make room for the whole.
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    if (!kept) kept = keepVoxels(made, rest);
    if (!kept && kept.error().code != ErrorCode::notWritable) return passOn(kept.error());
    if (kept) {
      restWhereKept(store_, kVolumes, plan_.volume, made);
      if (made.maps) restWhereKept(store_, kMaps, plan_.maps, *made.maps);
    } else {
      removeParts();
      notes_.push_back(notKept(kept.error()));
    }
    keepTruth();
    return made;
  }

  Result<void> keepVoxels(const Prepared& made, Progress& progress) {
    if (!plan_.motion.empty() && !isMotionKept_)
      if (auto kept = keepMotion(store_, kMotions, plan_.motion, made.motion.get()); !kept) return kept;
    if (made.maps)
      if (auto kept = keepMaps(store_, kMaps, plan_.maps, *made.maps); !kept) return kept;
    return keepPrepared(store_, kVolumes, plan_.volume, made, progress);
  }

  /// Of voxels that could not be kept as a whole: nobody reads them, and the medium is probably full.
  void removeParts() {
    store_.remove(kMaps, plan_.maps);
    if (!store_.find(kVolumes, plan_.volume)) store_.remove(kVolumes, plan_.volume);
  }

  Result<PatientPtr> patientOf() {
    if (patient_) return patient_;
    begin(PreparationStep::patient, say<"Reading the patient">());
    auto read = readPatient(plan_.patientFile, plan_.mannequins, {}, clock_);
    if (!read) return passOn(read.error());
    patient_ = std::move(*read);
    keepMachineSpeed(cacheFolder(), PreparationStep::patient, 1.0, clock_.sinceBegin_s());
    if (clock_.cancelRequested()) return stopped();
    return patient_;
  }

  /// Keeps it as well, if there is room now.
  Result<void> makeMotion() {
    if (plan_.motion.empty()) return {};
    auto motion = tissueMotionOf(*patient_, options_.threads, silent_);
    if (!motion) return passOn(motion.error());
    motion_ = std::move(*motion);
    isMotionKept_ = !isPassing_ && keepMotion(store_, kMotions, plan_.motion, motion_.get());
    return {};
  }

  void keepTruth() {
    if (!patient_) return;
    if (const auto truth = truthOfPatient(*patient_, silent_)) static_cast<void>(store_.keep(kTruths, plan_.truth, *truth));
  }

  /// A recording on disk, as a laboratory has it: the tracked images and the device set with calibration and sector.
  Result<void> record(const CaseSweep& sweep) {
    if (isWhole(store_, kRecordings, sweep.recording, {kImagesFile, kDeviceSetFile})) return {};
    auto patient = patientOf();
    if (!patient) return passOn(patient.error());
    begin(PreparationStep::record, say<"Recording the sweep '%1'">(sweep.name));
    PartOfProgress most(clock_, 0.0, 0.9), rest(clock_, 0.9, 1.0);
    const auto swept = recordSweep(*patient, sweep.probe, sweep.recipe, options_.threads, most, options_.maxBytes);
    if (!swept) return passOn(swept.error());
    if (auto room = store_.prepare(kRecordings); !room) return room;
    if (auto written = writeDeviceSet(swept->deviceSet, fileOf(sweep, kDeviceSetFile)); !written) return written;
    if (auto written = writeSequence(swept->sequence, fileOf(sweep, kImagesFile), rest); !written) return written;
    if (auto kept = store_.keep(kRecordings, sweep.recording, {}, {kDeviceSetFile, kImagesFile}); !kept) return kept;
    keepMachineSpeed(cacheFolder(), PreparationStep::record, sweep.work, clock_.sinceBegin_s());
    return {};
  }

  /// Of the recording of a sweep.
  [[nodiscard]] fs::path fileOf(const CaseSweep& sweep, const char* name) const {
    return store_.fileOf(kRecordings, sweep.recording, name);
  }

  /// The way a user's recording goes into a volume for stitching, with the options of the case.
  Result<void> reconstruct(const CaseSweep& sweep) {
    begin(PreparationStep::reconstruct, say<"Reconstructing the sweep '%1'">(sweep.name));
    const CaseReconstruction& asked = case_.volume.reconstruct;
    SweepImportOptions import;
    import.calibrations = {fileOf(sweep, kDeviceSetFile)};
    import.usual = {.spacing = !asked.spacing_mm,
                    .interpolation = !asked.interpolation,
                    .compounding = !asked.compounding,
                    .fillReach = !asked.fillReach_mm};
    import.reconstruct.spacing_mm = asked.spacing_mm.value_or(import.reconstruct.spacing_mm);
    import.reconstruct.interpolation = asked.interpolation.value_or(import.reconstruct.interpolation);
    import.reconstruct.compounding = asked.compounding.value_or(import.reconstruct.compounding);
    import.reconstruct.fillReach_mm = asked.fillReach_mm.value_or(import.reconstruct.fillReach_mm);
    import.reconstruct.threads = options_.threads;
    import.reconstruct.maxBytes = options_.maxBytes;
    import.acceptsSmall = true;  // recorded here a moment ago: there is nothing to misunderstand, and nobody to ask
    PartOfProgress reading(clock_, 0.0, 0.2), making(clock_, 0.2, 1.0);
    const auto opened = openSweep(fileOf(sweep, kImagesFile), import, reading);
    if (!opened) return passOn(opened.error());
    const auto made = makeSweepVolume(*opened, making);
    if (!made) return passOn(made.error());
    if (auto room = store_.prepare(kSweeps); !room) return room;
    const auto file = [&](const char* name) { return store_.fileOf(kSweeps, sweep.volume, name); };
    if (auto w = writeVolume(made->volume, file(kVolumeFile), silent_, kPlain); !w) return w;
    if (auto w = writeCoverage(made->volume, file(kCoverageFile), silent_, kPlain); !w) return w;
    if (auto w = writeConfidence(made->volume.grid, made->confidence, file(kConfidenceFile), silent_, kPlain); !w) return w;
    return store_.keep(kSweeps, sweep.volume, {}, {kVolumeFile, kCoverageFile, kConfidenceFile});
  }

  /// Leaves the volume of a sweep in the store.
  Result<void> makeSweep(const CaseSweep& sweep) {
    // Cases may share a patient and a sweep: whoever comes second finds what the first one kept, and never a recording that goes while he
    // reads it.
    const auto recording = store_.lock(kRecordings, sweep.recording, waiting(), silent_);
    if (!recording) return passOn(recording.error());
    const auto volume = store_.lock(kSweeps, sweep.volume, waiting(), silent_);
    if (!volume) return passOn(volume.error());
    if (store_.find(kSweeps, sweep.volume)) {
      if (isWhole(store_, kSweeps, sweep.volume, {kVolumeFile, kCoverageFile, kConfidenceFile})) return {};
      notes_.push_back(say<"A part of the case in the cache could not be used and was made again. %1">(
          damagedInCache(store_, kSweeps, sweep.volume).value().message));
    }
    if (auto recorded = record(sweep); !recorded) return recorded;
    if (auto made = reconstruct(sweep); !made) return made;
    if (auto moved = putAway(sweep); !moved) return moved;
    keepMachineSpeed(cacheFolder(), PreparationStep::reconstruct, sweep.work, clock_.sinceBegin_s());
    return {};
  }

  /// A recording has done its service once its volume is kept; whoever wants to look at it names a folder.
  Result<void> putAway(const CaseSweep& sweep) {
    if (!options_.keepSweeps.empty()) {
      std::error_code error;
      fs::create_directories(options_.keepSweeps, error);
      for (const auto& [name, ending] : {std::pair{kImagesFile, ".igs.mha"}, std::pair{kDeviceSetFile, ".xml"}}) {
        const fs::path target = options_.keepSweeps / (sweep.name + ending);
        error.clear();
        fs::copy_file(fileOf(sweep, name), target, error);  // never over a file that is there
        if (!error) continue;
        isNamedFolderInTheWay_ = true;
        return failure(ErrorCode::notWritable,
                       say<"The recording cannot be written to '%1' (%2); choose another folder.">(target, verbatim(error.message())),
                       {{"file", target.string()}});
      }
    }
    store_.remove(kRecordings, sweep.recording);
    return {};
  }

  /// What is asked of the chain of stitching. The poses of a virtual patient's sweeps are the truth, and labels and targets are placed by
  /// them: nothing is registered.
  [[nodiscard]] stitching::StitchProject project() const {
    const CaseReconstruction& asked = case_.volume.reconstruct;
    stitching::StitchProject project;
    for (const CaseSweep& sweep : plan_.sweeps) {
      stitching::ProjectVolume volume;
      volume.file = store_.fileOf(kSweeps, sweep.volume, kVolumeFile);
      volume.coverage = store_.fileOf(kSweeps, sweep.volume, kCoverageFile);
      volume.confidence = store_.fileOf(kSweeps, sweep.volume, kConfidenceFile);
      volume.name = sweep.name;
      project.volumes.push_back(std::move(volume));
    }
    project.settings.trackerError_mm = project.settings.trackerError_deg = 0.0;
    project.settings.elastic = false;
    project.settings.join.grid.spacing_mm = asked.spacing_mm.value_or(0.0);  // the finest of the sweeps
    project.settings.join.grid.axes = stitching::GridAxes::world;
    project.settings.join.grid.featherWidth_mm = asked.feather_mm;
    project.settings.join.seam.method = asked.seam;
    return project;
  }

  Result<Volume> stitchedVolume() {
    const fs::path folder = home_ / kJoins / plan_.volume;  // of the chain's own steps; gone when the volume is kept
    stitching::ChainOptions how;
    how.threads = options_.threads;
    how.maxBytes = options_.maxBytes;
    how.keepVolumes = false;
    how.isFolderOwn = true;
    how.streamAbove_voxels = 0;  // uncompressed
    PartOfProgress most(clock_, 0.0, 0.6), saving(clock_, 0.6, 0.65);
    const auto state = stitching::runChain(project(), folder, how, most);
    if (!state) return passOn(state.error());
    auto loaded = readVolume(state->volume, silent_);
    if (!loaded) return passOn(loaded.error());
    Prepared made{std::move(loaded->volume), {}};
    if (auto read = readCoverageInto(made.volume, state->coverage, silent_); !read) return passOn(read.error());
    auto level = readLabelVolume(state->level, silent_);
    if (!level) return passOn(level.error());
    if (auto kept = keepPrepared(store_, kVolumes, plan_.volume, made, saving); !kept) return passOn(kept.error());
    if (auto kept = keepMaps(store_, kMaps, plan_.maps, recordedMaps(made.volume.grid, std::move(level->volume.echo))); !kept)
      return passOn(kept.error());
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    return std::move(made.volume);
  }

  /// What live echoes of the joined volume are formed from: kept by the chain's end, or made of a volume that was joined before.
  Result<std::shared_ptr<TissueMaps>> recordedLevel(const Volume& volume) {
    if (auto kept = readKeptMaps(store_, kMaps, plan_.maps, volume.grid)) return kept;
    PartOfProgress levelling(clock_, 0.9, 1.0);
    auto level = levelOf(volume, {.threads = options_.threads, .maxBytes = options_.maxBytes}, levelling);
    if (!level) return passOn(level.error());
    auto maps = std::make_shared<TissueMaps>(recordedMaps(volume.grid, std::move(*level)));
    if (auto kept = keepMaps(store_, kMaps, plan_.maps, *maps); !kept) return passOn(kept.error());
    return maps;
  }

  Result<Volume> labelsOf(const Grid& grid) {
    if (store_.find(kLabels, plan_.labels)) {
      auto kept = readKeptLabels(store_, kLabels, plan_.labels, silent_);
      if (kept || kept.error().code == ErrorCode::cancelled) return kept;
    }
    if (!patient_) {
      auto read = readPatient(plan_.patientFile, plan_.mannequins, {}, silent_);
      if (!read) return passOn(read.error());
      patient_ = std::move(*read);
    }
    Grid coarse = grid;
    coarse.spacing_mm = glm::dvec3(case_.volume.reconstruct.labelsSpacing_mm);
    for (int axis = 0; axis < 3; ++axis)
      coarse.dims[axis] = static_cast<int>(std::ceil((grid.dims[axis] - 1) * grid.spacing_mm[axis] / coarse.spacing_mm[axis])) + 1;
    PartOfProgress labelling(clock_, 0.65, 0.87), saving(clock_, 0.87, 0.9);
    auto labels = labelsOn(*patient_, coarse, options_.threads, labelling, options_.maxBytes);
    if (!labels) return passOn(labels.error());
    Prepared made{{}, {coarse, std::move(*labels), {}}};
    const auto lock = store_.lock(kLabels, plan_.labels, waiting(), silent_);
    if (!lock) return passOn(lock.error());
    if (auto kept = keepPrepared(store_, kLabels, plan_.labels, made, saving); !kept) return passOn(kept.error());
    keepTruth();
    return std::move(made.labels);
  }

  const Case& case_;
  const CasePlan& plan_;
  const bool isPassing_;
  const fs::path home_;
  const StepStore& store_;
  const PreparationOptions& options_;
  std::vector<Message>& notes_;
  PreparationClock clock_;
  QuietProgress silent_;
  PatientPtr patient_;
  std::shared_ptr<TissueMotion> motion_;
  bool isMotionKept_ = false;
  bool isNamedFolderInTheWay_ = false;
};

/// Folders of chains that were stopped and never gone on with.
void removeOldJoins(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> old;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error))
    if (isContentKey(entry->path().filename().string()) && fs::file_time_type::clock::now() - entry->last_write_time(error) > kOldResult)
      old.push_back(entry->path());
  for (const fs::path& each : old) fs::remove_all(each, error);
}

/// What nobody will come back for, of this version and of those that kept results in other places.
void removeOld(const StepStore& cache) {
  cache.removeUnused(kOldResult);
  removeOldJoins(cacheFolder() / kJoins);
  for (const char* each : {"recipes", "steps"}) removeOldResults(cacheFolder() / each);
}

}  // namespace

PreparationEstimate estimateOf(const Case& opened, const CasePlan& plan) {
  const StepStore store = StepStore::peek(cacheFolder(), preparationSteps());
  if (plan.isDoneIn(store)) return {0.0, true};
  PreparationEstimate estimate;
  const PreparationStep longest = plan.sweeps.empty() ? PreparationStep::voxelise : PreparationStep::record;
  estimate.measured = readMachineSpeed(cacheFolder()).isMeasured[static_cast<std::size_t>(longest)];
  for (const auto& step : Preparation::stepsOf(opened, plan, store)) estimate.seconds += step.expected_s;
  return estimate;
}

Result<Prepared> makePrepared(const Case& opened, const CasePlan& plan, const PreparationOptions& options, Progress& whole,
                              std::vector<Message>& notes) {
  MonotonicProgress progress(whole);
  const auto cache = StepStore::share(cacheFolder(), preparationSteps());
  const auto readOrNote = [&](const StepStore& store) -> Result<Prepared> {
    auto cached = readPrepared(plan, store, progress);
    if (!cached && cached.error().code != ErrorCode::cancelled)
      notes.push_back(say<"The prepared volume in the cache could not be used and was made again. %1">(cached.error().message));
    return cached;
  };
  const bool wasThere = plan.isDone();
  if (wasThere) {
    auto cached = cache ? readOrNote(*cache) : readOrNote(StepStore::peek(cacheFolder(), preparationSteps()));
    if (cached || cached.error().code == ErrorCode::cancelled) return cached;
  }
  bool isNamedFolderInTheWay = false;
  Result<Prepared> made = [&]() -> Result<Prepared> {
    if (!cache) return passOn(cache.error());
    const auto lock = cache->lock(kVolumes, plan.volume, waiting(), progress);
    if (!lock) return passOn(lock.error());
    if (!wasThere && plan.isDoneIn(*cache)) {
      auto cached = readOrNote(*cache);
      if (cached || cached.error().code == ErrorCode::cancelled) return cached;
    } else if (!wasThere && plan.isDamagedIn(*cache)) {
      notes.push_back(say<"The prepared volume in the cache was damaged and was made again.">());
    }
    if (progress.cancelRequested()) return stopped();
    removeOld(*cache);
    Preparation preparation(opened, plan, Preparation::Home::cache, cacheFolder(), *cache, options, progress, notes);
    auto prepared = preparation.run();
    isNamedFolderInTheWay = preparation.isNamedFolderInTheWay();
    return prepared;
  }();
  if (made || made.error().code != ErrorCode::notWritable || isNamedFolderInTheWay) return made;
  // Without a cache the case still opens; it is only made anew next time, and the user is told why, once. The way leads through files all
  // the same, in a folder that nobody else can write to.
  notes.push_back(notKept(made.error()));
  const auto aside = PrivateFolder::make();
  if (!aside) return made;
  const auto store = StepStore::share(aside->path(), preparationSteps());
  if (!store) return passOn(store.error());
  return Preparation(opened, plan, Preparation::Home::passing, aside->path(), *store, options, progress, notes).run();
}

bool isWorthDrafting(const Case& opened, const CasePlan& plan) {
  constexpr double kWorthIt_s = 2.0;
  return plan.sweeps.empty() && !plan.isDone() && estimateOf(opened, plan).seconds > kWorthIt_s;
}

Result<Prepared> makeDraft(const Case& opened, const CasePlan& plan, const PreparationOptions& options, Progress& progress) {
  PartOfProgress reading(progress, 0.0, 0.2), moving(progress, 0.2, 0.4), painting(progress, 0.4, 0.9), spreading(progress, 0.9, 1.0);
  const auto patient = readPatient(plan.patientFile, plan.mannequins, {}, reading);
  if (!patient) return passOn(patient.error());
  Prepared made;
  if (!plan.motion.empty()) {
    auto motion = tissueMotionOf(**patient, options.threads, moving);
    if (!motion) return passOn(motion.error());
    made.motion = std::move(*motion);
  }
  auto voxels = voxelise(**patient,
                         {.spacing_mm = kDraftCoarseness * opened.volume.recipeSpacing_mm,
                          .threads = options.threads,
                          .maxBytes = options.maxBytes,
                          .maps = true},
                         painting);
  if (!voxels) return passOn(voxels.error());
  made.volume = std::move(voxels->volume);
  made.labels = {made.volume.grid, std::move(voxels->labels), {}};
  if (!voxels->maps) return made;
  auto maps = spreadOn(*voxels->maps, voxelGridOf(**patient, opened.volume.recipeSpacing_mm), options.threads, spreading);
  if (!maps) return stopped();
  made.maps = std::make_shared<TissueMaps>(std::move(*maps));
  return made;
}

Result<Volume> makeLabels(const Case& opened, const CasePlan& plan, const PreparationOptions& options, Progress& progress) {
  const auto cache = StepStore::share(cacheFolder(), preparationSteps());
  const StepStore store = StepStore::peek(cacheFolder(), preparationSteps());
  const auto kept = [&](const char* step, const std::string& key) -> std::optional<Result<Volume>> {
    if (!isWhole(store, step, key, {kLabelsFile})) return std::nullopt;
    return readKeptLabels(store, step, key, progress);
  };
  if (auto read = kept(kLabels, plan.labels)) return std::move(*read);
  if (plan.sweeps.empty())
    if (auto read = kept(kVolumes, plan.volume)) return std::move(*read);
  if (!plan.sweeps.empty()) {
    std::vector<Message> notes;
    auto made = makePrepared(opened, plan, options, progress, notes);
    if (!made) return passOn(made.error());
    return std::move(made->labels);
  }
  PartOfProgress reading(progress, 0.0, 0.2), labelling(progress, 0.2, 0.95), saving(progress, 0.95, 1.0);
  const auto patient = readPatient(plan.patientFile, plan.mannequins, {}, reading);
  if (!patient) return passOn(patient.error());
  const Grid grid = voxelGridOf(**patient, opened.volume.recipeSpacing_mm);
  auto labels = labelsOn(**patient, grid, options.threads, labelling, options.maxBytes);
  if (!labels) return passOn(labels.error());
  Prepared made{{}, {grid, std::move(*labels), {}}};
  if (cache) {  // what cannot be kept is made again next time
    const auto lock = cache->lock(kLabels, plan.labels, waiting(), saving);
    if (lock) static_cast<void>(keepPrepared(*cache, kLabels, plan.labels, made, saving));
  }
  return std::move(made.labels);
}

}  // namespace ew
