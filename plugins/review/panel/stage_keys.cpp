// The keys of the stage: they work while one of its views has the focus.
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPushButton>
#include <QStackedWidget>
#include <algorithm>

#include "panel/body_view.h"
#include "panel/image_view.h"
#include "panel/review_stage.h"
#include "panel/session/playback.h"

namespace ew::review {
namespace {

constexpr double kStep_s = 0.5;

}  // namespace

std::vector<std::pair<std::string, std::string>> ReviewStage::keyLines() {
  const auto line = [](const char* keys, const QString& does) { return std::pair(std::string(keys), does.toStdString()); };
  return {line("Space", tr("play both scans, or rest")),
          line("← →", tr("half a second back or on; with Shift one image")),
          line("Home, End", tr("to the beginning or the end")),
          line("[ ]", tr("the loop begins or ends here; again: no longer")),
          line("N, P", tr("to the next event, or the one before")),
          line("- +", tr("slower or faster")),
          line("T", tr("aligned, or on one clock")),
          line("H", tr("which regions are shown in the body")),
          line("D", tr("draw on the trainee's image")),
          line("C", tr("write a comment at this moment"))};
}

bool ReviewStage::handleKey(const QKeyEvent& event, bool act) {
  if (pages_->currentIndex() != kScansPage) return false;
  if ((event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) != Qt::NoModifier) return false;
  const auto run = [act](auto&& does) {
    if (act) does();
    return true;
  };
  const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
  const ReviewClock& clock = playback_.clock();
  const auto go = [&](int way) { shift ? playback_.stepFrame(way) : playback_.seek(clock.at_s() + way * kStep_s); };
  const auto speed = [&](int way) {
    const int n = std::clamp(speed_->currentIndex() + way, 0, speed_->count() - 1);
    playback_.setSpeed(speed_->itemData(n).toDouble());
  };
  switch (event.key()) {
    case Qt::Key_Space:
      return run([&] { clock.isPlaying() ? playback_.pause() : playback_.play(); });
    case Qt::Key_Left:
      return run([&] { go(-1); });
    case Qt::Key_Right:
      return run([&] { go(1); });
    case Qt::Key_Home:
      return run([&] { playback_.seek(clock.first_s()); });
    case Qt::Key_End:
      return run([&] { playback_.seek(clock.last_s()); });
    case Qt::Key_BracketLeft:
    case Qt::Key_BracketRight:
      return run([&] { playback_.markLoop(event.key() == Qt::Key_BracketLeft); });
    case Qt::Key_N:
    case Qt::Key_P:
      return run([&] { playback_.jump(event.key() == Qt::Key_N); });
    case Qt::Key_Minus:
      return run([&] { speed(-1); });
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return run([&] { speed(1); });
    case Qt::Key_T:
      return run([&] { playback_.setAligned(!playback_.times().isAligned()); });
    case Qt::Key_H:
      return run([&] { heat_->setCurrentIndex((heat_->currentIndex() + 1) % kHeats); });
    case Qt::Key_D:
      return run([&] { chooseTool(tools_.front()->isChecked() ? std::nullopt : std::optional(CommentStroke::Kind::line)); });
    case Qt::Key_C:
      return run([&] { commentText_->setFocus(Qt::ShortcutFocusReason); });
    case Qt::Key_Escape:
      if (reviewed_->drawn().empty()) return false;
      return run([&] { reviewed_->setDrawn({}); });
    default:
      return false;
  }
}

void ReviewStage::keyPressEvent(QKeyEvent* event) {
  if (!handleKey(*event, true)) QWidget::keyPressEvent(event);
}

bool ReviewStage::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && hasFocus() && handleKey(*static_cast<QKeyEvent*>(event), false)) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

/// The views have the focus; the keys are the stage's.
bool ReviewStage::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && handleKey(*static_cast<QKeyEvent*>(event), false)) {
    event->accept();
    return true;
  }
  if (event->type() == QEvent::KeyPress && handleKey(*static_cast<QKeyEvent*>(event), true)) return true;
  return QWidget::eventFilter(watched, event);
}

}  // namespace ew::review
