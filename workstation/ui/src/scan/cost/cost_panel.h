#pragma once

#include <QDialog>
#include <memory>
#include <optional>

#include "ew/imaging/cost_of_accuracy.h"
#include "jobs/jobs.h"
#include "scan/session.h"

class QButtonGroup;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTimer;
class QVBoxLayout;
class QWidget;

namespace ew::ui {

class CostChart;

/// What accuracy costs on this machine: measures the slicing qualities, and the planes of the slice thickness where the scene has one, on
/// the open volume around the present pose, or the qualities of live echoes where the scan forms them; draws them, marks the setting in
/// use, and sets the fastest that meets an accuracy.
class CostPanel final : public QDialog {
  Q_OBJECT

 public:
  CostPanel(Session& session, Jobs& jobs, QWidget* parent = nullptr);
  ~CostPanel() override;

  void measure();
  void cancel();
  [[nodiscard]] bool isMeasuring() const { return job_ != 0; }
  [[nodiscard]] const std::optional<CostOfAccuracy>& measured() const { return measured_; }

 private:
  void addCurves(QVBoxLayout* rows);    ///< which points are shown
  void addWishes(QVBoxLayout* rows);    ///< what is wanted, and what meets it
  void addProgress(QVBoxLayout* rows);  ///< of measuring, and the buttons below all
  void connectParts();
  [[nodiscard]] const std::vector<CostPoint>& shownPoints() const;
  [[nodiscard]] bool showsPlanes() const;
  [[nodiscard]] bool showsEchoes() const;  ///< whether the scan forms its echoes anew
  [[nodiscard]] bool isInUse(const CostPoint& point) const;
  void take(const Result<void>& outcome, const CostOfAccuracy& result);
  void useFastest();
  void showAll();
  void showLayout();

  Session& session_;
  Jobs& jobs_;
  int job_ = 0;
  std::optional<CostOfAccuracy> measured_;
  QString problem_;
  QString about_;  ///< what the present figures were measured with
  QLabel* reference_ = nullptr;
  QLabel* layout_ = nullptr;
  QWidget* curves_ = nullptr;
  QButtonGroup* curve_ = nullptr;
  CostChart* chart_ = nullptr;
  QDoubleSpinBox* wish_ = nullptr;
  QPushButton* use_ = nullptr;
  QLabel* answer_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* state_ = nullptr;
  QPushButton* again_ = nullptr;
  QTimer* poll_ = nullptr;
};

}  // namespace ew::ui
