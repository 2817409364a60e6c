#pragma once

#include <QWidget>

#include "ew/sdk/placement_fields.h"
#include "ew/widgets/paragraph.h"
#include "panel/charts.h"
#include "panel/slice_view.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace ew::stitching {

class AlignmentEdits;
class ProjectDocument;
class ProjectInputs;
class StitchLook;
class StitchResults;
class StitchRuns;
class StitchSession;

/// Everything about the pair that is looked at: what was found and why, its pose, its landmarks, and what to do about it.
class PairInspector final : public QWidget {
  Q_OBJECT

 public:
  PairInspector(StitchSession& session, Tools& tools, QWidget* parent = nullptr);
  void refresh();

 Q_SIGNALS:
  void handChosen();

 private:
  QWidget* makeHead();
  QWidget* makeFigures();
  QWidget* makePose();
  QWidget* makeLandmarks();
  QWidget* makeRedo();
  QWidget* makeElastic();
  void showLandmarks();
  void showFigures();
  void showCost();
  void showSearchCost();

  const ProjectDocument& document_;
  const ProjectInputs& inputs_;
  const StitchResults& results_;
  StitchLook& look_;
  const StitchRuns& runs_;
  AlignmentEdits& edits_;
  Tools& tools_;
  QWidget* body_ = nullptr;
  QWidget* empty_ = nullptr;
  QLabel* title_ = nullptr;
  QWidget* mark_ = nullptr;
  QLabel* word_ = nullptr;
  Paragraph* reason_ = nullptr;
  QPushButton* accept_ = nullptr;
  QPushButton* reject_ = nullptr;
  QLabel* overlap_ = nullptr;
  QLabel* correlation_ = nullptr;
  QLabel* now_ = nullptr;
  QLabel* jacobian_ = nullptr;
  QLabel* halves_ = nullptr;
  QLabel* time_ = nullptr;
  LevelChart* chart_ = nullptr;
  sdk::PlacementFields<frame::Fixed, frame::Moving>* pose_ = nullptr;
  QTableWidget* table_ = nullptr;
  Paragraph* landmarkWord_ = nullptr;
  QPushButton* pick_ = nullptr;
  QPushButton* removeMark_ = nullptr;
  QPushButton* useMarks_ = nullptr;
  QComboBox* method_ = nullptr;
  QWidget* turnRow_ = nullptr;
  NumberField* turn_ = nullptr;
  QComboBox* effort_ = nullptr;
  QLabel* memory_ = nullptr;
  QLabel* searchCost_ = nullptr;
  QComboBox* pairEffort_ = nullptr;
  QLabel* expected_ = nullptr;
  QLabel* measured_ = nullptr;
  Paragraph* warpedReason_ = nullptr;
  Paragraph* costHead_ = nullptr;
  CostChart* cost_ = nullptr;
  QPushButton* warpAgain_ = nullptr;
  bool showing_ = false;
};

}  // namespace ew::stitching
