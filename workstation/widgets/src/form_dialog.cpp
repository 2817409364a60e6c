#include "ew/widgets/form_dialog.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <utility>

#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"

namespace ew {
namespace {

constexpr int kLeastRows_px = 160;
constexpr int kAroundDialog_px = 32;  ///< of the screen, for a window's frame

}  // namespace

/// Asks for the height its rows have at its width, where a plain scroll area asks for a constant.
class FormDialog::RowsArea final : public QScrollArea {
 public:
  explicit RowsArea(QWidget* body) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWidget(body);
    viewport()->setAutoFillBackground(false);
    body->setAutoFillBackground(false);
  }
  [[nodiscard]] QSize minimumSizeHint() const override { return {leastWidth(), std::min(kLeastRows_px, sizeHint().height())}; }
  [[nodiscard]] QSize sizeHint() const override {
    QLayout& layout = *widget()->layout();
    layout.activate();
    const int width_px = std::max(leastWidth(), width());
    const int inside_px = width_px - verticalScrollBar()->sizeHint().width();
    return {leastWidth(), layout.hasHeightForWidth() ? layout.totalHeightForWidth(inside_px) : layout.totalSizeHint().height()};
  }

 private:
  [[nodiscard]] int leastWidth() const { return widget()->layout()->totalMinimumSize().width() + verticalScrollBar()->sizeHint().width(); }
};

FormDialog::FormDialog(const QString& heading, const QString& tip, QWidget* parent) : QDialog(parent) {
  setAttribute(Qt::WA_DeleteOnClose);
  outer_ = new QVBoxLayout(this);
  outer_->setContentsMargins(24, 24, 24, 24);
  outer_->setSpacing(16);
  auto* title = new QLabel(heading);
  setLook(title, Look::heading);
  title->setToolTip(tip);
  outer_->addWidget(title);
  sentence_ = new QLabel;
  sentence_->setWordWrap(true);
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  sentence_->hide();
  outer_->addWidget(sentence_);
  auto* body = new QWidget;
  rows_ = new QVBoxLayout(body);
  rows_->setContentsMargins(0, 0, 8, 0);
  rows_->setSpacing(16);
  area_ = new RowsArea(body);
  middle_ = new QHBoxLayout;
  middle_->setSpacing(24);
  middle_->addWidget(area_, 1);
  outer_->addLayout(middle_, 1);
  buttons_ = new QHBoxLayout;
  buttons_->setSpacing(8);
  buttons_->addStretch(1);
  outer_->addLayout(buttons_);
}

void FormDialog::say(const QString& sentence, bool isProblem) {
  sentence_->setStyleSheet(isProblem ? QStringLiteral("color: %1;").arg(currentTheme().danger.name()) : QString());
  sentence_->setText(sentence);
  sentence_->setVisible(!sentence.isEmpty());
  if (isVisible()) grow();
}

void FormDialog::putBeside(QWidget* large, const QSize& wanted) {
  middle_->setStretch(0, 0);
  middle_->addWidget(large, 1);
  wanted_ = wanted;
}

void FormDialog::grow() {
  outer_->activate();
  const QSize room = screen()->availableSize() - QSize(kAroundDialog_px, 2 * kAroundDialog_px);
  const int width_px = std::min(std::max({width(), wanted_.width(), outer_->totalMinimumSize().width()}), room.width());
  // Rows get their width first: what they need in height follows from it.
  if (width() != width_px) {
    resize(width_px, height());
    outer_->activate();
  }
  area_->updateGeometry();
  const int needed_px = outer_->hasHeightForWidth() ? outer_->totalHeightForWidth(width_px) : outer_->totalSizeHint().height();
  resize(width_px, std::min(std::max({height(), wanted_.height(), needed_px}), room.height()));
}

void FormDialog::showEvent(QShowEvent* event) {
  // A dialog that is not shown yet has a height that nobody asked for.
  if (!std::exchange(wasShown_, true) && !testAttribute(Qt::WA_Resized)) resize(width(), minimumSizeHint().height());
  grow();
  QDialog::showEvent(event);
}

}  // namespace ew
