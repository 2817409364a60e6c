#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QListWidget;
class QPushButton;

namespace ew {
class NumberField;
}
namespace ew::sdk {
class Files;
}

namespace ew::stitching {

class AlignmentEdits;
class ProjectDocument;
class ProjectInputs;
class StitchLook;
class StitchResults;
class StitchSession;

/// The project's subvolumes: name, size, where the place comes from, and what holds each. Rows are renamed, moved and taken off here; the
/// chosen one's place is told below them.
class VolumeList final : public QWidget {
  Q_OBJECT

 public:
  explicit VolumeList(StitchSession& session, QWidget* parent = nullptr);
  /// Shows the project as it is now. The panel calls it with its own refresh, so that nothing is laid out twice.
  void refresh();

 Q_SIGNALS:
  void problem(const QString& sentence);  ///< empty: none any more

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* makeChosenBox();
  QWidget* makeSweepRow();
  void showSweepRow();
  void chooseCalibration();
  void chooseTransform();
  void removeChosen();
  void moveChosen(int step);

  sdk::Files& files_;
  ProjectDocument& document_;
  ProjectInputs& inputs_;
  const StitchResults& results_;
  StitchLook& look_;
  AlignmentEdits& edits_;
  QListWidget* list_ = nullptr;
  QWidget* chosenBox_ = nullptr;
  QComboBox* placement_ = nullptr;
  QWidget* sweepRow_ = nullptr;  ///< how the chosen sweep becomes a volume
  QPushButton* calibration_ = nullptr;
  NumberField* sweepSpacing_ = nullptr;
  QCheckBox* acceptsSmall_ = nullptr;
  bool showing_ = false;
};

}  // namespace ew::stitching
