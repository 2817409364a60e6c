#include "ew/acquisition/motor_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "ew/core/json_fields.h"
#include "ew/core/numbers.h"
#include "ew/io/gating_fields.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

using nlohmann::json;

constexpr int kFormatVersion = 1;
constexpr std::size_t kLargestFile_bytes = 8u << 20;
constexpr double kDegree_rad = std::numbers::pi / 180.0;
constexpr double kFarthest_mm = 1e4;
constexpr double kWidest_deg = 720.0;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

constexpr std::array<std::pair<std::string_view, MotorKind>, 3> kMotorKinds{
    {{"parallel", MotorKind::parallel}, {"fan", MotorKind::fan}, {"rotational", MotorKind::rotational}}};

Result<json> readObject(const std::filesystem::path& file) {
  const auto text = readTextFile(file, kLargestFile_bytes);
  if (!text) return passOn(text.error());
  return parseJsonObject(*text, say<"the motor file %1">(file.string()));
}

Transform<frame::Probe, frame::Image> imageToProbeOf(const glm::dvec2& pixel_mm, const glm::dvec2& face_px) {
  glm::dmat4 matrix(1.0);
  matrix[0][0] = pixel_mm.x;
  matrix[1][1] = pixel_mm.y;
  matrix[2][2] = 0.5 * (pixel_mm.x + pixel_mm.y);
  matrix[3] = glm::dvec4(-pixel_mm.x * face_px.x, -pixel_mm.y * face_px.y, 0.0, 1.0);
  return {matrix};
}

std::optional<std::string> fieldOf(const std::vector<std::pair<std::string, std::string>>& fields, std::string_view name) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const auto& field) { return field.first == name; });
  if (found == fields.end()) return std::nullopt;
  return found->second;
}

tl::unexpected<Error> badRecordedField(std::string_view name, const std::string& found, const Message& expected) {
  const std::string field(name);
  return failure(
      ErrorCode::badField,
      found.empty()
          ? say<"The recording has nothing for its field %1; expected %2, or describe the motor in a file.">(field, expected)
          : say<"The recording has \"%1\" for its field %2; expected %3, or describe the motor in a file.">(found, field, expected),
      {{"field", field}, {"found", found}, {"expected", expected.english()}});
}

}  // namespace

Transform<frame::World, frame::Probe> probeToWorldAt(const MotorSweep& motor, double value) {
  const glm::dmat4 one(1.0);
  glm::dvec3 axis_mm(0.0), along(0.0);
  switch (motor.kind) {
    case MotorKind::parallel:
      return {motor.startProbeToWorld.matrix * glm::translate(one, glm::dvec3(0.0, 0.0, value))};
    case MotorKind::fan:
      axis_mm = {0.0, -motor.axisBehindFace_mm, 0.0};
      along = {1.0, 0.0, 0.0};
      break;
    case MotorKind::rotational:
      axis_mm = {motor.axisOffset_mm.x, 0.0, motor.axisOffset_mm.y};
      along = {0.0, 1.0, 0.0};
      break;
  }
  return {motor.startProbeToWorld.matrix * glm::translate(one, axis_mm) * glm::rotate(one, value * kDegree_rad, along) *
          glm::translate(one, -axis_mm)};
}

Result<MotorSweep> readMotorSweep(const std::filesystem::path& path) {
  const auto object = readObject(path);
  if (!object) return passOn(object.error());
  JsonReading reading(say<"the motor file %1">(path.string()), {"name", "note", "source"});
  const JsonFields file(*object, reading);
  const auto format = file.whole("format", 1, 1000000);
  if (file.good() && format > kFormatVersion)
    return failure(ErrorCode::newerFormat,
                   say<"The motor file %1 has format %2 and this program reads up to %3; use a newer version of the program.">(
                       path.string(), format, kFormatVersion),
                   {{"file", path.string()}});

  MotorSweep motor;
  motor.kind = file.word("kind", kMotorKinds);
  const bool parallel = motor.kind == MotorKind::parallel;
  const double limit = parallel ? kFarthest_mm : kWidest_deg;
  const std::string list = parallel ? "positions_mm" : "angles_deg";
  const std::string step = parallel ? "step_mm" : "step_deg", first = parallel ? "first_mm" : "first_deg";
  std::vector<std::string> names{"format", "kind", "image", "probe_to_world", list, step, first};
  if (motor.kind == MotorKind::fan) names.emplace_back("axis_behind_face_mm");
  if (motor.kind == MotorKind::rotational) names.emplace_back("axis_offset_mm");
  file.only(names);

  motor.values = file.numbers(list, 1, 1u << 20, -limit, limit, false);
  motor.step = file.number(step, -limit, limit, 0.0);
  motor.first = file.number(first, -limit, limit, 0.0);
  if (file.has(list) == file.has(step))
    file.refuse(step, say<"there unless \"%1\" is, and not beside it: one of the two says where the frames lie">(list));
  if (!file.has(list) && motor.step == 0.0) file.refuse(step, say<"a number other than 0">());
  motor.axisBehindFace_mm = file.number("axis_behind_face_mm", -1000.0, 1000.0, 0.0);
  if (const auto offset = file.numbers("axis_offset_mm", 2, 2, -1000.0, 1000.0, false); !offset.empty())
    motor.axisOffset_mm = {offset[0], offset[1]};
  if (const auto start = file.rigid("probe_to_world")) motor.startProbeToWorld.matrix = *start;
  if (file.has("image")) {
    const JsonFields image = file.object("image");
    image.only({"pixel_mm", "face_px"});
    const auto pixel_mm =
        image.numbers("pixel_mm", 2, 2, 1e-4, 100.0, true, say<"two numbers from 0.0001 to 100, a pixel's width and height in mm">());
    const auto face_px =
        image.numbers("face_px", 2, 2, -1e6, 1e6, true, say<"two numbers within a million, the pixel at the middle of the face">());
    if (image.good()) motor.imageToProbe = imageToProbeOf({pixel_mm[0], pixel_mm[1]}, {face_px[0], face_px[1]});
  }
  if (reading.problem()) return passOn(*reading.problem());
  return motor;
}

Result<MotorSweep> recordedMotor(const Sequence& sequence) {
  MotorSweep motor;
  const std::string kind = fieldOf(sequence.otherFields, fields::kMotorKind).value_or("");
  if (kind == "PARALLEL") {
    motor.kind = MotorKind::parallel;
  } else if (kind == "FAN") {
    motor.kind = MotorKind::fan;
  } else if (kind == "ROTATIONAL") {
    motor.kind = MotorKind::rotational;
  } else {
    return badRecordedField(fields::kMotorKind, kind, say<"PARALLEL, FAN or ROTATIONAL">());
  }
  if (const auto axis = fieldOf(sequence.otherFields, fields::kMotorAxisBehindFace)) {
    const auto value = parseNumber(*axis);
    if (!value || !(std::abs(*value) <= 1000.0))
      return badRecordedField(fields::kMotorAxisBehindFace, *axis, say<"a number of millimetres">());
    motor.axisBehindFace_mm = *value;
  }
  if (const auto start = fieldOf(sequence.otherFields, fields::kMotorStart)) {
    const auto rows = parseNumbers(*start);
    if (!rows || rows->size() != 16) return badRecordedField(fields::kMotorStart, *start, say<"%1 numbers">(16));
    std::array<double, 16> rowMajor{};
    std::copy(rows->begin(), rows->end(), rowMajor.begin());
    motor.startProbeToWorld.matrix = matrixFromRows(rowMajor);
    if (const auto rigid = checkRigid(motor.startProbeToWorld.matrix); !rigid) return passOn(rigid.error());
  }
  const std::string_view name = motor.kind == MotorKind::parallel ? fields::kMotorPosition : fields::kMotorAngle;
  const double limit = motor.kind == MotorKind::parallel ? kFarthest_mm : kWidest_deg;
  for (const SequenceFrame& frame : sequence.frames) {
    const auto text = fieldOf(frame.otherFields, name);
    const auto value = text ? parseNumber(*text) : std::nullopt;
    if (text && (!value || !(std::abs(*value) <= limit))) return badRecordedField(name, *text, rangeText(-limit, limit));
    motor.values.push_back(value.value_or(kNone));
  }
  return motor;
}

Result<SweepPoses> motorPoses(const Sequence& sequence, const MotorSweep& motor, const DeviceSet* calibration) {
  if (!motor.values.empty() && motor.values.size() != sequence.frames.size())
    return failure(ErrorCode::badField,
                   say<"The motor has %1 values and the recording %2 frames; give one value for each frame, or a step.">(
                       motor.values.size(), sequence.frames.size()),
                   {{"field", "values"}});
  SweepPoses poses;
  poses.toFrame = "Reference";
  poses.imageToWorld.resize(sequence.frames.size());
  std::set<double> differing;
  bool calibrated = motor.imageToProbe.has_value();
  for (std::size_t n = 0; n < sequence.frames.size(); ++n) {
    const SequenceFrame& frame = sequence.frames[n];
    const double value = motor.values.empty() ? motor.first + static_cast<double>(n) * motor.step : motor.values[n];
    std::optional<glm::dmat4> imageToProbe;
    if (motor.imageToProbe) imageToProbe = motor.imageToProbe->matrix;
    if (!imageToProbe && calibration != nullptr) imageToProbe = chain(calibration->transforms, "Image", "Probe");
    if (!imageToProbe) imageToProbe = chain(frame.transforms, "Image", "Probe");
    calibrated = calibrated || imageToProbe.has_value();
    if (frame.imageStatus == PoseStatus::invalid) {
      ++poses.invalid;
    } else if (!std::isfinite(value) || !imageToProbe) {
      ++poses.missing;
    } else {
      poses.imageToWorld[n] = probeToWorldAt(motor, value) * Transform<frame::Probe, frame::Image>{*imageToProbe};
      ++poses.usable;
      differing.insert(value);
    }
  }
  if (!calibrated)
    return failure(ErrorCode::missingCalibration,
                   say<"Nobody says where pixels lie before the probe; give \"image\" with pixel_mm and face_px in the motor file, or the "
                       "device set (.xml) with the calibration from Image to Probe.">(),
                   {{"from", "Image"}, {"to", "Probe"}});
  if (poses.usable == 0)
    return failure(ErrorCode::noValidPose,
                   say<"No frame of the motorised sweep can be used: each is marked invalid or has no motor value.">());
  if (differing.size() == 1 && poses.usable > 1)
    return failure(ErrorCode::badField, say<"The motor does not move from frame to frame; check its step or its recorded values.">(),
                   {{"field", "step"}});
  poses.notes.push_back(say<"The poses were worked out from the motor's values, not from a tracker.">());
  return poses;
}

}  // namespace ew
