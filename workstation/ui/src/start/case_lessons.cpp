#include "start/case_lessons.h"

#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "start/case_catalogue.h"
#include "start/learning_words.h"

namespace ew::ui {
namespace {

constexpr int kWidth_px = 440;

QLabel* wrapped(const QString& text, const char* name, bool quiet) {
  auto* label = new QLabel(text);
  label->setObjectName(QLatin1String(name));
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  setLook(label, Look::quiet, quiet);
  return label;
}

}  // namespace

CaseLessons::CaseLessons(const CaseRow& row, const LearningProgress& standings, QWidget* parent) : QFrame(parent, Qt::Popup) {
  setObjectName(QStringLiteral("overlay"));
  setAttribute(Qt::WA_DeleteOnClose);
  setAccessibleName(tr("Lessons of %1").arg(words(row.title)));
  setFixedWidth(kWidth_px);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px);
  column->setSpacing(kGrid_px);
  auto* title = wrapped(words(row.title), "caseLessonsTitle", false);
  setLook(title, Look::heading);
  column->addWidget(title);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  auto* body = new QWidget;
  auto* rows = new QVBoxLayout(body);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(2 * kGrid_px);
  for (const LessonRow& lesson : row.lessons) rows->addWidget(lessonRow(row, lesson, standings.of(row.id, lesson.id)));
  rows->addStretch(1);
  scroll->setWidget(body);
  scroll->viewport()->setAutoFillBackground(false);
  body->setAutoFillBackground(false);
  column->addWidget(scroll, 1);
  auto* open = new QPushButton(tr("Open the case without a lesson"));
  open->setObjectName(QStringLiteral("openWithoutLesson"));
  setLook(open, Look::flat);
  connect(open, &QPushButton::clicked, this, [this, folder = wordsOf(row.folder)] {
    Q_EMIT caseChosen(folder);
    close();
  });
  column->addWidget(open, 0, Qt::AlignLeading);
  if (auto* first = findChild<QPushButton*>(QStringLiteral("startLessonOfCase"))) first->setFocus();
}

QWidget* CaseLessons::lessonRow(const CaseRow& row, const LessonRow& lesson, const LessonStanding& standing) {
  const auto steps = static_cast<std::size_t>(std::max(0, lesson.steps));
  auto* made = new QWidget;
  auto* line = new QHBoxLayout(made);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(kGrid_px);
  auto* texts = new QVBoxLayout;
  texts->setSpacing(2);
  texts->addWidget(wrapped(QStringLiteral("%1  %2").arg(standingSign(standing, steps), words(lesson.title)), "lessonOfCase", false));
  QString state = tr("%1, about %2 min · %3").arg(levelWords(lesson.level)).arg(lesson.minutes).arg(standingWords(standing, steps));
  if (standing.last) state = tr("%1, last on %2").arg(state, dayWords(*standing.last));
  texts->addWidget(wrapped(state, "lessonOfCaseState", true));
  line->addLayout(texts, 1);
  auto* start = new QPushButton(startWords(standing, steps));
  start->setObjectName(QStringLiteral("startLessonOfCase"));
  setLook(start, Look::primary, !standing.isPassed(steps));
  start->setEnabled(steps > 0);
  if (steps == 0) start->setToolTip(tr("This lesson has no steps yet."));
  start->setAccessibleName(tr("%1: %2").arg(start->text(), words(lesson.title)));
  connect(start, &QPushButton::clicked, this, [this, folder = wordsOf(row.folder), id = words(lesson.id)] {
    Q_EMIT lessonChosen(folder, id);
    close();
  });
  line->addWidget(start, 0, Qt::AlignTop);
  return made;
}

void CaseLessons::showAt(const QRect& card_global) {
  adjustSize();
  const QScreen* screen = QGuiApplication::screenAt(card_global.center());
  const QRect room = (screen != nullptr ? screen : QGuiApplication::primaryScreen())->availableGeometry();
  resize(width(), std::min(sizeHint().height() + 2 * kGrid_px, room.height() - 4 * kGrid_px));
  const bool fitsBelow = card_global.bottom() + height() < room.bottom();
  const int y = fitsBelow ? card_global.bottom() + kGrid_px / 2 : std::max(room.top(), card_global.top() - height() - kGrid_px / 2);
  const int x = std::clamp(layoutDirection() == Qt::RightToLeft ? card_global.right() - width() : card_global.left(), room.left(),
                           std::max(room.left(), room.right() - width()));
  move(x, y);
  show();
}

}  // namespace ew::ui
