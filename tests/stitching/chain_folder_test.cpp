// What a run does with the folder it works in: what it trusts there, and what it never touches.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "chain/file_contents.h"
#include "ew/io/sequence.h"
#include "ew/io/step_store.h"
#include "ew/stitching/result_files.h"
#include "stitching/chain_world.h"

namespace ew::stitching::chain_folder_test {
namespace {

namespace fs = std::filesystem;
using test::ChainWorld;
using test::textOf;

constexpr const char* kResults[] = {"volume.mha", "coverage.mha", "source.mha", "level.mha", "provenance.json"};

/// Regular files below a folder by name, with what they hold.
std::map<std::string, std::string> everythingIn(const fs::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& each : fs::recursive_directory_iterator(folder))
    if (each.is_regular_file()) all[fs::relative(each.path(), folder).string()] = textOf(each.path());
  return all;
}

/// A folder with all it holds and when it was written.
void copyWithTimes(const fs::path& from, const fs::path& to) {
  fs::remove_all(to);
  fs::copy(from, to, fs::copy_options::recursive);
  for (const auto& each : fs::recursive_directory_iterator(from))
    if (each.is_regular_file()) fs::last_write_time(to / fs::relative(each.path(), from), each.last_write_time());
}

/// As a medium does it: nobody wrote, so no time changes.
void flipByte(const fs::path& file, std::size_t at) {
  const auto time = fs::last_write_time(file);
  std::string bytes = textOf(file);
  ASSERT_LT(at, bytes.size()) << file;
  bytes[at] = static_cast<char>(bytes[at] ^ 0x11);
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
  fs::last_write_time(file, time);
}

/// Of `stepFolder` and what depends on it, all but what is under test, so that a run has to read that.
void takeAwayWhatFollows(const fs::path& into, const std::string& stepFolder) {
  const std::vector<std::vector<std::string>> follow = {
      {"reconstruct", "pairs", "rigid", "graph", "equalise", "bends", "elastic", "seam", "volume"},
      {"pairs", "rigid", "graph", "equalise", "bends", "elastic", "seam", "volume"},
      {"rigid", "graph", "equalise", "bends", "elastic", "seam", "volume"},
      {"graph", "equalise", "bends", "elastic", "seam", "volume"},
      {"equalise", "seam", "volume"},
      {"bends", "elastic", "seam", "volume"},
      {"elastic", "seam", "volume"},
      {"seam", "volume"},
      {"volume"}};
  for (const auto& chain : follow) {
    if (chain.front() != stepFolder) continue;
    for (std::size_t n = 1; n < chain.size(); ++n) fs::remove_all(into / "steps" / chain[n]);
    for (const char* name : kResults)
      if (stepFolder != "volume") fs::remove(into / name);
  }
}

/// Three volumes, the first of which is a tracked sweep of its layers.
class WorldWithASweep : public ChainWorld {
 public:
  WorldWithASweep() {
    auto& line = project.volumes[0];
    const auto volume = readVolume(line.file);
    Sequence sweep;
    const glm::ivec3 dims = volume->volume.grid.dims;
    sweep.width = dims.x;
    sweep.height = dims.y;
    sweep.orientation = "MF";
    sweep.imageType = "BRIGHTNESS";
    sweep.pixels = volume->volume.echo;
    for (int k = 0; k < dims.z; ++k) {
      SequenceFrame frame;
      frame.time_s = 0.1 * k;
      glm::dmat4 imageToReference(1.0);
      for (int axis = 0; axis < 3; ++axis) imageToReference[axis][axis] = volume->volume.grid.spacing_mm[axis];
      imageToReference[3] = glm::dvec4(0.0, 0.0, volume->volume.grid.spacing_mm.z * k, 1.0);
      frame.transforms.push_back({"Image", "Reference", imageToReference, PoseStatus::ok});
      sweep.frames.push_back(frame);
    }
    line.file = folder / "a.igs.mha";
    if (!writeSequence(sweep, line.file)) throw std::runtime_error("the sweep was not written");
  }
};

TEST(ChainFolder, MakesAgainWhatAMediumDamagedWithoutAChangeOfSize) {
  WorldWithASweep world;
  const fs::path into = world.folder / "out";
  const auto first = world.run(into);
  ASSERT_TRUE(first) << first.error();
  const auto expected = ChainWorld::resultIn(into);
  const fs::path sound = world.folder / "sound";
  copyWithTimes(into, sound);
  std::set<std::string> folders;
  for (const auto& [name, bytes] : everythingIn(sound)) {
    if (bytes.empty()) continue;
    const fs::path parent = fs::path(name).parent_path();
    folders.insert(parent.string());
    copyWithTimes(sound, into);
    takeAwayWhatFollows(into, parent.filename().string());
    if (parent.filename() == "volume")
      for (const char* result : kResults) fs::remove(into / result);
    flipByte(into / name, bytes.size() / 2);
    const auto state = world.run(into);
    ASSERT_TRUE(state) << name << ": " << state.error();
    EXPECT_EQ(ChainWorld::resultIn(into), expected) << name;
  }
  for (const std::string& step : stepFolders()) EXPECT_TRUE(folders.contains("steps/" + step)) << step << " keeps no file";
}

TEST(ChainFolder, ASweepOfAlmostNothingIsRefusedUntilItsEntryAcceptsIt) {
  WorldWithASweep world;
  auto& line = world.project.volumes[0];
  line.calibration = world.folder / "a.xml";
  test::writeText(line.calibration,
                  "<PlusConfiguration version=\"2.1\"><VolumeReconstruction ClipRectangleOrigin=\"0 0\" "
                  "ClipRectangleSize=\"2 31\"/></PlusConfiguration>");
  const fs::path into = world.folder / "out";
  ChainOptions options;
  options.until = Step::reconstruct;
  const auto refused = world.run(into, noProgress(), options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::unsupported);
  EXPECT_NE(refused.error().sentence().find("Only 8.3 % of the pixels"), std::string::npos) << refused.error();
  EXPECT_NE(refused.error().sentence().find("\"accept_small\": true in the entry of 'a.mha'"), std::string::npos) << refused.error();
  line.acceptsSmall = true;
  const auto accepted = world.run(into, noProgress(), options);
  EXPECT_TRUE(accepted) << accepted.error();
  line.acceptsSmall = false;
  EXPECT_FALSE(world.run(into, noProgress(), options)) << "taken back";
}

TEST(ChainFolder, FindsASeamInWhichTwoViewsWereExchangedAndMakesItAgain) {
  ChainWorld world;
  const fs::path into = world.folder / "out";
  ASSERT_TRUE(world.run(into));
  const auto expected = ChainWorld::resultIn(into);
  for (const auto& each : fs::directory_iterator(into / "steps" / "seam")) {
    if (!each.path().string().ends_with("-cells.bin")) continue;
    std::string cells = textOf(each.path());
    for (char& view : cells) view = static_cast<char>(view == 1 ? 2 : view == 2 ? 1 : view);
    std::ofstream(each.path(), std::ios::binary | std::ios::trunc) << cells;
  }
  fs::remove(into / "volume.mha");
  const auto state = world.run(into);
  ASSERT_TRUE(state) << state.error();
  EXPECT_FALSE(state->steps[static_cast<std::size_t>(Step::seam)].reused);
  EXPECT_EQ(ChainWorld::resultIn(into), expected);
}

TEST(ChainFolder, LeavesForeignFilesBelowStepsAsTheyAre) {
  ChainWorld world;
  const fs::path into = world.folder / "out";
  const std::string key(32, 'a');
  const std::map<std::string, std::string> foreign = {{"steps/week1/plan-draft.txt", "a plan"},
                                                      {"steps/photos/2026-01-01.jpg", "an image"},
                                                      {"steps/photos/.hidden", "hidden"},
                                                      {"steps/photos/" + key + "-x.bin", "looks like ours, and lies elsewhere"},
                                                      {"steps/seam/my-notes.txt", "notes"},
                                                      {"steps/seam/.hidden", "hidden"},
                                                      {"steps/seam/notes.json", "{}"},
                                                      {"steps/volume/2026-01-01.json", "{}"},
                                                      {"steps/reconstruct/summary.json", "{}"},
                                                      {"steps/draft.part", "half a letter"},
                                                      {"steps/week1/.ew-99999999-0/draft.txt", "lies elsewhere"},
                                                      {"steps/inputs.json", "[\"what a theatre play is made of\"]"},
                                                      {"steps/uses.txt", "1 cup, 2 cups"},
                                                      {"notes.txt", "notes"},
                                                      {".volume.mha", "hidden"}};
  for (const auto& [name, text] : foreign) {
    fs::create_directories((into / name).parent_path());
    test::writeText(into / name, text);
  }
  ChainOptions options;
  options.keepBytes = 0;
  for (const double fallOff_mm : {15.0, 16.0}) {
    world.project.settings.fallOff_mm = fallOff_mm;
    const auto state = world.run(into, noProgress(), options);
    ASSERT_TRUE(state) << state.error();
    for (const auto& [name, text] : foreign) EXPECT_EQ(textOf(into / name), text) << name;
  }
}

TEST(ChainFolder, ClearsAwayWhatAKilledRunLeftHalfWritten) {
  ChainWorld world;
  const fs::path into = world.folder / "out";
  const std::string key(32, 'b');
  const std::vector<std::string> leftovers = {"steps/seam/" + key + "-cells.bin", "steps/seam/.ew-99999999-0/" + key + ".json",
                                              "steps/.ew-99999999-1/inputs.json"};
  for (const auto& name : leftovers) {
    fs::create_directories((into / name).parent_path());
    test::writeText(into / name, "half");
  }
  ASSERT_TRUE(world.run(into));
  for (const auto& name : leftovers) EXPECT_FALSE(fs::exists(into / name)) << name;
}

TEST(ChainFolder, NeverWritesOverAFileThatTheProjectReads) {
  ChainWorld world;
  const fs::path input = world.project.volumes[1].file;
  for (const char* name : kResults) {
    const fs::path into = world.folder / (std::string("out ") + name);
    fs::create_directories(into);
    fs::copy_file(input, into / name);
    world.project.volumes[1].file = into / name;
    const auto before = everythingIn(into);
    const auto refused = world.run(into);
    ASSERT_FALSE(refused) << name;
    EXPECT_EQ(refused.error().code, ErrorCode::badUsage) << refused.error();
    EXPECT_NE(refused.error().sentence().find(name), std::string::npos) << refused.error();
    EXPECT_EQ(everythingIn(into), before) << name;
  }
}

TEST(ChainFolder, NeverWritesOverAnInputUnderAnotherName) {
  ChainWorld world;
  const fs::path into = world.folder / "out";
  fs::create_directories(into);
  fs::create_hard_link(world.project.volumes[2].file, into / "coverage.mha");
  const auto linked = world.run(into);
  ASSERT_FALSE(linked);
  EXPECT_EQ(linked.error().code, ErrorCode::badUsage) << linked.error();
  fs::remove(into / "coverage.mha");

  ASSERT_TRUE(world.run(into));
  fs::path made;
  for (const auto& each : fs::directory_iterator(into / "steps" / "seam")) made = each.path();
  world.project.volumes[1].file = made;
  const auto below = world.run(into);
  ASSERT_FALSE(below) << "what lies below steps comes and goes";
  EXPECT_EQ(below.error().code, ErrorCode::badUsage) << below.error();
}

TEST(ChainFolder, NeverTouchesAFileOfAResultsNameThatItDidNotWrite) {
  ChainWorld world;
  ASSERT_TRUE(world.run(world.folder / "sound"));
  for (const char* name : kResults)
    for (const bool afterARun : {false, true}) {
      const fs::path into = world.folder / "out";
      fs::remove_all(into);
      if (afterARun) copyWithTimes(world.folder / "sound", into);
      fs::create_directories(into);
      fs::remove(into / name);
      test::writeText(into / name, "{\"my\": \"only copy\"}");
      const auto before = everythingIn(into);
      const auto refused = world.run(into);
      ASSERT_FALSE(refused) << name;
      EXPECT_EQ(refused.error().code, ErrorCode::notWritable) << refused.error();
      EXPECT_NE(refused.error().sentence().find(name), std::string::npos) << refused.error();
      EXPECT_EQ(everythingIn(into), before) << name << (afterARun ? " after a run" : "");
      ChainOptions until;
      until.until = Step::graph;
      EXPECT_TRUE(world.run(into, noProgress(), until)) << "what stops before has no results to write";
      EXPECT_EQ(textOf(into / name), "{\"my\": \"only copy\"}");
      fs::remove(into / name);
      EXPECT_TRUE(world.run(into));
    }
}

TEST(ChainFolder, AFileThatComesWhileARunIsAtWorkIsNotTouchedEither) {
  ChainWorld world;
  const fs::path into = world.folder / "out";
  ChainOptions options;
  options.onStep = [&](const StepOutcome& step) {
    if (step.step == Step::seam) test::writeText(into / "source.mha", "came meanwhile");
  };
  const auto refused = world.run(into, noProgress(), options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::notWritable) << refused.error();
  EXPECT_EQ(textOf(into / "source.mha"), "came meanwhile");
  EXPECT_FALSE(fs::exists(into / "volume.mha")) << "all four or none";
  EXPECT_FALSE(fs::exists(into / "provenance.json"));
  fs::remove(into / "source.mha");
  const auto state = world.run(into);
  ASSERT_TRUE(state) << state.error();
  EXPECT_TRUE(state->steps[static_cast<std::size_t>(Step::volume)].reused) << "what was made waited";
}

TEST(ChainFolder, KnowsItsOwnResultsByTheStepsOrByTheProvenance) {
  ChainWorld world;
  const fs::path into = world.folder / "out";
  ASSERT_TRUE(world.run(into));
  const auto expected = ChainWorld::resultIn(into);
  const auto again = [&](double fallOff_mm) {
    world.project.settings.fallOff_mm = fallOff_mm;
    const auto state = world.run(into);
    EXPECT_TRUE(state) << state.error();
  };
  again(17.0);
  EXPECT_NE(ChainWorld::resultIn(into), expected);
  fs::remove_all(into / "steps");
  again(18.0);
  fs::remove(into / "provenance.json");
  again(19.0);
  for (const auto& each : fs::directory_iterator(into / "steps" / "volume")) test::writeText(each.path(), "damaged");
  again(15.0);
  EXPECT_EQ(ChainWorld::resultIn(into), expected);
}

TEST(ChainFolder, AResultThatCannotBePutInItsPlaceLeavesTheOneBefore) {
  const test::TemporaryFolder folder;
  const fs::path out = folder / "out", made = folder / "made";
  fs::create_directories(out);
  fs::create_directories(made);
  std::vector<ResultFile> written;
  const ResultFiles::Waiting there = [&](const char* name) { return out / name; };
  for (const char* name : kResults) test::writeText(out / name, std::string("old ") + name);
  written = *resultFilesAt({std::begin(kResults), std::end(kResults)}, there);
  const auto before = everythingIn(out);
  const auto seen = ResultFiles::look(out, written, noProgress());
  ASSERT_TRUE(seen && seen->checkOwn());
  for (const char* name : kResults) test::writeText(made / name, std::string("new ") + name);
  const ResultFiles::Waiting waiting = [&](const char* name) { return made / name; };
  // The last but one has nowhere to go aside: a folder that is not empty has its name.
  const ResultFiles::Waiting aside = [&](const char* name) { return made / (std::string("earlier-") + name); };
  fs::create_directories(aside("coverage.mha") / "full");
  const auto failed = seen->publish(waiting, aside);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, ErrorCode::notWritable) << failed.error();
  EXPECT_EQ(everythingIn(out), before);
  fs::remove_all(aside("coverage.mha"));
  ASSERT_TRUE(seen->publish(waiting, aside));
  for (const char* name : kResults) EXPECT_EQ(textOf(out / name), std::string("new ") + name);
}

TEST(ChainFolder, CopiesAResultAndAsksBeforeItReplacesWhatSomebodyElseMade) {
  ChainWorld world;
  const fs::path into = world.folder / "out", copies = world.folder / "copies";
  const auto state = world.run(into);
  ASSERT_TRUE(state) << state.error();
  const ResultPaths result = {state->volume, state->coverage, state->source, state->level, state->provenance};
  const auto copy = [&](bool replaceForeign) { return copyResult(result, world.project, copies, replaceForeign, noProgress()); };
  ASSERT_TRUE(copy(false));
  EXPECT_EQ(ChainWorld::resultIn(copies), ChainWorld::resultIn(into));
  EXPECT_TRUE(copy(false)) << "its own earlier copy is no question";
  test::writeText(copies / "volume.mha", "my only copy");
  const auto before = everythingIn(copies);
  const auto refused = copy(false);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::notWritable) << refused.error();
  EXPECT_EQ(everythingIn(copies), before);
  EXPECT_TRUE(copy(true)) << "somebody said so";
  EXPECT_EQ(everythingIn(copies), ChainWorld::resultIn(into));
  world.project.volumes[0].file = copies / "volume.mha";
  const auto input = copy(true);
  ASSERT_FALSE(input) << "an input is never an output, whoever was asked";
  EXPECT_EQ(input.error().code, ErrorCode::badUsage) << input.error();
}

TEST(ChainFolder, WhatNestsWithoutEndIsNoMemoryOfInputsAndNoResult) {
  const std::string deep = "{ \"made_by\": \"EchoWeave\", \"x\": " + std::string(300000, '[');
  ChainWorld world;
  const fs::path into = world.folder / "out";
  ASSERT_TRUE(world.run(into));
  const auto expected = ChainWorld::resultIn(into);
  std::vector<fs::path> texts;
  for (const auto& each : fs::recursive_directory_iterator(into / "steps"))
    if (each.path().extension() == ".json") texts.push_back(each.path());
  for (const fs::path& file : texts) {
    test::writeText(file, deep);
    const auto state = world.run(into);
    ASSERT_TRUE(state) << file << state.error();
    EXPECT_EQ(ChainWorld::resultIn(into), expected) << file;
  }
  test::writeText(into / "provenance.json", deep);
  EXPECT_FALSE(world.run(into)) << "a provenance that this program did not write";
}

}  // namespace
}  // namespace ew::stitching::chain_folder_test
