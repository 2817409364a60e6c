#include "tracker_camera_steps.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QVariant>
#include <cmath>
#include <numeric>

#include "figures.h"
#include "tracker_camera_picture.h"
#include "tracker_control.h"
#include "tracking_look.h"
#include "words.h"

namespace ew::ui {
namespace {

constexpr double kDark = 45.0;  // mean grey below which a webcam makes its pictures long, and so blurred
constexpr double kBright = 225.0;
constexpr double kBlurred_px = 4.0;
constexpr std::size_t kStill = 20;  // readings that steadiness is told from
constexpr int kSeenEnough = 30;     // pictures, about a second of them
constexpr double kNear_mm = 250.0;
constexpr double kFar_mm = 900.0;

QString nameOfSize(const QSize& size) { return QStringLiteral("%1 × %2").arg(size.width()).arg(size.height()); }

/// A file or a device, and not the number of a camera that may be there or not.
bool isNamed(const std::string& device) { return device.find_first_not_of("0123456789") != std::string::npos; }

}  // namespace

void showCameraView(TrackerCameraPicture& picture, const CameraView& view) {
  if (view.preview.pixels.empty()) return picture.setPicture({}, {});
  const QImage grey(view.preview.pixels.data(), view.preview.width, view.preview.height, view.preview.width, QImage::Format_Grayscale8);
  std::vector<TrackerCameraPicture::Outline> outlines;
  const Theme look = scanTheme();
  std::vector<bool> named(view.names.size(), false);
  for (const MarkerSight& marker : view.sight.markers) {
    const auto body = static_cast<std::size_t>(marker.body);
    const TrackingState state = body < view.sight.bodies.size() ? view.sight.bodies[body].state : TrackingState::invalid;
    TrackerCameraPicture::Outline outline;
    for (const glm::dvec2& corner : marker.corners_px) outline.corners << QPointF(corner.x * view.scale, corner.y * view.scale);
    outline.colour = marker.used ? lookOf(state, look).colour : look.quiet;
    if (body < named.size() && !named[body]) outline.word = words(view.names[body]);
    if (body < named.size()) named[body] = true;
    outlines.push_back(std::move(outline));
  }
  picture.setPicture(grey.copy(), std::move(outlines));
}

TrackerCameraStep::TrackerCameraStep(Trackers& trackers, std::string tracker, QWidget* parent)
    : TrackerStep(
          tr("Choose the camera"),
          tr("Put the camera where it sees the mannequin and the hand with the probe, half a metre to a metre away and a little from "
             "above. Bright, even light is the best help there is: a window behind the camera, or two lamps."),
          parent),
      trackers_(trackers),
      tracker_(std::move(tracker)) {
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  cameras_ = new QComboBox;
  cameras_->setObjectName(QStringLiteral("trackerCameras"));
  cameras_->setAccessibleName(tr("Camera"));
  cameras_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  cameras_->setMinimumContentsLength(18);
  sizes_ = new QComboBox;
  sizes_->setObjectName(QStringLiteral("trackerSizes"));
  sizes_->setAccessibleName(tr("Size of the picture"));
  sizes_->setToolTip(tr("More pixels see further and cost time; 1280 × 720 is a good middle"));
  for (const QSize size : {QSize(640, 480), QSize(1280, 720), QSize(1920, 1080)}) sizes_->addItem(nameOfSize(size), size);
  auto* again = new QPushButton(tr("Look again"));
  again->setObjectName(QStringLiteral("trackerLookAgain"));
  again->setToolTip(tr("Looks for cameras that were plugged in meanwhile"));
  auto* film = new QPushButton(tr("Video file…"));
  film->setObjectName(QStringLiteral("trackerFilm"));
  film->setToolTip(tr("A film of a camera in place of one, to try or to show"));
  for (QPushButton* each : {again, film}) each->setAutoDefault(false);
  row->addWidget(cameras_, 1);
  row->addWidget(sizes_);
  row->addWidget(again);
  row->addWidget(film);
  rows().addLayout(row);
  picture_ = new TrackerCameraPicture;
  rows().addWidget(picture_, 1);
  verdict_ = addSentence("trackerCameraVerdict");
  connect(cameras_, qOverload<int>(&QComboBox::activated), this, [this] { choose(cameras_->currentData().toString()); });
  connect(sizes_, qOverload<int>(&QComboBox::activated), this, [this] { chooseSize(sizes_->currentData().toSize()); });
  connect(again, &QPushButton::clicked, this, &TrackerCameraStep::fillCameras);
  connect(film, &QPushButton::clicked, this, &TrackerCameraStep::chooseFilm);
  const CameraSettings* camera = trackers_.cameraOf(tracker_);
  seen_ = camera != nullptr && camera->model.has_value();  // it was seen to be calibrated
}

void TrackerCameraStep::enter() {
  fillCameras();
  const CameraSettings* camera = trackers_.cameraOf(tracker_);
  if (camera == nullptr) return;
  const int size = sizes_->findData(QSize(camera->width, camera->height));
  if (size >= 0) sizes_->setCurrentIndex(size);
  if (!isNamed(camera->device) && cameras_->count() > 0) choose(cameras_->itemData(0).toString());
  if (isNamed(trackers_.cameraOf(tracker_)->device)) trackers_.use(tracker_);
}

void TrackerCameraStep::fillCameras() {
  const QSignalBlocker quietly(cameras_);
  cameras_->clear();
  for (const CameraHere& each : camerasHere())
    cameras_->addItem(tr("%1 (%2)").arg(words(each.name), words(each.device)), words(each.device));
  const CameraSettings* camera = trackers_.cameraOf(tracker_);
  if (camera != nullptr && isNamed(camera->device) && cameras_->findData(words(camera->device)) < 0)
    cameras_->addItem(QFileInfo(words(camera->device)).fileName(), words(camera->device));
  if (camera != nullptr) cameras_->setCurrentIndex(cameras_->findData(words(camera->device)));
  cameras_->setEnabled(cameras_->count() > 0);
}

void TrackerCameraStep::choose(const QString& device) {
  trackers_.chooseCamera(tracker_, device.toStdString());
  seen_ = false;
  trackers_.use(tracker_);
  Q_EMIT changed();
}

void TrackerCameraStep::chooseFilm() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Film of a camera"), {}, tr("Films (*.avi *.mp4 *.mkv *.mov *.webm);;All files (*)"));
  if (file.isEmpty()) return;
  choose(file);
  fillCameras();
}

void TrackerCameraStep::chooseSize(const QSize& size) {
  trackers_.changeCamera(tracker_, [&](CameraSettings& camera) {
    camera.width = size.width();
    camera.height = size.height();
    if (!camera.model) return;
    auto scaledModel = scaledTo(*camera.model, size.width(), size.height());
    camera.model = scaledModel ? std::optional(*scaledModel) : std::nullopt;
  });
  trackers_.use(tracker_);
}

void TrackerCameraStep::poll() {
  const CameraSettings* camera = trackers_.cameraOf(tracker_);
  if (camera == nullptr || !isNamed(camera->device)) {
    picture_->setEmptySentence(tr("No camera was found. Plug one in and choose 'Look again', or choose a video file."));
    picture_->setPicture({}, {});
    return say(*verdict_, {});
  }
  if (cameras_->currentData().toString() != words(camera->device)) fillCameras();
  const auto view = trackers_.cameraView();
  if (!view || view->preview.pixels.empty()) {
    picture_->setEmptySentence(words(trackers_.deviceStatus().sentence));
    picture_->setPicture({}, {});
    return say(*verdict_, {});
  }
  showCameraView(*picture_, *view);
  if (view->light < kDark)
    say(*verdict_, tr("It is too dark: the camera then takes long pictures, and every motion is blurred. Switch on a lamp."), Tone::bad);
  else if (view->light > kBright)
    say(*verdict_, tr("It is too bright: white paper loses its edges. Turn a lamp away, or draw a curtain."), Tone::bad);
  else if (view->blur_px > kBlurred_px)
    say(*verdict_, tr("The picture is blurred while something moves. More light makes it sharper."), Tone::bad);
  else
    say(*verdict_,
        tr("The picture is bright enough: %1, %2 pictures each second.")
            .arg(nameOfSize({view->width, view->height}), figure(view->frames_hz, 0)),
        Tone::good);
  if (!std::exchange(seen_, true)) Q_EMIT changed();
}

struct TrackerLensStep::Gathering {
  CalibrationCollector collector;
  CharucoBoard board;
  int width = 0, height = 0;
  std::uint64_t lastPicture = 0;
};

TrackerLensStep::TrackerLensStep(Trackers& trackers, std::string tracker, QWidget* parent)
    : TrackerStep(
          tr("Measure the lens"),
          tr("Lay the chess board on something flat and stiff, and hold it before the camera: near and far, in the middle and in the "
             "corners, straight and tipped to each side. Hold it still for a moment; pictures are kept by themselves."),
          parent),
      trackers_(trackers),
      tracker_(std::move(tracker)) {
  next_ = addSentence("trackerLensNext");
  picture_ = new TrackerCameraPicture;
  picture_->setMirrored(true);
  rows().addWidget(picture_, 1);
  progress_ = new QProgressBar;
  progress_->setTextVisible(false);
  progress_->setRange(0, 20);
  progress_->setAccessibleName(tr("Pictures that were kept"));
  rows().addWidget(progress_);
  verdict_ = addSentence("trackerLensVerdict");
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  again_ = new QPushButton(tr("Begin again"));
  again_->setObjectName(QStringLiteral("trackerLensAgain"));
  solve_ = new QPushButton(tr("Measure now"));
  solve_->setObjectName(QStringLiteral("trackerLensSolve"));
  solve_->setToolTip(tr("Finds the measures of the lens from the pictures that are kept; it begins by itself once there are enough"));
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
    picture_->setEmptySentence(words(trackers_.deviceStatus().sentence));
    return picture_->setPicture({}, {});
  }
  if (isDone() || isSolving_) showCameraView(*picture_, *view);
  if (!isDone() && !isSolving_ && !isLooking_) look();
}

/// Looks at the latest picture on a thread of its own: finding a chess board takes longer than a window may rest.
void TrackerLensStep::look() {
  CameraDevice* camera = trackers_.camera();
  if (camera == nullptr) return;
  isLooking_ = true;
  worker_.add([this, camera = trackers_.sharedCamera(), board = trackers_.charucoBoard(), gathering = gathering_]() mutable {
    const GreyImage picture = camera->picture();
    const std::uint64_t number = camera->view().number;
    if (!gathering && !picture.pixels.empty()) {
      if (auto made = CalibrationCollector::make(board, picture.width, picture.height))
        gathering = std::shared_ptr<Gathering>(new Gathering{std::move(*made), board, picture.width, picture.height, 0});
    }
    CalibrationCollector::Look look;
    CalibrationCoverage coverage;
    const bool isNew =
        gathering && number != gathering->lastPicture && picture.width == gathering->width && picture.height == gathering->height;
    if (isNew) look = gathering->collector.look(viewOf(picture), steadyNow_s());
    if (isNew) gathering->lastPicture = number;
    if (gathering) coverage = gathering->collector.coverage();
    QMetaObject::invokeMethod(
        this,
        [this, gathering, look, coverage, picture, isNew] {
          isLooking_ = false;
          if (!gathering || isDone()) return;
          if (gathering_ && gathering_ != gathering) return;  // begun again meanwhile
          gathering_ = gathering;
          if (!isNew) return;
          const QImage grey(picture.pixels.data(), picture.width, picture.height, picture.width, QImage::Format_Grayscale8);
          std::vector<TrackerCameraPicture::Outline> corners;
          for (const glm::dvec2& at : look.view.corners_px)
            corners.push_back({QPolygonF(QRectF(at.x - 5.0, at.y - 5.0, 10.0, 10.0)), scanTheme().accent, {}});
          picture_->setPicture(grey.copy(), std::move(corners));
          take(look, coverage);
        },
        Qt::QueuedConnection);
  });
}

void TrackerLensStep::take(const CalibrationCollector::Look& look, const CalibrationCoverage& coverage) {
  coverage_ = coverage;
  switch (look.verdict) {
    case ViewVerdict::noBoard:
      say(*verdict_, tr("The chess board is not seen. Hold it so that at least half of it is in the picture."));
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
  say(*verdict_, tr("Measuring the lens from %n pictures…", nullptr, coverage_.views));
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
        tr("The lens is measured: its pictures agree within %1 pixels, found from %n pictures.", nullptr, model.views)
            .arg(figure(model.rms_px, 2)),
        Tone::good);
    return picture_->setCoverage({});
  }
  say(*next_, coverage_.views == 0 ? tr("Show the chess board to the camera.")
                                   : tr("Pictures kept: %1. %2").arg(coverage_.views).arg(words(coverage_.next)));
  TrackerCameraPicture::Coverage shown;
  shown.columns = CalibrationCoverage::kColumns;
  shown.rows = CalibrationCoverage::kRows;
  constexpr double kFull = 24.0;  // corners of a part of the picture that need no more
  for (const int corners : coverage_.corners) shown.shares.push_back(std::min(1.0, corners / kFull));
  const auto least = std::min_element(coverage_.corners.begin(), coverage_.corners.end());
  if (*least < kFull / 2.0) shown.next = static_cast<int>(least - coverage_.corners.begin());
  picture_->setCoverage(std::move(shown));
}

TrackerHoldStep::TrackerHoldStep(Trackers& trackers, std::string tracker, QWidget* parent)
    : TrackerStep(
          tr("Hold the probe"),
          tr("Take the folded body in your hand like a probe, its nose down, and hold it where the mannequin will be. Move it slowly: "
             "the outlines must follow."),
          parent),
      trackers_(trackers),
      tracker_(std::move(tracker)) {
  picture_ = new TrackerCameraPicture;
  rows().addWidget(picture_, 1);
  figures_ = addSentence("trackerHoldFigures");
  verdict_ = addSentence("trackerHoldVerdict");
}

bool TrackerHoldStep::isDone() const { return seenPictures_ >= kSeenEnough || trackers_.isAligned(tracker_); }

void TrackerHoldStep::enter() {
  recent_.clear();
  trackers_.use(tracker_);
}

void TrackerHoldStep::poll() {
  const auto view = trackers_.cameraView();
  if (!view || view->preview.pixels.empty()) {
    picture_->setEmptySentence(words(trackers_.deviceStatus().sentence));
    return picture_->setPicture({}, {});
  }
  showCameraView(*picture_, *view);
  if (view->number == lastPicture_) return;
  const auto since = static_cast<int>(view->number - lastPicture_);
  lastPicture_ = view->number;
  if (view->sight.bodies.empty()) return say(*verdict_, tr("No paper body is chosen; go back to the first step."), Tone::bad);
  const BodySight& body = view->sight.bodies.front();
  if (body.state != TrackingState::live) {
    recent_.clear();
    say(*figures_, {});
    return say(*verdict_, body.state == TrackingState::outOfRange
                              ? tr("It is seen, but too badly to be measured: bring it nearer, or turn another face to the camera.")
                              : tr("It is not seen. Hold it into the picture, so that no finger covers a marker."));
  }
  const bool wasDone = isDone();
  seenPictures_ += std::min(since, 5);
  recent_.push_back(glm::dvec3(body.bodyToCamera.matrix[3]));
  if (recent_.size() > kStill) recent_.pop_front();
  const double distance_mm = glm::length(recent_.back());
  glm::dvec3 mean(0.0);
  for (const glm::dvec3& at : recent_) mean += at / static_cast<double>(recent_.size());
  double spread = 0.0;
  for (const glm::dvec3& at : recent_) spread += glm::dot(at - mean, at - mean) / static_cast<double>(recent_.size());
  say(*figures_, tr("Distance %1 cm · %2 markers · trembles by %3 mm")
                     .arg(figure(distance_mm / 10.0, 0))
                     .arg(body.markers)
                     .arg(figure(std::sqrt(spread), 1)));
  if (distance_mm < kNear_mm)
    say(*verdict_, tr("Very near: move the camera or your hand back, so that it stays in the picture."));
  else if (distance_mm > kFar_mm)
    say(*verdict_, tr("Far away: it will be measured less well. Half a metre is good."));
  else
    say(*verdict_, tr("It is seen well."), Tone::good);
  if (wasDone != isDone()) Q_EMIT changed();
}

}  // namespace ew::ui
