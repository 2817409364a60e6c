#include "case_pipeline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <set>

#include "case_truth_file.h"
#include "ew/acquisition/import.h"
#include "ew/core/numbers.h"
#include "ew/core/quiet_progress.h"
#include "ew/io/safe_file.h"
#include "ew/library/case_truth.h"
#include "ew/phantom/label_grid.h"
#include "ew/phantom/patient.h"
#include "ew/stitching/stitch.h"
#include "guarded_case.h"
#include "machine_speed.h"
#include "old_results.h"
#include "preparation_clock.h"
#include "private_folder.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using PatientPtr = std::shared_ptr<const Patient>;

/// Part of every name in the cache: raise it when the same case starts to give another volume, by whatever step.
constexpr std::uint64_t kPreparationFormat = 3;
constexpr std::size_t kLargestSweepFile_bytes = 1u << 20;

tl::unexpected<Error> stopped() { return failure(ErrorCode::cancelled, "Preparing the case was stopped."); }

/// What the time of a recording goes by: resolution cells of its frames, in millions. Lines times wavelengths of depth; a small frame of
/// a high frequency takes as long as a large one of a low, so its area would say nothing.
double recordingWork(const Probe& probe, const SweepRecipe& recipe) {
  const double depth_mm = recipe.formation.depth_mm > 0.0 ? recipe.formation.depth_mm : probe.defaultDepth_mm;
  const double carrier_hz = recipe.formation.carrier_hz > 0.0 ? recipe.formation.carrier_hz : probe.carrier_hz;
  return 1e-6 * recipe.frames * probe.lines * depth_mm * carrier_hz / 1.54e6;
}

/// Area of a frame, mm2.
double frameArea_mm2(const Probe& probe, double depth_mm) {
  const double depth = depth_mm > 0.0 ? depth_mm : probe.defaultDepth_mm;
  const double face = faceLength_mm(probe);
  if (!isSector(probe.kind)) return face * depth;
  const double near = probe.radius_mm, far = probe.radius_mm + depth;
  return probe.halfAngle_rad * (far * far - near * near);
}

void addOptions(ContentHash& hash, const CaseReconstruction& reconstruct) {
  hash.add(reconstruct.spacing_mm)
      .add(static_cast<std::uint64_t>(reconstruct.interpolation))
      .add(static_cast<std::uint64_t>(reconstruct.compounding))
      .add(reconstruct.fillReach_mm);
}

Result<PlannedSweep> sweepOf(const Case& opened, const std::string& relative, const fs::path& resources, std::uint64_t patient,
                             const fs::path& steps) {
  auto file = fileOfCase(opened.folder, relative, "volume.sweeps");
  if (!file) return passOn(file.error());
  auto text = readTextFile(*file, kLargestSweepFile_bytes);
  if (!text) return passOn(text.error());
  auto recipe = readSweepRecipe(*file);
  if (!recipe) return passOn(recipe.error());
  const fs::path probeFile = resources / "probes" / (recipe->probe + ".json");
  auto probeText = readTextFile(probeFile, kLargestSweepFile_bytes);
  if (!probeText)
    return failure(ErrorCode::badField,
                   "The sweep '" + relative + "' asks for the probe '" + recipe->probe +
                       "', which the program does not have; name one of resources/probes.",
                   {{"field", "probe"}, {"found", recipe->probe}, {"file", relative}});
  auto probe = readProbe(probeFile);
  if (!probe) return passOn(probe.error());

  PlannedSweep planned;
  planned.name = fs::path(relative).stem().string();
  planned.recipe = std::move(*recipe);
  planned.probe = std::move(*probe);
  planned.key = ContentHash().add(kPreparationFormat).add(patient).add(*text).add(*probeText).text();
  planned.recording = steps / (planned.key + ".igs.mha");
  planned.calibration = steps / (planned.key + ".xml");
  planned.lock = steps / (planned.key + ".lock");
  ContentHash volume;
  volume.add(planned.key);
  addOptions(volume, opened.volume.reconstruct);
  planned.store = PreparedStore(steps, volume.text());
  planned.work = recordingWork(planned.probe, planned.recipe);
  return planned;
}

/// The stages after the sweeps count voxels; before there is a volume, what the sweeps see says how many there will be.
double stitchWork(const CasePlan& plan, double spacing_mm) {
  double volume_mm3 = 0.0;
  for (const PlannedSweep& sweep : plan.sweeps)
    volume_mm3 += frameArea_mm2(sweep.probe, sweep.recipe.formation.depth_mm) * sweep.recipe.frames;  // frames about 1 mm apart
  return 1e-6 * volume_mm3 / std::pow(spacing_mm, 3);
}

double voxeliseWork(double spacing_mm) { return 6.0 / std::pow(spacing_mm, 3); }  // a trunk of about six litres, in million voxels

/// Keeps the promise that fractions never move backwards where work turns out to have to be done again.
class Onward final : public Progress {
 public:
  explicit Onward(Progress& whole) : whole_(whole) {}
  void report(std::string_view what, double fraction) override {
    furthest_ = std::max(furthest_, fraction);
    whole_.report(what, furthest_);
  }
  [[nodiscard]] bool cancelRequested() const override { return whole_.cancelRequested(); }

 private:
  Progress& whole_;
  double furthest_ = 0.0;
};

/// One case's way from recipe to volume.
class Preparation {
 public:
  Preparation(const Case& opened, const CasePlan& plan, const PreparationOptions& options, Progress& progress,
              std::vector<std::string>& notes)
      : case_(opened), plan_(plan), options_(options), notes_(notes), clock_(progress, stepsOf(opened, plan)), silent_(progress) {}

  Result<Prepared> run() {
    if (plan_.volume.isThere()) {  // killed between stitching and labelling
      if (auto kept = plan_.volume.read(silent_)) {
        begin(PreparationStep::stitch, "Labelling the tissues");
        auto labels = labelsOf(kept->volume.grid);
        if (!labels) return passOn(labels.error());
        kept->labels = std::move(*labels);
        return kept;
      }
    }
    std::vector<Prepared> parts;
    for (const PlannedSweep& sweep : plan_.sweeps) {
      auto part = sweptVolume(sweep);
      if (!part) return passOn(part.error());
      parts.push_back(std::move(*part));
    }
    begin(PreparationStep::stitch, "Stitching");
    Prepared made;
    auto stitched = stitchedVolume(std::move(parts));
    if (!stitched) return passOn(stitched.error());
    made.volume = std::move(*stitched);
    auto labels = labelsOf(made.volume.grid);
    if (!labels) return passOn(labels.error());
    made.labels = std::move(*labels);
    keepMachineSpeed(cacheFolder(), PreparationStep::stitch, stitchWork(plan_, case_.volume.reconstruct.spacing_mm), clock_.sinceBegin_s());
    return made;
  }

  Result<Prepared> voxelised() {
    auto patient = patientOf();
    if (!patient) return passOn(patient.error());
    begin(PreparationStep::voxelise, "Building the virtual patient");
    PartOfProgress most(clock_, 0.0, 0.9);
    auto voxels = voxelise(**patient,
                           {.spacing_mm = case_.volume.recipeSpacing_mm, .threads = options_.threads, .maxBytes = options_.maxBytes}, most);
    if (!voxels) return passOn(voxels.error());
    keepMachineSpeed(cacheFolder(), PreparationStep::voxelise, voxeliseWork(case_.volume.recipeSpacing_mm), clock_.sinceBegin_s());
    Prepared made{std::move(voxels->volume), {}};
    made.labels = {made.volume.grid, std::move(voxels->labels), {}};
    PartOfProgress rest(clock_, 0.9, 1.0);
    if (auto kept = keep(plan_.volume, made, rest); !kept) return passOn(kept.error());
    keepTruth();
    return made;
  }

  [[nodiscard]] static std::vector<PreparationClock::Step> stepsOf(const Case& opened, const CasePlan& plan) {
    const MachineSpeed speed = readMachineSpeed(cacheFolder());
    std::vector<PreparationClock::Step> steps;
    const auto add = [&](PreparationStep kind, double work) { steps.push_back({static_cast<int>(kind), speed.of(kind) * work}); };
    if (plan.sweeps.empty()) {
      add(PreparationStep::patient, 1.0);
      add(PreparationStep::voxelise, voxeliseWork(opened.volume.recipeSpacing_mm));
      return steps;
    }
    bool hasPatient = false;
    std::error_code ignored;
    for (const PlannedSweep& sweep : plan.sweeps) {
      if (sweep.store.isThere()) continue;
      if (!fs::exists(sweep.recording, ignored)) {
        if (!hasPatient) add(PreparationStep::patient, 1.0);
        hasPatient = true;
        add(PreparationStep::record, sweep.work);
      }
      add(PreparationStep::reconstruct, sweep.work);
    }
    add(PreparationStep::stitch, stitchWork(plan, opened.volume.reconstruct.spacing_mm));
    return steps;
  }

 private:
  void begin(PreparationStep kind, std::string what) { clock_.begin(static_cast<int>(kind), std::move(what)); }

  Result<PatientPtr> patientOf() {
    if (patient_) return patient_;
    begin(PreparationStep::patient, "Reading the patient");
    auto read = readPatient(plan_.patientFile, plan_.mannequins, {}, clock_);
    if (!read) return passOn(read.error());
    patient_ = std::move(*read);
    keepMachineSpeed(cacheFolder(), PreparationStep::patient, 1.0, clock_.sinceBegin_s());
    if (clock_.cancelRequested()) return stopped();
    return patient_;
  }

  /// Without a cache the case still opens; it is only made anew next time, and the user is told why, once. A cancel, though, is a cancel.
  Result<void> keep(const PreparedStore& store, const Prepared& made, Progress& progress) {
    auto written = store.write(made, progress);
    if (written || written.error().code == ErrorCode::cancelled) return written;
    sayUnkept(written.error());
    return {};
  }

  void sayUnkept(const Error& why) {
    if (!saidUnkept_)
      notes_.push_back("The prepared volume could not be kept for the next start; set ECHOWEAVE_CACHE to a folder you may write to. " +
                       why.sentence);
    saidUnkept_ = true;
  }

  void keepTruth() {
    if (!patient_) return;
    if (const auto truth = truthOfPatient(*patient_, silent_)) static_cast<void>(writeFileSafely(plan_.truth, *truth));
  }

  /// A recording on disk, as a laboratory has it: the tracked images and the device set with calibration and sector.
  struct Recording {
    fs::path images;
    fs::path calibration;
  };

  Result<void> writeRecording(const VirtualSweep& swept, const Recording& recording, Progress& progress) {
    std::error_code ignored;
    fs::create_directories(recording.images.parent_path(), ignored);
    if (auto written = writeDeviceSet(swept.deviceSet, recording.calibration); !written) return written;
    return writeSequence(swept.sequence, recording.images, progress);
  }

  Result<Recording> recorded(const PlannedSweep& sweep) {
    const Recording kept{sweep.recording, sweep.calibration};
    std::error_code ignored;
    if (fs::exists(kept.images, ignored) && fs::exists(kept.calibration, ignored)) return kept;
    auto patient = patientOf();
    if (!patient) return passOn(patient.error());
    begin(PreparationStep::record, "Recording the sweep '" + sweep.name + "'");
    PartOfProgress most(clock_, 0.0, 0.9);
    auto swept = recordSweep(*patient, sweep.probe, sweep.recipe, options_.threads, most, options_.maxBytes);
    if (!swept) return passOn(swept.error());
    PartOfProgress rest(clock_, 0.9, 1.0);
    Recording made = kept;
    auto written = writeRecording(*swept, made, rest);
    if (!written && written.error().code != ErrorCode::cancelled) {
      // The cache cannot be written; the road leads through a file all the same, in a folder that nobody else can write to.
      sayUnkept(written.error());
      if (!aside_) aside_ = PrivateFolder::make();
      if (aside_) {
        made = {aside_->path() / (sweep.key + ".igs.mha"), aside_->path() / (sweep.key + ".xml")};
        written = writeRecording(*swept, made, rest);
      }
    }
    if (!written) return passOn(written.error());
    keepMachineSpeed(cacheFolder(), PreparationStep::record, sweep.work, clock_.sinceBegin_s());
    return made;
  }

  Result<ImportedSweep> reconstructed(const PlannedSweep& sweep, const Recording& recording) {
    begin(PreparationStep::reconstruct, "Reconstructing the sweep '" + sweep.name + "'");
    const CaseReconstruction& asked = case_.volume.reconstruct;
    SweepImportOptions import;
    import.calibrations = {recording.calibration};
    import.reconstruct.spacing_mm = asked.spacing_mm;
    import.reconstruct.interpolation = asked.interpolation;
    import.reconstruct.compounding = asked.compounding;
    import.reconstruct.fillReach_mm = asked.fillReach_mm;
    import.reconstruct.threads = options_.threads;
    import.reconstruct.maxBytes = options_.maxBytes;
    return importSweep(recording.images, import, clock_);
  }

  static void remove(const Recording& recording) {
    std::error_code ignored;
    fs::remove(recording.images, ignored);
    fs::remove(recording.calibration, ignored);
  }

  Result<Prepared> sweptVolume(const PlannedSweep& sweep) {
    // Cases may share a patient and a sweep: whoever comes second finds what the first one kept, and never a recording that goes while he
    // reads it.
    const auto lock = PreparationLock::take(sweep.lock, silent_);
    if (!lock) return passOn(lock.error());
    if (sweep.store.isThere()) {
      auto kept = sweep.store.read(silent_);
      if (kept || kept.error().code == ErrorCode::cancelled) return kept;
      notes_.push_back("A part of the case in the cache could not be used and was made again. " + kept.error().sentence);
    }
    auto recording = recorded(sweep);
    if (!recording) return passOn(recording.error());
    auto imported = reconstructed(sweep, *recording);
    if (!imported && imported.error().code != ErrorCode::cancelled && imported.error().code != ErrorCode::tooLarge) {
      remove(*recording);  // damaged in the cache: made again, once
      recording = recorded(sweep);
      if (!recording) return passOn(recording.error());
      imported = reconstructed(sweep, *recording);
    }
    if (!imported) return passOn(imported.error());
    Prepared made{std::move(imported->reconstruction.volume), {}};
    if (auto kept = keep(sweep.store, made, silent_); !kept) return passOn(kept.error());
    if (auto moved = putAway(*recording, sweep); !moved) return passOn(moved.error());
    keepMachineSpeed(cacheFolder(), PreparationStep::reconstruct, sweep.work, clock_.sinceBegin_s());
    return made;
  }

  /// A recording has done its service once its volume is kept; whoever wants to look at it names a folder.
  Result<void> putAway(const Recording& recording, const PlannedSweep& sweep) {
    if (!options_.keepSweeps.empty()) {
      std::error_code error;
      fs::create_directories(options_.keepSweeps, error);
      for (const auto& [from, ending] : {std::pair{recording.images, ".igs.mha"}, std::pair{recording.calibration, ".xml"}}) {
        const fs::path target = options_.keepSweeps / (sweep.name + ending);
        error.clear();
        fs::copy_file(from, target, error);  // never over a file that is there
        if (error)
          return failure(ErrorCode::notWritable,
                         "The recording cannot be written to '" + target.string() + "' (" + error.message() + "); choose another folder.",
                         {{"file", target.string()}});
      }
    }
    remove(recording);
    return {};
  }

  Result<Volume> stitchedVolume(std::vector<Prepared> parts) {
    std::vector<stitching::PlacedView> views;
    for (std::size_t n = 0; n < parts.size(); ++n) views.push_back({&parts[n].volume, glm::dmat4(1.0), plan_.sweeps[n].name});
    stitching::StitchOptions how;
    how.spacing_mm = case_.volume.reconstruct.spacing_mm;
    how.featherWidth_mm = case_.volume.reconstruct.feather_mm;
    how.axes = stitching::GridAxes::world;
    how.threads = options_.threads;
    how.maxBytes = options_.maxBytes;
    PartOfProgress most(clock_, 0.0, 0.6);
    auto stitched = stitching::stitch(views, how, most);
    if (!stitched) return passOn(stitched.error());
    Prepared made{std::move(stitched->volume), {}};
    PartOfProgress saving(clock_, 0.6, 0.65);
    if (auto kept = keep(plan_.volume, made, saving); !kept) return passOn(kept.error());
    return std::move(made.volume);
  }

  Result<Volume> labelsOf(const Grid& grid) {
    if (plan_.labels.isThere()) {
      auto kept = plan_.labels.read(silent_);
      if (kept) return std::move(kept->labels);
      if (kept.error().code == ErrorCode::cancelled) return passOn(kept.error());
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
    PartOfProgress labelling(clock_, 0.65, 0.95);
    auto labels = labelsOn(*patient_, coarse, options_.threads, labelling, options_.maxBytes);
    if (!labels) return passOn(labels.error());
    Prepared made{{}, {coarse, std::move(*labels), {}}};
    PartOfProgress saving(clock_, 0.95, 1.0);
    if (auto kept = keep(plan_.labels, made, saving); !kept) return passOn(kept.error());
    keepTruth();
    return std::move(made.labels);
  }

  const Case& case_;
  const CasePlan& plan_;
  const PreparationOptions& options_;
  std::vector<std::string>& notes_;
  PreparationClock clock_;
  QuietProgress silent_;
  PatientPtr patient_;
  std::optional<PrivateFolder> aside_;  ///< for recordings, when the cache cannot be written
  bool saidUnkept_ = false;
};

/// What the cache holds in full.
Result<Prepared> readDone(const CasePlan& plan, Progress& progress) {
  PartOfProgress first(progress, 0.0, 0.7);
  auto found = plan.volume.read(first);
  if (!found || plan.sweeps.empty()) return found;
  PartOfProgress second(progress, 0.7, 1.0);
  auto labels = plan.labels.read(second);
  if (!labels) return passOn(labels.error());
  found->labels = std::move(labels->labels);
  return found;
}

Result<CasePlan> unguardedPlanOf(const Case& opened) {
  const auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  CasePlan plan;
  plan.mannequins = *resources / "mannequin";
  auto recipe = fileOfCase(opened.folder, opened.volume.recipe, "volume.recipe");
  if (!recipe) return passOn(recipe.error());
  plan.patientFile = std::move(*recipe);
  // The phantom library answers for everything that shapes the patient: recipe, what it extends, mannequin and its own way of drawing.
  const auto patient = fingerprintOfPatient(plan.patientFile, plan.mannequins);
  if (!patient) return passOn(patient.error());
  const fs::path folder = cacheFolder() / "recipes";
  ContentHash whole;
  whole.add(kPreparationFormat).add(*patient);
  if (opened.volume.sweeps.empty()) {
    whole.add(std::string_view("voxelised")).add(opened.volume.recipeSpacing_mm);
  } else {
    std::set<std::string> names;
    for (const std::string& relative : opened.volume.sweeps) {
      auto sweep = sweepOf(opened, relative, *resources, *patient, cacheFolder() / "steps");
      if (!sweep) return passOn(sweep.error());
      if (!names.insert(sweep->name).second)
        return failure(ErrorCode::badField, "Two sweeps of the case are called '" + sweep->name + "'; give each a name of its own.",
                       {{"field", "volume.sweeps"}, {"found", sweep->name}});
      whole.add(std::string_view(sweep->store.name()));
      plan.sweeps.push_back(std::move(*sweep));
    }
    whole.add(opened.volume.reconstruct.feather_mm);
  }
  const std::string name = whole.text();
  plan.volume = PreparedStore(folder, name);
  plan.labels = PreparedStore(folder, ContentHash().add(std::string_view(name)).add(opened.volume.reconstruct.labelsSpacing_mm).text());
  plan.truth = folder / (name + ".truth.json");
  plan.lock = folder / (name + ".lock");
  return plan;
}

}  // namespace

Result<CasePlan> planOf(const Case& opened) {
  return guardedCase("The case '" + opened.folder.string() + "'", [&] { return unguardedPlanOf(opened); });
}

PreparationEstimate estimateOf(const Case& opened, const CasePlan& plan) {
  if (plan.isDone()) return {0.0, true};
  PreparationEstimate estimate;
  estimate.measured = readMachineSpeed(cacheFolder()).measured;
  for (const auto& step : Preparation::stepsOf(opened, plan)) estimate.seconds += step.expected_s;
  return estimate;
}

Result<Prepared> makePrepared(const Case& opened, const CasePlan& plan, const PreparationOptions& options, Progress& whole,
                              std::vector<std::string>& notes) {
  Onward progress(whole);
  const auto readOrNote = [&]() -> Result<Prepared> {
    auto cached = readDone(plan, progress);
    if (!cached && cached.error().code != ErrorCode::cancelled)
      notes.push_back("The prepared volume in the cache could not be used and was made again. " + cached.error().sentence);
    return cached;
  };
  if (plan.isDone()) {
    auto cached = readOrNote();
    if (cached || cached.error().code == ErrorCode::cancelled) return cached;
  }
  const bool wasThere = plan.isDone();
  const auto lock = PreparationLock::take(plan.lock, progress);
  if (!lock) return passOn(lock.error());
  if (!wasThere && plan.isDone()) {
    auto cached = readOrNote();
    if (cached || cached.error().code == ErrorCode::cancelled) return cached;
  }
  if (progress.cancelRequested()) return stopped();
  for (const char* each : {"recipes", "steps"}) removeOldResults(cacheFolder() / each);
  Preparation preparation(opened, plan, options, progress, notes);
  return plan.sweeps.empty() ? preparation.voxelised() : preparation.run();
}

}  // namespace ew
