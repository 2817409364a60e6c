#include <gtest/gtest.h>

#include "../even_sweep.h"
#include "cli/cli_world.h"
#include "ew/io/sequence.h"
#include "ew/io/volume_file.h"

namespace ew::test::case_new_test {
namespace {

namespace fs = std::filesystem;

void makeSweep(const std::string& file) {
  const Sequence sweep = evenSweep({.width = 30, .height = 20, .frames = 25, .from = "Image"}, [](int n, int) { return 20 + 8 * n; });
  ASSERT_TRUE(writeSequence(sweep, file));
}

TEST(CaseNew, MakesACaseOfASweepAndSaysHowItLies) {
  const TemporaryFolder folder;
  makeSweep(folder / "s.igs.mha");
  const auto made =
      run({"case", "new", folder / "s.igs.mha", "-o", folder / "cases/liver", "--title", "Liver", "--trainee-title", "Abdomen", "--region",
           "right upper quadrant", "--spacing", "1", "--attribution", "Nobody", "--licence", "CC0", "--report", folder / "r.json"});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_NE(made.out.find("Used 25 of 25 frames"), std::string::npos) << made.out;
  EXPECT_NE(made.err.find("MiB of memory"), std::string::npos) << "said before it is made: " << made.err;
  const auto report = readJson(folder / "r.json");
  EXPECT_GT(report["quality"]["contact_share"].get<double>(), 0.5);
  EXPECT_EQ(report["quality"]["frames_used"], 25);
  EXPECT_EQ(report["outputs"][0], folder / "cases/liver");
  EXPECT_EQ(report["case"]["id"], "liver");
  const auto manifest = readJson(folder / "cases/liver/case.json");
  EXPECT_EQ(manifest["title_for_trainees"], "Abdomen");
  EXPECT_EQ(manifest["volume"]["licence"], "CC0");
  EXPECT_TRUE(manifest["volume"].contains("level"));
  EXPECT_EQ(run({"case", "validate", folder / "cases/liver"}).status, 0);
  EXPECT_EQ(run({"case", "verify", folder / "cases/liver"}).status, 0);
  const auto again = run({"case", "new", folder / "s.igs.mha", "-o", folder / "cases/liver"});
  EXPECT_EQ(again.status, 1);
  EXPECT_NE(again.err.find("there already"), std::string::npos) << again.err;
  EXPECT_EQ(readJson(folder / "cases/liver/case.json"), manifest);
}

TEST(CaseNew, SaysWhenItKnowsNoPlaceForARegionAndForecastsTheLevelOnlyWhenItIsMade) {
  const TemporaryFolder folder;
  makeSweep(folder / "s.igs.mha");
  const auto makes = [&](const std::string& to, const std::vector<std::string>& more) {
    std::vector<std::string> words = {"case", "new",      folder / "s.igs.mha", "-o", folder / to, "--spacing",
                                      "1",    "--report", folder / "r.json"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  };
  const auto unknown = makes("a", {"--region", "left big toe", "--no-level"});
  ASSERT_EQ(unknown.status, 0) << unknown.err;
  EXPECT_NE(unknown.err.find("There is no usual place for 'left big toe'"), std::string::npos) << unknown.err;
  EXPECT_NE(unknown.err.find("upper abdomen"), std::string::npos) << unknown.err;
  const auto known = makes("b", {"--region", "Right upper quadrant, in deep breath"});
  ASSERT_EQ(known.status, 0) << known.err;
  EXPECT_EQ(known.err.find("no usual place"), std::string::npos) << known.err;
  Volume spaced = rampVolume({60, 50, 40});
  spaced.grid.spacing_mm = glm::dvec3(0.5);
  ASSERT_TRUE(writeVolume(spaced, folder / "v.mha"));
  std::vector<double> forecast_mib;
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--no-level"}, std::vector<std::string>{}}) {
    std::vector<std::string> words = {
        "case", "new", folder / "v.mha", "-o", folder / ("v" + std::to_string(more.size())), "--report", folder / "r.json"};
    words.insert(words.end(), more.begin(), more.end());
    const auto made = run(words);
    ASSERT_EQ(made.status, 0) << made.err;
    forecast_mib.push_back(readJson(folder / "r.json")["quality"]["forecast_mib"]);
  }
  EXPECT_NEAR(forecast_mib[0], 2.0 * 60 * 50 * 40 / 1048576.0, 1e-3) << "echoes and coverage";
  EXPECT_GT(forecast_mib[1], 1.5 * forecast_mib[0]);
}

TEST(CaseNew, TakesAStepOfAFileOfVolumesAndOneLengthOrThreeForItsVoxels) {
  const TemporaryFolder folder;
  writeText(folder / "beats.nrrd",
            "NRRD0005\ntype: uint8\ndimension: 4\nsizes: 24 20 10 2\nkinds: space space space time\nencoding: raw\n\n" +
                std::string(24 * 20 * 10, 'a') + std::string(24 * 20 * 10, 'b'));
  const auto makes = [&](const std::string& to, const std::vector<std::string>& more) {
    std::vector<std::string> words = {"case", "new", folder / "beats.nrrd", "-o", folder / to, "--no-level"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  };
  const auto unasked = makes("a", {});
  EXPECT_EQ(unasked.status, 1);
  EXPECT_NE(unasked.err.find("--time-step N"), std::string::npos) << unasked.err;
  const auto unspaced = makes("a", {"--time-step", "2"});
  EXPECT_EQ(unspaced.status, 1);
  EXPECT_NE(unspaced.err.find("--spacing X[,Y,Z]"), std::string::npos) << unspaced.err;
  for (const char* wrong : {"1,2", "0", "a", "1,1,-1"}) {
    const auto refused = makes("a", {"--time-step", "2", "--spacing", wrong});
    EXPECT_EQ(refused.status, 2) << wrong;
    EXPECT_NE(refused.err.find("one length or 3"), std::string::npos) << refused.err;
  }
  ASSERT_EQ(makes("a", {"--time-step", "2", "--spacing", "1,1,2.5"}).status, 0);
  const auto volume =
      readVolume(std::filesystem::path(folder / "a") / readJson(folder / "a/case.json")["volume"]["file"].get<std::string>());
  ASSERT_TRUE(volume) << volume.error();
  EXPECT_EQ(volume->volume.grid.spacing_mm, glm::dvec3(1.0, 1.0, 2.5));
  EXPECT_EQ(volume->volume.echo.front(), 'b');
  makeSweep(folder / "s.igs.mha");
  const auto uneven = run({"case", "new", folder / "s.igs.mha", "-o", folder / "b", "--spacing", "1,1,2"});
  EXPECT_EQ(uneven.status, 2);
  EXPECT_NE(uneven.err.find("one --spacing along all axes"), std::string::npos) << uneven.err;
}

TEST(CaseNew, NamesNoOptionsOfOtherCommands) {
  const TemporaryFolder folder;
  Sequence images = parallelSweep(8, 6, 5);
  const auto refusalOf = [&] {
    if (!writeSequence(images, folder / "s.igs.mha")) ADD_FAILURE();
    const auto refused = run({"case", "new", folder / "s.igs.mha", "-o", folder / "a"});
    EXPECT_EQ(refused.status, 1);
    for (const char* foreign : {"--motor", "--poses", "--image-to"}) EXPECT_EQ(refused.err.find(foreign), std::string::npos) << refused.err;
    return refused.err;
  };
  for (SequenceFrame& frame : images.frames)
    for (FrameTransform& one : frame.transforms) one.to = "Stylus";
  EXPECT_NE(refusalOf().find(": --calibration XML, or make its volume first (echoweave reconstruct), then the case of that."),
            std::string::npos);
  for (SequenceFrame& frame : images.frames) frame.transforms.clear();
  EXPECT_NE(refusalOf().find("say how a motor moved the probe: make its volume first (echoweave reconstruct), then the case of that."),
            std::string::npos);
}

TEST(CaseNew, PutsItWhereItIsTold) {
  const TemporaryFolder folder;
  makeSweep(folder / "s.igs.mha");
  ASSERT_EQ(
      run({"case", "new", folder / "s.igs.mha", "-o", folder / "a", "--place", "10", "-90", "5", "0", "0", "90", "--no-level"}).status, 0);
  const auto placed = readJson(folder / "a/case.json")["volume"];
  EXPECT_FALSE(placed.contains("level"));
  const std::vector<double> expected = {0, -1, 0, 10, 1, 0, 0, -90, 0, 0, 1, 5, 0, 0, 0, 1};
  for (std::size_t n = 0; n < 16; ++n) EXPECT_NEAR(placed["file_to_world"][n].get<double>(), expected[n], 1e-9) << n;

  // 20 mm to the left, by three places; one of them a landmark of the mannequin.
  writeText(folder / "pairs.json", R"({"format": 1, "pairs": [
    {"landmark": "xiphoid", "file_mm": [20, -106, 4]},
    {"name": "b", "file_mm": [120, 0, 0], "world_mm": [100, 0, 0]},
    {"name": "c", "file_mm": [20, 0, 80], "world_mm": [0, 0, 80]}]})");
  const auto fitted =
      run({"case", "new", folder / "s.igs.mha", "-o", folder / "b", "--landmarks", folder / "pairs.json", "--report", folder / "r.json"});
  ASSERT_EQ(fitted.status, 0) << fitted.err;
  EXPECT_NEAR(readJson(folder / "b/case.json")["volume"]["file_to_world"][3].get<double>(), -20.0, 0.6);
  EXPECT_LT(readJson(folder / "r.json")["quality"]["landmarks_rms_mm"].get<double>(), 1.5);
  EXPECT_EQ(run({"case", "new", folder / "s.igs.mha", "-o", folder / "c", "--landmarks", folder / "pairs.json", "--place", "0", "0", "0",
                 "0", "0", "0"})
                .status,
            2);
}

TEST(CaseNew, OfNothingOrATemplateWaitsForItsVolumeAndIsNotPublished) {
  const TemporaryFolder folder;
  const auto made = run({"case", "new", "-o", folder / "later", "--template", "thyroid-and-neck"});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_NE(made.out.find("no volume yet"), std::string::npos) << made.out;
  EXPECT_NE(made.err.find("Making the case needs less than 1 MiB of memory and less than 1 MiB on disk."), std::string::npos) << made.err;
  EXPECT_EQ(readJson(folder / "later/case.json")["mannequin"], "neck-extended.json");
  EXPECT_EQ(run({"case", "validate", folder / "later"}).status, 0);
  const auto published = run({"case", "publish", folder / "later", "--library", folder / "library"});
  EXPECT_EQ(published.status, 1);
  EXPECT_NE(published.out.find("missing: Give the case a volume."), std::string::npos) << published.out;
  EXPECT_NE(published.err.find("not ready to be published"), std::string::npos) << published.err;
  EXPECT_FALSE(fs::exists(folder / "library"));
  const auto list = run({"case", "new", "--list-templates"});
  EXPECT_EQ(list.status, 0);
  EXPECT_NE(list.out.find("obstetric-biometry"), std::string::npos) << list.out;
  EXPECT_EQ(run({"case", "new", "-o", folder / "x", "--template", "nothing"}).status, 1);
  EXPECT_EQ(run({"case", "new"}).status, 2) << "no folder is named";
  EXPECT_EQ(run({"case", "new", folder / "nowhere.mha", "-o", folder / "x"}).status, 1);
  EXPECT_FALSE(fs::exists(folder / "x"));
}

}  // namespace
}  // namespace ew::test::case_new_test
