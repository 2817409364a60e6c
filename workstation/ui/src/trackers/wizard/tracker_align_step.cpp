#include "trackers/wizard/tracker_align_step.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QShortcut>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ew/widgets/figures.h"
#include "ew/widgets/icons.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "trackers/control/tracker_control.h"
#include "trackers/wizard/tracker_body_drawing.h"

namespace ew::ui {
namespace {

const auto kByItself = QStringLiteral("tracker/takeByItself");

constexpr std::size_t kAdvised = 4;

}  // namespace

TrackerAlignStep::TrackerAlignStep(Trackers& trackers, std::string tracker, QWidget* parent)
    : TrackerStep(
          tr("Align with the mannequin"),
          tr("Touch the marked place of the mannequin with the middle of the probe's face and hold still for a second. Three places "
             "are enough; a fourth one shows whether one of them was wrong."),
          parent),
      trackers_(trackers),
      tracker_(std::move(tracker)) {
  auto* columns = new QHBoxLayout;
  columns->setSpacing(16);
  body_ = new TrackerBodyDrawing;
  columns->addWidget(body_, 1);
  auto* column = new QVBoxLayout;
  column->setSpacing(8);
  nextName_ = new QLabel;
  nextName_->setObjectName(QStringLiteral("trackerNextPlace"));
  setLook(nextName_, Look::heading);
  nextName_->setWordWrap(true);
  column->addWidget(nextName_);
  hand_ = new QLabel;
  hand_->setObjectName(QStringLiteral("trackerHandState"));
  hand_->setWordWrap(true);
  hand_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  holdLeastHeight(*hand_, 54);
  column->addWidget(hand_);
  auto* row = new QHBoxLayout;
  take_ = new QPushButton(tr("Take this place"));
  take_->setObjectName(QStringLiteral("trackerTake"));
  take_->setToolTip(tr("Takes the place where the probe's face is now (F5, or hold still for a second)"));
  remove_ = new QPushButton(tr("Remove"));
  remove_->setObjectName(QStringLiteral("trackerRemovePlace"));
  remove_->setToolTip(tr("Removes the chosen place from the list (Delete)"));
  for (QPushButton* each : {take_, remove_}) {
    each->setAutoDefault(false);
    row->addWidget(each);
  }
  row->addStretch(1);
  column->addLayout(row);
  byItself_ = new QCheckBox(tr("Take it when it is held still"));
  byItself_->setObjectName(QStringLiteral("trackerByItself"));
  byItself_->setChecked(QSettings().value(kByItself, true).toBool());
  column->addWidget(byItself_);
  touched_ = new QListWidget;
  touched_->setObjectName(QStringLiteral("trackerTouched"));
  touched_->setAccessibleName(tr("Places that were touched"));
  touched_->setWordWrap(true);
  touched_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  column->addWidget(touched_, 1);
  trace_ = new QPushButton;
  trace_->setObjectName(QStringLiteral("trackerTrace"));
  trace_->setCheckable(true);
  trace_->setAutoDefault(false);
  trace_->setToolTip(
      tr("Slide the probe over the skin, all over the belly and around the flanks: the alignment is refined by the surface"));
  column->addWidget(trace_);
  columns->addLayout(column, 1);
  rows().addLayout(columns, 1);
  result_ = addSentence("trackerAlignment");
  connect(body_, &TrackerBodyDrawing::chosen, this, [this](const QString& id) { chooseNext(id.toStdString()); });
  connect(take_, &QPushButton::clicked, this, &TrackerAlignStep::take);
  connect(remove_, &QPushButton::clicked, this, &TrackerAlignStep::removeChosen);
  connect(byItself_, &QCheckBox::toggled, this, [](bool on) { QSettings().setValue(kByItself, on); });
  connect(trace_, &QPushButton::toggled, this, &TrackerAlignStep::setTracing);
  connect(touched_, &QListWidget::currentRowChanged, this, [this](int chosen) { remove_->setEnabled(chosen >= 0); });
  auto* takeKey = new QShortcut(QKeySequence(Qt::Key_F5), this);
  connect(takeKey, &QShortcut::activated, this, &TrackerAlignStep::take);
  auto* removeKey = new QShortcut(QKeySequence(Qt::Key_Delete), touched_, nullptr, nullptr, Qt::WidgetShortcut);
  connect(removeKey, &QShortcut::activated, this, &TrackerAlignStep::removeChosen);
}

bool TrackerAlignStep::isDone() const { return trackers_.isAligned(tracker_); }

void TrackerAlignStep::enter() {
  trackers_.use(tracker_);
  landmarks_ = trackers_.mannequin().landmarks();
  body_->setBody(trackers_.mannequin().bodyPoints());
  body_->lookAt(trackers_.mannequin().landmarkPlaces());
  still_.forget();
  chooseFirstLeft();
}

void TrackerAlignStep::leave() { trace_->setChecked(false); }

const BodyLandmark* TrackerAlignStep::find(const std::string& id) const {
  const auto found = std::find_if(landmarks_.begin(), landmarks_.end(), [&](const BodyLandmark& each) { return each.id == id; });
  return found != landmarks_.end() ? &*found : nullptr;
}

void TrackerAlignStep::chooseNext(const std::string& id) {
  if (find(id) != nullptr) next_ = id;
  showAll();
}

void TrackerAlignStep::chooseFirstLeft() {
  const auto& touches = trackers_.mannequin().touches(tracker_);
  const auto isLeft = [&](const std::string& id) {
    return std::none_of(touches.begin(), touches.end(), [&](const TrackerTouch& each) { return each.landmark == id; });
  };
  next_.clear();
  std::vector<glm::dvec3> places;
  for (const BodyLandmark& each : landmarks_) places.push_back(each.at_mm);
  for (const std::size_t n : landmarkOrder(places))
    if (next_.empty() && isLeft(landmarks_[n].id)) next_ = landmarks_[n].id;
  showAll();
}

void TrackerAlignStep::take() {
  const auto mean = still_.mean();
  if (!mean || next_.empty() || isTracing_) return;
  const double spread_mm = still_.spread_mm();
  still_.rest();
  keep(*mean, spread_mm);
}

void TrackerAlignStep::keep(const glm::dvec3& at_tracker, double spread_mm) {
  auto touches = trackers_.mannequin().touches(tracker_);
  std::erase_if(touches, [this](const TrackerTouch& each) { return each.landmark == next_; });
  touches.push_back({next_, find(next_)->at_mm, at_tracker, spread_mm});
  trackers_.mannequin().setTouches(tracker_, std::move(touches));
  chooseFirstLeft();
  Q_EMIT changed();
}

void TrackerAlignStep::removeChosen() {
  auto touches = trackers_.mannequin().touches(tracker_);
  const int row = touched_->currentRow();
  if (row < 0 || row >= static_cast<int>(touches.size())) return;
  const std::string removed = touches[static_cast<std::size_t>(row)].landmark;
  touches.erase(touches.begin() + row);
  trackers_.mannequin().setTouches(tracker_, std::move(touches));
  chooseNext(removed);
  Q_EMIT changed();
}

void TrackerAlignStep::setTracing(bool tracing) {
  if (tracing == isTracing_) return;
  isTracing_ = tracing;
  if (tracing)
    trackers_.mannequin().beginTracing();
  else
    trackers_.mannequin().endTracing(tracker_);
  showAll();
  Q_EMIT changed();
}

void TrackerAlignStep::poll() {
  if (isTracing_)
    pollTracing();
  else
    pollTouching();
  const auto face = trackers_.face();
  body_->setProbe(face && trackers_.isAligned(tracker_) ? std::optional(face->at_world) : std::nullopt);
}

void TrackerAlignStep::pollTracing() {
  if (const auto face = trackers_.face()) trackers_.mannequin().trace(face->at_tracker);
  say(*hand_,
      tr("Slide over the skin, all over the belly and around both flanks. Places traced: %1").arg(trackers_.mannequin().tracedCount()));
}

void TrackerAlignStep::pollTouching() {
  const auto face = trackers_.face();
  take_->setEnabled(face.has_value() && !next_.empty());
  if (!face) {
    still_.forget();
    return say(*hand_, words(trackers_.report().sentence));
  }
  still_.add(face->at_tracker, face->time_s);
  if (byItself_->isChecked() && !next_.empty()) {
    const double spread_mm = still_.spread_mm();
    if (const auto at = still_.taken()) return keep(*at, spread_mm);
  }
  const int percent = static_cast<int>(100.0 * std::clamp(still_.heldFor_s() / TrackerStill::kHold_s, 0.0, 1.0));
  say(*hand_, byItself_->isChecked() ? tr("Held still: %1 %").arg(percent) : tr("Touch the place, then take it."));
}

void TrackerAlignStep::showAll() {
  const auto& touches = trackers_.mannequin().touches(tracker_);
  const TrackerAlignment& found = trackers_.mannequin().alignment(tracker_);
  const BodyLandmark* next = find(next_);
  nextName_->setText(isTracing_        ? tr("Trace the surface")
                     : next == nullptr ? tr("All places are touched")
                                       : tr("Touch: %1").arg(words(next->name)));
  std::vector<TrackerBodyDrawing::Place> places;
  for (const BodyLandmark& each : landmarks_) {
    const auto touch = std::find_if(touches.begin(), touches.end(), [&](const TrackerTouch& t) { return t.landmark == each.id; });
    using Mark = TrackerBodyDrawing::Mark;
    Mark mark = each.id == next_ && !isTracing_ ? Mark::next : Mark::offered;
    if (touch != touches.end() && each.id != next_) mark = each.id == found.wrong ? Mark::bad : Mark::taken;
    places.push_back({each.id, words(each.name), each.at_mm, mark});
  }
  body_->setPlaces(std::move(places));
  const int chosen = touched_->currentRow();
  touched_->clear();
  for (std::size_t n = 0; n < touches.size(); ++n) {
    const BodyLandmark* place = find(touches[n].landmark);
    const bool isWrong = touches[n].landmark == found.wrong;
    QString text = place != nullptr ? words(place->name) : words(touches[n].landmark);
    if (n < found.residuals_mm.size()) text += QLatin1Char('\n') + tr("off by %1 mm").arg(figure(found.residuals_mm[n], 1));
    if (isWrong) text += QStringLiteral(" · ") + tr("probably wrong");
    auto* item = new QListWidgetItem(icon(isWrong ? QStringLiteral("tracking-invalid") : QStringLiteral("tracking-live"),
                                          isWrong ? currentTheme().danger : currentTheme().accent),
                                     text, touched_);
    item->setData(Qt::UserRole, words(touches[n].landmark));
  }
  touched_->setCurrentRow(std::min(chosen, touched_->count() - 1));
  remove_->setEnabled(touched_->currentRow() >= 0);
  trace_->setText(isTracing_ ? tr("End tracing") : tr("Trace the surface as well"));
  trace_->setEnabled(isTracing_ || found.isFound);
  take_->setEnabled(next != nullptr && !isTracing_);
  Tone tone = Tone::plain;
  if (found.isFound) tone = found.wrong.empty() ? Tone::good : Tone::bad;
  if (!found.isFound && !found.sentence.empty() && touches.size() >= 3) tone = Tone::bad;
  QString sentence = words(found.sentence);
  if (found.isFound && found.wrong.empty() && touches.size() < kAdvised && !found.isTraced)
    sentence += QLatin1Char(' ') + tr("A fourth place would show a mistake.");
  say(*result_, sentence, tone);
}

}  // namespace ew::ui
