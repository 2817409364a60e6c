#pragma once

#include <cmath>
#include <cstdint>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <string>
#include <vector>

#include "ew/trackers/igtl_bodies.h"

/// Messages for the tests of OpenIGTLink.
namespace ew::test {

using Bytes = std::vector<std::uint8_t>;

/// A rigid pose without symmetry, another one for each n.
inline glm::dmat4 igtlPoseNumber(int n) {
  const glm::dmat4 place = glm::translate(glm::dmat4(1.0), glm::dvec3(100.0 + 0.25 * (n % 1000), -40.0, 7.5));
  return glm::rotate(place, 0.3 + 0.001 * (n % 1000), glm::normalize(glm::dvec3(1.0, 2.0, -0.5)));
}

inline IgtlMessage transformMessage(const glm::dmat4& matrix, const std::string& tool = "ProbeToTracker", double time_s = 1000.5,
                                    int version = 1) {
  IgtlMessage message;
  message.version = version;
  message.type = "TRANSFORM";
  message.device = tool;
  message.time_s = time_s;
  message.content = igtlTransformContent(matrix);
  return message;
}

inline IgtlMessage statusMessage(int code, const std::string& text = "") {
  IgtlMessage message;
  message.type = "STATUS";
  message.device = "Server";
  message.time_s = 1000.0;
  message.content = igtlStatusContent({.code = code, .subcode = 0, .name = "", .text = text});
  return message;
}

/// What a tracker's server sends as TDATA, as the protocol has it: for each tool a name of 20 bytes, 2 for six degrees of freedom, a zero,
/// and the twelve numbers of TRANSFORM. Our own side only reads it.
inline Bytes igtlTrackingContent(const std::vector<IgtlPose>& tools) {
  Bytes bytes;
  for (const IgtlPose& tool : tools) {
    std::string name = tool.tool;
    name.resize(20, '\0');
    bytes.insert(bytes.end(), name.begin(), name.end());
    bytes.insert(bytes.end(), {2, 0});
    const Bytes numbers = igtlTransformContent(tool.toolToTracker.matrix);
    bytes.insert(bytes.end(), numbers.begin(), numbers.end());
  }
  return bytes;
}

inline IgtlMessage trackingMessage(const std::vector<std::string>& tools, int n = 0) {
  IgtlMessage message;
  message.type = "TDATA";
  message.device = "Tracker";
  message.time_s = 1000.0 + n;
  std::vector<IgtlPose> poses;
  for (const std::string& tool : tools) {
    IgtlPose pose;
    pose.tool = tool;
    pose.toolToTracker.matrix = igtlPoseNumber(n);
    poses.push_back(pose);
  }
  message.content = igtlTrackingContent(poses);
  return message;
}

inline void append(Bytes& bytes, const Bytes& more) { bytes.insert(bytes.end(), more.begin(), more.end()); }

/// The largest difference of two matrices' entries.
inline double difference(const glm::dmat4& a, const glm::dmat4& b) {
  double largest = 0.0;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) {
      const double one = std::abs(a[column][row] - b[column][row]);
      largest = std::isnan(one) ? std::numeric_limits<double>::infinity() : std::max(largest, one);
    }
  return largest;
}

}  // namespace ew::test
