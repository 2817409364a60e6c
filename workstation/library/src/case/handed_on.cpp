#include "case/handed_on.h"

#include "case/manifest.h"

namespace ew {

Result<CaseToHandOn> caseToHandOn(const std::filesystem::path& folder, Progress& progress) {
  auto opened = loadCase(folder);
  if (!opened) return passOn(opened.error());
  if (auto good = checkNothingHiddenIsNeeded(manifestOf(*opened), opened->folder); !good) return passOn(good.error());
  auto files = sumsOfCase(opened->folder, progress);
  if (!files) return passOn(files.error());
  return CaseToHandOn{std::move(*opened), std::move(*files)};
}

}  // namespace ew
