// An examination of a virtual patient shows what the training case shows, to the pixel, and says no names.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <random>
#include <set>

#include "access/trainee_view.h"
#include "case/flow_file.h"
#include "ew/imaging/settings_json.h"
#include "ew/library/case_contents.h"
#include "ew/library/case_echoes.h"
#include "ew/scanning/scanner.h"
#include "library/coarse_case.h"
#include "library/examination_world.h"

namespace ew::test::examination_pixels_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// ---- images ----

/// What may change between two images of one subject.
struct Look {
  std::string name;
  std::function<void(ScanState&)> set;
};

void movePose(ScanState& state, const glm::dvec3& by_mm) {
  state.pose.probeToWorld.matrix = glm::translate(state.pose.probeToWorld.matrix, by_mm);
}
void turnPose(ScanState& state, double angle_deg, const glm::dvec3& axis) {
  state.pose.probeToWorld.matrix = glm::rotate(state.pose.probeToWorld.matrix, glm::radians(angle_deg), axis);
}

std::vector<Look> looks() {
  return {{"as it begins", [](ScanState&) {}},
          {"half a breath", [](ScanState& s) { s.body.breath = 0.5; }},
          {"a whole breath", [](ScanState& s) { s.body.breath = 1.0; }},
          {"a pulse", [](ScanState& s) { s.body.pulse = 1.0; }},
          {"everything moves",
           [](ScanState& s) {
             s.body = {0.4, 0.7, 0.3};
           }},
          {"pressed",
           [](ScanState& s) {
             movePose(s, {0.0, 4.0, 0.0});
           }},
          {"aside, in breath",
           [](ScanState& s) {
             movePose(s, {7.0, 1.0, -5.0});
             s.body.breath = 0.5;
           }},
          {"rotated",
           [](ScanState& s) {
             turnPose(s, 75.0, {0.0, 1.0, 0.0});
           }},
          {"tilted, in a pulse",
           [](ScanState& s) {
             turnPose(s, 15.0, {1.0, 0.0, 0.0});
             s.body.pulse = 0.5;
           }},
          {"lifted at one end",
           [](ScanState& s) {
             s.gaps_mm = {0.0F, 0.0F, 0.0F, 8.0F, 12.0F};
           }},
          {"shallow and magnified",
           [](ScanState& s) {
             s.knobs.depth_mm = 60.0;
             s.knobs.zoom = 1.7;
           }},
          {"other settings",
           [](ScanState& s) {
             s.knobs.gain_db = 6.0;
             s.knobs.dynamicRange_db = 50.0;
             s.knobs.focus_mm = 30.0;
             s.knobs.edgeEnhancement = 0.5;
             s.number = 7;
           }},
          {"quick", [](ScanState& s) { s.knobs.quality = Quality::weave; }},
          {"careful", [](ScanState& s) { s.knobs.quality = Quality::cubic; }},
          {"without live echoes", [](ScanState& s) { s.scene.liveEchoes.reset(); }},
          {"slices with little else", [](ScanState& s) {
             s.scene.liveEchoes.reset();
             s.scene.reverberation.reset();
             s.scene.noise.reset();
             s.knobs.quality = Quality::cubic;
           }}};
}

std::vector<std::uint8_t> greyOf(Scanner& scanner, const ScanState& state) {
  constexpr int kWidth_px = 220, kHeight_px = 180;
  const DisplayImage image = scanner.make(state, kWidth_px, kHeight_px);
  std::vector<std::uint8_t> grey;
  for (int y = 0; y < image.height(); ++y) grey.insert(grey.end(), image.grey.row(y), image.grey.row(y) + image.width());
  scanner.forget();
  return grey;
}

ScanSubject subjectIn(const fs::path& folder) {
  const auto opened = loadCase(folder);
  EXPECT_TRUE(opened) << opened.error();
  const auto contents = readContents(*opened, noProgress());
  EXPECT_TRUE(contents) << contents.error();
  return subjectOf(*opened, *contents);
}

ScanState startOf(const ScanSubject& subject) {
  const auto state = firstState(subject, *readProbes(*resourceFolder() / "probes"), *readPresets(*resourceFolder() / "presets"));
  EXPECT_TRUE(state);
  return *state;
}

/// That two subjects show the same in every look.
/// @return how many looks of the first show something of their own
std::size_t expectSamePixels(const ScanSubject& own, const ScanSubject& theirs) {
  Scanner ours, others;
  ours.show(own);
  others.show(theirs);
  std::set<std::vector<std::uint8_t>> seen;
  for (const Look& look : looks()) {
    ScanState here = startOf(own), there = startOf(theirs);
    look.set(here);
    look.set(there);
    const auto grey = greyOf(ours, here), shown = greyOf(others, there);
    EXPECT_GT(std::count_if(grey.begin(), grey.end(), [](int level) { return level > 20; }), 100) << look.name;
    seen.insert(grey);
    EXPECT_EQ(shown.size(), grey.size());
    std::size_t different = 0;
    for (std::size_t n = 0; n < std::min(grey.size(), shown.size()); ++n) different += grey[n] != shown[n] ? 1 : 0;
    EXPECT_EQ(different, 0u) << look.name << ": pixels of " << grey.size();
  }
  return seen.size();
}

/// The same blood: to the last bit, for the same numbers give the same tables.
void expectSameBlood(const ScanSubject& own, const ScanSubject& theirs) {
  ASSERT_EQ(own.flow == nullptr, theirs.flow == nullptr);
  if (!own.flow) return;
  EXPECT_EQ(theirs.flow->bounds().lowest_mm, own.flow->bounds().lowest_mm);
  EXPECT_EQ(theirs.flow->bounds().highest_mm, own.flow->bounds().highest_mm);
  EXPECT_EQ(theirs.flow->bytes(), own.flow->bytes());
  FlowMoment here, there;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::size_t flowing = 0;
  for (int n = 0; n < 4000; ++n) {
    own.flow->prepare(0.37 * n, here);
    theirs.flow->prepare(0.37 * n, there);
    const Bounds& box = own.flow->bounds();
    const glm::dvec3 p_mm = box.lowest_mm + (box.highest_mm - box.lowest_mm) * glm::dvec3(share(random), share(random), share(random));
    const BloodVelocity ours = own.flow->at(here, p_mm), shown = theirs.flow->at(there, p_mm);
    ASSERT_EQ(shown.mean_mmPerS, ours.mean_mmPerS);
    ASSERT_EQ(shown.turbulence_mmPerS, ours.turbulence_mmPerS);
    flowing += glm::length(ours.mean_mmPerS) > 1.0 ? 1 : 0;
  }
  EXPECT_GT(flowing, 5U);
}

/// The same of a virtual patient: whatever forms images is alike, and the comparison sees what it is about.
std::size_t expectSamePatient(const ScanSubject& own, const ScanSubject& theirs) {
  const bool isThere = own.tissue && theirs.tissue && own.motion && theirs.motion;
  EXPECT_TRUE(isThere);
  if (!isThere) return 0;
  EXPECT_FALSE(own.tissue->surfaces.empty());
  EXPECT_FALSE(theirs.tissue->isRecorded);
  EXPECT_EQ(*theirs.motion, *own.motion);
  EXPECT_EQ(theirs.tissue->level, own.tissue->level);
  EXPECT_EQ(theirs.tissue->surfaceDistance, own.tissue->surfaceDistance);
  EXPECT_EQ(theirs.placedTissue, own.placedTissue);
  EXPECT_EQ(theirs.placedLabels, own.placedLabels);
  EXPECT_EQ(theirs.placedGrid, own.placedGrid);
  expectSameBlood(own, theirs);
  ScanSubject bare = own;
  auto maps = std::make_shared<TissueMaps>(*own.tissue);
  maps->surfaces.clear();
  bare.tissue = maps;
  Scanner whole, without;
  whole.show(own);
  without.show(bare);
  EXPECT_NE(greyOf(without, startOf(own)), greyOf(whole, startOf(own))) << "no surface is seen from the start";
  return expectSamePixels(own, theirs);
}

json lessonOfOnePlane() {
  return {
      {"format", 1},
      {"lessons", {{{"id", "l"}, {"title", "L"}, {"steps", {{{"id", "s"}, {"title", "S"}, {"task", "plane"}, {"target", "across"}}}}}}}};
}

/// The ball of the small case, drawn, with a cyst and its twin that touch, one far from both, another kind of wall, a vessel that beats,
/// and breath; placed aslant in the world. Everything has a name that is looked for.
void makeTwins(const fs::path& folder) {
  makeSmallCase(folder);
  json patient = json::parse(textOf(folder / "patient.json"));
  const auto ball = [](const char* name, const glm::dvec3& at_mm, double radius_mm, double level) {
    return json{{"name", name},
                {"tissue", "SECRETDARK"},
                {"shape", {{"ellipsoid", {{"centre_mm", {at_mm.x, at_mm.y, at_mm.z}}, {"radii_mm", {radius_mm, radius_mm, radius_mm}}}}}},
                {"border", {{"echo_level", level}, {"width_mm", 0.8}}}};
  };
  patient["tissues"].push_back({{"name", "SECRETDARK"}, {"echo_level", 30}, {"speckle", 0.5}, {"attenuation_db_per_cm_mhz", 0.1}});
  patient["tissues"].push_back(
      {{"name", "SECRETSTONE"}, {"echo_level", 200}, {"speckle", 1}, {"reflection_db", 25}, {"attenuation_db_per_cm_mhz", 2}});
  patient["organs"] = {ball("SECRETTWINONE", {-7, -30, 0}, 8, 210),   ball("SECRETTWINTWO", {7, -30, 0}, 8, 210),
                       ball("SECRETFAR", {0, -8, 4}, 6, 210),         ball("SECRETOTHER", {18, -38, 2}, 5, 180),
                       ball("SECRETSTONEONE", {-22, -34, 0}, 3, 240), ball("SECRETSTONETWO", {-22, -28, 0}, 4, 240)};
  patient["organs"][4]["tissue"] = patient["organs"][5]["tissue"] = "SECRETSTONE";
  patient["shapes"] = {{{"name", "SECRETVESSEL"}, {"tube", {{"points", {{0, -18, -40, 4}, {0, -16, 40, 5}}}}}}};
  patient["motion"] = {{"breathing", {{"displacement_mm", {0, 3, -8}}, {"held_depth_mm", 4}, {"free_depth_mm", 25}, {"tidal", 0.3}}},
                       {"pulse", {{"vessels", {{{"of", "SECRETVESSEL"}, {"diameter_growth_mm", 1}}}}}}};
  patient["flow"] = {{"waves", {{{"name", "SECRETWAVE"}, {"samples", {1, 1.4, 1, 0.6}}}}},
                     {"streams",
                      {{{"name", "SECRETSTREAM"},
                        {"of", "SECRETVESSEL"},
                        {"flow_ml_per_min", 410},
                        {"wave", "SECRETWAVE"},
                        {"bluntness", 3.7},
                        {"pulse_wave_m_per_s", 6.1},
                        {"stenosis", {{"at_mm", {0, -17, 0}}, {"diameter_lost", 0.6}}}}}}};
  patient["planes"][0]["shows"] = {"SECRETTWINONE"};
  patient.erase("measurements");
  writeText(folder / "patient.json", patient.dump());
  const glm::dmat4 fileToWorld =
      glm::rotate(glm::translate(glm::dmat4(1.0), {11.3, -7.1, 101.7}), 0.61, glm::normalize(glm::dvec3(1.0, 2.0, 3.0)));
  const glm::dmat4 pose = fileToWorld * glm::dmat4({-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, 0}, {0, -60, 0, 1});
  const auto rows = [](const glm::dmat4& m) {
    json list = json::array();
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) list.push_back(m[column][row]);
    return list;
  };
  json manifest = json::parse(textOf(folder / "case.json"));
  manifest["title_for_trainees"] = "A ball";
  manifest["volume"] = {{"recipe", "patient.json"}, {"recipe_spacing_mm", 1.3}, {"file_to_world", rows(fileToWorld)}};
  manifest["start_pose"] = rows(pose);
  manifest["probes"] = {"linear-7.5"};
  manifest["scene"] = toJson(sceneWithEverything());
  manifest["parts"]["lessons"] = lessonOfOnePlane();
  manifest.erase("measurements");
  manifest["targets"] = {{{"kind", "plane"}, {"name", "across"}}};
  writeText(folder / "case.json", manifest.dump());
}

/// The twins and their examination, made once.
class ExaminationOfTwins : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    world_ = new TemporaryFolder;
    cache_ = new EnvironmentValue("ECHOWEAVE_CACHE", (*world_ / "cache").string());
    makeTwins(*world_ / "case");
    key_ = new SecretKey(*SecretKey::make());
    const auto made = makeExamination(*world_ / "case", *world_ / "examination", {.instructors = {key_->publicKey()}});
    ASSERT_TRUE(made) << made.error();
  }
  static void TearDownTestSuite() {
    delete key_;
    delete cache_;
    delete world_;
  }
  [[nodiscard]] static fs::path trained() { return *world_ / "case"; }
  [[nodiscard]] static fs::path examined() { return *world_ / "examination"; }
  [[nodiscard]] static const SecretKey& key() { return *key_; }

  /// A copy of the examination to be damaged.
  [[nodiscard]] fs::path copied() const {
    fs::remove_all(own_ / "e");
    fs::copy(examined(), own_ / "e", fs::copy_options::recursive);
    return own_ / "e";
  }
  [[nodiscard]] static json echoesOf(const fs::path& folder) { return json::parse(textOf(folder / "case.json"))["echoes"]; }
  static void setEchoes(const fs::path& folder, const json& echoes) {
    json manifest = json::parse(textOf(folder / "case.json"));
    manifest["echoes"] = echoes;
    writeText(folder / "case.json", manifest.dump());
  }
  /// That a damaged examination is refused in a sentence, when it is opened or when its volume is read.
  static void expectRefused(const fs::path& folder, const std::string& inSentence) {
    const auto opened = loadCase(folder);
    const std::string sentence = [&] {
      if (!opened) return opened.error().sentence();
      const auto echo = loadCaseVolume(*opened, noProgress());
      return echo ? std::string("it was taken") : echo.error().sentence();
    }();
    EXPECT_NE(sentence.find(inSentence), std::string::npos) << sentence;
    EXPECT_TRUE(sentence.ends_with('.')) << sentence;
  }

 private:
  static inline TemporaryFolder* world_ = nullptr;
  static inline EnvironmentValue* cache_ = nullptr;
  static inline SecretKey* key_ = nullptr;
  TemporaryFolder own_;
};

TEST_F(ExaminationOfTwins, ShowsThePixelsOfTheTrainingCase) {
  EXPECT_EQ(expectSamePatient(subjectIn(trained()), subjectIn(examined())), looks().size()) << "each look is an image of its own";
}

TEST_F(ExaminationOfTwins, HasOneSurfaceOfOrgansAlikeButWhereTheyTouch) {
  const auto own = loadCaseVolume(*loadCase(trained()), noProgress()), theirs = loadCaseVolume(*loadCase(examined()), noProgress());
  ASSERT_TRUE(own && theirs && theirs->tissue);
  const auto withLevel = [](const TissueMaps& maps, double level) {
    return std::count_if(maps.surfaces.begin(), maps.surfaces.end(), [&](const auto& each) { return each.echoLevel == level; });
  };
  EXPECT_EQ(withLevel(*own->tissue, 210.0), 3);
  EXPECT_EQ(withLevel(*theirs->tissue, 210.0), 2) << "the twins touch, the third is one of them";
  EXPECT_EQ(withLevel(*theirs->tissue, 180.0), 1);
  for (const ReflectingSurface& each : theirs->tissue->surfaces) EXPECT_EQ(each.name, "");
}

TEST_F(ExaminationOfTwins, NamesNothingInAnyOfItsFiles) {
  ASSERT_TRUE(exportBundle(examined(), examined().parent_path() / "named.ewcase"));
  const auto files = filesInBundle(examined().parent_path() / "named.ewcase");
  for (const char* name : {"SECRETTWINONE", "SECRETTWINTWO", "SECRETFAR", "SECRETOTHER", "SECRETDARK", "SECRETVESSEL", "SECRETSTREAM",
                           "SECRETWAVE", "SECRETSTONE", "SECRET"}) {
    EXPECT_EQ(placeOf(name, files), "") << name;
  }
  EXPECT_EQ(placeOf("\"name\"", {{"case.json", files.at("case.json")}}), "") << "surfaces have none";
  EXPECT_TRUE(files.contains("echoes/motion.bin"));
  EXPECT_TRUE(files.contains("echoes/flow.json"));
}

TEST_F(ExaminationOfTwins, CarriesItsBloodToTheLastBitWithoutNames) {
  const auto own = loadCaseVolume(*loadCase(trained()), noProgress()), theirs = loadCaseVolume(*loadCase(examined()), noProgress());
  ASSERT_TRUE(own && theirs && own->flow && theirs->flow);
  FlowField unnamed = *own->flow;
  ASSERT_EQ(unnamed.streams.size(), 1U);
  EXPECT_EQ(unnamed.streams.front().name, "SECRETSTREAM");
  const auto narrowed = [](const FlowNode& node) { return node.jet < 1.0 && node.backflow > 0.0 && node.turbulence > 0.0; };
  EXPECT_TRUE(std::any_of(unnamed.streams.front().line.begin(), unnamed.streams.front().line.end(), narrowed));
  EXPECT_FALSE(unnamed.streams.front().wave.harmonics.empty());
  unnamed.streams.front().name.clear();
  EXPECT_EQ(*theirs->flow, unnamed);
  EXPECT_TRUE(subjectIn(examined()).showsColour());
}

TEST(FlowFile, HoldsAnyFlowToTheLastBit) {
  EXPECT_TRUE(rc::check("any flow", [] {
    const auto number = [](double lowest, double highest) {
      return lowest + (highest - lowest) * *rc::gen::inRange(0, 1000003) / 1000003.0;
    };
    FlowField flow;
    flow.density_kgPerM3 = number(900.0, 1200.0);
    flow.viscosity_mPaS = number(1.0, 20.0);
    if (*rc::gen::arbitrary<bool>()) flow.rhythms.pulse = BodyRhythm{number(0.3, 2.0), number(0.0, 0.4)};
    if (*rc::gen::arbitrary<bool>()) flow.rhythms.breathing = BodyRhythms::Breathing{{number(1.0, 9.0), 0.1}, number(0.0, 0.9), 0.3};
    if (*rc::gen::arbitrary<bool>()) flow.rhythms.bowel = BodyRhythm{number(2.0, 60.0), number(0.0, 0.4)};
    for (int streams = *rc::gen::inRange(1, 4); streams > 0; --streams) {
      FlowStream& stream = flow.streams.emplace_back();
      stream.name = *rc::gen::element<std::string>("", "a", "vein \"x\"");
      stream.flow_mm3PerS = number(-9000.0, 9000.0);
      stream.wave.mean = number(-2.0, 2.0);
      for (int n = *rc::gen::inRange(0, 17); n > 0; --n) stream.wave.harmonics.emplace_back(number(-2.0, 2.0), number(-2.0, 2.0));
      stream.bluntness = number(2.0, 50.0);
      stream.pulseWave_mmPerS = *rc::gen::element(0.0, number(500.0, 30000.0));
      stream.delay_s = number(-1.0, 1.0);
      stream.breathShare = number(-1.0, 1.0);
      const bool isNarrowed = *rc::gen::arbitrary<bool>();
      for (int n = *rc::gen::inRange(2, 9); n > 0; --n) {
        FlowNode& node = stream.line.emplace_back();
        node.place_mm = {number(-100.0, 100.0), number(-100.0, 100.0), number(-100.0, 100.0)};
        node.radius_mm = number(0.1, 12.0);
        if (isNarrowed) node.jet = number(0.1, 1.0);
        if (isNarrowed) node.backflow = number(0.0, 1.0);
        if (isNarrowed) node.turbulence = number(0.0, 1.0);
      }
    }
    const json document = json::parse(fileJsonOf(flow).dump());
    JsonReading reading(verbatim("flow.json"));
    const FlowField read = flowIn(JsonFields(document, reading));
    RC_ASSERT(reading.good());
    RC_ASSERT(read == flow);
  }));
}

TEST(FlowFile, LeavesOutStreamsThatPassFarFromTheVolume) {
  const Bounds box{glm::dvec3(-10.0), glm::dvec3(10.0)};
  const auto stream = [](const glm::dvec3& from_mm, const glm::dvec3& to_mm, double radius_mm) {
    return FlowStream{.name = "s", .line = {{.place_mm = from_mm, .radius_mm = radius_mm}, {.place_mm = to_mm, .radius_mm = radius_mm}}};
  };
  FlowField flow;
  flow.streams = {stream({-50, 0, 0}, {50, 0, 0}, 2.0), stream({22.5, 0, 0}, {30, 0, 0}, 2.0), stream({22.5, 0, 0}, {30, 0, 0}, 3.0),
                  stream({0, 60, 0}, {0, 90, 0}, 4.0)};
  const FlowField within = flowWithin(flow, box, 10.0);
  EXPECT_EQ(within.streams, (std::vector<FlowStream>{flow.streams[0], flow.streams[2]})) << "one runs through, one's wall comes near";
}

TEST_F(ExaminationOfTwins, IsWholeAndUsesAllItsFiles) {
  for (const Error& problem : validateCase(examined())) ADD_FAILURE() << problem;
  const auto opened = loadCase(examined());
  ASSERT_TRUE(opened);
  EXPECT_EQ(echoFilesOf(*opened).size(), 4u);
  EXPECT_EQ(unusedFiles(*opened), std::vector<std::string>{});
  EXPECT_EQ(*caseFromManifest(manifestOf(*opened), opened->folder), *opened);
}

TEST_F(ExaminationOfTwins, IsTheSameWhenItIsMadeOfACaseThatHasEchoesAlready) {
  const fs::path folder = copied();
  json manifest = json::parse(textOf(folder / "case.json"));
  manifest.erase("sealed");
  manifest["parts"]["lessons"] = lessonOfOnePlane();
  writeText(folder / "case.json", manifest.dump());
  fs::remove(folder / kSealedName);
  const auto made = makeExamination(folder, folder.parent_path() / "again", {.instructors = {key().publicKey()}});
  ASSERT_TRUE(made) << made.error();
  EXPECT_EQ(echoesOf(folder.parent_path() / "again"), echoesOf(folder));
  EXPECT_EQ(expectSamePatient(subjectIn(trained()), subjectIn(folder.parent_path() / "again")), looks().size());
}

TEST_F(ExaminationOfTwins, IsNotJudgedWhenItsEchoesWereChanged) {
  for (const std::string& name : echoFilesOf(*loadCase(examined()))) {
    const fs::path folder = copied();
    std::string bytes = textOf(folder / name);
    ASSERT_FALSE(bytes.empty());
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    writeText(folder / name, bytes);
    const auto again = openExamination(folder, key(), folder.parent_path() / "again");
    ASSERT_FALSE(again) << name;
    EXPECT_EQ(again.error().code, ErrorCode::badField);
  }
}

TEST_F(ExaminationOfTwins, IsRefusedWithAFileThatIsCutOffOrMissing) {
  for (const std::string& name : echoFilesOf(*loadCase(examined()))) {
    const std::string bytes = textOf(examined() / name);
    ASSERT_FALSE(bytes.empty());
    for (const std::size_t left : {std::size_t{0}, bytes.size() / 2, bytes.size() - 1}) {
      const fs::path folder = copied();
      writeText(folder / name, bytes.substr(0, left));
      expectRefused(folder, "");
    }
    const fs::path folder = copied();
    fs::remove(folder / name);
    expectRefused(folder, "there is no such file");
  }
  const fs::path folder = copied();
  writeText(folder / "echoes/motion.bin", textOf(folder / "echoes/motion.bin") + "more");
  expectRefused(folder, "bytes instead of");
}

TEST_F(ExaminationOfTwins, IsRefusedWithMapsOnAnotherGrid) {
  const auto maps = loadCaseVolume(*loadCase(examined()), noProgress());
  ASSERT_TRUE(maps);
  const json echoes = echoesOf(examined());
  Volume smaller{maps->volume.grid, {}, {}}, wider{maps->volume.grid, maps->tissue->surfaceKind, {}};
  smaller.grid.dims -= 1;
  smaller.echo.resize(smaller.grid.voxelCount());
  wider.grid.spacing_mm *= 1.01;
  for (const Volume& other : {smaller, wider})
    for (const std::string& name : {echoes["distance"].get<std::string>(), echoes["kind"].get<std::string>(),
                                    json::parse(textOf(examined() / "case.json"))["volume"]["level"].get<std::string>()}) {
      const fs::path folder = copied();
      ASSERT_TRUE(writeVolume(other, folder / name));
      expectRefused(folder, "another grid than the volume");
    }
  // Of tissue without surfaces the level alone could lie elsewhere.
  const fs::path folder = copied();
  json without = echoes;
  for (const char* each : {"surfaces", "distance", "kind"}) without.erase(each);
  setEchoes(folder, without);
  const auto good = loadCaseVolume(*loadCase(folder), noProgress());
  ASSERT_TRUE(good) << good.error();
  EXPECT_TRUE(good->tissue && good->tissue->surfaces.empty() && !good->tissue->isRecorded);
  ASSERT_TRUE(writeVolume(wider, folder / loadCase(folder)->volume.level));
  expectRefused(folder, "another grid than the volume");
}

TEST_F(ExaminationOfTwins, IsRefusedWithASurfaceThatIsNotThere) {
  const fs::path folder = copied();
  json echoes = echoesOf(folder);
  const std::size_t last = echoes["surfaces"].size() - 1;
  echoes["surfaces"].erase(last);
  setEchoes(folder, echoes);
  expectRefused(folder, "names the surface " + std::to_string(last + 1) + " of " + std::to_string(last));
}

TEST_F(ExaminationOfTwins, IsRefusedWithShiftsThatAreNone) {
  constexpr auto kNaN = std::numeric_limits<float>::quiet_NaN(), kInfinite = std::numeric_limits<float>::infinity();
  for (const float wrong : {kNaN, kInfinite, -kInfinite, 1e30F, -301.0F}) {
    const fs::path folder = copied();
    std::string bytes = textOf(folder / "echoes/motion.bin");
    ASSERT_GE(bytes.size(), sizeof(float));
    std::memcpy(bytes.data() + bytes.size() - sizeof(float), &wrong, sizeof(float));
    writeText(folder / "echoes/motion.bin", bytes);
    expectRefused(folder, "no number or by more than 300 mm");
  }
}

TEST_F(ExaminationOfTwins, IsRefusedWithNumbersBeyondTheirRange) {
  struct Wrong {
    const char* place;
    json value;
    const char* named;
  };
  const json huge = {4096, 4096, 4096};
  for (const Wrong& wrong :
       {Wrong{"/surfaces/0/sheets", 9, "sheets"}, Wrong{"/surfaces/0/fall_deg", 0, "fall_deg"},
        Wrong{"/surfaces/0/echo_level", "bright", "echo_level"}, Wrong{"/surfaces/0/echo_level", nullptr, "echo_level"},
        Wrong{"/surfaces", 3, "surfaces"}, Wrong{"/motion/fields/0/dims", huge, "fields[0].dims"},
        Wrong{"/motion/fields/0/dims", {1, 2, 2}, "dims"}, Wrong{"/motion/fields/0/dims", {2, 2}, "dims"},
        Wrong{"/motion/fields/0/spacing_mm", {0, 1, 1}, "spacing_mm"}, Wrong{"/motion/fields/0/kind", "sneeze", "kind"},
        Wrong{"/motion/pulse/period_s", 0, "period_s"}, Wrong{"/motion/breathing/rhythm/variation", 2, "variation"},
        Wrong{"/motion/file", "../case/case.json", "echoes.motion.file"}, Wrong{"/kind", "/etc/hostname", "echoes.kind"},
        Wrong{"/distance", "answers.sealed", ""}}) {
    const fs::path folder = copied();
    json echoes = echoesOf(folder);
    echoes[json::json_pointer(wrong.place)] = wrong.value;
    setEchoes(folder, echoes);
    SCOPED_TRACE(wrong.place);
    expectRefused(folder, wrong.named);
  }
  for (const char* half : {"kind", "distance"}) {
    const fs::path folder = copied();
    json echoes = echoesOf(folder);
    echoes.erase(half);
    setEchoes(folder, echoes);
    expectRefused(folder, "echoes." + std::string(half));
  }
  const fs::path folder = copied();
  json manifest = json::parse(textOf(folder / "case.json"));
  manifest["volume"].erase("level");
  writeText(folder / "case.json", manifest.dump());
  expectRefused(folder, "'echoes' in case.json");
}

TEST_F(ExaminationOfTwins, IsRefusedWithAFlowThatIsNone) {
  struct Wrong {
    const char* place;
    json value;
    const char* named;
  };
  const json endless(250000, 1.0);
  for (const Wrong& wrong : {Wrong{"/streams/0/radii_mm/1", 0, "radii_mm"},
                             Wrong{"/streams/0/radii_mm/1", -3, "radii_mm"},
                             Wrong{"/streams/0/radii_mm/1", nullptr, "radii_mm"},
                             Wrong{"/streams/0/radii_mm", {4}, "radii_mm"},
                             Wrong{"/streams/0/radii_mm", endless, "radii_mm"},
                             Wrong{"/streams/0/places_mm", {0, 0, 0, 0, 0}, "places_mm"},
                             Wrong{"/streams/0/places_mm/3", 1e9, "places_mm"},
                             Wrong{"/streams/0/jets", {1, 1}, "jets"},
                             Wrong{"/streams/0/jets/0", 0, "jets"},
                             Wrong{"/streams/0/backflows/0", 2, "backflows"},
                             Wrong{"/streams/0/turbulences/0", -1, "turbulences"},
                             Wrong{"/streams/0/bluntness", 0, "bluntness"},
                             Wrong{"/streams/0/flow_mm3_per_s", "much", "flow_mm3_per_s"},
                             Wrong{"/streams/0/mean", 1e300, "mean"},
                             Wrong{"/streams/0/harmonics", {1, 2, 3}, "harmonics"},
                             Wrong{"/streams/0/harmonics", json(500, 0.1), "harmonics"},
                             Wrong{"/streams/0/delay_s", nullptr, "delay_s"},
                             Wrong{"/streams/0/breath", 7, "breath"},
                             Wrong{"/streams/0/other", 1, "other"},
                             Wrong{"/streams", json::array(), "streams"},
                             Wrong{"/streams", json(3000, json::object()), "streams"},
                             Wrong{"/streams", 4, "streams"},
                             Wrong{"/rhythms/pulse/period_s", 0, "rhythms.pulse.period_s"},
                             Wrong{"/rhythms", 1, "rhythms"},
                             Wrong{"/density_kg_per_m3", 1, "density_kg_per_m3"},
                             Wrong{"/viscosity_mpa_s", 0, "viscosity_mpa_s"}}) {
    const fs::path folder = copied();
    json flow = json::parse(textOf(folder / "echoes/flow.json"));
    flow[json::json_pointer(wrong.place)] = wrong.value;
    writeText(folder / "echoes/flow.json", flow.dump());
    SCOPED_TRACE(wrong.place);
    expectRefused(folder, wrong.named);
    expectRefused(folder, "echoes/flow.json");
  }
  // So wide and so many that looking them up would take the memory of the machine.
  const fs::path folder = copied();
  json flow = json::parse(textOf(folder / "echoes/flow.json"));
  json& stream = flow["streams"][0];
  for (const char* each : {"jets", "backflows", "turbulences"}) stream.erase(each);
  stream["radii_mm"] = json(10000, 900.0);
  stream["places_mm"] = json::array();
  for (int n = 0; n < 10000; ++n) stream["places_mm"].insert(stream["places_mm"].end(), {0.01 * n, 0.0, 0.0});
  writeText(folder / "echoes/flow.json", flow.dump());
  expectRefused(folder, "too wide to be looked up");
  json echoes = echoesOf(folder);
  echoes["flow"]["file"] = "../case/case.json";
  setEchoes(folder, echoes);
  expectRefused(folder, "echoes.flow.file");
}

TEST_F(ExaminationOfTwins, SurvivesAnyBytes) {
  std::mt19937 random(5);
  const auto drawn = [&](std::size_t below) { return std::uniform_int_distribution<std::size_t>(0, below - 1)(random); };
  std::vector<std::string> names = echoFilesOf(*loadCase(examined()));
  names.push_back("case.json");
  Scanner scanner;
  std::size_t refused = 0, shown = 0;
  for (int n = 0; n < 120; ++n) {
    const fs::path folder = copied();
    const std::string& name = names[drawn(names.size())];
    std::string bytes = textOf(folder / name);
    // Of the manifest "echoes" alone.
    const std::size_t first = name == "case.json" ? bytes.find("\"echoes\"") : 0;
    const std::size_t end = name == "case.json" ? bytes.find("\"parts\"") : bytes.size();
    ASSERT_LT(first, end);
    for (std::size_t flips = 1 + drawn(4); flips > 0; --flips)
      bytes[first + drawn(end - first)] =
          static_cast<char>(name == "case.json" ? ' ' + static_cast<int>(drawn(95)) : static_cast<int>(drawn(256)));
    writeText(folder / name, bytes);
    const auto opened = loadCase(folder);
    const auto contents = opened ? readContents(*opened, noProgress()) : Result<CaseContents>(passOn(opened.error()));
    if (!contents) {
      EXPECT_FALSE(contents.error().sentence().empty());
      ++refused;
      continue;
    }
    scanner.show(subjectOf(*opened, *contents));
    ScanState state = startOf(*scanner.subject());
    state.body = {1.0, 1.0, 0.3};
    EXPECT_FALSE(scanner.make(state, 120, 100).isEmpty());
    ++shown;
  }
  EXPECT_GT(refused, 30u);
  EXPECT_GT(shown, 5u);
}

// ---- the shipped cases ----

class ShippedPixels : public ::testing::TestWithParam<std::string> {};

TEST_P(ShippedPixels, AreThoseOfItsExamination) {
  const TemporaryFolder folder;
  const EnvironmentValue cache("ECHOWEAVE_CACHE", (folder / "cache").string());
  copyCoarse(*shippedCasesFolder() / GetParam(), folder / "case", 2.5);
  const auto made = makeExamination(folder / "case", folder / "e", {.instructors = {SecretKey::make()->publicKey()}});
  ASSERT_TRUE(made) << made.error();
  const ScanSubject own = subjectIn(folder / "case"), theirs = subjectIn(folder / "e");
  // Not everybody breathes (the neck), and a recording has neither surfaces nor motion.
  constexpr std::size_t kResting = 7;
  EXPECT_GT(own.motion ? expectSamePatient(own, theirs) : expectSamePixels(own, theirs), looks().size() - kResting);
}

INSTANTIATE_TEST_SUITE_P(Cases, ShippedPixels, ::testing::ValuesIn(shippedIds()), nameOfCase);

TEST(RecordedExamination, ShowsThePixelsOfTheTrainingCase) {
  const TemporaryFolder folder;
  const EnvironmentValue cache("ECHOWEAVE_CACHE", (folder / "cache").string());
  makeAnsweredCase(folder / "case");
  // Two tissues that reflect alike and touch are one label in the examination.
  json manifest = json::parse(textOf(folder / "case/case.json"));
  for (json& tissue : manifest["scene"]["tissues"]) tissue["reflection_db"] = 12.0;
  manifest["scene"].update(toJson(sceneWithEverything()));
  manifest["scene"].erase("live_echoes");
  manifest["start_pose"] = {1, 0, 0, 9, 0, 1, 0, 0, 0, 0, 1, 8, 0, 0, 0, 1};
  manifest["volume"]["file_to_world"] = {0.6, 0.8, 0, 3.1, -0.8, 0.6, 0, 12.7, 0, 0, 1, 0.3, 0, 0, 0, 1};
  writeText(folder / "case/case.json", manifest.dump());
  const auto made = makeExamination(folder / "case", folder / "e", {.instructors = {SecretKey::make()->publicKey()}});
  ASSERT_TRUE(made) << made.error();
  const ScanSubject own = subjectIn(folder / "case"), theirs = subjectIn(folder / "e");
  EXPECT_EQ(theirs.placedGrid, own.placedGrid);
  EXPECT_GT(expectSamePixels(own, theirs), 5u);
}

// ---- the scene and the surfaces by themselves ----

TEST(TraineeScene, HasEveryEffectThatFormsAnImage) {
  Scene scene = sceneWithEverything();
  scene.gainAndDgc = false;
  scene.recordedDynamicRange_db = 71.0;
  scene.motion->strength = 0.4;
  scene.reverberation->mirrorLoss_db = 3.0;
  EXPECT_EQ(plainTissues(scene).scene, scene);
}

ReflectingSurface surfaceOf(std::string name, double level) {
  ReflectingSurface surface;
  surface.name = std::move(name);
  surface.echoLevel = level;
  return surface;
}

/// What echo_surfaces.cpp asks for at a voxel of a cell between eight: which surface, and whether six of the eight know it.
std::pair<double, int> askedAt(const TissueMaps& maps, const glm::ivec3& low, int corner) {
  const auto kindAt = [&](int n) { return maps.surfaceKind[maps.grid.indexOf(low.x + (n & 1), low.y + ((n >> 1) & 1), low.z + (n >> 2))]; };
  const int kind = kindAt(corner);
  int same = 0;
  for (int n = 0; n < 8; ++n) same += kindAt(n) == kind ? 1 : 0;
  return {kind == 0 ? 0.0 : maps.surfaces[static_cast<std::size_t>(kind) - 1].echoLevel, kind == 0 ? 0 : same};
}

TEST(PlainSurfaces, AreAskedForTheSameAndSayNothingOfTheOrderOfOrgans) {
  EXPECT_TRUE(rc::check("any map", [] {
    constexpr int kSide = 5, kSurfaces = 6;
    TissueMaps maps;
    maps.grid.dims = glm::ivec3(kSide);
    for (int n = 0; n < kSurfaces; ++n) maps.surfaces.push_back(surfaceOf("organ " + std::to_string(n), 100.0 + *rc::gen::inRange(0, 3)));
    const int kinds = *rc::gen::inRange(1, kSurfaces + 2);
    for (std::size_t n = 0; n < maps.grid.voxelCount(); ++n)
      maps.surfaceKind.push_back(static_cast<std::uint8_t>(*rc::gen::inRange(0, kinds)));
    maps.level = maps.surfaceDistance = maps.surfaceKind;
    const TissueMaps plain = plainSurfaces(maps);
    RC_ASSERT(plain.surfaces.size() <= maps.surfaces.size());
    RC_ASSERT(plain.level == maps.level && plain.surfaceDistance == maps.surfaceDistance);
    for (const ReflectingSurface& each : plain.surfaces) RC_ASSERT(each.name.empty());
    for (int k = 0; k + 1 < kSide; ++k)
      for (int j = 0; j + 1 < kSide; ++j)
        for (int i = 0; i + 1 < kSide; ++i)
          for (int corner = 0; corner < 8; ++corner) RC_ASSERT(askedAt(plain, {i, j, k}, corner) == askedAt(maps, {i, j, k}, corner));
    // The same patient whose organs are listed the other way round.
    TissueMaps reversed = maps;
    std::reverse(reversed.surfaces.begin(), reversed.surfaces.end());
    for (std::uint8_t& kind : reversed.surfaceKind)
      if (kind != 0) kind = static_cast<std::uint8_t>(kSurfaces + 1 - kind);
    RC_ASSERT(plainSurfaces(reversed) == plain);
  }));
}

TEST(PlainSurfaces, AlikeAndApartAreOne) {
  TissueMaps maps;
  maps.grid.dims = {9, 2, 2};
  maps.surfaces = {surfaceOf("unseen", 9.0), surfaceOf("a", 200.0), surfaceOf("b", 100.0), surfaceOf("c", 200.0)};
  for (int row = 0; row < 4; ++row)
    for (const std::uint8_t kind : {2, 2, 0, 0, 3, 3, 0, 4, 4}) maps.surfaceKind.push_back(kind);
  const TissueMaps plain = plainSurfaces(maps);
  ASSERT_EQ(plain.surfaces.size(), 2u);
  EXPECT_EQ(plain.surfaces[0], surfaceOf("", 100.0)) << "in the order of their properties";
  EXPECT_EQ(plain.surfaces[1], surfaceOf("", 200.0));
  EXPECT_EQ(std::vector<std::uint8_t>(plain.surfaceKind.begin(), plain.surfaceKind.begin() + 9),
            (std::vector<std::uint8_t>{2, 2, 0, 0, 1, 1, 0, 2, 2}));
}

}  // namespace
}  // namespace ew::test::examination_pixels_test
