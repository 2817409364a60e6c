#include "case/manifest.h"

#include <array>
#include <string_view>

#include "ew/acquisition/reconstruct_words.h"
#include "ew/core/contract.h"
#include "ew/core/foreign_json.h"
#include "ew/core/json_fields.h"
#include "ew/core/responsive_thread.h"
#include "ew/imaging/settings_json.h"
#include "ew/library/schema.h"
#include "ew/stitching/project.h"
#include "files/json_rest.h"

namespace ew {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::array<std::string_view, 25> kTopFields = {"format",       "id",           "title",       "title_for_trainees",
                                                         "region",       "patient",      "complaint",   "history",
                                                         "indication",   "laboratory",   "findings",    "diagnosis",
                                                         "targets",      "differential", "difficulty",  "tags",
                                                         "measurements", "volume",       "mannequin",   "probes",
                                                         "scene",        "start_pose",   "expert_pose", "previous_examinations",
                                                         "sealed"};
constexpr std::array<std::string_view, 3> kPatientFields = {"name", "sex", "age_years"};
constexpr std::array<std::string_view, 9> kVolumeFields = {"file",   "labels",      "frames",       "level", "recipe", "recipe_spacing_mm",
                                                           "sweeps", "reconstruct", "file_to_world"};
constexpr std::array<std::string_view, 7> kReconstructFields = {"spacing_mm", "interpolation", "compounding",      "fill_reach_mm",
                                                                "seam",       "feather_mm",    "labels_spacing_mm"};
constexpr std::array<std::string_view, 4> kExaminationFields = {"when", "kind", "findings", "pictures"};
constexpr std::array<std::string_view, 2> kLaboratoryFields = {"when", "findings"};
constexpr std::array<std::string_view, 10> kTargetFields = {
    "kind",  "name",  "at_mm",          "tolerance_mm", "probe_to_world", "position_tolerance_mm", "angle_tolerance_deg",
    "organ", "label", "reveals_finding"};
constexpr std::array<std::string_view, 7> kMeasurementFields = {"name", "tolerance", "value",          "kind",
                                                                "unit", "points_mm", "reveals_finding"};
/// What the program does not know, at the top and inside the objects it does know.
json unknownFields(const json& manifest) {
  json unknown = without(manifest, kTopFields);
  const auto keep = [&](const char* field, const auto& known) {
    if (!manifest.contains(field)) return;
    json rest = without(manifest[field], known);
    if (!rest.empty()) unknown[field] = std::move(rest);
  };
  keep("patient", kPatientFields);
  keep("volume", kVolumeFields);
  if (manifest["volume"].contains("reconstruct")) {
    json rest = without(manifest["volume"]["reconstruct"], kReconstructFields);
    if (!rest.empty()) unknown["volume"]["reconstruct"] = std::move(rest);
  }
  if (manifest.contains("scene")) {
    json rest;
    if (sceneFromJson(manifest["scene"], sceneName(), &rest) && !rest.empty()) unknown["scene"] = std::move(rest);
  }
  return unknown;
}

template <class To, class From>
Transform<To, From> transformOf(const json& sixteen) {
  std::array<double, 16> rows{};
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = sixteen[i].get<double>();
  return {matrixFromRows(rows)};
}

}  // namespace

json ofToday(const json& manifest) {
  if (!manifest.is_object() || !manifest.contains("format") || manifest["format"] != 1) return manifest;
  json migrated = manifest;
  migrated["format"] = 2;
  if (!manifest.contains("previous_examinations") || !manifest["previous_examinations"].is_array()) return migrated;
  json examinations = json::array(), laboratory = json::array();
  for (json each : manifest["previous_examinations"]) {
    const bool isLaboratory = each.is_object() && each.contains("kind") && each["kind"] == "laboratory";
    if (isLaboratory) each.erase("kind");
    (isLaboratory ? laboratory : examinations).push_back(std::move(each));
  }
  if (laboratory.empty()) return migrated;
  if (migrated.contains("laboratory") && migrated["laboratory"].is_array())
    laboratory.insert(laboratory.begin(), migrated["laboratory"].begin(), migrated["laboratory"].end());
  migrated["laboratory"] = std::move(laboratory);
  migrated.erase("previous_examinations");
  if (!examinations.empty()) migrated["previous_examinations"] = std::move(examinations);
  return migrated;
}

namespace {

CaseReconstruction reconstructionOf(const json& object) {
  CaseReconstruction made;
  if (object.contains("spacing_mm")) made.spacing_mm = object["spacing_mm"].get<double>();
  made.interpolation = meaningIn(kInterpolationWords, textAt(object, "interpolation"));
  made.compounding = meaningIn(kCompoundingWords, textAt(object, "compounding"));
  if (object.contains("fill_reach_mm")) made.fillReach_mm = object["fill_reach_mm"].get<double>();
  const std::string seam = textAt(object, "seam", stitching::nameOf(made.seam));
  for (const auto method : {stitching::SeamMethod::feather, stitching::SeamMethod::nearest, stitching::SeamMethod::graphCut})
    if (seam == stitching::nameOf(method)) made.seam = method;
  made.feather_mm = numberAt(object, "feather_mm").value_or(made.feather_mm);
  made.labelsSpacing_mm = numberAt(object, "labels_spacing_mm").value_or(made.labelsSpacing_mm);
  return made;
}

ordered_json toJson(const CaseReconstruction& reconstruct) {
  ordered_json object = ordered_json::object();
  if (reconstruct.spacing_mm) object["spacing_mm"] = *reconstruct.spacing_mm;
  if (reconstruct.interpolation) object["interpolation"] = wordIn(kInterpolationWords, *reconstruct.interpolation);
  if (reconstruct.compounding) object["compounding"] = wordIn(kCompoundingWords, *reconstruct.compounding);
  if (reconstruct.fillReach_mm) object["fill_reach_mm"] = *reconstruct.fillReach_mm;
  object["seam"] = stitching::nameOf(reconstruct.seam);
  object["feather_mm"] = reconstruct.feather_mm;
  object["labels_spacing_mm"] = reconstruct.labelsSpacing_mm;
  return object;
}

std::optional<double> numberIn(const json& object, const char* field) {
  if (!object.contains(field)) return std::nullopt;
  return object[field].get<double>();
}

std::optional<Pose> poseIn(const json& object, const char* field) {
  if (!object.contains(field)) return std::nullopt;
  Pose pose;
  pose.probeToWorld = transformOf<frame::World, frame::Probe>(object[field]);
  return pose;
}

CaseTarget targetOf(const json& object) {
  CaseTarget target;
  const std::string kind = object["kind"];
  target.kind = kind == "point" ? CaseTarget::Kind::point : kind == "plane" ? CaseTarget::Kind::plane : CaseTarget::Kind::structure;
  target.name = object["name"];
  if (object.contains("at_mm")) target.at_mm = glm::dvec3(object["at_mm"][0], object["at_mm"][1], object["at_mm"][2]);
  target.tolerance_mm = numberIn(object, "tolerance_mm");
  if (object.contains("probe_to_world")) target.probeToFile = transformOf<frame::File, frame::Probe>(object["probe_to_world"]);
  target.positionTolerance_mm = numberIn(object, "position_tolerance_mm");
  target.angleTolerance_deg = numberIn(object, "angle_tolerance_deg");
  target.organ = textAt(object, "organ");
  if (object.contains("label")) target.label = object["label"].get<int>();
  target.revealsFinding = flagAt(object, "reveals_finding");
  target.otherFields = without(object, kTargetFields);
  return target;
}

void add(ordered_json& into, const json& others) {
  for (const auto& [key, value] : others.items())
    if (!into.contains(key)) into[key] = ordered_json(value);
}

ordered_json toJson(const CaseTarget& target) {
  ordered_json object = {{"kind", nameOf(target.kind)}, {"name", target.name}};
  if (target.at_mm) object["at_mm"] = {target.at_mm->x, target.at_mm->y, target.at_mm->z};
  if (target.tolerance_mm) object["tolerance_mm"] = *target.tolerance_mm;
  if (target.probeToFile) object["probe_to_world"] = rowsOf(*target.probeToFile);
  if (target.positionTolerance_mm) object["position_tolerance_mm"] = *target.positionTolerance_mm;
  if (target.angleTolerance_deg) object["angle_tolerance_deg"] = *target.angleTolerance_deg;
  if (!target.organ.empty()) object["organ"] = target.organ;
  if (target.label) object["label"] = *target.label;
  if (target.revealsFinding) object["reveals_finding"] = true;
  add(object, target.otherFields);
  return object;
}

CaseMeasurement measurementOf(const json& object) {
  CaseMeasurement measurement;
  measurement.name = object["name"];
  measurement.tolerance = numberIn(object, "tolerance");
  measurement.value = numberIn(object, "value");
  measurement.kind = textAt(object, "kind");
  measurement.unit = textAt(object, "unit");
  for (const json& point : listAt(object, "points_mm")) measurement.points_mm.push_back({point[0], point[1], point[2]});
  measurement.revealsFinding = flagAt(object, "reveals_finding");
  measurement.otherFields = without(object, kMeasurementFields);
  return measurement;
}

/// History, earlier findings and what is expected: everything a lesson asks about.
void readExpectations(const json& manifest, Case& made) {
  for (const json& each : listAt(manifest, "previous_examinations"))
    made.previousExaminations.push_back({textAt(each, "when"), textAt(each, "kind"), textAt(each, "findings"), textsAt(each, "pictures"),
                                         without(each, kExaminationFields)});
  for (const json& each : listAt(manifest, "laboratory"))
    made.laboratory.push_back({textAt(each, "when"), textAt(each, "findings"), without(each, kLaboratoryFields)});
  if (manifest.contains("findings")) made.findings = manifest["findings"].get<std::vector<std::string>>();
  for (const json& each : listAt(manifest, "targets")) made.targets.push_back(targetOf(each));
  for (const json& each : listAt(manifest, "measurements")) made.measurements.push_back(measurementOf(each));
}

ordered_json examinationsOf(const Case& edited) {
  ordered_json list = ordered_json::array();
  for (const CaseExamination& each : edited.previousExaminations) {
    ordered_json object = ordered_json::object();
    if (!each.when.empty()) object["when"] = each.when;
    if (!each.kind.empty()) object["kind"] = each.kind;
    if (!each.findings.empty()) object["findings"] = each.findings;
    if (!each.images.empty()) object["pictures"] = each.images;
    add(object, each.otherFields);
    list.push_back(std::move(object));
  }
  return list;
}

ordered_json laboratoryOf(const Case& edited) {
  ordered_json list = ordered_json::array();
  for (const CaseLaboratory& each : edited.laboratory) {
    ordered_json object = ordered_json::object();
    if (!each.when.empty()) object["when"] = each.when;
    if (!each.findings.empty()) object["findings"] = each.findings;
    add(object, each.otherFields);
    list.push_back(std::move(object));
  }
  return list;
}

ordered_json measurementsOf(const Case& edited) {
  ordered_json list = ordered_json::array();
  for (const CaseMeasurement& each : edited.measurements) {
    ordered_json object = {{"name", each.name}};
    if (each.tolerance) object["tolerance"] = *each.tolerance;
    if (each.value) object["value"] = *each.value;
    if (!each.kind.empty()) object["kind"] = each.kind;
    if (!each.unit.empty()) object["unit"] = each.unit;
    for (const glm::dvec3& p_mm : each.points_mm) object["points_mm"].push_back({p_mm.x, p_mm.y, p_mm.z});
    if (each.revealsFinding) object["reveals_finding"] = true;
    add(object, each.otherFields);
    list.push_back(std::move(object));
  }
  return list;
}

CaseVolume caseVolumeOf(const json& object) {
  CaseVolume volume;
  volume.file = textAt(object, "file");
  volume.labels = textAt(object, "labels");
  volume.frames = textAt(object, "frames");
  volume.level = textAt(object, "level");
  volume.recipe = textAt(object, "recipe");
  volume.recipeSpacing_mm = numberAt(object, "recipe_spacing_mm").value_or(1.0);
  volume.sweeps = textsAt(object, "sweeps");
  if (object.contains("reconstruct")) volume.reconstruct = reconstructionOf(object["reconstruct"]);
  if (object.contains("file_to_world")) volume.fileToWorld = transformOf<frame::World, frame::File>(object["file_to_world"]);
  return volume;
}

/// The scene of a manifest. What it cannot be is told with the place that it has there.
Result<Scene> sceneIn(const json& manifest) {
  if (!manifest.contains("scene")) return Scene{};
  json unknown;
  auto scene = sceneFromJson(manifest["scene"], sceneName(), &unknown);
  return scene ? std::move(scene) : passOn(inScene(std::move(scene.error())));
}

/// What a manifest says that conforms to the schema, whether it can be used or not.
Case valuesIn(const json& manifest, Scene scene, const std::filesystem::path& folder) {
  Case made;
  made.id = manifest["id"];
  made.title = manifest["title"];
  made.titleForTrainees = textAt(manifest, "title_for_trainees");
  made.region = textAt(manifest, "region");
  if (manifest.contains("patient")) {
    const json& patient = manifest["patient"];
    made.patient.name = textAt(patient, "name");
    made.patient.sex = textAt(patient, "sex");
    if (patient.contains("age_years")) made.patient.age_years = patient["age_years"].get<int>();
  }
  made.complaint = textAt(manifest, "complaint");
  made.history = textAt(manifest, "history");
  made.indication = textAt(manifest, "indication");
  made.diagnosis = textAt(manifest, "diagnosis");
  made.differential = textsAt(manifest, "differential");
  if (manifest.contains("difficulty")) made.difficulty = manifest["difficulty"].get<int>();
  made.tags = textsAt(manifest, "tags");
  readExpectations(manifest, made);
  made.volume = caseVolumeOf(manifest["volume"]);
  made.mannequin = textAt(manifest, "mannequin");
  made.probes = textsAt(manifest, "probes");
  made.scene = std::move(scene);
  made.startPose = poseIn(manifest, "start_pose");
  made.expertPose = poseIn(manifest, "expert_pose");
  if (manifest.contains("sealed"))
    made.sealed = {manifest["sealed"]["file"].get<std::string>(), manifest["sealed"]["sha256"].get<std::string>()};
  made.otherFields = unknownFields(manifest);
  made.folder = folder;
  return made;
}

/// What a manifest says, and everything that is wrong with it, in which case the values are of no use.
struct ManifestContent {
  Case values;
  std::vector<Error> problems;
};

ManifestContent readCaseManifest(const json& given, const std::filesystem::path& folder) {
  const json manifest = ofToday(given);
  if (manifest.is_object() && manifest.contains("format") && manifest["format"].is_number_integer() &&
      manifest["format"].get<double>() > kCaseFormat) {
    const std::string found = manifest["format"].dump();
    return {{},
            {{ErrorCode::newerFormat,
              say<"%1 has format %2, and this program reads formats up to %3; open it with a newer EchoWeave.">(std::string(kManifestName),
                                                                                                                found, kCaseFormat),
              {{"field", "format"}, {"found", found}, {"expected", "at most " + std::to_string(kCaseFormat)}}}}};
  }
  // What follows reads the fields as the types the schema promises.
  if (auto problems = schemaProblems(manifest, SchemaName::caseManifest, verbatim(kManifestName)); !problems.empty())
    return {{}, std::move(problems)};
  auto scene = sceneIn(manifest);
  ManifestContent made{valuesIn(manifest, scene.value_or(Scene{}), folder), {}};
  if (!scene) made.problems.push_back(std::move(scene.error()));
  if (manifest["volume"].contains("reconstruct") && made.values.volume.sweeps.empty())
    made.problems.push_back(fieldError(verbatim(kManifestName), "volume.reconstruct", say<"given without sweeps">(),
                                       say<"left out, or beside the sweeps it is about">()));
  for (Error& problem : problemsBetweenFields(made.values)) made.problems.push_back(std::move(problem));
  return made;
}

}  // namespace

std::vector<Error> checkManifest(const json& manifest, const std::filesystem::path& folder) {
  return readCaseManifest(manifest, folder).problems;
}

Result<Case> caseFromManifest(const json& manifest, const std::filesystem::path& folder) {
  EW_EXPECTS(!isResponsiveThread());
  ManifestContent made = readCaseManifest(manifest, folder);
  if (!made.problems.empty()) return passOn(std::move(made.problems.front()));
  return std::move(made.values);
}

Result<Case> valuesOfTemplate(const json& manifest) {
  ManifestContent made = readCaseManifest(manifest, {});
  if (!made.problems.empty()) return passOn(std::move(made.problems.front()));
  return std::move(made.values);
}

ordered_json orderedManifestOf(const Case& edited) {
  ordered_json manifest;
  const auto text = [&](const char* field, const std::string& value) {
    if (!value.empty()) manifest[field] = value;
  };
  manifest["format"] = edited.sealed ? kCaseFormat : kOpenCaseFormat;
  manifest["id"] = edited.id;
  manifest["title"] = edited.title;
  text("title_for_trainees", edited.titleForTrainees);
  text("region", edited.region);
  ordered_json patient = ordered_json::object();
  if (!edited.patient.name.empty()) patient["name"] = edited.patient.name;
  if (!edited.patient.sex.empty()) patient["sex"] = edited.patient.sex;
  if (edited.patient.age_years) patient["age_years"] = *edited.patient.age_years;
  if (!patient.empty()) manifest["patient"] = patient;
  text("complaint", edited.complaint);
  text("history", edited.history);
  text("indication", edited.indication);
  if (!edited.previousExaminations.empty()) manifest["previous_examinations"] = examinationsOf(edited);
  if (!edited.laboratory.empty()) manifest["laboratory"] = laboratoryOf(edited);
  if (!edited.findings.empty()) manifest["findings"] = edited.findings;
  text("diagnosis", edited.diagnosis);
  if (!edited.differential.empty()) manifest["differential"] = edited.differential;
  if (edited.difficulty) manifest["difficulty"] = *edited.difficulty;
  if (!edited.tags.empty()) manifest["tags"] = edited.tags;
  for (const CaseTarget& target : edited.targets) manifest["targets"].push_back(toJson(target));
  if (!edited.measurements.empty()) manifest["measurements"] = measurementsOf(edited);
  ordered_json volume = ordered_json::object();
  if (!edited.volume.file.empty()) volume["file"] = edited.volume.file;
  if (!edited.volume.labels.empty()) volume["labels"] = edited.volume.labels;
  if (!edited.volume.frames.empty()) volume["frames"] = edited.volume.frames;
  if (!edited.volume.level.empty()) volume["level"] = edited.volume.level;
  if (!edited.volume.recipe.empty()) volume["recipe"] = edited.volume.recipe;
  if (!edited.volume.recipe.empty() || edited.volume.recipeSpacing_mm != 1.0) volume["recipe_spacing_mm"] = edited.volume.recipeSpacing_mm;
  if (!edited.volume.sweeps.empty()) {
    volume["sweeps"] = edited.volume.sweeps;
    volume["reconstruct"] = toJson(edited.volume.reconstruct);
  }
  volume["file_to_world"] = rowsOf(edited.volume.fileToWorld);
  manifest["volume"] = volume;
  text("mannequin", edited.mannequin);
  if (!edited.probes.empty()) manifest["probes"] = edited.probes;
  manifest["scene"] = ordered_json(toJson(edited.scene, edited.otherFields.contains("scene") ? &edited.otherFields["scene"] : nullptr));
  if (edited.startPose) manifest["start_pose"] = rowsOf(edited.startPose->probeToWorld.matrix);
  if (edited.expertPose) manifest["expert_pose"] = rowsOf(edited.expertPose->probeToWorld.matrix);

  if (edited.sealed) manifest["sealed"] = {{"file", edited.sealed->file}, {"sha256", edited.sealed->sha256}};

  for (const char* nested : {"patient", "volume"})
    if (manifest.contains(nested) && edited.otherFields.contains(nested)) add(manifest[nested], edited.otherFields[nested]);
  if (manifest["volume"].contains("reconstruct") && edited.otherFields.contains("volume") &&
      edited.otherFields["volume"].contains("reconstruct"))
    add(manifest["volume"]["reconstruct"], edited.otherFields["volume"]["reconstruct"]);
  add(manifest, edited.otherFields);
  return manifest;
}

json manifestOf(const Case& edited) { return json(orderedManifestOf(edited)); }

}  // namespace ew
