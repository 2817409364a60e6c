#include "ew/library/course.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "library/temporary_folder.h"

namespace ew::course_test {
namespace {

using nlohmann::json;
using test::TemporaryFolder;
using test::writeText;

const json kCourse = {{"format", 1},
                      {"id", "first"},
                      {"title", {{"en", "First"}, {"de", "Zuerst"}}},
                      {"text", {{"en", "From here to there."}, {"de", "Von hier nach dort."}}},
                      {"lessons", {{{"case", "a"}, {"lesson", "x"}}, {{"case", "a"}, {"lesson", "y"}}, {{"case", "b"}, {"lesson", "x"}}}}};

Result<Course> read(const json& document) {
  const TemporaryFolder folder;
  writeText(folder.path() / "course.json", document.dump());
  return readCourse(folder.path() / "course.json");
}

std::string refusal(const json& document) {
  const auto course = read(document);
  return course ? std::string("taken") : course.error().sentence();
}

TEST(Course, IsReadInItsOrderAndInBothLanguages) {
  const auto course = read(kCourse);
  ASSERT_TRUE(course) << course.error().sentence();
  EXPECT_EQ(course->id, "first");
  EXPECT_EQ(course->title.in("de_AT"), "Zuerst");
  EXPECT_EQ(course->text.in("fr"), "From here to there.");
  EXPECT_EQ(course->lessons, (std::vector<CourseLesson>{{"a", "x"}, {"a", "y"}, {"b", "x"}}));
}

TEST(Course, RefusesALessonTwiceAnEmptyListAndUnknownFields) {
  json twice = kCourse;
  twice["lessons"][2] = twice["lessons"][0];
  EXPECT_NE(refusal(twice).find("lessons[2].lesson"), std::string::npos) << refusal(twice);
  json empty = kCourse;
  empty["lessons"] = json::array();
  EXPECT_NE(refusal(empty).find("'lessons'"), std::string::npos) << refusal(empty);
  json unknown = kCourse;
  unknown["colour"] = "blue";
  EXPECT_NE(refusal(unknown).find("colour"), std::string::npos) << refusal(unknown);
  json oneLanguage = kCourse;
  oneLanguage["title"].erase("de");
  EXPECT_NE(refusal(oneLanguage).find("title.de"), std::string::npos) << refusal(oneLanguage);
}

TEST(Course, OfANewerProgramIsRefusedWithBothNumbers) {
  json newer = kCourse;
  newer["format"] = 7;
  const auto course = read(newer);
  ASSERT_FALSE(course);
  EXPECT_EQ(course.error().code, ErrorCode::newerFormat);
  EXPECT_NE(course.error().sentence().find("7"), std::string::npos);
}

TEST(Course, ThatIsNotThereIsNotFound) {
  const auto course = readCourse("/nowhere/course.json");
  ASSERT_FALSE(course);
  EXPECT_EQ(course.error().code, ErrorCode::notFound);
}

}  // namespace
}  // namespace ew::course_test
