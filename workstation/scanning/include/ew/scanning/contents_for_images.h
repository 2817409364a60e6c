#pragma once

#include <optional>
#include <vector>

#include "ew/core/pose.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"
#include "ew/scanning/subject.h"

namespace ew {

/// Images of a body at rest, with one probe and one setting.
struct StillImages {
  Probe probe;
  Knobs knobs;
  std::vector<Pose> poses;
};

struct ContentsForImages {
  CaseContents contents;
  double share = 0.0;  ///< of the case that was made, 0..1
};

/// What a case shows in these images, made for them alone where all of it would take long (loadCasePart): a subject of it gives the same
/// pixels in them as one of the whole, and in other images black. Empty: read the whole.
/// @param opened with the scene of the images
/// @error as loadCasePart
[[nodiscard]] Result<std::optional<ContentsForImages>> readContentsFor(const Case& opened, const StillImages& images, Progress& progress);

}  // namespace ew
