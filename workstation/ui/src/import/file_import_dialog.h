#pragma once

#include <array>
#include <memory>
#include <optional>

#include "ew/library/file_import.h"
#include "ew/scanning/subject.h"
#include "ew/widgets/form_dialog.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace ew {
class ImageChooser;
}

namespace ew::ui {

class Jobs;
class MessageBar;

/// Asks what a DICOM file, a Kretz volume, a folder of images or raw samples leave open, says what of the patient is left out, and
/// imports. Nothing is filled in beforehand: layouts that fit a raw file are offered in a list, with its three middle slices as they would
/// look. Of images the first is shown: parts are chosen by a click on it, and what is to be made black is drawn on it.
class FileImportDialog final : public FormDialog {
  Q_OBJECT

 public:
  /// @param question what the first reading could not decide; empty: nothing
  FileImportDialog(const QString& file, FileKind kind, const QString& question, Jobs& jobs, MessageBar& messages, QWidget* parent);
  ~FileImportDialog() override;

 Q_SIGNALS:
  void imported(const ew::ScanVoxels& voxels, const QString& title);
  /// Images without a place were kept as a sequence: how the probe moved is the next question.
  void sequenceSaved(const QString& file);
  /// The images are a recorded screen, which is cleaned first. The dialog has closed.
  void screenChosen();

 private:
  void addRows();
  void addRawRows(QFormLayout& form);
  void addImageRows(QFormLayout& form);
  void look();
  void takeLook(const ImportPreview& preview);
  void showBlanked();
  void blankMore(const PixelRect& rect);
  void blankLess(int number);
  void showPreview();
  void takePreview(const RawPreview& slices, const RawLayout& layout, const Result<void>& outcome);
  void refuse(const QString& why);
  void start(bool acceptsSmall = false);
  void askSmall(const QString& sentence);
  struct Made;
  void take(const std::shared_ptr<Made>& made);
  void saveSequence(const std::shared_ptr<Made>& made);
  [[nodiscard]] Result<std::vector<PixelRect>> blanked() const;
  [[nodiscard]] Result<ImportAnswers> answers() const;
  [[nodiscard]] RawLayout rawLayout() const;

  QString file_;
  FileKind kind_;
  Jobs& jobs_;
  MessageBar& messages_;
  int job_ = 0;
  int preview_ = 0;  ///< job that reads the slices of the layout as it stands; 0: none
  QComboBox* region_ = nullptr;
  std::array<QDoubleSpinBox*, 2> pixel_{};
  std::array<QDoubleSpinBox*, 3> spacing_{};
  QComboBox* colour_ = nullptr;
  QSpinBox* timeStep_ = nullptr;
  QDoubleSpinBox* rate_ = nullptr;
  QLineEdit* blank_ = nullptr;
  QCheckBox* keepText_ = nullptr;
  QCheckBox* mirrored_ = nullptr;
  QComboBox* guess_ = nullptr;
  std::array<QSpinBox*, 3> dims_{};
  QComboBox* type_ = nullptr;
  QCheckBox* bigEndian_ = nullptr;
  QSpinBox* offset_ = nullptr;
  std::array<QLabel*, 3> slices_{};
  ImageChooser* image_ = nullptr;
  QLabel* removed_ = nullptr;
  QPushButton* import_ = nullptr;
};

}  // namespace ew::ui
