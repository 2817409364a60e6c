#include "manifest.h"

#include <array>
#include <cmath>
#include <string_view>

#include "ew/imaging/settings_json.h"
#include "ew/library/schema.h"

namespace ew {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::array<std::string_view, 13> kTopFields = {"format",    "id",     "title",     "region", "patient", "history",   "indication",
                                                         "diagnosis", "volume", "mannequin", "probes", "scene",   "start_pose"};
constexpr std::array<std::string_view, 3> kPatientFields = {"name", "sex", "age_years"};
constexpr std::array<std::string_view, 5> kVolumeFields = {"file", "labels", "recipe", "recipe_spacing_mm", "file_to_world"};
constexpr const char* kSceneName = "the scene of case.json";

template <class Names>
json without(json object, const Names& names) {
  for (const auto name : names) object.erase(std::string(name));
  return object;
}

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
  if (manifest.contains("scene")) {
    json rest;
    if (sceneFromJson(manifest["scene"], kSceneName, &rest) && !rest.empty()) unknown["scene"] = std::move(rest);
  }
  return unknown;
}

glm::dmat4 matrixOf(const json& sixteen) {
  std::array<double, 16> rows{};
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = sixteen[i].get<double>();
  return matrixFromRows(rows);
}

void checkMatrix(const json& owner, const char* key, const std::string& field, std::vector<Error>& problems) {
  if (!owner.contains(key)) return;
  if (auto rigid = checkRigid(matrixOf(owner[key])); !rigid) {
    Error problem = rigid.error();
    problem.sentence = "'" + field + "' in " + kManifestName + " cannot be used. " + problem.sentence;
    problem.context.insert(problem.context.begin(), {"field", field});
    problems.push_back(std::move(problem));
  }
}

void checkFile(const std::filesystem::path& folder, const json& owner, const char* key, const std::string& field,
               std::vector<Error>& problems) {
  if (!owner.contains(key)) return;
  if (auto file = fileOfCase(folder, owner[key].get<std::string>(), field); !file) problems.push_back(file.error());
}

/// The default mannequin and those of the program need no file in the case folder.
void checkMannequin(const std::filesystem::path& folder, const json& manifest, std::vector<Error>& problems) {
  const std::string name = manifest.value("mannequin", std::string());
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
                      "The mannequin '" + name +
                          "' is neither in the case folder nor among the program's own; put the file into the case "
                          "folder or leave the field empty.",
                      {{"field", "mannequin"}, {"found", name}}});
}

}  // namespace

std::vector<Error> checkManifest(const json& manifest, const std::filesystem::path& folder) {
  if (manifest.is_object() && manifest.contains("format") && manifest["format"].is_number_integer() &&
      manifest["format"].get<double>() > kCaseFormat) {
    const std::string found = manifest["format"].dump();
    return {{ErrorCode::newerFormat,
             std::string(kManifestName) + " has format " + found + ", and this program reads formats up to " + std::to_string(kCaseFormat) +
                 "; open it with a newer EchoWeave.",
             {{"field", "format"}, {"found", found}, {"expected", "at most " + std::to_string(kCaseFormat)}}}};
  }
  auto problems = schemaProblems(manifest, SchemaName::caseManifest, kManifestName);
  // What follows reads the fields as the types the schema promises.
  if (!problems.empty()) return problems;

  const json& volume = manifest["volume"];
  checkMatrix(volume, "file_to_world", "volume.file_to_world", problems);
  checkMatrix(manifest, "start_pose", "start_pose", problems);
  if (volume.contains("recipe_spacing_mm") && !std::isfinite(volume["recipe_spacing_mm"].get<double>()))
    problems.push_back({ErrorCode::badField,
                        "'volume.recipe_spacing_mm' in case.json is not a number; it must be from 0.1 to 10 mm.",
                        {{"field", "volume.recipe_spacing_mm"}}});
  if (manifest.contains("scene")) {
    json unknown;
    if (auto scene = sceneFromJson(manifest["scene"], kSceneName, &unknown); !scene) {
      Error problem = std::move(scene.error());
      for (auto& [key, value] : problem.context)
        if (key == "field") value.insert(0, "scene.");
      problems.push_back(std::move(problem));
    }
  }
  checkFile(folder, volume, "file", "volume.file", problems);
  checkFile(folder, volume, "labels", "volume.labels", problems);
  if (volume.contains("labels") && volume.contains("recipe"))
    problems.push_back({ErrorCode::badField,
                        "'volume.labels' in case.json stands beside a recipe, which makes its own labels; take one of them out.",
                        {{"field", "volume.labels"}, {"expected", "no labels beside a recipe"}}});
  checkFile(folder, volume, "recipe", "volume.recipe", problems);
  checkMannequin(folder, manifest, problems);
  return problems;
}

Result<Case> caseFromManifest(const json& manifest, const std::filesystem::path& folder) {
  if (auto problems = checkManifest(manifest, folder); !problems.empty()) return passOn(std::move(problems.front()));
  Case made;
  made.id = manifest["id"];
  made.title = manifest["title"];
  made.region = manifest.value("region", "");
  if (manifest.contains("patient")) {
    const json& patient = manifest["patient"];
    made.patient.name = patient.value("name", "");
    made.patient.sex = patient.value("sex", "");
    if (patient.contains("age_years")) made.patient.age_years = patient["age_years"].get<int>();
  }
  made.history = manifest.value("history", "");
  made.indication = manifest.value("indication", "");
  made.diagnosis = manifest.value("diagnosis", "");
  const json& volume = manifest["volume"];
  made.volume.file = volume.value("file", "");
  made.volume.labels = volume.value("labels", "");
  made.volume.recipe = volume.value("recipe", "");
  made.volume.recipeSpacing_mm = volume.value("recipe_spacing_mm", 1.0);
  if (volume.contains("file_to_world")) made.volume.fileToWorld = matrixOf(volume["file_to_world"]);
  made.mannequin = manifest.value("mannequin", "");
  if (manifest.contains("probes")) made.probes = manifest["probes"].get<std::vector<std::string>>();
  if (manifest.contains("scene")) {
    json unknown;
    auto scene = sceneFromJson(manifest["scene"], kSceneName, &unknown);
    if (!scene) return passOn(std::move(scene.error()));
    made.scene = std::move(*scene);
  }
  if (manifest.contains("start_pose")) {
    made.startPose.emplace();
    made.startPose->probeToWorld.matrix = matrixOf(manifest["start_pose"]);
  }
  made.otherFields = unknownFields(manifest);
  made.folder = folder;
  return made;
}

ordered_json orderedManifestOf(const Case& edited) {
  ordered_json manifest;
  const auto text = [&](const char* field, const std::string& value) {
    if (!value.empty()) manifest[field] = value;
  };
  manifest["format"] = kCaseFormat;
  manifest["id"] = edited.id;
  manifest["title"] = edited.title;
  text("region", edited.region);
  ordered_json patient = ordered_json::object();
  if (!edited.patient.name.empty()) patient["name"] = edited.patient.name;
  if (!edited.patient.sex.empty()) patient["sex"] = edited.patient.sex;
  if (edited.patient.age_years) patient["age_years"] = *edited.patient.age_years;
  if (!patient.empty()) manifest["patient"] = patient;
  text("history", edited.history);
  text("indication", edited.indication);
  text("diagnosis", edited.diagnosis);
  ordered_json volume = ordered_json::object();
  if (!edited.volume.file.empty()) volume["file"] = edited.volume.file;
  if (!edited.volume.labels.empty()) volume["labels"] = edited.volume.labels;
  if (!edited.volume.recipe.empty()) volume["recipe"] = edited.volume.recipe;
  if (!edited.volume.recipe.empty() || edited.volume.recipeSpacing_mm != 1.0) volume["recipe_spacing_mm"] = edited.volume.recipeSpacing_mm;
  volume["file_to_world"] = rowsOf(edited.volume.fileToWorld);
  manifest["volume"] = volume;
  text("mannequin", edited.mannequin);
  if (!edited.probes.empty()) manifest["probes"] = edited.probes;
  manifest["scene"] = ordered_json(toJson(edited.scene, edited.otherFields.contains("scene") ? &edited.otherFields["scene"] : nullptr));
  if (edited.startPose) manifest["start_pose"] = rowsOf(edited.startPose->probeToWorld.matrix);

  const auto addMissing = [](ordered_json& into, const json& from) {
    for (const auto& [key, value] : from.items())
      if (!into.contains(key)) into[key] = ordered_json(value);
  };
  for (const char* nested : {"patient", "volume"})
    if (manifest.contains(nested) && edited.otherFields.contains(nested)) addMissing(manifest[nested], edited.otherFields[nested]);
  addMissing(manifest, edited.otherFields);
  return manifest;
}

json manifestOf(const Case& edited) { return json(orderedManifestOf(edited)); }

}  // namespace ew
