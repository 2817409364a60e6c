#include "start/course_strip.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "start/learning_words.h"

namespace ew::ui {
namespace {

constexpr int kBarWidth_px = 96;
constexpr int kMostListed_px = 264;

QLabel* label(const char* name, bool quiet) {
  auto* made = new QLabel;
  made->setObjectName(QLatin1String(name));
  made->setTextFormat(Qt::PlainText);
  setLook(made, Look::quiet, quiet);
  made->setWordWrap(true);
  made->setMinimumWidth(80);
  return made;
}

}  // namespace

CourseStrip::CourseStrip(QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("courseStrip"));
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(12, kGrid_px, 12, kGrid_px);
  rows->setSpacing(kGrid_px);

  stopped_ = new QWidget;
  auto* stoppedRow = new QHBoxLayout(stopped_);
  stoppedRow->setContentsMargins(0, 0, 0, 0);
  stoppedRow->setSpacing(2 * kGrid_px);
  stoppedText_ = label("stoppedLesson", false);
  stoppedRow->addWidget(stoppedText_, 1);
  stoppedGoOn_ = new QPushButton(tr("Go on"));
  stoppedGoOn_->setObjectName(QStringLiteral("goOnWithStopped"));
  setLook(stoppedGoOn_, Look::primary);
  stoppedRow->addWidget(stoppedGoOn_);
  rows->addWidget(stopped_);

  course_ = new QWidget;
  auto* courseRow = new QHBoxLayout(course_);
  courseRow->setContentsMargins(0, 0, 0, 0);
  courseRow->setSpacing(2 * kGrid_px);
  auto* texts = new QVBoxLayout;
  texts->setSpacing(2);
  title_ = label("courseTitle", false);
  setLook(title_, Look::heading);
  texts->addWidget(title_);
  progressText_ = label("courseProgress", true);
  texts->addWidget(progressText_);
  courseRow->addLayout(texts, 1);
  bar_ = new QProgressBar;
  bar_->setObjectName(QStringLiteral("courseBar"));
  bar_->setTextVisible(false);
  bar_->setFixedWidth(kBarWidth_px);
  courseRow->addWidget(bar_);
  all_ = new QToolButton;
  all_->setObjectName(QStringLiteral("allLessons"));
  all_->setCheckable(true);
  courseRow->addWidget(all_);
  goOn_ = new QPushButton;
  goOn_->setObjectName(QStringLiteral("goOnWithCourse"));
  courseRow->addWidget(goOn_);
  rows->addWidget(course_);

  scroll_ = new QScrollArea;
  scroll_->setObjectName(QStringLiteral("courseLessons"));
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setFocusPolicy(Qt::NoFocus);
  auto* body = new QWidget;
  lessons_ = new QVBoxLayout(body);
  lessons_->setContentsMargins(0, 0, kGrid_px, 0);
  lessons_->setSpacing(kGrid_px / 2);
  scroll_->setWidget(body);
  scroll_->viewport()->setAutoFillBackground(false);
  body->setAutoFillBackground(false);
  scroll_->hide();
  rows->addWidget(scroll_);

  const auto showAll = [this](bool shown) {
    all_->setText(shown ? tr("Fewer lessons") : tr("All lessons"));
    all_->setToolTip(shown ? tr("Show the next lesson alone") : tr("Show all lessons of the course in their order"));
    scroll_->setVisible(shown);
  };
  showAll(false);
  connect(all_, &QToolButton::toggled, this, showAll);
  connect(stoppedGoOn_, &QPushButton::clicked, this, [this] {
    if (stoppedLesson_) Q_EMIT lessonChosen(wordsOf(stoppedLesson_->caseFolder), words(stoppedLesson_->lessonId));
  });
  connect(goOn_, &QPushButton::clicked, this, [this] {
    if (next_) Q_EMIT lessonChosen(wordsOf(next_->caseFolder), words(next_->lesson.lessonId));
  });
  QFrame::hide();
}

std::vector<QWidget*> CourseStrip::inOrder() const { return {stoppedGoOn_, all_, goOn_}; }

void CourseStrip::show(const Learning::Known& known) {
  showStopped(known.stopped);
  showCourse(known.course);
  setVisible(!stopped_->isHidden() || !course_->isHidden());
}

void CourseStrip::showStopped(const std::optional<ResumableLesson>& stopped) {
  stoppedLesson_ = stopped;
  stopped_->setVisible(stopped.has_value());
  if (!stopped) return;
  const QString title = words(stopped->title);
  stoppedText_->setText(tr("You stopped in step %1 of %2 of the lesson “%3”.").arg(stopped->step).arg(stopped->steps).arg(title));
  stoppedGoOn_->setAccessibleName(tr("Go on with %1").arg(title));
}

void CourseStrip::showCourse(const std::optional<CourseProgress>& course) {
  const bool isThere =
      course && std::any_of(course->steps.begin(), course->steps.end(), [](const CourseStep& each) { return each.isThere(); });
  course_->setVisible(isThere);
  scroll_->setVisible(isThere && all_->isChecked());
  next_.reset();
  if (!isThere) return;
  const auto passed = static_cast<int>(course->passed()), count = static_cast<int>(course->steps.size());
  if (const std::size_t next = course->next(); next < course->steps.size()) next_ = course->steps[next];
  title_->setText(tr("Course: %1").arg(words(course->course.title)));
  title_->setToolTip(words(course->course.text));
  const QString done = tr("%1 of %2 lessons passed").arg(passed).arg(count);
  progressText_->setText(next_ ? tr("%1. Next: %2 (%3)").arg(done, words(next_->title), words(next_->caseTitle))
                               : tr("%1. You have passed all lessons that are here.").arg(done));
  bar_->setRange(0, count);
  bar_->setValue(passed);
  bar_->setAccessibleName(done);
  goOn_->setVisible(next_.has_value());
  if (next_) {
    goOn_->setText(startWords(next_->standing, next_->steps));
    goOn_->setAccessibleName(tr("%1: %2").arg(goOn_->text(), words(next_->title)));
  }
  setLook(goOn_, Look::primary, !stoppedLesson_.has_value());
  listLessons(*course);
}

void CourseStrip::listLessons(const CourseProgress& course) {
  while (QLayoutItem* item = lessons_->takeAt(0)) {
    if (item->widget() != nullptr) item->widget()->deleteLater();
    delete item;
  }
  const std::size_t next = course.next();
  for (std::size_t n = 0; n < course.steps.size(); ++n) lessons_->addWidget(lessonRow(course.steps[n], static_cast<int>(n) + 1, n == next));
  lessons_->addStretch(1);
  fitList();
}

/// As high as the lessons, and no higher than leaves room for the cases below.
void CourseStrip::fitList() {
  const int bar_px = 2 * kGrid_px;
  const int wanted_px = std::max(0, scroll_->widget()->layout()->heightForWidth(std::max(1, width() - 24 - bar_px)));  // -1: no lessons
  scroll_->setFixedHeight(std::min({wanted_px, kMostListed_px, 2 * window()->height() / 5}));
}

QWidget* CourseStrip::lessonRow(const CourseStep& step, int number, bool isNext) {
  auto* row = new QWidget;
  row->setObjectName(QStringLiteral("courseLesson"));
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(kGrid_px);
  auto* sign = new QLabel(step.isThere() ? standingSign(step.standing, step.steps) : QStringLiteral("\u2013"));
  sign->setFixedWidth(2 * kGrid_px);
  line->addWidget(sign);
  auto* texts = new QVBoxLayout;
  texts->setSpacing(0);
  auto* title = label("courseLessonTitle", !step.isThere());
  title->setText(tr("%1. %2").arg(number).arg(step.isThere() ? words(step.title) : words(step.lesson.lessonId)));
  if (isNext) title->setFont(bold(title->font()));
  texts->addWidget(title);
  auto* state = label("courseLessonState", true);
  state->setText(
      step.isThere()
          ? tr("%1 · about %2 min · %3").arg(words(step.caseTitle)).arg(step.minutes).arg(standingWords(step.standing, step.steps))
          : tr("The case of this lesson is not in the library."));
  texts->addWidget(state);
  line->addLayout(texts, 1);
  if (!step.isThere()) return row;
  auto* start = new QPushButton(startWords(step.standing, step.steps));
  start->setObjectName(QStringLiteral("startCourseLesson"));
  start->setAccessibleName(tr("%1: %2").arg(start->text(), words(step.title)));
  connect(start, &QPushButton::clicked, this,
          [this, folder = wordsOf(step.caseFolder), id = words(step.lesson.lessonId)] { Q_EMIT lessonChosen(folder, id); });
  line->addWidget(start);
  return row;
}

void CourseStrip::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  bar_->setVisible(width() > 720);  // words say the same
  fitList();
}

}  // namespace ew::ui
