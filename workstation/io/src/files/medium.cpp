#include "ew/io/medium.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <system_error>

namespace ew {
namespace fs = std::filesystem;
namespace {

std::string firstLineOf(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

/// Where a device hangs is in its place in the tree of devices: one on a cable says by itself that it is not removable, for only its
/// medium would count.
bool isOnCable(const fs::path& place) {
  return std::any_of(place.begin(), place.end(), [](const fs::path& part) {
    const std::string name = part.string();
    return name.starts_with("usb") || name.starts_with("firewire") || name.starts_with("thunderbolt");
  });
}

}  // namespace

bool canBePulledOut(const fs::path& device) {
  std::error_code failed;
  const fs::path place = fs::canonical(device, failed);
  if (failed) return false;
  if (isOnCable(place)) return true;
  const auto isLoose = [](const fs::path& disk) {
    return firstLineOf(disk / "removable") == "1" || firstLineOf(disk / "device" / "type") == "SD";
  };
  return isLoose(place) || isLoose(place.parent_path());  // a disk, or a partition of one
}

}  // namespace ew
