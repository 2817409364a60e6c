#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/image.h"
#include "ew/trackers/igtl_wire.h"
#include "ew/tracking/tool_reading.h"

namespace ew {

/// What a message says of one tool.
struct IgtlPose {
  std::string tool;  ///< the device of TRANSFORM and POSITION ("ProbeToTracker"), the name in the list of TDATA and QTDATA
  /// live, outOfRange, outOfView or invalid
  TrackingState state = TrackingState::live;
  Transform<frame::Tracker, frame::Tool> toolToTracker{};  ///< rigid where live or outOfRange
  Message refusal{};                                       ///< why it is invalid; empty otherwise
};

/// The poses of a TRANSFORM, POSITION, QTRANS, TDATA or QTDATA, in their order; none of a message of another type.
/// Coordinates stay the tracker's own: those messages carry no flag of RAS or LPS.
/// Live are rigid poses alone. Rounding is taken out of them: where axes are off by at most 1e-3, the nearest rotation stands. Invalid are
/// numbers that are not finite or beyond 100 m (trackers write a lost tool as -3.7e28), the exact identity (PLUS and others send it for a
/// tool that is not seen), and what is not rigid. Where PLUS adds the words TransformStatus or TransformValid, they decide.
/// @error truncated when the body's length does not fit its type
[[nodiscard]] Result<std::vector<IgtlPose>> igtlPoses(const IgtlMessage& message);

struct IgtlStatus {
  int code = 1;  ///< 1: all is well; the rest as the protocol counts them, 0 to 19
  std::int64_t subcode = 0;
  std::string name;  ///< at most 20 bytes
  std::string text;  ///< in the server's own words
  bool operator==(const IgtlStatus&) const = default;
};

/// Nothing of a message of another type, or of a broken one.
[[nodiscard]] std::optional<IgtlStatus> igtlStatus(const IgtlMessage& message);
/// What a status other than 1 means to a person, with the server's own words.
[[nodiscard]] Message igtlStatusSentence(const IgtlStatus& status);

/// Contents to send.
[[nodiscard]] std::vector<std::uint8_t> igtlTransformContent(const glm::dmat4& toolToTracker);
[[nodiscard]] std::vector<std::uint8_t> igtlStatusContent(const IgtlStatus& status);
/// One slice of 8 bit pixels.
/// @param imageToRas pixels (centre of the first one at 0, 0) to mm, right, anterior, superior: Slicer reads every image as RAS, whatever
/// its flag.
///        The slice is 1 mm thick where the third column has no length.
/// The protocol wants the place of the image's centre, not of its first pixel.
[[nodiscard]] std::vector<std::uint8_t> igtlImageContent(ImageView<const std::uint8_t> image, const glm::dmat4& imageToRas);
/// Asks a server for all its tools as often as it has them: STT_TDATA.
[[nodiscard]] std::vector<std::uint8_t> igtlStartTrackingContent();

}  // namespace ew
