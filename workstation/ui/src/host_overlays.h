#pragma once

#include <QObject>
#include <QPointF>
#include <functional>
#include <memory>
#include <vector>

#include "ew/sdk/overlays.h"

class QPainter;

namespace ew::ui {

struct Theme;

/// What plugins draw over the views, and how it is painted: on the scan in the colours that are read against black, over the body in those
/// of the window.
class HostOverlays final : public QObject, public sdk::Overlays {
  Q_OBJECT

 public:
  explicit HostOverlays(QObject* parent = nullptr);

  [[nodiscard]] std::shared_ptr<sdk::ScanOverlay> overScan() override;
  [[nodiscard]] std::shared_ptr<sdk::BodyOverlay> overBody() override;
  [[nodiscard]] sdk::Ticket showInBody(const sdk::BodyAids& aids) override;
  /// What is asked for at last; null: nothing, the user's own choice counts.
  [[nodiscard]] const sdk::BodyAids* aids() const { return aids_.empty() ? nullptr : aids_.back().get(); }

  [[nodiscard]] bool isBodyDrawnOver() const;
  /// @param pixelOf where a point lies in the painter's coordinates
  void paintOverScan(QPainter& painter, const std::function<QPointF(const Point<frame::Probe>&)>& pixelOf) const;
  void paintOverBody(QPainter& painter, const std::function<QPointF(const Point<frame::World>&)>& pixelOf) const;

 Q_SIGNALS:
  void scanChanged();
  void bodyChanged();
  void aidsChanged();

 private:
  template <class Drawing>
  class Shown;
  template <class Drawing>
  [[nodiscard]] std::shared_ptr<Shown<Drawing>> made(std::vector<std::weak_ptr<Shown<Drawing>>>& all, void (HostOverlays::*changed)());
  std::vector<std::weak_ptr<Shown<sdk::ScanDrawing>>> scan_;
  std::vector<std::weak_ptr<Shown<sdk::BodyDrawing>>> body_;
  std::vector<std::shared_ptr<const sdk::BodyAids>> aids_;
};

}  // namespace ew::ui
