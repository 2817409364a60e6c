#include "ew/assessment/review_comment.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>

#include "ew/io/safe_file.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class ReviewComments : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("review-comments-" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
                                           ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

CommentFile example() {
  ReviewComment drawn;
  drawn.id = "c1";
  drawn.stepId = "find-the-kidney";
  drawn.recording = "step-03-find-the-kidney.seq.mha";
  drawn.time_s = 12.345;
  drawn.text = "Here you lose contact: Ä \"quoted\"\nsecond line";
  drawn.strokes = {{CommentStroke::Kind::line, {{1.5, 20.25}, {2.0, 21.0}, {-3.0, 22.0}}},
                   {CommentStroke::Kind::arrow, {{-10.0, 5.0}, {0.1, 33.3}}},
                   {CommentStroke::Kind::circle, {{4.0, 40.0}, {9.0, 40.0}}}};
  drawn.probeToWorld = Transform<frame::World, frame::Probe>{
      glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(10.0, -90.5, 33.0)), 0.7, glm::normalize(glm::dvec3(1.0, 2.0, 3.0)))};
  drawn.at = std::chrono::sys_seconds(std::chrono::seconds(1'800'000'000));
  drawn.otherFields["of_tomorrow"] = 7;
  ReviewComment plain;
  plain.id = "c2";
  plain.stepId = "measure";
  plain.text = "Good.";
  return {"Dr. Weiß", {drawn, plain}, {{"kept", true}}};
}

TEST_F(ReviewComments, SurviveAFile) {
  ASSERT_TRUE(writeComments(folder_, example()));
  const auto read = readComments(folder_, "Dr. Weiß");
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(*read, example());
}

TEST_F(ReviewComments, OfTwoAuthorsAreTwoFiles) {
  CommentFile other = example();
  other.author = "DR. WEISS";
  ASSERT_TRUE(writeComments(folder_, example()));
  ASSERT_TRUE(writeComments(folder_, other));
  EXPECT_NE(commentsFileOf(folder_, "Ana"), commentsFileOf(folder_, "ANA"));
  EXPECT_EQ(commentsFileOf(folder_, "../../x").parent_path(), folder_ / "comments") << "a name is no way out";
  const CommentList all = listComments(folder_);
  ASSERT_EQ(all.files.size(), 2U);
  EXPECT_TRUE(all.problems.empty());
  EXPECT_EQ(readComments(folder_, "nobody")->comments.size(), 0U);
}

TEST_F(ReviewComments, AreNotWrittenOverWhatCannotBeRead) {
  ASSERT_TRUE(writeComments(folder_, example()));
  const fs::path file = commentsFileOf(folder_, example().author);
  json newer = jsonOf(example());
  newer["format"] = kCommentsFormat + 1;
  ASSERT_TRUE(writeFileSafely(file, newer.dump()));
  const auto written = writeComments(folder_, example());
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::newerFormat);
  EXPECT_EQ(*readTextFile(file), newer.dump());
  EXPECT_EQ(listComments(folder_).problems.size(), 1U);
}

TEST_F(ReviewComments, RefuseWhatIsWrongWithTheFieldsName) {
  const auto refused = [](const char* pointer, const json& value) {
    json document = jsonOf(example());
    document[json::json_pointer(pointer)] = value;
    const auto read = commentsFromJson(document);
    return read ? std::string("taken") : read.error().sentence();
  };
  EXPECT_NE(refused("/comments/0/time_s", -1).find("comments[0].time_s"), std::string::npos);
  EXPECT_NE(refused("/comments/0/id", "").find("comments[0].id"), std::string::npos);
  EXPECT_NE(refused("/comments/1/id", "c1").find("no other comment"), std::string::npos);
  EXPECT_NE(refused("/comments/0/recording", "../../etc/passwd").find("attempt's folder"), std::string::npos);
  EXPECT_NE(refused("/comments/0/recording", "..").find("attempt's folder"), std::string::npos);
  EXPECT_NE(refused("/comments/0/strokes/0/kind", "scribble").find("kind"), std::string::npos);
  EXPECT_NE(refused("/comments/0/strokes/0/points_mm", json({1, 2, 3, 4, 5})).find("lateral and axial"), std::string::npos);
  EXPECT_NE(refused("/comments/0/strokes/1/points_mm", json({1, 2, 3, 4, 5, 6})).find("two points"), std::string::npos);
  EXPECT_NE(refused("/comments/0/probe_to_world", json::array({1, 2, 3})).find("probe_to_world"), std::string::npos);
  EXPECT_NE(refused("/author", 5).find("author"), std::string::npos);
}

}  // namespace
}  // namespace ew
