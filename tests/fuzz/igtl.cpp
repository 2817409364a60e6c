#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "ew/trackers/igtl_bodies.h"
#include "one_file.h"

namespace {

/// Reads what a server might send, and looks at every message as the client does.
void readAll(std::span<const std::uint8_t> bytes, std::size_t portion) {
  using namespace ew;
  IgtlReader reader(false);
  const auto look = [](const IgtlMessage& message) {
    static_cast<void>(igtlStatus(message));
    const auto poses = igtlPoses(message);
    if (!poses) return fuzz::checkError(poses.error());
    for (const IgtlPose& pose : *poses)
      fuzz::mustHold((pose.state != TrackingState::live && pose.state != TrackingState::outOfRange) ||
                     checkRigid(pose.toolToTracker, 1e-9).has_value());
  };
  while (!bytes.empty()) {
    const std::size_t count = std::min(portion, bytes.size());
    if (auto read = reader.read(bytes.first(count), look, [](const Message& why) { fuzz::mustHold(!why.empty()); }); !read)
      return fuzz::checkError(read.error());
    fuzz::mustHold(reader.held_bytes() <= kIgtlHeader_bytes + kIgtlLargestBody_bytes);
    bytes = bytes.subspan(count);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  if (size < 2) return 0;
  const std::span<const std::uint8_t> rest(bytes + 2, size - 2);
  const std::size_t portion = 1 + bytes[1] % 64;
  // Half of the inputs are a stream as it is; for the others a header is made that fits, which no fuzzer finds by itself.
  constexpr std::array<const char*, 7> kTypes = {"TRANSFORM", "TDATA", "QTDATA", "POSITION", "STATUS", "IMAGE", "QTRANS"};
  if (bytes[0] % 2 == 0) {
    readAll(rest, portion);
    return 0;
  }
  IgtlMessage message;
  message.type = kTypes[bytes[0] / 4 % kTypes.size()];
  message.device = "Device";
  message.content.assign(rest.begin(), rest.end());
  std::vector<std::uint8_t> stream = igtlBytes(message);
  if (bytes[0] / 2 % 2 == 1) stream[1] = 2;  // then the content is read as extended header, content and metadata
  readAll(stream, portion);
  return 0;
}
