#include "ew/io/cine_reader.h"
#include "one_file.h"

/// Films, TIFF of several pages and films inside DICOM, by their first bytes, turned as the last byte says.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  if (size < 16 || size > 65536) return 0;
  const Orientation asked{bytes[size - 1] % 4, bytes[size - 1] / 4 % 2 == 1};
  auto reader = CineReader::open(fuzz::asFile(bytes, size, ".film"), noProgress(), fuzz::kSmall, asked);
  if (!reader) {
    fuzz::checkError(reader.error());
    return 0;
  }
  CineFrame frame;
  double before_s = 0.0;
  constexpr int kMostFrames = 64;
  for (int n = 0; n < kMostFrames; ++n) {
    const auto got = reader->next(frame);
    if (!got) fuzz::checkError(got.error());
    if (!got || !*got) break;
    const CineInfo& info = reader->info();
    const auto pixels = static_cast<std::size_t>(info.width_px) * static_cast<std::size_t>(info.height_px);
    fuzz::mustHold(frame.level.width == info.width_px && frame.level.height == info.height_px && frame.level.pixels.size() == pixels);
    fuzz::mustHold(frame.coloured.empty() || frame.coloured.size() == pixels);
    fuzz::mustHold(frame.time_s >= before_s);
    before_s = frame.time_s;
  }
  if (reader->brokenOff()) fuzz::checkError(*reader->brokenOff());
  return 0;
}
