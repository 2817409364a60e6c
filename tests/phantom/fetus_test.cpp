#include <algorithm>
#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>
#include <numbers>

#include "recipes.h"

namespace ew {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

const Patient& pregnant() {
  static const auto patient = readPatient(testing::shippedPatient("fetal-biometry"));
  if (!patient) {
    ADD_FAILURE() << patient.error();
    std::abort();
  }
  return **patient;
}

/// A frame of the recipe, its columns in the world.
glm::dmat4 frameOf(const std::string& name) {
  std::ifstream in(testing::shippedPatient("fetal-biometry"));
  const auto recipe = nlohmann::json::parse(in);
  for (const auto& each : recipe.at("frames")) {
    if (each.at("name") != name) continue;
    const auto origin = each.at("origin_mm").get<std::array<double, 3>>(), turned = each.at("turned_deg").get<std::array<double, 3>>();
    glm::dmat4 frame(1.0);
    if (each.contains("within")) frame = frameOf(each.at("within"));
    frame = glm::translate(frame, {origin[0], origin[1], origin[2]});
    frame = glm::rotate(frame, turned[2] * kDegree, {0, 0, 1});
    frame = glm::rotate(frame, turned[1] * kDegree, {0, 1, 0});
    return glm::rotate(frame, turned[0] * kDegree, {1, 0, 0});
  }
  ADD_FAILURE() << "no frame " << name;
  return glm::dmat4(1.0);
}
glm::dvec3 in(const glm::dmat4& frame, const glm::dvec3& p_mm) { return {frame * glm::dvec4(p_mm, 1.0)}; }

double depthIn(const std::string& organ, const glm::dvec3& p_mm) { return -signedDistance_mm(pregnant(), organ, p_mm).value(); }

/// How far from `centre` the organ's outermost surface lies in a direction, seen from `reach_mm` away.
double outermost_mm(const std::string& organ, const glm::dvec3& centre, const glm::dvec3& direction, double reach_mm) {
  double outside = reach_mm;
  while (outside > 0.0 && depthIn(organ, centre + outside * direction) < 0.0) outside -= 0.2;
  double inside = outside, beyond = outside + 0.2;
  for (int n = 0; n < 40; ++n) {
    const double middle = 0.5 * (inside + beyond);
    (depthIn(organ, centre + middle * direction) < 0.0 ? beyond : inside) = middle;
  }
  return inside;
}

/// Length of the organ's outline in the plane z = 0 of a frame.
double circumference_mm(const std::string& organ, const glm::dmat4& frame, double reach_mm) {
  constexpr int kSteps = 720;
  double length = 0.0;
  glm::dvec3 last;
  for (int n = 0; n <= kSteps; ++n) {
    const double angle = 2.0 * std::numbers::pi * n / kSteps;
    const glm::dvec3 direction(frame * glm::dvec4(std::cos(angle), std::sin(angle), 0.0, 0.0));
    const glm::dvec3 at = glm::dvec3(frame[3]) + outermost_mm(organ, glm::dvec3(frame[3]), direction, reach_mm) * direction;
    if (n > 0) length += glm::distance(at, last);
    last = at;
  }
  return length;
}

std::vector<std::string> organsAlong(const glm::dvec3& from, const glm::dvec3& to) {
  const auto organs = organsOf(pregnant());
  std::vector<std::string> met;
  const int steps = static_cast<int>(glm::distance(from, to) / 0.1);
  for (int n = 0; n <= steps; ++n) {
    const int label = labelAt(pregnant(), glm::mix(from, to, static_cast<double>(n) / steps));
    const std::string name = label == 0 ? "" : organs[static_cast<std::size_t>(label - 1)].name;
    if (met.empty() || met.back() != name) met.push_back(name);
  }
  return met;
}

/// Whether `wanted` is found in `met` in this order, with whatever between.
bool inOrder(const std::vector<std::string>& met, const std::vector<std::string>& wanted) {
  auto at = met.begin();
  for (const std::string& each : wanted) {
    at = std::find(at, met.end(), each);
    if (at == met.end()) return false;
    ++at;
  }
  return true;
}

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const auto& each : names) all += each + "; ";
  return all;
}

/// Diameters of the head and body as a sonographer takes them from the drawn shapes.
struct Biometry {
  double biparietal_mm, occipitofrontal_mm, head_mm, abdomen_mm, femur_mm;
};
const Biometry& biometry() {
  static const Biometry measured = [] {
    const glm::dmat4 head = frameOf("fetal head"), body = frameOf("fetus");
    const auto skull = [&](const glm::dvec3& axis) {
      return outermost_mm("skull bone", in(head, {0, 0, 0}), glm::dvec3(head * glm::dvec4(axis, 0.0)), 45.0);
    };
    double inner = 20.0;  // the far inner edge of the skull, on the fetus's right
    while (depthIn("skull bone", in(head, {-inner, 0, 0})) < 0.0) inner += 0.01;
    // The far ends of the diaphysis along its own axis: extent of the organ in that direction.
    const glm::dvec3 hip = in(body, {11, 2, -37}), knee = in(body, {14, -33, -26});
    const glm::dvec3 along = glm::normalize(knee - hip), middle = 0.5 * (hip + knee);
    const double shaft = outermost_mm("femur", middle, along, 30.0) + outermost_mm("femur", middle, -along, 30.0);
    return Biometry{skull({1, 0, 0}) + inner, skull({0, 1, 0}) + skull({0, -1, 0}), circumference_mm("skull bone", head, 45.0),
                    circumference_mm("fetal skin", body, 34.0), shaft};
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
  const glm::dmat4 head = frameOf("fetal head"), body = frameOf("fetus");
  const auto throughHead = organsAlong(in(head, {110, -20, 3}), in(head, {-60, -20, 3}));
  EXPECT_TRUE(inOrder(
      throughHead, {"", "skin", "subcutaneous fat", "muscles of the belly", "preperitoneal fat", "uterine wall", "amniotic fluid", "scalp",
                    "skull bone", "fetal brain", "falx", "fetal brain", "skull bone", "scalp", "amniotic fluid", "uterine wall"}))
      << joined(throughHead);
  const auto throughBelly = organsAlong(in(body, {110, 4, 0}), in(body, {-70, 4, 0}));
  EXPECT_TRUE(inOrder(throughBelly, {"skin", "uterine wall", "amniotic fluid", "fetal skin", "fetal stomach", "fetal liver", "fetal skin",
                                     "placenta", "uterine wall"}))
      << joined(throughBelly);
}

TEST(Fetus, SwimsInsideTheWombWithoutGapsAroundIt) {
  const auto organs = organsOf(pregnant());
  const auto labelOf = [&](const std::string& name) {
    for (const auto& each : organs)
      if (each.name == name) return each.label;
    ADD_FAILURE() << name;
    return -1;
  };
  const int firstFetal = labelOf("cavum septi pellucidi"), lastFetal = labelOf("muscles of the fetus");
  int fetal = 0, inFluid = 0;
  for (double z = -385; z < -200; z += 2.5)
    for (double y = -112; y < 4; y += 2.5)
      for (double x = -70; x < 70; x += 2.5) {
        const int label = labelAt(pregnant(), {x, y, z});
        const double inCavity = depthIn("amniotic fluid", {x, y, z});
        if (inCavity > 0.5) {
          EXPECT_NE(label, 0) << x << ' ' << y << ' ' << z;
          ++inFluid;
        }
        if (label < firstFetal || label > lastFetal) continue;
        ++fetal;
        EXPECT_GT(inCavity, -0.5) << organs[static_cast<std::size_t>(label - 1)].name << " at " << x << ' ' << y << ' ' << z;
      }
  EXPECT_GT(fetal * 2.5 * 2.5 * 2.5 / 1000.0, 250.0) << "ml";
  EXPECT_LT(fetal * 2.5 * 2.5 * 2.5 / 1000.0, 400.0) << "ml; about 350 g at this age (Hadlock et al., Radiology 181, 1991)";
  EXPECT_GT(inFluid, fetal);
}

}  // namespace
}  // namespace ew
