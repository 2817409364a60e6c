#include "logic/tissues.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ew/core/find_entry.h"

namespace ew::case_authoring {
namespace {

constexpr std::array<TissueChoice, 9> kTissues = {{
    {EW_TRANSLATE_NOOP("ew::case_authoring::TissueChoice", "Soft tissue"), 0.5, 0.0, 1.6},
    {EW_TRANSLATE_NOOP("ew::case_authoring::TissueChoice", "Fluid (bile, urine)"), 0.01, 0.0, 1.53},
    {EW_TRANSLATE_NOOP("ew::case_authoring::TissueChoice", "Blood"), 0.18, 0.0, 1.66},
    {EW_TRANSLATE_NOOP("ew::case_authoring::TissueChoice", "Fat"), 0.5, 0.0, 1.31},
    {EW_TRANSLATE_NOOP("ew::case_authoring::TissueChoice", "Muscle"), 1.0, 0.0, 1.73},
    {EW_TRANSLATE_NOOP("ew::case_authoring::TissueChoice", "Stone"), 10.0, 24.0, 2.7},
    {EW_TRANSLATE_NOOP("ew::case_authoring::TissueChoice", "Calcification"), 15.0, 18.0, 4.5},
    {EW_TRANSLATE_NOOP("ew::case_authoring::TissueChoice", "Bone"), 15.0, 20.0, 6.7},
    {EW_TRANSLATE_NOOP("ew::case_authoring::TissueChoice", "Gas"), 12.0, 30.0, 0.0004},
}};

const TissueAcoustics* tissueIn(const Scene& scene, int label) { return entryWith(scene.tissues, &TissueAcoustics::label, label); }

bool isSame(double value, double known) { return std::abs(value - known) < 1e-9; }

}  // namespace

std::span<const TissueChoice> namedTissues() { return kTissues; }

bool hasTissue(const Case& shown, int label) { return tissueIn(shown.scene, label) != nullptr; }

std::optional<std::size_t> tissueOf(const Case& shown, int label) {
  const TissueAcoustics* given = tissueIn(shown.scene, label);
  for (std::size_t n = 0; given != nullptr && n < kTissues.size(); ++n)
    if (isSame(given->attenuation_dbPerCmMhz, kTissues[n].attenuation_dbPerCmMhz) &&
        isSame(given->reflection_db, kTissues[n].reflection_db) && isSame(given->impedance_mrayl, kTissues[n].impedance_mrayl))
      return n;
  return std::nullopt;
}

Case withTissue(Case edited, int label, const std::string& name, std::optional<std::size_t> tissue) {
  auto& list = edited.scene.tissues;
  const auto isOfLabel = [&](const TissueAcoustics& each) { return each.label == label; };
  if (!tissue) {
    std::erase_if(list, isOfLabel);
    return edited;
  }
  const TissueChoice& chosen = kTissues[*tissue];
  const TissueAcoustics made{label, name, chosen.attenuation_dbPerCmMhz, chosen.reflection_db, chosen.impedance_mrayl};
  if (hasTissue(edited, label))
    std::replace_if(list.begin(), list.end(), isOfLabel, made);
  else
    list.push_back(made);
  if (!edited.scene.attenuation) edited.scene.attenuation.emplace();
  return edited;
}

}  // namespace ew::case_authoring
