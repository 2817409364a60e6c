// What a case says that is well formed and still of no use to whoever opens it.
#include <algorithm>
#include <cmath>

#include "case/manifest.h"
#include "ew/core/numbers.h"
#include "ew/imaging/probe.h"
#include "ew/io/volume_file.h"
#include "ew/library/case.h"
#include "ew/phantom/patient.h"

namespace ew {
namespace {

constexpr double kFarthestStart_mm = 150.0;  // of the probe's face from the volume: as thick as a body's side is

/// The box around what is scanned, in the world; nothing when the file does not tell.
std::optional<Bounds> boxOfCase(const Case& opened, const std::filesystem::path& resources) {
  Bounds box;
  if (!opened.volume.recipe.empty()) {
    const auto recipe = fileOfCase(opened.folder, opened.volume.recipe, "volume.recipe");
    const auto read = recipe ? readPatientBox(*recipe, resources / "mannequin") : Result<Bounds>(passOn(recipe.error()));
    if (!read) return std::nullopt;
    box = *read;
  }
  Grid grid;
  if (opened.volume.recipe.empty()) {
    const auto file = fileOfCase(opened.folder, opened.volume.file, "volume.file");
    const auto header = file ? readVolumeHeader(*file) : Result<VolumeHeader>(passOn(file.error()));
    if (!header || header->sequence) return std::nullopt;
    grid = header->grid;
  } else {
    grid.dims = glm::ivec3(2);
    grid.origin_mm = box.lowest_mm;
    grid.spacing_mm = box.highest_mm - box.lowest_mm;
  }
  const auto voxelToWorld = placed(grid, opened.volume.fileToWorld).voxelToWorld();
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 ijk = glm::dvec3(grid.dims - 1) * glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2);
    const glm::dvec3 at = (voxelToWorld * Point<frame::Voxel>{ijk}).at;
    box.lowest_mm = corner == 0 ? at : glm::min(box.lowest_mm, at);
    box.highest_mm = corner == 0 ? at : glm::max(box.highest_mm, at);
  }
  return box;
}

}  // namespace

std::vector<Error> problemsInUse(const Case& opened) {
  std::vector<Error> problems;
  const auto resources = resourceFolder();
  if (!resources) return problems;
  if (const auto probes = readProbes(*resources / "probes"); probes) {
    std::string known;
    for (const Probe& probe : *probes) known += (known.empty() ? "" : ", ") + probe.id;
    for (std::size_t n = 0; n < opened.probes.size(); ++n) {
      const std::string& id = opened.probes[n];
      if (std::any_of(probes->begin(), probes->end(), [&](const Probe& probe) { return probe.id == id; })) continue;
      const std::string field = "probes[" + std::to_string(n) + "]";
      problems.push_back({ErrorCode::badField,
                          say<"'%1' in case.json is \"%2\", which is no probe of the program; name one of %3.">(field, id, known),
                          {{"field", field}, {"found", id}, {"expected", known}}});
    }
  }
  if (!opened.startPose) return problems;
  const auto box = boxOfCase(opened, *resources);
  if (!box) return problems;
  const glm::dvec3 face(opened.startPose->probeToWorld.matrix[3]);
  const glm::dvec3 outside = glm::max(glm::max(box->lowest_mm - face, face - box->highest_mm), glm::dvec3(0.0));
  if (glm::length(outside) > kFarthestStart_mm)
    problems.push_back(
        {ErrorCode::badField,
         say<"'start_pose' in case.json lies %1 mm beside the volume, where a probe sees nothing; put the probe on the body above the "
             "volume and "
             "take that pose.">(textOf(std::round(glm::length(outside)))),
         {{"field", "start_pose"}, {"found", textOf(glm::length(outside))}, {"expected", "at most " + textOf(kFarthestStart_mm)}}});
  return problems;
}

}  // namespace ew
