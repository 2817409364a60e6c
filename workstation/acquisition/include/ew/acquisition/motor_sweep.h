#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/result.h"
#include "ew/io/sequence.h"
#include "ew/io/sweep.h"

namespace ew {

enum class MotorKind {
  parallel,   ///< pushes the probe along its z, frames parallel
  fan,        ///< tilts the image plane about an axis parallel to the face's x
  rotational  ///< turns the image plane about an axis parallel to the beam
};

/// How a motor carried the probe while frames were taken. Values are mm for parallel and degrees for the others, positive along +z and by
/// the right hand about +x (fan) and +y (rotational) of the probe.
struct MotorSweep {
  MotorKind kind = MotorKind::parallel;
  double first = 0.0;               ///< value at frame 0
  double step = 0.0;                ///< from frame to frame, not 0 unless `values` are given
  std::vector<double> values = {};  ///< one per frame, in place of first and step; a NaN stands for a frame whose value was not recorded
  double axisBehindFace_mm = 0.0;   ///< fan: the axis runs through (0, -axisBehindFace_mm, 0); below 0: in front of the face
  glm::dvec2 axisOffset_mm{0.0};    ///< rotational: the axis runs through (x, 0, z) = (axisOffset_mm.x, 0, axisOffset_mm.y)
  std::optional<Transform<frame::Probe, frame::Image>> imageToProbe = {};  ///< absent: the recording's or device set's chain Image to Probe
  Transform<frame::World, frame::Probe> startProbeToWorld = {};            ///< pose at value 0
  bool operator==(const MotorSweep&) const = default;
};

/// Pose of the probe at a value of the motor:
/// parallel: start * T(0, 0, v); fan: start * T(a) R_x(v) T(-a), a = (0, -axisBehindFace, 0); rotational: start * T(o) R_y(v) T(-o).
[[nodiscard]] Transform<frame::World, frame::Probe> probeToWorldAt(const MotorSweep& motor, double value);

/// Reads resources/schemas/motor-sweep.schema.json.
/// @error notFound, notReadable, tooLarge, badHeader (not JSON), badField (field, found, expected), newerFormat
[[nodiscard]] Result<MotorSweep> readMotorSweep(const std::filesystem::path& file);

/// What a recording says about its motor in the fields of ew/io/gating_fields.h.
/// @error badField (no motor fields, or one that cannot be used, by name)
[[nodiscard]] Result<MotorSweep> recordedMotor(const Sequence& sequence);

/// Where the images of a motorised sweep lie. Frames marked INVALID, and frames without a value, get no pose and are counted.
/// @param calibration device set with Image to Probe; may be null
/// @error noValidPose, missingCalibration (neither the motor file nor the recording says where pixels lie in the probe's frame),
///        badField (values that do not fit the number of frames, or that are all the same: the frames would lie in one plane)
[[nodiscard]] Result<SweepPoses> motorPoses(const Sequence& sequence, const MotorSweep& motor, const DeviceSet* calibration = nullptr);

}  // namespace ew
