#include "ew/scanning/contents_for_images.h"

#include <memory>
#include <utility>

#include "ew/imaging/frame_reach.h"
#include "ew/library/case_part.h"

namespace ew {

Result<std::optional<ContentsForImages>> readContentsFor(const Case& opened, const StillImages& images, Progress& progress) {
  auto part = loadCasePart(opened, reachOfFrame(images.probe, images.knobs, opened.scene), images.poses, progress);
  if (!part) return passOn(part.error());
  if (!*part) return std::nullopt;
  CaseEcho& echo = (*part)->echo;
  CaseContents contents;
  contents.voxels = ScanVoxels::asStored(std::make_shared<const Volume>(std::move(echo.volume)));
  contents.labels = std::make_shared<const Volume>(std::move(*echo.labels));
  contents.flow = samplerOf(echo);
  contents.tissue = std::move(echo.tissue);
  contents.motion = std::move(echo.motion);
  contents.tissues = std::move(echo.tissues);
  contents.fileToWorld = opened.volume.fileToWorld;
  return ContentsForImages{std::move(contents), (*part)->share};
}

}  // namespace ew
