#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <functional>
#include <memory>
#include <vector>

#include "ew/sdk/overlays.h"

class QPainter;

namespace ew::ui {

/// What plugins draw over the views, and how it is painted: on the scan in the colours that are read against black, over the body in those
/// of the window.
class HostOverlays final : public QObject, public sdk::Overlays {
  Q_OBJECT

 public:
  explicit HostOverlays(QObject* parent = nullptr);

  [[nodiscard]] std::shared_ptr<sdk::ScanOverlay> overScan() override;
  [[nodiscard]] std::shared_ptr<sdk::BodyOverlay> overBody() override;
  [[nodiscard]] sdk::Ticket showInBody(const sdk::BodyAids& aids) override;
  [[nodiscard]] std::shared_ptr<sdk::HandlesOverlay> showHandles(const sdk::BodyHandles& handles, sdk::HandlesMoved moved) override;
  [[nodiscard]] sdk::Ticket askForBodyPoint(const std::string& hint, std::function<void(const Point<frame::World>&)> pointed,
                                            std::function<void()> stopped) override;

  /// Handles of a plugin's: where they stand, and who is told.
  struct Handles {
    sdk::BodyHandles shown;
    sdk::HandlesMoved moved;
  };
  /// Those that were asked for last; null: none.
  [[nodiscard]] std::shared_ptr<Handles> handles() const { return handles_.empty() ? nullptr : handles_.back(); }
  struct Asking {
    QString hint;
    std::function<void(const Point<frame::World>&)> pointed;
    std::function<void()> stopped;
  };
  /// Who asks for a place on the body; null: nobody.
  [[nodiscard]] std::shared_ptr<const Asking> asking() const { return askings_.empty() ? nullptr : askings_.back(); }
  /// The user does not want to be asked any more.
  void stopAsking();

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
  void handlesChanged();
  void askingChanged();

 private:
  template <class Drawing>
  class Shown;
  template <class Drawing>
  [[nodiscard]] std::shared_ptr<Shown<Drawing>> made(std::vector<std::weak_ptr<Shown<Drawing>>>& all, void (HostOverlays::*changed)());
  std::vector<std::weak_ptr<Shown<sdk::ScanDrawing>>> scan_;
  std::vector<std::weak_ptr<Shown<sdk::BodyDrawing>>> body_;
  std::vector<std::shared_ptr<const sdk::BodyAids>> aids_;
  class HandlesEntry;
  std::vector<std::shared_ptr<Handles>> handles_;
  std::vector<std::shared_ptr<const Asking>> askings_;
};

}  // namespace ew::ui
