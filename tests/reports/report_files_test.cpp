#include "ew/reports/report_files.h"

#include "ew/core/output_set.h"
#include "ew/library/step_answer.h"
#include "export/export_world.h"
#include "reports/example_class.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using test::AssessedWorld;
using test::holds;
using test::textOf;

ScanLog someScan() {
  return test::scanAlong([](double t) { return test::heldAt(20.0 - 4.0 * t, 0.0, 3.0 * t); }, 5.0);
}

/// Two attempts of the world's lesson, scored.
std::vector<fs::path> keptAttempts(const AssessedWorld& world) {
  std::vector<fs::path> folders;
  for (const std::string id : {"20261101-100000-aaaaaaaa", "20261101-110000-bbbbbbbb"})
    folders.push_back(world.keep(
        id, {{.step = "plane", .scan = someScan()},
             {.step = "measure", .scan = someScan(), .answer = MeasurementAnswer{40.5, "mm", "distance", {{-20, 0, 0}, {20.5, 0, 0}}}},
             {.step = "answer", .answer = OptionsAnswer{{0}}}}));
  for (const AttemptAssessment& one : assess(folders, world.library())) EXPECT_TRUE(one.score.has_value());
  return folders;
}

TEST(ReportFiles, AreAPageForTheClassAndOneForEachAttemptLinkedByRelativeNames) {
  const AssessedWorld world;
  const test::TemporaryFolder out;
  const ReportRequest request{.attempts = keptAttempts(world), .library = world.library(), .html = out / "pages", .csv = out / "all.csv"};
  ASSERT_TRUE(test::succeeded(writeReports(request)));
  EXPECT_EQ(test::namesIn(out / "pages"),
            (std::set<std::string>{"index.html", "attempt-20261101-100000-aaaaaaaa.html", "attempt-20261101-110000-bbbbbbbb.html"}));
  const std::string index = textOf(out / "pages" / "index.html"), page = textOf(out / "pages" / "attempt-20261101-100000-aaaaaaaa.html");
  EXPECT_TRUE(holds(index, "href='./attempt-20261101-110000-bbbbbbbb.html'"));
  EXPECT_TRUE(holds(page, "href='./index.html'"));
  EXPECT_TRUE(holds(page, "Way of the probe over the skin"));
  EXPECT_TRUE(holds(page, "About balls"));
  EXPECT_FALSE(holds(page, "Somebody"));
  EXPECT_FALSE(holds(page, world.library().string())) << "folders of this computer are nobody's business";
  EXPECT_EQ(test::countOf(textOf(out / "all.csv"), "\r\n"), 15u) << "a line of names, seven steps of two attempts";
  const auto files = reportFiles(request);
  ASSERT_TRUE(test::succeeded(files));
  for (const fs::path& file : *files) EXPECT_TRUE(fs::exists(file)) << file;
  EXPECT_EQ(files->size(), 4u);
}

TEST(ReportFiles, ArePagesAndPaperOfTheSameNames) {
  const AssessedWorld world;
  const test::TemporaryFolder out;
  const ReportRequest request{.attempts = keptAttempts(world), .library = world.library(), .html = out / "all", .pdf = out / "all"};
  ASSERT_TRUE(test::succeeded(writeReports(request)));
  EXPECT_EQ(test::namesIn(out / "all"),
            (std::set<std::string>{"index.html", "attempt-20261101-100000-aaaaaaaa.html", "attempt-20261101-110000-bbbbbbbb.html",
                                   "index.pdf", "attempt-20261101-100000-aaaaaaaa.pdf", "attempt-20261101-110000-bbbbbbbb.pdf"}));
  EXPECT_TRUE(textOf(out / "all" / "index.pdf").starts_with("%PDF-"));
  const auto files = reportFiles(request);
  ASSERT_TRUE(test::succeeded(files));
  EXPECT_EQ(files->size(), 6u);
  for (const fs::path& file : *files) EXPECT_TRUE(fs::exists(file)) << file;
}

TEST(ReportFiles, AreTheSameWrittenTwiceAndOnAnyNumberOfThreads) {
  const AssessedWorld world;
  const test::TemporaryFolder out;
  ReportRequest request{.attempts = keptAttempts(world), .library = world.library(), .html = out / "a", .pdf = out / "a", .threads = 1};
  ASSERT_TRUE(test::succeeded(writeReports(request)));
  request.html = request.pdf = out / "b";
  request.threads = 2;
  ASSERT_TRUE(test::succeeded(writeReports(request)));
  for (const std::string& name : test::namesIn(out / "a")) EXPECT_EQ(textOf(out / "a" / name), textOf(out / "b" / name)) << name;
}

TEST(ReportFiles, ShowTheExpertBesideTheTrainee) {
  const AssessedWorld world;
  const test::TemporaryFolder out;
  const auto folders = keptAttempts(world);
  AssessmentPlan plan = *readPlan(world.library(), "ball", "about-balls");
  plan.expertAttempt = "20261101-110000-bbbbbbbb";
  ASSERT_TRUE(keepPlan(world.library(), plan));
  ASSERT_EQ(assess(folders, world.library()).size(), 2u);
  ASSERT_TRUE(test::succeeded(writeReports({.attempts = folders, .library = world.library(), .html = out / "pages"})));
  EXPECT_TRUE(holds(textOf(out / "pages" / "attempt-20261101-100000-aaaaaaaa.html"), ">the expert</text>"));
  EXPECT_FALSE(holds(textOf(out / "pages" / "attempt-20261101-110000-bbbbbbbb.html"), ">the expert</text>"))
      << "nobody is compared with themselves";
}

TEST(ReportFiles, ListAScoreOfAnEarlierPlanAsSuchUntilTheAttemptIsScoredAgain) {
  const AssessedWorld world;
  const test::TemporaryFolder out;
  const auto folders = keptAttempts(world);
  AssessmentPlan plan = *readPlan(world.library(), "ball", "about-balls");
  plan.passLevel = 0.5;
  ASSERT_TRUE(keepPlan(world.library(), plan));
  const ReportRequest request{.attempts = folders, .library = world.library(), .html = out / "pages", .csv = out / "all.csv"};
  ASSERT_TRUE(test::succeeded(writeReports(request)));
  const std::string page = textOf(out / "pages" / "attempt-20261101-100000-aaaaaaaa.html"), table = textOf(out / "all.csv");
  EXPECT_TRUE(holds(page, "Earlier scores"));
  EXPECT_TRUE(holds(page, "score 1 was made by an earlier revision of the plan"));
  EXPECT_FALSE(holds(page, "not scored since"));
  EXPECT_FALSE(holds(table, "path_length")) << "no metric counts, so there is no column that nothing could fill";
  ASSERT_EQ(assess(folders, world.library()).size(), 2u);
  ASSERT_TRUE(test::succeeded(writeReports(request)));
  EXPECT_TRUE(holds(textOf(out / "pages" / "attempt-20261101-100000-aaaaaaaa.html"), "Score number</dt><dd>2</dd>"));
  EXPECT_TRUE(holds(textOf(out / "all.csv"), "path_length"));
}

TEST(ReportFiles, OfSeveralLessonsHaveAnIndexOfTheirClasses) {
  const AssessedWorld world;
  const test::TemporaryFolder out;
  auto folders = keptAttempts(world);
  Attempt other;
  other.id = "../../<odd>";
  other.caseId = "gone";
  other.lessonId = "gone";
  other.lessonTitle = "A lesson that is gone";
  const auto kept = AttemptFolder::begin(out / "elsewhere", [&] {
    Attempt named = other;
    named.id = "odd";
    return named;
  }());
  ASSERT_TRUE(test::succeeded(kept));
  test::writeText(kept->folder() / "attempt.json", jsonOf(other).dump());
  folders.push_back(kept->folder());
  ASSERT_TRUE(test::succeeded(writeReports({.attempts = folders, .library = world.library(), .html = out / "pages"})));
  EXPECT_EQ(test::namesIn(out / "pages"),
            (std::set<std::string>{"index.html", "lesson-1.html", "lesson-2.html", "attempt--------odd-.html",
                                   "attempt-20261101-100000-aaaaaaaa.html", "attempt-20261101-110000-bbbbbbbb.html"}));
  const std::string index = textOf(out / "pages" / "index.html");
  EXPECT_TRUE(holds(index, "<a href='./lesson-2.html'>A lesson that is gone</a>")) << index;
}

TEST(ReportFiles, LeaveOutAnAttemptThatCannotBeReadAndSaySo) {
  const AssessedWorld world;
  const test::TemporaryFolder out;
  auto folders = keptAttempts(world);
  test::writeText(out / "torn" / "attempt.json", "{\"format\": 1,");
  folders.push_back(out / "torn");
  const ReportRequest request{.attempts = folders, .library = world.library(), .html = out / "pages"};
  ASSERT_TRUE(test::succeeded(writeReports(request)));
  EXPECT_EQ(test::namesIn(out / "pages").size(), 3u);
  const std::string index = textOf(out / "pages" / "index.html");
  EXPECT_TRUE(holds(index, "The attempt &#39;torn&#39; is left out: "));
  EXPECT_FALSE(holds(index, out.path().string()));
  EXPECT_TRUE(holds(index, "<dt>Attempts</dt><dd>2</dd>"));
}

TEST(ReportFiles, AreAllOrNoneThroughACommandsOutputs) {
  const AssessedWorld world;
  const test::TemporaryFolder out;
  const ReportRequest request{.attempts = keptAttempts(world), .library = world.library(), .html = out / "pages"};
  const auto files = reportFiles(request);
  ASSERT_TRUE(test::succeeded(files));
  {
    OutputSet outputs;
    ASSERT_TRUE(test::succeeded(outputs.announceFolder(request.html)));
    for (const fs::path& file : *files) ASSERT_TRUE(test::succeeded(outputs.announce(file)));
    ASSERT_TRUE(test::succeeded(writeReports(request, [&](const fs::path& file) { return outputs.staged(file); })));
    EXPECT_FALSE(fs::exists(out / "pages" / "index.html"));
  }
  EXPECT_FALSE(fs::exists(out / "pages")) << "nothing was put in place";
  OutputSet outputs;
  ASSERT_TRUE(test::succeeded(outputs.announceFolder(request.html)));
  for (const fs::path& file : *files) ASSERT_TRUE(test::succeeded(outputs.announce(file)));
  ASSERT_TRUE(test::succeeded(writeReports(request, [&](const fs::path& file) { return outputs.staged(file); })));
  ASSERT_TRUE(test::succeeded(outputs.commit()));
  for (const fs::path& file : *files) EXPECT_TRUE(fs::exists(file)) << file;
}

TEST(ReportFiles, OfAWholeClassHaveItsRatingsCommentsImagesAndTheExpert) {
  const AssessedWorld world;
  const test::TemporaryFolder out;
  const fs::path pages = test::lookedAt().empty() ? out / "pages" : test::lookedAt() / "reports";
  ASSERT_TRUE(test::succeeded(
      writeReports({.attempts = test::exampleClass(world), .library = world.library(), .html = pages, .csv = pages / "all.csv"})));
  const std::string index = textOf(pages / "index.html"), page = textOf(pages / "attempt-20261101-140000-aaaaaaaa.html");
  for (const char* part : {"Hardest step", "How far raters agree", "Weighted kappa", "attempts should pass", "weight 1"})
    EXPECT_TRUE(holds(index, part)) << part;
  for (const char* part :
       {"src='data:image/png;base64,", "Earlier scores", "&lt;wait&gt; &amp; look.", ">the expert</text>", "Two items, by R-", "weight 1"})
    EXPECT_TRUE(holds(page, part)) << part;
  for (const char* name : {"Rita", "Sven", "Somebody"}) {
    EXPECT_FALSE(holds(index, name)) << name;
    EXPECT_FALSE(holds(page, name)) << name;
  }
}

TEST(ReportFiles, OfNothingAreRefusedWithASentence) {
  EXPECT_EQ(writeReports({}).error().code, ErrorCode::badUsage);
  const test::TemporaryFolder out;
  EXPECT_EQ(writeReports({.attempts = {out / "none"}, .library = out.path(), .html = out / "pages"}).error().code, ErrorCode::notFound);
  EXPECT_FALSE(fs::exists(out / "pages"));
}

}  // namespace
}  // namespace ew
