#include "start/recent_strip.h"

#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <algorithm>

#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"

namespace ew::ui {
namespace {

/// Opens with Enter as well as with a click: on a page of things to open nobody expects only the space bar to do it.
class RecentButton final : public QPushButton {
 public:
  using QPushButton::QPushButton;

 protected:
  void keyPressEvent(QKeyEvent* event) override {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
      click();
    } else {
      QPushButton::keyPressEvent(event);
    }
  }
};

}  // namespace

RecentStrip::RecentStrip(QWidget* parent) : QWidget(parent) {
  title_ = new QLabel(tr("Recently opened"), this);
  setLook(title_, Look::heading);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  hide();
}

void RecentStrip::show(const std::vector<RecentFile>& files) {
  for (QPushButton* button : buttons_) delete button;
  buttons_.clear();
  for (const RecentFile& file : files) {
    auto* button = new RecentButton(file.name, this);
    button->setObjectName(QStringLiteral("recentFile"));
    setLook(button, Look::flat);
    button->setToolTip(file.tip);
    connect(button, &QPushButton::clicked, this, [this, path = file.path] { Q_EMIT chosen(path); });
    buttons_.push_back(button);
  }
  setVisible(!files.empty());
  arrange();
}

QSize RecentStrip::sizeHint() const {
  int height_px = title_->sizeHint().height();
  for (const QPushButton* button : buttons_) height_px = std::max(height_px, button->sizeHint().height());
  return {title_->sizeHint().width(), height_px};
}

void RecentStrip::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

void RecentStrip::arrange() {
  const auto place = [this](QWidget& widget, int x, int width_px) {
    widget.setGeometry(QStyle::visualRect(layoutDirection(), rect(), QRect(x, 0, width_px, height())));
  };
  const int title_px = title_->sizeHint().width();
  place(*title_, 0, title_px);
  int x = title_px + kGrid_px;
  for (QPushButton* button : buttons_) {
    const int wanted_px = button->sizeHint().width();
    const bool isFirst = button == buttons_.front();  // at least one is there, cut where it has to be
    const bool fits = x + wanted_px <= width();
    button->setVisible(fits || isFirst);
    if (!fits && !isFirst) {
      x = width();
      continue;
    }
    place(*button, x, std::min(wanted_px, std::max(0, width() - x)));
    x += wanted_px + kGrid_px / 2;
  }
}

}  // namespace ew::ui
