#pragma once

#include <QWidget>

namespace ew::ui {

/// The ways to move a probe on the skin.
enum class ProbeMotion { none, slide, rock, tilt, rotate };

/// A small drawing of one of them: the probe as it stands, and where it goes. Seen from its broad side where it slides and rocks (along the
/// image's plane), from its narrow side where it tilts (out of it), from above where it rotates.
class ProbeMotionDrawing final : public QWidget {
  Q_OBJECT

 public:
  explicit ProbeMotionDrawing(ProbeMotion motion, QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  ProbeMotion motion_;
};

}  // namespace ew::ui
