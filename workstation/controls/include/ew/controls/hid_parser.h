#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "ew/controls/event.h"

namespace ew::controls {

inline constexpr int kContourVendor = 0x0b33;  ///< USB

/// Whether reports of a device begin with their number: a report descriptor has the item "Report ID".
/// Source: Device Class Definition for HID 1.11, section 6.2.2.
[[nodiscard]] bool numbersReports(std::span<const std::uint8_t> descriptor);

/// The reports of one HID device to what was moved: each byte that differs from the one before gives its value, and each bit of it that
/// changed. The first report says only how everything stands. What a byte means is found by moving it (learn.h), so that no description of
/// the device is needed. Contour's ShuttleXpress and ShuttlePro are known: the ring gives 0 to 255 from one end to the other.
class HidParser {
 public:
  HidParser(std::string device, int vendor, bool numbered) : device_(std::move(device)), vendor_(vendor), numbered_(numbered) {}

  void take(std::span<const std::uint8_t> report, std::vector<ControlEvent>& events);

 private:
  std::string device_;
  int vendor_;
  bool numbered_;
  std::map<int, std::vector<std::uint8_t>> last_;  ///< by number of the report
};

}  // namespace ew::controls
