#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "window/frame/feature.h"

class QAction;
class QMenu;
class QPushButton;

namespace ew::ui {

class ColumnTabs;
struct LayoutRequest;
struct WindowLayout;
enum class Column;

inline constexpr int kPanelWidth_px = 400;  ///< what panels want where something is made

/// Which columns have room beside the scan, and what leads to those that have none.
class Columns final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;

  /// What leads to columns that are not seen: tabs where they take turns, an edge to press where the scan is alone.
  void makeHandles();
  void addMenu(QMenu& view);
  void connectParts() override;

  void show();               ///< each where the window has room for it
  void show(Column column);  ///< in front of those it takes turns with
  void setScanOnly(bool scanOnly);
  [[nodiscard]] bool isScanOnly() const;
  /// A message lies over the scan's line of words, which is no image, or at the foot of what is shown in place of the scan.
  void placeMessages();

 private:
  void showNext();
  [[nodiscard]] LayoutRequest request() const;
  void showTabs(const WindowLayout& layout);

  std::vector<std::pair<Column, ColumnTabs*>> tabs_;  ///< one in each of panels, body and console
  QPushButton* comeBack_ = nullptr;                   ///< from the scan alone
  std::optional<Column> asked_;                       ///< of those that take turns, when somebody has chosen
  QAction* scanOnly_ = nullptr;
};

}  // namespace ew::ui
