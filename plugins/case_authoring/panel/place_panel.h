#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "ew/sdk/case_parts.h"
#include "ew/sdk/host.h"
#include "ew/sdk/overlays.h"
#include "ew/sdk/placement_fields.h"
#include "ew/sdk/scan.h"
#include "logic/landmark_pairs.h"
#include "logic/placing.h"
#include "panel/pair_list.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace ew::case_authoring {

/// Where the volume of the open case lies in the body: by handles in the 3D view, by numbers, on a place of the skin, by pairs of places;
/// and how it then lies against the skin. Each is an undoable step of the case.
class PlacePanel final : public QWidget {
  Q_OBJECT

 public:
  explicit PlacePanel(sdk::Host& host, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  /// The volume as it is scanned and placed now.
  struct Placed {
    FilePlace fileToWorld;
    Grid own;  ///< in the volume's file
    SweepAxes axes;
    bool isFaceSaid = false;  ///< by the case; else it is guessed
    std::shared_ptr<const Skin> skin;
    std::shared_ptr<const Volume> voxels;  ///< may be null
  };
  [[nodiscard]] std::optional<Placed> placed() const;
  [[nodiscard]] const PlacingShape& shapeNow(const Placed& now);

  QWidget* makeForm();
  QWidget* makeContact();
  QWidget* makeButtons();
  QWidget* makePairs();
  QPushButton* addButton(QWidget* row, const char* name, const QString& text, const QString& tip, std::function<void()> run);

  void showCase();
  void showFace(const std::optional<Placed>& now);
  void showContact();
  void showContactSoon();
  void drawFace(const Placed& now, const PlacingShape& shape);
  void showHandles();
  void showPairs();

  void place(const FilePlace& fileToWorld, const QString& what, const std::string& mergeKey);
  void chooseFace(int index);
  void dragged(const HandlesPose& now, bool isOver);
  void turn(double angle_rad, const QString& what);
  void askForSkin();
  void putAtUsualPlace();
  void editPairs(std::vector<DraftPair> pairs, const QString& what, const std::string& mergeKey = {});
  void pointInImage(std::size_t pair, bool asks);
  void pointOnBody(std::size_t pair);
  void takeImagePoint(std::size_t pair, const Point<frame::Probe>& at);
  void stopAsking();
  void say(const Error& problem);

  sdk::Host& host_;
  QStackedWidget* pages_ = nullptr;
  QLabel* remark_ = nullptr;  ///< why there is no contact to show
  QWidget* contact_ = nullptr;
  QLabel* verdict_ = nullptr;
  QProgressBar* share_ = nullptr;
  QLabel* figures_ = nullptr;
  QComboBox* face_ = nullptr;
  QPushButton* handles_ = nullptr;
  QPushButton* onSkin_ = nullptr;
  std::vector<QPushButton*> needVolume_;
  sdk::PlacementFields<frame::World, frame::File>* numbers_ = nullptr;
  PairList* pairs_ = nullptr;
  QPushButton* fit_ = nullptr;
  QLabel* fitWords_ = nullptr;
  QLabel* problem_ = nullptr;

  struct Shaped {
    std::shared_ptr<const Volume> voxels;
    Grid own;
    PlacingShape shape;
  };
  std::optional<Shaped> shaped_;
  std::shared_ptr<const Skin> skinSeen_;  ///< that what is shown was found with
  QTimer contactSoon_;
  double contactCost_ms_ = 0.0;

  std::shared_ptr<sdk::HandlesOverlay> handlesShown_;
  std::shared_ptr<sdk::BodyOverlay> over_;
  sdk::Ticket aids_;
  struct Drag {
    FilePlace fileToWorld;
    HandlesPose handles;
  };
  std::optional<Drag> drag_;
  int drags_ = 0;  ///< so far: each is a step of its own

  std::string landmarksOf_;  ///< mannequin whose landmarks are offered
  bool hasLandmarks_ = false;
  std::vector<PlacingSite> sites_;
  std::optional<PairList::Asked> asked_;
  sdk::Ticket asking_;
  sdk::Ticket changed_, seen_;
};

}  // namespace ew::case_authoring
