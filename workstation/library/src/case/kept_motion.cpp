#include "case/kept_motion.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "ew/core/message.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

std::string fieldFile(std::size_t number) { return "field-" + std::to_string(number) + ".bin"; }

ordered_json keptJsonOf(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
glm::dvec3 keptPointOf(const json& kept) { return {kept.at(0).get<double>(), kept.at(1).get<double>(), kept.at(2).get<double>()}; }

ordered_json keptJsonOf(const BodyRhythm& rhythm) { return {{"period_s", rhythm.period_s}, {"variation", rhythm.variation}}; }
BodyRhythm keptRhythmOf(const json& kept) { return {kept.at("period_s").get<double>(), kept.at("variation").get<double>()}; }

BodyRhythms keptRhythmsOf(const json& kept) {
  BodyRhythms rhythms;
  if (kept.contains("breathing")) {
    const json& breathing = kept.at("breathing");
    rhythms.breathing = {keptRhythmOf(breathing.at("rhythm")), breathing.at("pause").get<double>(), breathing.at("tidal").get<double>()};
  }
  if (kept.contains("pulse")) rhythms.pulse = keptRhythmOf(kept.at("pulse"));
  if (kept.contains("bowel")) rhythms.bowel = keptRhythmOf(kept.at("bowel"));
  return rhythms;
}

std::optional<TissueMotion::Mode> keptModeOf(const json& kept) {
  constexpr std::size_t kMostNodes = std::size_t{1} << 26;
  TissueMotion::Mode mode;
  const int kind = kept.at("kind").get<int>();
  if (kind < 0 || kind > static_cast<int>(TissueMotion::Kind::bowelSine)) return std::nullopt;
  mode.kind = static_cast<TissueMotion::Kind>(kind);
  mode.grid.dims = glm::ivec3(keptPointOf(kept.at("dims")));
  mode.grid.spacing_mm = keptPointOf(kept.at("spacing_mm"));
  mode.grid.origin_mm = keptPointOf(kept.at("origin_mm"));
  if (!checkGrid(mode.grid) || !glm::all(glm::greaterThan(mode.grid.dims, glm::ivec3(1))) || mode.grid.voxelCount() > kMostNodes)
    return std::nullopt;
  return mode;
}

}  // namespace

ordered_json keptJsonOf(const BodyRhythms& rhythms) {
  ordered_json kept = ordered_json::object();
  if (const auto& breathing = rhythms.breathing)
    kept["breathing"] = {{"rhythm", keptJsonOf(breathing->rhythm)}, {"pause", breathing->pause}, {"tidal", breathing->tidal}};
  if (rhythms.pulse) kept["pulse"] = keptJsonOf(*rhythms.pulse);
  if (rhythms.bowel) kept["bowel"] = keptJsonOf(*rhythms.bowel);
  return kept;
}

Result<void> keepMotion(const StepStore& store, const char* step, const std::string& key, const TissueMotion* motion) {
  if (auto room = store.prepare(step); !room) return room;
  ordered_json data = ordered_json::object();
  std::vector<std::string> names;
  if (motion != nullptr) {
    data["rhythms"] = keptJsonOf(motion->rhythms);
    data["fields"] = ordered_json::array();
    for (const TissueMotion::Mode& mode : motion->modes) {
      data["fields"].push_back({{"kind", static_cast<int>(mode.kind)},
                                {"dims", keptJsonOf(glm::dvec3(mode.grid.dims))},
                                {"spacing_mm", keptJsonOf(mode.grid.spacing_mm)},
                                {"origin_mm", keptJsonOf(mode.grid.origin_mm)}});
      const std::string_view bytes(reinterpret_cast<const char*>(mode.shift_mm.data()), mode.shift_mm.size() * sizeof(glm::vec3));
      const std::string& name = names.emplace_back(fieldFile(names.size()));
      if (auto written = writeFileSafely(store.fileOf(step, key, name), bytes); !written) return written;
    }
  }
  return store.keep(step, key, std::move(data), names);
}

bool readKeptMotion(const StepStore& store, const char* step, const std::string& key, std::shared_ptr<TissueMotion>& motion) {
  motion = nullptr;
  if (key.empty()) return true;
  const auto data = store.find(step, key);
  if (!data) return false;
  if (!data->contains("rhythms")) return true;
  auto read = std::make_shared<TissueMotion>();
  try {
    read->rhythms = keptRhythmsOf(data->at("rhythms"));
    for (const json& each : data->at("fields")) {
      auto mode = keptModeOf(each);
      if (!mode || !store.readValues(step, key, fieldFile(read->modes.size()), mode->grid.voxelCount(), mode->shift_mm)) return false;
      read->modes.push_back(std::move(*mode));
    }
  } catch (const json::exception&) {
    return false;
  }
  motion = std::move(read);
  return true;
}

}  // namespace ew
