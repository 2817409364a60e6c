#pragma once

#include <QDialog>
#include <QTimer>
#include <memory>

#include "ew/core/volume.h"
#include "ew/library/voxel_source.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace ew::ui {

class Jobs;
class MessageBar;

/// Asks what a sweep leaves open before it becomes a volume: calibration, frame, spacing, method; and says beforehand how large the volume
/// will be and what memory it takes. The reconstruction itself is a job.
class ImportDialog final : public QDialog {
  Q_OBJECT

 public:
  ImportDialog(const QString& sweep, Jobs& jobs, MessageBar& messages, QWidget* parent);
  ~ImportDialog() override;

 Q_SIGNALS:
  /// The volume in the coordinates of the chosen frame, with coverage. @param provenance null when it was not to be kept
  void imported(const std::shared_ptr<const ew::Volume>& volume, const QString& title,
                const std::shared_ptr<const ew::Provenance>& provenance);

 private:
  struct Seen;
  void addRows();
  void readAgain();
  void take(const std::shared_ptr<Seen>& found, const Result<void>& outcome);
  void showPlan();
  void refuse(const QString& why);
  void start();
  [[nodiscard]] SweepImportOptions options() const;

  QString sweep_;
  Jobs& jobs_;
  MessageBar& messages_;
  std::shared_ptr<Seen> seen_;
  QTimer soon_;
  int reading_ = 0;  ///< job that reads the sweep; 0: none
  QLineEdit* calibration_ = nullptr;
  QComboBox* frame_ = nullptr;
  QDoubleSpinBox* spacing_ = nullptr;
  QComboBox* interpolation_ = nullptr;
  QComboBox* compounding_ = nullptr;
  QDoubleSpinBox* fill_ = nullptr;
  QCheckBox* keepSource_ = nullptr;
  QLabel* frames_ = nullptr;
  QLabel* size_ = nullptr;
  QLabel* memory_ = nullptr;
  QLabel* notes_ = nullptr;
  QPushButton* make_ = nullptr;
};

}  // namespace ew::ui
