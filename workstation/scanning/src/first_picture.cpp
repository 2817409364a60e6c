#include "ew/scanning/first_picture.h"

namespace ew {

std::optional<Picture> firstPicture(Scanner& scanner, const ScanSubject& subject, const std::vector<Probe>& probes,
                                    const std::vector<Preset>& presets, int width_px, int height_px) {
  const auto state = firstState(subject, probes, presets);
  if (!state) return std::nullopt;
  scanner.show(subject);
  return scanner.make(*state, width_px, height_px);
}

}  // namespace ew
