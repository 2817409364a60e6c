#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "ew/library/case.h"
#include "ew/library/case_truth.h"
#include "ew/library/lesson_links.h"
#include "ew/library/preparation.h"
#include "ew/phantom/truth.h"
#include "ew/phantom/virtual_sweep.h"
#include "library/temporary_folder.h"

namespace ew::shipped_patients_test {
namespace {

using test::EnvironmentValue;
using test::TemporaryFolder;

TEST(ShippedCases, KnowEveryTargetAndMeasurementTheyName) {
  const TemporaryFolder folder;
  const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "cache");
  for (const Case& each : listCases(*shippedCasesFolder()).cases) {
    const auto truth = loadCaseTruth(each, noProgress());
    EXPECT_TRUE(truth) << each.id << ": " << truth.error();
    EXPECT_TRUE(estimatePreparation(each)) << each.id << ": " << estimatePreparation(each).error();
  }
}

/// How far caliper points lie from a plane at most, and whether they lie in front of the face. A section square to a curved vessel leans a
/// little out of a section across the body, which is what the last millimetre or two are.
double farthestFrom_mm(const ReferencePlane& plane, const std::vector<glm::dvec3>& points_mm) {
  double farthest = 0.0;
  for (const glm::dvec3& p_mm : points_mm) {
    const glm::dvec3 at = carried(rigidInverse(plane.probeToWorld), p_mm);
    farthest = std::max({farthest, std::abs(at.z), -at.y});
  }
  return farthest;
}

TEST(ShippedCases, MeasureInThePlanesThatTheyName) {
  constexpr double kInPlane_mm = 2.0;
  const TemporaryFolder folder;
  const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "cache");
  std::size_t looked = 0, lessons = 0;
  for (const Case& each : listCases(*shippedCasesFolder()).cases) {
    const auto truth = loadCaseTruth(each, noProgress());
    ASSERT_TRUE(truth) << each.id << ": " << truth.error();
    std::set<std::string> measuredInLessons;
    for (const Lesson& lesson : lessonsOf(each).value_or(std::vector<Lesson>()))
      for (const LessonStep& step : lesson.steps)
        if (const auto* task = std::get_if<MeasureTask>(&step.task)) measuredInLessons.insert(task->measurement);
    lessons += measuredInLessons.size();
    for (const ReferenceMeasurement& measured : truth->measurements) {
      SCOPED_TRACE(each.id + ", " + measured.name + ", " + measured.plane);
      double nearest_mm = std::numeric_limits<double>::infinity();
      for (const ReferencePlane& plane : truth->planes)
        if (measured.plane.empty() || plane.name == measured.plane)
          nearest_mm = std::min(nearest_mm, farthestFrom_mm(plane, measured.points_mm));
      // What an author has measured names no plane; where a lesson asks for it, it has to lie in one that the case has. A patient's own
      // measurement without a plane is taken wherever it is found.
      const auto asked =
          std::find_if(each.measurements.begin(), each.measurements.end(), [&](const auto& m) { return m.name == measured.name; });
      const bool isAuthored = asked != each.measurements.end() && asked->value && measuredInLessons.contains(measured.name);
      if (measured.points_mm.empty() || (measured.plane.empty() && !isAuthored)) continue;
      ++looked;
      EXPECT_LT(nearest_mm, kInPlane_mm);
      if (measured.kind == "distance" || measured.kind == "diameter" || measured.kind == "extent") {
        EXPECT_NEAR(glm::distance(measured.points_mm.front(), measured.points_mm.back()), measured.value, 0.1) << "from end to end";
      }
    }
  }
  EXPECT_GE(looked, 10u);
  EXPECT_GE(lessons, 15u);
}

TEST(ShippedCases, MeasureFluidFromOneOfItsBordersToTheOther) {
  const auto resources = resourceFolder();
  const auto opened = loadCase(*shippedCasesFolder() / "focused-trauma");
  ASSERT_TRUE(opened && resources);
  const auto patient = readPatient(opened->folder / opened->volume.recipe, *resources / "mannequin");
  ASSERT_TRUE(patient) << patient.error();
  ASSERT_EQ(opened->measurements.size(), 1u);
  for (const glm::dvec3& p_mm : opened->measurements.front().points_mm)
    EXPECT_NEAR(signedDistance_mm(**patient, "free fluid in Morison's pouch", p_mm).value_or(1e9), 0.0, 0.1);
}

/// What a plane cuts of an organ.
struct Section {
  glm::dvec2 middle_mm{0.0};  ///< in the probe's x and y
  double area_mm2 = 0.0;
};

Section sectionOf(const Patient& patient, const std::string& organ, const glm::dmat4& probeToWorld) {
  Section section;
  for (double y = 0.0; y <= 180.0; y += 1.0)
    for (double x = -60.0; x <= 60.0; x += 1.0) {
      const glm::dvec3 p_world(probeToWorld * glm::dvec4(x, y, 0.0, 1.0));
      if (signedDistance_mm(patient, organ, p_world).value_or(1.0) >= 0.0) continue;
      section.middle_mm += glm::dvec2(x, y);
      section.area_mm2 += 1.0;
    }
  if (section.area_mm2 > 0.0) section.middle_mm /= section.area_mm2;
  return section;
}

/// Two round vessels with bright walls lie over each other there, and a lesson that said no more sent trainees to the wrong one.
TEST(ShippedCases, ShowTheAortaWhereItsLessonSays) {
  const auto resources = resourceFolder();
  const auto opened = loadCase(*shippedCasesFolder() / "upper-abdomen-normal");
  ASSERT_TRUE(opened && resources);
  const auto lessons = lessonsOf(*opened);
  ASSERT_TRUE(lessons) << lessons.error();
  const LessonStep* asked = nullptr;
  for (const Lesson& lesson : *lessons)
    for (const LessonStep& step : lesson.steps)
      if (const auto* task = std::get_if<PointTask>(&step.task); task != nullptr && task->target == "aorta") asked = &step;
  ASSERT_NE(asked, nullptr);
  for (const char* told : {"large round vessel", "in front of the bright curve of the spine", "right of the image",
                           "small one in front of it", "superior mesenteric artery"})
    EXPECT_NE(asked->lookFor.find(told), std::string::npos) << told << ": " << asked->lookFor;

  const auto patient = readPatient(opened->folder / opened->volume.recipe, *resources / "mannequin");
  ASSERT_TRUE(patient) << patient.error();
  const auto planes = planesOf(**patient);
  const auto across = std::find_if(planes.begin(), planes.end(),
                                   [](const StandardPlane& plane) { return plane.name == "transverse at the renal vessels"; });
  ASSERT_NE(across, planes.end());
  const glm::dmat4& probeToWorld = across->probeToWorld.matrix;
  const Section aorta = sectionOf(**patient, "aorta", probeToWorld);
  const Section small = sectionOf(**patient, "superior mesenteric artery", probeToWorld);
  const Section spine = sectionOf(**patient, "vertebral body 3", probeToWorld);
  ASSERT_GT(small.area_mm2, 10.0) << "both are in the image";
  EXPECT_GT(aorta.area_mm2, 4.0 * small.area_mm2);
  EXPECT_LT(aorta.middle_mm.x, -5.0) << "the probe's +x, the marker, is the left of the image";
  EXPECT_LT(small.middle_mm.y, aorta.middle_mm.y - 10.0);
  EXPECT_GT(spine.middle_mm.y, aorta.middle_mm.y + 10.0);
  EXPECT_LT(glm::distance(aorta.middle_mm, spine.middle_mm), glm::distance(small.middle_mm, spine.middle_mm));
}

TEST(ShippedCases, NameProbesThatThereAre) {
  const auto resources = resourceFolder();
  ASSERT_TRUE(resources);
  for (const Case& each : listCases(*shippedCasesFolder()).cases) {
    const auto probes = readProbes(*resources / "probes");
    for (const std::string& id : each.probes)
      EXPECT_TRUE(std::any_of(probes->begin(), probes->end(), [&](const Probe& p) { return p.id == id; })) << each.id << ": " << id;
  }
}

/// Share of a fan's body that lies beyond the patient's box, where nothing is known: the image would end there.
double shareUnknown(const Patient& patient, const Probe& probe, const glm::dmat4& probeToWorld) {
  const Bounds box = boxOf(patient);
  int body = 0, unknown = 0;
  for (double aside = -1.0; aside <= 1.0; aside += 0.05)
    for (double depth_mm = 0.0; depth_mm <= probe.defaultDepth_mm; depth_mm += 3.0) {
      const double angle = probe.halfAngle_rad * aside, radius = probe.radius_mm + depth_mm;
      const glm::dvec3 p = isSector(probe.kind) ? glm::dvec3(radius * std::sin(angle), radius * std::cos(angle) - probe.radius_mm, 0.0)
                                                : glm::dvec3(0.5 * probe.width_mm * aside, depth_mm, 0.0);
      const glm::dvec3 p_world(probeToWorld * glm::dvec4(p, 1.0));
      if (*signedDistance_mm(patient, "skin surface", p_world) >= 0.0) continue;
      ++body;
      if (glm::any(glm::lessThan(p_world, box.lowest_mm)) || glm::any(glm::greaterThan(p_world, box.highest_mm))) ++unknown;
    }
  EXPECT_GT(body, 0);
  return static_cast<double>(unknown) / body;
}

TEST(ShippedCases, WithoutSweepsKnowEverythingThatTheirPlanesAndPosesSee) {
  const auto resources = resourceFolder();
  ASSERT_TRUE(resources);
  int looked = 0;
  for (const Case& each : listCases(*shippedCasesFolder()).cases) {
    if (!each.volume.sweeps.empty() || each.volume.recipe.empty()) continue;
    ++looked;
    const auto patient = readPatient(each.folder / each.volume.recipe, *resources / "mannequin");
    ASSERT_TRUE(patient) << each.id << ": " << patient.error();
    std::vector<std::pair<std::string, glm::dmat4>> views{{"start", each.startPose->probeToWorld.matrix},
                                                          {"expert", each.expertPose->probeToWorld.matrix}};
    for (const StandardPlane& plane : planesOf(**patient)) views.emplace_back(plane.name, plane.probeToWorld.matrix);
    for (const std::string& id : each.probes) {
      const auto probe = readProbe(*resources / "probes" / (id + ".json"));
      ASSERT_TRUE(probe) << probe.error();
      for (const auto& [name, pose] : views)
        EXPECT_LT(shareUnknown(**patient, *probe, pose), 0.001) << each.id << ", " << id << ", " << name;
    }
  }
  EXPECT_EQ(looked, 6);
}

}  // namespace
}  // namespace ew::shipped_patients_test
