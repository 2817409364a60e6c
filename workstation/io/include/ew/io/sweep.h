#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/result.h"
#include "ew/io/sequence.h"

namespace ew {

/// Where the images of a sweep lie: per frame the transform from pixels to mm of the chosen coordinate frame, which becomes the world.
struct SweepPoses {
  std::vector<std::optional<Transform<frame::World, frame::Image>>> imageToWorld;  ///< one per frame; empty where no pose can be used
  std::size_t usable = 0;
  std::size_t invalid = 0;     ///< frames whose image or a transform needed on the way is marked INVALID or is no usable matrix
  std::size_t missing = 0;     ///< frames about which the file does not say enough
  std::string toFrame;         ///< the file's name of the frame that became the world: "Reference", "Tracker" ...
  std::vector<Message> notes;  ///< what had to be decided, and what is unusual, in sentences
};

/// Pixel to the frame of choice, frame by frame: the shortest chain over that frame's valid transforms and those of the calibration, which
/// stand in for the file's own between the same two frames. A tool that no chain needs may be invalid throughout. Calibrations that are
/// not orthogonal are used as they are, with a note when an angle is off by more than 1 %.
/// @param calibration device set with "Image" to something; may be null when the file itself says where "Image" is
/// @param toFrame     empty for the first of "Reference", "Tracker", "World" that a valid chain leads to; which one is in the notes
/// @error missingCalibration (no chain from "Image" to toFrame in any frame; names what can be reached and what to give),
///        badField (a matrix that every way needs and that cannot be used; names it and what is wrong in it),
///        noValidPose (there is a chain, but never a valid one; says how many frames are invalid and how many missing)
[[nodiscard]] Result<SweepPoses> sweepPoses(const Sequence& sequence, const DeviceSet* calibration = nullptr,
                                            std::string_view toFrame = {});

}  // namespace ew
