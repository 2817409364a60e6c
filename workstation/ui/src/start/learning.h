#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "ew/library/learning_progress.h"
#include "ew/widgets/worker.h"

namespace ew::ui {

/// A lesson that was stopped in the middle, with what is needed to show and to open it.
struct ResumableLesson {
  std::filesystem::path caseFolder;
  std::string lessonId;
  std::string title;
  std::size_t step = 1;  ///< that comes next, from 1
  std::size_t steps = 1;
};

/// How far the person who learns has got, read from the attempts of the library on a thread of its own.
class Learning final : public QObject {
  Q_OBJECT

 public:
  struct Known {
    LearningProgress standings;
    std::optional<CourseProgress> course;
    std::optional<ResumableLesson> stopped;
  };

  explicit Learning(QObject* parent = nullptr);
  ~Learning() override;

  /// Reads everything anew.
  void refresh();
  [[nodiscard]] const Known& known() const { return *known_; }
  [[nodiscard]] std::shared_ptr<const Known> shared() const { return known_; }
  [[nodiscard]] bool isBusy() const { return waiting_ > 0; }

 Q_SIGNALS:
  void changed();
  void failed(const ew::Error& error);  ///< each attempt that cannot be read, once

 private:
  void take(std::shared_ptr<const Known> known, const std::vector<Error>& problems);
  std::shared_ptr<const Known> known_ = std::make_shared<const Known>();
  std::set<std::string> told_;
  int waiting_ = 0;
  Worker worker_;
};

}  // namespace ew::ui
