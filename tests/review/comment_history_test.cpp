#include "logic/comment_history.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace ew::review {
namespace {

namespace fs = std::filesystem;

class CommentHistoryTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        fs::temp_directory_path() / (std::string("comment-history-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  static ReviewComment said(const char* text, double time_s) {
    ReviewComment made;
    made.stepId = "find";
    made.text = text;
    made.time_s = time_s;
    return made;
  }
  fs::path folder_;
};

TEST_F(CommentHistoryTest, TakesEveryEditBackAndDoesItAgain) {
  auto history = CommentHistory::open(folder_, "Ana");
  ASSERT_TRUE(history);
  const std::string second = history->add(said("second", 2.0), "comment");
  const std::string first = history->add(said("first", 1.0), "comment");
  ASSERT_EQ(history->comments().size(), 2U);
  EXPECT_EQ(history->comments()[0].id, first) << "by time";
  history->remove(second, "remove comment");
  EXPECT_EQ(history->comments().size(), 1U);
  EXPECT_EQ(history->undoName(), "remove comment");
  history->undo();
  ASSERT_NE(history->find(second), nullptr) << "what was removed comes back";
  EXPECT_EQ(history->find(second)->text, "second");
  history->undo();
  history->undo();
  EXPECT_TRUE(history->comments().empty());
  EXPECT_EQ(history->undoName(), "");
  history->redo();
  history->redo();
  EXPECT_EQ(history->comments().size(), 2U);
  EXPECT_EQ(history->redoName(), "remove comment");
  EXPECT_NE(history->add(said("third", 3.0), "comment"), second);
}

TEST_F(CommentHistoryTest, AnEditAfterUndoLeavesNothingToDoAgain) {
  auto history = CommentHistory::open(folder_, "Ana");
  ASSERT_TRUE(history);
  history->add(said("first", 1.0), "comment");
  history->add(said("second", 2.0), "comment");
  history->undo();
  history->undo();
  history->add(said("other", 3.0), "another");
  ASSERT_EQ(history->comments().size(), 1U);
  EXPECT_EQ(history->comments()[0].text, "other");
  EXPECT_EQ(history->redoName(), "");
  history->undo();
  EXPECT_TRUE(history->comments().empty());
}

TEST_F(CommentHistoryTest, CountsWhatIsTypedInARowAsOneStep) {
  auto history = CommentHistory::open(folder_, "Ana");
  ASSERT_TRUE(history);
  ReviewComment typed = said("", 1.0);
  typed.id = history->add(typed, "comment");
  for (const char* text : {"G", "Go", "Goo", "Good"}) {
    typed.text = text;
    history->replace(typed, "type", "text " + typed.id);
  }
  history->replace(typed, "type", "text " + typed.id);
  history->undo();
  EXPECT_EQ(history->find(typed.id)->text, "");
  history->redo();
  EXPECT_EQ(history->find(typed.id)->text, "Good");
}

TEST_F(CommentHistoryTest, KnowsWhetherItIsSaved) {
  auto history = CommentHistory::open(folder_, "Ana");
  ASSERT_TRUE(history);
  EXPECT_TRUE(history->isSaved());
  history->add(said("Well held.", 1.0), "comment");
  EXPECT_FALSE(history->isSaved());
  EXPECT_FALSE(fs::exists(commentsFileOf(folder_, "Ana")));
  ASSERT_TRUE(history->save());
  EXPECT_TRUE(history->isSaved());
  history->undo();
  EXPECT_FALSE(history->isSaved()) << "the file has one that is taken back";
  history->redo();
  EXPECT_TRUE(history->isSaved());
  const auto again = CommentHistory::open(folder_, "Ana");
  ASSERT_TRUE(again);
  ASSERT_EQ(again->comments().size(), 1U);
  EXPECT_EQ(again->comments()[0].text, "Well held.");
  EXPECT_TRUE(CommentHistory::open(folder_, "Ben")->comments().empty());
}

}  // namespace
}  // namespace ew::review
