#include "teaching_case.h"

#include <algorithm>

#include "ew/library/body_skin.h"
#include "ew/phantom/label_grid.h"

namespace ew {
namespace {

constexpr double kLabels_mm = 1.6;  // as cases have theirs

/// The box of the data on a grid of labels, in the case's own frame.
Result<Grid> ownGridOf(const Case& opened, const std::filesystem::path& mannequins) {
  const auto box = readPatientBox(opened.folder / opened.volume.recipe, mannequins);
  if (!box) return passOn(box.error());
  Grid grid;
  grid.spacing_mm = glm::dvec3(kLabels_mm);
  grid.origin_mm = box->lowest_mm + 0.5 * kLabels_mm;
  grid.dims = glm::max(glm::ivec3(1), glm::ivec3((box->highest_mm - box->lowest_mm) / kLabels_mm));
  return grid;
}

}  // namespace

Result<TeachingCase> teachingCaseOf(const Case& opened, bool withLabels, int threads, Progress& progress) {
  TeachingCase made;
  made.opened = opened;
  const auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  if (opened.volume.recipe.empty())
    return failure(ErrorCode::unsupported, say<"%1 has no virtual patient; only cases with one are measured here.">(opened.id),
                   {{"case", opened.id}});
  auto truth = loadCaseTruth(opened, progress);
  if (!truth) return passOn(truth.error());
  made.truth = *std::move(truth);

  const std::filesystem::path mannequins = *resources / "mannequin";
  const std::string name = opened.mannequin.empty() ? std::string("adult.json") : opened.mannequin;
  const auto own = fileOfCase(opened.folder, name, "mannequin");
  auto skin = readBodySkin(own ? *own : mannequins / name);
  if (!skin) return passOn(skin.error());
  made.skin = *std::move(skin);

  const auto probes = readProbes(*resources / "probes");
  if (!probes) return passOn(probes.error());
  const auto first = opened.probes.empty() ? probes->begin() : std::find_if(probes->begin(), probes->end(), [&](const Probe& each) {
    return each.id == opened.probes.front();
  });
  if (first == probes->end())
    return failure(ErrorCode::notFound,
                   say<"There is no probe \"%1\"; see resources/probes.">(opened.probes.empty() ? "" : opened.probes.front()));
  made.probe = *first;

  const auto grid = ownGridOf(opened, mannequins);
  if (!grid) return passOn(grid.error());
  made.region.placedGrid = placed(*grid, opened.volume.fileToWorld);
  made.region.below_mm = std::min(30.0, 0.5 * made.probe.defaultDepth_mm);
  if (!withLabels) return made;
  const auto patient = readPatient(opened.folder / opened.volume.recipe, mannequins, {}, progress);
  if (!patient) return passOn(patient.error());
  auto labels = labelsOn(**patient, *grid, threads, progress);
  if (!labels) return passOn(labels.error());
  Volume volume;
  volume.grid = made.region.placedGrid;
  volume.echo = *std::move(labels);
  made.labels = std::make_shared<const Volume>(std::move(volume));
  return made;
}

}  // namespace ew
