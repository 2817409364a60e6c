// The step that measures the lens.
#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ew/widgets/figures.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "trackers/control/tracker_control.h"
#include "trackers/wizard/tracker_camera_steps.h"
#include "trackers/wizard/tracker_camera_view.h"

namespace ew::ui {

struct TrackerLensStep::Gathering {
  CalibrationCollector collector;
  CharucoBoard board;
  int width = 0, height = 0;
  std::uint64_t lastImage = 0;
};

TrackerLensStep::TrackerLensStep(Trackers& trackers, std::string tracker, QWidget* parent)
    : TrackerStep(
          tr("Measure the lens"),
          tr("Lay the chess board on something flat and stiff, and hold it before the camera: near and far, in the middle and in the "
             "corners, straight and tipped to each side. Hold it still for a moment; images are kept by themselves."),
          parent),
      trackers_(trackers),
      tracker_(std::move(tracker)) {
  next_ = addSentence("trackerLensNext");
  image_ = new TrackerCameraView;
  image_->setMirrored(true);
  rows().addWidget(image_, 1);
  progress_ = new QProgressBar;
  progress_->setTextVisible(false);
  progress_->setRange(0, 20);
  progress_->setAccessibleName(tr("Images that were kept"));
  rows().addWidget(progress_);
  verdict_ = addSentence("trackerLensVerdict");
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  again_ = new QPushButton(tr("Begin again"));
  again_->setObjectName(QStringLiteral("trackerLensAgain"));
  solve_ = new QPushButton(tr("Measure now"));
  solve_->setObjectName(QStringLiteral("trackerLensSolve"));
  solve_->setToolTip(tr("Finds the measures of the lens from the images that are kept; it begins by itself once there are enough"));
  row->addStretch(1);
  for (QPushButton* each : {again_, solve_}) {
    each->setAutoDefault(false);
    row->addWidget(each);
  }
  rows().addLayout(row);
  connect(again_, &QPushButton::clicked, this, &TrackerLensStep::begin);
  connect(solve_, &QPushButton::clicked, this, &TrackerLensStep::solve);
}

TrackerLensStep::~TrackerLensStep() = default;

bool TrackerLensStep::isDone() const {
  const CameraSettings* camera = trackers_.cameraOf(tracker_);
  return camera != nullptr && camera->model && camera->model->views > 0;
}

void TrackerLensStep::enter() {
  trackers_.use(tracker_);
  if (!isDone() && !gathering_) begin();
  showAll();
}

void TrackerLensStep::begin() {
  gathering_.reset();
  coverage_ = {};
  if (isDone()) trackers_.changeCamera(tracker_, [](CameraSettings& camera) { camera.model.reset(); });
  say(*verdict_, {});
  showAll();
  Q_EMIT changed();
}

void TrackerLensStep::poll() {
  const auto view = trackers_.cameraView();
  if (!view || view->preview.pixels.empty()) {
    image_->setEmptySentence(words(trackers_.deviceStatus().sentence));
    return image_->setImage({}, {});
  }
  if (isDone() || isSolving_) showCameraView(*image_, *view);
  if (!isDone() && !isSolving_ && !isLooking_) look();
}

/// Looks at the latest image on a thread of its own: finding a chess board takes longer than a window may rest.
void TrackerLensStep::look() {
  CameraDevice* camera = trackers_.camera();
  if (camera == nullptr) return;
  isLooking_ = true;
  worker_.add([this, camera = trackers_.sharedCamera(), board = trackers_.papers().charucoBoard(), gathering = gathering_]() mutable {
    const GreyImage image = camera->image();
    const std::uint64_t number = camera->view().number;
    if (!gathering && !image.pixels.empty()) {
      if (auto made = CalibrationCollector::make(board, image.width, image.height))
        gathering = std::shared_ptr<Gathering>(new Gathering{std::move(*made), board, image.width, image.height, 0});
    }
    CalibrationCollector::Look look;
    CalibrationCoverage coverage;
    const bool isNew = gathering && number != gathering->lastImage && image.width == gathering->width && image.height == gathering->height;
    if (isNew) look = gathering->collector.look(viewOf(image), steadyNow_s());
    if (isNew) gathering->lastImage = number;
    if (gathering) coverage = gathering->collector.coverage();
    QMetaObject::invokeMethod(
        this,
        [this, gathering, look, coverage, image, isNew] {
          isLooking_ = false;
          if (!gathering || isDone()) return;
          if (gathering_ && gathering_ != gathering) return;  // begun again meanwhile
          gathering_ = gathering;
          if (!isNew) return;
          const QImage grey(image.pixels.data(), image.width, image.height, image.width, QImage::Format_Grayscale8);
          std::vector<TrackerCameraView::Outline> corners;
          for (const glm::dvec2& at : look.view.corners_px)
            corners.push_back({QPolygonF(QRectF(at.x - 5.0, at.y - 5.0, 10.0, 10.0)), scanTheme().accent, {}});
          image_->setImage(grey.copy(), std::move(corners));
          take(look, coverage);
        },
        Qt::QueuedConnection);
  });
}

void TrackerLensStep::take(const CalibrationCollector::Look& look, const CalibrationCoverage& coverage) {
  coverage_ = coverage;
  switch (look.verdict) {
    case ViewVerdict::noBoard:
      say(*verdict_, tr("The chess board is not seen. Hold it so that at least half of it is in the image."));
      break;
    case ViewVerdict::blurred:
      say(*verdict_, tr("Blurred: hold it still, or give it more light."), Tone::bad);
      break;
    case ViewVerdict::moving:
      say(*verdict_, tr("Hold it still for a moment."));
      break;
    case ViewVerdict::alike:
      say(*verdict_, tr("This view is known. Move the board, or tip it."));
      break;
    case ViewVerdict::kept:
      say(*verdict_, tr("Kept."), Tone::good);
      break;
    case ViewVerdict::full:
      break;
  }
  showAll();
  if (coverage_.enough) solve();
}

void TrackerLensStep::solve() {
  if (isSolving_ || !gathering_ || coverage_.views == 0) return;
  isSolving_ = true;
  say(*verdict_, tr("Measuring the lens from %n images…", nullptr, coverage_.views));
  showAll();
  trackers_.solveLens(tracker_, gathering_->collector.views(), gathering_->board, gathering_->width, gathering_->height,
                      [guard = QPointer<TrackerLensStep>(this)](const Result<CameraCalibration>& found) {
                        if (!guard) return;
                        TrackerLensStep& step = *guard;
                        step.isSolving_ = false;
                        step.gathering_.reset();
                        if (!found)
                          step.say(*step.verdict_, words(found.error()), Tone::bad);
                        else
                          step.say(*step.verdict_, words(found->verdict),
                                   found->quality == CameraCalibration::Quality::bad ? Tone::bad : Tone::good);
                        step.showAll();
                        Q_EMIT step.changed();
                      });
}

void TrackerLensStep::showAll() {
  const bool done = isDone();
  progress_->setVisible(!done);
  progress_->setRange(0, isSolving_ ? 0 : 20);
  progress_->setValue(coverage_.views);
  solve_->setVisible(!done);
  solve_->setEnabled(!isSolving_ && coverage_.views >= 8);
  again_->setEnabled(!isSolving_ && (done || coverage_.views > 0));
  if (done) {
    const CameraModel& model = *trackers_.cameraOf(tracker_)->model;
    say(*next_,
        tr("The lens is measured: its images agree within %1 pixels, found from %n images.", nullptr, model.views)
            .arg(figure(model.rms_px, 2)),
        Tone::good);
    return image_->setCoverage({});
  }
  say(*next_, coverage_.views == 0 ? tr("Show the chess board to the camera.")
                                   : tr("Images kept: %1. %2").arg(coverage_.views).arg(words(coverage_.next)));
  TrackerCameraView::Coverage shown;
  shown.columns = CalibrationCoverage::kColumns;
  shown.rows = CalibrationCoverage::kRows;
  constexpr double kFull = 24.0;  // corners of a part of the image that need no more
  for (const int corners : coverage_.corners) shown.shares.push_back(std::min(1.0, corners / kFull));
  const auto least = std::min_element(coverage_.corners.begin(), coverage_.corners.end());
  if (*least < kFull / 2.0) shown.next = static_cast<int>(least - coverage_.corners.begin());
  image_->setCoverage(std::move(shown));
}

}  // namespace ew::ui
