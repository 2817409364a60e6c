#include "ew/io/sequence.h"
#include "ew/io/sweep.h"
#include "one_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  const auto read = readDeviceSet(fuzz::asFile(bytes, size, ".xml"));
  if (!read) {
    fuzz::checkError(read.error());
    return 0;
  }
  // What it says must lead somewhere, or to a sentence.
  Sequence sequence;
  sequence.frames.resize(1);
  sequence.frames[0].imageStatus = PoseStatus::ok;
  sequence.frames[0].transforms = {{"Probe", "Tracker", glm::dmat4(1.0), PoseStatus::ok}};
  if (const auto poses = sweepPoses(sequence, &*read, read->referenceFrame); !poses) fuzz::checkError(poses.error());
  return 0;
}
