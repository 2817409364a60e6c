#include "window/frame/top_bar.h"

#include <QAction>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenuBar>
#include <QPushButton>
#include <QStyle>
#include <QStyleOption>
#include <QVariant>
#include <algorithm>

#include "ew/widgets/icons.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "keys/key_tips.h"
#include "window/layout/window_layout.h"

namespace ew::ui {

namespace {

/// Asked for its size in a window read from the right, Qt's own puts its entries where the window ends and not where the bar does.
class MenuBar final : public QMenuBar {
 public:
  [[nodiscard]] QSize sizeHint() const override { return isRightToLeft() ? sizeOf(true) : QMenuBar::sizeHint(); }
  [[nodiscard]] QSize minimumSizeHint() const override { return isRightToLeft() ? sizeOf(false) : QMenuBar::minimumSizeHint(); }

 private:
  [[nodiscard]] QSize sizeOf(bool all) const {
    const QStyle& by = *style();
    const int spacing_px = by.pixelMetric(QStyle::PM_MenuBarItemSpacing, nullptr, this);
    QSize size(0, 0);
    for (QAction* entry : actions()) {
      if (!entry->isVisible()) continue;
      QStyleOptionMenuItem option;
      initStyleOption(&option, entry);
      const QSize words = fontMetrics().size(Qt::TextShowMnemonic, entry->text());
      const QSize its = by.sizeFromContents(QStyle::CT_MenuBarItem, &option, words, this);
      size = {size.width() + its.width() + spacing_px, std::max(size.height(), its.height())};
      if (!all) break;
    }
    const int across_px =
        by.pixelMetric(QStyle::PM_MenuBarHMargin, nullptr, this) + by.pixelMetric(QStyle::PM_MenuBarPanelWidth, nullptr, this);
    const int down_px =
        by.pixelMetric(QStyle::PM_MenuBarVMargin, nullptr, this) + by.pixelMetric(QStyle::PM_MenuBarPanelWidth, nullptr, this);
    return size + QSize(2 * across_px + (all ? 0 : 2 * kGrid_px), 2 * down_px);
  }
};

}  // namespace

TopBar::TopBar(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("topBar"));
  setAttribute(Qt::WA_StyledBackground);
  holdFixedHeight(*this, 44);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 0, 16, 0);
  row->setSpacing(0);
  brand_ = new QLabel(QStringLiteral("EchoWeave"));
  brand_->setObjectName(QStringLiteral("brand"));
  menus_ = new MenuBar;
  menus_->setNativeMenuBar(false);
  menus_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  group_ = new QButtonGroup(this);
  switch_ = new QHBoxLayout;
  switch_->setSpacing(8);
  row->addWidget(brand_);
  row->addSpacing(16);
  row->addLayout(switch_);
  row->addSpacing(16);
  row->addWidget(menus_);
  row->addStretch(1);
  addWorkspace(QStringLiteral("explore"), tr("Explore"), tipWithKeys(tr("Scan the open case (%1)"), "workspace.explore"), {});
  addWorkspace(QStringLiteral("author"), tr("Author"), tipWithKeys(tr("Edit the case and build volumes (%1)"), "workspace.author"), {});
  disclaimer_ = new QLabel(tr("simulation, not for diagnosis"));
  setLook(disclaimer_, Look::quiet);
  row->addWidget(disclaimer_);
  setWorkspace(QStringLiteral("explore"));
  // The title stands in the middle of the window, whatever stands beside it; a layout would put it into the middle of what is left.
  title_ = new QLabel(this);
  title_->setObjectName(QStringLiteral("title"));
  title_->setTextFormat(Qt::PlainText);
  remark_ = new QLabel(this);
  remark_->setObjectName(QStringLiteral("titleRemark"));
  setLook(remark_, Look::quiet);
}

void TopBar::addWorkspace(const QString& id, const QString& title, const QString& tip, const QByteArray& icon) {
  auto* button = new QPushButton(title);
  button->setObjectName(QStringLiteral("workspace") + id.left(1).toUpper() + id.mid(1));
  button->setToolTip(tip);
  setLook(button, Look::workspace);
  button->setCheckable(true);
  button->setFocusPolicy(Qt::TabFocus);  // a click must not take the arrow keys away from the probe
  group_->addButton(button);
  switch_->addWidget(button);
  connect(button, &QPushButton::clicked, this, [this, id] { Q_EMIT workspaceChosen(id); });
  workspaces_.push_back({id, button, icon});
  refreshIcons();
  if (title_ != nullptr) placeTitle();
}

void TopBar::setWorkspace(const QString& id) {
  for (const Button& each : workspaces_)
    if (each.id == id) each.button->setChecked(true);
}

void TopBar::setShown(const QString& id, bool shown) {
  for (const Button& each : workspaces_)
    if (each.id == id) each.button->setVisible(shown);
  placeTitle();
}

void TopBar::refreshIcons() {
  for (const Button& each : workspaces_)
    if (!each.icon.isEmpty()) each.button->setIcon(iconOf(each.icon, currentTheme().text));
}

void TopBar::setTitle(const QString& title, const QString& remark) {
  fullTitle_ = title;
  title_->setToolTip(title);
  remark_->setText(remark);
  placeTitle();
}

void TopBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeTitle();
}

void TopBar::placeTitle() {
  int needed_px = layout()->contentsMargins().left() + layout()->contentsMargins().right() + menus_->sizeHint().width();
  for (const Button& each : workspaces_)
    if (!each.button->isHidden()) needed_px += each.button->sizeHint().width() + kGrid_px;
  needed_px += 4 * kGrid_px;
  const TopBarLayout shown =
      topBarOf({width(), needed_px, disclaimer_->sizeHint().width(), brand_->sizeHint().width(), scaled(1000.0) / 1000.0});
  disclaimer_->setVisible(shown.showsDisclaimer);
  brand_->setVisible(shown.showsBrand);
  layout()->activate();
  constexpr int kGap_px = kTitleGap_px;
  const auto placed = [this](const QRect& rect) { return QStyle::visualRect(layoutDirection(), this->rect(), rect); };
  const int left = placed(menus_->geometry()).right() + kGap_px;
  const int right = disclaimer_->isHidden() ? width() - kGrid_px : placed(disclaimer_->geometry()).left() - kGap_px;
  const int room = std::max(0, right - left);
  const int wanted = remark_->text().isEmpty() ? 0 : remark_->sizeHint().width() + kGap_px;
  const QFontMetrics metrics = title_->fontMetrics();
  // What is open is named before what is remarked about it.
  const int remarkWidth = wanted + std::min(metrics.horizontalAdvance(fullTitle_) + 4, scaled(kReadableTitle_px)) <= room ? wanted : 0;
  const int titleWidth = std::min(metrics.horizontalAdvance(fullTitle_) + 4, std::max(0, room - remarkWidth));
  title_->setText(metrics.elidedText(fullTitle_, Qt::ElideRight, titleWidth));
  const int all = titleWidth + remarkWidth;
  const int x = std::clamp((width() - all) / 2, left, std::max(left, right - all));
  title_->setGeometry(placed(QRect(x, 0, titleWidth, height() - 1)));
  remark_->setGeometry(placed(QRect(x + titleWidth + kGap_px, 0, std::max(0, remarkWidth - kGap_px), height() - 1)));
  remark_->setVisible(remarkWidth > 0);
}

}  // namespace ew::ui
