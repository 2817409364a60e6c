#include "ew/io/sweep.h"
#include "one_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  // The first byte chooses between the two forms of header.
  const auto file = size > 0 && bytes[0] == 'N' ? fuzz::asFile(bytes, size, ".igs.nrrd") : fuzz::asFile(bytes, size, ".igs.mha");
  static_cast<void>(isSequence(file));
  if (const auto read = readSequence(file, noProgress(), fuzz::kSmall)) {
    fuzz::mustHold(read->pixels.empty() || read->pixels.size() == static_cast<std::size_t>(read->width) *
                                                                      static_cast<std::size_t>(read->height) * read->frames.size());
    static_cast<void>(sweepPoses(*read));
  } else {
    fuzz::checkError(read.error());
  }
  return 0;
}
