#include "ew/trackers/igtl_bodies.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>

#include "ew/core/contract.h"
#include "igtl_numbers.h"

namespace ew {
namespace {

using IgtlBytes = std::span<const std::uint8_t>;

constexpr std::size_t kIgtlTransform_bytes = 48, kIgtlTool_bytes = 20, kIgtlTracking_bytes = 70, kIgtlQuaternion_bytes = 28,
                      kIgtlQTracking_bytes = 50;
constexpr double kIgtlRounding = 1e-3;
constexpr double kIgtlFarthest_mm = 1e5;

/// Twelve numbers: the three axes, then the origin.
glm::dmat4 igtlMatrixAt(IgtlBytes bytes, std::size_t at) {
  glm::dmat4 matrix{1.0};
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row, at += 4) matrix[column][row] = igtlFloatAt(bytes, at);
  return matrix;
}

/// Place and quaternion (x, y, z, w); a quaternion that is none gives not a number.
glm::dmat4 igtlPlaceAt(IgtlBytes bytes, std::size_t at, bool withW) {
  glm::dvec3 place, v;
  for (int n = 0; n < 3; ++n) {
    place[n] = igtlFloatAt(bytes, at + static_cast<std::size_t>(4 * n));
    v[n] = igtlFloatAt(bytes, at + static_cast<std::size_t>(12 + 4 * n));
  }
  const double w = withW ? igtlFloatAt(bytes, at + 24) : std::sqrt(std::max(0.0, 1.0 - glm::dot(v, v)));
  const glm::dquat rotation(w, v.x, v.y, v.z);
  const double length = glm::length(rotation);
  glm::dmat4 matrix{std::numeric_limits<double>::quiet_NaN()};
  if (std::abs(length - 1.0) < 1e-2) matrix = glm::mat4_cast(rotation / length);
  matrix[3] = glm::dvec4(place, 1.0);
  return matrix;
}

/// The rotation nearest to a matrix that almost is one. Source: Higham, SIAM J. Sci. Stat. Comput. 7(4), 1986: X <- (X + X^-T) / 2, whose
/// error is squared at each step; three take 1e-3 below what a double holds.
glm::dmat3 nearestIgtlRotation(glm::dmat3 almost) {
  for (int n = 0; n < 3; ++n) almost = 0.5 * (almost + glm::transpose(glm::inverse(almost)));
  return almost;
}

void refuseIgtlPose(IgtlPose& pose, Message why) {
  pose.state = TrackingState::invalid;
  pose.refusal = std::move(why);
}

IgtlPose judgedIgtlPose(std::string tool, const glm::dmat4& matrix) {
  IgtlPose pose{.tool = std::move(tool)};
  bool isFinite = true;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) isFinite = isFinite && std::isfinite(matrix[column][row]);
  if (!isFinite) {
    refuseIgtlPose(pose, say<"The tracker sends numbers for the tool %1 that are none, as some do while they do not see it.">(pose.tool));
  } else if (glm::length(glm::dvec3(matrix[3])) > kIgtlFarthest_mm) {
    refuseIgtlPose(pose, say<"The tracker puts the tool %1 farther away than 100 m, as some do while they do not see it.">(pose.tool));
  } else if (matrix == glm::dmat4(1.0)) {
    refuseIgtlPose(pose,
                   say<"The tracker sends the identity as the pose of the tool %1, as PLUS does while a tool is not seen.">(pose.tool));
  } else if (!checkRigid(matrix, kIgtlRounding)) {
    refuseIgtlPose(
        pose, say<"The tracker sends a pose of the tool %1 that is not a rotation and a translation; check what the server sends under "
                  "that name.">(pose.tool));
  } else {
    pose.toolToTracker.matrix = glm::dmat4(nearestIgtlRotation(glm::dmat3(matrix)));
    pose.toolToTracker.matrix[3] = matrix[3];
  }
  return pose;
}

/// 3: only the tip's place is known; 4: the turn about the own axis is not.
void judgeIgtlKind(IgtlPose& pose, int kind) {
  if (kind == 3 || kind == 4)
    refuseIgtlPose(
        pose, say<"The tracker does not measure how the tool %1 is turned; a probe needs a tool with six degrees of freedom.">(pose.tool));
}

/// What PLUS says of a pose beside its numbers.
void judgeIgtlWords(IgtlPose& pose, const IgtlMessage& message) {
  std::string status, valid;
  for (const auto& [key, value] : message.words) {
    if (key == "TransformStatus") status = value.starts_with("TOOL_") ? value.substr(5) : value;
    if (key == "TransformValid") valid = value;
  }
  if (status == "OUT_OF_VIEW" || status == "MISSING") {
    pose.state = TrackingState::outOfView;
    pose.refusal = {};
  } else if (status == "OUT_OF_VOLUME") {
    if (pose.state == TrackingState::live) pose.state = TrackingState::outOfRange;
  } else if ((!status.empty() && status != "OK" && status != "UNKNOWN" && !status.starts_with("SWITCH")) || valid == "false" ||
             valid == "0" || valid == "False") {
    refuseIgtlPose(pose, say<"The tracker marks the pose of the tool %1 as not valid.">(pose.tool));
  }
}

tl::unexpected<Error> wrongIgtlLength(const IgtlMessage& message) {
  return failure(ErrorCode::truncated, say<"A message of the type %1 from %2 has a length that does not fit its type; it was left out.">(
                                           message.type, message.device));
}

}  // namespace

Result<std::vector<IgtlPose>> igtlPoses(const IgtlMessage& message) {
  const IgtlBytes bytes = message.content;
  std::vector<IgtlPose> poses;
  if (message.type == "TRANSFORM") {
    if (bytes.size() != kIgtlTransform_bytes) return wrongIgtlLength(message);
    poses.push_back(judgedIgtlPose(message.device, igtlMatrixAt(bytes, 0)));
  } else if (message.type == "POSITION" || message.type == "QTRANS") {
    if (bytes.size() == 12) {
      poses.push_back({.tool = message.device});
      judgeIgtlKind(poses.back(), 3);
    } else if (bytes.size() == 24 || bytes.size() == kIgtlQuaternion_bytes) {
      poses.push_back(judgedIgtlPose(message.device, igtlPlaceAt(bytes, 0, bytes.size() == kIgtlQuaternion_bytes)));
    } else {
      return wrongIgtlLength(message);
    }
  } else if (message.type == "TDATA" || message.type == "QTDATA") {
    const bool isMatrix = message.type == "TDATA";
    const std::size_t one = isMatrix ? kIgtlTracking_bytes : kIgtlQTracking_bytes;
    if (bytes.size() % one != 0) return wrongIgtlLength(message);
    for (std::size_t at = 0; at < bytes.size(); at += one) {
      const std::size_t numbers = at + kIgtlTool_bytes + 2;
      poses.push_back(judgedIgtlPose(igtlNameAt(bytes, at, kIgtlTool_bytes),
                                     isMatrix ? igtlMatrixAt(bytes, numbers) : igtlPlaceAt(bytes, numbers, true)));
      judgeIgtlKind(poses.back(), bytes[at + kIgtlTool_bytes]);
    }
  }
  for (IgtlPose& pose : poses) judgeIgtlWords(pose, message);
  return poses;
}

std::optional<IgtlStatus> igtlStatus(const IgtlMessage& message) {
  const IgtlBytes bytes = message.content;
  constexpr std::size_t kFixed_bytes = 2 + 8 + 20;
  if (message.type != "STATUS" || bytes.size() < kFixed_bytes) return std::nullopt;
  IgtlStatus status;
  status.code = igtlUnsignedAt<std::uint16_t>(bytes, 0);
  status.subcode = static_cast<std::int64_t>(igtlUnsignedAt<std::uint64_t>(bytes, 2));
  status.name = igtlNameAt(bytes, 10, 20);
  status.text = igtlNameAt(bytes, kFixed_bytes, std::min<std::size_t>(bytes.size() - kFixed_bytes, 300));
  return status;
}

std::vector<std::uint8_t> igtlTransformContent(const glm::dmat4& toolToTracker) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(kIgtlTransform_bytes);
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) igtlPutFloat(bytes, toolToTracker[column][row]);
  return bytes;
}

std::vector<std::uint8_t> igtlStatusContent(const IgtlStatus& status) {
  std::vector<std::uint8_t> bytes;
  igtlPut(bytes, static_cast<std::uint16_t>(status.code));
  igtlPut(bytes, static_cast<std::uint64_t>(status.subcode));
  igtlPutName(bytes, status.name, 20);
  igtlPutName(bytes, status.text, status.text.size() + 1);
  return bytes;
}

std::vector<std::uint8_t> igtlImageContent(ImageView<const std::uint8_t> image, const glm::dmat4& imageToRas) {
  EW_EXPECTS(image.width > 0 && image.width <= 65535 && image.height > 0 && image.height <= 65535);
  const glm::dvec3 across(imageToRas[0]), down(imageToRas[1]);
  glm::dvec3 through(imageToRas[2]);
  if (!(glm::length(through) > 1e-9)) through = glm::normalize(glm::cross(across, down));
  const glm::dvec3 centre = glm::dvec3(imageToRas[3]) + across * (0.5 * (image.width - 1)) + down * (0.5 * (image.height - 1));

  std::vector<std::uint8_t> bytes;
  const auto columns = static_cast<std::size_t>(image.width);
  bytes.reserve(72 + columns * static_cast<std::size_t>(image.height));
  igtlPut(bytes, std::uint16_t{1});
  constexpr std::uint8_t kOneComponent = 1, kUnsigned8 = 3, kLittleEndian = 2, kRas = 1;
  bytes.insert(bytes.end(), {kOneComponent, kUnsigned8, kLittleEndian, kRas});
  const auto putSize = [&] {
    igtlPut(bytes, static_cast<std::uint16_t>(image.width));
    igtlPut(bytes, static_cast<std::uint16_t>(image.height));
    igtlPut(bytes, std::uint16_t{1});
  };
  putSize();
  for (const glm::dvec3& column : {across, down, through, centre})
    for (int row = 0; row < 3; ++row) igtlPutFloat(bytes, column[row]);
  for (int n = 0; n < 3; ++n) igtlPut(bytes, std::uint16_t{0});
  putSize();
  for (int y = 0; y < image.height; ++y) bytes.insert(bytes.end(), image.row(y), image.row(y) + columns);
  return bytes;
}

std::vector<std::uint8_t> igtlStartTrackingContent() {
  std::vector<std::uint8_t> bytes;
  igtlPut(bytes, std::uint32_t{0});  // milliseconds between two; 0: as fast as they are measured
  igtlPutName(bytes, "", 32);        // in the coordinates the server likes
  return bytes;
}

}  // namespace ew
