#include "ew/library/case_truth.h"

#include <algorithm>

#include "ew/core/json_fields.h"
#include "ew/io/step_store.h"
#include "ew/phantom/truth.h"
#include "making/case_pipeline.h"
#include "making/case_truth_file.h"

namespace ew {
namespace {

using nlohmann::json;

json pointOf(const glm::dvec3& p_mm) { return {p_mm.x, p_mm.y, p_mm.z}; }

glm::dvec3 pointOf(const json& three) { return {three.at(0).get<double>(), three.at(1).get<double>(), three.at(2).get<double>()}; }

/// The patient is made in the frame of the file that it becomes.
Transform<frame::File, frame::Probe> planeOf(const json& rows) { return {matrixFromRows(rows.get<std::array<double, 16>>())}; }

/// The element of a list of objects that has this name, or the names there are.
/// @param noSuch what the patient has not: "no such organ"
Result<json> named(const json& list, const std::string& name, const std::string& field, const Message& noSuch) {
  std::string names;
  for (const json& each : list) {
    if (each.at("name") == name) return each;
    names += (names.empty() ? "" : ", ") + each.at("name").get<std::string>();
  }
  return failure(ErrorCode::badField,
                 names.empty() ? say<"'%1' in case.json is \"%2\", and the patient has %3.">(field, name, noSuch)
                               : say<"'%1' in case.json is \"%2\", and the patient has %3; it has %4.">(field, name, noSuch, names),
                 {{"field", field}, {"found", name}, {"expected", names}});
}

/// The patient's truth, from the cache or from the patient.
Result<json> patientTruth(const Case& opened, Progress& progress) {
  const auto plan = planOf(opened);
  if (!plan) return passOn(plan.error());
  if (auto kept = StepStore::peek(cacheFolder(), preparationSteps()).find(kTruths, plan->truth)) return std::move(*kept);
  progress.report(say<"Reading the patient">(), 0.1);
  PartOfProgress reading(progress, 0.1, 0.8);
  const auto patient = readPatient(plan->patientFile, plan->mannequins, {}, reading);
  if (!patient) return passOn(patient.error());
  if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Opening the case was stopped.">());
  auto truth = truthOfPatient(**patient, progress);
  if (!truth) return passOn(truth.error());
  if (const auto store = StepStore::share(cacheFolder(), preparationSteps()))
    static_cast<void>(store->keep(kTruths, plan->truth, *truth));  // the next start works it out again otherwise
  return truth;
}

/// One target after the other; `truth` is null for a case without a patient, where the manifest says everything itself.
Result<CaseTruth> compared(const Case& opened, const json& truth) {
  const auto& fileToWorld = opened.volume.fileToWorld;
  const auto placedPoint = [&](const glm::dvec3& p_mm) { return carried(fileToWorld, p_mm); };
  CaseTruth found;
  for (std::size_t n = 0; n < opened.targets.size(); ++n) {
    const CaseTarget& target = opened.targets[n];
    const std::string field = "targets[" + std::to_string(n) + "]";
    if (target.kind == CaseTarget::Kind::point) {
      ReferencePoint point;
      point.name = target.name;
      point.at_mm = placedPoint(target.at_mm.value_or(glm::dvec3(0.0)));
      point.tolerance_mm = target.tolerance_mm.value_or(point.tolerance_mm);
      found.points.push_back(point);
    } else if (target.kind == CaseTarget::Kind::structure && target.label) {
      found.structures.push_back({target.name, target.organ, *target.label});
    } else if (target.kind == CaseTarget::Kind::structure) {
      auto organ = named(truth.at("organs"), target.organ, field + ".organ", say<"no such organ">());
      if (!organ) return passOn(organ.error());
      found.structures.push_back({target.name, target.organ, organ->at("label").get<int>()});
    } else {
      ReferencePlane plane;
      plane.name = target.name;
      if (target.probeToFile) {
        plane.probeToWorld = fileToWorld * *target.probeToFile;
      } else {
        auto known = named(truth.at("planes"), target.name, field + ".name", say<"no such standard plane">());
        if (!known) return passOn(known.error());
        plane.probeToWorld = fileToWorld * planeOf(known->at("probe_to_world"));
        plane.positionTolerance_mm = known->at("position_tolerance_mm").get<double>();
        plane.angleTolerance_deg = known->at("angle_tolerance_deg").get<double>();
        plane.shows = known->at("shows").get<std::vector<std::string>>();
      }
      plane.positionTolerance_mm = target.positionTolerance_mm.value_or(plane.positionTolerance_mm);
      plane.angleTolerance_deg = target.angleTolerance_deg.value_or(plane.angleTolerance_deg);
      found.planes.push_back(std::move(plane));
    }
  }
  for (std::size_t n = 0; n < opened.measurements.size(); ++n) {
    const CaseMeasurement& asked = opened.measurements[n];
    if (asked.value) {
      ReferenceMeasurement expected{asked.name,
                                    asked.kind.empty() ? "distance" : asked.kind,
                                    *asked.value,
                                    asked.unit.empty() ? "mm" : asked.unit,
                                    asked.tolerance,
                                    {},
                                    {}};
      for (const glm::dvec3& p_mm : asked.points_mm) expected.points_mm.push_back(placedPoint(p_mm));
      found.measurements.push_back(std::move(expected));
      continue;
    }
    auto known = named(truth.at("measurements"), asked.name, "measurements[" + std::to_string(n) + "].name", say<"no such measurement">());
    if (!known) return passOn(known.error());
    ReferenceMeasurement expected;
    expected.name = asked.name;
    expected.kind = known->at("kind").get<std::string>();
    expected.value = known->at("value").get<double>();
    expected.unit = known->at("unit").get<std::string>();
    expected.tolerance = asked.tolerance;
    expected.plane = known->at("plane").get<std::string>();
    for (const json& point : known->at("points_mm")) expected.points_mm.push_back(placedPoint(pointOf(point)));
    found.measurements.push_back(std::move(expected));
  }
  return found;
}

}  // namespace

Result<json> truthOfPatient(const Patient& patient, Progress& progress) {
  const auto measured = measurementsOf(patient, {}, progress);
  if (!measured) return passOn(measured.error());
  json truth = {{"measurements", json::array()}, {"planes", json::array()}, {"organs", json::array()}};
  for (const TrueMeasurement& each : *measured) {
    json points = json::array();
    for (const auto& p_mm : each.points_mm) points.push_back(pointOf(p_mm));
    truth["measurements"].push_back({{"name", each.name},
                                     {"kind", each.kind},
                                     {"value", each.value},
                                     {"unit", each.unit},
                                     {"points_mm", points},
                                     {"plane", each.plane}});
  }
  for (const StandardPlane& each : planesOf(patient))
    truth["planes"].push_back({{"name", each.name},
                               {"probe_to_world", rowsOf(each.probeToWorld.matrix)},
                               {"position_tolerance_mm", each.positionTolerance_mm},
                               {"angle_tolerance_deg", each.angleTolerance_deg},
                               {"shows", each.shows}});
  for (const OrganName& each : organsOf(patient)) truth["organs"].push_back({{"name", each.name}, {"label", each.label}});
  return truth;
}

Result<CaseTruth> loadCaseTruth(const Case& opened, Progress& progress) {
  json truth = {{"measurements", json::array()}, {"planes", json::array()}, {"organs", json::array()}};
  if (!opened.volume.recipe.empty()) {
    auto read = patientTruth(opened, progress);
    if (!read) return passOn(read.error());
    truth = std::move(*read);
  }
  try {
    return compared(opened, truth);
  } catch (const json::exception&) {
    // A truth file that someone edited: it is only a copy.
    const auto plan = planOf(opened);
    if (plan) StepStore::peek(cacheFolder(), preparationSteps()).remove(kTruths, plan->truth);
    return failure(ErrorCode::badHeader,
                   say<"The patient's truth in the cache was damaged and has been taken away; open the case again.">());
  }
}

}  // namespace ew
