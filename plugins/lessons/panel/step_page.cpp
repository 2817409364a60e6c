#include "panel/step_page.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>

#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/scroll_rows.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace ew::lessons {

namespace {

QString minutes(double seconds) {
  const int all = static_cast<int>(std::ceil(seconds));
  return QStringLiteral("%1:%2").arg(all / 60).arg(all % 60, 2, 10, QLatin1Char('0'));
}

}  // namespace

StepPage::StepPage(sdk::Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * kGrid_px, kGrid_px, 2 * kGrid_px, 2 * kGrid_px);
  column->setSpacing(kGrid_px);
  auto* top = new QHBoxLayout;
  auto* leave = new QPushButton(tr("Leave"));
  leave->setObjectName(QStringLiteral("leaveLesson"));
  leave->setToolTip(tr("Back to the lessons; the lesson can be gone on with later"));
  connect(leave, &QPushButton::clicked, this, &StepPage::leaveAsked);
  head_ = quietLabel({});
  head_->setObjectName(QStringLiteral("stepNumber"));
  head_->setWordWrap(false);
  time_ = quietLabel({});
  time_->setObjectName(QStringLiteral("stepTime"));
  time_->setWordWrap(false);
  top->addWidget(leave);
  top->addWidget(head_, 1);
  top->addWidget(time_);
  column->addLayout(top);
  bar_ = new QProgressBar;
  bar_->setTextVisible(false);
  bar_->setFixedHeight(kGrid_px / 2);
  column->addWidget(bar_);
  scrolled_ = new ScrollRows;
  rows_ = scrolled_->rows();
  column->addWidget(scrolled_, 1);
  missing_ = quietLabel({});
  missing_->setObjectName(QStringLiteral("stepMissing"));
  column->addWidget(missing_);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGrid_px);
  pause_ = new QPushButton(tr("Pause"));
  pause_->setObjectName(QStringLiteral("pauseStep"));
  pause_->setCheckable(true);
  connect(pause_, &QPushButton::toggled, this, [this](bool paused) {
    pause_->setText(paused ? tr("Go on") : tr("Pause"));
    Q_EMIT pauseAsked(paused);
  });
  auto* skip = new QPushButton(tr("Skip"));
  skip->setObjectName(QStringLiteral("skipStep"));
  skip->setToolTip(tr("Leave this step out; it counts as not passed"));
  connect(skip, &QPushButton::clicked, this, &StepPage::skipAsked);
  done_ = new QPushButton(tr("Done"));
  done_->setObjectName(QStringLiteral("stepDone"));
  setLook(done_, Look::primary);
  connect(done_, &QPushButton::clicked, this, &StepPage::doneAsked);
  buttons->addWidget(pause_);
  buttons->addWidget(skip);
  buttons->addStretch(1);
  buttons->addWidget(done_);
  column->addLayout(buttons);
}

StepPage::~StepPage() = default;

void StepPage::clear() {
  scrolled_->clear();
  live_ = hint_ = mark_ = compassText_ = outlineText_ = nullptr;
  hintButton_ = pointButton_ = play_ = nullptr;
  options_ = nullptr;
  number_ = nullptr;
}

void StepPage::setHead(const QString& text, int value, int most) {
  head_->setText(text);
  bar_->setRange(0, most);
  bar_->setValue(value);
  bar_->setAccessibleName(text);
}

void StepPage::end() {
  asking_.reset();
  pointShown_.reset();
  aids_.reset();
  expert_.reset();
  run_ = nullptr;
}

QLabel* StepPage::addText(const QString& text, const char* name, bool quiet) {
  auto* label = quiet ? quietLabel(text) : new QLabel(text);
  label->setObjectName(QLatin1String(name));
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setFocusPolicy(Qt::NoFocus);
  rows_->addWidget(label);
  return label;
}

void StepPage::showStep(LessonRun& run, const LessonStep& shown, const StepScene& scene, std::optional<ScanRecording> recording,
                        const std::filesystem::path& image) {
  end();
  clear();
  run_ = &run;
  point_.reset();
  watched_ = false;
  const auto count = static_cast<int>(run.lesson().steps.size());
  const int number = static_cast<int>(run.at()) + 1;
  setHead(tr("Step %1 of %2").arg(number).arg(count), number, count);
  {
    const QSignalBlocker quiet(pause_);
    pause_->setChecked(false);
    pause_->setText(tr("Pause"));
  }
  // What is read is not worked on: one click leads on, and nothing runs that could rest.
  const bool isRead = std::holds_alternative<ReadingTask>(shown.task);
  done_->setText(isRead ? tr("Go on") : tr("Done"));
  pause_->setVisible(!isRead || shown.time_s.has_value());
  auto* title = headingLabel(words(shown.title));
  title->setObjectName(QStringLiteral("stepTitle"));
  title->setWordWrap(true);
  rows_->addWidget(title);
  if (!shown.text.empty()) addText(words(shown.text), "stepText");
  if (!image.empty()) addImage(image);
  if (!shown.lookFor.empty()) addText(tr("Look for: %1").arg(words(shown.lookFor)), "stepLookFor", true);
  if (const auto* answer = std::get_if<AnswerTask>(&shown.task)) addAnswer(*answer);
  if (std::holds_alternative<PointTask>(shown.task)) addPointing();
  if (const auto* watch = std::get_if<WatchTask>(&shown.task); watch != nullptr && recording) addExpert(*watch, std::move(*recording));
  if (shown.feedback) {
    live_ = addText({}, "stepLive");
    live_->hide();
  }
  makeCompass(shown, scene);
  aids_ = std::make_unique<AidsDrawer>(host_, shown, scene);
  addAids(shown);
  if (!shown.hints.empty()) {
    hintButton_ = new QPushButton(tr("Show a hint"));
    hintButton_->setObjectName(QStringLiteral("showHint"));
    hint_ = addText({}, "stepHint", true);
    hint_->hide();
    rows_->addWidget(hintButton_, 0, Qt::AlignLeft);
    connect(hintButton_, &QPushButton::clicked, this, [this, hints = shown.hints] {
      if (run_ == nullptr || !run_->nextHint()) return;
      const auto given = static_cast<std::size_t>(run_->hintsGiven());
      QStringList texts;
      for (std::size_t n = 0; n < given && n < hints.size(); ++n) texts << words(hints[n]);
      hint_->setText(texts.join(QStringLiteral("\n")));
      hint_->show();
      hintButton_->setEnabled(given < hints.size());
      hintButton_->setText(given < hints.size() ? tr("Show another hint") : tr("No more hints"));
    });
  }
  rows_->addStretch(1);
  guard_.begin({}, nullptr);  // refresh() looks at it
  refresh(host_.scan().now_s());
}

void StepPage::see(const ScanState& image) {
  if (aids_) aids_->see(image);
  if (outlineText_ != nullptr && aids_) outlineText_->setVisible(aids_->isTargetElsewhere());
  last_ = image;
}

void StepPage::setFrozen(bool isFrozen) {
  if (pointButton_ != nullptr) pointButton_->setChecked(isFrozen);
}

void StepPage::refresh(double now_s) {
  if (run_ == nullptr || !run_->isRunning()) return;
  const auto left_s = run_->left_s(now_s);
  time_->setText(left_s ? tr("%1 left").arg(minutes(*left_s)) : minutes(std::floor(run_->used_s(now_s))));
  const auto missing = run_->missing(handed());
  missing_->setText(missing ? words(*missing) : QString());
  missing_->setVisible(missing.has_value());
  done_->setEnabled(!missing && !guard_.isActive());
  showCompass();
  if (live_ == nullptr) return;
  QStringList lines;
  for (const LiveFigure& figure : run_->live())
    lines << (figure.good ? QStringLiteral("\u2713  ") : QStringLiteral("\u2022  ")) + words(figure.text);
  live_->setText(lines.join(QLatin1Char('\n')));
  live_->setVisible(!lines.isEmpty());
}

}  // namespace ew::lessons
