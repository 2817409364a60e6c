#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <optional>

#include "ew/sdk/host.h"
#include "logic/painting.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace ew::case_authoring {

class PaintWork;

/// Asks for an edit of the case and the chosen target's number in it, as one step named `what`; those of one part in a row are one
/// step.
using TargetChange =
    std::function<void(const QString& what, const std::string& part, const std::function<Case(Case edited, std::size_t number)>& edit)>;

/// What a structure among the targets consists of: an organ of the virtual patient, or a label that is painted, traced and grown in the
/// scan, with the tissue that decides about its shadow.
class StructurePage final : public QWidget {
  Q_OBJECT

 public:
  StructurePage(sdk::Host& host, PaintWork& work, QWidget* parent = nullptr);

  /// The structure that is edited.
  void setTarget(const Case& shown, const CaseTarget& target);
  /// What is painted, the tool, or whether it is busy has changed.
  void followWork();

  TargetChange change;

 private:
  QWidget* makeTools();
  QWidget* makeSettings();
  QWidget* makeShaping();
  QWidget* makeKeeping();
  QPushButton* addTool(PaintTool tool, const QString& text, const QString& tip, const char* name);
  QWidget* addSetting(QFormLayout* form, const QString& text, QWidget* field, const char* name);
  void takeTool(PaintTool tool, bool on);
  void showOrgans();
  void showTissue();
  void showSettings();
  [[nodiscard]] PaintSettings settings() const;

  sdk::Host& host_;
  PaintWork& work_;
  Case case_;
  CaseTarget target_;
  PaintTool shownTool_ = PaintTool::paint;
  QWidget *organPart_ = nullptr, *labelPart_ = nullptr;
  QComboBox *organ_ = nullptr, *tissue_ = nullptr, *shape_ = nullptr;
  QLabel *label_ = nullptr, *state_ = nullptr;
  std::array<QPushButton*, 4> tools_{};
  QDoubleSpinBox *radius_ = nullptr, *thickness_ = nullptr, *reach_ = nullptr, *largest_ = nullptr;
  QCheckBox* onlyUnlabelled_ = nullptr;
  QFormLayout* settingRows_ = nullptr;
  QPushButton *between_ = nullptr, *largestPiece_ = nullptr, *smooth_ = nullptr;
  QPushButton *undo_ = nullptr, *redo_ = nullptr, *keep_ = nullptr, *discard_ = nullptr, *cancel_ = nullptr;
};

}  // namespace ew::case_authoring
