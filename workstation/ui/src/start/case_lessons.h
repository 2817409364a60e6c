#pragma once

#include <QFrame>

#include "ew/library/index.h"
#include "ew/library/learning_progress.h"

namespace ew::ui {

/// The lessons of a case over its card: how far one has got with each, and a button that opens the case and begins or goes on. Closes with
/// Escape or a click elsewhere.
class CaseLessons final : public QFrame {
  Q_OBJECT

 public:
  CaseLessons(const CaseRow& row, const LearningProgress& standings, QWidget* parent);
  /// Below `card` where there is room, else above it; on the screen in any case.
  void showAt(const QRect& card_global);

 Q_SIGNALS:
  void lessonChosen(const QString& caseFolder, const QString& lessonId);
  void caseChosen(const QString& caseFolder);

 private:
  QWidget* lessonRow(const CaseRow& row, const LessonRow& lesson, const LessonStanding& standing);
};

}  // namespace ew::ui
