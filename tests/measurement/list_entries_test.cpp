#include "ew/measurement/list_entries.h"

#include <gtest/gtest.h>

#include "measurement/calipers.h"
#include "measurement/packages.h"

namespace ew::measurement::list_entries_test {
namespace {

using test::caliper;

TEST(WorksheetEntries, AreTheFiguresThatItemsAskFor) {
  MeasurementList list;
  list.add(caliper(CaliperKind::distance, {{0, 40}, {0, 122}}), "", "BPD");
  list.add(caliper(CaliperKind::ellipse, {{-50, 80}, {50, 80}, {0, 40}, {0, 120}}), "", "HC");
  list.add(caliper(CaliperKind::distance, {{0, 0}, {1, 0}}), "something else");
  list.add(caliper(CaliperKind::distance, {{0, 0}, {0, 0}}), "unfinished", "FL");
  const auto entries = entriesOf(list.now(), test::shipped("obstetric"), uncertaintyByDepth(glm::dvec2(0.3), {}));
  ASSERT_TRUE(entries) << entries.error();
  ASSERT_EQ(entries->size(), 2u);
  EXPECT_DOUBLE_EQ((*entries)[0].quantity.value, 82.0);
  EXPECT_NEAR((*entries)[0].quantity.uncertainty, 0.3 / std::sqrt(6.0), 1e-9);
  EXPECT_NEAR((*entries)[1].quantity.value, ellipseCircumference_mm(50.0, 40.0), 1e-9);
  const auto sheet = fillWorksheet(test::shipped("obstetric"), {*entries, Several::mean, {}});
  ASSERT_TRUE(sheet) << sheet.error();
  EXPECT_NEAR(sheet->row("GA_BPD")->value->value, 32.962, 5e-4);
}

TEST(WorksheetEntries, RefuseACaliperThatGivesSomethingElse) {
  MeasurementList list;
  list.add(caliper(CaliperKind::distance, {{0, 40}, {0, 122}}), "", "HC");
  const auto entries = entriesOf(list.now(), test::shipped("obstetric"));
  ASSERT_FALSE(entries);
  EXPECT_EQ(entries.error().sentence(), "Measurement 1 was made for HC, but gives no circumference; measure it with another caliper.");
}

}  // namespace
}  // namespace ew::measurement::list_entries_test
