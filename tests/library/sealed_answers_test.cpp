#include "ew/library/sealed_answers.h"

#include <gtest/gtest.h>

#include "access/sealed_file.h"
#include "ew/library/bundle.h"
#include "ew/library/case_start.h"
#include "ew/library/case_words.h"
#include "ew/library/lesson_links.h"
#include "ew/library/step_answer.h"
#include "library/examination_world.h"

namespace ew::test::sealed_answers_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TEST(SealedAnswers, GiveTheWholeCaseBackToTheByte) {
  const ExaminationWorld world;
  const auto opened = openExamination(world.place(), world.key, world.folder / "again");
  ASSERT_TRUE(opened) << opened.error();
  EXPECT_EQ(filesInFolder(world.folder / "again"), filesInFolder(world.folder / "case"));
  EXPECT_EQ(opened->caseId, "secretid");
  EXPECT_EQ(opened->examinationId, world.made.id);
  EXPECT_EQ(opened->lessons.at("lesson-1").id, "secretlesson");
  EXPECT_EQ(opened->lessons.at("lesson-1").steps.at("step-3"), "secretstep-plane");
}

TEST(SealedAnswers, OfAVirtualPatientTakeItsRecipeAlong) {
  const TemporaryFolder folder;
  const EnvironmentValue cache("ECHOWEAVE_CACHE", (folder / "cache").string());
  makeSmallCase(folder / "case");
  json manifest = json::parse(textOf(folder / "case/case.json"));
  manifest["title_for_trainees"] = "A ball";
  manifest["parts"]["lessons"] = {
      {"format", 1},
      {"lessons", {{{"id", "l"}, {"title", "L"}, {"steps", {{{"id", "s"}, {"title", "S"}, {"task", "plane"}, {"target", "across"}}}}}}}};
  writeText(folder / "case/case.json", manifest.dump());
  const SecretKey key = *SecretKey::make();
  const auto made = makeExamination(folder / "case", folder / "examination", {.instructors = {key.publicKey()}});
  ASSERT_TRUE(made) << made.error();
  for (const auto& [name, bytes] : filesInFolder(folder / "examination")) {
    EXPECT_EQ(name.find("patient"), std::string::npos) << name;
    EXPECT_EQ(name.find("sweeps"), std::string::npos) << name;
    EXPECT_TRUE(!name.ends_with(".json") || bytes.find("cyst") == std::string::npos) << name;
  }
  const auto view = loadCase(folder / "examination");
  ASSERT_TRUE(view);
  EXPECT_TRUE(view->volume.recipe.empty());
  const auto own = loadCaseVolume(*loadCase(folder / "case"), noProgress());
  const auto theirs = loadCaseVolume(*view, noProgress());
  ASSERT_TRUE(own && theirs);
  EXPECT_EQ(theirs->volume.echo, own->volume.echo) << "what is scanned is the same";
  EXPECT_NEAR(glm::length(theirs->volume.grid.origin_mm - own->volume.grid.origin_mm), 0.0, 1e-6);
  ASSERT_TRUE(openExamination(folder / "examination", key, folder / "again"));
  EXPECT_EQ(filesInFolder(folder / "again"), filesInFolder(folder / "case"));
}

TEST(SealedAnswers, LeaveTraineesWhatTheyNeedToWork) {
  const ExaminationWorld world;
  const auto view = loadCase(world.place());
  ASSERT_TRUE(view) << view.error();
  ASSERT_TRUE(view->sealed);
  EXPECT_EQ(view->sealed->sha256, world.made.sealedSha256);
  EXPECT_EQ(view->title, "A joint");
  EXPECT_EQ(view->patient.age_years, 41);
  EXPECT_EQ(view->history, "She fell.");
  EXPECT_EQ(view->previousExaminations.at(0).images.at(0), "media/picture-1.png");
  EXPECT_TRUE(view->startPose);
  EXPECT_EQ(presetsOf(*view), std::vector<std::string>{"abdomen-convex-3.5"}) << "the console stands as in training";
  const auto lessons = lessonsOf(*view);
  ASSERT_TRUE(lessons) << lessons.error();
  ASSERT_EQ(lessons->size(), 1u);
  EXPECT_EQ(lessons->at(0).title, "An examination");
  ASSERT_EQ(lessons->at(0).steps.size(), 8u);
  EXPECT_EQ(world.made.steps, 8u);
  EXPECT_EQ(world.made.leftOut, 2u);
  const LessonStep& answer = lessons->at(0).steps.at(5);
  EXPECT_EQ(answer.text, "What is it?");
  EXPECT_EQ(std::get<AnswerTask>(answer.task).options.at(1).text, "Another thing");
  EXPECT_FALSE(std::get<AnswerTask>(answer.task).options.at(0).right);
  EXPECT_EQ(lessons->at(0).steps.at(1).time_s, 120.0);
  EXPECT_TRUE(lessons->at(0).steps.at(1).aids.ownPath);
  EXPECT_FALSE(lessons->at(0).steps.at(1).aids.compass);
  EXPECT_EQ(wordsOf(world.place(), "de").of("What is it?"), "Was ist es?");
  EXPECT_TRUE(loadCaseVolume(*view, noProgress()));
}

TEST(SealedAnswers, MakeOneLabelOfTissuesThatSoundAlike) {
  const ExaminationWorld world;
  const auto view = loadCase(world.place());
  ASSERT_TRUE(view);
  ASSERT_EQ(view->scene.tissues.size(), 1u);
  EXPECT_EQ(view->scene.tissues.at(0).name, "");
  const auto echo = loadCaseVolume(*view, noProgress());
  ASSERT_TRUE(echo && echo->labels);
  const std::set<int> labels(echo->labels->echo.begin(), echo->labels->echo.end());
  EXPECT_EQ(labels, (std::set<int>{0, 1, 2})) << "nothing, what no tissue is known of, and both tissues as one";
}

TEST(SealedAnswers, AreNotBesideWhatTraineesHaveInTheBundle) {
  const ExaminationWorld world;
  ASSERT_TRUE(exportBundle(world.place(), world.folder / "e.ewcase"));
  const auto files = filesInBundle(world.folder / "e.ewcase");
  EXPECT_TRUE(files.contains("answers.sealed"));
  for (const std::string& word : kAnswerWords) EXPECT_EQ(placeOf(word, files), "") << word;
  for (const std::string& number : kAnswerNumbers) EXPECT_EQ(placeOf(number, files), "") << number;
  const auto original = filesInFolder(world.folder / "case");
  for (const std::string& word : kAnswerWords) EXPECT_NE(placeOf(word, original), "") << word << " is looked for and was never there";
  for (const std::string& number : kAnswerNumbers) EXPECT_NE(placeOf(number, original), "") << number;
}

TEST(Examination, IsNeverReplacedByAnotherExportForItsFileHoldsTheOnlyAnswers) {
  const TemporaryFolder folder;
  makeAnsweredCase(folder / "case");
  const SecretKey key = *SecretKey::make();
  const fs::path file = folder / "final.ewcase";
  EXPECT_FALSE(holdsExamination(file));
  ASSERT_TRUE(exportExamination(folder / "case", file, {.instructors = {key.publicKey()}}));
  EXPECT_TRUE(holdsExamination(file));
  const std::string kept = textOf(file);
  const auto again = exportExamination(folder / "case", file, {.instructors = {key.publicKey()}});
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().code, ErrorCode::badUsage);
  const auto bundle = exportBundle(folder / "case", file);
  ASSERT_FALSE(bundle);
  EXPECT_EQ(bundle.error().code, ErrorCode::badUsage);
  EXPECT_EQ(textOf(file), kept);
  // A case's bundle is made anew whenever that is wanted.
  ASSERT_TRUE(exportBundle(folder / "case", folder / "practice.ewcase"));
  EXPECT_FALSE(holdsExamination(folder / "practice.ewcase"));
  EXPECT_TRUE(exportBundle(folder / "case", folder / "practice.ewcase"));
}

TEST(SealedAnswers, AreThereForEachOfSeveralInstructorsAndForNobodyElse) {
  const TemporaryFolder folder;
  makeAnsweredCase(folder / "case");
  const SecretKey one = *SecretKey::make(), two = *SecretKey::make(), stranger = *SecretKey::make();
  ASSERT_TRUE(makeExamination(folder / "case", folder / "e", {.instructors = {one.publicKey(), two.publicKey()}, .id = "exam-7"}));
  EXPECT_TRUE(openExamination(folder / "e", one, folder / "by-one"));
  EXPECT_TRUE(openExamination(folder / "e", two, folder / "by-two"));
  const auto refused = openExamination(folder / "e", stranger, folder / "by-stranger");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence().find(shortNameOf(one.publicKey())), std::string::npos) << refused.error();
  EXPECT_FALSE(fs::exists(folder / "by-stranger"));
  EXPECT_EQ(readSealedFileHeader(folder / "e" / kSealedName)->forWhom,
            (std::vector<std::string>{shortNameOf(one.publicKey()), shortNameOf(two.publicKey())}));
  EXPECT_EQ(loadCase(folder / "e")->id, "exam-7");
}

TEST(SealedAnswers, ThatWereChangedAnywhereAreNoticed) {
  const ExaminationWorld world;
  const std::string whole = textOf(world.place() / kSealedName), manifest = textOf(world.place() / "case.json");
  const auto isRefused = [&](const char* what, std::size_t at) {
    const auto opened = openExamination(world.place(), world.key, world.folder / "again");
    EXPECT_FALSE(opened) << what << " " << at;
    EXPECT_FALSE(fs::exists(world.folder / "again")) << "nothing is left behind";
  };
  // Also when whoever changed it corrects the sum in case.json.
  const auto replace = [&](const std::string& bytes) {
    writeText(world.place() / kSealedName, bytes);
    json changed = json::parse(manifest);
    changed["sealed"]["sha256"] = sumOf(bytes);
    writeText(world.place() / "case.json", changed.dump());
  };
  for (std::size_t at = 0; at < whole.size(); at += std::max<std::size_t>(1, whole.size() / 97)) {
    std::string wrong = whole;
    wrong[at] = static_cast<char>(wrong[at] ^ 1);
    replace(wrong);
    isRefused("a bit", at);
  }
  for (const std::size_t length : {std::size_t(0), std::size_t(7), std::size_t(20), whole.size() / 2, whole.size() - 1}) {
    replace(whole.substr(0, length));
    isRefused("cut off", length);
  }
  replace(whole + "x");
  isRefused("more behind it", 0);
  writeText(world.place() / kSealedName, whole);
  writeText(world.place() / "case.json", manifest);
  EXPECT_TRUE(openExamination(world.place(), world.key, world.folder / "again")) << "unchanged it opens";
}

TEST(SealedAnswers, OfAnotherRevisionAreNoticed) {
  const ExaminationWorld world;
  writeText(world.folder / "case/case.json", [&] {
    json changed = json::parse(textOf(world.folder / "case/case.json"));
    changed["diagnosis"] = "Something else.";
    return changed.dump();
  }());
  ASSERT_TRUE(
      makeExamination(world.folder / "case", world.folder / "second", {.instructors = {world.key.publicKey()}, .id = world.made.id}));
  const std::string second = textOf(world.folder / "second" / kSealedName);
  writeText(world.place() / kSealedName, second);
  EXPECT_FALSE(openExamination(world.place(), world.key, world.folder / "a")) << "the sum in case.json says so";
  json manifest = json::parse(textOf(world.place() / "case.json"));
  manifest["sealed"]["sha256"] = sumOf(second);
  manifest["history"] = "Another story.";
  writeText(world.place() / "case.json", manifest.dump());
  EXPECT_FALSE(openExamination(world.place(), world.key, world.folder / "b")) << "the sum inside says so";
}

TEST(SealedAnswers, AreNotJudgedWithAnythingTheTraineeChanged) {
  const ExaminationWorld world;
  json manifest = json::parse(textOf(world.place() / "case.json"));
  manifest["start_pose"][3] = 5.0;
  writeText(world.place() / "case.json", manifest.dump());
  EXPECT_FALSE(openExamination(world.place(), world.key, world.folder / "again"));
}

TEST(Examination, AttemptsAreAtTheCaseOnceTheAnswersAreOpen) {
  const ExaminationWorld world;
  const auto opened = openExamination(world.place(), world.key, world.folder / "again");
  ASSERT_TRUE(opened);
  Attempt attempt;
  attempt.id = "20261126-093000-4f2a91c7";
  attempt.caseId = world.made.id;
  attempt.lessonId = "lesson-1";
  StepOutcome outcome;
  outcome.stepId = "step-3";
  outcome.answer = OptionsAnswer{{1}};
  attempt.outcomes.push_back(outcome);
  EXPECT_FALSE(asAttemptAtTheCase(attempt, *opened)) << "it does not say by which answers it is to be judged";
  attempt = withSealedAnswers(attempt, world.made.sealedSha256);
  EXPECT_EQ(*attemptFromJson(jsonOf(attempt)), attempt) << "it is kept as attempts are";
  const auto original = asAttemptAtTheCase(attempt, *opened);
  ASSERT_TRUE(original) << original.error();
  EXPECT_EQ(original->caseId, "secretid");
  EXPECT_EQ(original->lessonId, "secretlesson");
  EXPECT_EQ(original->outcomes.at(0).stepId, "secretstep-plane");
  EXPECT_EQ(original->outcomes.at(0).answer, attempt.outcomes.at(0).answer);
  Attempt wrong = attempt;
  wrong.outcomes.at(0).stepId = "step-99";
  EXPECT_FALSE(asAttemptAtTheCase(wrong, *opened));
  wrong = attempt;
  wrong.caseId = "another";
  EXPECT_FALSE(asAttemptAtTheCase(wrong, *opened));
}

TEST(Examination, OfAnswersThatATraineeInventedIsNotTheInstructors) {
  // Anybody can seal for a public key. So an attempt is judged with the instructor's own bundle, and says which one its trainee had.
  const ExaminationWorld world;
  ASSERT_TRUE(
      makeExamination(world.folder / "case", world.folder / "forged", {.instructors = {world.key.publicKey()}, .id = world.made.id}));
  const auto own = openExamination(world.place(), world.key, world.folder / "own");
  ASSERT_TRUE(own);
  Attempt attempt;
  attempt.id = "a";
  attempt.caseId = world.made.id;
  attempt.lessonId = "lesson-1";
  attempt = withSealedAnswers(attempt, loadCase(world.folder / "forged")->sealed->sha256);
  EXPECT_FALSE(asAttemptAtTheCase(attempt, *own));
}

TEST(Examination, SaysWhatKeepsItFromBeingMade) {
  const TemporaryFolder folder;
  const SecretKey key = *SecretKey::make();
  const auto problemWith = [&](const std::function<void(json&)>& change, ExaminationOptions options) {
    fs::remove_all(folder / "case");
    makeAnsweredCase(folder / "case");
    json manifest = manifestOfAnsweredCase();
    change(manifest);
    writeText(folder / "case/case.json", manifest.dump());
    const auto made = makeExamination(folder / "case", folder / "e", options);
    EXPECT_FALSE(fs::exists(folder / "e"));
    return made ? std::string() : made.error().sentence();
  };
  const ExaminationOptions good{.instructors = {key.publicKey()}};
  const auto unchanged = [](json&) {};
  EXPECT_NE(problemWith(unchanged, {}).find("for whom"), std::string::npos);
  EXPECT_NE(problemWith(unchanged, {.instructors = {key.publicKey()}, .id = "../up"}).find("cannot be the id"), std::string::npos);
  EXPECT_NE(problemWith([](json& m) { m.erase("title_for_trainees"); }, good).find("title for trainees"), std::string::npos);
  EXPECT_NE(problemWith([](json& m) { m.erase("parts"); }, good).find("nothing to examine"), std::string::npos);
  EXPECT_NE(problemWith([](json& m) { m["parts"]["lessons"]["lessons"][0]["steps"][2]["case"] = "other"; }, good).find("another case"),
            std::string::npos);
  EXPECT_NE(problemWith([](json& m) { m["mannequin"] = "volumes/v.mha"; }, good).find("mannequin of its own"), std::string::npos);
  writeText(folder / "text.png", "no image");
  EXPECT_NE(problemWith([](json& m) { m["previous_examinations"][0]["pictures"][0] = "notes/SECRETFILE.txt"; }, good).find("PNG or JPEG"),
            std::string::npos);
  ASSERT_TRUE(makeExamination((makeAnsweredCase(folder / "fine"), folder / "fine"), folder / "e", good));
  EXPECT_NE(makeExamination(folder / "e", folder / "twice", good).error().sentence().find("already"), std::string::npos);
}

TEST(Examination, ThatWasStoppedLeavesNothing) {
  class Stop final : public Progress {
   public:
    void report(const Message&, double) override { ++reports; }
    [[nodiscard]] bool cancelRequested() const override { return reports >= at; }
    int reports = 0, at = 0;
  };
  const TemporaryFolder folder;
  makeAnsweredCase(folder / "case");
  const SecretKey key = *SecretKey::make();
  for (int at = 0; at < 6; ++at) {
    Stop stop;
    stop.at = at;
    const auto made = makeExamination(folder / "case", folder / "e", {.instructors = {key.publicKey()}}, stop);
    if (made) break;
    EXPECT_EQ(made.error().code, ErrorCode::cancelled);
    EXPECT_FALSE(fs::exists(folder / "e"));
  }
}

}  // namespace
}  // namespace ew::test::sealed_answers_test
