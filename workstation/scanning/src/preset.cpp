#include "ew/scanning/preset.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numbers>

#include "ew/core/json_fields.h"
#include "ew/core/numbers.h"
#include "ew/imaging/settings_json.h"
#include "ew/io/json_files.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kLongestTitle = 80, kLongestSource = 600;

std::string idIn(const JsonFields& fields, std::string_view key) {
  if (!fields.has(key)) return {};
  std::string id = fields.text(key, {}, 1, kLongestTitle);
  const bool isPlain = id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789.-_") == std::string::npos;
  if (fields.good() && !isPlain) fields.refuse(key, say<"small letters, digits, ., - and _">());
  return id;
}

/// What a preset keeps out of: the quality is what the machine can do.
void withoutMachine(Knobs& knobs) { knobs.quality = Knobs().quality; }

/// Letters and digits of a title for a file name: "Abdomen, deep" gives "abdomen-deep"; other bytes by their number, so that titles of any
/// script make names that differ.
std::string nameFrom(const std::string& title) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string name;
  for (const char c : title) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 'A' && byte <= 'Z') {
      name += static_cast<char>(byte + 0x20U);
    } else if ((byte >= 'a' && byte <= 'z') || (byte >= '0' && byte <= '9')) {
      name += c;
    } else if (byte >= 0x80U) {
      name += kDigits[byte >> 4U];
      name += kDigits[byte & 0xFU];
    } else if (!name.empty() && name.back() != '-') {
      name += '-';
    }
  }
  while (name.ends_with('-')) name.pop_back();
  return name;
}

std::string listed(const std::vector<double>& numbers) {
  std::string text;
  for (const double each : numbers) text += (text.empty() ? "" : ", ") + textOf(each);
  return text;
}

/// What is wrong about a preset as sentences about fields of its file have it.
class Check {
 public:
  Check(const Preset& preset, const Probe& probe) : preset_(preset), probe_(probe), where_(say<"the preset %1">(preset.id)) {}

  Result<void> all() {
    const Knobs& knobs = preset_.knobs;
    const double depth_mm = knobs.depth_mm > 0.0 ? knobs.depth_mm : probe_.defaultDepth_mm;
    if (depth_mm < probe_.minDepth_mm || depth_mm > probe_.maxDepth_mm)
      refuse("depth_mm", textOf(depth_mm), rangeText(probe_.minDepth_mm, probe_.maxDepth_mm));
    const std::vector<double> carriers = probe_.carriers_hz.empty() ? std::vector{probe_.carrier_hz} : probe_.carriers_hz;
    if (knobs.carrier_hz > 0.0 && std::find(carriers.begin(), carriers.end(), knobs.carrier_hz) == carriers.end())
      refuse("carrier_hz", textOf(knobs.carrier_hz), say<"0 or one of the probe's frequencies, %1">(listed(carriers)));
    std::vector<double> foci{knobs.focus_mm};
    foci.insert(foci.end(), knobs.moreFoci_mm.begin(), knobs.moreFoci_mm.end());
    for (const double focus_mm : foci)
      if (focus_mm > depth_mm) refuse("focus_mm", textOf(focus_mm), say<"at most the depth, %1 mm">(textOf(depth_mm)));
    const double steering_deg = knobs.steering_rad * 180.0 / std::numbers::pi, most_deg = probe_.maxSteering_rad * 180.0 / std::numbers::pi;
    if (std::abs(steering_deg) > most_deg + 1e-9)
      refuse("steering_deg", textOf(steering_deg), most_deg > 0.0 ? rangeText(-most_deg, most_deg) : say<"0: the probe cannot steer">());
    if (knobs.trapezoid && !(probe_.trapezoidHalfAngle_rad > 0.0)) refuse("trapezoid", "true", say<"false: the probe cannot fan out">());
    if (problem_) return passOn(*problem_);
    return {};
  }

 private:
  void refuse(const std::string& field, const std::string& found, const Message& expected) {
    if (!problem_) problem_ = fieldError(where_, "knobs." + field, verbatim(found), expected);
  }
  const Preset& preset_;
  const Probe& probe_;
  Message where_;
  std::optional<Error> problem_;
};

}  // namespace

Result<Preset> presetFromJson(const json& document, const std::string& id, const Message& where) {
  JsonReading reading(where, {"note"});
  const JsonFields fields(document, reading);
  requireFormat(fields, kPresetFormat);
  fields.only({"format", "title", "probe", "knobs", "annotations", "body_mark", "measurements", "source"});
  Preset preset;
  preset.id = id;
  preset.title = wordsIn(fields, "title", kLongestTitle);
  preset.probe = fields.text("probe", {}, 1, kLongestTitle);
  preset.annotations = idIn(fields, "annotations");
  preset.bodyMark = idIn(fields, "body_mark");
  preset.measurements = idIn(fields, "measurements");
  preset.source = fields.text("source", "", 0, kLongestSource);
  const JsonFields knobs = fields.object("knobs");
  if (!fields.has("knobs")) fields.refuse("knobs", say<"an object, the knobs of the console">());
  if (knobs.has("quality")) knobs.refuse("quality", say<"left out: how fast the machine is belongs to no examination">());
  if (reading.problem()) return passOn(*reading.problem());
  auto set = knobsFromJson(document.at("knobs"), say<"the knobs of %1">(where));
  if (!set) return passOn(set.error());
  preset.knobs = *set;
  return preset;
}

json toJson(const Preset& preset) {
  Knobs kept = preset.knobs;
  withoutMachine(kept);
  json knobs = toJson(kept);
  const json usual = toJson(Knobs{});
  for (const auto& [key, value] : usual.items())
    if (knobs[key] == value) knobs.erase(key);
  // Unsaid, the law would be that of the values that are given.
  knobs["gain_law"] = toJson(kept)["gain_law"];
  json object = {{"format", kPresetFormat},
                 {"title", {{"en", preset.title.english}, {"de", preset.title.german}}},
                 {"probe", preset.probe},
                 {"knobs", std::move(knobs)}};
  const std::pair<const char*, const std::string&> words[] = {{"annotations", preset.annotations},
                                                              {"body_mark", preset.bodyMark},
                                                              {"measurements", preset.measurements},
                                                              {"source", preset.source}};
  for (const auto& [key, word] : words)
    if (!word.empty()) object[key] = word;
  return object;
}

Result<Preset> readPreset(const fs::path& file) {
  const Message where = say<"the preset %1">(file.string());
  const auto document = readJsonFile(file, where);
  if (!document) return passOn(document.error());
  return presetFromJson(*document, file.stem().string(), where);
}

Result<std::vector<Preset>> readPresets(const fs::path& folder) { return readEvery<Preset>(folder, say<"presets">(), readPreset); }

Result<void> checkPreset(const Preset& preset, const std::vector<Probe>& probes) {
  const auto found = std::find_if(probes.begin(), probes.end(), [&](const Probe& each) { return each.id == preset.probe; });
  if (found != probes.end()) return Check(preset, *found).all();
  std::string ids;
  for (const Probe& each : probes) ids += (ids.empty() ? "" : ", ") + each.id;
  return failure(ErrorCode::badField,
                 say<"The preset %1 is for the probe '%2', which there is not; those there are: %3.">(preset.id, preset.probe, ids),
                 {{"field", "probe"}, {"found", preset.probe}, {"in", preset.id}});
}

std::vector<Probe> usableOf(const std::vector<std::string>& ids, const std::vector<Probe>& probes) {
  if (ids.empty()) return probes;
  std::vector<Probe> usable;
  for (const std::string& id : ids)
    for (const Probe& probe : probes)
      if (probe.id == id) usable.push_back(probe);
  return usable;
}

const Preset* startPreset(const std::vector<std::string>& ids, const std::vector<Preset>& presets, const std::vector<Probe>& usable) {
  for (const std::string& id : ids) {
    const auto found = std::find_if(presets.begin(), presets.end(), [&](const Preset& each) { return each.id == id; });
    if (found != presets.end() && checkPreset(*found, usable)) return &*found;
  }
  return nullptr;
}

Knobs applied(const Preset& preset, const Knobs& present) {
  Knobs knobs = preset.knobs;
  knobs.quality = present.quality;
  return knobs;
}

Preset presetOf(const std::string& title, const Probe& probe, const Knobs& knobs) {
  const Knobs usual;
  Preset preset;
  preset.title = {title, title};
  preset.probe = probe.id;
  preset.knobs = knobs;
  withoutMachine(preset.knobs);
  preset.knobs.zoom = usual.zoom;
  preset.knobs.mode = usual.mode;
  preset.knobs.mLine = usual.mLine;
  preset.knobs.mSweep_s = usual.mSweep_s;
  return preset;
}

fs::path ownPresetsFolder() {
  const char* chosen = std::getenv("ECHOWEAVE_PRESETS");
  if (chosen != nullptr && *chosen != '\0') return chosen;
  const char* home = std::getenv("HOME");
  if (home != nullptr && *home != '\0') return fs::path(home) / "EchoWeave" / "presets";
  return "EchoWeave presets";
}

OwnPresets readOwnPresets(const fs::path& folder) {
  OwnPresets own;
  std::error_code ignored;
  if (!fs::exists(folder, ignored)) return own;
  const auto files = jsonFilesIn(folder, say<"presets">());
  if (!files) {
    own.problems.push_back(files.error());
    return own;
  }
  for (const fs::path& file : *files) {
    auto preset = readPreset(file);
    if (preset)
      own.presets.push_back(std::move(*preset));
    else
      own.problems.push_back(preset.error());
  }
  std::stable_sort(own.presets.begin(), own.presets.end(),
                   [](const Preset& a, const Preset& b) { return a.title.english < b.title.english; });
  return own;
}

Result<std::vector<Preset>> presetsThere(const fs::path& resources) {
  auto presets = readPresets(resources / "presets");
  if (!presets) return presets;
  for (Preset& own : readOwnPresets(ownPresetsFolder()).presets) presets->push_back(std::move(own));
  return presets;
}

Result<fs::path> saveOwnPreset(const Preset& preset, const fs::path& folder) {
  const std::string name = nameFrom(preset.title.english);
  if (name.empty() || preset.title.english.size() > kLongestTitle)
    return failure(ErrorCode::badField,
                   say<"'%1' cannot be the name of a preset; use 1 to %2 bytes with a letter or a digit among them.">(preset.title.english,
                                                                                                                      kLongestTitle),
                   {{"field", "title"}, {"found", preset.title.english}});
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem)
    return failure(ErrorCode::notWritable, say<"The folder of presets %1 cannot be made: %2.">(folder.string(), problem.message()),
                   {{"folder", folder.string()}});
  // The name says title and probe; where another preset has it already, a number follows.
  for (int n = 1;; ++n) {
    const fs::path file = folder / (name + "-" + nameFrom(preset.probe) + (n == 1 ? "" : "-" + std::to_string(n)) + ".json");
    if (fs::exists(file, problem)) {
      const auto there = readPreset(file);
      if (!there || there->title != preset.title || there->probe != preset.probe) continue;
    }
    if (auto written = writeFileSafely(file, toJson(preset).dump(2) + "\n"); !written) return passOn(written.error());
    return file;
  }
}

}  // namespace ew
