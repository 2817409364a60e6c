#include "case/case_plan.h"

#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

#include "ew/io/content_key.h"
#include "ew/io/safe_file.h"
#include "ew/phantom/patient.h"
#include "files/guarded_case.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

/// Part of every name in the cache: raise it when the same case starts to give another volume, by whatever step.
constexpr int kPreparationFormat = 6;
/// The same for the maps of tissue alone.
constexpr int kMapsFormat = 3;
/// And for the level of recorded tissue.
constexpr int kLevelFormat = 2;
/// The same for their motion.
constexpr int kMotionFormat = 1;
constexpr std::size_t kLargestSweepFile_bytes = 1u << 20;

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

void addOptions(ContentKey& key, const CaseReconstruction& reconstruct) {
  // 0 and -1: as the recording has it.
  key.add(reconstruct.spacing_mm.value_or(0.0))
      .add(reconstruct.interpolation ? static_cast<int>(*reconstruct.interpolation) : -1)
      .add(reconstruct.compounding ? static_cast<int>(*reconstruct.compounding) : -1)
      .add(reconstruct.fillReach_mm.value_or(-1.0));
}

Result<CaseSweep> sweepOf(const Case& opened, const std::string& relative, const fs::path& resources, std::uint64_t patient) {
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
                   say<"The sweep '%1' asks for the probe '%2', which the program does not have; name one of resources/probes.">(
                       relative, recipe->probe),
                   {{"field", "probe"}, {"found", recipe->probe}, {"file", relative}});
  auto probe = readProbe(probeFile);
  if (!probe) return passOn(probe.error());

  CaseSweep planned;
  planned.name = fs::path(relative).stem().string();
  planned.recipe = std::move(*recipe);
  planned.probe = std::move(*probe);
  planned.recording = ContentKey().add(kPreparationFormat).add(patient).add(*text).add(*probeText).text();
  ContentKey volume;
  volume.add("sweep").add(planned.recording);
  addOptions(volume, opened.volume.reconstruct);
  planned.volume = volume.text();
  planned.work = recordingWork(planned.probe, planned.recipe);
  return planned;
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
  ContentKey whole;
  whole.add(kPreparationFormat).add(*patient);
  if (opened.volume.sweeps.empty()) {
    whole.add("voxelised").add(opened.volume.recipeSpacing_mm);
  } else {
    std::set<std::string> names;
    for (const std::string& relative : opened.volume.sweeps) {
      auto sweep = sweepOf(opened, relative, *resources, *patient);
      if (!sweep) return passOn(sweep.error());
      if (!names.insert(sweep->name).second)
        return failure(ErrorCode::badField, say<"Two sweeps of the case are called '%1'; give each a name of its own.">(sweep->name),
                       {{"field", "volume.sweeps"}, {"found", sweep->name}});
      whole.add(sweep->name).add(sweep->volume);
      plan.sweeps.push_back(std::move(*sweep));
    }
    whole.add(static_cast<int>(opened.volume.reconstruct.seam)).add(opened.volume.reconstruct.feather_mm);
  }
  plan.volume = whole.text();
  plan.labels = ContentKey().add("labels").add(plan.volume).add(opened.volume.reconstruct.labelsSpacing_mm).text();
  plan.maps = opened.volume.sweeps.empty() ? ContentKey().add("maps").add(kMapsFormat).add(plan.volume).text()
                                           : ContentKey().add("level").add(kLevelFormat).add(plan.volume).text();
  if (opened.volume.sweeps.empty()) plan.motion = ContentKey().add("motion").add(kMotionFormat).add(plan.volume).text();
  plan.truth = ContentKey().add("truth").add(kPreparationFormat).add(*patient).text();
  return plan;
}

}  // namespace

Result<CasePlan> planOf(const Case& opened) {
  return guardedCase(opened.folder, [&] { return unguardedPlanOf(opened); });
}

const std::vector<std::string>& preparationSteps() {
  static const std::vector<std::string> names = {kRecordings, kSweeps, kVolumes, kLabels, kMaps, kMotions, kTruths};
  return names;
}

bool CasePlan::isDoneIn(const StepStore& store) const {
  return store.find(kVolumes, volume) && (sweeps.empty() || store.find(kLabels, labels)) && store.find(kMaps, maps) &&
         (motion.empty() || store.find(kMotions, motion));
}

bool CasePlan::isDamagedIn(const StepStore& store) const {
  const auto isDamaged = [&](const char* step, const std::string& key) { return store.claims(step, key) && !store.find(step, key); };
  return isDamaged(kVolumes, volume) || (!sweeps.empty() && isDamaged(kLabels, labels)) || isDamaged(kMaps, maps) ||
         (!motion.empty() && isDamaged(kMotions, motion));
}

bool CasePlan::isDone() const { return isDoneIn(StepStore::peek(cacheFolder(), preparationSteps())); }

double stitchWork(const CasePlan& plan, const CaseReconstruction& reconstruct) {
  constexpr double kUsual_mm = 0.6;  // of frames about 1 mm apart
  double volume_mm3 = 0.0;
  for (const CaseSweep& sweep : plan.sweeps)
    volume_mm3 += frameArea_mm2(sweep.probe, sweep.recipe.formation.depth_mm) * sweep.recipe.frames;  // frames about 1 mm apart
  return 1e-6 * volume_mm3 / std::pow(reconstruct.spacing_mm.value_or(kUsual_mm), 3);
}

double voxeliseWork(const CasePlan& plan, double spacing_mm) {
  const auto box = readPatientBox(plan.patientFile, plan.mannequins);
  if (!box) return 0.0;
  const glm::dvec3 voxels = (box->highest_mm - box->lowest_mm) / spacing_mm;
  return 1e-6 * voxels.x * voxels.y * voxels.z;
}

}  // namespace ew
