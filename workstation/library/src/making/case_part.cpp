#include "ew/library/case_part.h"

#include <utility>
#include <vector>

#include "ew/phantom/flow.h"
#include "ew/phantom/motion.h"
#include "ew/phantom/patient.h"
#include "ew/phantom/tissue_within.h"
#include "making/case_acoustics.h"
#include "making/case_pipeline.h"

namespace ew {
namespace {

constexpr double kMostShare = 0.4;  // beyond it the whole is worth its time, for it is kept

/// From the probe's frame to the case's own, for each pose that shows something.
std::vector<glm::dmat4> placesOf(const Case& opened, std::span<const Pose> poses) {
  const auto worldToFile = inverse(opened.volume.fileToWorld);
  std::vector<glm::dmat4> places;
  for (const Pose& pose : poses)
    if (pose.status == PoseStatus::ok && checkRigid(pose.probeToWorld.matrix)) places.push_back((worldToFile * pose.probeToWorld).matrix);
  return places;
}

Result<CaseEcho> makeSeen(const CasePlan& plan, const VoxelBlocks& blocks, const PreparationOptions& options, Progress& progress) {
  PartOfProgress reading(progress, 0.1, 0.4), moving(progress, 0.4, 0.5), painting(progress, 0.5, 1.0);
  const auto patient = readPatient(plan.patientFile, plan.mannequins, {}, reading);
  if (!patient) return passOn(patient.error());
  CaseEcho made;
  if (!plan.motion.empty()) {
    auto motion = tissueMotionOf(**patient, options.threads, moving);
    if (!motion) return passOn(motion.error());
    made.motion = std::move(*motion);
  }
  if (const FlowField& flow = flowOf(**patient); !flow.streams.empty()) made.flow = std::make_shared<const FlowField>(flow);
  auto part = tissueWithin(**patient, blocks, {.threads = options.threads, .maxBytes = options.maxBytes}, painting);
  if (!part) return passOn(part.error());
  made.labels = {part->volume.grid, std::move(part->labels), {}};
  made.volume = std::move(part->volume);
  made.tissue = std::make_shared<TissueMaps>(std::move(*part->maps));
  return made;
}

}  // namespace

Result<std::optional<CasePart>> loadCasePart(const Case& opened, std::vector<Capsule> seen_probe, std::span<const Pose> poses,
                                             Progress& progress, const PreparationOptions& options) {
  if (opened.volume.recipe.empty() || seen_probe.empty()) return std::nullopt;
  if (auto rigid = checkRigid(opened.volume.fileToWorld); !rigid) return passOn(rigid.error());
  const auto plan = planOf(opened);
  if (!plan) return passOn(plan.error());
  if (!isWorthDrafting(opened, *plan)) return std::nullopt;
  const auto box = readPatientBox(plan->patientFile, plan->mannequins);
  if (!box) return passOn(box.error());
  PartOfProgress looking(progress, 0.0, 0.1);
  const auto blocks =
      voxelBlocksAt({std::move(seen_probe), placesOf(opened, poses)}, *box, opened.volume.recipeSpacing_mm, kMostShare, looking);
  if (!blocks) return passOn(blocks.error());
  if (!*blocks) return std::nullopt;
  auto tissues = acousticsOf(*plan);
  if (!tissues) return passOn(tissues.error());
  auto made = makeSeen(*plan, **blocks, options, progress);
  if (!made) return passOn(made.error());
  made->tissues = std::move(*tissues);
  placeEcho(opened, *made);
  return CasePart{std::move(*made), (*blocks)->share};
}

}  // namespace ew
