#pragma once

#include <QTimer>
#include <memory>
#include <optional>

#include "ew/library/voxel_source.h"
#include "ew/scanning/subject.h"
#include "ew/widgets/form_dialog.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace ew {
class ImageChooser;
}

namespace ew::ui {

class Jobs;
class MessageBar;

/// Asks what a sweep leaves open before it becomes a volume: calibration, how the probe moved, frame, spacing, method, which part of the
/// frames; and says beforehand how large the volume will be and what memory it takes. The reconstruction itself is a job.
class ImportDialog final : public FormDialog {
  Q_OBJECT

 public:
  /// @param calibrations device sets that came with it
  ImportDialog(const QString& sweep, const QStringList& calibrations, Jobs& jobs, MessageBar& messages, QWidget* parent);
  ~ImportDialog() override;

 Q_SIGNALS:
  /// The volume in the coordinates of the chosen frame, with coverage. @param provenance null when it was not to be kept
  void imported(const ew::ScanVoxels& voxels, const QString& title, const std::shared_ptr<const ew::Provenance>& provenance);

 private:
  struct Seen;
  struct Frames;
  void addRows();
  void addPoseRows(QFormLayout& form);
  void addMethodRows(QFormLayout& form);
  void addImage();
  [[nodiscard]] QWidget* posesRow();
  void showMotorRows();
  void readAgain();
  void take(const std::shared_ptr<Seen>& found, const Result<void>& outcome);
  void offerFrames(const std::vector<std::string>& names, const QString& suggested);
  void showPlan();
  void refuse(const QString& why);
  void start(bool acceptsSmall = false);
  [[nodiscard]] Result<SweepImportOptions> options() const;

  QString sweep_;
  Jobs& jobs_;
  MessageBar& messages_;
  std::shared_ptr<Seen> seen_;
  std::shared_ptr<Frames> kept_;  ///< the recording, read once; as large as its images, gone with the dialog
  QTimer soon_;
  int reading_ = 0;  ///< job that reads the sweep; 0: none
  QLineEdit* calibration_ = nullptr;
  QComboBox* moved_ = nullptr;
  QWidget* motorFileRow_ = nullptr;
  QLineEdit* motorFile_ = nullptr;
  QWidget* stepRow_ = nullptr;
  QWidget* posesFileRow_ = nullptr;
  QLineEdit* posesFile_ = nullptr;
  QDoubleSpinBox* timeOffset_ = nullptr;
  QDoubleSpinBox* step_ = nullptr;
  QDoubleSpinBox* axisBehindFace_ = nullptr;
  QComboBox* frame_ = nullptr;
  QDoubleSpinBox* spacing_ = nullptr;
  bool spacingChosen_ = false;  ///< by a person: the device set does not change it any more; the two below likewise
  bool interpolationChosen_ = false;
  bool compoundingChosen_ = false;
  bool fillChosen_ = false;
  QComboBox* interpolation_ = nullptr;
  QComboBox* compounding_ = nullptr;
  QDoubleSpinBox* fill_ = nullptr;
  QLineEdit* clip_ = nullptr;
  QLineEdit* fan_ = nullptr;
  QCheckBox* keepSource_ = nullptr;
  QLabel* frames_ = nullptr;
  QLabel* size_ = nullptr;
  QLabel* memory_ = nullptr;
  QLabel* notes_ = nullptr;
  ImageChooser* image_ = nullptr;
  QPushButton* make_ = nullptr;
};

}  // namespace ew::ui
