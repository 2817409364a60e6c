#pragma once

#include <QObject>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ew/library/case.h"
#include "ew/library/lesson_links.h"
#include "ew/sdk/host.h"
#include "logic/lesson_edits.h"

namespace ew::lessons {

/// The lessons of the open case while an author edits them. They, and the history of edits, are the case's own: every edit goes to the host
/// as one undoable step, and what comes back from there is what is shown.
class LessonDocument final : public QObject {
  Q_OBJECT

 public:
  explicit LessonDocument(sdk::Host& host, QObject* parent = nullptr);

  [[nodiscard]] sdk::Host& host() const { return host_; }
  [[nodiscard]] const std::optional<Case>& home() const { return home_; }  ///< the open case; empty: none is open
  [[nodiscard]] const Lessons& lessons() const { return lessons_; }
  /// Why the lessons cannot be edited; empty: they can.
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }
  /// parts/lessons of the open case.
  [[nodiscard]] std::filesystem::path folder() const;

  /// One step of undo named `what`; edits with the same mergeKey in a row become one. What the edit leaves as it is, is none.
  /// @error badField (then nothing changed, and what was typed under that key before is taken back as well), notFound (no case is open)
  using Edit = std::function<Lessons(Lessons)>;
  Result<void> edit(const QString& what, const std::string& mergeKey, const Edit& edit);
  /// While changed() is told: whether an edit from here is its cause, so that fields are as the user typed them.
  [[nodiscard]] bool isEditing() const { return editing_; }

  /// What keeps a lesson from being worked through. Of steps that scan another case nothing until library() was read.
  [[nodiscard]] std::vector<LessonProblem> problemsOf(const Lesson& lesson);
  /// Cases that a step may scan besides this one; read in a job, once for each case that is opened, when first asked for. Empty until then;
  /// changed() tells of it.
  [[nodiscard]] const std::vector<Case>& library();
  /// What a step scans; null: its case is not in the library, or none is open.
  [[nodiscard]] const Case* scannedBy(const LessonStep& step);
  /// Before files are put into folder(): a shipped case is copied first, which the user is asked about. @error as Cases::makeOwn
  [[nodiscard]] Result<void> makeOwn();

 Q_SIGNALS:
  void changed();  ///< the case, its lessons or its saved state
  void opened();   ///< another case is open, or none

 private:
  void read();
  void readLibrary();
  [[nodiscard]] const Case* caseById(const std::string& id);

  sdk::Host& host_;
  std::optional<Case> home_;
  Lessons lessons_;
  std::optional<Error> problem_;
  bool editing_ = false;
  std::string typedIn_;   ///< merge key of the last edit
  Lessons beforeTyping_;  ///< as they were before the edits under that key
  std::optional<std::vector<Case>> library_;
  std::vector<Case> noCases_;  ///< what is known before it was read
  bool isReadingLibrary_ = false;
  int opened_ = 0;  ///< cases so far: what was read for an earlier one is not taken
  std::vector<sdk::Ticket> tickets_;
};

/// One step of one lesson, as its forms edit it.
struct StepEdit {
  LessonDocument& document;
  std::string lessonId, stepId;

  [[nodiscard]] const Lesson* lesson() const { return lessonIn(document.lessons(), lessonId); }
  [[nodiscard]] const LessonStep* step() const;  ///< null: it is not there any more
  /// @param field of the step: edits of one field in a row are one step of undo; empty: each is its own
  Result<void> change(const QString& what, const std::string& field, const std::function<void(LessonStep&)>& change) const;
  /// The same for a step whose task is a Task.
  template <class Task>
  Result<void> changeTask(const QString& what, const std::string& field, const std::function<void(Task&)>& edit) const {
    return change(what, field, [&](LessonStep& step) {
      if (auto* task = std::get_if<Task>(&step.task)) edit(*task);
    });
  }
  /// The step's task; a Task of its own when the step is gone.
  template <class Task>
  [[nodiscard]] Task task() const {
    const LessonStep* now = step();
    const auto* task = now != nullptr ? std::get_if<Task>(&now->task) : nullptr;
    return task != nullptr ? *task : Task{};
  }
};

}  // namespace ew::lessons
