#include "ew/acquisition/motor_sweep.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "ew/core/nesting.h"
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

std::string rangeText(double lowest, double highest) { return "a number from " + textOf(lowest) + " to " + textOf(highest); }

/// Reads fields one after another and keeps the first complaint.
class MotorFile {
 public:
  MotorFile(const json& object, std::string file) : object_(object), file_(std::move(file)) {}

  void refuse(const std::string& field, const std::string& expected) {
    if (complaint_) return;
    const auto found = object_.find(field);
    std::string shown = found == object_.end() ? "nothing" : found->dump(-1, ' ', true, json::error_handler_t::replace);
    if (shown.size() > 40) shown = shown.substr(0, 40) + "...";
    complaint_ = Error{ErrorCode::badField,
                       "The motor file " + file_ + " has " + shown + " for \"" + field + "\"; it must be " + expected + ".",
                       {{"file", file_}, {"field", field}, {"found", shown}, {"expected", expected}}};
  }
  void allow(const std::set<std::string>& names) {
    for (const auto& [name, value] : object_.items())
      if (!names.contains(name)) refuse(name, "left out, as a sweep of this kind has no such field");
  }
  [[nodiscard]] bool has(const char* field) const { return object_.contains(field); }
  double number(const char* field, double lowest, double highest, double usual) {
    const auto found = object_.find(field);
    if (found == object_.end()) return usual;
    const double value = found->is_number() ? found->get<double>() : kNone;
    if (value >= lowest && value <= highest) return value;
    refuse(field, rangeText(lowest, highest));
    return usual;
  }
  std::vector<double> numbers(const char* field, std::size_t atLeast, std::size_t atMost, double lowest, double highest) {
    std::vector<double> values;
    const auto found = object_.find(field);
    if (found == object_.end()) return values;
    bool fits = found->is_array() && found->size() >= atLeast && found->size() <= atMost;
    for (std::size_t n = 0; fits && n < found->size(); ++n) {
      values.push_back((*found)[n].is_number() ? (*found)[n].get<double>() : kNone);
      fits = values.back() >= lowest && values.back() <= highest;
    }
    if (fits) return values;
    const std::string count = atLeast == atMost ? std::to_string(atLeast) : std::to_string(atLeast) + " to " + std::to_string(atMost);
    refuse(field, "a list of " + count + " numbers from " + textOf(lowest) + " to " + textOf(highest));
    return {};
  }
  [[nodiscard]] const std::optional<Error>& complaint() const { return complaint_; }

 private:
  const json& object_;
  std::string file_;
  std::optional<Error> complaint_;
};

Result<json> readObject(const std::filesystem::path& file) {
  const auto text = readTextFile(file, kLargestFile_bytes);
  if (!text) return passOn(text.error());
  const std::string name = file.string();
  json object = nestsDeeperThan(*text, 32) ? json(json::value_t::discarded) : json::parse(*text, nullptr, false);
  if (object.is_discarded() || !object.is_object())
    return failure(ErrorCode::badHeader, "The motor file " + name + " is not a JSON object; check it with a JSON editor.",
                   {{"file", name}});
  const auto format = object.find("format");
  if (format == object.end() || !format->is_number_integer() || format->get<long long>() < 1)
    return failure(ErrorCode::badField, "The motor file " + name + " does not say \"format\": 1; add it.",
                   {{"file", name}, {"field", "format"}});
  if (format->get<long long>() > kFormatVersion)
    return failure(ErrorCode::newerFormat,
                   "The motor file " + name + " has format " + std::to_string(format->get<long long>()) + " and this program reads up to " +
                       std::to_string(kFormatVersion) + "; use a newer version of the program.",
                   {{"file", name}});
  return object;
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

tl::unexpected<Error> badRecordedField(std::string_view name, const std::string& found, const std::string& expected) {
  return failure(ErrorCode::badField,
                 "The recording has " + (found.empty() ? std::string("nothing") : "\"" + found + "\"") + " for its field " +
                     std::string(name) + "; expected " + expected + ", or describe the motor in a file.",
                 {{"field", std::string(name)}, {"found", found}, {"expected", expected}});
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
  MotorFile file(*object, path.string());
  MotorSweep motor;
  const auto kind = object->find("kind");
  const std::string word = kind != object->end() && kind->is_string() ? kind->get<std::string>() : "";
  std::set<std::string> names{"format", "name", "note", "source", "kind", "image", "probe_to_world"};
  if (word == "parallel") {
    motor.kind = MotorKind::parallel;
    names.insert({"step_mm", "first_mm", "positions_mm"});
  } else if (word == "fan") {
    motor.kind = MotorKind::fan;
    names.insert({"step_deg", "first_deg", "angles_deg", "axis_behind_face_mm"});
  } else if (word == "rotational") {
    motor.kind = MotorKind::rotational;
    names.insert({"step_deg", "first_deg", "angles_deg", "axis_offset_mm"});
  } else {
    file.refuse("kind", "\"parallel\", \"fan\" or \"rotational\"");
  }
  if (!file.complaint()) file.allow(names);

  const bool parallel = motor.kind == MotorKind::parallel;
  const double limit = parallel ? kFarthest_mm : kWidest_deg;
  const char* const list = parallel ? "positions_mm" : "angles_deg";
  const char* const step = parallel ? "step_mm" : "step_deg";
  motor.values = file.numbers(list, 1, 1u << 20, -limit, limit);
  motor.step = file.number(step, -limit, limit, 0.0);
  motor.first = file.number(parallel ? "first_mm" : "first_deg", -limit, limit, 0.0);
  if (file.has(list) == file.has(step))
    file.refuse(step, std::string("there unless \"") + list + "\" is, and not beside it: one of the two says where the frames lie");
  if (!file.has(list) && motor.step == 0.0) file.refuse(step, "a number other than 0");
  motor.axisBehindFace_mm = file.number("axis_behind_face_mm", -1000.0, 1000.0, 0.0);
  if (const auto offset = file.numbers("axis_offset_mm", 2, 2, -1000.0, 1000.0); !offset.empty())
    motor.axisOffset_mm = {offset[0], offset[1]};

  if (file.has("probe_to_world")) {
    const auto rows = file.numbers("probe_to_world", 16, 16, -1e9, 1e9);
    if (!rows.empty()) {
      std::array<double, 16> rowMajor{};
      std::copy(rows.begin(), rows.end(), rowMajor.begin());
      motor.startProbeToWorld.matrix = matrixFromRows(rowMajor);
      if (const auto rigid = checkRigid(motor.startProbeToWorld.matrix); !rigid)
        file.refuse("probe_to_world", "a rotation and a translation, 16 numbers row by row");
    }
  }
  if (const auto image = object->find("image"); image != object->end()) {
    const json fields = image->is_object() ? *image : json::object();
    MotorFile part(fields, path.string());
    part.allow({"pixel_mm", "face_px"});
    const auto pixel_mm = part.numbers("pixel_mm", 2, 2, 1e-4, 100.0);
    const auto face_px = part.numbers("face_px", 2, 2, -1e6, 1e6);
    if (pixel_mm.empty()) part.refuse("pixel_mm", "two numbers, the width and height of a pixel in mm");
    if (face_px.empty()) part.refuse("face_px", "two numbers, the pixel where the middle of the face lies");
    if (part.complaint()) return passOn(*part.complaint());
    motor.imageToProbe = imageToProbeOf({pixel_mm[0], pixel_mm[1]}, {face_px[0], face_px[1]});
  }
  if (file.complaint()) return passOn(*file.complaint());
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
    return badRecordedField(fields::kMotorKind, kind, "PARALLEL, FAN or ROTATIONAL");
  }
  if (const auto axis = fieldOf(sequence.otherFields, fields::kMotorAxisBehindFace)) {
    const auto value = parseNumber(*axis);
    if (!value || !(std::abs(*value) <= 1000.0)) return badRecordedField(fields::kMotorAxisBehindFace, *axis, "a number of millimetres");
    motor.axisBehindFace_mm = *value;
  }
  if (const auto start = fieldOf(sequence.otherFields, fields::kMotorStart)) {
    const auto rows = parseNumbers(*start);
    if (!rows || rows->size() != 16) return badRecordedField(fields::kMotorStart, *start, "16 numbers");
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
                   "The motor has " + std::to_string(motor.values.size()) + " values and the recording " +
                       std::to_string(sequence.frames.size()) + " frames; give one value for each frame, or a step.",
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
    return failure(
        ErrorCode::missingCalibration,
        "Nobody says where pixels lie before the probe; give \"image\" with pixel_mm and face_px in the motor file, or the device "
        "set (.xml) with the calibration from Image to Probe.",
        {{"from", "Image"}, {"to", "Probe"}});
  if (poses.usable == 0)
    return failure(ErrorCode::noValidPose, "No frame of the motorised sweep can be used: each is marked invalid or has no motor value.");
  if (differing.size() == 1 && poses.usable > 1)
    return failure(ErrorCode::badField, "The motor does not move from frame to frame; check its step or its recorded values.",
                   {{"field", "step"}});
  poses.notes.push_back("The poses were worked out from the motor's values, not from a tracker.");
  return poses;
}

}  // namespace ew
