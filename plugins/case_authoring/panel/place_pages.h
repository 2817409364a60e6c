#pragma once

#include <QWidget>

#include "ew/sdk/host.h"
#include "ew/sdk/scan.h"
#include "panel/structure_page.h"

namespace ew::case_authoring {

/// A point among the targets: where it lies, clicked in the scan, and how near is near enough.
class PointPage final : public QWidget {
  Q_OBJECT

 public:
  explicit PointPage(sdk::Host& host, QWidget* parent = nullptr);
  void setTarget(const CaseTarget& target);
  /// Nobody asks for a click any more.
  void rest();

  TargetChange change;

 private:
  void ask(bool on);

  sdk::Host& host_;
  QLabel* where_ = nullptr;
  QPushButton* click_ = nullptr;
  QDoubleSpinBox* tolerance_ = nullptr;
  sdk::Ticket asking_;
};

/// A plane among the targets: taken from the probe, with tolerances, and how far the probe is from it now, as a trainee is judged.
class PlanePage final : public QWidget {
  Q_OBJECT

 public:
  explicit PlanePage(sdk::Host& host, QWidget* parent = nullptr);
  void setTarget(const Case& shown, const CaseTarget& target);
  void see(const ScanState& image);

  TargetChange change;
  std::function<void(const QString& sentence)> onSaid;

 private:
  /// @param key of edits in a row
  QDoubleSpinBox* addTolerance(class QFormLayout* form, const QString& text, std::optional<double> CaseTarget::*tolerance, const char* key,
                               double highest, const QString& unit, const char* name);

  sdk::Host& host_;
  Transform<frame::World, frame::File> fileToWorld_;
  CaseTarget target_;
  QLabel* away_ = nullptr;
  QPushButton* go_ = nullptr;
  QDoubleSpinBox *position_ = nullptr, *angle_ = nullptr;
};

/// Where the image plane of an image lies in the frame of the case's file.
[[nodiscard]] Transform<frame::File, frame::Probe> planeInFile(const Case& shown, const ScanState& image);

}  // namespace ew::case_authoring
