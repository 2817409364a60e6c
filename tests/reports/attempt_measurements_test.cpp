#include "ew/reports/attempt_measurements.h"

#include <algorithm>

#include "ew/library/step_answer.h"
#include "export/export_world.h"
#include "reports/reports_world.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using test::AssessedWorld;
using test::holds;

fs::path measuredAttempt(const AssessedWorld& world, const StepAnswer& answer) {
  return world.keep("20261101-100000-aaaaaaaa", {{.step = "measure", .answer = answer}, {.step = "answer", .answer = OptionsAnswer{{0}}}});
}

ReportAttempt readBack(const fs::path& folder) {
  auto read = readReportedAttempt(folder);
  EXPECT_TRUE(test::succeeded(read));
  return *read;
}

TEST(MeasurementsOfAnAttempt, AreThoseItsMeasureStepsHandedIn) {
  const AssessedWorld world;
  const auto one = readBack(measuredAttempt(world, MeasurementAnswer{40.5, "mm", "distance", {}}));
  const auto lesson = readReportedLesson("ball", "about-balls", world.library(), {});
  const auto measured = measurementsOf(one, lesson);
  ASSERT_EQ(measured.size(), 1u);
  EXPECT_EQ(measured[0].caseId, "ball");
  const measurement::WorksheetRow* row = measured[0].worksheet.row("M1");
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row->title.english, "Step measure") << "what the trainee read; the name of the measurement may be the finding";
  EXPECT_EQ(row->value, (measurement::Quantity{40.5, 0.0, measurement::Unit::mm}));
  EXPECT_EQ(row->convention.english, "Step 'Step measure', caliper: distance");
}

TEST(MeasurementsOfAnAttempt, LeaveOutWhatIsNoMeasurementAndSaySo) {
  const AssessedWorld world;
  const auto lesson = readReportedLesson("ball", "about-balls", world.library(), {});
  for (const nlohmann::json& answer : {nlohmann::json{{"value", "40"}, {"unit", "mm"}},
                                       nlohmann::json{{"value", 40.0}, {"unit", "furlong"}}, nlohmann::json{{"value", 40.0}}}) {
    ReportAttempt one;
    one.attempt.caseId = "ball";
    one.attempt.outcomes = {StepOutcome{}};
    one.attempt.outcomes[0].stepId = "measure";
    one.attempt.outcomes[0].answer = stepAnswerFromJson(answer);
    one.attempt.outcomes[0].otherAnswer = answer;
    const auto measured = measurementsOf(one, lesson);
    ASSERT_EQ(measured.size(), 1u);
    EXPECT_EQ(measured[0].worksheet.row("M1"), nullptr);
    ASSERT_EQ(measured[0].leftOut.size(), 1u);
    EXPECT_TRUE(holds(measured[0].leftOut[0].english(), "is no measurement"));
  }
}

TEST(MeasurementsOfAnAttempt, AreADicomReportWithoutTheTraineesName) {
  EW_NEEDS_PROGRAM("dsrdump");
  EW_NEEDS_PROGRAM("dcmdump");
  const AssessedWorld world;
  const test::TemporaryFolder out;
  const auto one = readBack(measuredAttempt(world, MeasurementAnswer{40.5, "mm", "distance", {}}));
  const auto lesson = readReportedLesson("ball", "about-balls", world.library(), {});
  const auto files = writeAttemptMeasurements(one, lesson, test::someCodes(), false, world.library(), out.path());
  ASSERT_TRUE(test::succeeded(files));
  ASSERT_EQ(files->size(), 1u);
  EXPECT_EQ(files->front().filename(), "20261101-100000-aaaaaaaa-ball.dcm");
  const test::Said report = test::said("dsrdump +Pc +U8 +Pl " + files->front().string());
  EXPECT_EQ(report.status, 0) << report.text;
  EXPECT_TRUE(holds(report.text, "(126000,DCM,\"Imaging Measurement Report\")"));
  EXPECT_TRUE(holds(report.text, "(lesson.M1,99ECHOWEAVE,\"Step measure\")")) << report.text;
  EXPECT_FALSE(holds(report.text, "ball, across"));
  EXPECT_TRUE(holds(report.text, "\"40.5\" (mm,UCUM,\"millimeter\")"));
  EXPECT_TRUE(holds(report.text, "not for diagnosis"));
  EXPECT_TRUE(holds(report.text, "Step 'Step measure', caliper: distance"));
  const std::string all = test::said("dcmdump +L " + files->front().string()).text;
  EXPECT_FALSE(holds(all, "Somebody")) << all;
  EXPECT_TRUE(holds(all, test::someCodes().ofPerson("Somebody")));
  const auto named = writeAttemptMeasurements(one, lesson, test::someCodes(), true, world.library(), out.path());
  ASSERT_TRUE(test::succeeded(named));
  EXPECT_TRUE(holds(test::said("dcmdump +L " + named->front().string()).text, "Somebody"));
}

TEST(MeasurementsOfAnAttempt, OfACaseThatIsGoneAreRefused) {
  const AssessedWorld world;
  const test::TemporaryFolder out, empty;
  const auto one = readBack(measuredAttempt(world, MeasurementAnswer{40.5, "mm", {}, {}}));
  const auto lesson = readReportedLesson("ball", "about-balls", world.library(), {});
  const auto files = writeAttemptMeasurements(one, lesson, test::someCodes(), false, empty.path(), out.path());
  ASSERT_FALSE(files);
  EXPECT_EQ(files.error().code, ErrorCode::notFound);
  EXPECT_TRUE(fs::is_empty(out.path()));
}

TEST(MeasurementsOfAnAttempt, ThatMeasuredNothingMakeNoFile) {
  const AssessedWorld world;
  const test::TemporaryFolder out;
  const auto one = readBack(world.keep("20261101-100000-aaaaaaab", {{.step = "answer", .answer = OptionsAnswer{{0}}}}));
  const auto lesson = readReportedLesson("ball", "about-balls", world.library(), {});
  const auto files = writeAttemptMeasurements(one, lesson, test::someCodes(), false, world.library(), out.path());
  ASSERT_TRUE(test::succeeded(files));
  EXPECT_TRUE(files->empty());
}

}  // namespace
}  // namespace ew
