#include "logic/edits.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "ew/sdk/placement.h"

namespace ew::case_authoring::edits_test {
namespace {

using nlohmann::json;

const json kManifest = {{"format", 1},
                        {"id", "x"},
                        {"title", "X"},
                        {"patient", {{"name", "A"}, {"weight_kg", 70}}},
                        {"volume", {{"file", "a.mha"}, {"licence", "CC0"}}},
                        {"lesson", {1, 2}}};

TEST(Edits, ChangeOneFieldAndNothingElse) {
  json expected = kManifest;
  expected["patient"]["name"] = "B";
  EXPECT_EQ(withText(kManifest, "patient.name", "B"), expected);
  EXPECT_EQ(textOf(expected, "patient.name"), "B");
}

TEST(Edits, AnEmptyTextRemovesTheFieldButNeverARequiredOne) {
  const json without = withText(kManifest, "patient.name", "");
  EXPECT_FALSE(without["patient"].contains("name"));
  EXPECT_EQ(without["patient"]["weight_kg"], 70);
  EXPECT_EQ(withText(kManifest, "title", "")["title"], "");
  EXPECT_EQ(withText(kManifest, "history", ""), kManifest);
}

TEST(Edits, AnObjectThatBecomesEmptyGoesToo) {
  json manifest = kManifest;
  manifest["patient"] = {{"age_years", 4}};
  EXPECT_FALSE(withField(manifest, "patient.age_years", std::nullopt).contains("patient"));
}

TEST(Edits, AMissingFieldIsEmptyAndCanBeMade) {
  EXPECT_TRUE(fieldOf(kManifest, "patient.age_years").is_null());
  EXPECT_TRUE(fieldOf(kManifest, "nobody.knows.this").is_null());
  EXPECT_EQ(textOf(kManifest, "patient.weight_kg"), "") << "a number is no text";
  EXPECT_EQ(fieldOf(withField(kManifest, "patient.age_years", 46), "patient.age_years"), 46);
  EXPECT_EQ(withText(json{{"id", "x"}}, "patient.name", "C")["patient"]["name"], "C");
}

TEST(Edits, AnEffectIsSwitchedOnAtItsUsualStrengthAndOffWithoutATrace) {
  const json on = withEffect(kManifest, "scene.noise", true);
  EXPECT_EQ(on["scene"]["noise"], true);
  EXPECT_TRUE(hasEffect(on, "scene.noise"));
  EXPECT_EQ(withEffect(on, "scene.noise", false), kManifest);
  EXPECT_FALSE(hasEffect(kManifest, "scene.noise"));
}

TEST(Edits, AnEffectThatIsOnKeepsItsParameters) {
  const json tuned = withField(kManifest, "scene.focus", json{{"strength", 2.0}});
  EXPECT_TRUE(hasEffect(tuned, "scene.focus"));
  EXPECT_EQ(withEffect(tuned, "scene.focus", true), tuned);
  EXPECT_FALSE(hasEffect(withEffect(tuned, "scene.focus", false), "scene.focus"));
  EXPECT_FALSE(hasEffect(withField(kManifest, "scene.focus", false), "scene.focus"));
}

TEST(Edits, GainAndDgcAreThereUntilTheyAreSwitchedOff) {
  EXPECT_TRUE(hasEffect(json::object(), "scene.gain_and_dgc"));
  const json off = withEffect(kManifest, "scene.gain_and_dgc", false);
  EXPECT_EQ(off["scene"]["gain_and_dgc"], false);
  EXPECT_TRUE(hasEffect(withEffect(off, "scene.gain_and_dgc", true), "scene.gain_and_dgc"));
}

TEST(Edits, APlaceThatIsMissingIsTheIdentityAndABrokenOneIsAnError) {
  EXPECT_EQ(placeOf(kManifest).value(), (Transform<frame::World, frame::File>{}));
  for (const json& wrong : {json("here"), json::array({1, 2}), json::array({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, "16"})})
    EXPECT_EQ(placeOf(withField(kManifest, "volume.file_to_world", wrong)).error().code, ErrorCode::badField);
}

TEST(Edits, TheFieldOfAProblemComesFromItsContext) {
  EXPECT_EQ(fieldOf(Error{ErrorCode::badField, verbatim("x"), {{"found", "3"}, {"field", "patient.sex"}}}), "patient.sex");
  EXPECT_EQ(fieldOf(Error{ErrorCode::badField, verbatim("x"), {{"field", "start_pose[3]"}}}), "start_pose");
  EXPECT_EQ(fieldOf(Error{ErrorCode::notWritable, verbatim("x"), {}}), "");
}

RC_GTEST_PROP(Edits, APlaceSurvivesTheManifestAndItsText, ()) {
  const auto number = [](double unit) { return *rc::gen::inRange(-20000, 20000) * unit; };
  const auto matrix = sdk::transformOf({{number(0.037), number(0.037), number(0.037)}, {number(0.01), number(0.01), number(0.01)}});
  const json manifest = json::parse(withPlace(kManifest, matrix).dump());
  RC_ASSERT(placeOf(manifest).value() == matrix);
  RC_ASSERT(manifest["volume"]["licence"] == "CC0");
}

TEST(Edits, AProbeIsAddedLastAndAnEmptyListMeansAll) {
  json manifest = withProbe(withProbe(kManifest, "linear-12", true), "convex-3.5", true);
  EXPECT_EQ(probesOf(manifest), (std::vector<std::string>{"linear-12", "convex-3.5"}));
  EXPECT_EQ(withProbe(manifest, "linear-12", true), manifest) << "listing it again must not move it to the end";
  EXPECT_TRUE(listsProbe(manifest, "linear-12"));
  manifest = withProbe(withProbe(manifest, "linear-12", false), "convex-3.5", false);
  EXPECT_EQ(manifest, kManifest);
}

TEST(Edits, LinesBecomeAListWithoutEmptyOnesAndBack) {
  const json manifest = withLines(kManifest, "findings", "One stone.\n\n  \nNo duct dilated.\n");
  EXPECT_EQ(manifest["findings"], json({"One stone.", "No duct dilated."}));
  EXPECT_EQ(linesOf(manifest, "findings"), "One stone.\nNo duct dilated.");
  EXPECT_EQ(withLines(manifest, "findings", " \n"), kManifest);
}

TEST(Edits, TheStartPoseIsSetExactlyAndTakenAway) {
  Transform<frame::World, frame::Probe> pose;
  pose.matrix[3] = glm::dvec4(1.25, -7.5, 1e-3, 1.0);
  const json manifest = withStartPose(kManifest, pose);
  EXPECT_EQ(startPoseOf(manifest), pose);
  EXPECT_EQ(withStartPose(manifest, std::nullopt), kManifest);
  EXPECT_FALSE(startPoseOf({{"start_pose", {1, 2, 3}}}).has_value());
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
  EXPECT_FALSE(seesVolume(scan, here)) << "the picture ends before it";
  scan.depth_mm = 100.0;
  Transform<frame::World, frame::Probe> behind;
  behind.matrix[3] = glm::dvec4(0.0, 120.0, 0.0, 1.0);
  EXPECT_FALSE(seesVolume(scan, behind));
}

}  // namespace
}  // namespace ew::case_authoring::edits_test
