#include "trackers/wizard/tracker_face_step.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ew/tracking/face_calibration.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "trackers/control/tracker_control.h"
#include "trackers/control/tracker_drawing.h"

namespace ew::ui {
namespace {

constexpr std::size_t kPivot = 0;
constexpr std::size_t kFlat = 1;
constexpr std::size_t kAlong = 2;

}  // namespace

TrackerFaceStep::TrackerFaceStep(Trackers& trackers, std::string tracker, QWidget* parent)
    : TrackerStep(
          tr("Find the probe's face"),
          tr("The tracker measures its own tool; where the face of the probe lies on it is found by three motions, each of about ten "
             "seconds."),
          parent),
      trackers_(trackers),
      tracker_(std::move(tracker)) {
  rows().addWidget(new TrackerDrawing(QStringLiteral("tracker-step-face"),
                                      tr("The probe is tipped to all sides about its tip, which stays where it is; then it lies flat on a "
                                         "table and is slid about.")),
                   1);
  addMotion(kPivot, tr("1. Put the middle of the face into a small hollow and tip the probe to all sides; the tip must not slip."));
  addMotion(kFlat, tr("2. Lay the face flat on a table; slide it about and turn it on the table by a quarter or more."));
  addMotion(kAlong, tr("3. Push it straight along its long side, towards its marker, at least 10 cm, without turning it."));
  verdict_ = addSentence("trackerFaceVerdict");
}

void TrackerFaceStep::addMotion(std::size_t n, const QString& what) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(16);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(0, 1);
  auto* words = new QLabel(what);
  words->setWordWrap(true);
  Motion& motion = motions_[n];
  motion.record = new QPushButton(tr("Begin"));
  motion.record->setObjectName(QStringLiteral("trackerMotion%1").arg(n + 1));
  motion.record->setAccessibleName(tr("Begin or end motion %1").arg(n + 1));
  motion.record->setCheckable(true);
  motion.record->setAutoDefault(false);
  motion.answer = new QLabel;
  motion.answer->setObjectName(QStringLiteral("trackerMotionAnswer%1").arg(n + 1));
  motion.answer->setWordWrap(true);
  grid->addWidget(words, 0, 0);
  grid->addWidget(motion.record, 0, 1, Qt::AlignTop);
  grid->addWidget(motion.answer, 1, 0, 1, 2);
  rows().addLayout(grid);
  connect(motion.record, &QPushButton::toggled, this, [this, n](bool on) { setRecording(n, on); });
}

bool TrackerFaceStep::isDone() const {
  const std::string method = trackers_.calibrationOf(tracker_).face.method;
  return method == "pivot_and_flat" || (!isNeeded() && method == "body_file");
}

bool TrackerFaceStep::isNeeded() const { return trackers_.needsFace(tracker_); }

void TrackerFaceStep::enter() {
  trackers_.use(tracker_);
  const TrackerCalibration known = trackers_.calibrationOf(tracker_);
  if (known.face.method == "pivot_and_flat")
    say(*verdict_, tr("The face was found with %1 mm left over. It can be found again.").arg(figure(known.face.residual_mm, 1)),
        Tone::good);
}

void TrackerFaceStep::leave() {
  if (recording_) motions_[*recording_].record->setChecked(false);
}

void TrackerFaceStep::setRecording(std::size_t n, bool recording) {
  if (recording) {
    if (recording_) motions_[*recording_].record->setChecked(false);
    recording_ = n;
    readings_.clear();
    motions_[n].record->setText(tr("End"));
    return;
  }
  motions_[n].record->setText(tr("Begin"));
  if (recording_ != n) return;
  recording_.reset();
  judge(n);
}

void TrackerFaceStep::poll() {
  const auto now = trackers_.reading();
  if (!recording_) return;
  QLabel& answer = *motions_[*recording_].answer;
  if (!now || now->state != TrackingState::live) return say(answer, words(trackers_.report().sentence));
  if (now->arrival_s > latest_s_) readings_.push_back(*now);
  latest_s_ = now->arrival_s;
  say(answer, tr("Readings: %1").arg(readings_.size()));
}

void TrackerFaceStep::judge(std::size_t n) {
  Motion& motion = motions_[n];
  motion.isKnown = false;
  Message sentence;
  if (n == kPivot) {
    const auto found = pivotOf(readings_);
    sentence = found ? found->sentence : found.error().message;
    motion.isKnown = found && found->isKnown;
    if (motion.isKnown) {
      tip_ = found->tip_tool_mm;
      rms_mm_ = found->rms_mm;
      spread_mm_ = found->spread_mm;
      tipReadings_ = found->readings;
    }
  } else if (n == kFlat) {
    const auto found = flatFaceOf(readings_, tip_);
    sentence = found ? found->sentence : found.error().message;
    motion.isKnown = found && found->isKnown;
    if (motion.isKnown) axial_ = found->axial_tool;
  } else {
    const auto found = lateralOf(readings_);
    if (!found) sentence = found.error().message;
    motion.isKnown = found.has_value();
    if (motion.isKnown) lateral_ = *found;
  }
  say(*motion.answer, sentence.empty() ? tr("Good.") : words(sentence), motion.isKnown ? Tone::good : Tone::bad);
  if (std::all_of(motions_.begin(), motions_.end(), [](const Motion& each) { return each.isKnown; })) finish();
}

void TrackerFaceStep::finish() {
  const auto face = faceFrom(tip_, axial_, lateral_);
  if (!face) return say(*verdict_, words(face.error()), Tone::bad);
  CalibrationQuality quality;
  quality.method = "pivot_and_flat";
  quality.residual_mm = rms_mm_;
  quality.expected_mm = spread_mm_;
  quality.samples = tipReadings_;
  trackers_.keepFace(tracker_, face->probeToTool, quality);
  say(*verdict_, tr("The face is found, with %1 mm left over. The mannequin is aligned next.").arg(figure(rms_mm_, 1)), Tone::good);
  Q_EMIT changed();
}

}  // namespace ew::ui
