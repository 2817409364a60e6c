#include "ew/measurement/list_entries.h"

#include <gtest/gtest.h>

#include "measurement/calipers.h"
#include "measurement/packages.h"

namespace ew::measurement::list_entries_test {
namespace {

using test::caliper;

/// What every measurement of a list gives to a package, or the first that gives nothing its item needs.
Result<std::vector<WorksheetEntry>> entriesOf(const MeasurementList& list, const Package& package, const UncertaintyAt& at = {}) {
  std::vector<WorksheetEntry> entries;
  for (const Measurement& each : list.now().all) {
    auto entry = entryOf(each, package, at);
    if (!entry) return passOn(entry.error());
    if (*entry) entries.push_back(**entry);
  }
  return entries;
}

TEST(WorksheetEntries, AreTheFiguresThatItemsAskFor) {
  MeasurementList list;
  list.add(caliper(CaliperKind::distance, {{0, 40}, {0, 122}}), "", "BPD");
  list.add(caliper(CaliperKind::ellipse, {{-50, 80}, {50, 80}, {0, 40}, {0, 120}}), "", "HC");
  list.add(caliper(CaliperKind::distance, {{0, 0}, {1, 0}}), "something else");
  list.add(caliper(CaliperKind::distance, {{0, 0}, {0, 0}}), "unfinished", "FL");
  const auto evenly = [](int, const glm::dvec2&) { return PointUncertainty{glm::dvec2(0.3), 0.0, 0.0, 0.0}; };
  const auto entries = entriesOf(list, test::shipped("obstetric"), evenly);
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
  const auto entries = entriesOf(list, test::shipped("obstetric"));
  ASSERT_FALSE(entries);
  EXPECT_EQ(entries.error().sentence(), "Measurement 1 was made for HC, but gives no circumference; measure it with another caliper.");
}

}  // namespace
}  // namespace ew::measurement::list_entries_test
