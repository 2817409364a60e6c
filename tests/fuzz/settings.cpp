#include "ew/imaging/settings_json.h"

#include <nlohmann/json.hpp>

#include "ew/core/nesting.h"
#include "folder.h"

/// Knobs and scenes, as from the files of `scan` and out of cases.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  if (nestsDeeperThan(text)) return 0;
  const auto document = nlohmann::json::parse(text, nullptr, false);
  if (document.is_discarded()) return 0;
  nlohmann::json unknown;
  const auto knobs = knobsFromJson(document, verbatim("The settings"), &unknown);
  if (!knobs) {
    fuzz::checkSentence(knobs.error());
  } else {
    const auto again = knobsFromJson(toJson(*knobs), verbatim("The settings"));
    fuzz::mustHold(again.has_value() && *again == *knobs);
  }
  const auto scene = sceneFromJson(document, verbatim("The scene"), &unknown);
  if (!scene) {
    fuzz::checkSentence(scene.error());
  } else {
    const auto again = sceneFromJson(toJson(*scene), verbatim("The scene"));
    fuzz::mustHold(again.has_value() && *again == *scene);
  }
  return 0;
}
