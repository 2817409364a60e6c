#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "ew/phantom/truth.h"
#include "recipes.h"

namespace ew::testing {

/// A shipped patient as it is drawn, for asking along beams and around organs.
class DrawnPatient {
 public:
  explicit DrawnPatient(const std::string& id, const ParameterValues& parameters = {}) : recipe_(shippedPatient(id)) {
    auto patient = readPatient(recipe_, {}, parameters);
    if (!patient) {
      ADD_FAILURE() << patient.error();
      std::abort();
    }
    patient_ = *patient;
    organs_ = organsOf(*patient_);
  }
  [[nodiscard]] const Patient& operator*() const { return *patient_; }

  /// A frame of the recipe: its axes and origin in the world, worked out here and not by the reader under test.
  [[nodiscard]] glm::dmat4 frame(const std::string& name) const {
    std::ifstream in(recipe_);
    const auto recipe = nlohmann::json::parse(in);
    for (const auto& each : recipe.at("frames")) {
      if (each.at("name") != name) continue;
      const auto origin = each.at("origin_mm").get<std::array<double, 3>>(), turned = each.at("turned_deg").get<std::array<double, 3>>();
      constexpr double kDegree = std::numbers::pi / 180.0;
      glm::dmat4 found = each.contains("within") ? frame(each.at("within")) : glm::dmat4(1.0);
      found = glm::translate(found, {origin[0], origin[1], origin[2]});
      found = glm::rotate(found, turned[2] * kDegree, {0, 0, 1});
      found = glm::rotate(found, turned[1] * kDegree, {0, 1, 0});
      return glm::rotate(found, turned[0] * kDegree, {1, 0, 0});
    }
    ADD_FAILURE() << "no frame " << name;
    return glm::dmat4(1.0);
  }

  [[nodiscard]] std::string organAt(const glm::dvec3& p_mm) const {
    const int label = labelAt(*patient_, p_mm);
    return label == 0 ? "" : organs_[static_cast<std::size_t>(label - 1)].name;
  }
  [[nodiscard]] int labelOf(const std::string& organ) const {
    for (const auto& each : organs_)
      if (each.name == organ) return each.label;
    ADD_FAILURE() << "no organ " << organ;
    return -1;
  }
  [[nodiscard]] double depthIn_mm(const std::string& organ, const glm::dvec3& p_mm) const {
    return -signedDistance_mm(*patient_, organ, p_mm).value();
  }

  /// How far from `centre` the organ's outermost surface lies in a direction, looked for within `reach_mm`.
  [[nodiscard]] double outermost_mm(const std::string& organ, const glm::dvec3& centre, const glm::dvec3& direction,
                                    double reach_mm) const {
    double inside = reach_mm;
    while (inside > 0.0 && depthIn_mm(organ, centre + inside * direction) < 0.0) inside -= 0.2;
    double beyond = inside + 0.2;
    for (int n = 0; n < 40; ++n) {
      const double middle = 0.5 * (inside + beyond);
      (depthIn_mm(organ, centre + middle * direction) < 0.0 ? beyond : inside) = middle;
    }
    return inside;
  }
  /// Between the outermost surfaces on both sides of `centre`.
  [[nodiscard]] double diameter_mm(const std::string& organ, const glm::dvec3& centre, const glm::dvec3& axis, double reach_mm) const {
    return outermost_mm(organ, centre, axis, reach_mm) + outermost_mm(organ, centre, -axis, reach_mm);
  }
  /// Length of the organ's outline in the plane z = 0 of a frame.
  [[nodiscard]] double circumference_mm(const std::string& organ, const glm::dmat4& frame, double reach_mm) const {
    constexpr int kSteps = 720;
    double length = 0.0;
    glm::dvec3 last(0.0);
    for (int n = 0; n <= kSteps; ++n) {
      const double angle = 2.0 * std::numbers::pi * n / kSteps;
      const glm::dvec3 direction(frame * glm::dvec4(std::cos(angle), std::sin(angle), 0.0, 0.0)), centre(frame[3]);
      const glm::dvec3 at = centre + outermost_mm(organ, centre, direction, reach_mm) * direction;
      if (n > 0) length += glm::distance(at, last);
      last = at;
    }
    return length;
  }

  /// The organs that a straight beam meets, one after the other; "" is the background and what lies outside the skin.
  [[nodiscard]] std::vector<std::string> organsAlong(const glm::dvec3& from, const glm::dvec3& to) const {
    std::vector<std::string> met;
    const int steps = static_cast<int>(glm::distance(from, to) / 0.1);
    for (int n = 0; n <= steps; ++n) {
      const std::string organ = organAt(glm::mix(from, to, static_cast<double>(n) / steps));
      if (met.empty() || met.back() != organ) met.push_back(organ);
    }
    return met;
  }

  /// How many places of a plane, 0.8 mm apart from the face down, each organ owns.
  [[nodiscard]] std::map<std::string, int> organsIn(const StandardPlane& plane, double halfWidth_mm, double depth_mm) const {
    constexpr double kStep_mm = 0.8;
    std::map<std::string, int> owned;
    for (double y = 0.0; y < depth_mm; y += kStep_mm)
      for (double x = -halfWidth_mm; x < halfWidth_mm; x += kStep_mm) ++owned[organAt(in(plane.probeToWorld.matrix, {x, y, 0.0}))];
    return owned;
  }
  /// The named plane of the recipe; an empty one when it has none.
  [[nodiscard]] StandardPlane plane(const std::string& name) const {
    for (const StandardPlane& each : planesOf(*patient_))
      if (each.name == name) return each;
    ADD_FAILURE() << "no plane " << name;
    return {};
  }
  /// Expects every standard plane to begin on the skin and to cut what it says within an image.
  void expectPlanesShowWhatTheySay(double halfWidth_mm, double depth_mm) const {
    const auto planes = planesOf(*patient_);
    EXPECT_FALSE(planes.empty());
    for (const StandardPlane& plane : planes) {
      EXPECT_NEAR(signedDistance_mm(*patient_, "skin surface", glm::dvec3(plane.probeToWorld.matrix[3])).value(), 0.0, 0.2) << plane.name;
      const auto owned = organsIn(plane, halfWidth_mm, depth_mm);
      EXPECT_FALSE(plane.shows.empty()) << plane.name;
      for (const std::string& organ : plane.shows)
        EXPECT_GE(owned.count(organ) > 0 ? owned.at(organ) : 0, 2) << plane.name << ": " << organ;
    }
  }
  /// The measurements that the recipe asks for, by name.
  [[nodiscard]] std::map<std::string, double> measured(const BodyState& state = {}) const {
    const auto all = measurementsOf(*patient_, state);
    EXPECT_TRUE(all) << all.error();
    std::map<std::string, double> values;
    for (const TrueMeasurement& each : all ? *all : std::vector<TrueMeasurement>{}) values[each.name] = each.value;
    return values;
  }

 private:
  [[nodiscard]] static glm::dvec3 in(const glm::dmat4& frame, const glm::dvec3& p_mm) { return {frame * glm::dvec4(p_mm, 1.0)}; }

  std::filesystem::path recipe_;
  std::shared_ptr<const Patient> patient_;
  std::vector<OrganName> organs_;
};

inline glm::dvec3 in(const glm::dmat4& frame, const glm::dvec3& p_mm) { return {frame * glm::dvec4(p_mm, 1.0)}; }

/// Succeeds when `wanted` is found in `met` in this order, with whatever between.
inline ::testing::AssertionResult inOrder(const std::vector<std::string>& met, const std::vector<std::string>& wanted) {
  auto at = met.begin();
  for (const std::string& each : wanted) {
    at = std::find(at, met.end(), each);
    if (at == met.end()) {
      auto told = ::testing::AssertionFailure() << '"' << each << "\" is missing or out of order in: ";
      for (const auto& organ : met) told << (organ.empty() ? "(nothing)" : organ) << "; ";
      return told;
    }
    ++at;
  }
  return ::testing::AssertionSuccess();
}

}  // namespace ew::testing
