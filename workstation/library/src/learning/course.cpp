#include "ew/library/course.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "ew/core/json_fields.h"
#include "ew/io/json_files.h"
#include "ew/library/case.h"

namespace ew {
namespace {

constexpr std::size_t kLargestCourse_bytes = 1u << 20;
constexpr std::size_t kMostLessons = 1000;
constexpr std::size_t kLongestTitle = 200;
constexpr std::size_t kLongestText = 20000;

}  // namespace

Result<Course> readCourse(const std::filesystem::path& file) {
  const Message where = verbatim(file.filename().string());
  const auto document = readJsonFile(file, where, kLargestCourse_bytes);
  if (!document) return passOn(document.error());
  JsonReading reading(where, {"note"});
  const JsonFields fields(*document, reading);
  requireFormat(fields, kCourseFormat);
  fields.only({"format", "id", "title", "text", "lessons"});
  Course course;
  course.id = fields.text("id", {}, 1, 100);
  course.title = wordsIn(fields, "title", kLongestTitle);
  course.text = wordsIn(fields, "text", kLongestText);
  for (const JsonFields& each : fields.objects("lessons", 1, kMostLessons)) {
    each.only({"case", "lesson"});
    CourseLesson lesson{each.text("case", {}, 1, 100), each.text("lesson", {}, 1, 100)};
    if (std::find(course.lessons.begin(), course.lessons.end(), lesson) != course.lessons.end())
      each.refuse("lesson", say<"a lesson that the course does not hold yet">());
    course.lessons.push_back(std::move(lesson));
  }
  if (reading.problem()) return passOn(*reading.problem());
  return course;
}

Result<std::filesystem::path> shippedCourseFile() {
  auto folder = shippedCasesFolder();
  if (!folder) return passOn(folder.error());
  return *folder / "course.json";
}

}  // namespace ew
