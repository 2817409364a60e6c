#include "scan/cine/cine_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPushButton>
#include <QVariant>
#include <QWheelEvent>

#include "ew/widgets/figures.h"
#include "ew/widgets/icons.h"
#include "ew/widgets/look.h"
#include "ew/widgets/time_line.h"
#include "keys/key_tips.h"
#include "scan/cine/bar_parts.h"
#include "scan/session.h"

namespace ew::ui {
namespace {

constexpr int kManyFrames = 10;
constexpr int kNotch = 120;  // what Qt says of a wheel's notch

}  // namespace

CineBar::CineBar(Session& session, QWidget* parent) : QWidget(parent), session_(session) {
  setObjectName(QStringLiteral("cineBar"));
  setLayoutDirection(Qt::LeftToRight);  // as on every player: what comes later stands to the right
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  play_ = smallButton("cinePlay", QString());
  back_ = smallButton("cineBack", tipWithKeys(tr("An image back (%1, wheel; with Shift ten images)"), "cine.back | cine.stepBack"));
  on_ = smallButton("cineOn", tipWithKeys(tr("An image on (%1, wheel; with Shift ten images)"), "cine.on | cine.stepOn"));
  line_ = new TimeLine;
  line_->setObjectName(QStringLiteral("cineLine"));
  line_->setAccessibleName(tr("Time line of what was scanned"));
  line_->setToolTip(tr("Click or drag to another image (arrows: an image, with Shift ten; Home and End)"));
  line_->installEventFilter(this);
  time_ = new FigureLabel(tr("%1 of %2   %3 s").arg(8888).arg(8888).arg(signedFigure(-88.8, 1)));
  time_->setObjectName(QStringLiteral("cineTime"));
  setLook(time_, Look::small);
  time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  time_->setToolTip(tr("Which image is shown, and how long before the freeze it was made"));
  in_ = smallButton("cineIn", tipWithKeys(tr("The loop begins with this image; once more: with the first (%1)"), "cine.in"));
  out_ = smallButton("cineOut", tipWithKeys(tr("The loop ends with this image; once more: with the last (%1)"), "cine.out"));
  speed_ = new QComboBox;
  speed_->setObjectName(QStringLiteral("cineSpeed"));
  speed_->setFocusPolicy(Qt::TabFocus);
  speed_->setToolTip(tr("Speed"));
  speed_->setAccessibleName(tr("Speed"));
  const std::pair<QString, double> speeds[] = {{tr("1/4 ×"), 0.25}, {tr("1/2 ×"), 0.5}, {tr("1 ×"), 1.0}, {tr("2 ×"), 2.0}};
  for (const auto& [text, speed] : speeds) speed_->addItem(text, speed);
  speed_->setCurrentIndex(2);
  save_ = smallButton("cineSave", tr("Save what runs in the loop as a recording"));
  save_->setText(tr("Save clip…"));
  for (QWidget* each : std::initializer_list<QWidget*>{play_, back_, line_, on_, time_, in_, out_, speed_, save_})
    row->addWidget(each, each == line_ ? 1 : 0);
  hide();

  tick_.setInterval(kBarTick_ms);
  tick_.setTimerType(Qt::PreciseTimer);
  connect(&tick_, &QTimer::timeout, this, &CineBar::advance);
  connect(play_, &QPushButton::clicked, this, [this] { setPlaying(!isPlaying()); });
  connect(back_, &QPushButton::clicked, this, [this] { step(-1); });
  connect(on_, &QPushButton::clicked, this, [this] { step(1); });
  connect(in_, &QPushButton::clicked, this, &CineBar::markIn);
  connect(out_, &QPushButton::clicked, this, &CineBar::markOut);
  connect(save_, &QPushButton::clicked, this, &CineBar::saveAsked);
  connect(line_, &TimeLine::moved, this, [this](double position_s) {
    if (!review_) return;
    setPlaying(false);
    goTo(session_.cineLoop().ring().frameAt(session_.cineLoop().ring().frameTime_s(0) + position_s));
  });
  connect(&session_, &Session::frozenChanged, this, &CineBar::follow);
  connect(&session_.cineLoop(), &CineLoop::changed, this, &CineBar::follow);
  connect(&session_.cineLoop(), &CineLoop::replaced, this, [this] {
    if (isOpen()) close();
    follow();
  });
  connect(&session_, &Session::imageChanged, this, [this] {
    if (review_ && session_.cineLoop().frame()) showState();  // not in the moment in which the scan runs on and the ring begins anew
  });
  refreshIcons();
}

void CineBar::watch(QWidget* scan, QWidget* body) {
  scan_ = scan;
  for (QWidget* each : {scan, body}) each->installEventFilter(this);
}

void CineBar::follow() {
  const bool opens = session_.cineLoop().frame().has_value() && session_.cineLoop().ring().frameCount() > 1;
  if (opens == isOpen()) return;
  if (!opens) return close();
  review_.emplace(session_.cineLoop().ring());
  review_->goTo(*session_.cineLoop().frame());
  wheel_ = 0;
  line_->setLength(session_.cineLoop().ring().length_s(), {}, {});
  showState();
  Q_EMIT openChanged(true);
}

void CineBar::close() {
  setPlaying(false);
  review_.reset();
  Q_EMIT openChanged(false);
}

void CineBar::setPlaying(bool playing) {
  if (playing == isPlaying() || (playing && !review_)) return;
  if (playing) {
    sinceTick_.start();
    tick_.start();
  } else {
    tick_.stop();
  }
  showPlaying();
}

void CineBar::showPlaying() {
  const QString tip = isPlaying() ? tipWithKeys(tr("Stop (%1)"), "cine.play") : tipWithKeys(tr("Play in a loop (%1)"), "cine.play");
  play_->setAccessibleName(tip);
  play_->setToolTip(tip);
  play_->setIcon(icon(isPlaying() ? QStringLiteral("pause") : QStringLiteral("play")));
}

void CineBar::advance() {
  // An image that is still being formed is waited for, and the time it takes is not made up for.
  const double passed_s = static_cast<double>(sinceTick_.nsecsElapsed()) * 1e-9 * speed_->currentData().toDouble();
  sinceTick_.restart();
  if (session_.cineLoop().isForming()) return;
  review_->advance(passed_s);
  showFrame();
}

void CineBar::step(int frames) {
  if (!review_) return;
  setPlaying(false);
  review_->step(frames);
  showFrame();
}

void CineBar::goTo(std::size_t frame) {
  if (!review_) return;
  review_->goTo(frame);
  showFrame();
}

void CineBar::markIn() {
  if (!review_) return;
  review_->markIn();
  showState();
}

void CineBar::markOut() {
  if (!review_) return;
  review_->markOut();
  showState();
}

void CineBar::showFrame() {
  session_.cineLoop().show(review_->frame());
  showState();
}

void CineBar::showState() {
  const CineRing& ring = session_.cineLoop().ring();
  const double begin_s = ring.frameTime_s(0), at_s = ring.frameTime_s(review_->frame());
  const std::size_t last = ring.frameCount() - 1;
  line_->setPosition(at_s - begin_s);
  line_->setRange(review_->isInMarked() ? std::optional(ring.frameTime_s(review_->in()) - begin_s) : std::nullopt,
                  review_->isOutMarked() ? std::optional(ring.frameTime_s(review_->out()) - begin_s) : std::nullopt);
  const QString before_s = session_.cineLoop().isForming() ? QStringLiteral("…") : signedFigure(at_s - ring.frameTime_s(last), 1);
  time_->setText(tr("%1 of %2   %3 s").arg(review_->frame() + 1).arg(last + 1).arg(before_s));
}

bool CineBar::handleKey(const QKeyEvent& key) { return run(keys_->meant(key, kWhileStill), (key.modifiers() & Qt::ShiftModifier) != 0); }

bool CineBar::run(const std::string& command, bool far) {
  if (!review_) return false;
  const int frames = far ? kManyFrames : 1;
  if (command == "cine.stepBack") {
    step(-frames);
  } else if (command == "cine.stepOn") {
    step(frames);
  } else if (command == "cine.first") {
    setPlaying(false);
    goTo(0);
  } else if (command == "cine.last") {
    setPlaying(false);
    goTo(session_.cineLoop().ring().frameCount() - 1);
  } else {
    return false;
  }
  return true;
}

void CineBar::stepByWheel(const QWheelEvent& wheel) {
  wheel_ += wheel.angleDelta().y() != 0 ? wheel.angleDelta().y() : wheel.angleDelta().x();
  const int notches = wheel_ / kNotch;  // a touchpad gives fractions
  wheel_ -= notches * kNotch;
  if (notches != 0) step(-notches * ((wheel.modifiers() & Qt::ShiftModifier) != 0 ? kManyFrames : 1));
}

bool CineBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress && handleKey(*static_cast<QKeyEvent*>(event))) {
    event->accept();
    return true;
  }
  if (event->type() == QEvent::Wheel && review_ && watched == scan_) {
    stepByWheel(*static_cast<QWheelEvent*>(event));
    event->accept();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

std::shared_ptr<const ScanRecording> CineBar::clip(const std::string& caseId) const {
  if (!review_ || !session_.subject()) return nullptr;
  return std::make_shared<const ScanRecording>(
      clipOf(session_.cineLoop().ring(), review_->in(), review_->out(), caseId, session_.subject()->title));
}

void CineBar::refreshIcons() {
  back_->setIcon(icon(QStringLiteral("step-back")));
  on_->setIcon(icon(QStringLiteral("step-on")));
  in_->setIcon(icon(QStringLiteral("mark-in")));
  out_->setIcon(icon(QStringLiteral("mark-out")));
  showPlaying();
}

}  // namespace ew::ui
