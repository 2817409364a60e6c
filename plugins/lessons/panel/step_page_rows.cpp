#include "ew/widgets/fields.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/step_page.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPixmap>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>
#include <algorithm>

#include "panel/aid_words.h"

namespace ew::lessons {

void StepPage::addAids(const LessonStep& step) {
  auto on = std::make_shared<LessonAids>(step.aids);
  for (const AidWords& aid : kAidWords) {
    if (!(step.aids.*aid.aid)) continue;
    auto* box = new QCheckBox(aidText(aid));
    box->setObjectName(QStringLiteral("aid"));
    box->setChecked(true);
    rows_->addWidget(box);
    connect(box, &QCheckBox::toggled, this, [this, on, which = aid.aid](bool checked) {
      (*on).*which = checked;
      if (aids_) aids_->setAids(*on);
      if (outlineText_ != nullptr && aids_) outlineText_->setVisible(aids_->isTargetElsewhere());
      wantsCompass_ = on->compass;
      showCompass();
    });
    if (aid.aid != &LessonAids::outline) continue;
    outlineText_ = addText(tr("What is sought is not in this image."), "outlineElsewhere", true);
    outlineText_->hide();
  }
  aids_->setAids(*on);
}

void StepPage::addAnswer(const AnswerTask& task) {
  if (task.options.empty()) {
    number_ = new NumberField(-1e9, 1e9, 2, words(task.unit));
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
    line->setSpacing(kGrid_px);
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
  pointButton_->setToolTip(
      tr("Freezes the image, where a click points; on the keyboard arrows and Enter. Freezing the image does the same."));
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
  // Above the text, which is longer for one mark than for another: the button stays under the hand.
  play_ = new QPushButton(tr("Play"));
  play_->setObjectName(QStringLiteral("playExpert"));
  rows_->addWidget(play_, 0, Qt::AlignLeft);
  mark_ = addText({}, "expertMark");
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
  play_->setText(expert_->isPlaying()  ? tr("Stop here")
                 : expert_->hasEnded() ? tr("Play again")
                 : mark != nullptr     ? tr("Play on")
                                       : tr("Play"));
}

void StepPage::addImage(const std::filesystem::path& file) {
  const QPixmap image(words(file.string()));
  if (image.isNull()) {
    addText(tr("The image '%1' cannot be shown.").arg(words(file.filename().string())), "stepPicture", true);
    return;
  }
  auto* label = new QLabel;
  label->setObjectName(QStringLiteral("stepPicture"));
  const int width = std::max(200, this->width() - 5 * kGrid_px);
  label->setPixmap(image.width() > width ? image.scaledToWidth(width, Qt::SmoothTransformation) : image);
  rows_->addWidget(label);
}

void StepPage::makeCompass(const LessonStep& step, const StepScene& scene) {
  compass_.reset();
  last_.reset();
  wantsCompass_ = step.aids.compass;
  const auto* task = std::get_if<PlaneTask>(&step.task);
  const auto state = host_.scan().state();
  if (task == nullptr || !step.aids.compass || !scene.scanned.skin || !state) return;
  for (const ReferencePlane& plane : scene.truth->planes) {
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

Handed StepPage::handed() const {
  Handed made;
  if (options_ != nullptr)
    for (QAbstractButton* option : options_->buttons())
      if (option->isChecked()) made.chosen.push_back(static_cast<std::size_t>(options_->id(option)));
  if (number_ != nullptr && number_->value() > number_->minimum()) made.number = number_->value();
  made.point = point_;
  made.measurements = handedOf(host_.scan().measurements());
  made.watched = watched_;
  return made;
}

}  // namespace ew::lessons
