#pragma once

#include <QKeyEvent>
#include <QMetaType>
#include <QObject>
#include <functional>
#include <memory>

#include "ew/tracking/pose_source.h"

class QMouseEvent;
class QWheelEvent;

namespace ew::ui {

class KeyMap;
class View3D;

/// The mouse and the keyboard move the hand. Watches the 3D view and the scan view and says how the probe is to be held from now on; who
/// owns the hand holds it so.
///   3D view    left drag on probe or body: slide, the contact follows the pointer; click elsewhere on the skin: put it there
///              right drag: orbit; middle drag: pan; Ctrl or Alt + right drag, or pinch: zoom
///   scan view  left drag: slide along lateral and elevational
///   both       wheel: tilt; Shift + wheel: rock; Ctrl + wheel: rotate
///   keys       arrows: slide 2 mm (Shift: 10 mm), Q/E: rotate, A/D: rock, W/S: tilt, Home: back to the start
/// It changes nothing while disabled (setEnabled) except the camera, and says that it refused.
class HandInput : public QObject {
  Q_OBJECT

 public:
  explicit HandInput(const HandOnSkin& hand, QObject* parent = nullptr);
  ~HandInput() override;

  /// Watches the 3D view; its skin is the one the probe slides on, in both views.
  void watch(View3D* view);
  /// Watches a scan view. @param lateralPerPixel_mm what one pixel to the right in the image is along the probe's lateral axis, in mm;
  ///        negative when the image shows the marker's side at the left (the sign of imageToProbe's first entry)
  void watch(QWidget* scanView, std::function<double()> lateralPerPixel_mm);

  [[nodiscard]] const Hold& hold() const;
  /// Where Home goes.
  void setStartHold(const Hold& hold);
  void setEnabled(bool enabled);
  [[nodiscard]] bool isEnabled() const;

  /// Whose keys act; without a window the usual ones.
  void setKeys(const KeyMap& keys);
  /// Acts on a key as described above. @return whether the key was one of these
  bool handleKey(const QKeyEvent& key, const QWidget* where = nullptr);
  /// Does what a key of a command "hand.…" does. @param far as with Shift @return whether there is such a command
  bool run(const std::string& command, bool far = false, const QWidget* where = nullptr);
  enum class Turn { rotation, rock, tilt };
  /// Turns the probe by so many steps of a key, 2 degrees each.
  void turn(Turn axis, double steps);
  /// Slides along the probe's own axes.
  void slide(double alongLateral_mm, double alongElevational_mm);

 Q_SIGNALS:
  void moved(const ew::Hold& hold);
  void refused();  ///< somebody tried to move the probe while it is disabled

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void change(const Hold& hold);
  void slideOnScreen(glm::dvec2 direction, double length_mm);
  void dragInView(const QPointF& at);
  bool pressInView(const QMouseEvent& event);
  bool moveInView(const QMouseEvent& event);
  bool viewEvent(QEvent* event);
  bool scanEvent(QEvent* event);
  bool turnByWheel(const QWheelEvent& event);

  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ew::ui

Q_DECLARE_METATYPE(ew::Hold)
