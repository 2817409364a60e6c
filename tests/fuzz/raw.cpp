#include "ew/io/raw_volume.h"
#include "one_file.h"

/// The first line is the layout, what follows are the samples.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  const std::string_view all(reinterpret_cast<const char*>(bytes), size);
  const std::size_t line = std::min(all.find('\n'), all.size());
  const auto file = fuzz::asFile(bytes + line, size - line, ".raw");
  static_cast<void>(guessRawLayouts(size * 4096));
  const auto layout = parseRawLayout(all.substr(0, line));
  if (!layout) {
    fuzz::checkError(layout.error());
    return 0;
  }
  if (const auto again = parseRawLayout(textOf(*layout)); !again || *again != *layout) fuzz::mustHold(false);
  static_cast<void>(previewRawVolume(file, *layout));
  if (const auto read = readRawVolume(file, *layout, noProgress(), fuzz::kSmall))
    fuzz::checkVolume(read->volume);
  else
    fuzz::checkError(read.error());
  return 0;
}
