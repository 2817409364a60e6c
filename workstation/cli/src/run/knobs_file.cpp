#include "run/knobs_file.h"

#include <nlohmann/json.hpp>

#include "ew/core/json_fields.h"
#include "ew/core/numbers.h"
#include "ew/imaging/settings_json.h"
#include "ew/io/safe_file.h"

namespace ew::cli {
namespace {

template <class T>
Result<T> readSetting(const std::filesystem::path& file, Result<T> (*fromJson)(const nlohmann::json&, const Message&, nlohmann::json*)) {
  constexpr std::size_t kMaxBytes = 1u << 20;
  const auto text = readTextFile(file, kMaxBytes);
  if (!text) return passOn(text.error());
  const auto document = parseJson(*text, verbatim(file.filename().string()));
  if (!document) return passOn(document.error());
  auto setting = fromJson(*document, verbatim("'" + file.string() + "'"), nullptr);
  if (!setting) {
    Error problem = std::move(setting.error());
    problem.context.emplace_back("file", file.string());
    return passOn(std::move(problem));
  }
  return setting;
}

}  // namespace

Result<Knobs> readKnobs(const std::filesystem::path& file) { return readSetting<Knobs>(file, knobsFromJson); }
Result<Scene> readScene(const std::filesystem::path& file) { return readSetting<Scene>(file, sceneFromJson); }

Result<void> checkDepth(const Knobs& knobs, const Probe& probe) {
  if (knobs.depth_mm == 0.0 || (knobs.depth_mm >= probe.minDepth_mm && knobs.depth_mm <= probe.maxDepth_mm)) return {};
  return failure(ErrorCode::badField,
                 say<"The depth of %1 mm is not one of the probe %2; give %3 to %4 mm, or 0 for its own.">(
                     textOf(knobs.depth_mm), probe.name, textOf(probe.minDepth_mm), textOf(probe.maxDepth_mm)),
                 {{"field", "depth_mm"}});
}

}  // namespace ew::cli
