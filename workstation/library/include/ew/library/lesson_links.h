#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/library/case.h"
#include "ew/library/lesson.h"

namespace ew {

/// The lessons of a case; none when it has no such section. @error as lessonsFromJson
[[nodiscard]] Result<std::vector<Lesson>> lessonsOf(const Case& home);

/// What still keeps a lesson from being worked through.
struct LessonProblem {
  std::string stepId;  ///< empty: the lesson as a whole
  Message text;
  bool operator==(const LessonProblem&) const = default;
};

/// A case by its id; null when there is none, or nobody knows. The case that holds the lesson is not asked for.
using CaseById = std::function<const Case*(const std::string& id)>;

/// Looks at a lesson beside the cases it refers to: targets and measurements that a case does not have, files that are not there, questions
/// without a right answer, steps and answers that nobody has put into words, a step that is there twice. Empty: it is ready.
/// @param home the case that holds it, with its folder: files are looked for in its parts/lessons
[[nodiscard]] std::vector<LessonProblem> problemsOf(const Lesson& lesson, const Case& home, const CaseById& caseById);

/// Whether a name is one that the editors give to something new, in whatever language of theirs, perhaps with a number: "Answer 2",
/// "Struktur". Nobody wrote it, and a trainee would read it.
[[nodiscard]] bool isGivenName(std::string_view name);

/// Recordings and images in parts/lessons that no lesson of the case names, relative to it, sorted: earlier takes, mostly. They stay
/// until somebody decides, for a step of undo or an edit that a crash has interrupted may name them again.
[[nodiscard]] std::vector<std::string> unusedLessonFiles(const Case& home);

}  // namespace ew
