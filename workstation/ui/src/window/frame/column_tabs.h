#pragma once

#include <QTabBar>
#include <vector>

#include "window/layout/window_layout.h"

namespace ew::ui {

/// The handle of columns that take turns in one place: a tab for each. Every column carries one, and all of them show the same.
class ColumnTabs final : public QTabBar {
  Q_OBJECT

 public:
  struct Tab {
    Column column;
    QString title;
    QString tip;
    bool operator==(const Tab&) const = default;
  };
  explicit ColumnTabs(QWidget* parent = nullptr);
  /// @param tabs fewer than two: nothing takes turns, and the handle is not seen
  void showTabs(const std::vector<Tab>& tabs, Column front);

 Q_SIGNALS:
  void asked(Column column);

 private:
  std::vector<Tab> tabs_;
};

}  // namespace ew::ui
