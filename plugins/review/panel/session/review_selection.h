#pragma once

#include <QObject>
#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "logic/scan_shelf.h"

namespace ew::review {

/// What can be reviewed, and what of it is chosen: lesson, attempt, step, and what the step is compared with. It opens nothing and tells
/// nobody: whoever changes it (ReviewSession) says when the rest has followed.
class ReviewSelection final : public QObject {
  Q_OBJECT

 public:
  ReviewSelection() : shelf_(std::make_shared<const ScanShelf>()) {}

  [[nodiscard]] const ScanShelf& shelf() const { return *shelf_; }
  [[nodiscard]] const std::shared_ptr<const ScanShelf>& sharedShelf() const { return shelf_; }
  /// Whether the shelf was read at all.
  [[nodiscard]] bool hasShelf() const { return hasShelf_; }
  [[nodiscard]] bool isReading() const { return reading_; }
  void setReading(bool reading) { reading_ = reading; }
  /// One that was read anew: the lesson and the attempt that are chosen are looked for in it.
  void takeShelf(std::shared_ptr<const ScanShelf> shelf);

  [[nodiscard]] const LessonAttempts* lesson() const;
  [[nodiscard]] std::optional<std::size_t> lessonNumber() const { return lesson_; }
  [[nodiscard]] const std::pair<std::filesystem::path, Attempt>* attempt() const;  ///< null: none is chosen
  [[nodiscard]] std::optional<std::size_t> attemptNumber() const { return attempt_; }
  [[nodiscard]] const LessonStep* step() const;
  [[nodiscard]] const std::string& stepId() const { return stepId_; }
  void setLesson(std::size_t lesson);    ///< and no attempt and no step of it. @param lesson below their number
  void setAttempt(std::size_t attempt);  ///< and the first of its steps that was recorded. @param attempt below their number
  void setStep(const std::string& stepId) { stepId_ = stepId; }

  /// What the chosen step may be compared with: the expert's scans, then the other attempts that recorded it.
  [[nodiscard]] const std::vector<ScanChoice>& comparisons() const { return comparisons_; }
  [[nodiscard]] std::optional<std::size_t> comparison() const { return comparison_; }
  void setComparison(std::optional<std::size_t> comparison) { comparison_ = comparison; }
  void addComparison(const ScanChoice& choice);  ///< and chooses it; it stays until another attempt or step is chosen
  /// The attempt's step, beside what it is usually compared with; comparisons() are its own from now on.
  [[nodiscard]] std::array<std::optional<ScanChoice>, 2> listScans();

 Q_SIGNALS:
  void shelfChanged();
  void changed();

 private:
  std::shared_ptr<const ScanShelf> shelf_;
  bool hasShelf_ = false, reading_ = false;
  std::optional<std::size_t> lesson_, attempt_, comparison_;
  std::string stepId_;
  std::vector<ScanChoice> comparisons_;
};

}  // namespace ew::review
