#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ew/sdk/scan.h"

class QPoint;

namespace ew::ui {

class Calipers;
class PickLayer;
class Session;

/// The scan of a session as plugins see it, and who of them has the probe.
class HostScan final : public QObject, public sdk::Scan {
  Q_OBJECT

 public:
  explicit HostScan(Session& session, QObject* parent = nullptr);

  [[nodiscard]] std::optional<ScanState> state() const override;
  [[nodiscard]] DisplayImage image() const override;
  [[nodiscard]] DisplayGeometry geometry() const override;
  [[nodiscard]] Knobs knobs() const override;
  [[nodiscard]] double now_s() const override;
  [[nodiscard]] sdk::Ticket onEvent(EventCallback callback) override;
  [[nodiscard]] sdk::Ticket drive(std::shared_ptr<const PoseSource> source, std::function<void()> takenBack) override;
  [[nodiscard]] Result<void> placeProbe(const Transform<frame::World, frame::Probe>& probeToWorld) override;
  [[nodiscard]] Result<void> apply(const Knobs& knobs) override;
  [[nodiscard]] Result<void> chooseProbe(const std::string& id) override;
  [[nodiscard]] Result<void> setFrozen(bool frozen) override;
  [[nodiscard]] sdk::Ticket keepSettings() override;
  [[nodiscard]] std::optional<sdk::Scanned> scanned() const override;
  [[nodiscard]] std::vector<sdk::ScanMeasurement> measurements() const override;
  [[nodiscard]] sdk::Ticket onMeasured(std::function<void()> callback) override;
  [[nodiscard]] sdk::Ticket askForPoint(const std::string& hint, std::function<void(const Point<frame::Probe>&)> pointed,
                                        std::function<void()> stopped) override;
  [[nodiscard]] sdk::Ticket askForStroke(sdk::StrokeRequest request) override;
  [[nodiscard]] Result<void> showLabels(std::optional<Volume> labels) override;

  /// Without them nothing is measured and nobody is asked to point. Both must outlive the host.
  void setCalipers(Calipers& calipers);
  void setPointing(PickLayer& layer);

  /// The user wants the probe back: nobody drives it any more, and who did is told.
  void takeProbeBack();

 private:
  struct Driver {
    std::shared_ptr<const PoseSource> source;
    std::function<void()> takenBack;
  };
  struct Asking {
    QString hint;
    std::function<void(const Point<frame::Probe>&)> pointed;
    std::function<void()> stopped;
    std::optional<sdk::StrokeRequest> stroke;  ///< for strokes rather than for a point
  };
  [[nodiscard]] Point<frame::Probe> probePointOf(const QPoint& pixel) const;
  [[nodiscard]] sdk::Ticket ask(Asking asking);
  void tellStroke(const QPoint& pixel, sdk::StrokeRequest::At sdk::StrokeRequest::*told) const;
  void followLatest();
  void askLatest();
  void tellImage();
  void tellMissed();
  void tell(const ScanEvent& event);
  [[nodiscard]] Result<void> mayChange() const;
  [[nodiscard]] Result<void> maySet() const;  ///< of the scan, which must run for it

  Session& session_;
  std::vector<std::shared_ptr<Driver>> drivers_;
  std::vector<std::weak_ptr<EventCallback>> callbacks_;
  Calipers* calipers_ = nullptr;
  std::vector<std::weak_ptr<std::function<void()>>> measured_;
  PickLayer* pointing_ = nullptr;
  std::vector<std::shared_ptr<Asking>> askings_;
  std::optional<ScanState> told_;  ///< the state of the last image that was told; empty: none of this subject
  int subjects_ = 0;               ///< shown so far
};

}  // namespace ew::ui
