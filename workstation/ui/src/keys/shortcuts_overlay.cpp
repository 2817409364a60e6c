#include "keys/shortcuts_overlay.h"

#include <QApplication>
#include <QCloseEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ew/widgets/icons.h"
#include "ew/widgets/look.h"

namespace ew::ui {
namespace {

constexpr int kAround_px = 16;  // between the page and the window's border
constexpr int kMostColumns = 3;

QGridLayout* linesOf(const ShortcutsOverlay::Group& group) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(2);
  for (int row = 0; row < static_cast<int>(group.lines.size()); ++row) {
    const ShortcutsOverlay::Line& line = group.lines[static_cast<std::size_t>(row)];
    auto* keys = new QLabel(line.keys);
    keys->setObjectName(QStringLiteral("keyCap"));
    setLook(keys, Look::small);
    grid->addWidget(keys, row, 0, Qt::AlignLeft | Qt::AlignVCenter);
    auto* what = new QLabel(line.what);
    setLook(what, Look::quiet);
    grid->addWidget(what, row, 1);
    if (line.motion != ProbeMotion::none) grid->addWidget(new ProbeMotionDrawing(line.motion), row, 2, Qt::AlignRight);
  }
  grid->setColumnStretch(1, 1);
  return grid;
}

/// The groups in so many columns of about the same length.
QWidget* bodyOf(const std::vector<ShortcutsOverlay::Group>& groups, int count) {
  auto* body = new QWidget;
  body->setObjectName(QStringLiteral("overlayBody"));
  auto* columns = new QHBoxLayout(body);
  columns->setContentsMargins(24, 0, 24, 16);
  columns->setSpacing(24);
  std::size_t all = 0;
  for (const auto& group : groups) all += group.lines.size() + 2;
  QVBoxLayout* column = nullptr;
  std::size_t filled = 0;
  for (const auto& group : groups) {
    const bool isFull =
        filled + group.lines.size() / 2 >= all * static_cast<std::size_t>(columns->count()) / static_cast<std::size_t>(count);
    if (column == nullptr || (isFull && columns->count() < count)) {
      if (column != nullptr) column->addStretch(1);
      column = new QVBoxLayout;
      column->setSpacing(6);
      columns->addLayout(column);
    }
    auto* title = new QLabel(group.title);
    setLook(title, Look::heading);
    column->addWidget(title);
    column->addLayout(linesOf(group));
    column->addSpacing(8);
    filled += group.lines.size() + 2;
  }
  if (column != nullptr) column->addStretch(1);
  return body;
}

}  // namespace

ShortcutsOverlay::ShortcutsOverlay(const std::vector<Group>& groups, QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("overlay"));
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_DeleteOnClose);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  auto* head = new QHBoxLayout;
  head->setContentsMargins(24, 12, 12, 8);
  auto* title = new QLabel(tr("Keys and mouse"));
  setLook(title, Look::heading);
  head->addWidget(title);
  head->addStretch(1);
  auto* closeButton = new QPushButton(icon(QStringLiteral("close")), QString());
  closeButton->setObjectName(QStringLiteral("closeKeys"));
  setLook(closeButton, Look::flat);
  closeButton->setFocusPolicy(Qt::NoFocus);  // the page keeps the keys
  closeButton->setToolTip(tr("Close this page (Escape)"));
  closeButton->setAccessibleName(closeButton->toolTip());
  connect(closeButton, &QPushButton::clicked, this, &QWidget::close);
  head->addWidget(closeButton);
  rows->addLayout(head);
  scroll_ = new QScrollArea;
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->setWidgetResizable(true);
  rows->addWidget(scroll_, 1);

  const QSize most = parent->size() - QSize(2 * kAround_px, 2 * kAround_px);
  constexpr int kEdges_px = 4;  // of the page and of what scrolls in it
  const int bar_px = scroll_->verticalScrollBar()->sizeHint().width() + kEdges_px;
  QWidget* body = nullptr;
  // As many columns as the window is wide enough for; one may be wider than the window, and then scrolls to the side as well.
  for (int count = kMostColumns; count >= 1; --count) {
    delete body;
    body = bodyOf(groups, count);
    body->setParent(this);  // so that it has the fonts of the window's style sheet
    body->ensurePolished();
    for (QWidget* each : body->findChildren<QWidget*>()) each->ensurePolished();
    if (body->sizeHint().width() + bar_px <= most.width()) break;
  }
  const QSize wanted = body->sizeHint() + QSize(bar_px, head->sizeHint().height() + 2);
  scroll_->setWidget(body);
  resize(wanted.boundedTo(most));
  move((parent->width() - width()) / 2, std::max(0, (parent->height() - height()) / 2));
  show();
  raise();
  before_ = QApplication::focusWidget();
  setFocus();
}

bool ShortcutsOverlay::event(QEvent* event) {
  // As long as the page is read its keys are its own: Page Down scrolls and does not make the image deeper.
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();
    return true;
  }
  return QFrame::event(event);
}

void ShortcutsOverlay::keyPressEvent(QKeyEvent* event) {
  QScrollBar* bar = scroll_->verticalScrollBar();
  switch (event->key()) {
    case Qt::Key_Down:
      return bar->triggerAction(QAbstractSlider::SliderSingleStepAdd);
    case Qt::Key_Up:
      return bar->triggerAction(QAbstractSlider::SliderSingleStepSub);
    case Qt::Key_PageDown:
      return bar->triggerAction(QAbstractSlider::SliderPageStepAdd);
    case Qt::Key_PageUp:
      return bar->triggerAction(QAbstractSlider::SliderPageStepSub);
    case Qt::Key_Home:
      return bar->triggerAction(QAbstractSlider::SliderToMinimum);
    case Qt::Key_End:
      return bar->triggerAction(QAbstractSlider::SliderToMaximum);
    default:
      close();
  }
}

void ShortcutsOverlay::focusOutEvent(QFocusEvent*) { close(); }

void ShortcutsOverlay::closeEvent(QCloseEvent* event) {
  // Left alone, Qt would give the focus to the next button, and the arrows would no longer move the probe.
  QWidget* before = before_.data();
  if (before != nullptr && hasFocus() && before->isVisible()) before->setFocus(Qt::OtherFocusReason);
  QFrame::closeEvent(event);
}

}  // namespace ew::ui
