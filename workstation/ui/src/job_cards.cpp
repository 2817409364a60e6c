#include "job_cards.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <set>

#include "figures.h"
#include "theme.h"

namespace ew::ui {
namespace {

constexpr double kShowAfter_s = 0.5;
constexpr int kWidth_px = 336;
constexpr int kAround_px = 16;

/// A title whose file names may wrap as words do, so that none of it has to be left out.
QString breakable(QString title) {
  for (const char after : {'-', '_', '.', '/'}) title.replace(QLatin1Char(after), QLatin1Char(after) + QString(QChar(0x200B)));
  return title;
}

}  // namespace

struct JobCards::Card final : QFrame {
  QLabel* title = nullptr;
  QLabel* step = nullptr;
  FigureLabel* percent = nullptr;
  QProgressBar* bar = nullptr;
  QPushButton* cancel = nullptr;

  explicit Card(QWidget* parent) : QFrame(parent) {
    setObjectName(QStringLiteral("jobCard"));
    setFixedWidth(scaled(kWidth_px));
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(16, 12, 16, 16);
    rows->setSpacing(4);
    auto* head = new QHBoxLayout;
    title = new QLabel;
    title->setProperty("heading", true);
    title->setTextFormat(Qt::PlainText);
    title->setWordWrap(true);
    cancel = new QPushButton(JobCards::tr("Cancel"));
    cancel->setProperty("flat", true);
    cancel->setObjectName(QStringLiteral("cancelJob"));
    cancel->setFocusPolicy(Qt::TabFocus);  // it vanishes with its job; the focus had better stay where it was
    head->addWidget(title, 1);
    head->addWidget(cancel, 0, Qt::AlignTop);
    rows->addLayout(head);
    auto* line = new QHBoxLayout;
    step = new QLabel;
    step->setProperty("quiet", true);
    step->setProperty("small", true);
    percent = new FigureLabel(QStringLiteral("100 %"));
    percent->setProperty("quiet", true);
    percent->setProperty("small", true);
    line->addWidget(step, 1);
    line->addWidget(percent);
    rows->addLayout(line);
    rows->addSpacing(4);
    bar = new QProgressBar;
    bar->setRange(0, 1000);
    bar->setTextVisible(false);
    rows->addWidget(bar);
  }

  void show(const Jobs::Seen& job) {
    const int room_px = width() - 40;
    title->setText(breakable(job.title));
    title->setToolTip(job.title);
    const QString now = job.cancelling ? JobCards::tr("Stopping…") : job.step;
    step->setText(step->fontMetrics().elidedText(now, Qt::ElideRight, room_px - percent->sizeHint().width()));
    percent->setText(QStringLiteral("%1 %").arg(static_cast<int>(std::floor(job.fraction * 100.0))));
    bar->setValue(static_cast<int>(job.fraction * 1000.0));
    cancel->setEnabled(!job.cancelling);
  }
};

JobCards::JobCards(Jobs& jobs, QWidget* parent) : QWidget(parent), jobs_(jobs) {
  setObjectName(QStringLiteral("jobCards"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  poll_.setInterval(60);
  connect(&poll_, &QTimer::timeout, this, &JobCards::refresh);
  connect(&jobs_, &Jobs::started, &poll_, qOverload<>(&QTimer::start));
  connect(&jobs_, &Jobs::finished, this, &JobCards::refresh);
  hide();
}

void JobCards::placeIn(const QRect& area) {
  area_ = area;
  const int width_px = std::min(scaled(kWidth_px), area.width() - 2 * kAround_px);
  for (const auto& [id, card] : cards_) card->setFixedWidth(width_px);
  layout()->activate();
  const QSize size = sizeHint();
  const QRect corner(area.right() - kAround_px - size.width(), area.bottom() - kAround_px - size.height(), size.width(), size.height());
  setGeometry(QStyle::visualRect(layoutDirection(), area, corner));
  raise();
}

int JobCards::heightWanted() const { return cards_.empty() ? 0 : sizeHint().height() + 2 * kAround_px; }

void JobCards::refresh() {
  const auto jobs = jobs_.seen();
  if (jobs.empty()) poll_.stop();
  std::set<int> running;
  bool changed = false;
  for (const Jobs::Seen& job : jobs) {
    running.insert(job.id);
    auto at = cards_.find(job.id);
    if (at == cards_.end()) {
      if (job.age_s < kShowAfter_s) continue;
      auto* card = new Card(this);
      card->setFixedWidth(std::min(scaled(kWidth_px), area_.width() - 2 * kAround_px));
      connect(card->cancel, &QPushButton::clicked, &jobs_, [this, id = job.id] { jobs_.cancel(id); });
      layout()->addWidget(card);
      at = cards_.emplace(job.id, card).first;
      changed = true;
    }
    at->second->show(job);
    at->second->QWidget::show();
  }
  for (auto at = cards_.begin(); at != cards_.end();) {
    if (running.count(at->first) != 0) {
      ++at;
      continue;
    }
    layout()->removeWidget(at->second);
    at->second->hide();
    at->second->deleteLater();
    at = cards_.erase(at);
    changed = true;
  }
  if (!changed) return;
  setVisible(!cards_.empty());
  layout()->activate();
  placeIn(area_);
  Q_EMIT rearranged();
}

}  // namespace ew::ui
