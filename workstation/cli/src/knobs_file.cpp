#include "knobs_file.h"

#include <cmath>
#include <functional>
#include <map>

#include "ew/core/numbers.h"
#include "ew/io/safe_file.h"
#include "ew/library/schema.h"

namespace ew::cli {
namespace {

using nlohmann::json;

constexpr double kLargestFactor = 1e6;

Error badKey(const std::string& file, const std::string& key, const json& found, const std::string& expected) {
  std::string shown = found.dump(-1, ' ', false, json::error_handler_t::replace);
  if (shown.size() > 60) shown = shown.substr(0, 57) + "...";
  return {ErrorCode::badField,
          "'" + key + "' in '" + file + "' is " + shown + ", expected is " + expected + ".",
          {{"file", file}, {"field", key}, {"found", shown}, {"expected", expected}}};
}

using Setter = std::function<bool(const json&)>;
struct Key {
  std::string expected;
  Setter set;  // false: the value cannot be used
};

bool setNumber(const json& value, double lowest, double highest, double& target) {
  if (!value.is_number()) return false;
  const double number = value.get<double>();
  if (!std::isfinite(number) || number < lowest || number > highest) return false;
  target = number;
  return true;
}

Result<void> readKeys(const std::filesystem::path& file, const std::map<std::string, Key>& keys) {
  constexpr std::size_t kMaxBytes = 1u << 20;
  const auto text = readTextFile(file, kMaxBytes);
  if (!text) return passOn(text.error());
  const auto document = parseJson(*text, file.filename().string());
  if (!document) return passOn(document.error());
  const json& parsed = *document;
  if (!parsed.is_object())
    return failure(ErrorCode::badHeader, "'" + file.string() + "' is not a JSON object; write it as { \"name\": value, … }.",
                   {{"file", file.string()}});
  for (const auto& [name, value] : parsed.items()) {
    const auto key = keys.find(name);
    if (key == keys.end()) {
      std::string known;
      for (const auto& [each, unused] : keys) known += (known.empty() ? "" : ", ") + each;
      return failure(ErrorCode::badField, "'" + file.string() + "' has the unknown key '" + name + "'; known are " + known + ".",
                     {{"file", file.string()}, {"field", name}});
    }
    if (!key->second.set(value)) return passOn(badKey(file.string(), name, value, key->second.expected));
  }
  return {};
}

}  // namespace

Result<Knobs> readKnobs(const std::filesystem::path& file) {
  Knobs knobs;
  const std::map<std::string, Key> keys{
      {"gain", {"a factor of at least 0 (1 is neutral)", [&](const json& v) { return setNumber(v, 0.0, kLargestFactor, knobs.gain); }}},
      {"dgc",
       {"a list of 8 factors of at least 0, near to far (1 is neutral)",
        [&](const json& v) {
          if (!v.is_array() || v.size() != knobs.dgc.size()) return false;
          for (std::size_t n = 0; n < knobs.dgc.size(); ++n)
            if (!setNumber(v[n], 0.0, kLargestFactor, knobs.dgc[n])) return false;
          return true;
        }}},
      {"depth_mm", {"a depth in mm, or 0 for the probe's own", [&](const json& v) { return setNumber(v, 0.0, 1000.0, knobs.depth_mm); }}},
      {"focus_mm", {"a depth in mm, or 0 for half of the depth", [&](const json& v) { return setNumber(v, 0.0, 1000.0, knobs.focus_mm); }}},
      {"zoom", {"a magnification from 1 to 8", [&](const json& v) { return setNumber(v, 1.0, 8.0, knobs.zoom); }}},
      {"quality",
       {"\"weave\" or \"linear\"",
        [&](const json& v) {
          if (v != "weave" && v != "linear") return false;
          knobs.quality = v == "weave" ? Quality::weave : Quality::linear;
          return true;
        }}},
      {"marker_left",
       {"true or false",
        [&](const json& v) {
          if (!v.is_boolean()) return false;
          knobs.markerLeft = v.get<bool>();
          return true;
        }}},
  };
  if (auto read = readKeys(file, keys); !read) return passOn(read.error());
  return knobs;
}

Result<Scene> readScene(const std::filesystem::path& file) {
  Scene scene;
  const std::map<std::string, Key> keys{{"gain_and_dgc", {"true or false", [&](const json& v) {
                                                            if (!v.is_boolean()) return false;
                                                            scene.gainAndDgc = v.get<bool>();
                                                            return true;
                                                          }}}};
  if (auto read = readKeys(file, keys); !read) return passOn(read.error());
  return scene;
}

Result<void> checkDepth(const Knobs& knobs, const Probe& probe) {
  if (knobs.depth_mm == 0.0 || (knobs.depth_mm >= probe.minDepth_mm && knobs.depth_mm <= probe.maxDepth_mm)) return {};
  return failure(ErrorCode::badField,
                 "The depth of " + textOf(knobs.depth_mm) + " mm is not one of the probe " + probe.name + "; give " +
                     textOf(probe.minDepth_mm) + " to " + textOf(probe.maxDepth_mm) + " mm, or 0 for its own.",
                 {{"field", "depth_mm"}});
}

nlohmann::json toJson(const Knobs& knobs) {
  return {{"gain", knobs.gain},
          {"dgc", knobs.dgc},
          {"depth_mm", knobs.depth_mm},
          {"focus_mm", knobs.focus_mm},
          {"zoom", knobs.zoom},
          {"quality", knobs.quality == Quality::weave ? "weave" : "linear"},
          {"marker_left", knobs.markerLeft}};
}

}  // namespace ew::cli
