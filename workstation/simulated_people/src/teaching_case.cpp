#include "ew/simulated_people/teaching_case.h"

#include <algorithm>

#include "ew/io/volume_file.h"
#include "ew/library/body_skin.h"
#include "ew/library/new_case.h"
#include "ew/phantom/label_grid.h"

namespace ew {
namespace {

constexpr double kLabels_mm = 1.6;  // as cases have theirs

/// The file's own grid, or the box of a patient on a grid of labels; in the case's own frame.
Result<Grid> ownGridOf(const Case& opened, const std::filesystem::path& mannequins) {
  if (opened.volume.recipe.empty()) {
    const auto file = fileOfCase(opened.folder, opened.volume.file, "volume.file");
    if (!file) return passOn(file.error());
    const auto header = readVolumeHeader(*file);
    if (!header) return passOn(header.error());
    return header->grid;
  }
  const auto box = readPatientBox(opened.folder / opened.volume.recipe, mannequins);
  if (!box) return passOn(box.error());
  Grid grid;
  grid.spacing_mm = glm::dvec3(kLabels_mm);
  grid.origin_mm = box->lowest_mm + 0.5 * kLabels_mm;
  grid.dims = glm::max(glm::ivec3(1), glm::ivec3((box->highest_mm - box->lowest_mm) / kLabels_mm));
  return grid;
}

/// Of a patient at rest, or those that stand beside a recorded volume; null where there are none.
Result<std::shared_ptr<const Volume>> labelsOf(const Case& opened, const Grid& own, const std::filesystem::path& mannequins, int threads,
                                               Progress& progress) {
  if (opened.volume.recipe.empty()) {
    if (opened.volume.labels.empty()) return std::shared_ptr<const Volume>();
    auto read = readLabelVolume(opened.folder / opened.volume.labels, progress);
    if (!read) return passOn(read.error());
    read->volume.grid = placed(read->volume.grid, opened.volume.fileToWorld);
    return std::make_shared<const Volume>(std::move(read->volume));
  }
  const auto patient = readPatient(opened.folder / opened.volume.recipe, mannequins, {}, progress);
  if (!patient) return passOn(patient.error());
  auto labels = labelsOn(**patient, own, threads, progress);
  if (!labels) return passOn(labels.error());
  return std::make_shared<const Volume>(Volume{placed(own, opened.volume.fileToWorld), *std::move(labels), {}});
}

}  // namespace

Result<TeachingCase> teachingCaseOf(const Case& opened, bool withLabels, int threads, Progress& progress) {
  TeachingCase made;
  made.opened = opened;
  const auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  if (hasNoVolume(opened))
    return failure(ErrorCode::unsupported, say<"%1 has no volume, so that nobody can be taught with it yet.">(opened.id),
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
  auto labels = labelsOf(opened, *grid, mannequins, threads, progress);
  if (!labels) return passOn(labels.error());
  made.labels = *std::move(labels);
  return made;
}

}  // namespace ew
