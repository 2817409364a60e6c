#include "trackers/wizard/tracker_check_step.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "ew/tracking/hand.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "trackers/control/tracker_control.h"
#include "trackers/wizard/tracker_body_drawing.h"

namespace ew::ui {
namespace {

constexpr double kApart_mm = 60.0;  ///< two places closer together prove one thing twice
constexpr double kTouch_mm = 40.0;  ///< further from the skin nobody claims to touch it

}  // namespace

TrackerCheckStep::TrackerCheckStep(Trackers& trackers, std::string tracker, QWidget* parent)
    : TrackerStep(
          tr("Check it"),
          tr("Lay the middle of the probe's face on the skin, lightly, in three places far from each other, and hold still in each. "
             "The distance shown should be within 3 mm."),
          parent),
      trackers_(trackers),
      tracker_(std::move(tracker)) {
  auto* columns = new QHBoxLayout;
  columns->setSpacing(16);
  body_ = new TrackerBodyDrawing;
  columns->addWidget(body_, 1);
  auto* column = new QVBoxLayout;
  column->setSpacing(8);
  auto* name = new QLabel(tr("Distance from the skin"));
  setLook(name, Look::quiet);
  column->addWidget(name);
  gap_ = new FigureLabel(tr("%1 mm").arg(QStringLiteral("-888.8")));
  gap_->setObjectName(QStringLiteral("trackerGap"));
  setLook(gap_, Look::heading);
  gap_->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  column->addWidget(gap_);
  hand_ = new QLabel;
  hand_->setObjectName(QStringLiteral("trackerCheckHand"));
  hand_->setWordWrap(true);
  hand_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  holdLeastHeight(*hand_, 54);
  column->addWidget(hand_);
  column->addStretch(1);
  columns->addLayout(column, 1);
  rows().addLayout(columns, 1);
  verdict_ = addSentence("trackerCheckVerdict");
}

bool TrackerCheckStep::isDone() const {
  return checked_.size() >= kPlaces &&
         std::all_of(checked_.begin(), checked_.end(), [](const Checked& each) { return std::abs(each.gap_mm) <= kGood_mm; });
}

void TrackerCheckStep::enter() {
  trackers_.use(tracker_);
  body_->setBody(trackers_.mannequin().bodyPoints());
  body_->lookAt(trackers_.mannequin().landmarkPlaces());
  still_.forget();
  checked_.clear();
  showAll();
}

void TrackerCheckStep::poll() {
  const auto face = trackers_.face();
  const auto skin = trackers_.mannequin().skin();
  if (!trackers_.isAligned(tracker_)) {
    gap_->setText(QStringLiteral("–"));
    return say(*hand_, tr("The tracker is not aligned with the mannequin yet; go back one step."), Tone::bad);
  }
  if (!face || !skin) {
    still_.forget();
    gap_->setText(QStringLiteral("–"));
    body_->setProbe(std::nullopt);
    return say(*hand_, words(trackers_.report().sentence));
  }
  body_->setProbe(face->at_world);
  const double gap_mm = MannequinTouches::gap_mm(*skin, face->at_world);
  gap_->setText(tr("%1 mm").arg(signedFigure(gap_mm, 1)));
  still_.add(face->at_world, face->time_s);
  const int percent = static_cast<int>(100.0 * std::clamp(still_.heldFor_s() / TrackerStill::kHold_s, 0.0, 1.0));
  say(*hand_, std::abs(gap_mm) > kTouch_mm ? tr("Lay the probe on the skin.") : tr("Held still: %1 %").arg(percent));
  if (std::abs(gap_mm) > kTouch_mm) return;
  if (const auto at = still_.taken()) take(*at);
}

void TrackerCheckStep::take(const glm::dvec3& at_world) {
  const Checked fresh{at_world, MannequinTouches::gap_mm(*trackers_.mannequin().skin(), at_world)};
  const auto near =
      std::find_if(checked_.begin(), checked_.end(), [&](const Checked& each) { return glm::distance(each.at_mm, at_world) < kApart_mm; });
  if (near != checked_.end())
    *near = fresh;
  else
    checked_.push_back(fresh);
  showAll();
  Q_EMIT changed();
}

void TrackerCheckStep::showAll() {
  std::vector<TrackerBodyDrawing::Place> places;
  double worst_mm = 0.0;
  for (const Checked& each : checked_) {
    const bool fits = std::abs(each.gap_mm) <= kGood_mm;
    places.push_back({{}, {}, each.at_mm, fits ? TrackerBodyDrawing::Mark::taken : TrackerBodyDrawing::Mark::bad});
    worst_mm = std::max(worst_mm, std::abs(each.gap_mm));
  }
  body_->setPlaces(std::move(places));
  const int left = static_cast<int>(kPlaces) - static_cast<int>(checked_.size());
  if (worst_mm > kGood_mm)
    say(*verdict_,
        tr("In one place the probe is %1 mm from the skin by what the program knows. Touch that place again; if it stays, go back and "
           "align "
           "again.")
            .arg(figure(worst_mm, 1)),
        Tone::bad);
  else if (left > 0)
    say(*verdict_, checked_.empty() ? QString() : tr("It fits. Places still to be touched: %1").arg(left));
  else
    say(*verdict_, tr("It fits within %1 mm. You can scan now.").arg(figure(worst_mm, 1)), Tone::good);
}

}  // namespace ew::ui
