#include "ew/library/case.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>

#include "ew/core/responsive_thread.h"
#include "ew/library/new_case.h"
#include "ew/library/schema.h"
#include "least_case.h"
#include "library/temporary_folder.h"

namespace ew::case_test {
namespace {

using nlohmann::json;
using test::context;
using test::EnvironmentValue;
using test::makeCase;
using test::smallest;
using test::TemporaryFolder;
using test::textOf;
using test::writeText;

/// Stops with the broken expectation, in builds that check contracts.
void readOnAResponsiveThread(const std::filesystem::path& folder, const std::function<void(const std::filesystem::path&)>& reading) {
  const ResponsiveThread mark;
  reading(folder);
}

json identityWith(std::size_t index, double value) {
  json rows = rowsOf(glm::dmat4(1.0));
  rows[index] = value;
  return rows;
}

/// The one problem `manifest` has, and what it says about the field.
Error onlyProblem(const json& manifest) {
  const TemporaryFolder folder;
  makeCase(folder.path(), manifest);
  const auto problems = validateCase(folder.path());
  EXPECT_EQ(problems.size(), 1u) << manifest;
  for (const auto& problem : problems) EXPECT_TRUE(problem.sentence().ends_with('.')) << problem.sentence();
  const auto opened = loadCase(folder.path());
  EXPECT_FALSE(opened);
  if (problems.empty()) return {};
  if (!opened) {
    EXPECT_EQ(opened.error(), problems.front());
  }
  return problems.front();
}

TEST(LoadCase, IsNeverCalledOnAThreadThatSomebodyWaitsFor) {
#ifndef EW_CHECK_CONTRACTS
  GTEST_SKIP() << "this build checks no contracts";
#else
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const TemporaryFolder folder;
  makeCase(folder.path(), smallest());
  using Path = const std::filesystem::path&;
  EXPECT_DEATH(readOnAResponsiveThread(folder.path(), [](Path at) { (void)loadCase(at); }), "isResponsiveThread");
  EXPECT_DEATH(readOnAResponsiveThread(folder.path(), [](Path at) { (void)validateCase(at); }), "isResponsiveThread");
  EXPECT_DEATH(readOnAResponsiveThread(folder.path().parent_path(), [](Path at) { (void)listCases(at); }), "isResponsiveThread");
  EXPECT_DEATH(readOnAResponsiveThread(folder.path(), [](Path at) { (void)caseFromManifest(smallest(), at); }), "isResponsiveThread");
  EXPECT_TRUE(loadCase(folder.path())) << "without the mark nothing stops";
#endif
}

TEST(LoadCase, OpensAFolderOrItsManifestAlike) {
  const TemporaryFolder folder;
  makeCase(folder.path(), smallest());
  const auto byFolder = loadCase(folder.path());
  const auto byManifest = loadCase(folder / "case.json");
  ASSERT_TRUE(byFolder) << byFolder.error();
  ASSERT_TRUE(byManifest);
  EXPECT_EQ(*byFolder, *byManifest);
  EXPECT_EQ(byFolder->title, "One");
  EXPECT_EQ(byFolder->volume.fileToWorld, (Transform<frame::World, frame::File>{}));
  EXPECT_TRUE(byFolder->scene.gainAndDgc);
  EXPECT_FALSE(byFolder->startPose);
}

TEST(LoadCase, GivesATraineeATitleOfTheirOwnAndKeepsTheExpertsPoseApartFromTheStart) {
  json manifest = smallest();
  manifest["title"] = "Aneurysm";
  manifest["title_for_trainees"] = "Pulsating swelling";
  manifest["expert_pose"] = identityWith(3, 5.0);
  const auto made = caseFromManifest(manifest, {});
  ASSERT_TRUE(made) << made.error();
  EXPECT_EQ(titleForTrainees(*made), "Pulsating swelling");
  EXPECT_FALSE(made->startPose);
  ASSERT_TRUE(made->expertPose);
  EXPECT_EQ(made->expertPose->probeToWorld.matrix[3].x, 5.0);
  EXPECT_TRUE(made->otherFields.empty());
  manifest.erase("title_for_trainees");
  EXPECT_EQ(titleForTrainees(*caseFromManifest(manifest, {})), "Aneurysm") << "a case without one has nothing to hide";
  manifest["expert_pose"] = identityWith(5, 3.0);
  EXPECT_EQ(context(onlyProblem(manifest), "field"), "expert_pose");
  manifest.erase("expert_pose");
  manifest["title_for_trainees"] = "";
  EXPECT_EQ(context(onlyProblem(manifest), "field"), "title_for_trainees");
}

TEST(LoadCase, RefusesANewerFormatAndNamesBothNumbers) {
  json manifest = smallest();
  manifest["format"] = 7;
  manifest["title"] = 12;  // whatever a newer format does with other fields must not be judged
  const Error problem = onlyProblem(manifest);
  EXPECT_EQ(problem.code, ErrorCode::newerFormat);
  EXPECT_NE(problem.sentence().find('7'), std::string::npos);
  EXPECT_NE(problem.sentence().find(std::to_string(kCaseFormat)), std::string::npos);
}

TEST(LoadCase, SaysOfEachBadFieldWhatWasFoundAndWhatIsExpected) {
  struct Wrong {
    const char* pointer;
    json value;
    const char* field;
    const char* found;
    const char* expected;
  };
  const Wrong wrongs[] = {
      {"/title", 12, "title", "12", "1 to 200 characters"},
      {"/title", "", "title", "\"\"", "1 to 200 characters"},
      {"/id", "../x", "id", "\"../x\"", "letters, digits"},
      {"/format", 0, "format", "0", "from 1"},
      {"/format", 1.5, "format", "1.5", "whole number"},
      {"/patient/age_years", 200, "patient.age_years", "200", "0 to 130"},
      {"/patient/age_years", "old", "patient.age_years", "\"old\"", "0 to 130"},
      {"/patient/sex", "yes", "patient.sex", "\"yes\"", "female"},
      {"/volume/recipe_spacing_mm", 0, "volume.recipe_spacing_mm", "0", "0.1 to 10"},
      {"/volume/file_to_world", json::array({1, 2}), "volume.file_to_world", "[1,2]", "16 numbers"},
      {"/start_pose", "here", "start_pose", "\"here\"", "16 numbers"},
      {"/start_pose", identityWith(3, 0), "", "", ""},  // valid: the identity
      {"/probes", json::array({"convex-3.5", 3}), "probes[1]", "3", "probe id"},
      {"/scene", true, "scene", "true", "an object"},
      {"/scene/gain_and_dgc", "on", "scene.gain_and_dgc", "\"on\"", "true or false"},
      {"/volume", json::array(), "volume", "[]", "an object"},
  };
  for (const auto& wrong : wrongs) {
    json manifest = smallest();
    manifest[json::json_pointer(wrong.pointer)] = wrong.value;
    if (std::string(wrong.field).empty()) continue;
    const Error problem = onlyProblem(manifest);
    EXPECT_EQ(problem.code, ErrorCode::badField) << problem;
    EXPECT_EQ(context(problem, "field"), wrong.field) << problem;
    EXPECT_EQ(context(problem, "found"), wrong.found) << problem;
    EXPECT_NE(context(problem, "expected").find(wrong.expected), std::string::npos) << problem;
    EXPECT_NE(problem.sentence().find(wrong.field), std::string::npos) << problem;
    EXPECT_NE(problem.sentence().find(wrong.found), std::string::npos) << problem;
  }
}

TEST(LoadCase, NamesEachMissingFieldThatACaseNeeds) {
  for (const char* field : {"format", "id", "title", "volume"}) {
    json manifest = smallest();
    manifest.erase(field);
    const Error problem = onlyProblem(manifest);
    EXPECT_EQ(context(problem, "field"), field);
    EXPECT_NE(problem.sentence().find("missing"), std::string::npos) << problem;
  }
}

TEST(LoadCase, TakesAFileOrARecipeButNotBothAndWaitsForEither) {
  json both = smallest();
  both["volume"]["recipe"] = "patient.json";
  const Error problem = onlyProblem(both);
  EXPECT_EQ(context(problem, "field"), "volume");
  EXPECT_NE(problem.sentence().find("a file or a recipe, not both"), std::string::npos) << problem;
  json neither = smallest();
  neither["volume"] = json::object();
  const auto waiting = caseFromManifest(neither, {});
  ASSERT_TRUE(waiting) << waiting.error();
  EXPECT_TRUE(hasNoVolume(*waiting));
  EXPECT_EQ(json(manifestOf(*waiting))["volume"], json({{"file_to_world", identityWith(0, 1.0)}}));
  const auto loaded = loadCaseVolume(*waiting, noProgress());
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().code, ErrorCode::emptyVolume);
}

TEST(LoadCase, RefusesAPlaceThatIsNotRigid) {
  for (const auto& rows : {identityWith(0, 2.0), identityWith(0, -1.0), identityWith(1, 0.5), identityWith(15, 2.0)}) {
    json manifest = smallest();
    manifest["volume"]["file_to_world"] = rows;
    const Error problem = onlyProblem(manifest);
    EXPECT_EQ(problem.code, ErrorCode::notRigid);
    EXPECT_EQ(context(problem, "field"), "volume.file_to_world");
  }
  json manifest = smallest();
  manifest["start_pose"] = identityWith(5, 3.0);
  EXPECT_EQ(context(onlyProblem(manifest), "field"), "start_pose");
}

TEST(ValidateCase, ListsAllProblemsAtOnce) {
  const TemporaryFolder folder;
  json manifest = smallest();
  manifest["title"] = 3;
  manifest["patient"] = {{"sex", 4}, {"age_years", -1}};
  manifest.erase("id");
  makeCase(folder.path(), manifest);
  std::vector<std::string> fields;
  for (const auto& problem : validateCase(folder.path())) fields.push_back(context(problem, "field"));
  std::sort(fields.begin(), fields.end());
  EXPECT_EQ(fields, (std::vector<std::string>{"id", "patient.age_years", "patient.sex", "title"}));
}

TEST(LoadCase, SaysWhereBrokenJsonBreaks) {
  const TemporaryFolder folder;
  writeText(folder / "case.json", "{\n  \"format\": 1,\n  \"id\" \"x\"\n}");
  const auto opened = loadCase(folder.path());
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, ErrorCode::badHeader);
  EXPECT_EQ(context(opened.error(), "line"), "3");
  EXPECT_EQ(loadCase(folder / "nowhere").error().code, ErrorCode::notFound);
  std::filesystem::remove(folder / "case.json");
  const auto empty = loadCase(folder.path());
  EXPECT_EQ(empty.error().code, ErrorCode::notFound);
  EXPECT_NE(empty.error().sentence().find("case.json"), std::string::npos);
}

TEST(LoadCase, NamesAFileThatIsNotThere) {
  json manifest = smallest();
  manifest["volume"]["file"] = "volumes/b.mha";
  const Error problem = onlyProblem(manifest);
  EXPECT_EQ(problem.code, ErrorCode::notFound);
  EXPECT_EQ(context(problem, "field"), "volume.file");
  manifest = smallest();
  manifest["mannequin"] = "nobody.json";
  EXPECT_EQ(context(onlyProblem(manifest), "field"), "mannequin");
}

TEST(SaveCase, KeepsUnknownFieldsWhereTheyWere) {
  const TemporaryFolder folder;
  json manifest = smallest();
  manifest["lesson"] = {{"steps", {1, 2, 3}}};
  manifest["patient"] = {{"name", "A"}, {"weight_kg", 70.5}};
  manifest["volume"]["licence"] = "CC0";
  manifest["scene"] = {{"gain_and_dgc", false}, {"shadow", true}};
  makeCase(folder.path(), manifest);
  auto opened = loadCase(folder.path());
  ASSERT_TRUE(opened) << opened.error();
  opened->title = "Another";
  ASSERT_TRUE(saveCase(*opened, folder.path()));
  const json saved = json::parse(textOf(folder / "case.json"));
  EXPECT_EQ(saved["lesson"], manifest["lesson"]);
  EXPECT_EQ(saved["patient"]["weight_kg"], 70.5);
  EXPECT_EQ(saved["volume"]["licence"], "CC0");
  EXPECT_EQ(saved["scene"]["shadow"], true);
  EXPECT_EQ(saved["title"], "Another");
  EXPECT_EQ(loadCase(folder.path())->otherFields, opened->otherFields);
}

TEST(LoadCase, ReadsTheFormerFormatAndSavesTheOneOfToday) {
  json former = smallest();
  former["format"] = 1;
  former["previous_examinations"] = {{{"when", "in May"}, {"kind", "ultrasound"}, {"findings", "None."}},
                                     {{"when", "in June"}, {"kind", "laboratory"}, {"findings", "Lipase 40 U/l."}, {"by", "x"}}};
  const TemporaryFolder folder;
  makeCase(folder.path(), former);
  EXPECT_TRUE(validateCase(folder.path()).empty());
  const auto opened = loadCase(folder.path());
  ASSERT_TRUE(opened) << opened.error();
  ASSERT_EQ(opened->previousExaminations.size(), 1u);
  ASSERT_EQ(opened->laboratory.size(), 1u);
  EXPECT_EQ(opened->laboratory[0].when, "in June");
  EXPECT_EQ(opened->laboratory[0].findings, "Lipase 40 U/l.");
  EXPECT_EQ(opened->laboratory[0].otherFields["by"], "x");
  ASSERT_TRUE(saveCase(*opened, folder.path()));
  EXPECT_EQ(json::parse(textOf(folder / "case.json"))["format"], kOpenCaseFormat);
  EXPECT_EQ(*loadCase(folder.path()), *opened);
}

TEST(LoadCase, ReadsWhatATraineeIsToldAndWhatIsExpectedOfARecordedVolume) {
  json manifest = smallest();
  manifest["complaint"] = "It hurts.";
  manifest["laboratory"] = {{{"when", "today"}, {"findings", "CRP 5 mg/l."}}};
  manifest["differential"] = {"Gastritis", "Ulcer"};
  manifest["difficulty"] = 4;
  manifest["tags"] = {"liver", "first steps"};
  manifest["volume"]["labels"] = "volumes/a.mha";
  manifest["previous_examinations"] = {{{"when", "in May"}, {"pictures", {"patient.json"}}}};
  manifest["targets"] = {{{"kind", "structure"}, {"name", "vein"}, {"label", 7}}};
  manifest["measurements"] = {
      {{"name", "vein"}, {"value", 9.5}, {"kind", "distance"}, {"unit", "mm"}, {"tolerance", 1}, {"points_mm", {{1, 2, 3}, {4, 5, 6}}}}};
  const TemporaryFolder folder;
  makeCase(folder.path(), manifest);
  const auto opened = loadCase(folder.path());
  ASSERT_TRUE(opened) << opened.error();
  EXPECT_EQ(opened->complaint, "It hurts.");
  EXPECT_EQ(opened->differential, (std::vector<std::string>{"Gastritis", "Ulcer"}));
  EXPECT_EQ(opened->difficulty, 4);
  EXPECT_EQ(opened->tags.size(), 2u);
  EXPECT_EQ(opened->previousExaminations[0].images.front(), "patient.json");
  EXPECT_EQ(opened->targets[0].label, 7);
  EXPECT_EQ(opened->measurements[0].value, 9.5);
  EXPECT_EQ(opened->measurements[0].points_mm[1], glm::dvec3(4, 5, 6));
  ASSERT_TRUE(saveCase(*opened, folder.path()));
  EXPECT_EQ(*loadCase(folder.path()), *opened);

  json without = manifest;
  without["measurements"][0].erase("value");
  EXPECT_EQ(context(onlyProblem(without), "field"), "measurements[0].value");
  without = manifest;
  without["volume"].erase("labels");
  EXPECT_EQ(context(onlyProblem(without), "field"), "targets[0].label");
  without = manifest;
  without["previous_examinations"][0]["pictures"] = {"../secret.png"};
  EXPECT_EQ(context(onlyProblem(without), "field"), "previous_examinations[0].pictures");
}

json withSweeps() {
  json manifest = smallest();
  manifest["volume"] = {{"recipe", "patient.json"},
                        {"sweeps", {"sweeps/a.json", "sweeps/b.json"}},
                        {"reconstruct", {{"spacing_mm", 0.5}, {"compounding", "maximum"}, {"later", {1, 2}}}}};
  manifest["previous_examinations"] = {{{"when", "a year ago"}, {"kind", "ultrasound"}, {"findings", "None."}, {"place", "here"}}};
  manifest["findings"] = {"One.", "Two."};
  manifest["targets"] = {{{"kind", "point"}, {"name", "p"}, {"at_mm", {1, 2, 3}}, {"tolerance_mm", 4}, {"hint", "x"}},
                         {{"kind", "plane"}, {"name", "long"}, {"angle_tolerance_deg", 20}},
                         {{"kind", "plane"}, {"name", "own"}, {"probe_to_world", rowsOf(glm::dmat4(1.0))}},
                         {{"kind", "structure"}, {"name", "the stone"}, {"organ", "gall stone"}}};
  manifest["measurements"] = {{{"name", "stone"}, {"tolerance", 2}, {"why", "y"}}, {{"name", "duct"}}};
  return manifest;
}

void makeSweptCase(const std::filesystem::path& folder, const json& manifest) {
  makeCase(folder, manifest);
  for (const char* name : {"sweeps/a.json", "sweeps/b.json"}) writeText(folder / name, "{}");
}

TEST(LoadCase, ReadsSweepsTargetsAndWhatIsExpected) {
  const TemporaryFolder folder;
  makeSweptCase(folder.path(), withSweeps());
  const auto opened = loadCase(folder.path());
  ASSERT_TRUE(opened) << opened.error();
  EXPECT_EQ(opened->volume.sweeps, (std::vector<std::string>{"sweeps/a.json", "sweeps/b.json"}));
  EXPECT_EQ(opened->volume.reconstruct.spacing_mm, 0.5);
  EXPECT_EQ(opened->volume.reconstruct.compounding, Compounding::maximum);
  EXPECT_FALSE(opened->volume.reconstruct.interpolation) << "left to the recording";
  ASSERT_EQ(opened->previousExaminations.size(), 1u);
  EXPECT_EQ(opened->previousExaminations[0].when, "a year ago");
  EXPECT_EQ(opened->findings, (std::vector<std::string>{"One.", "Two."}));
  ASSERT_EQ(opened->targets.size(), 4u);
  EXPECT_EQ(opened->targets[0].at_mm, glm::dvec3(1, 2, 3));
  EXPECT_EQ(opened->targets[1].kind, CaseTarget::Kind::plane);
  EXPECT_FALSE(opened->targets[1].probeToFile);
  EXPECT_EQ(opened->targets[1].angleTolerance_deg, 20.0);
  EXPECT_EQ(opened->targets[2].probeToFile, (Transform<frame::File, frame::Probe>{}));
  EXPECT_EQ(opened->targets[3].organ, "gall stone");
  ASSERT_EQ(opened->measurements.size(), 2u);
  EXPECT_EQ(opened->measurements[0].tolerance, 2.0);
  EXPECT_FALSE(opened->measurements[1].tolerance);
}

TEST(SaveCase, KeepsUnknownFieldsOfSweepsTargetsAndMeasurements) {
  const TemporaryFolder folder;
  makeSweptCase(folder.path(), withSweeps());
  const auto opened = loadCase(folder.path());
  ASSERT_TRUE(opened) << opened.error();
  ASSERT_TRUE(saveCase(*opened, folder.path()));
  const auto again = loadCase(folder.path());
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(*again, *opened);
  const json saved = json::parse(textOf(folder / "case.json"));
  EXPECT_EQ(saved["volume"]["reconstruct"]["later"], json({1, 2}));
  EXPECT_EQ(saved["previous_examinations"][0]["place"], "here");
  EXPECT_EQ(saved["targets"][0]["hint"], "x");
  EXPECT_EQ(saved["measurements"][0]["why"], "y");
}

TEST(LoadCase, SaysWhatIsWrongWithSweepsAndTargets) {
  const auto problemOf = [](const char* pointer, const json& value) {
    json manifest = withSweeps();
    manifest[json::json_pointer(pointer)] = value;
    const TemporaryFolder folder;
    makeSweptCase(folder.path(), manifest);
    const auto problems = validateCase(folder.path());
    EXPECT_EQ(problems.size(), 1u) << pointer << " " << value;
    return problems.empty() ? Error{} : problems.front();
  };
  const std::pair<const char*, json> wrong[] = {{"/volume/sweeps", json::array()},
                                                {"/volume/sweeps/1", "sweeps/none.json"},
                                                {"/volume/sweeps/0", "../a.json"},
                                                {"/volume/sweeps", 3},
                                                {"/volume/reconstruct/spacing_mm", 0},
                                                {"/volume/reconstruct/compounding", "median"},
                                                {"/volume/reconstruct/fill_reach_mm", -1},
                                                {"/targets/0/kind", "line"},
                                                {"/targets/0/at_mm", {1, 2}},
                                                {"/targets/2/probe_to_world", std::vector<double>(16, 1.0)},
                                                {"/targets/3", {{"kind", "structure"}, {"name", "x"}}},
                                                {"/targets/0", {{"kind", "point"}, {"name", "x"}}},
                                                {"/measurements/0/tolerance", 0},
                                                {"/measurements/0", {{"tolerance", 1}}},
                                                {"/findings/0", 1},
                                                {"/previous_examinations/0/when", 2019}};
  for (const auto& [pointer, value] : wrong) {
    const Error problem = problemOf(pointer, value);
    EXPECT_FALSE(context(problem, "field").empty()) << pointer;
    EXPECT_TRUE(problem.sentence().ends_with('.')) << problem.sentence();
  }
}

TEST(LoadCase, WantsAPatientForWhatOnlyAPatientKnows) {
  json manifest = smallest();
  manifest["targets"] = {{{"kind", "structure"}, {"name", "x"}, {"organ", "liver"}}};
  EXPECT_EQ(context(onlyProblem(manifest), "field"), "targets[0]");
  manifest = smallest();
  manifest["targets"] = {{{"kind", "plane"}, {"name", "x"}}};
  EXPECT_EQ(context(onlyProblem(manifest), "field"), "targets[0]");
  manifest = smallest();
  manifest["measurements"] = {{{"name", "x"}}};
  EXPECT_EQ(context(onlyProblem(manifest), "field"), "measurements[0].value");
  manifest = smallest();
  manifest["volume"]["sweeps"] = {"patient.json"};
  EXPECT_EQ(context(onlyProblem(manifest), "field"), "volume.sweeps");
  manifest = smallest();
  manifest["volume"]["reconstruct"] = json::object();
  EXPECT_EQ(context(onlyProblem(manifest), "field"), "volume.reconstruct");
}

TEST(SaveCase, RefusesWhatLoadCaseWouldRefuseAndLeavesTheOldFile) {
  const TemporaryFolder folder;
  makeCase(folder.path(), smallest());
  const std::string before = textOf(folder / "case.json");
  const auto opened = loadCase(folder.path());
  ASSERT_TRUE(opened);
  const auto refused = [&](auto change) {
    Case edited = *opened;
    change(edited);
    const auto saved = saveCase(edited, folder.path());
    EXPECT_FALSE(saved);
    EXPECT_EQ(textOf(folder / "case.json"), before);
    return saved ? ErrorCode::internal : saved.error().code;
  };
  EXPECT_EQ(refused([](Case& c) { c.title.clear(); }), ErrorCode::badField);
  EXPECT_EQ(refused([](Case& c) { c.patient.age_years = -3; }), ErrorCode::badField);
  EXPECT_EQ(refused([](Case& c) { c.volume.file = "../../etc/passwd"; }), ErrorCode::badField);
  EXPECT_EQ(refused([](Case& c) { c.volume.fileToWorld.matrix[0][0] = std::nan(""); }), ErrorCode::notRigid);
  EXPECT_EQ(refused([](Case& c) { c.volume.fileToWorld.matrix[0][0] = 3.0; }), ErrorCode::notRigid);
  EXPECT_EQ(refused([](Case& c) { c.history = "\xff\xfe not UTF-8"; }), ErrorCode::badField);
}

TEST(SaveCase, LeavesTheOldFileWholeWhenTheProcessDiesWhileSaving) {
  const TemporaryFolder folder;
  makeCase(folder.path(), smallest());
  const std::string before = textOf(folder / "case.json");
  auto opened = loadCase(folder.path());
  ASSERT_TRUE(opened);
  // A history longer than a file may become: the kernel kills the child with SIGXFSZ in the middle of writing.
  opened->history = std::string(600'000, 'x');
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
    const rlimit small{100'000, 100'000};
    ::setrlimit(RLIMIT_FSIZE, &small);
    static_cast<void>(saveCase(*opened, folder.path()));
    ::_exit(0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status)) << "the child was meant to die while it saved";
  EXPECT_EQ(textOf(folder / "case.json"), before);
  const auto again = loadCase(folder.path());
  ASSERT_TRUE(again);
  EXPECT_EQ(again->history, "");
}

TEST(SaveCase, CopiesTheWholeCaseWhenItIsSavedElsewhere) {
  const TemporaryFolder folder;
  makeCase(folder / "old", smallest());
  writeText(folder / "old/media/picture.txt", "an image");
  auto opened = loadCase(folder / "old");
  ASSERT_TRUE(opened);
  opened->title = "The copy";
  ASSERT_TRUE(saveCase(*opened, folder / "new"));
  EXPECT_EQ(loadCase(folder / "new")->title, "The copy");
  EXPECT_EQ(loadCase(folder / "old")->title, "One");
  EXPECT_EQ(textOf(folder / "new/media/picture.txt"), "an image");
  // A second time would overwrite: refused, and nothing aside stays behind.
  EXPECT_EQ(saveCase(*opened, folder / "new").error().code, ErrorCode::notWritable);
  EXPECT_EQ(saveCase(*opened, folder / "old/inside").error().code, ErrorCode::notWritable);
  std::size_t entries = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) ++entries;
  EXPECT_EQ(entries, 2u);
}

TEST(SaveCase, CopiesACaseThatWasOpenedThroughALinkedFolder) {
  const TemporaryFolder folder;
  makeCase(folder / "old", smallest());
  writeText(folder / "old/media/picture.txt", "an image");
  std::filesystem::create_directory_symlink("old", folder / "link");
  const auto opened = loadCase(folder / "link");
  ASSERT_TRUE(opened);
  const auto saved = saveCase(*opened, folder / "new");
  ASSERT_TRUE(saved) << saved.error();
  EXPECT_EQ(loadCase(folder / "new")->title, "One");
  EXPECT_EQ(textOf(folder / "new/media/picture.txt"), "an image");
}

TEST(CaseAsRead, TellsWhetherSomebodyElseHasSavedTheCaseSince) {
  const TemporaryFolder folder;
  makeCase(folder.path(), smallest());
  auto read = readCase(folder.path());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->manifest, *manifestFingerprint(folder.path()));
  EXPECT_EQ(readCase(folder / "case.json")->manifest, read->manifest);
  read->opened.title = "Another";
  ASSERT_TRUE(saveCase(read->opened, folder.path()));
  const auto saved = manifestFingerprint(folder.path());
  ASSERT_TRUE(saved);
  EXPECT_NE(*saved, read->manifest);
  writeText(folder / "case.json", textOf(folder / "case.json"));
  EXPECT_EQ(*manifestFingerprint(folder.path()), *saved) << "the same content written again is no change";
  std::filesystem::remove(folder / "case.json");
  EXPECT_EQ(manifestFingerprint(folder.path()).error().code, ErrorCode::notFound);
}

RC_GTEST_PROP(SaveCase, IsReadBackEqual, ()) {
  const auto text = [] {
    return *rc::gen::container<std::string>(rc::gen::oneOf(rc::gen::inRange<char>(32, 127), rc::gen::element('\n', '\t')));
  };
  const auto angle = [] { return *rc::gen::inRange(-314159, 314159) * 1e-5; };
  const auto matrix = [&] {
    glm::dmat4 m = glm::rotate(glm::dmat4(1.0), angle(), glm::dvec3(1, 0, 0)) * glm::rotate(glm::dmat4(1.0), angle(), glm::dvec3(0, 0, 1));
    m[3] = glm::dvec4(*rc::gen::inRange(-99999, 99999) * 0.0137, *rc::gen::inRange(-99999, 99999) / 3.0, 1e-17, 1.0);
    return m;
  };
  const TemporaryFolder folder;
  makeCase(folder.path(), smallest());
  Case made;
  made.id = "a" + std::to_string(*rc::gen::inRange(0, 1000000));
  made.title = "T" + text().substr(0, 100);
  made.region = text().substr(0, 100);
  made.patient = {text().substr(0, 100), *rc::gen::element<std::string>("", "female", "male", "other"), {}};
  if (*rc::gen::arbitrary<bool>()) made.patient.age_years = *rc::gen::inRange(0, 131);
  made.history = text();
  made.indication = text();
  made.diagnosis = text();
  (*rc::gen::arbitrary<bool>() ? made.volume.file : made.volume.recipe) = "patient.json";
  made.volume.recipeSpacing_mm = *rc::gen::inRange(1, 100) * 0.1;
  made.volume.fileToWorld = {matrix()};
  if (!made.volume.recipe.empty() && *rc::gen::arbitrary<bool>()) {
    made.volume.sweeps = {"volumes/a.mha"};
    made.volume.reconstruct = {
        *rc::gen::inRange(1, 100) * 0.1,
        *rc::gen::element(Interpolation::nearest, Interpolation::linear),
        *rc::gen::element(Compounding::mean, Compounding::maximum, Compounding::latest),
        *rc::gen::inRange(0, 300) * 0.1,
        *rc::gen::element(stitching::SeamMethod::feather, stitching::SeamMethod::nearest, stitching::SeamMethod::graphCut),
        *rc::gen::inRange(0, 1000) * 0.1,
        *rc::gen::inRange(1, 100) * 0.1};
    if (*rc::gen::arbitrary<bool>()) made.volume.reconstruct.spacing_mm.reset();
    if (*rc::gen::arbitrary<bool>()) made.volume.reconstruct.compounding.reset();
    if (*rc::gen::arbitrary<bool>()) made.volume.reconstruct.fillReach_mm.reset();
    made.measurements = {{"m" + text().substr(0, 99), *rc::gen::inRange(1, 100) * 0.1}, {"n", {}, true}};
    made.targets = {
        {.kind = CaseTarget::Kind::structure, .name = "s" + text().substr(0, 99), .organ = "o" + text(), .revealsFinding = true},
        {.kind = CaseTarget::Kind::plane,
         .name = "p",
         .probeToFile = Transform<frame::File, frame::Probe>{matrix()},
         .angleTolerance_deg = 3.5},
        {.kind = CaseTarget::Kind::point, .name = "q", .at_mm = glm::dvec3(1.0 / 3.0, 2, -1e-9), .tolerance_mm = 0.7}};
  }
  if (*rc::gen::arbitrary<bool>()) made.findings = {text(), text()};
  if (*rc::gen::arbitrary<bool>()) made.previousExaminations = {{text(), text(), text()}};
  made.probes = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>("convex-3.5", "linear-7.5"));
  made.scene.gainAndDgc = *rc::gen::arbitrary<bool>();
  if (*rc::gen::arbitrary<bool>()) made.startPose = Pose{{matrix()}};
  if (*rc::gen::arbitrary<bool>()) made.expertPose = Pose{{matrix()}};
  if (*rc::gen::arbitrary<bool>()) made.titleForTrainees = "t" + text().substr(0, 99);
  if (*rc::gen::arbitrary<bool>()) made.otherFields["x_" + std::to_string(*rc::gen::inRange(0, 9))] = {{"deep", text()}};
  if (*rc::gen::arbitrary<bool>()) made.otherFields["volume"] = {{"source", text()}};
  made.folder = folder.path();
  const auto saved = saveCase(made, folder.path());
  if (!saved) RC_FAIL(saved.error().sentence());
  const auto read = loadCase(folder.path());
  if (!read) RC_FAIL(read.error().sentence());
  RC_ASSERT(*read == made);
  RC_ASSERT(caseFromManifest(manifestOf(made), made.folder) == made);
}

}  // namespace
}  // namespace ew::case_test
