#pragma once

#include <QWidget>
#include <memory>

#include "ew/widgets/paragraph.h"
#include "panel/pair_graph.h"
#include "panel/volume_list.h"

class QAction;
class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace ew::stitching {

class Mosaic;
class ProjectDocument;
class ProjectInputs;
class StitchLook;
class StitchResults;
class StitchRuns;
class StitchSession;

/// The column beside the stage: subvolumes, graph of pairs, and the steps from them to one volume. Files are added with the button or
/// dropped; a stitch project (.json) opens.
class StitchPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit StitchPanel(StitchSession& session, QWidget* parent = nullptr);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QWidget* makeOffer();
  QWidget* makeWorkPage(StitchSession& session);
  QWidget* makeLegend();
  QWidget* makeSteps();
  QWidget* makeResultBox();
  QWidget* makeOptions();
  void refresh();
  void showForecast();
  void showProblem(const QString& sentence);
  void askForFiles();
  void askForProject();
  bool mayLeaveProject();  ///< asks where something would be lost

  ProjectDocument& document_;
  ProjectInputs& inputs_;
  const StitchResults& results_;
  Mosaic& mosaic_;
  const StitchLook& look_;
  StitchRuns& runs_;
  QWidget* offer_ = nullptr;
  QLabel* offerWord_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  QPushButton* addFirst_ = nullptr;
  VolumeList* list_ = nullptr;
  PairGraph* graph_ = nullptr;
  QWidget* pairsBox_ = nullptr;
  QLabel* pairWord_ = nullptr;
  QPushButton* match_ = nullptr;
  QPushButton* refine_ = nullptr;
  QPushButton* elastic_ = nullptr;
  QPushButton* seams_ = nullptr;
  QPushButton* handOver_ = nullptr;
  QPushButton* saveVolume_ = nullptr;
  std::shared_ptr<void> caseTicket_;
  QPushButton* waiting_ = nullptr;  ///< had the focus when a run began
  QAction* saveProject_ = nullptr;
  QWidget* resultBox_ = nullptr;
  QWidget* moreRow_ = nullptr;
  QWidget* options_ = nullptr;
  NumberField* spacing_ = nullptr;
  NumberField* fallOff_ = nullptr;
  QComboBox* seamMethod_ = nullptr;
  QComboBox* axes_ = nullptr;
  Paragraph* forecast_ = nullptr;
  Paragraph* outcome_ = nullptr;
  Paragraph* old_ = nullptr;  ///< the result no longer is what the project asks for
  QLabel* problem_ = nullptr;
  bool showing_ = false;
};

}  // namespace ew::stitching
