#pragma once

#include <QObject>
#include <QPointF>
#include <memory>
#include <optional>

#include "body/host_overlays.h"
#include "ew/bridge/handles.h"
#include "keys/key_map.h"

class QKeyEvent;
class QMouseEvent;
class QPainter;

namespace ew::ui {

class View3D;

/// The mouse and the keys in the 3D view for plugins that move something by handles or ask for a place on the body. What it does not use
/// goes on to the hand.
///   handles   left drag on an arrow or a ring: move along, turn about (Shift: whole mm and degrees); Escape gives back
///             arrows, Page up, Page down: 1 mm as it is seen; with Alt: 1 degree
///   a place   left click on the skin; Escape ends it. Looking around with the other buttons goes on
class BodyTools final : public QObject {
  Q_OBJECT

 public:
  BodyTools(HostOverlays& overlays, View3D& view, QObject* parent = nullptr);
  void setKeys(const KeyMap& keys) { keys_ = &keys; }

  [[nodiscard]] bool isDrawnOver() const;
  /// The sentence of whoever asks, the cross, and what the handle in use does.
  void paintOver(QPainter& painter) const;

 Q_SIGNALS:
  void overChanged();  ///< paintOver has something else to show

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void followHandles();
  void followAsking();
  bool askingEvent(QEvent& event);
  bool handlesEvent(QEvent& event);
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  bool key(const QKeyEvent& event);
  void nudge(const std::string& command);
  void endNudge();
  void show(const HostOverlays::Handles& handles);
  void take(const bridge::HandlesToWorld& toWorld, bool isOver);
  void endDrag(bool givesBack);
  void use(const std::optional<bridge::Handle>& handle);
  [[nodiscard]] bridge::Ray rayAt(const QPointF& at) const;
  [[nodiscard]] QString wordsOfUse() const;

  HostOverlays& overlays_;
  View3D& view_;
  const KeyMap* keys_ = &usualKeys();
  std::shared_ptr<HostOverlays::Handles> handles_;  ///< that are shown; null: none
  std::optional<bridge::HandleDrag> drag_;
  double step_ = 0.0;  ///< of the drag, mm or radians
  std::optional<bridge::Handle> used_;
  bool isNudging_ = false;
  std::optional<QPointF> cross_;  ///< where a place would be taken
};

}  // namespace ew::ui
