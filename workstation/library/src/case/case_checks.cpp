// What a case may be, asked of its values: the same for a manifest that was read and for an edit.
#include <algorithm>
#include <cmath>

#include "case/echo_files.h"
#include "case/manifest.h"
#include "ew/acquisition/reconstruct_words.h"
#include "ew/core/json_fields.h"
#include "ew/imaging/settings_json.h"
#include "ew/imaging/tissue_name.h"
#include "ew/library/schema.h"
#include "ew/stitching/project.h"
#include "files/value_rules.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

using Problems = std::vector<Error>;

Error wrongField(const std::string& field, const Message& found, const Message& expected) {
  return fieldError(verbatim(kManifestName), field, found, expected);
}

std::string numbered(const char* list, std::size_t number) { return list + ("[" + std::to_string(number) + "]"); }

void checkPlacement(const glm::dmat4& matrix, const std::string& field, Problems& problems) {
  if (auto problem = rigidProblem(matrix, field, verbatim(kManifestName))) problems.push_back(std::move(*problem));
}

/// Each kind of target has fields of its own.
void checkTargets(const Case& opened, Problems& problems) {
  const bool hasRecipe = !opened.volume.recipe.empty();
  for (std::size_t n = 0; n < opened.targets.size(); ++n) {
    const CaseTarget& target = opened.targets[n];
    const std::string field = numbered("targets", n);
    using Kind = CaseTarget::Kind;
    if (target.kind == Kind::point && !target.at_mm)
      problems.push_back(wrongField(field + ".at_mm", say<"missing">(), say<"three numbers, mm in the world">()));
    if (target.kind == Kind::structure && target.organ.empty() && !target.label)
      problems.push_back(wrongField(
          field + (hasRecipe ? ".organ" : ".label"), say<"missing">(),
          hasRecipe ? say<"the name of an organ of the patient">() : say<"the number of the structure in the labels of the volume">()));
    if (target.label && opened.volume.labels.empty())
      problems.push_back(
          wrongField(field + ".label", say<"given, and the case has no labels">(), say<"left out, or a number of volume.labels">()));
    if (target.kind == Kind::plane && !target.probeToFile && !hasRecipe)
      problems.push_back(
          wrongField(field, say<"a plane of a patient, and the case has no recipe">(), say<"a plane with probe_to_world">()));
    if (target.kind == Kind::structure && !target.organ.empty() && !hasRecipe)
      problems.push_back(wrongField(field, say<"a structure of a patient, and the case has no recipe">(),
                                    say<"a structure with a label, or a point or a plane">()));
    if (target.probeToFile) checkPlacement(target.probeToFile->matrix, field + ".probe_to_world", problems);
  }
}

void checkMeasurements(const Case& opened, Problems& problems) {
  if (!opened.volume.recipe.empty()) return;
  for (std::size_t n = 0; n < opened.measurements.size(); ++n)
    if (!opened.measurements[n].value)
      problems.push_back(wrongField(numbered("measurements", n) + ".value", say<"missing, and the case has no patient who could know it">(),
                                    say<"the value as it was measured">()));
}

/// Looks for a file that is named. @param find fileOfCase or volumeOfCase
template <class Find>
void checkNamed(const Find& find, const Case& opened, const std::string& name, const std::string& field, Problems& problems) {
  if (name.empty()) return;
  if (auto file = find(opened.folder, name, field); !file) problems.push_back(file.error());
}

void checkImages(const Case& opened, Problems& problems) {
  for (std::size_t n = 0; n < opened.previousExaminations.size(); ++n)
    for (const std::string& image : opened.previousExaminations[n].images)
      if (auto file = fileOfCase(opened.folder, image, numbered("previous_examinations", n) + ".pictures"); !file)
        problems.push_back(file.error());
}

/// The default mannequin and those of the program need no file in the case folder.
void checkMannequin(const Case& opened, Problems& problems) {
  const std::string& name = opened.mannequin;
  if (name.empty()) return;
  auto own = fileOfCase(opened.folder, name, "mannequin");
  if (own || own.error().code != ErrorCode::notFound) {
    if (!own) problems.push_back(own.error());
    return;
  }
  std::error_code ignored;
  const auto resources = resourceFolder();
  if (opened.folder.empty() || (resources && fs::exists(*resources / "mannequin" / name, ignored))) return;
  problems.push_back({ErrorCode::notFound,
                      say<"The mannequin '%1' is neither in the case folder nor among the program's own; put the file into the case folder "
                          "or leave the field empty.">(name),
                      {{"field", "mannequin"}, {"found", name}}});
}

void checkVolume(const Case& opened, Problems& problems) {
  const CaseVolume& volume = opened.volume;
  const bool hasRecipe = !volume.recipe.empty();
  checkNamed(volumeOfCase, opened, volume.file, "volume.file", problems);
  checkNamed(volumeOfCase, opened, volume.labels, "volume.labels", problems);
  if (!volume.labels.empty() && hasRecipe)
    problems.push_back({ErrorCode::badField,
                        say<"'volume.labels' in case.json stands beside a recipe, which makes its own labels; take one of them out.">(),
                        {{"field", "volume.labels"}, {"expected", "no labels beside a recipe"}}});
  checkNamed(fileOfCase, opened, volume.frames, "volume.frames", problems);
  if (!volume.frames.empty() && volume.file.empty())
    problems.push_back({ErrorCode::badField,
                        say<"'volume.frames' in case.json stands without the volume that was made of them; take it out.">(),
                        {{"field", "volume.frames"}, {"expected", "beside volume.file"}}});
  checkNamed(volumeOfCase, opened, volume.level, "volume.level", problems);
  if (!volume.level.empty() && hasRecipe)
    problems.push_back({ErrorCode::badField,
                        say<"'volume.level' in case.json stands beside a recipe, which makes its own level; take one of them out.">(),
                        {{"field", "volume.level"}, {"expected", "no level beside a recipe"}}});
  for (Error& problem : problemsOfEchoes(opened)) problems.push_back(std::move(problem));
  checkNamed(fileOfCase, opened, volume.recipe, "volume.recipe", problems);
  if (!volume.sweeps.empty() && !hasRecipe)
    problems.push_back(
        wrongField("volume.sweeps", say<"given without a recipe">(), say<"left out, or beside the recipe whose patient is swept">()));
  for (std::size_t n = 0; n < volume.sweeps.size(); ++n)
    checkNamed(fileOfCase, opened, volume.sweeps[n], numbered("volume.sweeps", n), problems);
}

// By the schema, field by field.

bool isFinite(const glm::dvec3& at_mm) { return std::isfinite(at_mm.x) && std::isfinite(at_mm.y) && std::isfinite(at_mm.z); }

void checkReconstruction(const ValueRules& rules, const CaseReconstruction& reconstruct) {
  rules.number("spacing_mm", reconstruct.spacing_mm);
  if (reconstruct.interpolation) rules.text("interpolation", std::string(wordIn(kInterpolationWords, *reconstruct.interpolation)));
  if (reconstruct.compounding) rules.text("compounding", std::string(wordIn(kCompoundingWords, *reconstruct.compounding)));
  rules.number("fill_reach_mm", reconstruct.fillReach_mm);
  rules.text("seam", stitching::nameOf(reconstruct.seam));
  rules.number("feather_mm", reconstruct.feather_mm);
  rules.number("labels_spacing_mm", reconstruct.labelsSpacing_mm);
}

void checkVolumeFields(const ValueRules& rules, const CaseVolume& volume) {
  if (!volume.file.empty() && !volume.recipe.empty()) rules.refuse(shown(nlohmann::json{{"file", volume.file}, {"recipe", volume.recipe}}));
  rules.number("recipe_spacing_mm", volume.recipeSpacing_mm);
  if (volume.sweeps.empty()) return;
  rules.texts("sweeps", volume.sweeps);
  checkReconstruction(rules.in("reconstruct"), volume.reconstruct);
}

void checkTargetFields(const ValueRules& rules, const CaseTarget& target) {
  rules.text("name", target.name);
  if (target.at_mm && !isFinite(*target.at_mm)) rules.in("at_mm").refuse(say<"not a number">());
  rules.number("tolerance_mm", target.tolerance_mm);
  rules.number("position_tolerance_mm", target.positionTolerance_mm);
  rules.number("angle_tolerance_deg", target.angleTolerance_deg);
  rules.number("label", target.label);
}

void checkMeasurementFields(const ValueRules& rules, const CaseMeasurement& measurement) {
  rules.text("name", measurement.name);
  rules.number("tolerance", measurement.tolerance);
  rules.number("value", measurement.value);
  rules.textIfAny("kind", measurement.kind);
  rules.textIfAny("unit", measurement.unit);
  rules.list("points_mm", measurement.points_mm.size(), [&](const ValueRules& point, std::size_t n) {
    if (!isFinite(measurement.points_mm[n])) point.refuse(say<"not a number">());
  });
}

void checkPatient(const ValueRules& rules, const CasePatient& patient) {
  rules.text("name", patient.name);
  rules.text("sex", patient.sex);
  rules.number("age_years", patient.age_years);
}

/// A scene knows its limits itself; only where it breaks them is it written out, for the sentence.
Problems problemsOfScene(const Scene& scene) {
  const auto sameLabel = [](const TissueAcoustics& a, const TissueAcoustics& b) { return a.label < b.label; };
  std::vector<TissueAcoustics> tissues = scene.tissues;
  std::sort(tissues.begin(), tissues.end(), sameLabel);
  const bool isDouble =
      std::adjacent_find(tissues.begin(), tissues.end(), [](const auto& a, const auto& b) { return a.label == b.label; }) != tissues.end();
  const bool isLong =
      std::any_of(tissues.begin(), tissues.end(), [](const TissueAcoustics& each) { return each.name.size() > kLongestTissueName_bytes; });
  if (limited(scene) == scene && !isDouble && !isLong) return {};
  Problems problems = schemaProblems({{"scene", toJson(scene)}}, SchemaName::caseOtherFields, verbatim(kManifestName));
  if (!problems.empty()) return problems;
  if (auto read = sceneFromJson(toJson(scene), sceneName()); !read) problems.push_back(inScene(std::move(read.error())));
  return problems;
}

}  // namespace

Message sceneName() { return say<"the scene of case.json">(); }

Error inScene(Error problem) {
  for (auto& [key, value] : problem.context)
    if (key == "field") value.insert(0, "scene.");
  return problem;
}

Problems problemsBetweenFields(const Case& opened) {
  Problems problems;
  checkPlacement(opened.volume.fileToWorld.matrix, "volume.file_to_world", problems);
  if (opened.startPose) checkPlacement(opened.startPose->probeToWorld.matrix, "start_pose", problems);
  if (opened.expertPose) checkPlacement(opened.expertPose->probeToWorld.matrix, "expert_pose", problems);
  if (!std::isfinite(opened.volume.recipeSpacing_mm))
    problems.push_back(wrongField("volume.recipe_spacing_mm", say<"not a number">(), say<"from 0.1 to 10 mm">()));
  checkVolume(opened, problems);
  if (opened.sealed) checkNamed(fileOfCase, opened, opened.sealed->file, "sealed.file", problems);
  checkTargets(opened, problems);
  checkMeasurements(opened, problems);
  checkImages(opened, problems);
  checkMannequin(opened, problems);
  return problems;
}

Problems checkCase(const Case& edited) {
  Problems problems;
  const ValueRules rules(problems);
  rules.text("id", edited.id);
  rules.text("title", edited.title);
  rules.textIfAny("title_for_trainees", edited.titleForTrainees);
  rules.text("region", edited.region);
  checkPatient(rules.in("patient"), edited.patient);
  rules.list("previous_examinations", edited.previousExaminations.size(),
             [&](const ValueRules& item, std::size_t n) { item.texts("pictures", edited.previousExaminations[n].images); });
  rules.list("laboratory", edited.laboratory.size(), [](const ValueRules&, std::size_t) {});
  rules.texts("findings", edited.findings);
  rules.texts("differential", edited.differential);
  rules.number("difficulty", edited.difficulty);
  rules.texts("tags", edited.tags);
  rules.list("targets", edited.targets.size(), [&](const ValueRules& item, std::size_t n) { checkTargetFields(item, edited.targets[n]); });
  rules.list("measurements", edited.measurements.size(),
             [&](const ValueRules& item, std::size_t n) { checkMeasurementFields(item, edited.measurements[n]); });
  checkVolumeFields(rules.in("volume"), edited.volume);
  rules.texts("probes", edited.probes);
  if (edited.sealed) {
    rules.in("sealed").text("file", edited.sealed->file);
    rules.in("sealed").text("sha256", edited.sealed->sha256);
  }
  for (Error& problem : schemaProblems(edited.otherFields, SchemaName::caseOtherFields, verbatim(kManifestName)))
    problems.push_back(std::move(problem));
  for (Error& problem : problemsOfScene(edited.scene)) problems.push_back(std::move(problem));
  // As for a manifest: whether fields go together is asked of those that can be used.
  return problems.empty() ? problemsBetweenFields(edited) : problems;
}

}  // namespace ew
