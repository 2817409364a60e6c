#include "logic/stitch_document.h"

#include <gtest/gtest.h>
#include <fstream>
#include <sstream>

#include "library/temporary_folder.h"
#include "stitching/fake_host.h"

namespace ew::test {

Result<std::string> PlainFiles::readText(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) return failure(ErrorCode::notFound, verbatim("There is no file '" + file.string() + "'."));
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}
Result<void> PlainFiles::writeText(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file);
  out << text;
  if (!out) return failure(ErrorCode::notWritable, verbatim("'" + file.string() + "' cannot be written."));
  return {};
}

}  // namespace ew::test

namespace ew::stitching {
namespace {

ProjectVolume volumeCalled(const std::string& name) {
  ProjectVolume volume;
  volume.file = "/data/" + name + ".mha";
  volume.name = name;
  return volume;
}

StitchProject threeVolumes() { return withVolumes({}, {volumeCalled("a"), volumeCalled("b"), volumeCalled("c")}); }

ProjectPair pairWithLandmark(std::size_t fixed, std::size_t moving) {
  ProjectPair pair;
  pair.fixed = fixed;
  pair.moving = moving;
  pair.landmarks.push_back({"fork", {1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}});
  return pair;
}

class StitchDocumentTest : public ::testing::Test {
 protected:
  test::TemporaryFolder folder_;
  test::PlainFiles files_;
  const std::filesystem::path recovery_ = folder_ / "kept/recovery.json";
  StitchDocument document_{files_, recovery_};
};

TEST_F(StitchDocumentTest, EachEditIsUndoneAndRedoneByItsName) {
  document_.edit(threeVolumes(), "add 3 volumes");
  document_.edit(withoutVolume(document_.project(), 1), "remove b");
  EXPECT_EQ(document_.undoName(), "remove b");
  document_.undo();
  EXPECT_EQ(document_.project(), threeVolumes());
  EXPECT_EQ(document_.undoName(), "add 3 volumes");
  EXPECT_EQ(document_.redoName(), "remove b");
  document_.undo();
  EXPECT_TRUE(document_.project().volumes.empty());
  EXPECT_EQ(document_.undoName(), "");
  document_.undo();  // nothing left: nothing happens
  document_.redo();
  document_.redo();
  EXPECT_EQ(document_.project().volumes.size(), 2u);
  EXPECT_EQ(document_.redoName(), "");
}

TEST_F(StitchDocumentTest, AnEditAfterAnUndoForgetsWhatWasUndone) {
  document_.edit(threeVolumes(), "add");
  document_.undo();
  document_.edit(withVolumes({}, {volumeCalled("d")}), "add d");
  EXPECT_EQ(document_.redoName(), "");
  document_.undo();
  EXPECT_TRUE(document_.project().volumes.empty());
}

TEST_F(StitchDocumentTest, RepeatedNudgesAreOneStepWithTheirSumInItsName) {
  document_.edit(threeVolumes(), "add");
  for (int n = 1; n <= 4; ++n) {
    const StitchProject* before = document_.beforeMerging("nudge 1");
    EXPECT_EQ(before != nullptr, n > 1);
    Transform<frame::World, frame::View> place;
    place.matrix[3].x = 0.5 * n;
    if (before != nullptr) {
      EXPECT_EQ(before->volumes[1].toWorld, (Transform<frame::World, frame::View>{}));
    }
    document_.edit(withPlace(document_.project(), 1, place, Placement::hand), "nudge b by " + std::to_string(0.5 * n) + " mm", "nudge 1");
  }
  EXPECT_EQ(document_.undoName(), "nudge b by 2.000000 mm");
  document_.undo();
  EXPECT_EQ(document_.project(), threeVolumes());
  EXPECT_EQ(document_.beforeMerging("nudge 1"), nullptr) << "an undone step must not take more in";
}

TEST_F(StitchDocumentTest, AHandThatLetsGoBeginsAnotherStep) {
  document_.edit(threeVolumes(), "add");
  Transform<frame::World, frame::View> place;
  place.matrix[3].x = 1.0;
  document_.edit(withPlace(document_.project(), 1, place, Placement::hand), "one", "key");
  document_.endMerging();
  place.matrix[3].x = 2.0;
  document_.edit(withPlace(document_.project(), 1, place, Placement::hand), "two", "key");
  document_.undo();
  EXPECT_EQ(document_.project().volumes[1].toWorld.matrix[3].x, 1.0);
}

TEST_F(StitchDocumentTest, AnEditThatChangesNothingIsNoStep) {
  document_.edit(threeVolumes(), "add");
  document_.edit(document_.project(), "nothing");
  EXPECT_EQ(document_.undoName(), "add");
}

TEST_F(StitchDocumentTest, ARemovedVolumeTakesItsPairsAndStrokesAlongAndTheOthersKeepTheirs) {
  StitchProject project = threeVolumes();
  project = withPair(project, pairWithLandmark(0, 1));
  project = withPair(project, pairWithLandmark(0, 2));
  project = withStroke(project, {1, {1, 1, 1}, 5.0});
  project = withStroke(project, {2, {2, 2, 2}, 5.0});
  project = withoutVolume(project, 1);
  ASSERT_EQ(project.pairs.size(), 1u);
  EXPECT_EQ(project.pairs[0].fixed, 0u);
  EXPECT_EQ(project.pairs[0].moving, 1u);
  ASSERT_EQ(project.settings.join.seam.strokes.size(), 1u);
  EXPECT_EQ(project.settings.join.seam.strokes[0].view, 1u);
  EXPECT_EQ(project.settings.join.seam.strokes[0].at_mm.x, 2.0);
}

TEST_F(StitchDocumentTest, APairWhoseVolumesChangePlacesIsTheSamePairToldFromTheOtherSide) {
  StitchProject project = threeVolumes();
  ProjectPair pair = pairWithLandmark(0, 2);
  Transform<frame::Moving, frame::Fixed> start;
  start.matrix[3] = {7.0, -2.0, 1.0, 1.0};
  pair.start = start;
  project = withVolumeMoved(withPair(project, pair), 2, 0);
  EXPECT_EQ(project.volumes[0].name, "c");
  ASSERT_EQ(project.pairs.size(), 1u);
  EXPECT_EQ(project.pairs[0].fixed, 0u);
  EXPECT_EQ(project.pairs[0].moving, 1u);
  EXPECT_EQ(project.pairs[0].landmarks[0].fixed_mm, glm::dvec3(4, 5, 6));
  EXPECT_EQ(glm::dvec3(project.pairs[0].start->matrix[3]), glm::dvec3(-7, 2, -1));
  EXPECT_EQ(withVolumeMoved(project, 0, 2), withPair(threeVolumes(), pair)) << "there and back";
}

TEST_F(StitchDocumentTest, APairOfWhichNothingIsSaidIsNotWritten) {
  StitchProject project = withPair(threeVolumes(), pairWithLandmark(0, 1));
  ProjectPair pair = pairOf(project, 1, 0);
  EXPECT_EQ(pair.landmarks.size(), 1u) << "the order in which a pair is named does not matter";
  pair.landmarks.clear();
  EXPECT_TRUE(withPair(project, pair).pairs.empty());
}

TEST_F(StitchDocumentTest, NamesStayUniqueAndAnEmptyOneIsRefusedWithASentence) {
  StitchProject project = withVolumes(threeVolumes(), {volumeCalled("a"), volumeCalled("a")});
  EXPECT_EQ(project.volumes[3].name, "a (2)");
  EXPECT_EQ(project.volumes[4].name, "a (3)");
  EXPECT_TRUE(problemOfName(project, 0, "  "));
  ASSERT_TRUE(problemOfName(project, 0, "b"));
  EXPECT_NE(problemOfName(project, 0, "b")->sentence().find("'b'"), std::string::npos);
  EXPECT_FALSE(problemOfName(project, 0, "a"));
  EXPECT_EQ(letterOf(0) + letterOf(25) + letterOf(26), "AZAA");
}

TEST_F(StitchDocumentTest, ASavedProjectOpensAsItWas) {
  StitchProject project = withPair(threeVolumes(), pairWithLandmark(0, 2));
  project = withStroke(project, {1, {1.5, -2.25, 3.0}, 4.0});
  project.settings.effort = registration::ElasticEffort::accurate;
  document_.edit(project, "all");
  EXPECT_TRUE(document_.hasUnsavedChanges());
  ASSERT_TRUE(document_.save(folder_ / "p.json"));
  EXPECT_FALSE(document_.hasUnsavedChanges());
  StitchDocument other(files_, folder_ / "other.json");
  ASSERT_TRUE(other.open(folder_ / "p.json"));
  EXPECT_EQ(other.project(), project);
  EXPECT_EQ(other.undoName(), "");
  EXPECT_FALSE(other.hasUnsavedChanges());
  other.edit(withoutVolume(other.project(), 0), "remove");
  EXPECT_TRUE(other.hasUnsavedChanges());
  other.undo();
  EXPECT_FALSE(other.hasUnsavedChanges()) << "an undone edit needs no saving";
}

TEST_F(StitchDocumentTest, AFileThatIsNoProjectLeavesThePresentOneAlone) {
  document_.edit(threeVolumes(), "add");
  test::writeText(folder_ / "bad.json", "{\"volumes\": 3}");
  EXPECT_FALSE(document_.open(folder_ / "bad.json"));
  EXPECT_FALSE(document_.open(folder_ / "missing.json"));
  EXPECT_EQ(document_.project(), threeVolumes());
  EXPECT_EQ(document_.undoName(), "add");
}

TEST_F(StitchDocumentTest, WhatACrashLeavesIsOfferedAndTakenOver) {
  {
    StitchDocument crashed(files_, folder_ / "kept" / "recovery.json");
    crashed.edit(threeVolumes(), "add");
    ASSERT_TRUE(crashed.save(folder_ / "p.json"));
    EXPECT_FALSE(*crashed.leftIn(folder_ / "kept" / "recovery.json"));
    crashed.edit(withPair(crashed.project(), pairWithLandmark(0, 1)), "landmark");
    ASSERT_TRUE(crashed.keepRecovery());
  }
  const auto left = document_.leftIn(recovery_);
  ASSERT_TRUE(left) << left.error();
  ASSERT_TRUE(*left);
  EXPECT_EQ((*left)->file, folder_ / "p.json");
  document_.takeOver(**left);
  EXPECT_EQ(document_.project(), withPair(threeVolumes(), pairWithLandmark(0, 1)));
  EXPECT_TRUE(document_.hasUnsavedChanges());
  ASSERT_TRUE(document_.save(document_.file()));
  EXPECT_FALSE(*document_.leftIn(recovery_));
}

TEST_F(StitchDocumentTest, ADamagedRecoveryFileIsASentenceAndStaysWhereItIs) {
  std::filesystem::create_directories(folder_ / "kept");
  test::writeText(folder_ / "kept" / "recovery.json", "{\"file\": 3");
  const auto left = document_.leftIn(recovery_);
  ASSERT_FALSE(left);
  EXPECT_EQ(left.error().sentence().back(), '.');
  EXPECT_TRUE(std::filesystem::exists(folder_ / "kept" / "recovery.json"));
}

TEST_F(StitchDocumentTest, AfterEverythingIsUndoneNoRecoveryIsLeft) {
  document_.edit(threeVolumes(), "add");
  ASSERT_TRUE(document_.keepRecovery());
  EXPECT_TRUE(*document_.leftIn(recovery_));
  document_.undo();
  ASSERT_TRUE(document_.keepRecovery());
  EXPECT_FALSE(*document_.leftIn(recovery_));
  EXPECT_FALSE(document_.save(folder_ / "empty.json")) << "an empty project could not be opened again";
}

TEST_F(StitchDocumentTest, NamesTheFilesThatDoNotGoAlongWhenAProjectIsTakenElsewhere) {
  StitchProject project = withVolumes({}, {volumeCalled("a"), volumeCalled("b")});
  project.volumes[0].file = "/study/recordings/a.mha";
  project.volumes[0].calibration = "/study/probe.xml";
  EXPECT_EQ(filesElsewhere(project, "/study"), std::vector<std::filesystem::path>{"/data/b.mha"});
  EXPECT_EQ(filesElsewhere(project, "/").size(), 0u);
  EXPECT_EQ(filesElsewhere(project, "/study/recordings").size(), 2u);
  const std::string text = projectText(project, "/study");
  EXPECT_NE(text.find("\"recordings/a.mha\""), std::string::npos) << text;
  EXPECT_NE(text.find("\"/data/b.mha\""), std::string::npos) << text;
}

TEST_F(StitchDocumentTest, KnowsThatSomebodyElseWroteItsFile) {
  StitchDocument other(files_, folder_ / "other.json");
  document_.edit(threeVolumes(), "add");
  EXPECT_FALSE(document_.isChangedOnDisk()) << "it has no file";
  ASSERT_TRUE(document_.save(folder_ / "p.json"));
  EXPECT_FALSE(document_.isChangedOnDisk());
  ASSERT_TRUE(other.open(folder_ / "p.json"));
  EXPECT_FALSE(other.isChangedOnDisk());
  other.edit(withoutVolume(other.project(), 0), "remove");
  ASSERT_TRUE(other.save(other.file()));
  EXPECT_FALSE(other.isChangedOnDisk());
  EXPECT_TRUE(document_.isChangedOnDisk());
  ASSERT_TRUE(document_.open(document_.file()));
  EXPECT_FALSE(document_.isChangedOnDisk());
  std::filesystem::remove(folder_ / "p.json");
  EXPECT_FALSE(document_.isChangedOnDisk()) << "nothing is lost by writing it again";
}

TEST_F(StitchDocumentTest, KnowsThatTheFileOfRecoveredWorkWasWrittenAfterwards) {
  document_.edit(threeVolumes(), "add");
  ASSERT_TRUE(document_.save(folder_ / "p.json"));
  document_.edit(withoutVolume(document_.project(), 0), "remove");
  ASSERT_TRUE(document_.keepRecovery());
  StitchDocument later(files_, folder_ / "later.json");
  const auto left = later.leftIn(recovery_);
  ASSERT_TRUE(left && *left);
  later.takeOver(**left);
  EXPECT_FALSE(later.isChangedOnDisk());
  ASSERT_TRUE(later.keepRecovery());
  EXPECT_TRUE(std::filesystem::exists(folder_ / "later.json")) << "what was taken over is kept in the window's own place";
}

TEST_F(StitchDocumentTest, ARecoveryThatNestsWithoutEndIsASentence) {
  std::filesystem::create_directories(recovery_.parent_path());
  test::writeText(recovery_, "{\"file\": \"\", \"project\": " + std::string(300000, '['));
  EXPECT_FALSE(document_.leftIn(recovery_));
}

}  // namespace
}  // namespace ew::stitching
