#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "cli/cli_world.h"
#include "ew/imaging/settings_json.h"
#include "ew/library/case_start.h"
#include "ew/library/case_truth.h"
#include "ew/scanning/contact.h"
#include "ew/scanning/preset.h"
#include "ew/scanning/recording.h"
#include "places.h"

namespace ew::test::lesson_command_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class LessonCommand : public ::testing::Test {
 protected:
  const TemporaryFolder folder_;
  const fs::path cases_ = fs::path(EW_SOURCE_DIR) / "cases";
  EnvironmentValue resources_{"ECHOWEAVE_RESOURCES", std::string(EW_SOURCE_DIR) + "/resources"};
  EnvironmentValue cache_{"ECHOWEAVE_CACHE", folder_ / "cache"};
  const std::string fetus_ = (cases_ / "fetal-biometry").string();

  /// A copy of the case of the fetus with its lessons changed.
  std::string changed(const std::function<void(json& lessons)>& change) const {
    const std::string copy = folder_ / "copy";
    fs::copy(fetus_, copy, fs::copy_options::recursive);
    json manifest = readJson(copy + "/case.json");
    change(manifest["parts"]["lessons"]["lessons"]);
    writeText(copy + "/case.json", manifest.dump());
    return copy;
  }

  std::string pathFile(const json& stations) const {
    writeText(folder_ / "p.path.json", json{{"format", 1}, {"rate_hz", 10}, {"stations", stations}}.dump());
    return folder_ / "p.path.json";
  }
};

TEST_F(LessonCommand, ListsAndShowsTheLessonsOfACaseInTheLanguageAskedFor) {
  const auto list = run({"lesson", "list", fetus_});
  EXPECT_EQ(list.status, 0) << list.err;
  EXPECT_NE(list.out.find("three-standard-planes  Three standard planes (level 2, about 25 minutes, 8 steps)"), std::string::npos)
      << list.out;
  const auto shown = run({"lesson", "show", fetus_, "three-standard-planes", "--language", "de"});
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_NE(shown.out.find("Drei Standardebenen"), std::string::npos) << shown.out;
  EXPECT_NE(shown.out.find("3 Der Kopf [plane]"), std::string::npos) << shown.out;
  const auto missing = run({"lesson", "show", fetus_, "nothing"});
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(missing.err.find("it has three-standard-planes, biometry-complete."), std::string::npos) << missing.err;
}

TEST_F(LessonCommand, ChecksWhatLessonsReferTo) {
  EXPECT_EQ(run({"lesson", "check", fetus_}).status, 0);
  const std::string copy = changed([](json& lessons) {
    lessons[0]["steps"][2]["target"] = "nowhere";
    lessons[0]["steps"][1]["marks"][0]["time_s"] = 1000;
  });
  fs::copy_file(cases_ / "focused-trauma/parts/lessons/scans/windows.seq.mha", copy + "/parts/lessons/scans/head-planes.seq.mha",
                fs::copy_options::overwrite_existing);
  const auto bad = run({"lesson", "check", copy, "--report", folder_ / "r.json"});
  EXPECT_EQ(bad.status, 1);
  EXPECT_NE(bad.out.find("three-standard-planes, step head: The case 'fetal-biometry' has no plane 'nowhere'"), std::string::npos)
      << bad.out;
  EXPECT_NE(bad.out.find("step expert: A mark stands at 1000 s"), std::string::npos) << bad.out;
  EXPECT_NE(bad.out.find("is a scan of the case 'focused-trauma', and the step scans 'fetal-biometry'"), std::string::npos) << bad.out;
  EXPECT_EQ(readJson(folder_ / "r.json")["quality"]["problems"], 3) << bad.out;
  const auto one = run({"lesson", "check", copy, "biometry-complete"});
  EXPECT_EQ(one.status, 1);
  EXPECT_EQ(one.out.find("nowhere"), std::string::npos) << one.out;
}

TEST_F(LessonCommand, RefusesLessonsThatCannotBeRead) {
  const std::string copy = changed([](json& lessons) { lessons[0]["steps"][0]["task"] = "dance"; });
  const auto bad = run({"lesson", "check", copy});
  EXPECT_EQ(bad.status, 1);
  EXPECT_NE(bad.err.find("task"), std::string::npos) << bad.err;
}

TEST_F(LessonCommand, RecordsAShippedPathAgainAsItWasRecorded) {
  for (const std::string scan : {"fetal-biometry/parts/lessons/scans/three-planes", "liver-sweep-recorded/parts/lessons/scans/landmarks"}) {
    const std::string opened = (cases_ / scan.substr(0, scan.find('/'))).string();
    const auto made = run({"lesson", "record", opened, "--path", (cases_ / scan).string() + ".path.json", "-o", folder_ / "again.seq.mha"});
    ASSERT_EQ(made.status, 0) << made.err;
    const auto shipped = readRecording((cases_ / scan).string() + ".seq.mha"), again = readRecording(folder_ / "again.seq.mha");
    ASSERT_TRUE(shipped && again);
    EXPECT_TRUE(shipped->log.events() == again->log.events()) << scan << ": every pose and gap, to the bit";
    fs::remove(folder_ / "again.seq.mha");
  }
}

TEST_F(LessonCommand, EveryShippedScanWasMadeInTheSceneOfItsCaseAndWithItsPreset) {
  int scans = 0;
  const auto resources = resourceFolder();
  ASSERT_TRUE(resources);
  const auto presets = readPresets(*resources / "presets");
  const auto probes = readProbes(*resources / "probes");
  ASSERT_TRUE(presets && probes);
  for (const auto& each : fs::directory_iterator(cases_)) {
    const fs::path folder = each.path() / "parts/lessons/scans";
    if (!fs::exists(folder)) continue;
    const auto opened = loadCase(each.path());
    ASSERT_TRUE(opened) << opened.error();
    Scene expected = opened->scene;
    expected.tissues.clear();  // of the patient: who plays a scan knows them
    for (const auto& file : fs::directory_iterator(folder)) {
      if (!file.path().string().ends_with(".seq.mha")) continue;
      const auto recorded = readRecording(file.path());
      ASSERT_TRUE(recorded) << recorded.error();
      const ScanState first = recorded->log.frame(0);
      const Preset* start = startPreset(presetsOf(*opened), *presets, {first.probe});
      ASSERT_NE(start, nullptr) << file.path();
      Knobs expectedKnobs = start->knobs;
      expectedKnobs.depth_mm = first.knobs.depth_mm;  // the expert's own choice
      EXPECT_TRUE(first.knobs == expectedKnobs) << file.path() << ": " << toJson(first.knobs) << " and not " << toJson(expectedKnobs);
      for (std::size_t n = 0; n < recorded->log.frameCount(); n += 20) {
        Scene scene = recorded->log.frame(n).scene;
        scene.tissues.clear();
        EXPECT_TRUE(scene == expected) << file.path() << ", frame " << n << ": " << toJson(scene) << " and not " << toJson(expected);
      }
      ++scans;
    }
  }
  EXPECT_GE(scans, 14);
}

TEST_F(LessonCommand, RecordsTheSameScanTwiceAlongTheStationsOfAPath) {
  const std::string path = pathFile({{{"plane", "transthalamic"}, {"stay_s", 1.0}},
                                     {{"plane", "femur"}, {"travel_s", 2.0}, {"stay_s", 1.0}, {"knobs", {{"depth_mm", 120}}}}});
  for (const char* name : {"a.seq.mha", "b.seq.mha"}) {
    const auto made = run({"lesson", "record", fetus_, "--path", path, "-o", folder_ / name});
    ASSERT_EQ(made.status, 0) << made.err;
  }
  EXPECT_EQ(readText(folder_ / "a.seq.mha"), readText(folder_ / "b.seq.mha"));

  const auto recording = readRecording(folder_ / "a.seq.mha");
  ASSERT_TRUE(recording) << recording.error().sentence();
  EXPECT_EQ(recording->caseId, "fetal-biometry");
  ASSERT_EQ(recording->log.frameCount(), 40u);
  const auto opened = loadCase(fetus_);
  const auto truth = loadCaseTruth(*opened, noProgress());
  ASSERT_TRUE(truth) << truth.error().sentence();
  const auto planeOf = [&](const std::string& name) {
    return std::find_if(truth->planes.begin(), truth->planes.end(), [&](const auto& each) { return each.name == name; })
        ->probeToWorld.matrix;
  };
  const auto expectNear = [](const ScanState& frame, const glm::dmat4& plane) {
    const glm::dmat4& at = frame.pose.probeToWorld.matrix;
    const glm::dvec3 away(at[3] - plane[3]);
    EXPECT_LT(std::abs(glm::dot(away, glm::dvec3(plane[0]))), 2.0);
    EXPECT_LT(std::abs(glm::dot(away, glm::dvec3(plane[1]))), kMaxPress_mm) << "a hand presses the probe on, where a plane may only touch";
    EXPECT_LT(std::abs(glm::dot(away, glm::dvec3(plane[2]))), 1.0);
    for (int axis = 0; axis < 3; ++axis) EXPECT_GT(glm::dot(glm::dvec3(at[axis]), glm::dvec3(plane[axis])), std::cos(0.05));
  };
  expectNear(recording->log.frame(5), planeOf("transthalamic"));
  expectNear(recording->log.frame(39), planeOf("femur"));
  EXPECT_EQ(recording->log.frame(5).knobs.depth_mm, 130.0) << "of the case's preset";
  EXPECT_EQ(recording->log.frame(39).knobs.depth_mm, 120.0);
  for (std::size_t n = 0; n < recording->log.frameCount(); ++n) {
    const ScanState frame = recording->log.frame(n);
    EXPECT_GT(contactShare(frame.gaps_mm), 0.5) << "frame " << n;
    if (n == 0) continue;
    const ScanState before = recording->log.frame(n - 1);
    EXPECT_LT(glm::distance(glm::dvec3(frame.pose.probeToWorld.matrix[3]), glm::dvec3(before.pose.probeToWorld.matrix[3])), 25.0);
  }
}

TEST_F(LessonCommand, MovesStationsByTheirOffsets) {
  const std::string path = pathFile({{{"plane", "start"}, {"stay_s", 0.2}},
                                     {{"plane", "start"}, {"offset", {{"slide_mm", {0, 30}}, {"rotation_deg", 90}}}, {"stay_s", 0.2}}});
  ASSERT_EQ(run({"lesson", "record", fetus_, "--path", path, "-o", folder_ / "a.seq.mha"}).status, 0);
  const auto recording = readRecording(folder_ / "a.seq.mha");
  ASSERT_TRUE(recording);
  const glm::dmat4 first = recording->log.frame(0).pose.probeToWorld.matrix;
  const glm::dmat4 last = recording->log.frame(recording->log.frameCount() - 1).pose.probeToWorld.matrix;
  EXPECT_NEAR(glm::distance(glm::dvec3(first[3]), glm::dvec3(last[3])), 30.0, 3.0);
  EXPECT_GT(last[3].z, first[3].z - 31.0);
  EXPECT_LT(last[3].z, first[3].z - 25.0) << "elevational is towards the feet when the marker is on the right";
  EXPECT_NEAR(glm::dot(glm::dvec3(first[0]), glm::dvec3(last[0])), 0.0, 0.1);
}

TEST_F(LessonCommand, SaysWhatIsWrongWithAPath) {
  const auto refusal = [&](const json& stations) {
    const auto made = run({"lesson", "record", fetus_, "--path", pathFile(stations), "-o", folder_ / "x.seq.mha"});
    EXPECT_EQ(made.status, 1);
    EXPECT_FALSE(fs::exists(folder_ / "x.seq.mha"));
    return made.err;
  };
  EXPECT_NE(refusal({{{"plane", "nowhere"}}}).find("name one that it has: start, transthalamic"), std::string::npos);
  EXPECT_NE(refusal({{{"stay_s", 1}}}).find("stations[0].plane"), std::string::npos);
  EXPECT_NE(refusal({{{"plane", "femur"}, {"knobs", {{"depth_mm", -3}}}}}).find("depth_mm"), std::string::npos);
  EXPECT_NE(refusal(json::array()).find("'stations'"), std::string::npos);
  const json behind = {1, 0, 0, 0, 0, -1, 0, 200, 0, 0, -1, -300, 0, 0, 0, 1};
  EXPECT_NE(refusal({{{"plane", "start"}}, {{"pose", behind}}}).find("put a station between them"), std::string::npos);
}

TEST_F(LessonCommand, ShowsTheCourseAndNamesWhatItLacks) {
  const auto whole = run({"lesson", "course", (cases_ / "course.json").string(), "--language", "de"});
  EXPECT_EQ(whole.status, 0) << whole.err;
  EXPECT_LT(whole.out.find("Orientierung und Bewegungen"), whole.out.find("Drei Standardebenen")) << whole.out;
  EXPECT_NE(whole.out.find("Drei Standardebenen (Stufe 2, etwa 25 Minuten, 8 Schritte)"), std::string::npos) << whole.out;
  EXPECT_EQ(whole.out.find("level "), std::string::npos) << whole.out;
  json course = readJson((cases_ / "course.json").string());
  course["lessons"].push_back({{"case", "fetal-biometry"}, {"lesson", "nothing"}});
  writeText(folder_ / "course.json", course.dump());
  const auto lacking = run({"lesson", "course", folder_ / "course.json"});
  EXPECT_EQ(lacking.status, 1);
  EXPECT_NE(lacking.err.find("1 lesson"), std::string::npos) << lacking.err;
}

}  // namespace
}  // namespace ew::test::lesson_command_test
