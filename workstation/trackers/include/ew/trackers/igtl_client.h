#pragma once

#include <memory>
#include <string>

#include "ew/tracking/tracker_device.h"

namespace ew {

/// An OpenIGTLink server that sends poses: PLUS, Slicer, a tracker's own program.
struct IgtlSettings {
  std::string host = "localhost";
  int port = 18944;
  bool checksSums = true;  ///< messages whose CRC is wrong are refused
  bool operator==(const IgtlSettings&) const = default;
};

[[nodiscard]] std::unique_ptr<TrackerDevice> makeIgtlClient(const IgtlSettings& settings);

}  // namespace ew
