#pragma once

#include <QTimer>
#include <map>
#include <memory>
#include <optional>

#include "ew/acquisition/screen_edit.h"
#include "ew/measurement/caliper_drawing.h"
#include "ew/widgets/form_dialog.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QSlider;

namespace ew {
class FigureLabel;
}

namespace ew::ui {

struct FilmFrame;
class Jobs;
class MessageBar;
struct FilmReader;
class ScreenView;

/// A film or recorded screen before it comes in: reads it, shows what was found of the scan in it (outline, depth scale, text), lets a
/// person correct that and measure distances in any frame, and stores the cleaned recording alone, under a name the person chooses.
class ScreenDialog final : public FormDialog {
  Q_OBJECT

 public:
  ScreenDialog(const QString& file, Jobs& jobs, MessageBar& messages, QWidget* parent);
  ~ScreenDialog() override;

  /// What was found and corrected; null while it is not known.
  [[nodiscard]] const ScreenEdit* edit() const { return edit_ ? &*edit_ : nullptr; }
  [[nodiscard]] int shownFrame() const { return shownFrame_; }
  /// Whether a person has corrected something that no recording was written with.
  [[nodiscard]] bool isUnsaved() const;
  /// Asks what is to become of the corrections, also while they are being written: writing may fail. @param waits whether the window waits
  /// for what is being written and stays when that fails; else the dialog stays until it is written @return whether it may close
  [[nodiscard]] bool mayLeave(bool waits);

  void reject() override;

 Q_SIGNALS:
  void written(const QString& file);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void addRows();
  void addTurnRows(QFormLayout& form);
  void addScaleRows(QFormLayout& form);
  [[nodiscard]] QWidget* viewWithFrames();
  void look(const std::optional<FanOutline>& outline);
  void turn();  ///< as the fields say
  void showTurned(const Orientation& turned);
  void take(const std::shared_ptr<FilmReader>& opened);
  void showProgress();
  void setBusy(bool busy);
  void follow();  ///< what the edit has become
  void showNotes(const Result<ScreenGeometry>& geometry);
  void wantFrame(int frame);
  void fetch();
  void takeFrame(const FilmFrame& shown);
  void setPlaying(bool playing);
  void step(int frames);
  void advance();
  [[nodiscard]] measurement::CaliperDrawing& drawing();
  void measureAll();
  [[nodiscard]] bool mayLeaveWriting();
  bool import();  ///< @return whether it began; when not, the dialog says why
  void endImport(const QString& target, const Result<void>& outcome, const std::vector<Message>& removed);

  QString file_;
  Jobs& jobs_;
  MessageBar& messages_;
  std::shared_ptr<FilmReader> opened_;
  std::optional<ScreenEdit> edit_;
  Orientation turned_;                       ///< of what is or will be looked at
  bool tookBack_ = false;                    ///< corrections, because the images were turned
  int job_ = 0;                              ///< that reads and finds, or writes; 0: none
  int frameJob_ = 0;                         ///< that reads the frame to show
  std::optional<ScreenCorrection> writing_;  ///< that the recording is being written with; empty: none is
  ScreenCorrection written_;                 ///< that the recording was written with last
  int wantedFrame_ = 0;
  int shownFrame_ = -1;
  int changes_ = 0;       ///< of what makes a cleaned frame
  int shownChanges_ = 0;  ///< of the frame that is shown
  double playTime_s_ = 0.0;
  QTimer progressTick_, playTick_;
  std::map<int, measurement::CaliperDrawing> drawings_;  ///< of each frame, in pixels of the recording
  ScreenView* view_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton* play_ = nullptr;
  QSlider* frames_ = nullptr;
  FigureLabel* time_ = nullptr;
  QComboBox* turn_ = nullptr;
  QCheckBox* mirror_ = nullptr;
  QComboBox* shape_ = nullptr;
  QDoubleSpinBox* depth_ = nullptr;
  QDoubleSpinBox* tick_ = nullptr;
  QLabel* scale_ = nullptr;
  QCheckBox* cleaned_ = nullptr;
  QPushButton* measure_ = nullptr;
  QLabel* distances_ = nullptr;
  QPushButton* again_ = nullptr;
  QPushButton* back_ = nullptr;
  QLabel* text_ = nullptr;
  QLabel* notes_ = nullptr;
  QPushButton* import_ = nullptr;
  QPushButton* close_ = nullptr;
};

}  // namespace ew::ui
