#pragma once

#include <QKeyEvent>
#include <QTimer>
#include <QWidget>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "panel/pair_inspector.h"
#include "panel/placement_view.h"
#include "panel/slice_view.h"

class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace ew::stitching {

class AlignmentEdits;
class ProjectDocument;
class ProjectInputs;
class StitchLook;
class StitchSession;

/// Two by two views of the pair that is looked at, and its inspector at the right.
class StitchStage final : public QWidget {
  Q_OBJECT

 public:
  explicit StitchStage(StitchSession& session, QWidget* parent = nullptr);

  /// What the keys do, for the window's page of keys.
  [[nodiscard]] static std::vector<std::pair<std::string, std::string>> keyLines();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QWidget* makeFrame(QLabel*& title, QWidget* content, const std::vector<QWidget*>& controls);
  void makeViews(StitchSession& session);
  void makeCutControls();
  void makeOverlayControls();
  void makeFourthChoice();
  void makeBrush();
  QWidget* makeGrid();
  void connectSession(StitchSession& session);
  /// @param act false: only asked whether the key is one of the stage's. @return whether it is
  [[nodiscard]] bool handleKey(const QKeyEvent& event, bool act);
  [[nodiscard]] bool nudgeByKey(const QKeyEvent& event, bool act);
  [[nodiscard]] bool lookByKey(const QKeyEvent& event, bool act);
  [[nodiscard]] bool chooseViewByKey(const QKeyEvent& event, bool act);
  [[nodiscard]] bool useHandByKey(const QKeyEvent& event, bool act);
  [[nodiscard]] bool judgeByKey(const QKeyEvent& event, bool act);  ///< the pair in front, or another one
  void showTitles();
  void setFourth(Tools::Fourth fourth);
  void setHand(Tools::Hand hand);
  void setOverlay(Overlay overlay);
  void toolsChanged();

  const ProjectDocument& document_;
  ProjectInputs& inputs_;
  StitchLook& look_;
  AlignmentEdits& edits_;
  Tools tools_;
  QTimer flicker_;
  std::array<QLabel*, 4> titles_{};
  SliceView* fixed_ = nullptr;
  SliceView* moving_ = nullptr;
  SliceView* overlap_ = nullptr;
  SliceView* fourth_ = nullptr;
  PlacementView* placement_ = nullptr;
  QStackedWidget* fourthPages_ = nullptr;
  QComboBox* cut_ = nullptr;
  QPushButton* linked_ = nullptr;
  QComboBox* overlay_ = nullptr;
  QComboBox* stageChoice_ = nullptr;
  QPushButton* halves_ = nullptr;
  QComboBox* fourthChoice_ = nullptr;
  QWidget* brushRow_ = nullptr;
  QPushButton* paint_ = nullptr;
  QComboBox* brushView_ = nullptr;
  NumberField* brush_ = nullptr;
  PairInspector* inspector_ = nullptr;
  bool showing_ = false;
};

}  // namespace ew::stitching
