#include "trackers/control/tracker_figures.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QVariant>
#include <cmath>
#include <numbers>

#include "ew/widgets/figures.h"
#include "ew/widgets/look.h"
#include "ew/widgets/words.h"

namespace ew::ui {
namespace {

const auto kNoFigure = QStringLiteral("–");

QString milliseconds(double seconds) {
  return std::isfinite(seconds) ? TrackerFigures::tr("%1 ms").arg(figure(seconds * 1000.0, 1)) : kNoFigure;
}

}  // namespace

QString nameOf(FilterKind kind) {
  switch (kind) {
    case FilterKind::automatic:
      return TrackerFigures::tr("chosen by the noise");
    case FilterKind::none:
      return TrackerFigures::tr("none");
    case FilterKind::kalman:
      return TrackerFigures::tr("Kalman");
    case FilterKind::oneEuro:
      return TrackerFigures::tr("One Euro");
  }
  return {};
}

TrackerFigures::TrackerFigures(QWidget* parent) : QWidget(parent) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 12, 0, 0);
  rows->setSpacing(12);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(16);
  grid->setVerticalSpacing(6);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  int count = 0;
  const auto place = [&](const QString& name, QLabel* value, const char* objectName, const QString& tip) {
    auto* label = new QLabel(name);
    setLook(label, Look::quiet);
    label->setToolTip(tip);
    value->setObjectName(QLatin1String(objectName));
    value->setToolTip(tip);
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    grid->addWidget(label, count / 2, 2 * (count % 2));
    grid->addWidget(value, count / 2, 2 * (count % 2) + 1);
    ++count;
  };
  const auto add = [&](const QString& name, const QString& widest, const char* objectName, const QString& tip) {
    auto* value = new FigureLabel(widest);
    place(name, value, objectName, tip);
    return value;
  };
  rate_ =
      add(tr("Rate"), tr("%1 per s").arg(QStringLiteral("8888")), "trackerRate", tr("New poses each second, over the last two seconds"));
  delay_ = add(tr("Delay"), tr("%1 ms").arg(QStringLiteral("8888.8")), "trackerDelay",
               tr("From the measurement to this program, by the tracker's own clock; – where it stamps nothing"));
  noise_ = add(tr("Noise"), tr("%1 mm").arg(QStringLiteral("88.88")), "trackerNoise",
               tr("How far the face of the probe trembles about its path (one standard deviation)"));
  intervals_ = add(tr("Uneven by"), tr("%1 ms").arg(QStringLiteral("8888.8")), "trackerIntervals",
                   tr("Spread of the time between two poses: 0 is a tracker that beats evenly"));
  drift_ = add(tr("Clock drift"), tr("%1 ppm").arg(QStringLiteral("-8888")), "trackerDrift",
               tr("How much faster the tracker's clock runs than that of this computer, in millionths"));
  filterDelay_ = add(tr("Filter lags"), tr("%1 ms").arg(QStringLiteral("8888.8")), "trackerFilterDelay",
                     tr("What smoothing adds to the delay of a steady motion"));
  rows->addLayout(grid);

  auto* form = new QFormLayout;
  form->setHorizontalSpacing(16);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  filter_ = new QLabel;
  filter_->setObjectName(QStringLiteral("trackerFilterUsed"));
  form->addRow(tr("Smoothing now"), filter_);
  probe_ = new QComboBox;
  probe_->setObjectName(QStringLiteral("trackerTool"));
  probe_->setAccessibleName(tr("Tool that carries the probe"));
  probe_->setToolTip(tr("Tool that carries the probe"));
  form->addRow(tr("Probe"), probe_);
  reference_ = new QComboBox;
  reference_->setObjectName(QStringLiteral("trackerReference"));
  reference_->setAccessibleName(tr("Tool that is fixed to the mannequin"));
  reference_->setToolTip(tr("Tool that is fixed to the mannequin: then the tracker itself may move"));
  form->addRow(tr("Mannequin"), reference_);
  for (QComboBox* each : {probe_, reference_}) {
    each->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    each->setMinimumContentsLength(16);
  }
  rows->addLayout(form);
  noTools_ = new QLabel(tr("No tool has been heard of yet: its name comes with its first reading."));
  noTools_->setObjectName(QStringLiteral("trackerNoTools"));
  refused_ = new QLabel;
  refused_->setObjectName(QStringLiteral("trackerRefused"));
  for (QLabel* each : {noTools_, refused_}) {
    each->setWordWrap(true);
    setLook(each, Look::quiet);
    setLook(each, Look::small);
    rows->addWidget(each);
  }
  rows->addStretch(1);
  connect(probe_, qOverload<int>(&QComboBox::activated), this, [this] { Q_EMIT probeChosen(probe_->currentData().toString()); });
  connect(reference_, qOverload<int>(&QComboBox::activated), this,
          [this] { Q_EMIT referenceChosen(reference_->currentData().toString()); });
  showNone({});
}

void TrackerFigures::fillTools(QComboBox& box, const std::vector<std::string>& tools, const std::string& chosen,
                               const QString& none) const {
  QStringList wanted{QString()};
  for (const std::string& tool : tools) wanted << QString::fromStdString(tool);
  const QString chosenTool = QString::fromStdString(chosen);
  if (!wanted.contains(chosenTool)) wanted << chosenTool;
  QStringList present;
  for (int n = 0; n < box.count(); ++n) present << box.itemData(n).toString();
  const QSignalBlocker quietly(box);
  if (present != wanted || box.itemText(0) != none) {  // a list that is open under a hand is not made anew for nothing
    box.clear();
    for (const QString& tool : wanted) box.addItem(tool.isEmpty() ? none : tool, tool);
  }
  if (box.currentData().toString() != chosenTool) box.setCurrentIndex(box.findData(chosenTool));
}

void TrackerFigures::show(const TrackingReport& report, const DeviceStatus& status, const TrackedProbeOptions& options) {
  const bool isMeasured = report.rate_hz > 0.0;
  rate_->setText(tr("%1 per s").arg(figure(report.rate_hz, 0)));
  delay_->setText(isMeasured ? milliseconds(report.delay_s) : kNoFigure);
  noise_->setText(isMeasured ? tr("%1 mm").arg(figure(report.noise_mm, 2)) : kNoFigure);
  noise_->setToolTip(isMeasured ? tr("How far the face of the probe trembles about its path (one standard deviation); it turns by %1°")
                                      .arg(figure(report.noise_rad * 180.0 / std::numbers::pi, 2))
                                : tr("How far the face of the probe trembles about its path (one standard deviation)"));
  intervals_->setText(isMeasured ? milliseconds(report.jitterTime_s) : kNoFigure);
  drift_->setText(isMeasured && std::isfinite(report.delay_s) ? tr("%1 ppm").arg(figure(report.drift_ppm, 0)) : kNoFigure);
  filterDelay_->setText(isMeasured ? milliseconds(report.filterDelay_s) : kNoFigure);
  filter_->setText(nameOf(report.filter));
  fillTools(*probe_, status.tools, options.tool,
            report.tool.empty() ? tr("the first one") : tr("the first one: %1").arg(words(report.tool)));
  fillTools(*reference_, status.tools, options.reference, tr("none: the tracker stands still"));
  noTools_->setVisible(status.tools.empty());
  refused_->setVisible(status.refused > 0);
  if (status.refused > 0)
    refused_->setText(
        tr("Not used: %n of what it sent. The last one: %1", nullptr, static_cast<int>(status.refused)).arg(words(status.lastRefusal)));
}

void TrackerFigures::showNone(const TrackedProbeOptions& options) {
  for (FigureLabel* each : {rate_, delay_, noise_, intervals_, drift_, filterDelay_}) each->setText(kNoFigure);
  filter_->setText(nameOf(options.filter));
  fillTools(*probe_, {}, options.tool, tr("the first one"));
  fillTools(*reference_, {}, options.reference, tr("none: the tracker stands still"));
  noTools_->setVisible(false);
  refused_->setVisible(false);
}

}  // namespace ew::ui
