// What a trainee may try: each test is named after one attempt to read an answer key or somebody else's attempt, and shows that it fails.
// The table of all of them is in resources/docs/developer/tests.md; those on the command line are in tests/cli/access_test.cpp, those in
// the window and through a plugin in tests/gui/lessons/access_test.cpp.
#include "ew/library/access.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "access/sealed_file.h"
#include "ew/library/bundle.h"
#include "ew/library/case_start.h"
#include "ew/library/case_truth.h"
#include "ew/library/index.h"
#include "ew/library/instructor_log.h"
#include "ew/library/learning_progress.h"
#include "library/examination_world.h"

namespace ew::test::access_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const Passphrase kWords("correct horse battery");
constexpr uid_t kNobody = 65534;

/// Whether another account of this machine can do something. Needs root, who alone can become another account.
bool anotherAccountCan(const std::function<bool()>& attempt) {
  const pid_t child = ::fork();
  if (child == 0) {
    const bool other = ::setgid(kNobody) == 0 && ::setuid(kNobody) == 0;
    ::_exit(other && attempt() ? 0 : 1);
  }
  int status = 1;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}
bool canRead(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY);
  if (descriptor < 0) return false;
  ::close(descriptor);
  return true;
}
bool canList(const fs::path& folder) {
  std::error_code failed;
  const fs::directory_iterator entries(folder, failed);
  return !failed;
}

// --- An examination's files ---------------------------------------------------------------------------------------------------------

class OfAnExamination : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(exportBundle(world_.place(), bundle())); }
  [[nodiscard]] fs::path bundle() const { return world_.folder / "e.ewcase"; }
  [[nodiscard]] std::map<std::string, std::string> files() const { return filesInBundle(bundle()); }
  [[nodiscard]] json view() const { return json::parse(files().at("case.json")); }
  const ExaminationWorld world_;
};

TEST_F(OfAnExamination, TheBundleIsSearchedForWords) {
  const std::map<std::string, std::string> whole = {{"bundle", textOf(bundle())}};
  for (const std::string& word : kAnswerWords) EXPECT_EQ(placeOf(word, whole), "") << word;
}
TEST_F(OfAnExamination, TheBundleIsUnpackedAndSearchedForWords) {
  for (const std::string& word : kAnswerWords) EXPECT_EQ(placeOf(word, files()), "") << word;
}
TEST_F(OfAnExamination, TheBundleIsUnpackedAndSearchedForNumbers) {
  for (const std::string& number : kAnswerNumbers) EXPECT_EQ(placeOf(number, files()), "") << number;
}
TEST_F(OfAnExamination, NamesOfFilesAreRead) {
  for (const auto& [name, bytes] : files()) EXPECT_EQ(name.find("secret"), std::string::npos) << name;
}
TEST_F(OfAnExamination, IdsOfCaseLessonsAndStepsAreRead) {
  const std::string text = view().dump();
  EXPECT_EQ(text.find("secret"), std::string::npos);
  EXPECT_EQ(view()["parts"]["lessons"]["lessons"][0]["steps"][1]["id"], "step-3");
}
TEST_F(OfAnExamination, TextsInImagesAreRead) {
  const std::string image = files().at("media/picture-1.png");
  EXPECT_EQ(image.find("tEXt"), std::string::npos);
  EXPECT_TRUE(image.ends_with("IEND\xae\x42\x60\x82")) << "nothing stands behind its end";
}
TEST_F(OfAnExamination, TranslationsOfAnswersAreRead) {
  const json words = json::parse(files().at("words/de.json"))["words"];
  EXPECT_EQ(words, (json{{"A joint", "Ein Gelenk"}, {"What is it?", "Was ist es?"}}));
}
TEST_F(OfAnExamination, TheOptionThatIsRightIsLookedFor) {
  std::size_t looked = 0;
  for (const json whole = view(); const json& step : whole["parts"]["lessons"]["lessons"][0]["steps"])
    for (const json& option : step.value("options", json::array())) {
      EXPECT_EQ(option, (json{{"text", option["text"]}, {"right", false}}));
      ++looked;
    }
  EXPECT_EQ(looked, 2u);
}
TEST_F(OfAnExamination, TheTextAfterTheLastQuestionIsRead) {
  for (const json whole = view(); const json& step : whole["parts"]["lessons"]["lessons"][0]["steps"])
    EXPECT_NE(step["title"], "What it was");
}
TEST_F(OfAnExamination, TheExpertsScanIsPlayed) {
  for (const json whole = view(); const json& step : whole["parts"]["lessons"]["lessons"][0]["steps"]) EXPECT_NE(step["task"], "watch");
  EXPECT_EQ(placeOf("scans", files()), "");
}
TEST_F(OfAnExamination, TargetsMeasurementsAndTheExpertsPoseAreLookedFor) {
  for (const char* field : {"targets", "measurements", "expert_pose", "findings", "diagnosis", "differential", "difficulty", "tags"})
    EXPECT_FALSE(view().contains(field)) << field;
}
TEST_F(OfAnExamination, FieldsThatNobodyHasThoughtOfAreRead) {
  EXPECT_EQ(placeOf("SECRETFUTURE", files()), "");
  EXPECT_EQ(placeOf("future", files()), "");
}
TEST_F(OfAnExamination, SectionsOfOtherPluginsAreRead) { EXPECT_EQ(view()["parts"].size(), 1u); }
TEST_F(OfAnExamination, LabelsAreComparedWithTheirNames) {
  ASSERT_EQ(view()["scene"]["tissues"].size(), 1u);
  EXPECT_EQ(view()["scene"]["tissues"][0].value("name", ""), "");
}
TEST_F(OfAnExamination, TheHeaderOfTheVolumeIsRead) {
  for (const auto& [name, bytes] : files())
    if (name.starts_with("volumes/")) {
      const std::string header = bytes.substr(0, bytes.find("ElementDataFile"));
      EXPECT_EQ(header.find("SECRET"), std::string::npos);
      EXPECT_EQ(header.find("Comment"), std::string::npos);
    }
}
TEST_F(OfAnExamination, TheSealedFileIsReadWithoutAKey) {
  const std::string sealed = files().at("answers.sealed");
  const auto header = readSealedFileHeader(world_.place() / kSealedName);
  ASSERT_TRUE(header);
  EXPECT_EQ(header->forWhom.size(), 1u);
  for (const std::string& word : kAnswerWords) EXPECT_EQ(sealed.find(word), std::string::npos) << word;
}
TEST_F(OfAnExamination, TheSealedFileIsOpenedWithAKeyOfTheTrainees) {
  EXPECT_FALSE(openExamination(world_.place(), *SecretKey::make(), world_.folder / "x"));
  EXPECT_FALSE(fs::exists(world_.folder / "x"));
}
TEST_F(OfAnExamination, TheSealedFileIsOpenedWithThePublicKey) {
  const auto asSecret = SecretKey::of(world_.key.publicKey().bytes.data());
  ASSERT_TRUE(asSecret);
  EXPECT_FALSE(openExamination(world_.place(), *asSecret, world_.folder / "x"));
}
TEST_F(OfAnExamination, TheSlotOfAnotherExaminationIsPutIn) {
  // With a key that opens one examination, its slot is put before the content of another.
  const SecretKey own = *SecretKey::make();
  ASSERT_TRUE(makeExamination(world_.folder / "case", world_.folder / "mine", {.instructors = {own.publicKey()}, .id = world_.made.id}));
  const std::string mine = textOf(world_.folder / "mine" / kSealedName), theirs = textOf(world_.place() / kSealedName);
  const auto headerEnd = [](const std::string& bytes) {
    return 16u + static_cast<unsigned char>(bytes[12]) + 256u * static_cast<unsigned char>(bytes[13]);
  };
  const std::string mixed = mine.substr(0, headerEnd(mine)) + theirs.substr(headerEnd(theirs));
  writeText(world_.place() / kSealedName, mixed);
  json manifest = view();
  manifest["sealed"]["sha256"] = sumOf(mixed);
  writeText(world_.place() / "case.json", manifest.dump());
  EXPECT_FALSE(openExamination(world_.place(), own, world_.folder / "x"));
}
TEST_F(OfAnExamination, TheBundleIsTakenIntoALibraryAndLookedAtThere) {
  const auto imported = importBundle(bundle(), world_.folder / "library");
  ASSERT_TRUE(imported);
  const auto there = filesInFolder(world_.folder / "library");
  for (const std::string& word : kAnswerWords) EXPECT_EQ(placeOf(word, there), "") << word;
}
TEST_F(OfAnExamination, TheCacheIsSearchedAfterItsVolumeWasLoaded) {
  const EnvironmentValue cache("ECHOWEAVE_CACHE", (world_.folder / "cache").string());
  fs::create_directories(world_.folder / "cache");
  ASSERT_TRUE(loadCaseVolume(*loadCase(world_.place()), noProgress()));
  ASSERT_TRUE(loadCaseTruth(*loadCase(world_.place()), noProgress()));
  const auto kept = filesInFolder(world_.folder / "cache");
  for (const std::string& word : kAnswerWords) EXPECT_EQ(placeOf(word, kept), "") << word;
}
TEST_F(OfAnExamination, TheIndexOfTheLibraryIsSearched) {
  const auto index = openIndex(world_.folder / "index.db");
  ASSERT_TRUE(index);
  fs::create_directories(world_.folder / "cases");
  fs::rename(world_.place(), world_.folder / "cases/e");
  ASSERT_TRUE((*index)->refresh({{world_.folder / "cases", LibraryKind::own}}, noProgress()));
  for (const bool forTrainees : {true, false})
    for (const char* word : {"SECRETDIAGNOSIS", "SECRETTITLE", "SECRETFINDING", "SECRETTAG"})
      EXPECT_TRUE((*index)->find({.words = word, .forTrainees = forTrainees})->empty()) << word;
  for (const auto& each : fs::directory_iterator(world_.folder.path()))
    for (const std::string& word : kAnswerWords)
      EXPECT_TRUE(!each.path().filename().string().starts_with("index.db") || textOf(each.path()).find(word) == std::string::npos)
          << word << each.path();
}
TEST_F(OfAnExamination, LeftoversOfItsMakingAreLookedFor) {
  for (const auto& each : fs::recursive_directory_iterator(world_.folder.path()))
    EXPECT_FALSE(each.path().filename().string().starts_with(".ew-")) << each.path();
}
TEST_F(OfAnExamination, AttemptsAreJudgedByAnswersOfTheTraineesOwn) {
  ASSERT_TRUE(
      makeExamination(world_.folder / "case", world_.folder / "forged", {.instructors = {world_.key.publicKey()}, .id = world_.made.id}));
  Attempt attempt;
  attempt.id = "a";
  attempt.caseId = world_.made.id;
  attempt.lessonId = "lesson-1";
  attempt = withSealedAnswers(attempt, loadCase(world_.folder / "forged")->sealed->sha256);
  const auto own = openExamination(world_.place(), world_.key, world_.folder / "own");
  ASSERT_TRUE(own);
  EXPECT_FALSE(asAttemptAtTheCase(attempt, *own));
}

/// What an instructor opens may come from anybody: a bundle that says it holds files elsewhere.
TEST_F(OfAnExamination, TheInstructorIsMadeToWriteOutsideOfTheFolder) {
  EXPECT_TRUE(problemOfPath("../outside"));
  EXPECT_TRUE(problemOfPath("/etc/passwd"));
  const auto header = checkFileList({{"../outside", 1, std::string(64, '0')}}, say<"the index of %1">(std::string(kSealedName)));
  EXPECT_FALSE(header);
}

class OfAHandedInAttempt : public OfAnExamination {
 protected:
  void SetUp() override {
    OfAnExamination::SetUp();
    opened_ = openExamination(world_.place(), world_.key, world_.folder / "own");
    ASSERT_TRUE(opened_) << opened_.error();
    writeText(world_.folder / "instructors/notes.txt", "SECRETNOTES");
  }
  /// The trainee's attempt with a step that names a file.
  fs::path attemptNaming(const std::string& recording) {
    Attempt attempt;
    attempt.id = "20261126-093000-4f2a91c7";
    attempt.caseId = world_.made.id;
    attempt.lessonId = "lesson-1";
    attempt = withSealedAnswers(attempt, world_.made.sealedSha256);
    auto kept = AttemptFolder::begin(world_.folder / "theirs", attempt);
    EXPECT_TRUE(kept);
    StepOutcome outcome;
    outcome.stepId = "step-3";
    outcome.verdict = StepVerdict::handedIn;
    outcome.recording = recording;
    EXPECT_TRUE(kept->endStep(outcome));
    return kept->folder();
  }
  Result<OpenExamination> opened_ = failure(ErrorCode::internal, say<"Cancelled.">());
};

TEST_F(OfAHandedInAttempt, AFileOutsideIsNamedAsItsRecording) {
  for (const char* name : {"../../instructors/notes.txt", "/etc/passwd"}) {
    EXPECT_FALSE(takeExamined(attemptNaming(name), *opened_, world_.folder / "scored")) << name;
    EXPECT_FALSE(fs::exists(world_.folder / "scored"));
    fs::remove_all(world_.folder / "theirs");
  }
}
TEST_F(OfAHandedInAttempt, ALinkToTheInstructorsFilesIsNamedAsItsRecording) {
  const fs::path folder = attemptNaming("link.seq.mha");
  fs::create_symlink(world_.folder / "instructors/notes.txt", folder / "link.seq.mha");
  const auto taken = takeExamined(folder, *opened_, world_.folder / "scored");
  ASSERT_TRUE(taken) << taken.error();
  EXPECT_EQ(placeOf("SECRETNOTES", filesInFolder(world_.folder / "scored")), "");
}
TEST_F(OfAHandedInAttempt, IsTakenAsOneAtTheCaseWithItsFiles) {
  const fs::path folder = attemptNaming("step.seq.mha");
  writeText(folder / "step.seq.mha", "raw data");
  const auto taken = takeExamined(folder, *opened_, world_.folder / "scored");
  ASSERT_TRUE(taken) << taken.error();
  EXPECT_EQ(textOf(*taken / "step.seq.mha"), "raw data");
  const auto kept = AttemptFolder::open(*taken);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->attempt().caseId, "secretid");
  EXPECT_EQ(kept->attempt().outcomes.at(0).stepId, "secretstep-plane");
  EXPECT_EQ(sealedAnswersOf(kept->attempt()), "") << "it can be scored now";
  const Attempt theirs = AttemptFolder::open(folder)->attempt();
  EXPECT_EQ(triedAs(kept->attempt()), (TrialIdentity{theirs.caseId, theirs.lessonId})) << "a course that started it knows it again";
  EXPECT_EQ(triedAs(theirs), (TrialIdentity{theirs.caseId, theirs.lessonId}));
  EXPECT_FALSE(takeExamined(folder, *opened_, world_.folder / "scored")) << "once";
}

// --- Another account of the machine -------------------------------------------------------------------------------------------------

class FromAnotherAccount : public ::testing::Test {
 protected:
  void SetUp() override {
    if (::geteuid() != 0) GTEST_SKIP() << "only root can become another account";
    ::umask(0);  // the worst that a user can have set
    ::chmod(folder_.path().c_str(), 0755);
    fs::create_directories(library_);
    ::chmod(library_.c_str(), 0755);
    Attempt attempt;
    attempt.id = "20261126-093000-4f2a91c7";
    attempt.caseId = "case";
    attempt.lessonId = "lesson";
    attempt.person = "Ada";
    auto kept = AttemptFolder::begin(attemptsFolder(library_), attempt);
    ASSERT_TRUE(kept) << kept.error();
    writeText(kept->folder() / "step.seq.mha", "raw");
    StepOutcome outcome;
    outcome.stepId = "s";
    outcome.recording = "step.seq.mha";
    ASSERT_TRUE(kept->endStep(outcome));
    attempt_ = kept->folder();
    ASSERT_TRUE(logChange(library_, "key made"));
    AccessPolicy policy = AccessPolicy::of(library_);
    ASSERT_TRUE(setLock(policy, kWords, {}, kCheapCost));
    ASSERT_TRUE(keepSecretKey(*SecretKey::make(), kWords, folder_ / "keys/instructor.key", kCheapCost));
  }
  void TearDown() override { ::umask(022); }
  const TemporaryFolder folder_;
  const fs::path library_ = folder_ / "library";
  fs::path attempt_;
};

TEST_F(FromAnotherAccount, TheAttemptsAreListed) {
  EXPECT_FALSE(anotherAccountCan([&] { return canList(attemptsFolder(library_)); }));
  EXPECT_TRUE(canList(attemptsFolder(library_)));
}
TEST_F(FromAnotherAccount, AnAttemptWhoseNameIsKnownIsRead) {
  EXPECT_FALSE(anotherAccountCan([&] { return canRead(attempt_ / "attempt.json"); }));
  EXPECT_TRUE(canRead(attempt_ / "attempt.json"));
}
TEST_F(FromAnotherAccount, ARecordingOfAnAttemptIsRead) {
  EXPECT_FALSE(anotherAccountCan([&] { return canRead(attempt_ / "step.seq.mha"); }));
}
TEST_F(FromAnotherAccount, TheAttemptIsOpenedWithTheProgram) {
  EXPECT_FALSE(anotherAccountCan([&] { return AttemptFolder::open(attempt_).has_value(); }));
  EXPECT_FALSE(anotherAccountCan([&] { return !listAttempts(attemptsFolder(library_)).attempts.empty(); }));
}
TEST_F(FromAnotherAccount, AFileIsPlantedAmongTheAttempts) {
  EXPECT_FALSE(anotherAccountCan([&] { return ::mkdir((attemptsFolder(library_) / "planted").c_str(), 0777) == 0; }));
}
TEST_F(FromAnotherAccount, ALinkInAnotherFolderLeadsToTheAttempt) {
  EXPECT_FALSE(anotherAccountCan([&] {
    const std::string link = "/tmp/ew-link-" + std::to_string(::getpid());
    if (::symlink((attempt_ / "attempt.json").c_str(), link.c_str()) != 0) return false;
    const bool read = canRead(link);
    ::unlink(link.c_str());
    return read;
  }));
}
TEST_F(FromAnotherAccount, TheInstructorsKeyIsRead) {
  EXPECT_FALSE(anotherAccountCan([&] { return canRead(folder_ / "keys/instructor.key") || canList(folder_ / "keys"); }));
}
TEST_F(FromAnotherAccount, TheHashOfThePassphraseIsRead) {
  EXPECT_FALSE(anotherAccountCan([&] { return canRead(accessFile(library_)); }));
}
TEST_F(FromAnotherAccount, TheLockIsTakenAway) {
  EXPECT_FALSE(anotherAccountCan([&] { return ::unlink(accessFile(library_).c_str()) == 0; }));
}
TEST_F(FromAnotherAccount, TheInstructorsLogIsRead) {
  EXPECT_FALSE(anotherAccountCan([&] { return canRead(instructorLogFile(library_)) || canList(assessmentFolder(library_)); }));
}
TEST_F(FromAnotherAccount, TheLibrarySeemsLockedAndStaysSo) {
  EXPECT_TRUE(anotherAccountCan([&] {
    AccessPolicy policy = AccessPolicy::of(library_);
    return policy.isLocked() && !policy.unlock(kWords);  // its passphrase file is not theirs to read
  }));
}

// --- The lock on a shared account ---------------------------------------------------------------------------------------------------

class WhileLocked : public ::testing::Test {
 protected:
  void SetUp() override {
    AccessPolicy policy = AccessPolicy::of(library_);
    const auto refused = setLock(policy, Passphrase("abc"), "Anna", kCheapCost);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find("too short"), std::string::npos);
    ASSERT_FALSE(policy.hasLock()) << "three letters lock nothing";
    ASSERT_TRUE(setLock(policy, kWords, "Anna", kCheapCost));
  }
  [[nodiscard]] AccessPolicy policy() const { return AccessPolicy::of(library_); }
  [[nodiscard]] std::vector<std::string> logged() const {
    std::vector<std::string> what;
    const auto log = readInstructorLog(library_);
    EXPECT_TRUE(log);
    if (log)
      for (const auto& each : log->changes) what.push_back(each.what);
    return what;
  }
  const TemporaryFolder folder_;
  const fs::path library_ = folder_ / "library";
};

TEST_F(WhileLocked, NothingThatIsAnInstructorsMayBeDone) {
  for (const Permission each : {Permission::seeAnswers, Permission::editCases, Permission::exportCases, Permission::seeOthersAttempts,
                                Permission::judge, Permission::changeLock}) {
    EXPECT_FALSE(policy().may(each));
    EXPECT_NE(policy().require(each).error().sentence().find("locked for trainees"), std::string::npos);
  }
}
TEST_F(WhileLocked, ThePassphraseIsGuessed) {
  AccessPolicy guessed = policy();
  for (const char* words : {"", "correct horse", "Correct horse battery", "correct horse battery\n", "passphrase"})
    EXPECT_FALSE(guessed.unlock(Passphrase(words))) << words;
  EXPECT_TRUE(guessed.isLocked());
  EXPECT_EQ(logged(), (std::vector<std::string>{"lock set", "wrong passphrase", "wrong passphrase", "wrong passphrase", "wrong passphrase",
                                                "wrong passphrase"}))
      << "each is written down";
}
TEST_F(WhileLocked, TheHashIsGivenAsThePassphrase) {
  const std::string hash = json::parse(textOf(accessFile(library_)))["passphrase"];
  AccessPolicy tried = policy();
  EXPECT_FALSE(tried.unlock(Passphrase(hash)));
}
TEST_F(WhileLocked, TheLockFileIsDamaged) {
  for (const char* content : {"", "{", "{}", R"({"format": 1})", R"({"format": 99, "passphrase": "x"})",
                              R"({"format": 1, "passphrase": ""})", R"({"format": 1, "passphrase": "correct horse battery"})"}) {
    writeText(accessFile(library_), content);
    AccessPolicy tried = policy();
    EXPECT_TRUE(tried.isLocked()) << content;
    EXPECT_FALSE(tried.unlock(kWords)) << content;
    EXPECT_FALSE(tried.unlock(Passphrase("x"))) << content;
  }
}
TEST_F(WhileLocked, TheLockFileIsOpenedToOthers) {
  ::chmod(accessFile(library_).c_str(), 0666);
  AccessPolicy tried = policy();
  EXPECT_TRUE(tried.isLocked());
  const auto refused = tried.unlock(kWords);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence().find("chmod 600"), std::string::npos);
}
TEST_F(WhileLocked, TheLockFileIsExchangedForALinkToOnesOwn) {
  writeText(folder_ / "own.json", json{{"format", 1}, {"passphrase", *hashOf(Passphrase("my own words"), kCheapCost)}}.dump());
  ::chmod((folder_ / "own.json").c_str(), 0600);
  fs::remove(accessFile(library_));
  fs::create_symlink(folder_ / "own.json", accessFile(library_));
  AccessPolicy tried = policy();
  EXPECT_FALSE(tried.unlock(Passphrase("my own words")));
  EXPECT_TRUE(tried.isLocked());
}
TEST_F(WhileLocked, TheLockFileIsExchangedForAFolder) {
  fs::remove(accessFile(library_));
  fs::create_directory(accessFile(library_));
  EXPECT_TRUE(policy().isLocked());
}
TEST_F(WhileLocked, ANewLockIsSetOverTheOldOne) {
  AccessPolicy tried = policy();
  EXPECT_FALSE(setLock(tried, Passphrase("my own words"), {}, kCheapCost));
  AccessPolicy before;  // made when there was no lock yet
  EXPECT_TRUE(AccessPolicy::of(library_).unlock(kWords));
}
TEST_F(WhileLocked, TheLockIsTakenAwayWithThePolicyOfBefore) {
  const TemporaryFolder other;
  AccessPolicy before = AccessPolicy::of(other / "library");  // nobody has locked it yet
  AccessPolicy instructor = AccessPolicy::of(other / "library");
  ASSERT_TRUE(setLock(instructor, kWords, {}, kCheapCost));
  EXPECT_FALSE(setLock(before, Passphrase("my own words"), {}, kCheapCost));
  EXPECT_TRUE(before.isLocked()) << "it has noticed";
}
TEST_F(WhileLocked, DetailsOfACaseAreRead) {
  makeAnsweredCase(folder_ / "case");
  const Case shown = shownCase(*loadCase(folder_ / "case"), policy());
  const std::string text = manifestOf(shown).dump();
  for (const char* word : {"SECRETTITLE", "SECRETFINDING", "SECRETDIAGNOSIS", "SECRETDIFFERENTIAL", "SECRETTARGET", "SECRETMEASUREMENT",
                           "SECRETWHY", "SECRETFUTURE", "SECRETTISSUE", "SECRETPRESET", "31.4159"})
    EXPECT_EQ(text.find(word), std::string::npos) << word;
  EXPECT_EQ(presetsOf(shown), std::vector<std::string>{"abdomen-convex-3.5"}) << "whoever reads it scans as others do";
  AccessPolicy open = policy();
  ASSERT_TRUE(open.unlock(kWords));
  EXPECT_EQ(shownCase(*loadCase(folder_ / "case"), open), *loadCase(folder_ / "case"));
}
TEST_F(WhileLocked, TheStartPageIsSearchedForAnAnswer) {
  makeAnsweredCase(folder_ / "cases/case");
  const auto index = openIndex({});
  ASSERT_TRUE(index);
  ASSERT_TRUE((*index)->refresh({{folder_ / "cases", LibraryKind::own}}, noProgress()));
  for (const char* word : {"SECRETDIAGNOSIS", "SECRETFINDING", "SECRETTITLE", "secretid", "SECRETDIFFERENTIAL"}) {
    EXPECT_TRUE((*index)->find({.words = word})->empty()) << word;
    EXPECT_EQ((*index)->find({.words = word, .forTrainees = false})->size(), 1u) << word << ", which authors find";
  }
  const auto found = search(**index, {.words = "joint"});
  ASSERT_EQ(found->rows.size(), 1u);
  EXPECT_EQ(found->rows[0].pathology, "");
  EXPECT_EQ(found->rows[0].title, "A joint");
}
TEST_F(WhileLocked, SomebodyElsesAttemptIsOpened) {
  Attempt attempt;
  attempt.person = "Ada";
  EXPECT_TRUE(mayOpen(attempt, "Ada", policy()));
  EXPECT_FALSE(mayOpen(attempt, "Ben", policy()));
  EXPECT_FALSE(mayOpen(attempt, "", policy()));
  EXPECT_FALSE(mayOpen(attempt, "ada", policy()));
}
TEST_F(WhileLocked, WhatAnInstructorDoesIsWrittenDown) {
  AccessPolicy open = policy();
  ASSERT_TRUE(open.unlock(kWords, "Anna"));
  open.lockAgain();
  EXPECT_TRUE(open.isLocked());
  ASSERT_TRUE(open.unlock(kWords, "Anna"));
  ASSERT_TRUE(setLock(open, Passphrase("other words here"), "Anna", kCheapCost));
  EXPECT_TRUE(open.isLocked());
  ASSERT_TRUE(open.unlock(Passphrase("other words here")));
  ASSERT_TRUE(removeLock(open, "Anna"));
  EXPECT_FALSE(open.hasLock());
  EXPECT_EQ(logged(),
            (std::vector<std::string>{"lock set", "unlocked", "locked", "unlocked", "passphrase changed", "unlocked", "lock taken away"}));
}

// --- The instructors' log -----------------------------------------------------------------------------------------------------------

TEST(InstructorLog, SurvivesALineThatWasTorn) {
  const TemporaryFolder folder;
  ASSERT_TRUE(logChange(folder.path(), "pass level", "knee/first/widest", 0.7, 0.8));
  const std::string whole = textOf(instructorLogFile(folder.path()));
  for (std::size_t length = 1; length < whole.size(); length += 7) {
    writeText(instructorLogFile(folder.path()), whole + whole.substr(0, length));
    ASSERT_TRUE(logChange(folder.path(), "after the crash"));
    const auto log = readInstructorLog(folder.path());
    ASSERT_TRUE(log);
    EXPECT_EQ(log->changes.size() + log->damaged, 3u) << length;
    EXPECT_EQ(log->changes.front().before, 0.7);
    EXPECT_EQ(log->changes.front().after, 0.8);
    EXPECT_EQ(log->changes.back().what, "after the crash");
  }
}
TEST(InstructorLog, ThatIsNotThereHoldsNothing) {
  const TemporaryFolder folder;
  EXPECT_TRUE(readInstructorLog(folder.path())->changes.empty());
}
TEST(InstructorLog, IsNotWrittenThroughALink) {
  const TemporaryFolder folder;
  ASSERT_TRUE(logChange(folder.path(), "first"));
  fs::remove(instructorLogFile(folder.path()));
  writeText(folder / "elsewhere", "");
  fs::create_symlink(folder / "elsewhere", instructorLogFile(folder.path()));
  EXPECT_FALSE(logChange(folder.path(), "second"));
  EXPECT_EQ(textOf(folder / "elsewhere"), "");
}

}  // namespace
}  // namespace ew::test::access_test
