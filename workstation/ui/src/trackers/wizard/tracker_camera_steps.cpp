#include "trackers/wizard/tracker_camera_steps.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QVariant>
#include <cmath>

#include "ew/widgets/figures.h"
#include "ew/widgets/words.h"
#include "scan/tracking_look.h"
#include "trackers/control/tracker_control.h"
#include "trackers/wizard/tracker_camera_view.h"

namespace ew::ui {
namespace {

constexpr double kDark = 45.0;  // mean grey below which a webcam makes its images long, and so blurred
constexpr double kBright = 225.0;
constexpr double kBlurred_px = 4.0;
constexpr std::size_t kStill = 20;  // readings that steadiness is told from
constexpr int kSeenEnough = 30;     // images, about a second of them
constexpr double kNear_mm = 250.0;
constexpr double kFar_mm = 900.0;

QString nameOfSize(const QSize& size) { return QStringLiteral("%1 × %2").arg(size.width()).arg(size.height()); }

/// A file or a device, and not the number of a camera that may be there or not.
bool isNamed(const std::string& device) { return device.find_first_not_of("0123456789") != std::string::npos; }

}  // namespace

void showCameraView(TrackerCameraView& image, const CameraView& view) {
  if (view.preview.pixels.empty()) return image.setImage({}, {});
  const QImage grey(view.preview.pixels.data(), view.preview.width, view.preview.height, view.preview.width, QImage::Format_Grayscale8);
  std::vector<TrackerCameraView::Outline> outlines;
  const Theme look = scanTheme();
  std::vector<bool> named(view.names.size(), false);
  for (const MarkerSight& marker : view.sight.markers) {
    const auto body = static_cast<std::size_t>(marker.body);
    const TrackingState state = body < view.sight.bodies.size() ? view.sight.bodies[body].state : TrackingState::invalid;
    TrackerCameraView::Outline outline;
    for (const glm::dvec2& corner : marker.corners_px) outline.corners << QPointF(corner.x * view.scale, corner.y * view.scale);
    outline.colour = marker.used ? lookOf(state, look).colour : look.quiet;
    if (body < named.size() && !named[body]) outline.word = words(view.names[body]);
    if (body < named.size()) named[body] = true;
    outlines.push_back(std::move(outline));
  }
  image.setImage(grey.copy(), std::move(outlines));
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
  sizes_->setAccessibleName(tr("Size of the image"));
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
  image_ = new TrackerCameraView;
  rows().addWidget(image_, 1);
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
    image_->setEmptySentence(tr("No camera was found. Plug one in and choose 'Look again', or choose a video file."));
    image_->setImage({}, {});
    return say(*verdict_, {});
  }
  if (cameras_->currentData().toString() != words(camera->device)) fillCameras();
  const auto view = trackers_.cameraView();
  if (!view || view->preview.pixels.empty()) {
    image_->setEmptySentence(words(trackers_.deviceStatus().sentence));
    image_->setImage({}, {});
    return say(*verdict_, {});
  }
  showCameraView(*image_, *view);
  if (view->light < kDark)
    say(*verdict_, tr("It is too dark: the camera then takes long images, and every motion is blurred. Switch on a lamp."), Tone::bad);
  else if (view->light > kBright)
    say(*verdict_, tr("It is too bright: white paper loses its edges. Turn a lamp away, or draw a curtain."), Tone::bad);
  else if (view->blur_px > kBlurred_px)
    say(*verdict_, tr("The image is blurred while something moves. More light makes it sharper."), Tone::bad);
  else
    say(*verdict_,
        tr("The image is bright enough: %1, %2 images each second.")
            .arg(nameOfSize({view->width, view->height}), figure(view->frames_hz, 0)),
        Tone::good);
  if (!std::exchange(seen_, true)) Q_EMIT changed();
}

TrackerHoldStep::TrackerHoldStep(Trackers& trackers, std::string tracker, QWidget* parent)
    : TrackerStep(
          tr("Hold the probe"),
          tr("Take the folded body in your hand like a probe, its nose down, and hold it where the mannequin will be. Move it slowly: "
             "the outlines must follow."),
          parent),
      trackers_(trackers),
      tracker_(std::move(tracker)) {
  image_ = new TrackerCameraView;
  rows().addWidget(image_, 1);
  figures_ = addSentence("trackerHoldFigures");
  verdict_ = addSentence("trackerHoldVerdict");
}

bool TrackerHoldStep::isDone() const { return seenImages_ >= kSeenEnough || trackers_.isAligned(tracker_); }

void TrackerHoldStep::enter() {
  recent_.clear();
  trackers_.use(tracker_);
}

void TrackerHoldStep::poll() {
  const auto view = trackers_.cameraView();
  if (!view || view->preview.pixels.empty()) {
    image_->setEmptySentence(words(trackers_.deviceStatus().sentence));
    return image_->setImage({}, {});
  }
  showCameraView(*image_, *view);
  if (view->number == lastImage_) return;
  const auto since = static_cast<int>(view->number - lastImage_);
  lastImage_ = view->number;
  if (view->sight.bodies.empty()) return say(*verdict_, tr("No paper body is chosen; go back to the first step."), Tone::bad);
  const BodySight& body = view->sight.bodies.front();
  if (body.state != TrackingState::live) {
    recent_.clear();
    say(*figures_, {});
    return say(*verdict_, body.state == TrackingState::outOfRange
                              ? tr("It is seen, but too badly to be measured: bring it nearer, or turn another face to the camera.")
                              : tr("It is not seen. Hold it into the image, so that no finger covers a marker."));
  }
  const bool wasDone = isDone();
  seenImages_ += std::min(since, 5);
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
    say(*verdict_, tr("Very near: move the camera or your hand back, so that it stays in the image."));
  else if (distance_mm > kFar_mm)
    say(*verdict_, tr("Far away: it will be measured less well. Half a metre is good."));
  else
    say(*verdict_, tr("It is seen well."), Tone::good);
  if (wasDone != isDone()) Q_EMIT changed();
}

}  // namespace ew::ui
