#include "start_page.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ew/imaging/frame.h"
#include "ew/tracking/hand.h"
#include "icons.h"
#include "key_tips.h"
#include "theme.h"
#include "words.h"

namespace ew::ui {
namespace {

constexpr int kLeastCardWidth_px = 280;
constexpr int kMostCardWidth_px = 440;
constexpr int kGap_px = 16;
constexpr int kThumbHeight_px = 160;

/// A fan drawn in the accent's tone, for a case whose volume has not been prepared yet: shape, not data.
void paintFan(QPainter& painter, const QRect& box) {
  const Theme theme = scanTheme();
  QPainterPath fan;
  const QPointF apex(box.center().x(), box.top() - 24.0);
  const double inner = 48.0;
  const double outer = box.height() + 8.0;
  fan.arcMoveTo(QRectF(apex.x() - inner, apex.y() - inner, 2 * inner, 2 * inner), 240);
  fan.arcTo(QRectF(apex.x() - inner, apex.y() - inner, 2 * inner, 2 * inner), 240, 60);
  fan.arcTo(QRectF(apex.x() - outer, apex.y() - outer, 2 * outer, 2 * outer), 300, -60);
  fan.closeSubpath();
  QColor fill = theme.accent;
  fill.setAlphaF(0.16);
  painter.setPen(QPen(theme.accent, 1.25));
  painter.fillPath(fan, fill);
  painter.drawPath(fan);
}

class Thumbnail final : public QWidget {
 public:
  explicit Thumbnail(QWidget* parent) : QWidget(parent) { setFixedHeight(kThumbHeight_px); }
  void setPicture(const QImage& picture) {
    picture_ = picture;
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath rounded;
    rounded.addRoundedRect(QRectF(rect()), 4, 4);
    painter.setClipPath(rounded);
    painter.fillRect(rect(), Qt::black);
    if (picture_.isNull()) {
      paintFan(painter, rect());
      return;
    }
    const QSize fitted = picture_.size().scaled(size(), Qt::KeepAspectRatioByExpanding);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRect(QPoint((width() - fitted.width()) / 2, (height() - fitted.height()) / 2), fitted), picture_);
  }

 private:
  QImage picture_;
};

class CaseCard final : public QFrame {
 public:
  CaseCard(const Case& shown, bool forAuthors, std::function<void()> chosen)
      : id(shown.id), ownTitle_(words(shown.title)), traineesTitle_(words(titleForTrainees(shown))), chosen_(std::move(chosen)) {
    setObjectName(QStringLiteral("caseCard"));
    setMinimumWidth(kLeastCardWidth_px);
    setMaximumWidth(kMostCardWidth_px);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(12, 12, 12, 16);
    rows->setSpacing(4);
    thumbnail = new Thumbnail(this);
    rows->addWidget(thumbnail);
    rows->addSpacing(8);
    title_ = new QLabel;
    title_->setObjectName(QStringLiteral("caseCardTitle"));
    QLabel* title = title_;
    title->setProperty("heading", true);
    title->setWordWrap(true);
    rows->addWidget(title);
    const auto quiet = [rows](const QString& text) {
      if (text.isEmpty()) return;
      auto* label = new QLabel(text);
      label->setProperty("quiet", true);
      label->setProperty("small", true);
      label->setWordWrap(true);
      rows->addWidget(label);
    };
    quiet(words(shown.region));
    quiet(words(shown.indication));
    rows->addStretch(1);
    state = new QLabel;
    state->setObjectName(QStringLiteral("caseState"));
    state->setProperty("quiet", true);
    state->setProperty("small", true);
    state->setWordWrap(true);
    rows->addWidget(state);
    bar = new QProgressBar;
    bar->setRange(0, 1000);
    bar->setTextVisible(false);
    rows->addWidget(bar);
    state->hide();
    bar->hide();
    setForAuthors(forAuthors);
  }

  void setForAuthors(bool forAuthors) {
    title_->setText(forAuthors ? ownTitle_ : traineesTitle_);
    setAccessibleName(title_->text());
  }

  void setState(const QString& text, double fraction) {
    state->setText(text);
    state->setVisible(!text.isEmpty());
    bar->setValue(static_cast<int>(fraction * 1000.0));
    bar->setVisible(fraction > 0.0);
  }

  QLabel* state = nullptr;
  QProgressBar* bar = nullptr;
  Thumbnail* thumbnail = nullptr;
  const std::string id;

 protected:
  void mouseReleaseEvent(QMouseEvent* event) override {
    if (event->button() == Qt::LeftButton && rect().contains(event->pos())) chosen_();
  }
  void keyPressEvent(QKeyEvent* event) override {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_Space) {
      chosen_();
    } else {
      QFrame::keyPressEvent(event);
    }
  }

 private:
  QLabel* title_ = nullptr;
  QString ownTitle_, traineesTitle_;
  std::function<void()> chosen_;
};

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

QLabel* heading(const QString& text) {
  auto* label = new QLabel(text);
  label->setProperty("heading", true);
  return label;
}

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("startPage"));
  setAttribute(Qt::WA_StyledBackground);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->addWidget(scroll);
  body_ = new QWidget;
  body_->setObjectName(QStringLiteral("startBody"));
  body_->setAttribute(Qt::WA_StyledBackground);
  scroll->setWidget(body_);

  auto* rows = new QVBoxLayout(body_);
  rows->setContentsMargins(40, 32, 40, 32);
  rows->setSpacing(16);
  auto* head = new QHBoxLayout;
  head->addWidget(heading(tr("Cases")));
  head->addStretch(1);
  back_ = new QPushButton;
  back_->setObjectName(QStringLiteral("startBack"));
  back_->setToolTip(tr("Back to what is open (Escape)"));
  back_->hide();
  head->addWidget(back_);
  auto* open = new QPushButton(icon(QStringLiteral("open"), currentTheme().onAccent), tr("Open…"));
  open->setObjectName(QStringLiteral("startOpen"));
  open->setProperty("primary", true);
  open->setToolTip(tipWithKeys(tr("Open a case, a volume or a sweep (%1)"), "open"));
  head->addWidget(open);
  rows->addLayout(head);
  empty_ = new QLabel;
  empty_->setObjectName(QStringLiteral("startEmpty"));
  empty_->setProperty("quiet", true);
  empty_->setWordWrap(true);
  empty_->hide();
  rows->addWidget(empty_);
  grid_ = new QGridLayout;
  grid_->setSpacing(kGap_px);
  rows->addLayout(grid_);
  recentTitle_ = heading(tr("Recently opened"));
  recentTitle_->hide();
  rows->addSpacing(16);
  rows->addWidget(recentTitle_);
  recent_ = new QVBoxLayout;
  recent_->setSpacing(0);
  rows->addLayout(recent_);
  hint_ = new QLabel;
  hint_->setObjectName(QStringLiteral("startHint"));
  hint_->setProperty("quiet", true);
  hint_->setProperty("small", true);
  hint_->setWordWrap(true);
  rows->addWidget(hint_);
  rows->addStretch(1);
  connect(open, &QPushButton::clicked, this, &StartPage::openRequested);
  connect(back_, &QPushButton::clicked, this, &StartPage::backRequested);
  setForAuthors(false);
}

void StartPage::setForAuthors(bool forAuthors) {
  forAuthors_ = forAuthors;
  for (QWidget* card : cards_) static_cast<CaseCard*>(card)->setForAuthors(forAuthors);
  hint_->setText(forAuthors
                     ? tr("A sweep (.igs.mha), a volume (.mha, .mhd, .nrrd, .nii) or a case folder can also be dropped on this window.")
                     : tr("A case folder can also be dropped on this window."));
}

void StartPage::setOpenCase(const QString& name) {
  back_->setVisible(!name.isEmpty());
  back_->setText(tr("Back to the scan"));
  back_->setAccessibleName(tr("Back to %1").arg(name));
}

void StartPage::showCases(const std::vector<Case>& cases, const QString& problem) {
  for (QWidget* card : cards_) card->deleteLater();
  cards_.clear();
  for (const Case& shown : cases) {
    cards_.push_back(new CaseCard(shown, forAuthors_, [this, folder = wordsOf(shown.folder)] { Q_EMIT caseChosen(folder); }));
  }
  empty_->setVisible(cases.empty());
  empty_->setText(problem.isEmpty() ? tr("There are no cases here yet. Open a case folder, a volume or a sweep to begin.") : problem);
  columns_ = 0;
  arrange();
}

void StartPage::showRecent(const std::vector<RecentFile>& files) {
  while (QLayoutItem* item = recent_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  recentTitle_->setVisible(!files.empty());
  for (const RecentFile& file : files) {
    auto* button = new RecentButton(file.name);
    button->setObjectName(QStringLiteral("recentFile"));
    button->setProperty("flat", true);
    button->setToolTip(file.tip);
    button->setStyleSheet(QStringLiteral("text-align: left;"));
    button->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    connect(button, &QPushButton::clicked, this, [this, path = file.path] { Q_EMIT fileChosen(path); });
    recent_->addWidget(button, 0, Qt::AlignLeft);
  }
}

void StartPage::setThumbnail(const std::string& caseId, const QImage& picture) {
  for (QWidget* widget : cards_) {
    auto* card = static_cast<CaseCard*>(widget);
    if (card->id == caseId) card->thumbnail->setPicture(picture);
  }
}

void StartPage::setState(const std::string& caseId, const QString& state, double fraction) {
  for (QWidget* widget : cards_) {
    auto* card = static_cast<CaseCard*>(widget);
    if (card->id == caseId) card->setState(state, fraction);
  }
}

void StartPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

void StartPage::arrange() {
  const int columns = std::max(1, (width() - 80 + kGap_px) / (kLeastCardWidth_px + kGap_px));
  if (columns == columns_) return;
  columns_ = columns;
  for (std::size_t i = 0; i < cards_.size(); ++i) {
    grid_->addWidget(cards_[i], static_cast<int>(i) / columns, static_cast<int>(i) % columns);
    cards_[i]->show();
  }
  // The cards share the width. Giving a column a stretch makes it exist, so the count is taken before.
  const int known = std::max(grid_->columnCount(), columns);
  for (int column = 0; column < known; ++column) grid_->setColumnStretch(column, column < columns ? 1 : 0);
  // The tab key goes from card to card before it comes to what was open recently.
  QWidget* before = findChild<QPushButton*>(QStringLiteral("startOpen"));
  for (QWidget* card : cards_) {
    setTabOrder(before, card);
    before = card;
  }
}

}  // namespace ew::ui
