#include "ew/scanning/first_image.h"

#include "ew/core/data_file.h"

namespace ew {

Result<Beginnings> beginningsThere() {
  const auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  auto probes = readProbes(*resources / "probes");
  if (!probes) return passOn(probes.error());
  auto presets = presetsThere(*resources);
  if (!presets) return passOn(presets.error());
  return Beginnings{std::move(*probes), std::move(*presets)};
}

std::optional<DisplayImage> firstImage(Scanner& scanner, const ScanSubject& subject, const Beginnings& there, int width_px, int height_px) {
  const auto state = firstState(subject, there.probes, there.presets);
  if (!state) return std::nullopt;
  scanner.show(subject);
  return scanner.make(*state, width_px, height_px);
}

}  // namespace ew
