#include "ew/library/templates.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "case/manifest.h"
#include "ew/core/json_fields.h"
#include "ew/io/json_files.h"
#include "ew/library/case_start.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kTemplateFormat = 1;

Result<fs::path> templateFolder() {
  const auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  return *resources / "templates";
}

std::vector<Words> wordsList(const JsonFields& fields, const char* key) {
  std::vector<Words> all;
  for (const JsonFields& each : fields.objects(key, 0, 50)) {
    each.only({"en", "de"});
    all.push_back({each.text("en", {}, 1, 600), each.text("de", {}, 1, 600)});
  }
  return all;
}

/// The fields that a template shares with a case, as a manifest of one: so they are checked as those are.
json manifestOfTemplate(const json& document) {
  json manifest = {{"format", kCaseFormat}, {"id", "template"}, {"title", "Template"}, {"volume", json::object()}};
  for (const char* field : {"region", "mannequin", "probes", "scene", "tags", "difficulty"})
    if (document.contains(field)) manifest[field] = document[field];
  return manifest;
}

Result<CaseTemplate> readTemplateFile(const fs::path& file) {
  const Message where = verbatim(file.filename().string());
  const auto document = readJsonFile(file, where);
  if (!document) return passOn(document.error());
  JsonReading reading(where, {"note"});
  const JsonFields fields(*document, reading);
  requireFormat(fields, kTemplateFormat);
  fields.only({"format", "title", "text", "region", "mannequin", "probes", "preset", "scene", "tags", "difficulty", "indications",
               "targets", "lessons", "source"});
  CaseTemplate read;
  read.id = file.stem().string();
  read.title = wordsIn(fields, "title", 100);
  read.text = wordsIn(fields, "text");
  read.preset = fields.text("preset", "", 0);
  read.indications = wordsList(fields, "indications");
  read.targets = wordsList(fields, "targets");
  if (reading.problem()) return passOn(*reading.problem());
  auto prefilled = valuesOfTemplate(manifestOfTemplate(*document));
  if (!prefilled) return passOn(prefilled.error());
  read.prefilled = *std::move(prefilled);
  read.prefilled.id.clear();
  read.prefilled.title.clear();
  if (!document->contains("lessons")) return read;
  auto lessons = lessonsFromJson({{"format", kLessonsFormat}, {"lessons", (*document)["lessons"]}});
  if (!lessons) return passOn(lessons.error());
  read.lessons = *std::move(lessons);
  return read;
}

bool hasLessons(const Case& edited) {
  const json& others = edited.otherFields;
  return others.contains("parts") && others["parts"].is_object() && others["parts"].contains(kLessonsPart);
}

}  // namespace

TemplateList listTemplates() {
  TemplateList list;
  const auto folder = templateFolder();
  const auto files = folder ? jsonFilesIn(*folder, say<"templates">()) : Result<std::vector<fs::path>>(passOn(folder.error()));
  if (!files) {
    list.problems.push_back(files.error());
    return list;
  }
  for (const fs::path& file : *files) {
    auto read = readTemplateFile(file);
    if (read)
      list.templates.push_back(*std::move(read));
    else
      list.problems.push_back(read.error());
  }
  std::sort(list.templates.begin(), list.templates.end(),
            [](const CaseTemplate& a, const CaseTemplate& b) { return a.title.english < b.title.english; });
  return list;
}

Result<CaseTemplate> readTemplate(const std::string& id) {
  const TemplateList list = listTemplates();
  std::string known;
  for (const CaseTemplate& each : list.templates) {
    if (each.id == id) return each;
    known += (known.empty() ? "" : ", ") + each.id;
  }
  return failure(ErrorCode::notFound, say<"There is no template '%1'; the templates are %2.">(id, known), {{"template", id}});
}

Case withTemplate(Case edited, const CaseTemplate& from) {
  const Case& has = from.prefilled;
  if (edited.region.empty()) edited.region = has.region;
  if (edited.mannequin.empty()) edited.mannequin = has.mannequin;
  if (edited.probes.empty()) edited.probes = has.probes;
  if (edited.tags.empty()) edited.tags = has.tags;
  if (!edited.difficulty) edited.difficulty = has.difficulty;
  if (edited.scene == Scene{}) {
    edited.scene = has.scene;
    if (has.otherFields.contains("scene")) edited.otherFields["scene"] = has.otherFields["scene"];
  }
  if (!from.preset.empty() && presetsOf(edited).empty()) edited = withPresets(std::move(edited), {from.preset});
  if (!from.lessons.empty() && !hasLessons(edited)) edited.otherFields["parts"][std::string(kLessonsPart)] = jsonOf(from.lessons);
  return edited;
}

}  // namespace ew
