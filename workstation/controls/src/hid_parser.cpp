#include "ew/controls/hid_parser.h"

#include <algorithm>
#include <bit>

namespace ew::controls {
namespace {

constexpr int kFarthestOfRing = 7;

}  // namespace

bool numbersReports(std::span<const std::uint8_t> descriptor) {
  constexpr std::uint8_t kLongItem = 0xFE, kReportId = 0x84, kTagAndType = 0xFC;
  for (std::size_t at = 0; at < descriptor.size();) {
    const std::uint8_t prefix = descriptor[at];
    if (prefix == kLongItem) {
      if (at + 1 >= descriptor.size()) return false;
      at += 3 + std::size_t{descriptor[at + 1]};
      continue;
    }
    if ((prefix & kTagAndType) == kReportId) return true;
    const std::size_t size = (prefix & 3U) == 3U ? 4U : prefix & 3U;
    at += 1 + size;
  }
  return false;
}

void HidParser::take(std::span<const std::uint8_t> report, std::vector<ControlEvent>& events) {
  if (report.empty()) return;
  const int number = numbered_ ? report[0] : 0;
  std::vector<std::uint8_t> bytes(report.begin() + (numbered_ ? 1 : 0), report.end());
  if (vendor_ == kContourVendor && !bytes.empty()) {
    const int ring = std::clamp<int>(std::bit_cast<std::int8_t>(bytes[0]), -kFarthestOfRing, kFarthestOfRing);
    bytes[0] = static_cast<std::uint8_t>((ring + kFarthestOfRing) * 255 / (2 * kFarthestOfRing));
  }
  const auto last = last_.find(number);
  if (last != last_.end()) {
    for (std::size_t at = 0; at < std::min(bytes.size(), last->second.size()); ++at) {
      const unsigned changed = bytes[at] ^ last->second[at];
      if (changed == 0) continue;
      const int index = static_cast<int>(at);
      events.push_back({{device_, ControlKind::hidByte, number, index}, bytes[at]});
      for (int bit = 0; bit < 8; ++bit)
        if ((changed >> bit & 1U) != 0) events.push_back({{device_, ControlKind::hidBit, number, 8 * index + bit}, bytes[at] >> bit & 1});
    }
  }
  last_[number] = std::move(bytes);
}

}  // namespace ew::controls
