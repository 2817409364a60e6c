#include "ew/scanning/seen_contents.h"

#include <memory>
#include <utility>

#include "ew/imaging/frame_reach.h"
#include "ew/library/seen_part.h"

namespace ew {

Result<std::optional<SeenContents>> readSeenContents(const Case& opened, const AskedImages& images, Progress& progress) {
  auto part = loadSeenPart(opened, reachOfFrame(images.probe, images.knobs, opened.scene), images.poses, progress);
  if (!part) return passOn(part.error());
  if (!*part) return std::nullopt;
  CaseEcho& echo = (*part)->echo;
  CaseContents contents;
  contents.voxels = ScanVoxels::asStored(std::make_shared<const Volume>(std::move(echo.volume)));
  contents.labels = std::make_shared<const Volume>(std::move(*echo.labels));
  contents.tissue = std::move(echo.tissue);
  contents.motion = std::move(echo.motion);
  contents.tissues = std::move(echo.tissues);
  contents.fileToWorld = opened.volume.fileToWorld;
  return SeenContents{std::move(contents), (*part)->share};
}

}  // namespace ew
