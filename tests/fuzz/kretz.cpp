#include "ew/io/kretz.h"
#include "one_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  const auto file = fuzz::asFile(bytes, size, ".vol");
  for (const int step : {0, 1}) {
    KretzOptions options;
    if (step > 0) options.timeStep = step;
    options.threads = 1;
    if (const auto read = readKretz(file, options, noProgress(), ReaderLimits{4u << 20}))
      fuzz::checkVolume(read->volume);
    else
      fuzz::checkError(read.error());
  }
  return 0;
}
