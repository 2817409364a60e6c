#include "case/manifest.h"

#include <array>
#include <cmath>
#include <string_view>

#include "case/echo_files.h"
#include "ew/acquisition/reconstruct_words.h"
#include "ew/core/foreign_json.h"
#include "ew/core/json_fields.h"
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
constexpr std::array<std::string_view, 8> kVolumeFields = {"file",   "labels",      "level",        "recipe", "recipe_spacing_mm",
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
Message sceneName() { return say<"the scene of case.json">(); }

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

void checkMatrix(const json& owner, const char* key, const std::string& place, std::vector<Error>& problems) {
  JsonReading reading(verbatim(kManifestName));
  JsonFields(owner, reading, place).rigid(key);
  if (reading.problem()) problems.push_back(*reading.problem());
}

Error wrongField(const std::string& field, const Message& found, const Message& expected) {
  return fieldError(verbatim(kManifestName), field, found, expected);
}

/// What the schema cannot say: each kind of target has fields of its own.
void checkTargets(const json& manifest, std::vector<Error>& problems) {
  if (!manifest.contains("targets")) return;
  for (std::size_t n = 0; n < manifest["targets"].size(); ++n) {
    const json& target = manifest["targets"][n];
    const std::string field = "targets[" + std::to_string(n) + "]";
    const std::string kind = target["kind"];
    if (kind == "point" && !target.contains("at_mm"))
      problems.push_back(wrongField(field + ".at_mm", say<"missing">(), say<"three numbers, mm in the world">()));
    const bool hasRecipe = manifest["volume"].contains("recipe");
    if (kind == "structure" && !target.contains("organ") && !target.contains("label"))
      problems.push_back(wrongField(
          field + (hasRecipe ? ".organ" : ".label"), say<"missing">(),
          hasRecipe ? say<"the name of an organ of the patient">() : say<"the number of the structure in the labels of the volume">()));
    if (target.contains("label") && !manifest["volume"].contains("labels"))
      problems.push_back(
          wrongField(field + ".label", say<"given, and the case has no labels">(), say<"left out, or a number of volume.labels">()));
    if (kind == "plane" && !target.contains("probe_to_world") && !hasRecipe)
      problems.push_back(
          wrongField(field, say<"a plane of a patient, and the case has no recipe">(), say<"a plane with probe_to_world">()));
    if (kind == "structure" && target.contains("organ") && !hasRecipe)
      problems.push_back(wrongField(field, say<"a structure of a patient, and the case has no recipe">(),
                                    say<"a structure with a label, or a point or a plane">()));
    checkMatrix(target, "probe_to_world", field, problems);
  }
}

void checkMeasurements(const json& manifest, std::vector<Error>& problems) {
  if (!manifest.contains("measurements") || manifest["volume"].contains("recipe")) return;
  for (std::size_t n = 0; n < manifest["measurements"].size(); ++n)
    if (!manifest["measurements"][n].contains("value"))
      problems.push_back(wrongField("measurements[" + std::to_string(n) + "].value",
                                    say<"missing, and the case has no patient who could know it">(),
                                    say<"the value as it was measured">()));
}

void checkPictures(const std::filesystem::path& folder, const json& manifest, std::vector<Error>& problems) {
  if (!manifest.contains("previous_examinations")) return;
  for (std::size_t n = 0; n < manifest["previous_examinations"].size(); ++n) {
    const json& examination = manifest["previous_examinations"][n];
    if (!examination.contains("pictures")) continue;
    const std::string field = "previous_examinations[" + std::to_string(n) + "].pictures";
    for (const json& picture : examination["pictures"])
      if (auto file = fileOfCase(folder, picture.get<std::string>(), field); !file) problems.push_back(file.error());
  }
}

void checkFile(const std::filesystem::path& folder, const json& owner, const char* key, const std::string& field,
               std::vector<Error>& problems) {
  if (!owner.contains(key)) return;
  if (auto file = fileOfCase(folder, owner[key].get<std::string>(), field); !file) problems.push_back(file.error());
}

void checkVolumeFile(const std::filesystem::path& folder, const json& owner, const char* key, const std::string& field,
                     std::vector<Error>& problems) {
  if (!owner.contains(key)) return;
  if (auto file = volumeOfCase(folder, owner[key].get<std::string>(), field); !file) problems.push_back(file.error());
}

/// The default mannequin and those of the program need no file in the case folder.
void checkMannequin(const std::filesystem::path& folder, const json& manifest, std::vector<Error>& problems) {
  const std::string name = textAt(manifest, "mannequin");
  if (name.empty()) return;
  auto own = fileOfCase(folder, name, "mannequin");
  if (own || own.error().code != ErrorCode::notFound) {
    if (!own) problems.push_back(own.error());
    return;
  }
  std::error_code ignored;
  const auto resources = resourceFolder();
  if (folder.empty() || (resources && std::filesystem::exists(*resources / "mannequin" / name, ignored))) return;
  problems.push_back({ErrorCode::notFound,
                      say<"The mannequin '%1' is neither in the case folder nor among the program's own; put the file into the case folder "
                          "or leave the field empty.">(name),
                      {{"field", "mannequin"}, {"found", name}}});
}

}  // namespace

const char* nameOf(CaseTarget::Kind kind) {
  switch (kind) {
    case CaseTarget::Kind::point:
      return "point";
    case CaseTarget::Kind::plane:
      return "plane";
    case CaseTarget::Kind::structure:
      return "structure";
  }
  return "";
}

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

std::vector<Error> checkManifest(const json& given, const std::filesystem::path& folder) {
  const json manifest = ofToday(given);
  if (manifest.is_object() && manifest.contains("format") && manifest["format"].is_number_integer() &&
      manifest["format"].get<double>() > kCaseFormat) {
    const std::string found = manifest["format"].dump();
    return {{ErrorCode::newerFormat,
             say<"%1 has format %2, and this program reads formats up to %3; open it with a newer EchoWeave.">(std::string(kManifestName),
                                                                                                               found, kCaseFormat),
             {{"field", "format"}, {"found", found}, {"expected", "at most " + std::to_string(kCaseFormat)}}}};
  }
  auto problems = schemaProblems(manifest, SchemaName::caseManifest, verbatim(kManifestName));
  // What follows reads the fields as the types the schema promises.
  if (!problems.empty()) return problems;

  const json& volume = manifest["volume"];
  checkMatrix(volume, "file_to_world", "volume", problems);
  for (const char* pose : {"start_pose", "expert_pose"}) checkMatrix(manifest, pose, {}, problems);
  if (volume.contains("recipe_spacing_mm") && !std::isfinite(volume["recipe_spacing_mm"].get<double>()))
    problems.push_back(wrongField("volume.recipe_spacing_mm", say<"not a number">(), say<"from 0.1 to 10 mm">()));
  if (manifest.contains("scene")) {
    json unknown;
    if (auto scene = sceneFromJson(manifest["scene"], sceneName(), &unknown); !scene) {
      Error problem = std::move(scene.error());
      for (auto& [key, value] : problem.context)
        if (key == "field") value.insert(0, "scene.");
      problems.push_back(std::move(problem));
    }
  }
  checkVolumeFile(folder, volume, "file", "volume.file", problems);
  checkVolumeFile(folder, volume, "labels", "volume.labels", problems);
  if (volume.contains("labels") && volume.contains("recipe"))
    problems.push_back({ErrorCode::badField,
                        say<"'volume.labels' in case.json stands beside a recipe, which makes its own labels; take one of them out.">(),
                        {{"field", "volume.labels"}, {"expected", "no labels beside a recipe"}}});
  checkFile(folder, volume, "frames", "volume.frames", problems);
  if (volume.contains("frames") && !volume.contains("file"))
    problems.push_back({ErrorCode::badField,
                        say<"'volume.frames' in case.json stands without the volume that was made of them; take it out.">(),
                        {{"field", "volume.frames"}, {"expected", "beside volume.file"}}});
  checkVolumeFile(folder, volume, "level", "volume.level", problems);
  if (volume.contains("level") && volume.contains("recipe"))
    problems.push_back({ErrorCode::badField,
                        say<"'volume.level' in case.json stands beside a recipe, which makes its own level; take one of them out.">(),
                        {{"field", "volume.level"}, {"expected", "no level beside a recipe"}}});
  for (Error& problem : problemsOfEchoes(manifest, folder)) problems.push_back(std::move(problem));
  checkFile(folder, volume, "recipe", "volume.recipe", problems);
  if (volume.contains("sweeps")) {
    if (!volume.contains("recipe"))
      problems.push_back(
          wrongField("volume.sweeps", say<"given without a recipe">(), say<"left out, or beside the recipe whose patient is swept">()));
    for (std::size_t n = 0; n < volume["sweeps"].size(); ++n) {
      const std::string field = "volume.sweeps[" + std::to_string(n) + "]";
      if (auto file = fileOfCase(folder, volume["sweeps"][n].get<std::string>(), field); !file) problems.push_back(file.error());
    }
  } else if (volume.contains("reconstruct")) {
    problems.push_back(
        wrongField("volume.reconstruct", say<"given without sweeps">(), say<"left out, or beside the sweeps it is about">()));
  }
  if (manifest.contains("sealed")) checkFile(folder, manifest["sealed"], "file", "sealed.file", problems);
  checkTargets(manifest, problems);
  checkMeasurements(manifest, problems);
  checkPictures(folder, manifest, problems);
  checkMannequin(folder, manifest, problems);
  return problems;
}

namespace {

CaseReconstruction reconstructionOf(const json& object) {
  CaseReconstruction made;
  if (object.contains("spacing_mm")) made.spacing_mm = object["spacing_mm"].get<double>();
  made.interpolation = meaningOf(kInterpolationWords, textAt(object, "interpolation"));
  made.compounding = meaningOf(kCompoundingWords, textAt(object, "compounding"));
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
  if (reconstruct.interpolation) object["interpolation"] = wordOf(kInterpolationWords, *reconstruct.interpolation);
  if (reconstruct.compounding) object["compounding"] = wordOf(kCompoundingWords, *reconstruct.compounding);
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
    if (!each.pictures.empty()) object["pictures"] = each.pictures;
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

}  // namespace

Result<Case> caseFromManifest(const json& given, const std::filesystem::path& folder) {
  const json manifest = ofToday(given);
  if (auto problems = checkManifest(manifest, folder); !problems.empty()) return passOn(std::move(problems.front()));
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
  const json& volume = manifest["volume"];
  made.volume.file = textAt(volume, "file");
  made.volume.labels = textAt(volume, "labels");
  made.volume.frames = textAt(volume, "frames");
  made.volume.level = textAt(volume, "level");
  made.volume.recipe = textAt(volume, "recipe");
  made.volume.recipeSpacing_mm = numberAt(volume, "recipe_spacing_mm").value_or(1.0);
  if (volume.contains("sweeps")) made.volume.sweeps = volume["sweeps"].get<std::vector<std::string>>();
  if (volume.contains("reconstruct")) made.volume.reconstruct = reconstructionOf(volume["reconstruct"]);
  if (volume.contains("file_to_world")) made.volume.fileToWorld = transformOf<frame::World, frame::File>(volume["file_to_world"]);
  made.mannequin = textAt(manifest, "mannequin");
  if (manifest.contains("probes")) made.probes = manifest["probes"].get<std::vector<std::string>>();
  if (manifest.contains("scene")) {
    json unknown;
    auto scene = sceneFromJson(manifest["scene"], sceneName(), &unknown);
    if (!scene) return passOn(std::move(scene.error()));
    made.scene = std::move(*scene);
  }
  made.startPose = poseIn(manifest, "start_pose");
  made.expertPose = poseIn(manifest, "expert_pose");
  if (manifest.contains("sealed"))
    made.sealed = {manifest["sealed"]["file"].get<std::string>(), manifest["sealed"]["sha256"].get<std::string>()};
  made.otherFields = unknownFields(manifest);
  made.folder = folder;
  return made;
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
