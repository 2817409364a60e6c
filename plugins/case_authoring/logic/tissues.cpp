#include "logic/tissues.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "logic/edits.h"

namespace ew::case_authoring {
namespace {

using nlohmann::json;

constexpr std::array<NamedTissue, 9> kTissues = {{
    {EW_TRANSLATE_NOOP("ew::case_authoring::NamedTissue", "Soft tissue"), 0.5, 0.0, 1.6},
    {EW_TRANSLATE_NOOP("ew::case_authoring::NamedTissue", "Fluid (bile, urine)"), 0.01, 0.0, 1.53},
    {EW_TRANSLATE_NOOP("ew::case_authoring::NamedTissue", "Blood"), 0.18, 0.0, 1.66},
    {EW_TRANSLATE_NOOP("ew::case_authoring::NamedTissue", "Fat"), 0.5, 0.0, 1.31},
    {EW_TRANSLATE_NOOP("ew::case_authoring::NamedTissue", "Muscle"), 1.0, 0.0, 1.73},
    {EW_TRANSLATE_NOOP("ew::case_authoring::NamedTissue", "Stone"), 10.0, 24.0, 2.7},
    {EW_TRANSLATE_NOOP("ew::case_authoring::NamedTissue", "Calcification"), 15.0, 18.0, 4.5},
    {EW_TRANSLATE_NOOP("ew::case_authoring::NamedTissue", "Bone"), 15.0, 20.0, 6.7},
    {EW_TRANSLATE_NOOP("ew::case_authoring::NamedTissue", "Gas"), 12.0, 30.0, 0.0004},
}};

json tissuesIn(const json& manifest) {
  auto list = fieldOf(manifest, "scene.tissues");
  return list.is_array() ? list : json::array();
}

bool isOf(const json& tissue, int label) { return tissue.is_object() && tissue.contains("label") && tissue["label"] == label; }

bool isSame(const json& tissue, const char* key, double value) {
  return tissue.contains(key) && tissue[key].is_number() && std::abs(tissue[key].get<double>() - value) < 1e-9;
}

}  // namespace

std::span<const NamedTissue> namedTissues() { return kTissues; }

bool hasTissue(const json& manifest, int label) {
  const json list = tissuesIn(manifest);
  return std::any_of(list.begin(), list.end(), [&](const json& each) { return isOf(each, label); });
}

std::optional<std::size_t> tissueOf(const json& manifest, int label) {
  for (const json& each : tissuesIn(manifest)) {
    if (!isOf(each, label)) continue;
    for (std::size_t n = 0; n < kTissues.size(); ++n)
      if (isSame(each, "attenuation_db_per_cm_mhz", kTissues[n].attenuation_dbPerCmMhz) &&
          isSame(each, "reflection_db", kTissues[n].reflection_db) && isSame(each, "impedance_mrayl", kTissues[n].impedance_mrayl))
        return n;
  }
  return std::nullopt;
}

json withTissue(json manifest, int label, const std::string& name, std::optional<std::size_t> tissue) {
  json list = tissuesIn(manifest);
  const auto at = std::find_if(list.begin(), list.end(), [&](const json& each) { return isOf(each, label); });
  if (!tissue) {
    if (at == list.end()) return manifest;
    list.erase(at);
    return withField(std::move(manifest), "scene.tissues", list.empty() ? std::nullopt : std::optional<json>(std::move(list)));
  }
  const NamedTissue& chosen = kTissues[*tissue];
  json made = at == list.end() ? json::object() : *at;
  made["label"] = label;
  made["name"] = name;
  made["attenuation_db_per_cm_mhz"] = chosen.attenuation_dbPerCmMhz;
  made["reflection_db"] = chosen.reflection_db;
  made["impedance_mrayl"] = chosen.impedance_mrayl;
  if (at == list.end())
    list.push_back(std::move(made));
  else
    *at = std::move(made);
  manifest = withField(std::move(manifest), "scene.tissues", std::move(list));
  return withEffect(std::move(manifest), "scene.attenuation", true);
}

}  // namespace ew::case_authoring
