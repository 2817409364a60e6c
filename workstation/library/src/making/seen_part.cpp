#include "ew/library/seen_part.h"

#include <vector>

#include "ew/phantom/motion.h"
#include "ew/phantom/patient.h"
#include "ew/phantom/tissue_within.h"
#include "making/case_acoustics.h"
#include "making/case_pipeline.h"

namespace ew {
namespace {

constexpr double kMostShare = 0.4;  // beyond it the whole is worth its time, for it is kept

std::vector<Capsule> inOwnFrame(const Case& opened, std::span<const Capsule> seen_world) {
  const auto worldToFile = inverse(opened.volume.fileToWorld);
  const auto own = [&](const glm::dvec3& p_mm) { return (worldToFile * Point<frame::World>{p_mm}).at; };
  std::vector<Capsule> seen;
  seen.reserve(seen_world.size());
  for (const Capsule& each : seen_world) seen.push_back({own(each.from_mm), own(each.to_mm), each.radius_mm});
  return seen;
}

Result<CaseEcho> makeSeen(const Case& opened, const CasePlan& plan, std::span<const Capsule> seen, const PreparationOptions& options,
                          Progress& progress) {
  PartOfProgress reading(progress, 0.0, 0.4), moving(progress, 0.4, 0.5), painting(progress, 0.5, 1.0);
  const auto patient = readPatient(plan.patientFile, plan.mannequins, {}, reading);
  if (!patient) return passOn(patient.error());
  CaseEcho made;
  if (!plan.motion.empty()) {
    auto motion = tissueMotionOf(**patient, options.threads, moving);
    if (!motion) return passOn(motion.error());
    made.motion = std::move(*motion);
  }
  auto part = tissueWithin(
      **patient, seen, {.spacing_mm = opened.volume.recipeSpacing_mm, .threads = options.threads, .maxBytes = options.maxBytes}, painting);
  if (!part) return passOn(part.error());
  made.volume = {part->maps.grid, std::vector<std::uint8_t>(part->maps.level.size()), {}};
  made.labels = {part->maps.grid, std::move(part->labels), {}};
  made.tissue = std::make_shared<TissueMaps>(std::move(part->maps));
  return made;
}

}  // namespace

Result<std::optional<SeenPart>> loadSeenPart(const Case& opened, std::span<const Capsule> seen_world, Progress& progress,
                                             const PreparationOptions& options) {
  if (opened.volume.recipe.empty() || seen_world.empty()) return std::nullopt;
  if (auto rigid = checkRigid(opened.volume.fileToWorld); !rigid) return passOn(rigid.error());
  const auto plan = planOf(opened);
  if (!plan) return passOn(plan.error());
  if (!isWorthDrafting(opened, *plan)) return std::nullopt;
  const auto box = readPatientBox(plan->patientFile, plan->mannequins);
  if (!box) return passOn(box.error());
  const std::vector<Capsule> seen = inOwnFrame(opened, seen_world);
  const double share = shareWithin(*box, opened.volume.recipeSpacing_mm, seen);
  if (share > kMostShare) return std::nullopt;
  auto tissues = acousticsOf(*plan);
  if (!tissues) return passOn(tissues.error());
  auto made = makeSeen(opened, *plan, seen, options, progress);
  if (!made) return passOn(made.error());
  made->tissues = std::move(*tissues);
  placeEcho(opened, *made);
  return SeenPart{std::move(*made), share};
}

}  // namespace ew
