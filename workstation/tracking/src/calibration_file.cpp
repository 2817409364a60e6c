#include "ew/tracking/calibration_file.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "ew/core/data_file.h"
#include "ew/core/json_fields.h"
#include "ew/io/json_files.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kMostRevisions = 999999;
constexpr std::size_t kLongestName = 200;

json jsonOf(const CalibrationQuality& quality) {
  return {{"method", quality.method},
          {"made", quality.made},
          {"residual_mm", quality.residual_mm},
          {"expected_mm", quality.expected_mm},
          {"samples", quality.samples}};
}

CalibrationQuality qualityIn(const JsonFields& fields) {
  fields.only({"method", "made", "residual_mm", "expected_mm", "samples"});
  constexpr double kFarthest_mm = 1e4;
  return {.method = fields.text("method"),
          .made = fields.text("made", {}, 0),
          .residual_mm = fields.number("residual_mm", 0.0, kFarthest_mm),
          .expected_mm = fields.number("expected_mm", 0.0, kFarthest_mm),
          .samples = static_cast<int>(fields.whole("samples", 0, 1000000000))};
}

/// Letters, digits, - and _ as they are, anything else by its bytes in hexadecimal: different names stay different.
std::string fileNameOf(const std::string& name) {
  std::string made;
  for (const char c : name) {
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_') {
      made += c;
      continue;
    }
    char code[4];
    std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
    made += code;
  }
  return made.empty() ? "%" : made.substr(0, 100);
}

/// The revision of a file's name; empty for other files.
std::optional<int> revisionOf(const fs::path& file) {
  const std::string stem = file.stem().string();
  if (file.extension() != ".json" || stem.size() < 2 || stem.size() > 7 || stem.front() != 'r') return std::nullopt;
  if (!std::all_of(stem.begin() + 1, stem.end(), [](char c) { return c >= '0' && c <= '9'; })) return std::nullopt;
  return std::stoi(stem.substr(1));
}

json documentOf(const TrackerCalibration& calibration) {
  return {{"format", TrackerCalibration::kFormat},
          {"revision", calibration.revision},
          {"source", calibration.source},
          {"tool", calibration.tool},
          {"reference", calibration.reference},
          {"body", calibration.body},
          {"mannequin", calibration.mannequin},
          {"probe_to_tool", rowsOf(calibration.probeToTool)},
          {"face", jsonOf(calibration.face)},
          {"tracker_to_world", rowsOf(calibration.trackerToWorld)},
          {"alignment", jsonOf(calibration.alignment)}};
}

Result<TrackerCalibration> calibrationIn(const json& value, const Message& where) {
  JsonReading reading(where, {"note"});
  const JsonFields document(value, reading);
  requireFormat(document, TrackerCalibration::kFormat);
  document.only(
      {"format", "revision", "source", "tool", "reference", "body", "mannequin", "probe_to_tool", "face", "tracker_to_world", "alignment"});
  TrackerCalibration calibration;
  calibration.revision = static_cast<int>(document.whole("revision", 0, kMostRevisions));
  calibration.source = document.text("source", {}, 0, kLongestName);
  calibration.tool = document.text("tool", {}, 0, kLongestName);
  calibration.reference = document.text("reference", {}, 0, kLongestName);
  calibration.body = document.text("body", {}, 0, kLongestName);
  calibration.mannequin = document.text("mannequin", {}, 0, kLongestName);
  for (const auto& [key, matrix] :
       {std::pair{"probe_to_tool", &calibration.probeToTool.matrix}, std::pair{"tracker_to_world", &calibration.trackerToWorld.matrix}}) {
    const auto found = document.rigid(key);
    if (found)
      *matrix = *found;
    else if (document.good())
      document.refuse(key, say<"a rotation and a translation: 16 numbers, row by row">());
  }
  calibration.face = qualityIn(document.object("face"));
  calibration.alignment = qualityIn(document.object("alignment"));
  if (reading.problem()) return passOn(*reading.problem());
  return calibration;
}

}  // namespace

Result<TrackerCalibration> readCalibration(const fs::path& file) {
  const Message where = say<"the calibration %1">(file.string());
  const auto read = readJsonFile(file, where);
  if (!read) return passOn(read.error());
  return calibrationIn(*read, where);
}

fs::path calibrationFolder(const fs::path& root, const std::string& source, const std::string& tool) {
  return root / (fileNameOf(source) + "." + fileNameOf(tool));
}

std::vector<fs::path> calibrationRevisions(const fs::path& root, const std::string& source, const std::string& tool) {
  std::vector<std::pair<int, fs::path>> found;
  std::error_code problem;
  for (fs::directory_iterator at(calibrationFolder(root, source, tool), problem), end; !problem && at != end; at.increment(problem))
    if (const auto revision = revisionOf(at->path())) found.emplace_back(*revision, at->path());
  std::sort(found.begin(), found.end());
  std::vector<fs::path> files;
  for (auto& [revision, file] : found) files.push_back(std::move(file));
  return files;
}

Result<TrackerCalibration> latestCalibration(const fs::path& root, const std::string& source, const std::string& tool) {
  const auto files = calibrationRevisions(root, source, tool);
  if (!files.empty()) return readCalibration(files.back());
  TrackerCalibration none;
  none.source = source;
  none.tool = tool;
  none.face.method = none.alignment.method = "none";
  return none;
}

Result<TrackerCalibration> keepCalibration(const fs::path& root, TrackerCalibration calibration) {
  const auto files = calibrationRevisions(root, calibration.source, calibration.tool);
  calibration.revision = files.empty() ? 1 : *revisionOf(files.back()) + 1;
  if (calibration.face.method.empty()) calibration.face.method = "none";
  if (calibration.alignment.method.empty()) calibration.alignment.method = "none";
  const json document = documentOf(calibration);
  if (auto good = calibrationIn(document, say<"the calibration">()); !good) return passOn(good.error());
  const fs::path folder = calibrationFolder(root, calibration.source, calibration.tool);
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem)
    return failure(ErrorCode::notWritable,
                   say<"The folder %1 cannot be made (%2); check its permissions.">(folder.string(), verbatim(problem.message())),
                   {{"file", folder.string()}});
  char name[32];
  std::snprintf(name, sizeof name, "r%04d.json", calibration.revision);
  if (auto written = writeFileSafely(folder / name, document.dump(2, ' ', false, json::error_handler_t::replace) + "\n"); !written)
    return passOn(written.error());
  return calibration;
}

}  // namespace ew
