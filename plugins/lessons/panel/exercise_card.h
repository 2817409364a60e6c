#pragma once

#include <QWidget>
#include <chrono>

#include "ew/library/case.h"
#include "ew/library/case_words.h"
#include "logic/exercises.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace ew::lessons {

/// Below the lessons of a case: exercises that the program makes of it, how one stands with them, and who learns.
class ExerciseCard final : public QWidget {
  Q_OBJECT

 public:
  explicit ExerciseCard(QWidget* parent = nullptr);
  /// @param allLessonsFinished then what gives a finding away is asked for, too
  void showCase(const Case& opened, const CaseWords& words, const std::vector<RepetitionState>& states, bool allLessonsFinished);
  [[nodiscard]] bool withFindings() const;
  /// Whether the program could make exercises of a case: whether it has targets or measurements at all.
  [[nodiscard]] static bool couldAsk(const Case& opened);

 Q_SIGNALS:
  void startAsked();
  void personChanged();

 private:
  QLabel* state_ = nullptr;
  QLabel* weakest_ = nullptr;
  QLabel* strongest_ = nullptr;
  QCheckBox* findings_ = nullptr;
  QPushButton* start_ = nullptr;
  QWidget* exercises_ = nullptr;
  QLineEdit* person_ = nullptr;
  QString folder_;
};

}  // namespace ew::lessons
