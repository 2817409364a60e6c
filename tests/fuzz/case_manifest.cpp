#include <nlohmann/json.hpp>

#include "ew/library/case.h"
#include "ew/library/preparation.h"
#include "folder.h"

/// case.json, then the recipe of its patient, then one of its sweeps.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  const auto parts = fuzz::partsOf(bytes, size);
  fuzz::put("case.json", parts[0]);
  fuzz::put("patient.json", parts.size() > 1 ? parts[1] : "{}");
  fuzz::put("sweep.json", parts.size() > 2 ? parts[2] : "{}");
  fuzz::put("v.mha",
            "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementSpacing = 2 2 2\nElementType = MET_UCHAR\n"
            "ElementDataFile = LOCAL\n12345678");
  const auto& folder = fuzz::ownFolder();
  const auto problems = validateCase(folder);
  for (const Error& problem : problems) fuzz::checkSentence(problem);
  const auto opened = loadCase(folder);
  if (!opened) {
    fuzz::checkSentence(opened.error());
    fuzz::mustHold(!problems.empty());
    return 0;
  }
  const auto again = caseFromManifest(manifestOf(*opened), folder);
  fuzz::mustHold(again.has_value() && *again == *opened);
  static_cast<void>(caseNeedsPreparation(*opened));
  if (const auto estimate = estimatePreparation(*opened); !estimate) fuzz::checkSentence(estimate.error());
  if (!opened->volume.recipe.empty()) return 0;
  if (const auto echo = loadCaseVolume(*opened, noProgress()); !echo) fuzz::checkSentence(echo.error());
  return 0;
}
