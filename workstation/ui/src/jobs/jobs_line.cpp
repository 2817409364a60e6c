#include "jobs/jobs_line.h"

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
#include <utility>

#include "ew/widgets/ellipsis_label.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/icons.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"

namespace ew::ui {
namespace {

constexpr double kShowAfter_s = 0.5;
constexpr int kJobsLine_px = 380;
constexpr int kLeastJobsLine_px = 150;
constexpr int kJobList_px = 360;

/// A title whose file names may wrap as words do, so that none of it has to be left out.
QString breakable(QString title) {
  for (const char after : {'-', '_', '.', '/'}) title.replace(QLatin1Char(after), QLatin1Char(after) + QString(QChar(0x200B)));
  return title;
}

QString percentOf(const Jobs::Seen& job) { return QStringLiteral("%1 %").arg(static_cast<int>(std::floor(job.fraction * 100.0))); }
int perMilleOf(const Jobs::Seen& job) { return static_cast<int>(job.fraction * 1000.0); }

QProgressBar* thinBar() {
  auto* bar = new QProgressBar;
  bar->setRange(0, 1000);
  bar->setTextVisible(false);
  return bar;
}

QPushButton* flatButton(const QString& text, const char* name) {
  auto* button = new QPushButton(text);
  button->setObjectName(QLatin1String(name));
  setLook(button, Look::flat);
  setLook(button, Look::small);
  button->setFocusPolicy(Qt::TabFocus);  // it vanishes with its job; the focus had better stay where it was
  return button;
}

}  // namespace

JobsLine::JobsLine(Jobs& jobs, QWidget* parent) : QWidget(parent), jobs_(jobs) {
  setObjectName(QStringLiteral("jobsLine"));
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  auto* line = new QHBoxLayout;
  line->setSpacing(8);
  title_ = new EllipsisLabel;
  title_->setObjectName(QStringLiteral("jobTitle"));
  title_->setTextFormat(Qt::PlainText);
  title_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  percent_ = new FigureLabel(QStringLiteral("100 %"));
  percent_->setObjectName(QStringLiteral("jobPercent"));
  for (QLabel* label : {static_cast<QLabel*>(title_), static_cast<QLabel*>(percent_)}) {
    setLook(label, Look::small);
    setLook(label, Look::quiet);
  }
  more_ = flatButton({}, "moreJobs");
  more_->setCheckable(true);
  cancel_ = flatButton(tr("Cancel"), "cancelJob");
  line->addWidget(title_, 1);
  line->addWidget(percent_);
  line->addWidget(more_);
  line->addWidget(cancel_);
  rows->addLayout(line, 1);
  bar_ = thinBar();
  rows->addWidget(bar_);
  poll_.setInterval(60);
  connect(&poll_, &QTimer::timeout, this, &JobsLine::refresh);
  connect(&jobs_, &Jobs::started, &poll_, qOverload<>(&QTimer::start));
  connect(&jobs_, &Jobs::finished, this, &JobsLine::refresh);
  // Another job may come to the front between press and click; keys and click() press, too.
  connect(cancel_, &QPushButton::pressed, this, [this] { pressed_ = shown_; });
  connect(cancel_, &QPushButton::clicked, this, [this] { jobs_.cancel(pressed_); });
  connect(more_, &QPushButton::toggled, this, &JobsLine::fold);
  hide();
}

QSize JobsLine::sizeHint() const { return {scaled(kJobsLine_px), QWidget::sizeHint().height()}; }

QSize JobsLine::minimumSizeHint() const {
  const int least_px = cancel_->sizeHint().width() + percent_->sizeHint().width() + (more_->isHidden() ? 0 : more_->sizeHint().width());
  return {std::max(scaled(kLeastJobsLine_px), least_px + 4 * kGrid_px), QWidget::minimumSizeHint().height()};
}

void JobsLine::refresh() {
  seen_.clear();
  const std::vector<Jobs::Seen> running = jobs_.seen();
  if (running.empty()) poll_.stop();
  for (const Jobs::Seen& job : running)
    if (job.age_s >= kShowAfter_s || job.id == shown_) seen_.push_back(job);
  // Somebody waits for the others; of those that nobody waits for the first one is in front.
  std::stable_sort(seen_.begin(), seen_.end(), [](const Jobs::Seen& a, const Jobs::Seen& b) {
    return a.kind != Jobs::Kind::background && b.kind == Jobs::Kind::background;
  });
  shown_ = seen_.empty() ? 0 : seen_.front().id;
  if (!seen_.empty()) {
    const Jobs::Seen& front = seen_.front();
    title_->setText(front.cancelling ? tr("Stopping…") : front.title);
    title_->setToolTip(front.step.isEmpty() ? front.title : front.title + QLatin1Char('\n') + front.step);
    percent_->setText(percentOf(front));
    bar_->setValue(perMilleOf(front));
    cancel_->setText(front.kind == Jobs::Kind::background ? tr("Not now") : tr("Cancel"));
    cancel_->setEnabled(!front.cancelling);
    cancel_->setAccessibleName(tr("Cancel: %1").arg(front.title));
    const auto others = static_cast<int>(seen_.size()) - 1;
    more_->setText(tr("%n more", nullptr, others));
    more_->setToolTip(tr("Shows everything that is being worked on"));
    more_->setVisible(others > 0);
    if (others == 0 && more_->isChecked()) more_->setChecked(false);
  } else if (more_->isChecked()) {
    more_->setChecked(false);
  }
  setVisible(!seen_.empty());
  if (list_ != nullptr) fillList();
}

void JobsLine::fold(bool open) {
  if (!open) {
    if (list_ != nullptr) list_->deleteLater();
    list_.clear();
    rows_.clear();
    return;
  }
  list_ = new QFrame(window());
  list_->setObjectName(QStringLiteral("jobList"));
  new QVBoxLayout(list_);
  fillList();
}

void JobsLine::fillList() {
  const bool isSame = std::equal(rows_.begin(), rows_.end(), seen_.begin(), seen_.end(),
                                 [](const Row& row, const Jobs::Seen& job) { return row.id == job.id; });
  if (!isSame) {
    rows_.clear();
    delete list_->layout();
    qDeleteAll(list_->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
    auto* column = new QVBoxLayout(list_);
    column->setContentsMargins(16, 12, 16, 12);
    for (const Jobs::Seen& job : seen_) {
      auto* head = new QHBoxLayout;
      auto* title = new QLabel(breakable(job.title));
      title->setTextFormat(Qt::PlainText);
      title->setWordWrap(true);
      auto* cancel = flatButton(tr("Cancel"), "cancelListedJob");
      cancel->setAccessibleName(tr("Cancel: %1").arg(job.title));
      connect(cancel, &QPushButton::clicked, this, [this, id = job.id] { jobs_.cancel(id); });
      head->addWidget(title, 1);
      head->addWidget(cancel, 0, Qt::AlignTop);
      auto* step = new QLabel;
      setLook(step, Look::quiet);
      setLook(step, Look::small);
      step->setWordWrap(true);
      auto* bar = thinBar();
      column->addLayout(head);
      column->addWidget(step);
      column->addWidget(bar);
      rows_.push_back({job.id, step, bar, cancel});
    }
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Jobs::Seen& job = seen_[i];
    rows_[i].step->setText(job.cancelling       ? tr("Stopping…")
                           : job.step.isEmpty() ? percentOf(job)
                                                : tr("%1: %2").arg(percentOf(job), job.step));
    rows_[i].bar->setValue(perMilleOf(job));
    rows_[i].cancel->setEnabled(!job.cancelling);
  }
  list_->show();
  placeList();
}

/// Above the line, as long as it is asked for.
void JobsLine::placeList() {
  list_->setFixedWidth(std::min(scaled(kJobList_px), window()->width() - 2 * kGrid_px));
  list_->layout()->activate();
  const int height_px = list_->layout()->hasHeightForWidth() ? list_->layout()->heightForWidth(list_->width()) : list_->sizeHint().height();
  list_->resize(list_->width(), height_px);
  const QPoint corner = mapTo(window(), QPoint(isRightToLeft() ? 0 : width() - list_->width(), -height_px - kGrid_px / 2));
  list_->move(std::clamp(corner.x(), kGrid_px, std::max(kGrid_px, window()->width() - list_->width() - kGrid_px)), corner.y());
  list_->raise();
}

}  // namespace ew::ui
