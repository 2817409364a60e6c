#include "ew/io/mapped_volume.h"
#include "one_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  const auto file = fuzz::asFile(bytes, size, ".nrrd");
  if (const auto read = readVolume(file, noProgress(), fuzz::kSmall))
    fuzz::checkVolume(read->volume);
  else
    fuzz::checkError(read.error());
  if (const auto second = readVolume(file, noProgress(), fuzz::kSmall, {.timeStep = 2})) fuzz::checkVolume(second->volume);
  if (const auto labels = readLabelVolume(file, noProgress(), fuzz::kSmall); !labels) fuzz::checkError(labels.error());
  static_cast<void>(mapVolume(file));
  return 0;
}
