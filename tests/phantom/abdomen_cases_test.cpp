// The abdomens that extend one anatomy: aneurysm, free fluid, gall stone.
#include <algorithm>
#include <cmath>
#include <map>

#include "drawn_anatomy.h"
#include "ew/phantom/motion.h"
#include "ew/phantom/truth.h"
#include "recipes.h"

namespace ew::abdomen_cases_test {
namespace {

std::shared_ptr<const Patient> patientOfCase(const std::string& id, const ParameterValues& values = {}) {
  auto patient = readPatient(testing::shippedPatient(id), {}, values);
  if (!patient) {
    ADD_FAILURE() << patient.error();
    std::abort();
  }
  return *patient;
}

std::map<std::string, double> truthOf(const Patient& patient, const BodyState& state = {}) {
  std::map<std::string, double> values;
  const auto measured = measurementsOf(patient, state);
  if (!measured) {
    ADD_FAILURE() << measured.error();
    return values;
  }
  for (const TrueMeasurement& each : *measured) values[each.name] = each.value;
  return values;
}

std::string organAt(const Patient& patient, const glm::dvec3& p) {
  const int label = labelAt(patient, p);
  return label == 0 ? "" : organsOf(patient)[static_cast<std::size_t>(label - 1)].name;
}

class AbdomenCase : public ::testing::TestWithParam<std::string> {};

TEST_P(AbdomenCase, CutsWithEachStandardPlaneTheOrgansThePlaneIsFor) {
  const auto patient = patientOfCase(GetParam());
  ASSERT_FALSE(planesOf(*patient).empty());
  for (const StandardPlane& plane : planesOf(*patient)) {
    const glm::dmat4& pose = plane.probeToWorld.matrix;
    EXPECT_NEAR(signedDistance_mm(*patient, "skin surface", glm::dvec3(pose[3])).value(), 0.0, 0.01) << plane.name;
    std::map<std::string, int> squareMillimetres;
    for (double depth = 1.0; depth < 180.0; depth += 3.0)
      for (double aside = -20.0 - 0.55 * depth; aside < 20.0 + 0.55 * depth; aside += 3.0)
        squareMillimetres[organAt(*patient, glm::dvec3(pose * glm::dvec4(aside, depth, 0.0, 1.0)))] += 9;
    for (const std::string& organ : plane.shows) EXPECT_GT(squareMillimetres[organ], 20) << plane.name << " misses " << organ;
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, AbdomenCase,
                         ::testing::Values("upper-abdomen-normal", "upper-abdomen-gall-stone", "abdominal-aorta-aneurysm",
                                           "focused-trauma"),
                         [](const auto& found) {
                           std::string name = found.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(AneurysmCase, HasTheDiametersItsParametersSay) {
  for (const auto& [outer_mm, lumen_mm] : {std::pair{52.0, 29.0}, std::pair{65.0, 40.0}}) {
    const auto patient = patientOfCase("abdominal-aorta-aneurysm", {{"aneurysm_diameter_mm", outer_mm}, {"lumen_diameter_mm", lumen_mm}});
    auto truth = truthOf(*patient);
    EXPECT_NEAR(truth["aneurysm, outer diameter front to back"], outer_mm, outer_mm > 60.0 ? 0.5 : 0.1) << "the widest sac leans";
    EXPECT_NEAR(truth["aneurysm, outer diameter side to side"], outer_mm, 0.1);
    EXPECT_NEAR(truth["aneurysm, lumen front to back"], lumen_mm, 0.1);
    EXPECT_NEAR(truth["aorta above the aneurysm, outer diameter"], 21.6, 0.3);
  }
}

TEST(AneurysmCase, WidensWithTheBeatByAboutAMillimetre) {
  const auto patient = patientOfCase("abdominal-aorta-aneurysm");
  const double narrow = truthOf(*patient)["aneurysm, outer diameter side to side"];
  EXPECT_NEAR(truthOf(*patient, {0.0, 1.0})["aneurysm, outer diameter side to side"] - narrow, 1.1, 0.05);
  EXPECT_NEAR(truthOf(*patient, {1.0, 1.0})["aneurysm, outer diameter side to side"] - narrow, 1.1, 0.3) << "breath shears it a little";
}

TEST(AneurysmCase, LiesInFrontOfTheSpineWithTheVenaCavaOnItsRight) {
  for (const double diameter_mm : {30.0, 65.0}) {
    const auto patient = patientOfCase("abdominal-aorta-aneurysm", {{"aneurysm_diameter_mm", diameter_mm}, {"lumen_diameter_mm", 18.0}});
    for (double z = -160.0; z <= -40.0; z += 10.0) {
      double aorta = 0.0, count = 0.0, cavaLeft = -1e9, back = -1e9, spineFront = 1e9;
      for (double x = -60.0; x <= 70.0; x += 2.5)
        for (double y = -70.0; y <= 70.0; y += 2.5) {
          const std::string organ = organAt(*patient, {x, y, z});
          if (organ == "aorta" || organ == "mural thrombus" || organ == "aortic wall") aorta += x, ++count, back = std::max(back, y);
          if (organ == "inferior vena cava") cavaLeft = std::max(cavaLeft, x);
          if (organ.rfind("vertebral body", 0) == 0 || organ == "intervertebral discs") spineFront = std::min(spineFront, y);
        }
      ASSERT_GT(count, 5.0) << z;
      EXPECT_GT(aorta / count, 5.0) << z;
      EXPECT_LT(cavaLeft, aorta / count) << z;
      EXPECT_LE(back, spineFront + 6.0) << z << " at " << diameter_mm;
    }
  }
}

TEST(AneurysmCase, IsRefusedWhereItWouldNotFit) {
  const auto file = testing::shippedPatient("abdominal-aorta-aneurysm");
  const auto larger = readPatient(file, {}, {{"aneurysm_diameter_mm", 300.0}});
  ASSERT_FALSE(larger);
  EXPECT_NE(larger.error().sentence().find("a number from 30 to 65"), std::string::npos) << larger.error();
  const auto wider = readPatient(file, {}, {{"aneurysm_diameter_mm", 40.0}, {"lumen_diameter_mm", 45.0}});
  ASSERT_FALSE(wider) << "a lumen wider than its sac";
  EXPECT_NE(wider.error().sentence().find("thrombus_mm"), std::string::npos) << wider.error();
}

TEST(TraumaCase, HasFluidBetweenLiverAndKidneyAsWideAsItsParameterSays) {
  for (const double width_mm : {3.0, 11.0, 30.0}) {
    const auto patient = patientOfCase("focused-trauma", {{"fluid_width_mm", width_mm}});
    EXPECT_NEAR(truthOf(*patient)["free fluid in Morison's pouch, width"], width_mm, 0.05);
    // Along the same line: kidney, its fat, fluid, liver.
    const glm::dvec3 kidney(-66, 40, -76), way = glm::normalize(glm::dvec3(-0.36, -0.74, 0.568));
    std::vector<std::string> met;
    for (double along = 0.0; along < 75.0; along += 0.25) {
      const std::string organ = organAt(*patient, kidney + way * along);
      if (met.empty() || met.back() != organ) met.push_back(organ);
    }
    const auto fluid = std::find(met.begin(), met.end(), "free fluid in Morison's pouch");
    ASSERT_NE(fluid, met.end()) << width_mm;
    EXPECT_NE(std::find(met.begin(), fluid, "right kidney"), fluid);
    ASSERT_NE(fluid + 1, met.end());
    EXPECT_EQ(*(fluid + 1), width_mm < 6.0 ? "perirenal fat" : "liver") << width_mm;
  }
}

TEST(TraumaCase, HasMoreFluidTheWiderItIs) {
  double before = 0.0;
  for (const double width_mm : {3.0, 8.0, 16.0}) {
    const double volume =
        truthOf(*patientOfCase("focused-trauma", {{"fluid_width_mm", width_mm}}))["free fluid in Morison's pouch, volume"];
    EXPECT_GT(volume, before * 1.5);
    before = volume;
  }
}

const testing::DrawnPatient& fallen() {
  static const testing::DrawnPatient patient("focused-trauma");
  return patient;
}

/// Where a line of a curved face is, in the plane of the face.
constexpr double kRadius_mm = 60.0;
glm::dvec3 onLine(double angle_rad, double range_mm) {
  return (kRadius_mm + range_mm) * glm::dvec3(std::sin(angle_rad), std::cos(angle_rad), 0.0) - glm::dvec3(0.0, kRadius_mm, 0.0);
}

/// What lines from the face on meet in the subxiphoid plane, in a state of the body.
struct WayToTheHeart {
  int chambersFirst = 0;        ///< lines that meet a chamber
  int lungFirst = 0;            ///< lines that lung takes, though a chamber lies behind it
  double pericardium_mm = 1e9;  ///< the nearest of it
  double chambers_mm2 = 0.0;
};
WayToTheHeart wayToTheHeart(const BodyState& state) {
  const auto motion = bodyMotion(*fallen(), state);
  const glm::dmat4 pose = fallen().plane("subxiphoid").probeToWorld.matrix;
  constexpr double kStep_mm = 1.0;
  WayToTheHeart way;
  for (double angle = -0.5; angle <= 0.5; angle += 0.02) {
    bool isBehindLung = false, isSeen = false, isCovered = false;
    for (double range = 0.0; range < 175.0; range += kStep_mm) {
      const std::string organ = fallen().organAt(motion->rest(testing::in(pose, onLine(angle, range))));
      isBehindLung = isBehindLung || organ == "lungs";
      if (organ == "pericardium" && !isBehindLung) way.pericardium_mm = std::min(way.pericardium_mm, range);
      if (organ != "chambers of the heart") continue;
      (isBehindLung ? isCovered : isSeen) = true;
      if (!isBehindLung) way.chambers_mm2 += 0.02 * (kRadius_mm + range) * kStep_mm;
    }
    way.chambersFirst += isSeen ? 1 : 0;
    way.lungFirst += isCovered && !isSeen ? 1 : 0;
  }
  return way;
}

TEST(TraumaCase, HasAHeartOfFourChambersOnTheDiaphragm) {
  const glm::dmat4 heart = fallen().frame("heart");
  const auto onAxis = [&](double x_mm) {
    return fallen().organsAlong(testing::in(heart, {x_mm, -60, 0}), testing::in(heart, {x_mm, 70, 0}));
  };
  const std::string wall = "heart", blood = "chambers of the heart";
  EXPECT_TRUE(testing::inOrder(onAxis(36), {"diaphragm", "pericardium", wall, blood, wall, blood, wall, "pericardium"})) << "ventricles";
  EXPECT_TRUE(testing::inOrder(onAxis(-12), {"pericardium", wall, blood, "septum between the atria", blood, wall, "pericardium"}));
  const auto valves = fallen().organsAlong(testing::in(heart, {14, -40, 0}), testing::in(heart, {14, 50, 0}));
  EXPECT_EQ(std::count(valves.begin(), valves.end(), "heart valves"), 4) << "two leaflets each";
  const auto lengthOf = [&](double from_mm, double to_mm, const std::string& organ) {
    double length_mm = 0.0;
    for (double y = from_mm; y < to_mm; y += 0.1) length_mm += fallen().organAt(testing::in(heart, {32, y, 0})) == organ ? 0.1 : 0.0;
    return length_mm;
  };
  EXPECT_NEAR(lengthOf(-10, 20, wall), 10.0, 1.5) << "septum";
  EXPECT_NEAR(lengthOf(30, 70, wall), 10.0, 1.5) << "wall of the left ventricle";
}

TEST(TraumaCase, BringsTheHeartNearerWithEachBreathAndNoLungBetween) {
  const WayToTheHeart out = wayToTheHeart({}), quiet = wayToTheHeart({.breath = 0.4}), deep = wayToTheHeart({.breath = 1.0});
  EXPECT_LT(quiet.pericardium_mm, out.pericardium_mm - 4.0);
  EXPECT_LT(deep.pericardium_mm, quiet.pericardium_mm - 4.0);
  for (const WayToTheHeart& way : {out, quiet, deep}) {
    EXPECT_EQ(way.lungFirst, 0);
    EXPECT_GT(way.chambersFirst, 25);
    EXPECT_GT(way.chambers_mm2, 4000.0);
  }
}

TEST(TraumaCase, HasAHeartThatBeatsAsItsSourcesSay) {
  EXPECT_NEAR(60.0 / rhythmsOf(*fallen()).pulse->period_s, 104.0, 1e-9);
  const glm::dmat4 heart = fallen().frame("heart");
  const auto isBlood = [&](const Deformation& motion, const glm::dvec3& p_heart, bool isLeft) {
    const glm::dvec3 rest = motion.rest(testing::in(heart, p_heart));
    const std::string organ = fallen().organAt(rest);
    if (organ != "chambers of the heart" && organ != "papillary muscles" && organ != "heart valves") return false;
    const glm::dvec3 drawn(glm::inverse(heart) * glm::dvec4(rest, 1.0));
    return drawn.x > 6.0 && (drawn.y > 2.0) == isLeft;
  };
  double width_mm[2] = {}, right_mm2[2] = {};
  for (const int systole : {0, 1}) {
    const auto motion = bodyMotion(*fallen(), {.pulse = static_cast<double>(systole)});
    for (double y = -10.0; y < 60.0; y += 0.1) width_mm[systole] += isBlood(*motion, {40, y, 0}, true) ? 0.1 : 0.0;
    for (double x = 0.0; x < 90.0; x += 1.0)
      for (double y = -50.0; y < 30.0; y += 1.0) right_mm2[systole] += isBlood(*motion, {x, y, 0}, false) ? 1.0 : 0.0;
  }
  EXPECT_NEAR(width_mm[0], 42.0, 1.0);
  EXPECT_NEAR(1.0 - width_mm[1] / width_mm[0], 0.35, 0.03);
  EXPECT_NEAR(1.0 - right_mm2[1] / right_mm2[0], 0.38, 0.04);
}

TEST(TraumaCase, ShowsFlanksBetweenTheRibs) {
  // Lines that bone or lung take before they are 60 mm deep.
  for (const char* name : {"right upper quadrant", "left upper quadrant"}) {
    const glm::dmat4 pose = fallen().plane(name).probeToWorld.matrix;
    int open = 0, lines = 0;
    for (double angle = -0.54; angle <= 0.54; angle += 0.02, ++lines) {
      bool isOpen = true;
      for (double range = 0.0; range < 60.0 && isOpen; range += 1.0) {
        const std::string organ = fallen().organAt(testing::in(pose, onLine(angle, range)));
        isOpen = organ.rfind("ribs", 0) != 0 && organ != "lungs";
      }
      open += isOpen ? 1 : 0;
    }
    EXPECT_GT(static_cast<double>(open) / lines, 0.7) << name;
  }
}

TEST(NormalAbdomen, ShowsTheSpleenAlongItsAxisBelowTheRibs) {
  const testing::DrawnPatient patient("upper-abdomen-normal");
  const glm::dmat4 pose = patient.plane("spleen lengthwise").probeToWorld.matrix;
  EXPECT_GT(pose[0].z, 0.7) << "the marker points to the head";
  // Lines that bone takes before they are 60 mm deep; what the others meet, over the part of the image towards the head or the feet.
  int open = 0, lines = 0;
  std::map<std::string, int> towardsHead, towardsFeet;
  for (double angle = -0.54; angle <= 0.54; angle += 0.02, ++lines) {
    bool isOpen = true;
    for (double range = 0.0; range < 130.0 && isOpen; range += 1.0) {
      const std::string organ = patient.organAt(testing::in(pose, onLine(angle, range)));
      if (range < 60.0) isOpen = organ.rfind("ribs", 0) != 0;
      ++(angle > 0.0 ? towardsHead : towardsFeet)[organ];
    }
    open += isOpen ? 1 : 0;
  }
  EXPECT_GT(static_cast<double>(open) / lines, 0.7);
  EXPECT_GT(towardsHead["spleen"], 5 * towardsFeet["spleen"]);
  EXPECT_GT(towardsHead["diaphragm"], 10);
  EXPECT_GT(towardsFeet["left kidney"], towardsHead["left kidney"]);
  const double longest_mm = truthOf(*patient)["spleen, length"];
  EXPECT_GT(longest_mm, 85.0);
  EXPECT_LT(longest_mm, 120.0);
}

TEST(NormalAbdomen, HasTheLengthsItsSourcesState) {
  auto truth = truthOf(*patientOfCase("upper-abdomen-normal"));
  EXPECT_NEAR(truth["right kidney, length"], 110.0, 0.1);
  EXPECT_NEAR(truth["aorta, front to back"], 20.0, 0.5);
}

}  // namespace
}  // namespace ew::abdomen_cases_test
