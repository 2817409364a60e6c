#include "drawn_anatomy.h"
#include "ew/phantom/motion.h"

namespace ew::fetus_test {
namespace {

using testing::in;
using testing::inOrder;

const testing::DrawnPatient& pregnant() {
  static const testing::DrawnPatient patient("fetal-biometry");
  return patient;
}

/// What a sonographer's calipers find on the drawn shapes.
struct Biometry {
  double biparietal_mm, occipitofrontal_mm, head_mm, abdomen_mm, femur_mm;
};
const Biometry& biometry() {
  static const Biometry measured = [] {
    const auto& patient = pregnant();
    const glm::dmat4 head = patient.frame("fetal head"), body = patient.frame("fetus");
    const glm::dvec3 middle(head[3]), left(head[0]), back(head[1]);
    double inner = 20.0;  // the far inner edge of the skull, on the fetus's right
    while (patient.depthIn_mm("skull bone", middle - inner * left) < 0.0) inner += 0.01;
    const glm::dvec3 hip = in(body, {11, 2, -37}), knee = in(body, {14, -33, -26});
    return Biometry{patient.outermost_mm("skull bone", middle, left, 45.0) + inner, patient.diameter_mm("skull bone", middle, back, 45.0),
                    patient.circumference_mm("skull bone", head, 45.0), patient.circumference_mm("fetal skin", body, 34.0),
                    patient.diameter_mm("femur", 0.5 * (hip + knee), glm::normalize(knee - hip), 30.0)};
  }();
  return measured;
}

TEST(Fetus, HasTheBiometryItsAgeShallHave) {
  EXPECT_NEAR(biometry().biparietal_mm, 48.0, 0.05) << "outer to inner edge";
  EXPECT_NEAR(biometry().occipitofrontal_mm, 63.5, 0.05);
  EXPECT_NEAR(biometry().head_mm, 178.2, 0.3);
  EXPECT_NEAR(biometry().abdomen_mm, 154.0, 0.3);
  EXPECT_NEAR(biometry().femur_mm, 33.0, 0.05);
}

TEST(Fetus, Is20WeeksAnd4DaysOldByEveryChartWithin4Days) {
  // Hadlock et al., Radiology 152, 1984; lengths in cm, age in weeks.
  const double bpd = biometry().biparietal_mm / 10, hc = biometry().head_mm / 10, ac = biometry().abdomen_mm / 10,
               fl = biometry().femur_mm / 10;
  const double age = 20.0 + 4.0 / 7.0, tolerance = 4.0 / 7.0;
  EXPECT_NEAR(9.54 + 1.482 * bpd + 0.1676 * bpd * bpd, age, tolerance);
  EXPECT_NEAR(8.96 + 0.540 * hc + 0.0003 * hc * hc * hc, age, tolerance);
  EXPECT_NEAR(8.14 + 0.753 * ac + 0.0036 * ac * ac, age, tolerance);
  EXPECT_NEAR(10.35 + 2.460 * fl + 0.170 * fl * fl, age, tolerance);
  EXPECT_NEAR(10.85 + 0.060 * hc * fl + 0.6700 * bpd + 0.1680 * ac, age, tolerance);
}

TEST(Fetus, LiesBehindTheWallsOfBellyAndWombInTheRightOrder) {
  const glm::dmat4 head = pregnant().frame("fetal head"), body = pregnant().frame("fetus");
  EXPECT_TRUE(
      inOrder(pregnant().organsAlong(in(head, {110, -20, 3}), in(head, {-60, -20, 3})),
              {"", "skin", "subcutaneous fat", "muscles of the belly", "preperitoneal fat", "uterine wall", "amniotic fluid", "scalp",
               "skull bone", "fetal brain", "falx", "fetal brain", "skull bone", "scalp", "amniotic fluid", "uterine wall"}));
  EXPECT_TRUE(inOrder(
      pregnant().organsAlong(in(body, {110, 4, 0}), in(body, {-70, 4, 0})),
      {"skin", "uterine wall", "amniotic fluid", "fetal skin", "fetal stomach", "fetal liver", "fetal skin", "placenta", "uterine wall"}));
}

TEST(Fetus, SwimsInsideTheWombWithoutGapsAroundIt) {
  const int firstFetal = pregnant().labelOf("cavum septi pellucidi"), lastFetal = pregnant().labelOf("muscles of the fetus");
  constexpr double kStep_mm = 4.0;
  int fetal = 0;
  for (double z = -385; z < -200; z += kStep_mm)
    for (double y = -112; y < 4; y += kStep_mm)
      for (double x = -70; x < 70; x += kStep_mm) {
        const int label = labelAt(*pregnant(), {x, y, z});
        const double inCavity_mm = pregnant().depthIn_mm("amniotic fluid", {x, y, z});
        if (inCavity_mm > 0.5) {
          EXPECT_NE(label, 0) << x << ' ' << y << ' ' << z;
        }
        if (label < firstFetal || label > lastFetal) continue;
        ++fetal;
        EXPECT_GT(inCavity_mm, -0.5) << pregnant().organAt({x, y, z}) << " at " << x << ' ' << y << ' ' << z;
      }
  const double volume_ml = fetal * kStep_mm * kStep_mm * kStep_mm / 1000.0;
  EXPECT_NEAR(volume_ml, 350.0, 100.0) << "about 360 g at this age (Hadlock et al., Radiology 181, 1991)";
}

TEST(Fetus, HasAHeartOfFourChambersWithWallsOfItsAgesSize) {
  const glm::dmat4 heart = pregnant().frame("fetal heart");
  const glm::dvec3 middle = in(heart, {0, 4, 0});
  EXPECT_NEAR(pregnant().diameter_mm("fetal heart", middle, glm::dvec3(heart[0]), 20.0), 23.5, 1.0) << "length";
  const auto ventricles = pregnant().organsAlong(in(heart, {4, 14, 0}), in(heart, {4, -14, 0}));
  EXPECT_TRUE(inOrder(ventricles, {"fetal heart", "left ventricle", "fetal heart", "right ventricle", "fetal heart"}));
  const auto atria = pregnant().organsAlong(in(heart, {-7.5, 14, 0}), in(heart, {-7.5, -14, 0}));
  EXPECT_TRUE(inOrder(atria, {"fetal heart", "left atrium", "septum between the fetal atria", "right atrium", "fetal heart"}));
  EXPECT_TRUE(
      inOrder(pregnant().organsAlong(in(heart, {-7, 4, 0}), in(heart, {14, 4, 0})), {"left atrium", "left ventricle", "fetal heart"}))
      << "open to each other, no wall between";
  const auto valves = pregnant().organsAlong(in(heart, {0.8, 9, 0}), in(heart, {0.8, -9, 0}));
  EXPECT_EQ(std::count(valves.begin(), valves.end(), "fetal heart valves"), 4) << "two leaflets each";
}

TEST(Fetus, HasAHeartWhoseChamberMovesByMillimetresAtTheRateOfItsAge) {
  EXPECT_NEAR(60.0 / rhythmsOf(*pregnant()).pulse->period_s, 146.0, 1e-9);
  const glm::dmat4 heart = pregnant().frame("fetal heart");
  const auto width_mm = [&](double pulse) {
    const auto motion = bodyMotion(*pregnant(), {.pulse = pulse});
    double width = 0.0;
    for (double y = -1.0; y < 12.0; y += 0.05)
      width += pregnant().organAt(motion->rest(in(heart, {4.5, y, 0}))) == "left ventricle" ? 0.05 : 0.0;
    return width;
  };
  EXPECT_NEAR(width_mm(0.0), 7.4, 0.3);
  EXPECT_NEAR(width_mm(0.0) - width_mm(1.0), 2.8, 0.6);
}

TEST(Fetus, HasMeasurementsThatAgreeWithCalipersOnItsShapes) {
  const auto measured = pregnant().measured();
  EXPECT_NEAR(measured.at("biparietal diameter, outer to inner"), biometry().biparietal_mm, 0.06);
  EXPECT_NEAR(measured.at("occipitofrontal diameter"), biometry().occipitofrontal_mm, 0.06);
  EXPECT_NEAR(measured.at("head circumference"), biometry().head_mm, 0.2);
  EXPECT_NEAR(measured.at("abdominal circumference"), biometry().abdomen_mm, 0.2);
  EXPECT_NEAR(measured.at("femur length"), biometry().femur_mm, 0.06);
  EXPECT_NEAR(measured.at("transverse diameter of the cerebellum"), 21.0, 0.5);
  EXPECT_LT(measured.at("atrium of the lateral ventricle"), 10.0) << "no wider than normal";
  EXPECT_GT(measured.at("atrium of the lateral ventricle"), 5.0);
}

TEST(Fetus, IsShownByItsStandardPlanesAndEachLeavesOutWhatItMust) {
  pregnant().expectPlanesShowWhatTheySay(50.0, 110.0);
  const auto leavesOut = [](const std::string& plane, const std::vector<std::string>& organs) {
    const auto owned = pregnant().organsIn(pregnant().plane(plane), 50.0, 110.0);
    for (const auto& organ : organs) EXPECT_EQ(owned.count(organ), 0u) << plane << ": " << organ;
  };
  leavesOut("transthalamic", {"cerebellum", "eyes"});
  leavesOut("abdominal circumference", {"fetal kidneys", "left ventricle", "right ventricle", "fetal bladder", "fetal lungs"});
  leavesOut("four chambers", {"fetal stomach", "fetal liver"});
}

}  // namespace
}  // namespace ew::fetus_test
