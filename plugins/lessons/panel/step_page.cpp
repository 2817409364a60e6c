#include "panel/step_page.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPixmap>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ew/sdk/panel.h"

namespace ew::lessons {

using sdk::kGap_px;
using sdk::words;

namespace {

struct AidWords {
  bool LessonAids::*aid;
  const char* text;
};
constexpr AidWords kAidWords[] = {
    {&LessonAids::translucentSkin, QT_TRANSLATE_NOOP("ew::lessons::StepPage", "Translucent skin")},
    {&LessonAids::organs, QT_TRANSLATE_NOOP("ew::lessons::StepPage", "Organs in the body")},
    {&LessonAids::volumeBox, QT_TRANSLATE_NOOP("ew::lessons::StepPage", "What was recorded")},
    {&LessonAids::ownPath, QT_TRANSLATE_NOOP("ew::lessons::StepPage", "My path")},
    {&LessonAids::expertProbe, QT_TRANSLATE_NOOP("ew::lessons::StepPage", "The expert's plane")},
    {&LessonAids::outline, QT_TRANSLATE_NOOP("ew::lessons::StepPage", "Outline in the image")},
    {&LessonAids::compass, QT_TRANSLATE_NOOP("ew::lessons::StepPage", "Next movement")},
};

QString minutes(double seconds) {
  const int all = static_cast<int>(std::ceil(seconds));
  return QStringLiteral("%1:%2").arg(all / 60).arg(all % 60, 2, 10, QLatin1Char('0'));
}

}  // namespace

StepPage::StepPage(sdk::Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * kGap_px, kGap_px, 2 * kGap_px, 2 * kGap_px);
  column->setSpacing(kGap_px);
  auto* top = new QHBoxLayout;
  auto* leave = new QPushButton(tr("Leave"));
  leave->setObjectName(QStringLiteral("leaveLesson"));
  leave->setToolTip(tr("Back to the lessons; the lesson can be gone on with later"));
  connect(leave, &QPushButton::clicked, this, &StepPage::leaveAsked);
  head_ = sdk::quietLabel({});
  head_->setObjectName(QStringLiteral("stepNumber"));
  head_->setWordWrap(false);
  time_ = sdk::quietLabel({});
  time_->setObjectName(QStringLiteral("stepTime"));
  time_->setWordWrap(false);
  top->addWidget(leave);
  top->addWidget(head_, 1);
  top->addWidget(time_);
  column->addLayout(top);
  bar_ = new QProgressBar;
  bar_->setTextVisible(false);
  bar_->setFixedHeight(kGap_px / 2);
  column->addWidget(bar_);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  auto* body = new QWidget;
  rows_ = new QVBoxLayout(body);
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(kGap_px);
  scroll->setWidget(body);
  column->addWidget(scroll, 1);
  missing_ = sdk::quietLabel({});
  missing_->setObjectName(QStringLiteral("stepMissing"));
  column->addWidget(missing_);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGap_px);
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
  done_->setProperty("primary", true);
  connect(done_, &QPushButton::clicked, this, &StepPage::doneAsked);
  buttons->addWidget(pause_);
  buttons->addWidget(skip);
  buttons->addStretch(1);
  buttons->addWidget(done_);
  column->addLayout(buttons);
}

StepPage::~StepPage() = default;

void StepPage::clear() {
  while (QLayoutItem* item = rows_->takeAt(0)) {
    if (item->widget() != nullptr) item->widget()->deleteLater();
    delete item;
  }
  live_ = hint_ = mark_ = compassText_ = nullptr;
  hintButton_ = pointButton_ = play_ = nullptr;
  options_ = nullptr;
  number_ = nullptr;
}

void StepPage::end() {
  asking_.reset();
  pointShown_.reset();
  aids_.reset();
  expert_.reset();
  run_ = nullptr;
}

QLabel* StepPage::addText(const QString& text, const char* name, bool quiet) {
  auto* label = quiet ? sdk::quietLabel(text) : new QLabel(text);
  label->setObjectName(QLatin1String(name));
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setFocusPolicy(Qt::NoFocus);
  rows_->addWidget(label);
  return label;
}

void StepPage::showStep(LessonRun& run, const LessonStep& shown, const StepScene& scene, std::optional<ScanRecording> recording,
                        const std::filesystem::path& picture) {
  end();
  clear();
  run_ = &run;
  point_.reset();
  watched_ = false;
  const auto count = static_cast<int>(run.lesson().steps.size());
  const int number = static_cast<int>(run.at()) + 1;
  head_->setText(tr("Step %1 of %2").arg(number).arg(count));
  bar_->setRange(0, count);
  bar_->setValue(number);
  bar_->setAccessibleName(head_->text());
  {
    const QSignalBlocker quiet(pause_);
    pause_->setChecked(false);
    pause_->setText(tr("Pause"));
  }
  auto* title = sdk::headingLabel(words(shown.title));
  title->setObjectName(QStringLiteral("stepTitle"));
  title->setWordWrap(true);
  rows_->addWidget(title);
  if (!shown.text.empty()) addText(words(shown.text), "stepText");
  if (!picture.empty()) addPicture(picture);
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
  refresh(host_.scan().now_s());
}

void StepPage::addAids(const LessonStep& step) {
  auto on = std::make_shared<LessonAids>(step.aids);
  for (const AidWords& aid : kAidWords) {
    if (!(step.aids.*aid.aid)) continue;
    auto* box = new QCheckBox(tr(aid.text));
    box->setObjectName(QStringLiteral("aid"));
    box->setChecked(true);
    rows_->addWidget(box);
    connect(box, &QCheckBox::toggled, this, [this, on, which = aid.aid](bool checked) {
      (*on).*which = checked;
      if (aids_) aids_->setAids(*on);
      wantsCompass_ = on->compass;
      showCompass();
    });
  }
  aids_->setAids(*on);
}

void StepPage::addAnswer(const AnswerTask& task) {
  if (task.options.empty()) {
    number_ = new sdk::NumberField(-1e9, 1e9, 2, words(task.unit));
    number_->setObjectName(QStringLiteral("answerNumber"));
    number_->setAccessibleName(tr("Your answer"));
    number_->setSpecialValueText(QStringLiteral(" "));  // nothing was entered yet
    number_->setValue(number_->minimum());
    rows_->addWidget(number_, 0, Qt::AlignLeft);
    return;
  }
  const auto right = std::count_if(task.options.begin(), task.options.end(), [](const AnswerOption& one) { return one.right; });
  options_ = new QButtonGroup(this);
  options_->setExclusive(right == 1);
  if (right > 1) addText(tr("More than one answer is right."), "severalRight", true);
  for (std::size_t n = 0; n < task.options.size(); ++n) {
    QAbstractButton* option = right == 1 ? static_cast<QAbstractButton*>(new QRadioButton) : new QCheckBox;
    option->setObjectName(QStringLiteral("answerOption"));
    option->setAccessibleName(words(task.options[n].text));
    options_->addButton(option, static_cast<int>(n));
    auto* line = new QHBoxLayout;
    line->setSpacing(kGap_px);
    line->addWidget(option, 0, Qt::AlignTop);
    auto* label = new QLabel(words(task.options[n].text));  // wraps where the words of a button would be cut off
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setBuddy(option);
    line->addWidget(label, 1);
    auto* row = new QWidget;
    row->setLayout(line);
    line->setContentsMargins(0, 0, 0, 0);
    rows_->addWidget(row);
  }
}

void StepPage::addPointing() {
  pointButton_ = new QPushButton(tr("Point at it"));
  pointButton_->setObjectName(QStringLiteral("pointAtIt"));
  pointButton_->setCheckable(true);
  pointButton_->setToolTip(tr("Then click in the image; on the keyboard arrows and Enter"));
  rows_->addWidget(pointButton_, 0, Qt::AlignLeft);
  pointShown_ = host_.overlays().overScan();
  connect(pointButton_, &QPushButton::toggled, this, [this](bool asks) {
    if (!asks) return asking_.reset();
    static_cast<void>(host_.scan().setFrozen(true));  // what is pointed at must not move away
    asking_ = host_.scan().askForPoint(
        tr("Click what is asked for. Arrows and Enter do the same, Escape ends.").toStdString(),
        [this](const Point<frame::Probe>& at) {
          point_ = at;
          showPoint();
          refresh(host_.scan().now_s());
        },
        [this] { pointButton_->setChecked(false); });
  });
}

void StepPage::showPoint() {
  sdk::ScanDrawing drawing;
  sdk::OverlayLabel<frame::Probe> label;
  label.at = *point_;
  label.role = sdk::OverlayRole::trainee;
  drawing.labels.push_back(std::move(label));
  pointShown_->show(std::move(drawing));
}

void StepPage::addExpert(const WatchTask& task, ScanRecording recording) {
  expert_ = std::make_unique<ExpertPlayer>(host_, std::move(recording), task);
  mark_ = addText({}, "expertMark");
  play_ = new QPushButton(tr("Play"));
  play_->setObjectName(QStringLiteral("playExpert"));
  rows_->addWidget(play_, 0, Qt::AlignLeft);
  connect(play_, &QPushButton::clicked, this, [this] {
    if (!expert_) return;
    if (expert_->isPlaying())
      expert_->rest();
    else
      expert_->play();
  });
  connect(expert_.get(), &ExpertPlayer::changed, this, &StepPage::showExpert);
  showExpert();
}

void StepPage::showExpert() {
  if (!expert_) return;
  if (expert_->hasEnded()) watched_ = true;
  const ExpertMark* mark = expert_->mark();
  mark_->setText(mark != nullptr ? words(mark->text) : QString());
  mark_->setVisible(mark != nullptr);
  play_->setText(expert_->isPlaying() ? tr("Rest") : expert_->hasEnded() ? tr("Play again") : mark != nullptr ? tr("Go on") : tr("Play"));
}

void StepPage::addPicture(const std::filesystem::path& file) {
  const QPixmap picture(words(file.string()));
  if (picture.isNull()) {
    addText(tr("The picture '%1' cannot be shown.").arg(words(file.filename().string())), "stepPicture", true);
    return;
  }
  auto* label = new QLabel;
  label->setObjectName(QStringLiteral("stepPicture"));
  const int width = std::max(200, this->width() - 5 * kGap_px);
  label->setPixmap(picture.width() > width ? picture.scaledToWidth(width, Qt::SmoothTransformation) : picture);
  rows_->addWidget(label);
}

void StepPage::makeCompass(const LessonStep& step, const StepScene& scene) {
  compass_.reset();
  last_.reset();
  wantsCompass_ = step.aids.compass;
  const auto* task = std::get_if<PlaneTask>(&step.task);
  const auto state = host_.scan().state();
  if (task == nullptr || !step.aids.compass || !scene.scanned.skin || !state) return;
  for (const ExpectedPlane& plane : scene.truth->planes) {
    if (plane.name != task->target) continue;
    PlaneTolerance tolerance = toleranceOf(plane);
    tolerance.position_mm = task->positionTolerance_mm.value_or(tolerance.position_mm);
    tolerance.angle_deg = task->angleTolerance_deg.value_or(tolerance.angle_deg);
    const PlaneTarget target = targetOf(plane, *scene.truth, resolvedDepth_mm(state->probe, state->knobs));
    compass_ = Compass{compassTargetOf(target, tolerance, *scene.scanned.skin), scene.scanned.skin, {}};
    compassText_ = addText({}, "stepCompass");
    compassText_->hide();
    return;
  }
}

void StepPage::showCompass() {
  if (compassText_ == nullptr) return;
  if (!compass_ || !wantsCompass_ || !last_ || last_->pose.status != PoseStatus::ok) return compassText_->hide();
  compass_->advice = nextMovement(compass_->target, holdFor(last_->pose, *compass_->skin), compass_->advice);
  compassText_->setText(words(compass_->advice->text));
  compassText_->show();
}

void StepPage::see(const ScanState& image) {
  if (aids_) aids_->see(image);
  last_ = image;
}

Handed StepPage::handed() const {
  Handed made;
  if (options_ != nullptr)
    for (QAbstractButton* option : options_->buttons())
      if (option->isChecked()) made.chosen.push_back(static_cast<std::size_t>(options_->id(option)));
  if (number_ != nullptr && number_->value() > number_->minimum()) made.number = number_->value();
  made.point = point_;
  made.measurements = host_.scan().measurements();
  made.watched = watched_;
  return made;
}

void StepPage::refresh(double now_s) {
  if (run_ == nullptr || !run_->isRunning()) return;
  const auto left_s = run_->left_s(now_s);
  time_->setText(left_s ? tr("%1 left").arg(minutes(*left_s)) : minutes(std::floor(run_->used_s(now_s))));
  const auto missing = run_->missing(handed());
  missing_->setText(missing ? words(*missing) : QString());
  missing_->setVisible(missing.has_value());
  done_->setEnabled(!missing);
  showCompass();
  if (live_ == nullptr) return;
  QStringList lines;
  for (const LiveFigure& figure : run_->live())
    lines << (figure.good ? QStringLiteral("\u2713  ") : QStringLiteral("\u2022  ")) + words(figure.text);
  live_->setText(lines.join(QLatin1Char('\n')));
  live_->setVisible(!lines.isEmpty());
}

}  // namespace ew::lessons
