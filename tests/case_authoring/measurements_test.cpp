#include "logic/measurements.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ew/core/figure.h"

namespace ew::case_authoring::measurements_test {
namespace {

using json = nlohmann::json;

sdk::ScanMeasurement drawn(const char* kind, std::vector<glm::dvec3> points, std::vector<Figure> figures) {
  sdk::ScanMeasurement made;
  made.kind = kind;
  for (const glm::dvec3& at : points) made.points.push_back({at});
  made.figures = std::move(figures);
  return made;
}

/// A quarter turn about z and a shift: probe (x, y) lies at file (10 - y, 20 + x, 30).
Transform<frame::File, frame::Probe> turned() {
  Transform<frame::File, frame::Probe> made;
  made.matrix = glm::dmat4({0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {10, 20, 30, 1});
  return made;
}

TEST(WithCaliper, TakesValueKindUnitAndWhereTheCaliperStands) {
  const auto caliper = drawn("distance", {{0, 40, 0}, {3, 44, 0}}, {{"length", 5.0, "mm", 0.1}});
  const auto taken = withCaliper({{"name", "cyst"}, {"tolerance", 2.0}}, {caliper}, turned());
  ASSERT_TRUE(taken) << taken.error();
  EXPECT_EQ(*taken, json({{"name", "cyst"},
                          {"tolerance", 2.0},
                          {"value", 5.0},
                          {"kind", "distance"},
                          {"unit", "mm"},
                          {"points_mm", {{-30.0, 20.0, 30.0}, {-34.0, 23.0, 30.0}}}}));
}

TEST(WithCaliper, TakesTheLatestFigureOfTheKindThatIsAskedFor) {
  const auto distance = drawn("distance", {{0, 0, 0}, {7, 0, 0}}, {{"length", 7.0, "mm"}});
  const auto ellipse = drawn("ellipse", {{0, 0, 0}, {9, 0, 0}}, {{"circumference", 31.4, "mm"}, {"area", 0.785, "cm2"}});
  EXPECT_EQ(withCaliper({{"kind", "area"}}, {distance, ellipse}, turned())->at("value"), 0.79);
  EXPECT_EQ(withCaliper({{"kind", "distance"}}, {distance, ellipse}, turned())->at("value"), 7.0);
  EXPECT_EQ(withCaliper(json::object(), {distance, ellipse}, turned())->at("kind"), "circumference");
  EXPECT_EQ(withCaliper(json::object(), {ellipse, distance}, turned())->at("kind"), "distance");
}

TEST(WithCaliper, SaysWhatToDrawWhereNothingFits) {
  const auto without = withCaliper(json::object(), {}, turned());
  ASSERT_FALSE(without);
  EXPECT_NE(without.error().sentence().find("draw a caliper first"), std::string::npos) << without.error();
  const auto distance = drawn("distance", {{0, 0, 0}, {7, 0, 0}}, {{"length", 7.0, "mm"}});
  const auto other = withCaliper({{"kind", "angle"}}, {distance}, turned());
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().code, ErrorCode::badUsage);
}

TEST(HasValue, IsWhetherTheCaseItselfKnowsTheValue) {
  EXPECT_TRUE(hasValue({{"name", "a"}, {"value", 3}}));
  EXPECT_FALSE(hasValue({{"name", "a"}}));
  EXPECT_FALSE(hasValue(nullptr));
}

}  // namespace
}  // namespace ew::case_authoring::measurements_test
