#include <gtest/gtest.h>

#include <algorithm>

#include "cli/cli_world.h"
#include "ew/io/image_file.h"
#include "ew/library/case.h"
#include "library/small_case.h"

namespace ew::test::case_test {
namespace {

/// A case folder with a small volume.
void makeCase(const TemporaryFolder& folder, const std::string& name, const std::string& title) {
  std::filesystem::create_directories(folder.path() / name / "volumes");
  ASSERT_TRUE(writeVolume(rampVolume({6, 5, 4}), folder / (name + "/volumes/v.mha")));
  const nlohmann::json manifest = {
      {"format", 1},
      {"id", name},
      {"title", title},
      {"region", "knee"},
      {"patient", {{"name", "A. Nobody"}, {"sex", "female"}, {"age_years", 40}}},
      {"history", "None."},
      {"indication", "Pain."},
      {"diagnosis", "Effusion."},
      {"volume", {{"file", "volumes/v.mha"}, {"file_to_world", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}}};
  writeText(folder / (name + "/case.json"), manifest.dump(2));
}

TEST(CaseCommand, ListsTheCasesOfAFolderByTitleAndNamesWhatCannotBeRead) {
  const TemporaryFolder folder;
  makeCase(folder, "b", "Ankle");
  makeCase(folder, "a", "Knee");
  std::filesystem::create_directory(folder / "c");
  writeText(folder / "c/case.json", "{");
  std::filesystem::create_directory(folder / "d");
  const auto listed = run({"case", "list", folder.path().string()});
  ASSERT_EQ(listed.status, 0) << listed.err;
  EXPECT_LT(listed.out.find("Ankle"), listed.out.find("Knee")) << listed.out;
  EXPECT_NE(listed.err.find("note: The case in the folder 'c' is left out: "), std::string::npos) << listed.err;
  EXPECT_NE(listed.err.find("note: The folder 'd' is left out: it holds no case.json."), std::string::npos) << listed.err;
  const auto asJson = run({"case", "list", folder.path().string(), "--json"});
  const auto json = nlohmann::json::parse(asJson.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << asJson.out;
  EXPECT_EQ(json["cases"].size(), 2u);
  EXPECT_EQ(json["problems"].size(), 1u);
  EXPECT_EQ(json["no_cases"].size(), 1u);
}

TEST(CaseCommand, ShowsTheShippedCaseByItsId) {
  const auto listed = run({"case", "list", "--json"});
  ASSERT_EQ(listed.status, 0) << listed.err;
  const auto json = nlohmann::json::parse(listed.out, nullptr, false);
  ASSERT_FALSE(json["cases"].empty());
  const std::string id = json["cases"][0]["id"], title = json["cases"][0]["title"];
  const auto shown = run({"case", "show", id});
  ASSERT_EQ(shown.status, 0) << shown.err;
  EXPECT_NE(shown.out.find(title), std::string::npos) << shown.out;
  EXPECT_EQ(nlohmann::json::parse(run({"case", "show", id, "--json"}).out)["title"], title);
  EXPECT_EQ(run({"case", "validate", id}).status, 0);
}

TEST(CaseCommand, ShowsTolerancesWithTheUnitThatOnlyThePatientKnows) {
  const auto shown = run({"case", "show", "upper-abdomen-gall-stone"});
  ASSERT_EQ(shown.status, 0) << shown.err;
  for (const char* part : {"gall stone, width, tolerance 2 mm", "gall bladder, width, tolerance 4 mm"})
    EXPECT_NE(shown.out.find(part), std::string::npos) << part << "\n" << shown.out;
}

TEST(CaseCommand, ShowsEveryFieldAndItsManifestAsJson) {
  const TemporaryFolder folder;
  makeCase(folder, "a", "Knee");
  const auto shown = run({"case", "show", folder / "a"});
  ASSERT_EQ(shown.status, 0) << shown.err;
  for (const char* part : {"Knee", "A. Nobody", "female", "40 years", "Pain.", "Effusion.", "volumes/v.mha"})
    EXPECT_NE(shown.out.find(part), std::string::npos) << part << "\n" << shown.out;
  const auto manifest = nlohmann::json::parse(run({"case", "show", folder / "a/case.json", "--json"}).out, nullptr, false);
  EXPECT_EQ(manifest["id"], "a");
}

TEST(CaseCommand, ShowsWhatIsExpectedAndEveryEffectThatIsOn) {
  const TemporaryFolder folder;
  makeCase(folder, "a", "Knee");
  auto manifest = readJson(folder / "a/case.json");
  manifest["scene"] = {{"attenuation", nlohmann::json::object()}, {"noise", nlohmann::json::object()}};
  manifest["findings"] = {"Fluid beside the patella."};
  manifest["previous_examinations"] = {{{"when", "a year ago"}, {"kind", "ultrasound"}, {"findings", "dry"}}};
  manifest["targets"] = {{{"kind", "point"}, {"name", "the recess"}, {"at_mm", {1, 2, 3}}, {"tolerance_mm", 5}}};
  writeText(folder / "a/case.json", manifest.dump());
  const auto shown = run({"case", "show", folder / "a"});
  ASSERT_EQ(shown.status, 0) << shown.err;
  for (const char* part : {"shadow and enhancement", "noise", "Fluid beside", "a year ago, ultrasound: dry", "the recess (point)"})
    EXPECT_NE(shown.out.find(part), std::string::npos) << part << "\n" << shown.out;
  EXPECT_EQ(shown.out.find("focus"), std::string::npos) << shown.out;
}

TEST(CaseCommand, ValidatePrintsEveryProblemAndFails) {
  const TemporaryFolder folder;
  makeCase(folder, "a", "Knee");
  EXPECT_EQ(run({"case", "validate", folder / "a"}).status, 0);
  auto manifest = readJson(folder / "a/case.json");
  manifest["title"] = 3;
  manifest["volume"]["file_to_world"][0] = 2;
  manifest["probes"] = "all";
  writeText(folder / "a/case.json", manifest.dump());
  const auto checked = run({"case", "validate", folder / "a", "--json"});
  EXPECT_EQ(checked.status, 1);
  const auto json = nlohmann::json::parse(checked.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << checked.out;
  EXPECT_EQ(json["valid"], false);
  EXPECT_GE(json["problems"].size(), 2u) << checked.out;
  const auto words = run({"case", "validate", folder / "a"});
  EXPECT_EQ(words.status, 1);
  EXPECT_NE(words.out.find("title"), std::string::npos) << words.out;
  EXPECT_NE(words.out.find("probes"), std::string::npos) << words.out;
}

TEST(CaseCommand, AnUnknownCaseNamesTheShippedOnes) {
  const auto outcome = run({"case", "show", "no-such-case"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("shipped case"), std::string::npos) << outcome.err;
}

TEST(CaseCommand, PrepareMakesAVolumeOnceAndThenHasNothingToDo) {
  const TemporaryFolder folder;
  const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "cache");
  const auto shipped = shippedCasesFolder();
  ASSERT_TRUE(shipped);
  std::string recipe;
  std::filesystem::path home;
  for (const auto& each : listCases(*shipped).cases)
    if (!each.volume.recipe.empty()) {
      recipe = each.volume.recipe;
      home = each.folder;
    }
  ASSERT_FALSE(recipe.empty());
  std::filesystem::copy(home, folder.path() / "coarse", std::filesystem::copy_options::recursive);
  auto manifest = readJson(folder / "coarse/case.json");
  manifest["volume"]["recipe_spacing_mm"] = 6;
  manifest["volume"].erase("sweeps");
  manifest["volume"].erase("reconstruct");
  writeText(folder / "coarse/case.json", manifest.dump());

  const auto first = run({"case", "prepare", folder / "coarse", "--report", folder / "1.json"});
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_EQ(readJson(folder / "1.json")["quality"]["prepared_now"], 1);
  EXPECT_NE(first.err.find(" %  "), std::string::npos) << "progress in plain lines\n" << first.err;
  const auto second = run({"case", "prepare", folder / "coarse", "--report", folder / "2.json"});
  ASSERT_EQ(second.status, 0) << second.err;
  EXPECT_EQ(readJson(folder / "2.json")["quality"]["prepared_now"], 0);
  EXPECT_EQ(second.err, "");
}

/// Pixels of a case as `scan` begins with it and as its card has it, which stands above the words that every image carries.
TEST(CaseCommand, TheCardIsWhatTheCaseBeginsWithAboveTheWords) {
  const TemporaryFolder folder;
  const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "cache");
  const std::string home = folder / "drawn";
  makeSmallCase(home);
  writeText(home + "/case.json", nlohmann::json({{"format", 1},
                                                 {"id", "drawn"},
                                                 {"title", "Drawn"},
                                                 {"volume", {{"recipe", "patient.json"}, {"recipe_spacing_mm", 3.0}}},
                                                 {"probes", {"microconvex-6", "linear-7.5"}},
                                                 {"presets", {"superficial-linear-7.5"}},
                                                 {"start_pose", {1, 0, 0, 0, 0, 1, 0, -60, 0, 0, 1, 0, 0, 0, 0, 1}}})
                                     .dump());
  const auto made = run({"case", "card", home});
  ASSERT_EQ(made.status, 0) << made.err;
  const auto card = readImage(home + "/card.png");
  ASSERT_TRUE(card);
  ASSERT_EQ(card->width, 544);
  ASSERT_EQ(card->height, 350);
  ASSERT_EQ(run({"scan", home, "--size", "544x320", "-o", folder / "scan.mha"}).status, 0);
  const auto scanned = readImage(folder / "scan.mha");
  ASSERT_TRUE(scanned);
  ASSERT_EQ(scanned->height, 320);
  EXPECT_TRUE(std::equal(scanned->pixels.begin(), scanned->pixels.end(), card->pixels.begin()));
  EXPECT_TRUE(std::any_of(scanned->pixels.begin(), scanned->pixels.end(), [](std::uint8_t level) { return level > 0; }));
  EXPECT_TRUE(std::any_of(card->pixels.begin() + std::ptrdiff_t{544} * 320, card->pixels.end(), [](std::uint8_t level) {
    return level > 0;
  })) << "without its words";

  const auto elsewhere = run({"case", "card", home, "-o", folder / "other.png"});
  ASSERT_EQ(elsewhere.status, 0) << elsewhere.err;
  EXPECT_EQ(readText(folder / "other.png"), readText(home + "/card.png"));
  EXPECT_EQ(run({"case", "card", home, "-o", home + "/case.json"}).status, 2);
}

}  // namespace
}  // namespace ew::test::case_test
