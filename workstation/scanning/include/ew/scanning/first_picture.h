#pragma once

#include <optional>
#include <vector>

#include "ew/scanning/preset.h"
#include "ew/scanning/scanner.h"

namespace ew {

/// What a scan of the subject begins with (firstState), as the window shows it first.
/// @param scanner shows the subject afterwards; the picture is valid as long as nothing else is made with it
/// @return empty when the subject's probes are not among `probes`
[[nodiscard]] std::optional<Picture> firstPicture(Scanner& scanner, const ScanSubject& subject, const std::vector<Probe>& probes,
                                                  const std::vector<Preset>& presets, int width_px, int height_px);

}  // namespace ew
