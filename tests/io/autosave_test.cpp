// What is not saved yet outlives a kill, is offered to one asker alone, and leaves nothing behind when the program ends in order.
#include "ew/io/autosave.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <future>

#include "ew/io/safe_file.h"
#include "io/file_size_limit.h"
#include "library/temporary_folder.h"

namespace ew::autosave_test {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

/// Does `work` with a keeper in a program of its own, which is then killed as `kill -9` kills.
void doAndBeKilled(const fs::path& root, const std::function<void(Autosave&)>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    Autosave kept(root);
    work(kept);
    kept.flush();
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
}

std::size_t foldersIn(const fs::path& root) {
  std::error_code ignored;
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(root, ignored), fs::directory_iterator()));
}

mode_t modeOf(const fs::path& file) {
  struct stat found {};
  return ::stat(file.c_str(), &found) == 0 ? found.st_mode & 0777 : 0;
}

TEST(Autosave, WhatWasKeptOutlivesAKill) {
  const TemporaryFolder folder;
  doAndBeKilled(folder / "kept", [](Autosave& kept) {
    kept.describe({{"title", "One"}});
    kept.append("scan.jsonl", "first\n");
    kept.append("scan.jsonl", "second\n");
    kept.replace("sheet.json", "old");
    kept.replace("sheet.json", "new");
    kept.replace("gone.json", "decided");
    kept.remove("gone.json");
  });
  const Autosave here(folder / "kept");
  const auto left = here.takeLeft();
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].about().at("title"), "One");
  EXPECT_EQ(readTextFile(left[0].fileOf("scan.jsonl")).value_or(""), "first\nsecond\n");
  EXPECT_EQ(readTextFile(left[0].fileOf("sheet.json")).value_or(""), "new");
  EXPECT_FALSE(left[0].has("gone.json"));
}

TEST(Autosave, IsForItsOwnerAlone) {
  const TemporaryFolder folder;
  Autosave kept(folder / "kept");
  kept.describe({{"title", "One"}});
  kept.append("scan.jsonl", "first\n");
  kept.replace("sheet.json", "values");
  kept.replaceFile("volume.mha", 3, [](const fs::path& file) { return writeFileSafely(file, "abc"); });
  kept.flush();
  ASSERT_EQ(foldersIn(folder / "kept"), 1U);
  const fs::path own = fs::directory_iterator(folder / "kept")->path();
  EXPECT_EQ(modeOf(own), 0700U);
  for (const char* item : {"about.json", "scan.jsonl", "sheet.json", "volume.mha"}) EXPECT_EQ(modeOf(own / item), 0600U) << item;
}

TEST(Autosave, AProgramThatLivesIsNotOfferedAndOneThatEndsInOrderLeavesNothing) {
  const TemporaryFolder folder;
  {
    Autosave kept(folder / "kept");
    kept.describe({{"title", "One"}});
    kept.append("scan.jsonl", "first\n");
    kept.flush();
    const Autosave other(folder / "kept");
    EXPECT_TRUE(other.takeLeft().empty());
    kept.forget();
    kept.flush();
    EXPECT_EQ(foldersIn(folder / "kept"), 0U);
    kept.describe({{"title", "Two"}});
    kept.append("scan.jsonl", "again\n");
  }
  EXPECT_EQ(foldersIn(folder / "kept"), 0U);
}

TEST(Autosave, IsOfferedToOneAskerAndAgainWhenNobodyDecided) {
  const TemporaryFolder folder;
  doAndBeKilled(folder / "kept", [](Autosave& kept) {
    kept.describe({{"kind", "window"}});
    kept.append("scan.jsonl", "first\n");
  });
  doAndBeKilled(folder / "kept", [](Autosave& kept) {
    kept.describe({{"kind", "lesson"}});
    kept.append("step.jsonl", "first\n");
  });
  const Autosave first(folder / "kept"), second(folder / "kept");
  const auto isOfWindow = [](const nlohmann::json& about) { return about.at("kind") == "window"; };
  {
    const auto left = first.takeLeft(isOfWindow);
    ASSERT_EQ(left.size(), 1U);
    EXPECT_TRUE(second.takeLeft(isOfWindow).empty()) << "somebody is asked about it already";
    EXPECT_EQ(second.takeLeft().size(), 1U) << "what is not wanted stays for others";
  }
  auto again = second.takeLeft(isOfWindow);
  ASSERT_EQ(again.size(), 1U) << "nobody decided";
  again[0].discard();
  EXPECT_TRUE(first.takeLeft(isOfWindow).empty());
  EXPECT_EQ(foldersIn(folder / "kept"), 1U);
}

/// What a program has left that kept `bytes` of a scan.
std::shared_ptr<Autosave::Left> leftOf(const fs::path& root, const std::string& bytes, const Autosave& asker) {
  doAndBeKilled(root, [&](Autosave& kept) {
    kept.describe({{"title", "One"}});
    kept.append("scan.jsonl", bytes);
  });
  auto left = asker.takeLeft();
  EXPECT_EQ(left.size(), 1U);
  return left.empty() ? nullptr : std::make_shared<Autosave::Left>(std::move(left.front()));
}

/// Holds the thread of a keeper up until it may go on.
class HeldUp {
 public:
  explicit HeldUp(Autosave& kept) {
    kept.replace("first.json", [this]() -> Result<std::string> {
      begun_.set_value();
      goOn_.get_future().wait();
      return "first";
    });
    begun_.get_future().wait();
  }
  void goOn() { goOn_.set_value(); }

 private:
  std::promise<void> begun_, goOn_;
};

TEST(Autosave, WhatIsForgottenIsNotWrittenFirst) {
  const TemporaryFolder folder;
  Autosave kept(folder / "kept");
  const auto left = leftOf(folder / "kept", "first\n", kept);
  ASSERT_TRUE(left);
  HeldUp heldUp(kept);
  int made = 0;
  kept.describe({{"title", "One"}});
  kept.replaceFile("volume.mha", 3, [&](const fs::path& file) { return ++made, writeFileSafely(file, "abc"); });
  kept.discardOnceKept(left);
  kept.forget();
  heldUp.goOn();
  kept.flush();
  EXPECT_EQ(made, 0) << "nobody waits for a large volume that is given up";
  EXPECT_EQ(foldersIn(folder / "kept"), 0U) << "nor is there anything that was left of it before";
}

TEST(Autosave, WhatWasLeftStaysUntilAllOfItIsKeptAgain) {
  const TemporaryFolder folder;
  Autosave kept(folder / "kept", {}, {.most_bytes = 10, .least_free_bytes = 0});
  const auto left = leftOf(folder / "kept", "12345678", kept);
  ASSERT_TRUE(left);
  kept.describe({{"title", "One"}});
  kept.replace("sheet.json", "123");
  kept.append("scan.jsonl", "12345678");  // for which there is no room beside it
  kept.discardOnceKept(left);
  kept.flush();
  EXPECT_TRUE(left->has("scan.jsonl")) << "the only copy there is";
  kept.replace("sheet.json", "321");
  kept.flush();
  EXPECT_TRUE(left->has("scan.jsonl")) << "what else is kept does not make up for it";
  kept.remove("sheet.json");
  kept.flush();
  EXPECT_FALSE(left->has("scan.jsonl"));
  ASSERT_EQ(foldersIn(folder / "kept"), 1U);
  EXPECT_EQ(readTextFile(fs::directory_iterator(folder / "kept")->path() / "scan.jsonl").value_or(""), "12345678");
}

TEST(Autosave, WhatWasLeftIsOfferedAgainByAProgramThatCouldNotKeepIt) {
  const TemporaryFolder folder;
  {
    Autosave kept(folder / "kept", {}, {.most_bytes = 10, .least_free_bytes = 0});
    const auto left = leftOf(folder / "kept", "12345678", kept);
    ASSERT_TRUE(left);
    kept.describe({{"title", "One"}});
    kept.replace("scan.jsonl", "12345678 and more");
    kept.discardOnceKept(left);
    kept.flush();
    EXPECT_TRUE(Autosave(folder / "kept").takeLeft().empty()) << "as long as that one lives it may still keep it";
  }
  const auto again = Autosave(folder / "kept").takeLeft();
  ASSERT_EQ(again.size(), 1U);
  EXPECT_EQ(readTextFile(again[0].fileOf("scan.jsonl")).value_or(""), "12345678");
}

TEST(Autosave, WhatWaitsToBeReplacedIsNotKeptYet) {
  const TemporaryFolder folder;
  Autosave kept(folder / "kept");
  const auto left = leftOf(folder / "kept", "first\n", kept);
  ASSERT_TRUE(left);
  HeldUp heldUp(kept);
  kept.describe({{"title", "One"}});
  kept.replace("sheet.json", "of before the crash");
  kept.discardOnceKept(left);
  bool wasThere = false;
  kept.replace("sheet.json", [&]() -> Result<std::string> {  // the one before it is not written at all
    wasThere = left->has("scan.jsonl");
    return "of before the crash, and more";
  });
  heldUp.goOn();
  kept.flush();
  EXPECT_TRUE(wasThere);
  EXPECT_FALSE(left->has("scan.jsonl"));
}

TEST(Autosave, WhatWasWrittenInPartIsTakenBackAndGoesFirst) {
  const TemporaryFolder folder;
  doAndBeKilled(folder / "kept", [](Autosave& kept) {
    kept.describe({{"title", "One"}});
    kept.append("scan.jsonl", "first\n");
    kept.flush();
    {
      const test::FileSizeLimit limit(10);
      kept.append("scan.jsonl", "second\n");
      kept.append("scan.jsonl", "third\n");
      kept.flush();
    }
    kept.append("scan.jsonl", "fourth\n");
  });
  doAndBeKilled(folder / "kept", [](Autosave& kept) {
    kept.describe({{"title", "Two"}});
    kept.append("scan.jsonl", "first\n");
    kept.flush();
    const test::FileSizeLimit limit(10);
    kept.append("scan.jsonl", "second\n");
    kept.flush();
    ::kill(::getpid(), SIGKILL);
  });
  const auto left = Autosave(folder / "kept").takeLeft();
  ASSERT_EQ(left.size(), 2U);
  for (const auto& each : left)
    EXPECT_EQ(readTextFile(each.fileOf("scan.jsonl")).value_or(""),
              each.about().at("title") == "One" ? "first\nsecond\nthird\nfourth\n" : "first\n");
}

TEST(Autosave, ADescriptionThatCouldNotBeWrittenIsTriedAgain) {
  const TemporaryFolder folder;
  doAndBeKilled(folder / "kept", [](Autosave& kept) {
    {
      const test::FileSizeLimit limit(4);
      kept.describe({{"title", "One"}});
      kept.append("scan.jsonl", "first\n");
      kept.flush();
    }
    kept.append("scan.jsonl", "second\n");
  });
  const auto left = Autosave(folder / "kept").takeLeft();
  ASSERT_EQ(left.size(), 1U) << "without it nothing would be offered";
  EXPECT_EQ(readTextFile(left[0].fileOf("scan.jsonl")).value_or(""), "first\nsecond\n");
  EXPECT_EQ(left[0].items(), std::vector<std::string>{"scan.jsonl"});
}

TEST(Autosave, WhatWaitsHasABoundBeyondWhichNothingIsAddedAfterTheGap) {
  const TemporaryFolder folder;
  Autosave kept(folder / "kept", {}, {.most_bytes = 10, .least_free_bytes = 0, .most_held_bytes = 12});
  const auto left = leftOf(folder / "kept", "12345678", kept);
  ASSERT_TRUE(left);
  const auto scan = [&] {
    kept.flush();
    for (const auto& each : fs::directory_iterator(folder / "kept"))
      if (each.path() != left->folder()) return readTextFile(each.path() / "scan.jsonl").value_or("");
    return std::string();
  };
  kept.describe({{"title", "One"}});
  kept.append("scan.jsonl", "12345678");
  kept.append("scan.jsonl", "too much");
  kept.append("scan.jsonl", "and more");
  kept.append("scan.jsonl", "9");  // for which there would be room
  kept.discardOnceKept(left);
  EXPECT_EQ(scan(), "12345678");
  EXPECT_TRUE(left->has("scan.jsonl"));
  kept.replace("scan.jsonl", "new ");
  kept.append("scan.jsonl", "again");
  EXPECT_EQ(scan(), "new again");
  EXPECT_FALSE(left->has("scan.jsonl"));
}

TEST(Autosave, HasABoundAndSaysSoOnce) {
  const TemporaryFolder folder;
  std::vector<std::string> said;
  {
    Autosave kept(folder / "kept", [&](const Error& problem) { said.push_back(problem.sentence()); },
                  {.most_bytes = 10, .least_free_bytes = 0});
    kept.describe({{"title", "One"}});
    kept.append("scan.jsonl", "12345678");
    kept.append("scan.jsonl", "too much");
    kept.append("scan.jsonl", "again too much");
    kept.flush();
    EXPECT_EQ(said.size(), 1U);
    EXPECT_EQ(readTextFile(fs::directory_iterator(folder / "kept")->path() / "scan.jsonl").value_or(""), "12345678");
    kept.append("scan.jsonl", "9");  // waits behind what came before it
    kept.flush();
    EXPECT_EQ(said.size(), 1U);
    kept.replace("sheet.json", "9");
    kept.append("scan.jsonl", "again too much");
    kept.flush();
    EXPECT_EQ(readTextFile(fs::directory_iterator(folder / "kept")->path() / "scan.jsonl").value_or(""), "12345678");
  }
  EXPECT_EQ(said.size(), 2U);
}

TEST(Autosave, AFolderThatCannotBeMadeIsAProblemAndNoCrash) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFileSafely(folder / "file", "in the way"));
  std::vector<std::string> said;
  {
    Autosave kept(folder / "file" / "kept", [&](const Error& problem) { said.push_back(problem.sentence()); });
    kept.describe({{"title", "One"}});
    kept.append("scan.jsonl", "first\n");
    kept.replace("sheet.json", []() -> Result<std::string> { throw std::runtime_error("odd"); });
    kept.flush();
    EXPECT_TRUE(kept.takeLeft().empty());
  }
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("a crash would lose it"), std::string::npos) << said[0];
}

TEST(Autosave, DamageIsNotOffered) {
  const TemporaryFolder folder;
  doAndBeKilled(folder / "kept", [](Autosave& kept) { kept.append("scan.jsonl", "without a description\n"); });
  doAndBeKilled(folder / "kept", [](Autosave& kept) { kept.describe({{"title", "One"}}); });
  for (const auto& each : fs::directory_iterator(folder / "kept"))
    if (fs::exists(each.path() / "about.json")) {
      ASSERT_TRUE(writeFileSafely(each.path() / "about.json", "[[[[ no json"));
    }
  const Autosave here(folder / "kept");
  EXPECT_TRUE(here.takeLeft().empty());
}

}  // namespace
}  // namespace ew::autosave_test
