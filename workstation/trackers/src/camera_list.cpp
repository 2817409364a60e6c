#include <fcntl.h>
#include <linux/videodev2.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "ew/trackers/camera_device.h"

namespace ew {
namespace {

/// A camera has nodes beside the one for images: for descriptions of them, for its controls. True also where it cannot be asked.
bool deliversImages(const std::string& device) {
  const int node = ::open(device.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (node < 0) return true;
  v4l2_capability can{};
  const bool answered = ::ioctl(node, VIDIOC_QUERYCAP, &can) == 0;
  ::close(node);
  if (!answered) return true;
  const auto does = (can.capabilities & V4L2_CAP_DEVICE_CAPS) != 0 ? can.device_caps : can.capabilities;
  return (does & (V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_VIDEO_CAPTURE_MPLANE)) != 0;
}

}  // namespace

std::vector<CameraHere> camerasHere() {
  namespace fs = std::filesystem;
  std::vector<CameraHere> found;
  std::error_code ignored;
  for (fs::directory_iterator at("/sys/class/video4linux", ignored), end; !ignored && at != end; at.increment(ignored)) {
    CameraHere camera{"/dev/" + at->path().filename().string(), {}};
    if (!fs::exists(camera.device, ignored) || !deliversImages(camera.device)) continue;
    std::ifstream name(at->path() / "name");
    std::getline(name, camera.name);
    if (camera.name.empty()) camera.name = camera.device;
    found.push_back(std::move(camera));
  }
  // video2 before video10
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return std::pair(a.device.size(), a.device) < std::pair(b.device.size(), b.device); });
  return found;
}

}  // namespace ew
