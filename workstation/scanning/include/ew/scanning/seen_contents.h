#pragma once

#include <optional>
#include <vector>

#include "ew/core/pose.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"
#include "ew/scanning/subject.h"

namespace ew {

/// Images of a body at rest, with one probe and one setting.
struct AskedImages {
  Probe probe;
  Knobs knobs;
  std::vector<Pose> poses;
};

struct SeenContents {
  CaseContents contents;
  double share = 0.0;  ///< of the case that was made, 0..1
};

/// What a case shows in these images, made for them alone where all of it would take long (loadSeenPart): a subject of it gives the same
/// pixels in them as one of the whole, and in other images black. Empty: read the whole.
/// @param opened with the scene of the images
/// @error as loadSeenPart
[[nodiscard]] Result<std::optional<SeenContents>> readSeenContents(const Case& opened, const AskedImages& images, Progress& progress);

}  // namespace ew
