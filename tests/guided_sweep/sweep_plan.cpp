#include "sweep_plan.h"

#include <algorithm>
#include <array>
#include <glm/gtc/quaternion.hpp>

namespace guided_sweep {
namespace {

ew::Pose poseOf(const nlohmann::json& sixteen) {
  ew::Pose pose;
  pose.probeToWorld.matrix = ew::matrixFromRows(sixteen.get<std::array<double, 16>>());
  return pose;
}

}  // namespace

const char* const kSchema = R"({
  "$schema": "http://json-schema.org/draft-07/schema#",
  "description": "an object with start, end and duration_s",
  "type": "object",
  "properties": {
    "start": {"description": "16 numbers, probe to world, row by row", "type": "array", "minItems": 16, "maxItems": 16,
              "items": {"description": "a number", "type": "number"}},
    "end": {"description": "16 numbers, probe to world, row by row", "type": "array", "minItems": 16, "maxItems": 16,
            "items": {"description": "a number", "type": "number"}},
    "duration_s": {"description": "a number from 1 to 60", "type": "number", "minimum": 1, "maximum": 60}
  }
})";

nlohmann::json toJson(const SweepPlan& plan) {
  nlohmann::json section = {{"duration_s", plan.duration_s}};
  if (plan.start) section["start"] = ew::rowsOf(plan.start->probeToWorld.matrix);
  if (plan.end) section["end"] = ew::rowsOf(plan.end->probeToWorld.matrix);
  return section;
}

SweepPlan planOf(const nlohmann::json& section) {
  SweepPlan plan;
  plan.duration_s = section.value("duration_s", plan.duration_s);
  if (section.contains("start")) plan.start = poseOf(section["start"]);
  if (section.contains("end")) plan.end = poseOf(section["end"]);
  return plan;
}

ew::Pose poseAlong(const SweepPlan& plan, double part) {
  const glm::dmat4& from = plan.start->probeToWorld.matrix;
  const glm::dmat4& to = plan.end->probeToWorld.matrix;
  ew::Pose pose;
  pose.probeToWorld.matrix = glm::dmat4(glm::mat3_cast(glm::slerp(glm::quat_cast(glm::dmat3(from)), glm::quat_cast(glm::dmat3(to)), part)));
  pose.probeToWorld.matrix[3] = glm::mix(from[3], to[3], part);
  return pose;
}

double length_mm(const SweepPlan& plan) {
  return plan.isWhole() ? glm::distance(glm::dvec3(plan.start->probeToWorld.matrix[3]), glm::dvec3(plan.end->probeToWorld.matrix[3])) : 0.0;
}

ew::Pose SweepPath::poseAt(double time_s) const {
  ew::Pose pose = poseAlong(plan_, std::clamp((time_s - begin_s_) / plan_.duration_s, 0.0, 1.0));
  pose.time_s = time_s;
  return pose;
}

}  // namespace guided_sweep
