#include "ew/io/sequence.h"
#include "one_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  if (const auto read = readDeviceSet(fuzz::asFile(bytes, size, ".xml")); !read) fuzz::checkError(read.error());
  return 0;
}
