#include "ew/measurement/examination.h"

#include <gtest/gtest.h>

#include <memory>

#include "measurement/calipers.h"
#include "measurement/packages.h"

namespace ew::measurement::examination_test {
namespace {

using test::caliper;

Examination examinationOf(const char* package) { return Examination(std::make_shared<const Package>(test::shipped(package))); }

TEST(Examinations, KeepWhatWasMeasuredInImagesThatAreGone) {
  Examination examination = examinationOf("obstetric");
  MeasurementList first, second;
  const int bpd = first.add(caliper(CaliperKind::distance, {{0, 40}, {0, 122}}), "", "BPD");
  EXPECT_TRUE(examination.measuredIn(1, first.now(), {}).empty());
  second.add(caliper(CaliperKind::distance, {{0, 40}, {0, 103}}), "", "FL");
  second.add(caliper(CaliperKind::distance, {{0, 40}, {0, 124}}), "", "BPD");
  EXPECT_TRUE(examination.measuredIn(2, second.now(), {}).empty());
  ASSERT_EQ(examination.of("BPD", "").size(), 2u);
  EXPECT_DOUBLE_EQ(examination.of("BPD", "")[0].value, 82.0);
  EXPECT_DOUBLE_EQ(examination.worksheet().row("BPD")->value->value, 8.3);  // the mean, in cm
  EXPECT_NE(examination.worksheet().row("GA_BPD"), nullptr);
  // A handle that is moved changes the value and keeps its place; what is deleted in its image goes.
  first.setCaliper(bpd, caliper(CaliperKind::distance, {{0, 40}, {0, 120}}));
  EXPECT_TRUE(examination.measuredIn(1, first.now(), {}).empty());
  ASSERT_EQ(examination.found().size(), 3u);
  EXPECT_DOUBLE_EQ(examination.found()[0].entry.quantity.value, 80.0);
  first.clear();
  EXPECT_TRUE(examination.measuredIn(1, first.now(), {}).empty());
  EXPECT_EQ(examination.of("BPD", "").size(), 1u);
  EXPECT_TRUE(examination.remove(2, 2));
  EXPECT_FALSE(examination.remove(2, 2));
  EXPECT_TRUE(examination.of("BPD", "").empty());
  EXPECT_EQ(examination.of("FL", "").size(), 1u);
}

TEST(Examinations, LeaveOutWhatCannotBeTrueAndSaySo) {
  Examination examination = examinationOf("obstetric");
  MeasurementList list;
  list.add(caliper(CaliperKind::distance, {{0, 0}, {0, 190}}), "", "BPD");  // no head is that wide
  list.add(caliper(CaliperKind::distance, {{0, 40}, {0, 122}}), "", "HC");  // a distance is no circumference
  list.add(caliper(CaliperKind::distance, {{0, 40}, {0, 103}}), "", "FL");
  list.add(caliper(CaliperKind::distance, {{0, 40}, {0, 50}}), "", "AORTA");  // of another package
  const auto remarks = examination.measuredIn(7, list.now(), {});
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_NE(remarks[0].english().find("BPD of 190"), std::string::npos) << remarks[0].english();
  EXPECT_NE(remarks[1].english().find("no circumference"), std::string::npos) << remarks[1].english();
  ASSERT_EQ(examination.found().size(), 1u);
  EXPECT_EQ(examination.found()[0].entry.label, "FL");
  EXPECT_EQ(examination.found()[0].number, 3);
}

TEST(Examinations, KeepSidesApart) {
  Examination examination = examinationOf("abdomen");
  MeasurementList list;
  list.add(caliper(CaliperKind::distance, {{0, 0}, {0, 110}}), "", "KIDNEY_L", "right");
  list.add(caliper(CaliperKind::distance, {{0, 0}, {0, 104}}), "", "KIDNEY_L", "left");
  list.add(caliper(CaliperKind::distance, {{0, 0}, {0, 104}}), "", "KIDNEY_L", "");
  EXPECT_EQ(examination.measuredIn(1, list.now(), {}).size(), 1u);
  EXPECT_DOUBLE_EQ(examination.of("KIDNEY_L", "right")[0].value, 110.0);
  EXPECT_DOUBLE_EQ(examination.of("KIDNEY_L", "left")[0].value, 104.0);
}

TEST(Examinations, TakeAnswersOfTheirItemsAlone) {
  Examination examination = examinationOf("trauma");
  const auto& choices = examination.package().item("RUQ")->choices;
  EXPECT_TRUE(examination.answer("RUQ", "", choices[0].first));
  EXPECT_TRUE(examination.answer("RUQ", "", choices[1].first));  // the later one counts
  ASSERT_EQ(examination.answers().size(), 1u);
  EXPECT_EQ(examination.worksheet().row("RUQ")->choice, choices[1].first);
  EXPECT_FALSE(examination.answer("RUQ", "", "maybe"));
  EXPECT_FALSE(examination.answer("RUQ", "left", choices[0].first));
  EXPECT_FALSE(examination.answer("PLEURA", "", choices[0].first));
  EXPECT_FALSE(examination.answer("BPD", "", choices[0].first));
  ASSERT_EQ(examination.answers().size(), 1u);
  EXPECT_TRUE(examination.answer("RUQ", "", ""));
  EXPECT_TRUE(examination.isEmpty());
}

TEST(Examinations, TakeAGestationThatCanBe) {
  Examination examination = examinationOf("obstetric");
  EXPECT_TRUE(examination.setGestation(32.5));
  EXPECT_FALSE(examination.setGestation(46.0));
  EXPECT_FALSE(examination.setGestation(-1.0));
  EXPECT_EQ(examination.gestation_weeks(), 32.5);
  EXPECT_EQ(examination.worksheet().gestation_weeks, 32.5);
  EXPECT_TRUE(examination.setGestation(std::nullopt));
  EXPECT_FALSE(examination.gestation_weeks().has_value());
}

}  // namespace
}  // namespace ew::measurement::examination_test
