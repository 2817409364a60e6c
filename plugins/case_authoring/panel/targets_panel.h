#pragma once

#include <QWidget>

#include "ew/sdk/case_parts.h"
#include "ew/sdk/host.h"
#include "panel/target_drawer.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QStackedWidget;

namespace ew::case_authoring {

class PaintWork;
class PlanePage;
class PointPage;
class StructurePage;

/// The targets of the open case: what a trainee is to find. A list, and what belongs to the chosen one; scan and body show them while the
/// panel is seen.
class TargetsPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit TargetsPanel(sdk::Host& host, QWidget* parent = nullptr);
  ~TargetsPanel() override;

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  /// While strokes can be taken back, Ctrl+Z takes them back before it takes back steps of the case.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* makeList();
  QWidget* makeEditor();
  QWidget* makeLeft();
  QWidget* makeUnkept();
  void addPoint();
  void addPlane();
  void addStructure();
  void add(const QString& what, const CaseTarget& target);
  void remove();
  void move(int by);
  void rename(const QString& name);
  void choose(std::size_t number);
  void change(const QString& what, const std::string& part, const std::function<Case(Case edited, std::size_t number)>& edit);
  void showCase();
  void showChosen();
  void followWork();
  void say(const QString& sentence);
  [[nodiscard]] QString lineOf(const CaseTarget& target) const;

  sdk::Host& host_;
  Case case_;  ///< that is shown; without one it is empty
  std::size_t chosen_ = 0;
  PaintWork* work_ = nullptr;
  TargetDrawer drawer_;
  QStackedWidget* pages_ = nullptr;
  QListWidget* list_ = nullptr;
  QPushButton *up_ = nullptr, *down_ = nullptr, *remove_ = nullptr;
  QWidget *editor_ = nullptr, *left_ = nullptr, *unkept_ = nullptr;
  QLineEdit* name_ = nullptr;
  QCheckBox* reveals_ = nullptr;
  QLabel *lessons_ = nullptr, *problem_ = nullptr, *empty_ = nullptr, *unkeptText_ = nullptr;
  PointPage* point_ = nullptr;
  PlanePage* plane_ = nullptr;
  StructurePage* structure_ = nullptr;
  sdk::Ticket changed_, opened_, images_;
};

}  // namespace ew::case_authoring
