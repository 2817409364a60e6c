#include "bench/images/echo_subject.h"

#include <algorithm>
#include <chrono>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <utility>

#include "ew/phantom/truth.h"

namespace ew {
namespace {

constexpr double kWideRange_db = 120.0;  // of levels: nothing is clamped
constexpr double kForwardFNumber = 1.5;  // of the model's reception (resources/docs/science/forward-model.md)

/// What both engines know, and nothing that one of them alone adds.
Scene comparedScene(const ScanSubject& subject) {
  Scene scene;
  scene.recordedDynamicRange_db = kWideRange_db;
  scene.tissues = subject.scene.tissues;
  scene.focus = FocusEffect{};
  scene.sliceThickness = SliceThicknessEffect{};
  scene.attenuation = AttenuationEffect{};
  if (subject.scene.attenuation) scene.attenuation->expected_dbPerCmMhz = subject.scene.attenuation->expected_dbPerCmMhz;
  scene.attenuation->largestEnhancement_db = 60.0;
  LiveEchoesEffect effect = subject.scene.liveEchoes.value_or(LiveEchoesEffect{});
  effect.apertureShare = 1.0;
  effect.receiveFNumber = kForwardFNumber;
  effect.lineFilterWidth = 1.0;
  effect.lineAverage = effect.gain_db = effect.texture_db = effect.fragmentsPerCm3 = 0.0;
  effect.speckleReduction = 0.0;
  effect.haze_db = -80.0;
  scene.liveEchoes = effect;
  return scene;
}

/// Whether voxels of the maps hold a texture: liver and kidney, but not the thin sheets of mesentery and muscle, nor stomach content.
bool holds(double spacing_mm, const TissueTexture& texture) {
  constexpr double kVoxelsOfAGrain = 2.0, kSteepest_perVoxel = 10.0;  // grey levels
  const double grain_mm = finestGrain_mm(texture);
  return grain_mm >= kVoxelsOfAGrain * spacing_mm && texture.level * spacing_mm <= kSteepest_perVoxel * grain_mm;
}

/// Moves the face along the beam until it lies `pressed_mm` below the skin.
void putOnSkin(const Patient& patient, const glm::dmat4& worldToPatient, Transform<frame::World, frame::Probe>& probeToWorld) {
  constexpr double kPressed_mm = 1.0;
  for (int n = 0; n < 4; ++n) {
    const auto distance = signedDistance_mm(patient, "skin surface", glm::dvec3(worldToPatient * probeToWorld.matrix[3]));
    if (!distance) return;
    probeToWorld.matrix[3] += probeToWorld.matrix[1] * std::clamp(*distance + kPressed_mm, -30.0, 30.0);
  }
}

}  // namespace

EchoTruth EchoSubject::truth() const {
  EchoTruth truth{.maps = *subject.tissue,
                  .mapsGrid = subject.placedTissue,
                  .volume = *subject.voxels.volume(),
                  .volumeGrid = subject.placedGrid,
                  .labels = subject.labels.get(),
                  .labelsGrid = subject.placedLabels};
  for (const TissueAcoustics& tissue : scene.tissues)
    if (tissue.label >= 0 && tissue.label < 256) {
      const auto label = static_cast<std::size_t>(tissue.label);
      truth.reflection_db[label] = static_cast<float>(tissue.reflection_db);
      const double excess_dbPerCmMhz = tissue.attenuation_dbPerCmMhz - scene.attenuation->expected_dbPerCmMhz;
      truth.excess_dbPerMm[label] = static_cast<float>(2.0 * excess_dbPerCmMhz * 0.1 * 1e-6 * probe.carrier_hz);
    }
  truth.isUneven = isUneven;
  return truth;
}

Result<EchoSubject> readEchoSubject(const Case& opened, Progress& progress) {
  if (opened.volume.recipe.empty() || !opened.volume.sweeps.empty())
    return failure(ErrorCode::badUsage,
                   say<"The case '%1' is not drawn: live echoes are compared on cases with a recipe and no sweeps.">(opened.id));
  EchoSubject made;
  made.id = opened.id;
  PartOfProgress preparing(progress, 0.0, 0.8);
  auto contents = readContents(opened, preparing);
  if (!contents) return passOn(contents.error());
  made.subject = subjectOf(opened, *contents);
  if (made.subject.tissue == nullptr || made.subject.voxels.volume() == nullptr)
    return failure(ErrorCode::badUsage, say<"The case '%1' has no maps of its tissue; prepare it anew.">(opened.id));
  auto bare = std::make_shared<TissueMaps>(*made.subject.tissue);
  bare->surfaces.clear();
  made.bare = std::move(bare);
  made.worldToPatient = glm::inverse(opened.volume.fileToWorld.matrix);

  const auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  const auto recipe = fileOfCase(opened.folder, opened.volume.recipe, "volume.recipe");
  if (!recipe) return passOn(recipe.error());
  PartOfProgress reading(progress, 0.8, 1.0);
  auto patient = readPatient(*recipe, *resources / "mannequin", {}, reading);
  if (!patient) return passOn(patient.error());
  made.patient = std::move(*patient);
  const auto tissues = readLabelTissues(*recipe, *resources / "mannequin");
  if (!tissues) return passOn(tissues.error());
  for (const LabelTissue& each : *tissues)
    if (each.label >= 0 && each.label < 256)
      made.isUneven[static_cast<std::size_t>(each.label)] =
          each.tissue.scatterers_perMm3.has_value() || !holds(opened.volume.recipeSpacing_mm, each.tissue.texture);

  const auto probes = readProbes(*resources / "probes");
  if (!probes) return passOn(probes.error());
  const auto state = firstState(made.subject, *probes, {});
  if (!state) return failure(ErrorCode::notFound, say<"The probe of the case '%1' is not there.">(opened.id));
  made.probe = state->probe;
  made.scene = comparedScene(made.subject);
  made.anchors.push_back(state->pose.probeToWorld);
  if (opened.expertPose) made.anchors.push_back(opened.expertPose->probeToWorld);
  for (const StandardPlane& plane : planesOf(*made.patient)) {
    Transform<frame::World, frame::Probe> placed;
    placed.matrix = opened.volume.fileToWorld.matrix * plane.probeToWorld.matrix;
    made.anchors.push_back(placed);
  }
  return made;
}

std::vector<Transform<frame::World, frame::Probe>> echoPoses(const EchoSubject& subject, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto within = [&](double most) { return most * (2.0 * static_cast<double>(random() >> 11) * 0x1p-53 - 1.0); };
  constexpr double kSlide_mm = 12.0, kPerDegree = std::numbers::pi / 180.0;
  std::vector<Transform<frame::World, frame::Probe>> poses;
  for (int n = 0; n < count; ++n) {
    const auto anchors = subject.anchors.size(), number = static_cast<std::size_t>(n);
    Transform<frame::World, frame::Probe> pose = subject.anchors[number % anchors];
    if (number >= anchors) {
      pose.matrix = glm::translate(pose.matrix, {within(kSlide_mm), 0.0, within(kSlide_mm)});
      pose.matrix = glm::rotate(pose.matrix, within(25.0) * kPerDegree, glm::dvec3(0.0, 1.0, 0.0));
      pose.matrix = glm::rotate(pose.matrix, within(8.0) * kPerDegree, glm::dvec3(1.0, 0.0, 0.0));
      pose.matrix = glm::rotate(pose.matrix, within(8.0) * kPerDegree, glm::dvec3(0.0, 0.0, 1.0));
      putOnSkin(*subject.patient, subject.worldToPatient, pose);
    }
    poses.push_back(pose);
  }
  return poses;
}

LiveEngine::LiveEngine(const EchoSubject& subject, const Probe& probe, Quality quality, bool loses) : subject_(subject) {
  Scene scene = subject.scene;
  if (!loses) scene.attenuation.reset();
  Knobs knobs;
  knobs.quality = quality;
  // The image itself is not looked at.
  constexpr int kSmall_px = 64;
  maker_.configure(probe, knobs, scene, subject.subject.placedGrid, kSmall_px, kSmall_px,
                   {.labels = subject.subject.labels != nullptr, .tissue = true});
}

EchoFrame LiveEngine::frameAt(const Transform<frame::World, frame::Probe>& probeToWorld) {
  FrameInput input;
  input.echo = subject_.subject.voxels.source(subject_.subject.placedGrid, 0.0);
  if (subject_.subject.labels)
    input.labels = VolumeView<const std::uint8_t>{subject_.subject.labels->echo.data(), subject_.subject.placedLabels};
  input.tissue = subject_.bare.get();
  input.tissueGrid = subject_.subject.placedTissue;
  input.pose.probeToWorld = probeToWorld;
  [[maybe_unused]] const DisplayImage image = maker_.make(input);
  return frameOfLevels(maker_.beamGrid(), maker_.beamLevels(), kWideRange_db);
}

Result<ForwardEngine> ForwardEngine::of(const EchoSubject& subject, const Probe& probe, bool loses, std::uint64_t seed) {
  FormationOptions options;
  options.pulseCycles = subject.scene.liveEchoes->pulseCycles;
  options.looks = subject.scene.liveEchoes->looks;
  options.attenuation = loses;
  options.specular = false;
  options.noise_db = -300.0;
  options.expected_dbPerCmMhz = subject.scene.attenuation->expected_dbPerCmMhz;
  options.largestTgc_db = 200.0;
  auto scanner = makeVirtualScanner(subject.patient, probe, options, seed);
  if (!scanner) return passOn(scanner.error());
  ForwardEngine engine;
  engine.scanner_ = std::move(*scanner);
  engine.scratch_ = engine.scanner_->makeScratch();
  engine.worldToPatient_ = subject.worldToPatient;
  return engine;
}

EchoFrame ForwardEngine::frameAt(const Transform<frame::World, frame::Probe>& probeToWorld) {
  Transform<frame::World, frame::Probe> probeToPatient;
  probeToPatient.matrix = worldToPatient_ * probeToWorld.matrix;
  Image<float> envelope;
  const auto start = std::chrono::steady_clock::now();
  scanner_->envelope(probeToPatient, restingBody(), 0, *scratch_, envelope);
  last_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return frameOfAmplitudes(scanner_->grid(), envelope);
}

}  // namespace ew
