#pragma once

#include <QWidget>

#include "ew/tracking/tracked_probe.h"
#include "ew/tracking/tracker_device.h"

class QComboBox;
class QLabel;

namespace ew {
class FigureLabel;
}

namespace ew::ui {

/// What a tracker does at this moment, in figures, and which of the tools it tells of is the probe and which the mannequin's.
class TrackerFigures final : public QWidget {
  Q_OBJECT

 public:
  explicit TrackerFigures(QWidget* parent = nullptr);
  /// @param options what was chosen of the tools and the filter
  void show(const TrackingReport& report, const DeviceStatus& status, const TrackedProbeOptions& options);
  /// Of a tracker that does not run.
  void showNone(const TrackedProbeOptions& options);

 Q_SIGNALS:
  void probeChosen(const QString& tool);  ///< empty: the first that is heard of
  void referenceChosen(const QString& tool);

 private:
  void fillTools(QComboBox& box, const std::vector<std::string>& tools, const std::string& chosen, const QString& none) const;

  FigureLabel *rate_ = nullptr, *delay_ = nullptr, *noise_ = nullptr, *intervals_ = nullptr, *drift_ = nullptr, *filterDelay_ = nullptr;
  QLabel *filter_ = nullptr, *refused_ = nullptr, *noTools_ = nullptr;
  QComboBox *probe_ = nullptr, *reference_ = nullptr;
};

/// "Kalman", "One Euro", ...
[[nodiscard]] QString nameOf(FilterKind kind);

}  // namespace ew::ui
