#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "cli/cli_world.h"
#include "ew/io/volume_file.h"
#include "ew/library/access.h"
#include "ew/library/bundle.h"
#include "ew/library/instructor_log.h"
#include "ew/library/sealed_answers.h"
#include "ew/library/step_answer.h"

namespace ew::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string kWords = "correct horse battery";
constexpr PassphraseCost kCheap{.passes = 1, .memory_bytes = 64 << 10};

/// A library, keys and a case with an answer, in folders of their own.
class AccessCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_.path() / "case/volumes");
    ASSERT_TRUE(writeVolume(rampVolume({12, 11, 10}), folder_.path() / "case/volumes/v.mha"));
    const json steps = {{{"id", "s"},
                         {"task", "answer"},
                         {"title", "Decide"},
                         {"text", "What is it?"},
                         {"options", {{{"text", "One"}, {"right", true}, {"why", "SECRETWHY"}}, {{"text", "Other"}}}}}};
    const json pose = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const json manifest = {{"format", 2},
                           {"id", "secretid"},
                           {"title", "SECRETTITLE"},
                           {"title_for_trainees", "A joint"},
                           {"indication", "Pain?"},
                           {"diagnosis", "SECRETDIAGNOSIS"},
                           {"findings", {"SECRETFINDING"}},
                           {"start_pose", pose},
                           {"volume", {{"file", "volumes/v.mha"}, {"file_to_world", pose}, {"licence", "CC0"}, {"attribution", "a test"}}},
                           {"parts", {{"lessons", {{"format", 1}, {"lessons", {{{"id", "l"}, {"title", "L"}, {"steps", steps}}}}}}}}};
    writeText(folder_ / "case/case.json", manifest.dump());
    writePassphrase("words", kWords);
  }
  void writePassphrase(const std::string& name, const std::string& words) const {
    writeText(folder_ / name, words + "\n");
    ::chmod((folder_ / name).c_str(), 0600);
  }
  void lock() const {
    AccessPolicy policy = AccessPolicy::of(libraryFolder());
    ASSERT_TRUE(setLock(policy, Passphrase(kWords), {}, kCheap));
  }
  [[nodiscard]] std::string caseFolder() const { return folder_ / "case"; }

  const TemporaryFolder folder_;
  const EnvironmentValue library_{"ECHOWEAVE_LIBRARY", folder_ / "library"};
  const EnvironmentValue keys_{"ECHOWEAVE_KEYS", folder_ / "keys"};
};

TEST_F(AccessCommand, ShowsNoAnswerAndChangesNothingWhileLocked) {
  const std::vector<std::vector<std::string>> asked = {{"case", "show", caseFolder()},
                                                       {"case", "show", caseFolder(), "--json"},
                                                       {"case", "validate", caseFolder()},
                                                       {"case", "list", folder_.path().string()},
                                                       {"case", "export", caseFolder(), "-o", folder_ / "x.ewcase"},
                                                       {"case", "publish", caseFolder()},
                                                       {"case", "new", caseFolder() + "/volumes/v.mha", "-o", folder_ / "made"},
                                                       {"lesson", "show", caseFolder(), "l"},
                                                       {"lesson", "check", caseFolder()},
                                                       {"phantom", folder_ / "case/case.json", "--labels", folder_ / "l.mha"},
                                                       {"replay", caseFolder(), "--scan", "s.seq.mha", "-o", folder_ / "clip"},
                                                       {"case", "prepare", caseFolder()},
                                                       {"case", "card", caseFolder()},
                                                       {"lesson", "course"},
                                                       {"access", "changes"},
                                                       {"key", "new", "--passphrase", folder_ / "words"}};
  lock();
  const auto before = folder_.names();
  for (const auto& words : asked) {
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.status, 2) << words.at(0) << " " << words.at(1);
    EXPECT_NE(outcome.err.find("locked for trainees"), std::string::npos) << words.at(1) << ": " << outcome.err;
    EXPECT_EQ((outcome.out + outcome.err).find("SECRET"), std::string::npos) << words.at(1);
  }
  EXPECT_EQ(folder_.names(), before);
}

TEST_F(AccessCommand, OfAPluginIsNotTakenForHarmless) {
  // A command that nobody has thought about: what it shows is not known.
  lock();
  const Outcome outcome = run({"stitch", folder_ / "none.json", "-o", folder_ / "out"});
  EXPECT_NE(outcome.status, 0);
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(AccessCommand, WorksAgainWithThePassphraseFromAFileOrADescriptor) {
  lock();
  const Outcome shown = run({"case", "show", caseFolder(), "--unlock", folder_ / "words"});
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_NE(shown.out.find("SECRETDIAGNOSIS"), std::string::npos);
  const int descriptor = ::open((folder_ / "words").c_str(), O_RDONLY);
  EXPECT_EQ(run({"lesson", "show", caseFolder(), "l", "--unlock", "fd:" + std::to_string(descriptor)}).status, 0);
  ::close(descriptor);
  EXPECT_EQ(run({"case", "show", caseFolder()}).status, 2) << "the lock is still there";
}

TEST_F(AccessCommand, IsNotUnlockedByAnythingElse) {
  lock();
  writePassphrase("wrong", "correct horse batterz");
  writePassphrase("empty", "");
  writeText(folder_ / "open", kWords + "\n");
  ::chmod((folder_ / "open").c_str(), 0644);
  for (const std::string& source : {folder_ / "wrong", folder_ / "empty", folder_ / "open", folder_ / "none", kWords, std::string("fd:999"),
                                    std::string("fd:"), std::string("fd:-1"), std::string("fd:0x1")}) {
    const Outcome outcome = run({"case", "show", caseFolder(), "--unlock", source});
    EXPECT_NE(outcome.status, 0) << source;
    EXPECT_EQ(outcome.out, "") << source;
  }
}

TEST_F(AccessCommand, LetsTraineesWorkWhileLocked) {
  lock();
  EXPECT_EQ(run({"lesson", "list", caseFolder()}).status, 0);
  EXPECT_EQ(run({"access", "status"}).status, 0);
  EXPECT_EQ(run({"slice", caseFolder() + "/volumes/v.mha", "--pose", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", "-o", folder_ / "s.png"}).status,
            0);
}

TEST_F(AccessCommand, LocksAndUnlocksAndWritesItDown) {
  EXPECT_EQ(run({"access", "lock", "--passphrase", folder_ / "words"}).status, 0);
  EXPECT_TRUE(AccessPolicy::of(libraryFolder()).isLocked());
  writePassphrase("wrong", "correct horse batterz");
  EXPECT_NE(run({"access", "unlock", "--passphrase", folder_ / "wrong"}).status, 0);
  EXPECT_TRUE(hasLock(libraryFolder()));
  EXPECT_EQ(run({"access", "unlock", "--passphrase", folder_ / "words"}).status, 0);
  EXPECT_FALSE(hasLock(libraryFolder()));
  const auto log = readInstructorLog(libraryFolder());
  ASSERT_TRUE(log);
  std::vector<std::string> what;
  for (const auto& each : log->changes) what.push_back(each.what);
  EXPECT_EQ(what, (std::vector<std::string>{"lock set", "wrong passphrase", "unlocked", "lock taken away"}));
  const Outcome changes = run({"access", "changes"});
  EXPECT_EQ(changes.status, 0);
  EXPECT_NE(changes.out.find("wrong passphrase"), std::string::npos);
  EXPECT_EQ(changes.out.find("horse"), std::string::npos);
}

TEST_F(AccessCommand, MakesAKeyAndAnExaminationForIt) {
  ASSERT_EQ(run({"key", "new", "--passphrase", folder_ / "words"}).status, 0);
  EXPECT_NE(run({"key", "new", "--passphrase", folder_ / "words"}).status, 0) << "a key is not written over";
  ASSERT_EQ(run({"key", "show", "-o", folder_ / "anna.pub"}).status, 0);
  const Outcome made = run({"case", "export", caseFolder(), "-o", folder_ / "friday.ewcase", "--examination", "--for", folder_ / "anna.pub",
                            "--report", folder_ / "r.json"});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_NE(made.out.find("answers sealed"), std::string::npos);
  for (const std::string& name : folder_.names()) EXPECT_EQ(name.find(".echoweave-"), std::string::npos) << "the scratch folder is left";
  const auto imported = importBundle(folder_ / "friday.ewcase", libraryFolder());
  ASSERT_TRUE(imported) << imported.error();
  EXPECT_EQ(imported->id, readJson(folder_ / "r.json")["examination"]["id"]);
  const Outcome shown = run({"case", "show", imported->folder.string(), "--json"});
  EXPECT_EQ(shown.status, 0);
  EXPECT_EQ(shown.out.find("SECRET"), std::string::npos);
  EXPECT_EQ(run({"lesson", "show", imported->folder.string(), "lesson-1"}).out.find("SECRET"), std::string::npos);
  const auto key = openSecretKey(instructorKeyFile(), Passphrase(kWords));
  ASSERT_TRUE(key) << key.error();
  EXPECT_TRUE(openExamination(imported->folder, *key, folder_ / "again"));
}

TEST_F(AccessCommand, PublishesAndExportsAnImportedExaminationAsItIs) {
  ASSERT_EQ(run({"key", "new", "--passphrase", folder_ / "words"}).status, 0);
  ASSERT_EQ(run({"key", "show", "-o", folder_ / "anna.pub"}).status, 0);
  ASSERT_EQ(run({"case", "export", caseFolder(), "-o", folder_ / "friday.ewcase", "--examination", "--for", folder_ / "anna.pub",
                 "--examination-id", "friday"})
                .status,
            0);
  ASSERT_EQ(run({"case", "import", folder_ / "friday.ewcase"}).status, 0);
  const Outcome exported = run({"case", "export", "friday", "-o", folder_ / "again.ewcase"});
  ASSERT_EQ(exported.status, 0) << exported.err;
  EXPECT_NE(exported.out.find("An examination, as it was made: its answers stay sealed for the instructors whose keys it was made for."),
            std::string::npos)
      << exported.out;
  EXPECT_EQ(exported.out.find("can read the answers"), std::string::npos) << exported.out;
  const Outcome published = run({"case", "publish", "friday"});
  ASSERT_EQ(published.status, 0) << published.err;
  EXPECT_EQ(published.out.find("missing:"), std::string::npos) << published.out;
  EXPECT_NE(published.out.find("An examination is published as it was made, and was published before, so nothing was done: friday, "
                               "revision 1: "),
            std::string::npos)
      << published.out;
  ASSERT_EQ(run({"case", "publish", "friday", "--library", folder_ / "another"}).status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "another/published/friday/1/answers.sealed"));
}

TEST_F(AccessCommand, NeverWritesOverTheFileOfAnExamination) {
  ASSERT_EQ(run({"key", "new", "--passphrase", folder_ / "words"}).status, 0);
  ASSERT_EQ(run({"key", "show", "-o", folder_ / "anna.pub"}).status, 0);
  const std::string exam = folder_ / "exam.ewcase";
  ASSERT_EQ(run({"case", "export", caseFolder(), "-o", exam, "--examination", "--for", folder_ / "anna.pub"}).status, 0);
  const std::string before = readText(exam);
  const std::vector<std::vector<std::string>> ways = {
      {"case", "export", caseFolder(), "-o", exam},
      {"case", "export", caseFolder(), "-o", exam, "--examination", "--for", folder_ / "anna.pub"},
      {"case", "export", caseFolder(), "-o", folder_ / "other.ewcase", "--report", exam},
      {"key", "show", "-o", exam},
  };
  for (const std::vector<std::string>& way : ways) {
    const Outcome refused = run(way);
    EXPECT_EQ(refused.status, 2) << refused.out;
    EXPECT_NE(refused.err.find("is never replaced"), std::string::npos) << refused.err;
    EXPECT_EQ(readText(exam), before);
  }
  EXPECT_FALSE(fs::exists(folder_ / "other.ewcase")) << "what cannot be reported is not begun";
}

TEST_F(AccessCommand, OpensAnExaminationWithTheKeyAndScoresWhatWasHandedIn) {
  ASSERT_EQ(run({"key", "new", "--passphrase", folder_ / "words"}).status, 0);
  ASSERT_EQ(run({"key", "show", "-o", folder_ / "anna.pub"}).status, 0);
  ASSERT_EQ(run({"case", "export", caseFolder(), "-o", folder_ / "friday.ewcase", "--examination", "--for", folder_ / "anna.pub",
                 "--examination-id", "friday"})
                .status,
            0);
  const auto imported = importBundle(folder_ / "friday.ewcase", libraryFolder());
  ASSERT_TRUE(imported);
  std::vector<std::string> words = {
      "case", "unseal", folder_ / "friday.ewcase", "-o", folder_ / "opened", "--passphrase", folder_ / "words", "--attempts"};
  for (const std::size_t option : {0U, 1U}) {
    Attempt attempt;
    attempt.id = "20261126-09300" + std::to_string(option) + "-4f2a91c7";
    attempt.caseId = "friday";
    attempt.lessonId = "lesson-1";
    attempt.startedAt = std::chrono::sys_seconds(std::chrono::seconds(1'800'000'000));
    attempt = withSealedAnswers(attempt, loadCase(imported->folder)->sealed->sha256);
    auto kept = AttemptFolder::begin(folder_.path() / "handed", attempt);
    ASSERT_TRUE(kept) << kept.error();
    StepOutcome outcome;
    outcome.stepId = "step-1";
    outcome.verdict = StepVerdict::handedIn;
    outcome.answer = OptionsAnswer{{option}};
    ASSERT_TRUE(kept->endStep(outcome));
    ASSERT_TRUE(kept->finish(attempt.startedAt));
    words.push_back(kept->folder().string());
  }
  const Outcome sealed = run({"assess", words.back()});
  EXPECT_NE(sealed.status, 0) << "as long as the answers are sealed it has no score";
  EXPECT_NE((sealed.out + sealed.err).find("unseal"), std::string::npos) << sealed.out << sealed.err;

  writePassphrase("wrong", "correct horse batterz");
  auto wrong = words;
  wrong[6] = folder_ / "wrong";
  EXPECT_NE(run(wrong).status, 0);
  EXPECT_FALSE(fs::exists(folder_ / "opened"));
  const Outcome opened = run(words);
  ASSERT_EQ(opened.status, 0) << opened.err;
  EXPECT_TRUE(loadCase(folder_ / "opened/cases/secretid"));
  const Outcome scored = run({"assess", "--library", folder_ / "opened", "--report", folder_ / "r.json"});
  ASSERT_EQ(scored.status, 0) << scored.err << scored.out;
  const json attempts = readJson(folder_ / "r.json")["attempts"];
  ASSERT_EQ(attempts.size(), 2u);
  EXPECT_EQ(attempts[0]["score"], 1.0);
  EXPECT_EQ(attempts[0]["passed"], true);
  EXPECT_EQ(attempts[1]["score"], 0.0);
  EXPECT_EQ(attempts[1]["passed"], false);
}

TEST_F(AccessCommand, SaysThatAnOrdinaryBundleIsForPractice) {
  const Outcome made = run({"case", "export", caseFolder(), "-o", folder_ / "p.ewcase"});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_NE(made.out.find("can read the answers"), std::string::npos);
}

TEST_F(AccessCommand, WantsToKnowForWhomAnswersAreSealed) {
  EXPECT_EQ(run({"case", "export", caseFolder(), "-o", folder_ / "e.ewcase", "--examination"}).status, 2);
  writeText(folder_ / "bad.pub", "echoweave-key-1 AAAA 1234\n");
  EXPECT_NE(run({"case", "export", caseFolder(), "-o", folder_ / "e.ewcase", "--examination", "--for", folder_ / "bad.pub"}).status, 0);
  EXPECT_FALSE(fs::exists(folder_ / "e.ewcase"));
}

}  // namespace
}  // namespace ew::test
