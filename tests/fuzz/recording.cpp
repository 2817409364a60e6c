#include "ew/scanning/recording.h"
#include "one_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  const auto file = fuzz::asFile(bytes, size, ".seq.mha");
  static_cast<void>(isRecording(file));
  const auto read = readRecording(file);
  if (!read) {
    fuzz::checkError(read.error());
    return 0;
  }
  const ScanLog& log = read->log;
  fuzz::mustHold(log.frameCount() > 0 && log.frameAt(log.end_s()) == log.frameCount() - 1);
  for (std::size_t n = 0; n < log.frameCount(); ++n) static_cast<void>(log.frame(n));
  return 0;
}
