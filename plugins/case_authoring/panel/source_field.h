#pragma once

#include <QString>
#include <QTimer>
#include <QWidget>
#include <array>
#include <atomic>
#include <functional>
#include <memory>

#include "ew/library/new_case.h"
#include "ew/sdk/host.h"

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace ew {
class NumberField;
}

namespace ew::case_authoring {

/// What a volume is made from: what is on screen, a file of one of three kinds, or nothing yet. A chosen file says by itself what it is,
/// and what it does not say is asked for here: each question has a field, which is there when it is asked.
class SourceField final : public QWidget {
  Q_OBJECT

 public:
  enum class Kind { volume, sweep, stitched, nothing, shown };
  /// What is on screen is offered when that is no case's. A job of the host looks at what was chosen.
  /// @param offersNothing whether "nothing yet" can be chosen
  SourceField(sdk::Host& host, bool offersNothing, QWidget* parent = nullptr);
  ~SourceField() override;

  [[nodiscard]] Kind kind() const;
  [[nodiscard]] QString file() const;  ///< as it is written in the field; empty for nothing
  /// What was chosen. @error notFound, as sourceOf; badUsage: no file is chosen yet
  [[nodiscard]] Result<CaseSource> source() const;
  /// What still has to be done or waited for before the source can be used, a sentence; empty: nothing.
  [[nodiscard]] QString openQuestion() const;

 Q_SIGNALS:
  void changed();

 private:
  void addFile();
  void addSweep();
  void addAsked();
  /// Looks at the source once what is typed has come to rest.
  void lookSoon();
  void lookInside();
  /// What was looked at is not what is chosen any more: its job ends, and what it still says is not taken.
  void giveUpLook();
  /// Reveals the field for what a look at the source asked (askedFor); what has none is said beside the file.
  void ask(const Error& question);
  /// Asks from which side the volume was scanned, and shows its middle as it would be seen.
  void askForSide(const NewCasePlan& found);
  void showSide();
  void forget();
  [[nodiscard]] std::optional<VolumeSide> side() const;
  void addKind(Kind kind, const char* name, const QString& title, const QString& text);
  void chooseFile();
  void look();

  sdk::Host& host_;
  QTimer soon_;
  int look_ = 0;                                ///< number of the latest look, which no other ever has
  bool isLooking_ = false;                      ///< its answer is waited for
  std::shared_ptr<std::atomic<bool>> looking_;  ///< true: its job is to stop; null: none runs
  bool isRefused_ = false;                      ///< what the look said stands beside the file
  QButtonGroup* kinds_ = nullptr;
  QWidget* fileRow_ = nullptr;
  QLineEdit* file_ = nullptr;
  QPushButton* choose_ = nullptr;
  QWidget* sweepRow_ = nullptr;
  NumberField* spacing_ = nullptr;
  QCheckBox* fan_ = nullptr;
  QCheckBox* images_ = nullptr;
  QLineEdit* calibration_ = nullptr;
  QLabel* remark_ = nullptr;
  std::optional<sdk::DisplayVolume> shown_;
  QFormLayout* asked_ = nullptr;
  QWidget* askedRows_ = nullptr;
  QSpinBox* timeStep_ = nullptr;
  QCheckBox* acceptsSmall_ = nullptr;
  std::array<NumberField*, 3> voxel_{};
  QWidget* voxelRow_ = nullptr;
  QComboBox* side_ = nullptr;
  QLabel* sideImage_ = nullptr;
  QLabel* sideText_ = nullptr;
  Volume seen_;
  bool asksStep_ = false;
  bool asksSmall_ = false;
  bool asksSpacing_ = false;
  bool asksSide_ = false;
};

}  // namespace ew::case_authoring
