#include "scan/status_line.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

#include "ew/widgets/ellipsis_label.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/icons.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"

namespace ew::ui {

QString nameOfStep(StepKind kind) { return QCoreApplication::translate("ew::StepKind", labelOf(kind)); }

QString nameOfQuality(Quality quality) {
  switch (quality) {
    case Quality::weave:
      return StatusLine::tr("nearest");
    case Quality::linear:
      return StatusLine::tr("linear");
    case Quality::cubic:
      return StatusLine::tr("cubic");
  }
  return {};
}

StatusLine::StatusLine(Session& session, QWidget* parent) : QWidget(parent), session_(session) {
  setObjectName(QStringLiteral("statusLine"));
  setAttribute(Qt::WA_StyledBackground);
  holdFixedHeight(*this, 40);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 0, 16, 0);
  row->setSpacing(32);
  position_ = new FigureLabel(QStringLiteral("x -888.8  y -888.8  z -888.8 mm"));
  plan_ = new FigureLabel;
  contact_ = new FigureLabel(tr("contact %1 %").arg(888));
  edit_ = new EllipsisLabel;
  lowered_ = new QLabel;
  position_->setObjectName(QStringLiteral("position"));
  plan_->setObjectName(QStringLiteral("plan"));
  contact_->setObjectName(QStringLiteral("contact"));
  edit_->setObjectName(QStringLiteral("lastEdit"));
  lowered_->setObjectName(QStringLiteral("lowered"));
  lowered_->setForegroundRole(QPalette::Link);  // the accent
  lowered_->setToolTip(tr("The probe moves fast and frames take long: quality falls until it rests (Adaptive, F9)"));
  position_->setToolTip(tr("Middle of the transducer's face: left, back, up from the mannequin's origin"));
  contact_->setToolTip(tr("How much of the transducer's face touches skin with something recorded below it"));
  for (QLabel* label : {static_cast<QLabel*>(position_), static_cast<QLabel*>(plan_), static_cast<QLabel*>(contact_), edit_, lowered_}) {
    setLook(label, Look::small);
    if (label != lowered_) setLook(label, Look::quiet);
    label->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  }
  contact_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  tracker_ = new QPushButton;
  tracker_->setObjectName(QStringLiteral("trackingState"));
  setLook(tracker_, Look::flat);
  setLook(tracker_, Look::small);
  tracker_->hide();
  connect(tracker_, &QPushButton::clicked, this, &StatusLine::trackerAsked);
  row->addWidget(tracker_);
  row->addWidget(position_);
  row->addWidget(plan_);
  row->addStretch(1);
  row->addWidget(lowered_);
  row->addWidget(edit_);
  row->addWidget(contact_);
  note_ = new EllipsisLabel;
  note_->setObjectName(QStringLiteral("panelNote"));
  setLook(note_, Look::small);
  note_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(note_);

  // Figures that change with every frame cannot be read, and contact asks the skin: four times a second is enough.
  soon_.setSingleShot(true);
  soon_.setInterval(250);
  connect(&soon_, &QTimer::timeout, this, &StatusLine::showPlan);
  connect(&session_.probeControl(), &ProbeControl::holdChanged, this, &StatusLine::showPose);
  connect(&session_.console(), &ScanConsole::knobsChanged, this, &StatusLine::showPose);
  connect(&session_.probeControl(), &ProbeControl::trackingChanged, this, &StatusLine::showPose);
  connect(&session_, &Session::subjectChanged, this, &StatusLine::showPose);
  connect(&session_, &Session::imageChanged, this, [this] {
    if (session_.probeControl().mover() != ProbeControl::Mover::hand) showPose();
    if (!soon_.isActive()) soon_.start();
  });
  showLabels();
  showPose();
  showPlan();
}

void StatusLine::setEdit(const QString& text) { edit_->setText(text); }

void StatusLine::setNote(const QString& text) { note_->setText(text); }

void StatusLine::setTracker(const QString& iconName, const QString& word, const QColor& colour, const QString& tip) {
  constexpr int kIcon_px = 16;
  tracker_->setText(word);
  tracker_->setAccessibleName(tr("Tracker: %1").arg(word));
  tracker_->setToolTip(tip);
  tracker_->setIcon(word.isEmpty() ? QIcon() : icon(iconName, colour));
  tracker_->setIconSize({scaled(kIcon_px), scaled(kIcon_px)});
  tracker_->setStyleSheet(word.isEmpty() ? QString() : QStringLiteral("color: %1;").arg(colour.name()));
  showLabels();
}

void StatusLine::setStaged(bool staged) {
  staged_ = staged;
  showLabels();
  auto* row = static_cast<QHBoxLayout*>(layout());
  row->removeWidget(edit_);
  // Beside a stage the last edit begins the line; beside the scan it stands after the plan.
  row->insertWidget(staged ? 0 : row->indexOf(contact_), edit_, staged ? 1 : 0);
}

void StatusLine::setIdle(bool idle) {
  idle_ = idle;
  showLabels();
}

void StatusLine::setForAuthors(bool forAuthors) {
  forAuthors_ = forAuthors;
  showLabels();
}

void StatusLine::takeCine(QWidget* bar) {
  constexpr int kAllThereIs = 1000;
  cine_ = bar;
  static_cast<QHBoxLayout*>(layout())->insertWidget(0, bar, kAllThereIs);
  showLabels();
}

void StatusLine::takeJobs(QWidget* line) {
  jobs_ = line;
  jobs_->installEventFilter(this);
  layout()->addWidget(jobs_);
}

bool StatusLine::eventFilter(QObject* watched, QEvent* event) {
  if (watched == jobs_ && (event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent)) showLabels();
  return QWidget::eventFilter(watched, event);
}

void StatusLine::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  showLabels();
}

void StatusLine::setCineShown(bool shown) {
  isCineShown_ = shown;
  showLabels();
}

void StatusLine::showLabels() {
  const bool isCine = isCineShown_ && !staged_ && !idle_;
  const bool ofScan = !staged_ && !idle_ && !isCine;
  std::vector<std::pair<QWidget*, bool>> shown{{position_, ofScan},
                                               {lowered_, ofScan},
                                               {contact_, ofScan},
                                               {tracker_, ofScan && !tracker_->text().isEmpty()},
                                               {plan_, ofScan && forAuthors_},
                                               {edit_, !idle_ && !isCine},
                                               {note_, !idle_ && !isCine}};
  if (cine_ != nullptr) shown.emplace_back(cine_, isCine);
  const auto find = [&shown](const QWidget* widget) -> bool& {
    return std::find_if(shown.begin(), shown.end(), [widget](const auto& each) { return each.first == widget; })->second;
  };
  // In a narrow window with large words figures give way: what is cut off says something else.
  const QMargins edges = layout()->contentsMargins();
  int needed_px = edges.left() + edges.right();
  if (jobs_ != nullptr && !jobs_->isHidden()) needed_px += jobs_->minimumSizeHint().width() + layout()->spacing();
  for (const QWidget* each : std::initializer_list<const QWidget*>{tracker_, position_, plan_, contact_})
    if (find(each)) needed_px += each->sizeHint().width() + layout()->spacing();
  for (const QWidget* each : std::initializer_list<const QWidget*>{plan_, position_, contact_}) {
    if (needed_px <= width() || !find(each)) continue;
    find(each) = false;
    needed_px -= each->sizeHint().width() + layout()->spacing();
  }
  // What is shown asks the window for room at once, and it does not become narrower again: so what goes makes room first.
  for (const bool now : {false, true})
    for (const auto& [widget, isShown] : shown)
      if (isShown == now) widget->setVisible(now);
}

void StatusLine::showPose() {
  const glm::dvec3 at = session_.probeControl().pose().probeToWorld.matrix[3];
  // A value that rounds to zero is shown as 0.0, never as -0.0.
  const auto aligned = [](double value) { return figure(std::round(value * 10.0) / 10.0 + 0.0, 1).rightJustified(6); };
  position_->setText(session_.subject() && !session_.probeControl().isLost()
                         ? QStringLiteral("x %1  y %2  z %3 mm").arg(aligned(at.x), aligned(at.y), aligned(at.z))
                         : QString());
  if (!soon_.isActive()) soon_.start();
}

void StatusLine::showPlan() {
  if (!session_.subject()) {
    plan_->setText({});
    plan_->setToolTip({});
    lowered_->setText({});
    contact_->setText({});
    return;
  }
  const std::vector<StepTime> times = session_.frames().stepTimes();
  QStringList parts;
  double total_ms = 0.0;
  for (const StepTime& step : times) {
    total_ms += step.measured_us / 1000.0;
    parts << QStringLiteral("%1 %2").arg(nameOfStep(step.kind), figure(step.measured_us / 1000.0, 2));
  }
  // Two steps can be read at a glance; more of them are for the tooltip.
  constexpr int kReadable = 2;
  if (parts.isEmpty()) {
    plan_->setText({});
  } else if (parts.size() == 1) {
    plan_->setText(tr("plan: %1 ms").arg(parts.front()));
  } else if (parts.size() <= kReadable) {
    plan_->setText(tr("plan: %1 = %2 ms").arg(parts.join(QStringLiteral(" | "))).arg(figure(total_ms, 2)));
  } else {
    plan_->setText(tr("plan: %n steps, %1 ms", nullptr, static_cast<int>(parts.size())).arg(figure(total_ms, 2)));
  }
  plan_->setToolTip(planTip());
  lowered_->setText(session_.frames().isLowered() ? tr("adaptive: %1").arg(nameOfQuality(session_.shownState().knobs.quality)) : QString());
  const auto contact = session_.probeControl().isLost() ? std::nullopt : session_.contact();
  contact_->setText(contact ? tr("contact %1 %").arg(static_cast<int>(std::lround(*contact * 100.0))) : QString());
}

QString StatusLine::planTip() const {
  const auto cell = [](double us) { return QStringLiteral("<td align='right'>%1</td>").arg(figure(us / 1000.0, 2)); };
  QString rows;
  const std::vector<StepTime> times = session_.frames().stepTimes();
  double estimated_us = 0.0;
  double measured_us = 0.0;
  for (const Step& step : session_.seen().plan().steps) {
    const auto time = std::find_if(times.begin(), times.end(), [&](const StepTime& t) { return t.kind == step.kind; });
    const double took_us = time != times.end() ? time->measured_us : 0.0;
    estimated_us += step.estimated_us;
    measured_us += took_us;
    rows += QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td>%2%3</tr>").arg(nameOfStep(step.kind), cell(step.estimated_us), cell(took_us));
  }
  rows += QStringLiteral("<tr><td>%1</td>%2%3</tr>").arg(tr("frame"), cell(estimated_us), cell(measured_us));
  QString tip = QStringLiteral(
                    "<p style='white-space:pre'>%1</p><table cellspacing='2'><tr><td></td><td align='right'>%2&nbsp;</td>"
                    "<td align='right'>%3</td></tr>%4</table>")
                    .arg(tr("What the image runs, ms (median of the last frames)"), tr("estimated"), tr("measured"), rows);
  const LatencyHistogram& latency = session_.frames().latency();
  if (latency.count() == 0) return tip;
  const auto quantile_ms = [&](double share) { return latency.quantile_us(share) / 1000.0; };
  tip += QStringLiteral("<p style='white-space:pre'>%1<br>%2</p><table cellspacing='0'>")
             .arg(tr("From the hand to the image, ms; images: %1").arg(latency.count()), tr("median %1, 95 % %2, 99 % %3, worst %4")
                                                                                             .arg(figure(quantile_ms(0.5), 1))
                                                                                             .arg(figure(quantile_ms(0.95), 1))
                                                                                             .arg(figure(quantile_ms(0.99), 1))
                                                                                             .arg(figure(latency.max_us() / 1000.0, 1)));
  // Buckets are a quarter of a doubling; two together are still finer than anyone reads.
  constexpr int kTogether = 2;
  std::uint64_t most = 1;
  std::vector<std::pair<double, std::uint64_t>> bars;
  for (int bucket = 0; bucket + kTogether <= LatencyHistogram::kBuckets; bucket += kTogether) {
    std::uint64_t count = 0;
    for (int i = 0; i < kTogether; ++i) count += latency.inBucket(bucket + i);
    bars.emplace_back(LatencyHistogram::edge_us(bucket + kTogether - 1), count);
    most = std::max(most, count);
  }
  const auto isEmpty = [](const auto& bar) { return bar.second == 0; };
  bars.erase(std::find_if_not(bars.rbegin(), bars.rend(), isEmpty).base(), bars.end());
  bars.erase(bars.begin(), std::find_if_not(bars.begin(), bars.end(), isEmpty));
  constexpr double kWidest = 24.0;
  for (const auto& [edge_us, count] : bars) {
    const int length =
        count == 0 ? 0 : std::max(1, static_cast<int>(std::lround(kWidest * static_cast<double>(count) / static_cast<double>(most))));
    tip += QStringLiteral("<tr><td align='right'>≤ %1&nbsp;ms&nbsp;</td><td style='color:%2'>%3</td><td>&nbsp;%4</td></tr>")
               .arg(figure(edge_us / 1000.0, edge_us < 10000.0 ? 1 : 0))
               .arg(currentTheme().accent.name(), QString(length, QChar(0x2588)))
               .arg(count);
  }
  return tip + QStringLiteral("</table>");
}

}  // namespace ew::ui
