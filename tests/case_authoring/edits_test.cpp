#include "logic/edits.h"

#include <gtest/gtest.h>

namespace ew::case_authoring::edits_test {
namespace {

Case opened() {
  Case made;
  made.id = "x";
  made.title = "X";
  made.patient.name = "A";
  made.volume.file = "a.mha";
  made.otherFields = {{"patient", {{"weight_kg", 70}}}, {"volume", {{"licence", "CC0"}, {"future", 1}}}, {"lesson", {1, 2}}};
  return made;
}

TEST(Edits, ChangeOneFieldAndNothingElse) {
  Case expected = opened();
  expected.patient.name = "B";
  EXPECT_EQ(fieldAt(&CasePatient::name).with(opened(), "B"), expected);
  EXPECT_EQ(fieldAt(&CasePatient::name).of(expected), "B");
  expected = opened();
  expected.history = "Pain.";
  EXPECT_EQ(fieldAt(&Case::history).with(opened(), "Pain."), expected);
  EXPECT_EQ(fieldAt(&Case::tags).with(opened(), {}), opened());
}

TEST(Edits, RightsStandBesideTheVolumeAndGoWithoutATrace) {
  const auto licence = fieldAt(&RecordingRights::licence), attribution = fieldAt(&RecordingRights::attribution);
  EXPECT_EQ(licence.of(opened()), "CC0");
  const Case named = attribution.with(opened(), "Somebody");
  EXPECT_EQ(named.otherFields["volume"], nlohmann::json({{"licence", "CC0"}, {"future", 1}, {"attribution", "Somebody"}}));
  EXPECT_EQ(attribution.with(named, ""), opened());
}

TEST(Edits, AGivenVolumeBringsWhatIsSaidOfItAndNothingElse) {
  Case present = opened();
  present.title = "typed meanwhile";
  present.scene.attenuation.emplace();
  present.scene.reverberation.emplace();
  present.scene.noise.emplace();
  present.otherFields["echoes"] = nlohmann::json::object();
  Case given = opened();
  given.volume.file = "b.mha";
  given.targets = {{CaseTarget::Kind::point, "p", glm::dvec3(1.0), 5.0}};
  given.otherFields["volume"] = {{"licence", "CC BY 4.0"}};
  Case expected = given;
  expected.title = "typed meanwhile";
  expected.scene.noise.emplace();
  EXPECT_EQ(withVolumeGiven(present, given), expected) << "a recording has its own shadows, and its echoes are no other's";
  given.scene.attenuation.emplace();
  EXPECT_TRUE(withVolumeGiven(present, given).scene.attenuation);
  given.otherFields.erase("volume");
  EXPECT_FALSE(withVolumeGiven(present, given).otherFields.contains("volume"));
}

TEST(Edits, TheFieldOfAProblemComesFromItsContext) {
  EXPECT_EQ(fieldOf(Error{ErrorCode::badField, verbatim("x"), {{"found", "3"}, {"field", "patient.sex"}}}), "patient.sex");
  EXPECT_EQ(fieldOf(Error{ErrorCode::badField, verbatim("x"), {{"field", "start_pose[3]"}}}), "start_pose");
  EXPECT_EQ(fieldOf(Error{ErrorCode::notWritable, verbatim("x"), {}}), "");
}

TEST(Edits, AnIdIsAddedLastAndTakenOutWhereItStood) {
  const std::vector<std::string> both = withListed(withListed({}, "linear-12", true), "convex-3.5", true);
  EXPECT_EQ(both, (std::vector<std::string>{"linear-12", "convex-3.5"}));
  EXPECT_EQ(withListed(both, "linear-12", true), both) << "listing it again must not move it to the end";
  EXPECT_EQ(withListed(both, "linear-12", false), (std::vector<std::string>{"convex-3.5"}));
  EXPECT_EQ(withListed(both, "nobody's", false), both);
}

TEST(Edits, LinesBecomeAListWithoutEmptyOnesAndBack) {
  const std::vector<std::string> texts = textsIn("One stone.\n\n  \nNo duct dilated.\n");
  EXPECT_EQ(texts, (std::vector<std::string>{"One stone.", "No duct dilated."}));
  EXPECT_EQ(linesOf(texts), "One stone.\nNo duct dilated.");
  EXPECT_TRUE(textsIn(" \n").empty());
}

TEST(Edits, TheStartPoseIsSetExactlyAndTakenAway) {
  Transform<frame::World, frame::Probe> pose;
  pose.matrix[3] = glm::dvec4(1.25, -7.5, 1e-3, 1.0);
  const Case placed = withStartPose(opened(), pose);
  ASSERT_TRUE(placed.startPose);
  EXPECT_EQ(placed.startPose->probeToWorld, pose);
  EXPECT_EQ(withStartPose(placed, std::nullopt), opened());
}

TEST(Edits, AProbeSeesTheVolumeWhereItsFanReachesIt) {
  sdk::Cases::Scan scan;
  scan.depth_mm = 100.0;
  scan.halfFace_mm = 20.0;
  scan.volume.dims = {21, 21, 21};  // 20 mm
  scan.volume.origin_mm = {30.0, 60.0, -10.0};
  const Transform<frame::World, frame::Probe> here;
  EXPECT_FALSE(seesVolume(scan, here)) << "parallel lines run beside it";
  scan.halfWidth_rad = 0.5;
  EXPECT_TRUE(seesVolume(scan, here)) << "a fan opens towards it";
  scan.depth_mm = 40.0;
  EXPECT_FALSE(seesVolume(scan, here)) << "the image ends before it";
  scan.depth_mm = 100.0;
  Transform<frame::World, frame::Probe> behind;
  behind.matrix[3] = glm::dvec4(0.0, 120.0, 0.0, 1.0);
  EXPECT_FALSE(seesVolume(scan, behind));
}

}  // namespace
}  // namespace ew::case_authoring::edits_test
