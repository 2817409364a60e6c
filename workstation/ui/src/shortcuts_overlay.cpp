#include "shortcuts_overlay.h"

#include <QApplication>
#include <QCloseEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QVBoxLayout>
#include <QVariant>

namespace ew::ui {

ShortcutsOverlay::ShortcutsOverlay(const std::vector<Group>& groups, QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("overlay"));
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_DeleteOnClose);
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(24, 16, 24, 16);
  columns->setSpacing(24);
  // Three columns of about the same length.
  std::size_t all = 0;
  for (const Group& group : groups) all += group.lines.size() + 2;
  QVBoxLayout* column = nullptr;
  std::size_t filled = 0;
  for (const Group& group : groups) {
    if (column == nullptr ||
        (filled + group.lines.size() / 2 >= all * static_cast<std::size_t>(columns->count()) / 3 && columns->count() < 3)) {
      if (column != nullptr) column->addStretch(1);
      column = new QVBoxLayout;
      column->setSpacing(6);
      columns->addLayout(column);
    }
    auto* title = new QLabel(group.title);
    title->setProperty("heading", true);
    column->addWidget(title);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(12);
    grid->setVerticalSpacing(2);
    for (int row = 0; row < static_cast<int>(group.lines.size()); ++row) {
      const Line& line = group.lines[static_cast<std::size_t>(row)];
      auto* keys = new QLabel(line.keys);
      keys->setObjectName(QStringLiteral("keyCap"));
      keys->setProperty("small", true);
      grid->addWidget(keys, row, 0, Qt::AlignLeft);
      auto* what = new QLabel(line.what);
      what->setProperty("quiet", true);
      grid->addWidget(what, row, 1);
    }
    grid->setColumnStretch(1, 1);
    column->addLayout(grid);
    column->addSpacing(8);
    filled += group.lines.size() + 2;
  }
  if (column != nullptr) column->addStretch(1);
  adjustSize();
  move((parent->width() - width()) / 2, std::max(0, (parent->height() - height()) / 2));
  show();
  raise();
  before_ = QApplication::focusWidget();
  setFocus();
}

void ShortcutsOverlay::keyPressEvent(QKeyEvent*) { close(); }
void ShortcutsOverlay::mousePressEvent(QMouseEvent*) { close(); }
void ShortcutsOverlay::focusOutEvent(QFocusEvent*) { close(); }

void ShortcutsOverlay::closeEvent(QCloseEvent* event) {
  // Left alone, Qt would give the focus to the next button, and the arrows would no longer move the probe.
  QWidget* before = before_.data();
  if (before != nullptr && hasFocus() && before->isVisible()) before->setFocus(Qt::OtherFocusReason);
  QFrame::closeEvent(event);
}

}  // namespace ew::ui
