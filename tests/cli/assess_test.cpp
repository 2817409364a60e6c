#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "assessment/assessed_world.h"
#include "ew/cli/run_command.h"
#include "ew/library/step_answer.h"

namespace ew::test::assess_command_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct Said {
  int status = -1;
  std::string out, err;
};

Said run(std::vector<std::string> args) {
  std::ostringstream out, err;
  Said said;
  said.status = cli::runCommand(args, {out, err});
  said.out = out.str();
  said.err = err.str();
  return said;
}

std::vector<AssessedWorld::Tried> tries(double z_mm) {
  return {{.step = "plane", .scan = scanAlong([=](double t) { return heldAt(z_mm + std::max(0.0, 8.0 - 4.0 * t)); }, 4.0)},
          {.step = "answer", .answer = OptionsAnswer{{0}}}};
}

class AssessCommand : public ::testing::Test {
 protected:
  AssessedWorld world_;
  const TemporaryFolder outputs_;
};

TEST_F(AssessCommand, ScoresTheLibraryOnceAndSaysSo) {
  world_.keep("20261101-100000-aaaaaaaa", tries(0.0));
  world_.keep("20261101-100001-bbbbbbbb", tries(4.0));
  const Said first = run({"assess", "-o", (outputs_ / "scores").string(), "--report", (outputs_ / "r.json").string()});
  EXPECT_EQ(first.status, 0) << first.err;
  EXPECT_NE(first.out.find("Scored 2 attempts now; 0 were up to date."), std::string::npos) << first.out;
  EXPECT_EQ(first.out.find("Somebody"), std::string::npos) << "names only when they are asked for";
  EXPECT_NE(first.out.find("T-"), std::string::npos) << first.out;
  const json report = json::parse(textOf(outputs_ / "r.json"));
  EXPECT_EQ(report["quality"]["scored_now"], 2);
  EXPECT_EQ(report["attempts"].size(), 2u) << report.dump(1);
  const json score = json::parse(textOf(outputs_ / "scores" / "20261101-100001-bbbbbbbb.json"));
  EXPECT_NEAR(score["steps"][1]["task"].get<double>(), 1.0 - 0.3 * 0.8, 1e-6);
  const Said again = run({"assess", "--names"});
  EXPECT_NE(again.out.find("Scored 0 attempts now; 2 were up to date."), std::string::npos) << again.out;
  EXPECT_NE(again.out.find("Somebody"), std::string::npos);
}

TEST_F(AssessCommand, ScoresWhatItCanAndNamesTheRest) {
  const fs::path good = world_.keep("20261101-100000-aaaaaaaa", tries(0.0));
  const fs::path bad = world_.keep("20261101-100001-bbbbbbbb", tries(0.0));
  writeText(bad / "attempt.json", "{");
  const Said said = run({"assess", good.parent_path().string()});
  EXPECT_EQ(said.status, 1);
  EXPECT_NE(said.err.find("1 attempt of 2 could not be scored"), std::string::npos) << said.err;
  EXPECT_NE(said.out.find("20261101-100001-bbbbbbbb"), std::string::npos);
  EXPECT_TRUE(latestScore(good));
}

TEST_F(AssessCommand, RefusesAFolderWithoutAttempts) {
  const Said none = run({"assess", (outputs_ / "nothing").string()});
  EXPECT_EQ(none.status, 1);
  EXPECT_NE(none.err.find("neither an attempt nor a folder of attempts"), std::string::npos) << none.err;
  const Said empty = run({"assess"});
  EXPECT_EQ(empty.status, 1);
  EXPECT_NE(empty.err.find("There are no attempts in"), std::string::npos) << empty.err;
}

TEST_F(AssessCommand, WritesTheSameToPrintWithoutAWindow) {
  world_.keep("20261101-100000-aaaaaaaa", tries(0.0));
  const fs::path paper = outputs_ / "paper";
  const Said said = run({"assess", "--pdf", paper.string(), "--report", (outputs_ / "r.json").string()});
  EXPECT_EQ(said.status, 0) << said.err;
  for (const std::string name : {"index.pdf", "attempt-20261101-100000-aaaaaaaa.pdf"}) {
    EXPECT_TRUE(textOf(paper / name).starts_with("%PDF-")) << name;
    EXPECT_EQ(textOf(paper / name).find("Somebody"), std::string::npos);
  }
  EXPECT_EQ(json::parse(textOf(outputs_ / "r.json"))["outputs"].size(), 2u);
  writeText(outputs_ / "file", "");
  EXPECT_EQ(run({"assess", "--pdf", (outputs_ / "file").string()}).status, 1) << "a file is no folder";
  EXPECT_EQ(textOf(outputs_ / "file"), "");
}

TEST_F(AssessCommand, WritesPagesATableAndDicomReports) {
  auto measured = tries(0.0);
  measured.push_back({.step = "measure",
                      .scan = scanAlong([](double) { return heldAt(); }, 2.0),
                      .answer = MeasurementAnswer{40.5, "mm", "distance", {{-20, 0, 0}, {20.5, 0, 0}}}});
  world_.keep("20261101-100000-aaaaaaaa", measured);
  world_.keep("20261101-100001-bbbbbbbb", tries(4.0));
  const Said said = run({"assess", "--html", (outputs_ / "pages").string(), "--csv", (outputs_ / "t.csv").string(), "--dicom",
                         (outputs_ / "reports").string()});
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_NE(textOf(outputs_ / "pages" / "index.html").find("About balls"), std::string::npos);
  EXPECT_NE(textOf(outputs_ / "t.csv").find("20261101-100001-bbbbbbbb"), std::string::npos);
  EXPECT_EQ(textOf(outputs_ / "t.csv").find("Somebody"), std::string::npos);
  std::size_t reports = 0;
  for (const auto& entry : fs::directory_iterator(outputs_ / "reports")) {
    ++reports;
    EXPECT_EQ(entry.path().filename().string(), "20261101-100000-aaaaaaaa-ball.dcm") << "only what measured something";
    EXPECT_EQ(textOf(entry.path()).substr(128, 4), "DICM");
  }
  EXPECT_EQ(reports, 1u);
}

}  // namespace
}  // namespace ew::test::assess_command_test
