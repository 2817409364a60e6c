#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ew/core/data_file.h"
#include "ew/core/result.h"

namespace ew {

inline constexpr int kCourseFormat = 1;  ///< `format` of a course; a file with a larger one is refused with newerFormat

/// A lesson by the case that holds it.
struct CourseLesson {
  std::string caseId;
  std::string lessonId;
  bool operator==(const CourseLesson&) const = default;
};

/// Lessons of several cases in the order in which they are best learnt.
struct Course {
  std::string id;
  Words title;
  Words text;  ///< what it leads to
  std::vector<CourseLesson> lessons;
  bool operator==(const Course&) const = default;
};

/// {"format": 1, "id": "basics", "title": {"en": ..., "de": ...}, "text": {"en": ..., "de": ...},
/// "lessons": [{"case": "upper-abdomen-normal", "lesson": "first-movements"}, ...]}, each lesson once. Whether they are there is for the
/// library to say.
/// @error notFound, notReadable, tooLarge, badHeader, badField (field name, value found, value expected), newerFormat
[[nodiscard]] Result<Course> readCourse(const std::filesystem::path& file);

/// The course of the shipped cases: cases/course.json. @error as shippedCasesFolder
[[nodiscard]] Result<std::filesystem::path> shippedCourseFile();

}  // namespace ew
