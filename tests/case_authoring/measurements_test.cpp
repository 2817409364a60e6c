#include "logic/measurements.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ew/core/figure.h"

namespace ew::case_authoring::measurements_test {
namespace {

sdk::ScanMeasurement drawn(const char* kind, std::vector<glm::dvec3> points, std::vector<Figure> figures) {
  sdk::ScanMeasurement made;
  made.kind = kind;
  for (const glm::dvec3& at : points) made.points.push_back({at});
  made.figures = std::move(figures);
  return made;
}

CaseMeasurement expected(const std::string& kind = {}) {
  CaseMeasurement made;
  made.kind = kind;
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
  CaseMeasurement cyst;
  cyst.name = "cyst";
  cyst.tolerance = 2.0;
  const auto taken = withCaliper(cyst, {caliper}, turned());
  ASSERT_TRUE(taken) << taken.error();
  cyst.value = 5.0;
  cyst.kind = "distance";
  cyst.unit = "mm";
  cyst.points_mm = {{-30.0, 20.0, 30.0}, {-34.0, 23.0, 30.0}};
  EXPECT_EQ(*taken, cyst);
}

TEST(WithCaliper, TakesTheLatestFigureOfTheKindThatIsAskedFor) {
  const auto distance = drawn("distance", {{0, 0, 0}, {7, 0, 0}}, {{"length", 7.0, "mm"}});
  const auto ellipse = drawn("ellipse", {{0, 0, 0}, {9, 0, 0}}, {{"circumference", 31.4, "mm"}, {"area", 0.785, "cm2"}});
  EXPECT_EQ(withCaliper(expected("area"), {distance, ellipse}, turned())->value, 0.79);
  EXPECT_EQ(withCaliper(expected("distance"), {distance, ellipse}, turned())->value, 7.0);
  EXPECT_EQ(withCaliper(expected(), {distance, ellipse}, turned())->kind, "circumference");
  EXPECT_EQ(withCaliper(expected(), {ellipse, distance}, turned())->kind, "distance");
}

TEST(WithCaliper, SaysWhatToDrawWhereNothingFits) {
  const auto without = withCaliper(expected(), {}, turned());
  ASSERT_FALSE(without);
  EXPECT_NE(without.error().sentence().find("draw a caliper first"), std::string::npos) << without.error();
  const auto distance = drawn("distance", {{0, 0, 0}, {7, 0, 0}}, {{"length", 7.0, "mm"}});
  const auto other = withCaliper(expected("angle"), {distance}, turned());
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().code, ErrorCode::badUsage);
}

}  // namespace
}  // namespace ew::case_authoring::measurements_test
