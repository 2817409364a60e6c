#pragma once

#include <optional>
#include <vector>

#include "ew/scanning/preset.h"
#include "ew/scanning/scanner.h"

namespace ew {

/// What a scan can begin with: the program's probes, its presets and the user's own.
struct Beginnings {
  std::vector<Probe> probes;
  std::vector<Preset> presets;
};
/// @error as resourceFolder, readProbes, presetsThere
[[nodiscard]] Result<Beginnings> beginningsThere();

/// What a scan of the subject begins with (firstState), as the window shows it first.
/// @param scanner shows the subject afterwards; the image is valid as long as nothing else is made with it
/// @return empty when the subject's probes are not among those that are there
[[nodiscard]] std::optional<DisplayImage> firstImage(Scanner& scanner, const ScanSubject& subject, const Beginnings& there, int width_px,
                                                     int height_px);

}  // namespace ew
