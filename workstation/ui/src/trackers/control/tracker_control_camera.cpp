// Cameras: which one, what it looks for, its lens.
#include "jobs/jobs.h"
#include "trackers/control/tracker_control.h"

namespace ew::ui {
namespace {

const CameraSource* cameraSourceOf(const TrackerSettings* settings) {
  return settings != nullptr ? std::get_if<CameraSource>(&settings->source) : nullptr;
}

}  // namespace

void Trackers::setMeasuredScale(double mm) {
  if (const auto kept = papers_.keepMeasuredScale(mm); !kept) Q_EMIT problem(kept.error());
  const TrackerSettings* settings = find(used_);
  if (settings != nullptr && camera_) applyCamera(*settings, *cameraOf(used_));
}

bool Trackers::needsFace(const std::string& id) const { return cameraOf(id) == nullptr || !papers_.bodyCalled(bodyOf(id)).faceIsExact; }

const CameraSettings* Trackers::cameraOf(const std::string& id) const {
  const CameraSource* source = cameraSourceOf(find(id));
  return source != nullptr ? &source->camera : nullptr;
}

std::string Trackers::bodyOf(const std::string& id) const {
  const CameraSource* source = cameraSourceOf(find(id));
  return source != nullptr ? source->probeBody : std::string();
}

void Trackers::chooseBody(const std::string& id, const std::string& body) {
  const TrackerSettings* present = find(id);
  if (cameraSourceOf(present) == nullptr || bodyOf(id) == body) return;
  TrackerSettings changed = *present;
  std::get<CameraSource>(changed.source).probeBody = body;
  change(changed);
}

void Trackers::chooseCamera(const std::string& id, const std::string& device) {
  const auto isFilm = [](const std::string& each) { return std::filesystem::path(each).has_extension(); };
  changeCamera(id, [&](CameraSettings& camera) {
    if (camera.device == device) return;
    if (!isFilm(device) || !isFilm(camera.device)) camera.model.reset();
    camera.device = device;
    camera.filmLoops = isFilm(device);
  });
}

void Trackers::changeCamera(const std::string& id, const std::function<void(CameraSettings&)>& apply) {
  TrackerSettings* settings = findMutable(id);
  if (cameraSourceOf(settings) == nullptr) return;
  CameraSettings& camera = std::get<CameraSource>(settings->source).camera;
  const CameraSettings before = camera;
  apply(camera);
  if (camera == before) return;
  keepList();
  if (used_ == id) applyCamera(*settings, before);
  Q_EMIT listChanged();
}

/// A camera that is open stays open where only what is looked for is another.
void Trackers::applyCamera(const TrackerSettings& settings, const CameraSettings& before) {
  const auto& source = std::get<CameraSource>(settings.source);
  CameraSettings asBefore = source.camera;
  asBefore.model = before.model;
  asBefore.tracking = before.tracking;
  if (asBefore != before || !camera_) {
    stopDevice();
    return start(settings);
  }
  const auto known = [this](const std::string& body) {
    return body.empty() || papers_.bodyCalled(body).id.empty() ? std::nullopt : std::optional(papers_.bodyCalled(body));
  };
  camera_->setTracking(source.camera.model, known(source.probeBody), known(source.boardBody), source.camera.tracking);
  if (probe_) probe_->setCalibration(calibrationOf(settings.id));
}

void Trackers::solveLens(const std::string& id, const std::vector<CharucoView>& views, const CharucoBoard& board, int width, int height,
                         LensFound found) {
  auto made = std::make_shared<std::optional<CameraCalibration>>();
  jobs_.start(
      tr("Measuring the lens"),
      [=](Progress& progress) -> Result<void> {
        auto solved = calibrateCamera(views, board, width, height, progress);
        if (!solved) return passOn(solved.error());
        *made = std::move(*solved);
        return {};
      },
      [this, id, made, found = std::move(found)](const Result<void>& outcome) {
        if (!outcome) return found(passOn(outcome.error()));
        if ((*made)->quality != CameraCalibration::Quality::bad)
          changeCamera(id, [&](CameraSettings& camera) {
            camera.model = (*made)->model;
            camera.model->camera = camera.device;
          });
        found(**made);
      });
}

}  // namespace ew::ui
