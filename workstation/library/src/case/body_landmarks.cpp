#include <algorithm>
#include <nlohmann/json.hpp>

#include "ew/core/json_fields.h"
#include "ew/io/json_files.h"
#include "ew/library/body_skin.h"
#include "ew/library/placing.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

constexpr int kLandmarksFormat = 1;
constexpr double kFarthest_mm = 3000.0;
constexpr const char* kDefaultMannequin = "adult.json";

BodyLandmark landmarkIn(const JsonFields& fields) {
  fields.only({"id", "name", "at_mm", "note"});
  BodyLandmark read;
  read.id = fields.text("id");
  read.name = wordsIn(fields, "name", 100);
  read.at_mm = fields.point("at_mm", kFarthest_mm);
  return read;
}

PlacingSite siteIn(const JsonFields& fields) {
  fields.only({"region", "at_mm", "towards_mm", "lateral", "note"});
  PlacingSite read;
  read.region = fields.text("region");
  read.at_mm = fields.point("at_mm", kFarthest_mm);
  read.towards_mm = fields.point("towards_mm", kFarthest_mm);
  read.lateralHint = fields.point("lateral", 1.0, read.lateralHint);
  return read;
}

/// What a file says itself, beside the name of the one it extends.
struct LandmarkFile {
  std::string extends;
  MannequinLandmarks own;
};

Result<LandmarkFile> readLandmarkFile(const fs::path& file) {
  const auto document = readJsonFile(file, verbatim(file.filename().string()));
  if (!document) return passOn(document.error());
  JsonReading reading(verbatim(file.filename().string()));
  const JsonFields fields(*document, reading);
  requireFormat(fields, kLandmarksFormat);
  fields.only({"format", "note", "source", "extends", "landmarks", "sites"});
  LandmarkFile read;
  read.extends = fields.text("extends", "", 0);
  for (const JsonFields& each : fields.objects("landmarks", 0, 200)) read.own.landmarks.push_back(landmarkIn(each));
  for (const JsonFields& each : fields.objects("sites", 0, 100)) read.own.sites.push_back(siteIn(each));
  if (reading.problem()) return passOn(*reading.problem());
  return read;
}

/// Entries of the same name are replaced in their place, others come at the end.
template <class Entry, class Name>
void putOver(std::vector<Entry>& below, const std::vector<Entry>& above, Name Entry::*name) {
  for (const Entry& each : above) {
    const auto same = std::find_if(below.begin(), below.end(), [&](const Entry& old) { return old.*name == each.*name; });
    if (same == below.end())
      below.push_back(each);
    else
      *same = each;
  }
}

fs::path fileNameOf(const std::string& mannequin) { return fs::path(mannequin.empty() ? kDefaultMannequin : mannequin).filename(); }

}  // namespace

Result<MannequinLandmarks> landmarksOf(const std::string& mannequin) {
  const auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  const fs::path folder = *resources / "mannequin" / "landmarks";
  const fs::path file = folder / fileNameOf(mannequin).replace_extension(".json");
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored))
    return failure(ErrorCode::notFound,
                   say<"Nobody has named places of the mannequin '%1'; place the volume by hand, or choose another mannequin.">(
                       fileNameOf(mannequin).string()),
                   {{"file", file.string()}});
  auto read = readLandmarkFile(file);
  if (!read) return passOn(read.error());
  if (read->extends.empty()) return std::move(read->own);
  auto below = readLandmarkFile(folder / fs::path(read->extends).filename());
  if (!below) return passOn(below.error());
  MannequinLandmarks all = std::move(below->own);
  putOver(all.landmarks, read->own.landmarks, &BodyLandmark::id);
  putOver(all.sites, read->own.sites, &PlacingSite::region);
  return all;
}

Result<std::shared_ptr<const Skin>> skinOfMannequin(const std::string& mannequin, const fs::path& caseFolder) {
  const std::string name = mannequin.empty() ? kDefaultMannequin : mannequin;
  if (fs::path(name).extension() != ".json")
    return failure(ErrorCode::unsupported,
                   say<"The mannequin '%1' is a mesh, whose skin only the window has; place the volume there.">(name),
                   {{"mannequin", name}});
  if (!caseFolder.empty())
    if (const auto own = fileOfCase(caseFolder, name, "mannequin"); own) return readBodySkin(*own);
  const auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  return readBodySkin(*resources / "mannequin" / fs::path(name).filename());
}

}  // namespace ew
