#include "ew/io/dicom.h"
#include "one_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  const auto file = fuzz::asFile(bytes, size, ".dcm");
  static_cast<void>(isDicom(file));
  const auto summary = inspectDicom(file, fuzz::kSmall);
  if (!summary) {
    fuzz::checkError(summary.error());
    return 0;
  }
  for (const int region : {-1, 0, 1}) {
    CineOptions options;
    if (region >= 0) options.region = region;
    if (region == 0) options.pixel_mm = glm::dvec2(0.1);
    options.colour = region == 0 ? ColourRule::dropColour : ColourRule::ask;
    options.keepText = true;
    options.blank = {{1, 1, 5, 5}};
    if (const auto cine = readDicomCine(file, options, noProgress(), fuzz::kSmall)) {
      const Sequence& s = cine->sequence;
      const auto pixels = static_cast<std::size_t>(s.width) * static_cast<std::size_t>(s.height) * s.frames.size();
      fuzz::mustHold(s.pixels.size() == pixels && (cine->coloured.empty() || cine->coloured.size() == pixels) && cine->pixel_mm.x > 0.0);
    } else {
      fuzz::checkError(cine.error());
    }
  }
  return 0;
}
