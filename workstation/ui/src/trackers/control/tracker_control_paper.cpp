// Cameras and the paper they look for: bodies, sheets, the lens.
#include <QLocale>
#include <algorithm>

#include "ew/library/case.h"
#include "ew/trackers/marker_sheet.h"
#include "jobs/jobs.h"
#include "trackers/control/tracker_control.h"
#include "widgets/words.h"

namespace ew::ui {
namespace {

constexpr double kPrintedScale_mm = 100.0;

const CameraSource* cameraSourceOf(const TrackerSettings* settings) {
  return settings != nullptr ? std::get_if<CameraSource>(&settings->source) : nullptr;
}

}  // namespace

void Trackers::readPapers() {
  std::vector<std::filesystem::path> folders;
  if (const auto resources = resourceFolder()) folders.push_back(*resources / "marker_bodies");
  folders.push_back(libraryFolder() / "trackers" / "bodies");
  auto read = readPaperBodies(folders);
  paperProblem_ = read ? Message() : read.error().message;
  papers_ = read ? std::move(*read) : std::vector<PaperBody>{};
  if (read && papers_.empty()) paperProblem_ = say<"No paper body is installed; install EchoWeave again.">();
}

double Trackers::measuredScale_mm() const { return readPrintedScale(libraryFolder() / "trackers").value_or(kPrintedScale_mm); }

double Trackers::printedFactorNow() const { return printedFactor(measuredScale_mm()).value_or(1.0); }

void Trackers::setMeasuredScale(double mm) {
  if (const auto kept = keepPrintedScale(libraryFolder() / "trackers", mm); !kept) Q_EMIT problem(kept.error());
  const TrackerSettings* settings = find(used_);
  if (settings != nullptr && camera_) applyCamera(*settings, *cameraOf(used_));
}

std::vector<MarkerBody> Trackers::bodies() const {
  std::vector<MarkerBody> made;
  const double factor = printedFactorNow();
  for (const PaperBody& each : papers_)
    if (each.kind != PaperKind::calibration) made.push_back(foldedBody(each, factor));
  return made;
}

MarkerBody Trackers::bodyCalled(const std::string& body) const {
  for (MarkerBody& each : bodies())
    if (each.id == body) return each;
  return {};
}

bool Trackers::needsFace(const std::string& id) const { return cameraOf(id) == nullptr || !bodyCalled(bodyOf(id)).faceIsExact; }

CharucoBoard Trackers::charucoBoard() const {
  const auto paper =
      std::find_if(papers_.begin(), papers_.end(), [](const PaperBody& each) { return each.kind == PaperKind::calibration; });
  if (paper == papers_.end()) return {};
  const CalibrationBoard printed = printedBoard(*paper, printedFactorNow());
  return {printed.columns, printed.rows, printed.square_mm, printed.marker_mm, printed.dictionary};
}

Result<void> Trackers::writeSheet(const std::filesystem::path& file, const std::string& body, bool isLetter) const {
  std::vector<PaperBody> wanted;
  for (const PaperBody& each : papers_)
    if (each.id == body || each.kind != PaperKind::held) wanted.push_back(each);
  return writeMarkerSheet(
      wanted, isLetter ? PaperSize::letter : PaperSize::a4, file, [](const Message& text) { return words(text).toStdString(); },
      QLocale().language() == QLocale::German ? "de" : "en");
}

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
    return body.empty() || bodyCalled(body).id.empty() ? std::nullopt : std::optional(bodyCalled(body));
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
