#include "ew/io/image_stack.h"
#include "one_file.h"

/// The first byte chooses the kind of image.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  if (size < 2 || size > 65536) return 0;
  const auto file = fuzz::asFile(bytes, size, bytes[0] == 0xFF ? "a.jpg" : bytes[0] == 'P' ? "b.pgm" : "c.png");
  StackOptions options;
  options.spacing_mm = glm::dvec3(0.5);
  options.colour = ColourRule::dropColour;
  options.blank = {{0, 0, 3, 3}};
  if (const auto read = readImageStack(file, options, noProgress(), fuzz::kSmall))
    fuzz::checkVolume(read->volume);
  else
    fuzz::checkError(read.error());
  return 0;
}
