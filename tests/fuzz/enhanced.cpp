#include "ew/io/dicom.h"
#include "one_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  const auto file = fuzz::asFile(bytes, size, ".dcm");
  for (const int step : {0, 1}) {
    DicomVolumeOptions options;
    if (step > 0) options.timeStep = step;
    if (const auto read = readDicomVolume(file, options, noProgress(), fuzz::kSmall))
      fuzz::checkVolume(read->volume);
    else
      fuzz::checkError(read.error());
  }
  if (const auto planes = readDicomPlanes(file, {.timeStep = 1}, noProgress(), fuzz::kSmall); !planes) fuzz::checkError(planes.error());
  return 0;
}
