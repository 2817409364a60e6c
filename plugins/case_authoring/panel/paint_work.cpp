#include "panel/paint_work.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPointer>
#include <QStandardPaths>

#include "ew/library/content_name.h"
#include "ew/sdk/window.h"
#include "ew/widgets/words.h"
#include "logic/targets.h"
#include "logic/until_told.h"

namespace ew::case_authoring {
namespace {

constexpr int kKeepAfter_ms = 1000;

std::filesystem::path rootOfKept() {
  return std::filesystem::path(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation).toStdString()) / "echoweave" /
         "unsaved-labels";
}

}  // namespace

PaintWork::PaintWork(sdk::Host& host, QObject* parent) : QObject(parent), host_(host), aside_(newAside()) {
  keepSoon_.setSingleShot(true);
  keepSoon_.setInterval(kKeepAfter_ms);
  connect(&keepSoon_, &QTimer::timeout, this, &PaintWork::keepAside);
  closing_ = host_.window().onClosing(
      [this] { return hasUnkept() ? tr("What was painted is not kept in the case yet.").toStdString() : std::string(); });
  const auto tryAgain = [this] {
    keepUnkept();
    return true;
  };
  holding_ = host_.window().holdUnsaved({[this] { return closingSentence().toStdString(); }, tryAgain});
}

PaintWork::~PaintWork() { aside_->forget(); }

KeepingAside::Start PaintWork::starting(bool isSaving) const {
  return [&host = host_, isSaving](KeepingAside::Work work, KeepingAside::Done done) {
    const std::string title = tr("Keeping what is painted").toStdString();
    if (isSaving)
      host.jobs().startSaving(title, std::move(work), std::move(done));
    else
      host.jobs().start(title, std::move(work), std::move(done));
  };
}

std::shared_ptr<KeepingAside> PaintWork::newAside() const { return std::make_shared<KeepingAside>(rootOfKept(), starting(false)); }

void PaintWork::say(const QString& sentence) const {
  if (onSaid) onSaid(sentence);
}
void PaintWork::say(const Error& error) const {
  if (error.code == ErrorCode::cancelled) return say(QString());
  host_.log().warn(error.sentence());
  say(words(error.message));
}

std::optional<Transform<frame::World, frame::File>> PaintWork::fileToWorld() const {
  const auto opened = host_.cases().current();
  return opened ? std::optional(opened->volume.fileToWorld) : std::nullopt;
}

std::optional<Transform<frame::File, frame::Probe>> PaintWork::planeToFile() const {
  const auto image = host_.scan().state();
  const auto place = fileToWorld();
  if (!image || !place || !host_.cases().scan()) return std::nullopt;
  return rigidInverse(*place) * image->pose.probeToWorld;
}

bool PaintWork::begin() {
  if (painting_) return true;
  const auto scanned = host_.scan().scanned();
  const auto place = fileToWorld();
  if (!scanned || !place || !host_.cases().scan()) {
    say(tr("The volume of this case is not what is scanned at the moment; choose View, Scan the case's volume."));
    return false;
  }
  auto begun = Painting::begin(*scanned, *place);
  if (!begun) {
    say(begun.error());
    return false;
  }
  painting_ = std::move(*begun);
  voxels_ = scanned->voxels;
  rememberCase();
  return true;
}

void PaintWork::setLabel(int label) {
  if (label == label_) return;
  label_ = label;
  if (painting_) painting_->forgetTraced();
  if (label == 0) take({});
}

void PaintWork::take(const std::optional<PaintSettings>& settings) {
  const bool isOther = settings.has_value() != settings_.has_value() || (settings && !(*settings == *settings_));
  settings_ = label_ > 0 ? settings : std::nullopt;
  if (isOther || !settings_) askForStrokes();
  if (onChanged) onChanged();
}

void PaintWork::askForStrokes() {
  if (!settings_) return asking_.reset();
  const auto stopped = [this] { take({}); };
  if (settings_->tool == PaintTool::grow) {
    asking_ = host_.scan().askForPoint(
        tr("Click inside the structure; it grows from there to its edges. Escape ends.").toStdString(),
        [this](const Point<frame::Probe>& at) { grow(glm::dvec2(at.at)); }, stopped);
    return;
  }
  const bool isTrace = settings_->tool == PaintTool::trace;
  const QString hint = isTrace ? tr("Draw around the structure with the button held. The wheel still moves the probe. Escape ends.")
                       : settings_->tool == PaintTool::erase
                           ? tr("Erase with the button held. The wheel still moves the probe. Escape ends.")
                           : tr("Paint with the button held. The wheel still moves the probe. Escape ends.");
  sdk::StrokeRequest request{.hint = hint.toStdString(), .radius_mm = isTrace ? 0.0 : settings_->radius_mm};
  request.begun = [this](const Point<frame::Probe>& at) { strokeBegun(glm::dvec2(at.at)); };
  request.moved = [this](const Point<frame::Probe>& at) {
    if (!painting_ || !painting_->isDrawing()) return;
    painting_->strokeMoved(glm::dvec2(at.at));
    if (onChanged) onChanged();
  };
  request.ended = [this](const Point<frame::Probe>&) { strokeEnded(); };
  request.stopped = stopped;
  asking_ = host_.scan().askForStroke(std::move(request));
}

QString PaintWork::nameOfStroke() const {
  if (!settings_ || settings_->tool == PaintTool::paint) return tr("Paint");
  return settings_->tool == PaintTool::erase ? tr("Erase") : tr("Trace");
}

void PaintWork::strokeBegun(const glm::dvec2& at_mm) {
  const auto plane = planeToFile();
  if (isBusy_ || !settings_ || !begin() || !plane) return;
  say(QString());
  painting_->strokeBegun(*settings_, label_, nameOfStroke().toStdString(), *plane, at_mm);
  if (onChanged) onChanged();
}

void PaintWork::strokeEnded() {
  if (!painting_ || !painting_->isDrawing()) return;
  painting_->strokeEnded();
  painted();
}

/// Image and body show what is painted now; a second later it is kept aside.
void PaintWork::painted() {
  const auto place = fileToWorld();
  if (painting_ && place) {
    if (const auto shown = host_.scan().showLabels(painting_->inWorld(*place)); !shown) say(shown.error());
  }
  keepSoon_.start();
  if (onChanged) onChanged();
}

void PaintWork::cancelGrowing() {
  if (growing_) growing_->store(true);
}

void PaintWork::grow(const glm::dvec2& at_mm) {
  const auto plane = planeToFile();
  if (isBusy_ || !settings_ || !begin() || !plane) return;
  say(QString());
  isBusy_ = true;
  growing_ = std::make_shared<std::atomic<bool>>(false);
  if (onChanged) onChanged();
  auto grown = std::make_shared<Painting::Growth>();
  auto growing = painting_->growing(carried(*plane, {at_mm, 0.0}), settings_->grow, label_, settings_->onlyUnlabelled);
  host_.jobs().start(
      tr("Growing the structure").toStdString(),
      [grown, growing = std::move(growing), stop = growing_](Progress& progress) mutable -> Result<void> {
        UntilTold told(progress, *stop);
        auto made = growing(told);
        if (!made) return passOn(made.error());
        *grown = std::move(*made);
        return {};
      },
      [self = QPointer<PaintWork>(this), painting = painting_.get(), grown](const Result<void>& outcome) {
        if (!self) return;
        self->isBusy_ = false;
        self->growing_.reset();
        if (!outcome) {
          self->say(outcome.error());
        } else if (self->painting_.get() == painting && painting != nullptr) {
          self->showGrowth(grown->result);
          if (grown->result.stop == labelling::GrowStop::done) self->painting_->take(std::move(*grown), tr("Grow").toStdString());
          return self->painted();
        }
        if (self->onChanged) self->onChanged();
      });
}

void PaintWork::showGrowth(const labelling::GrowResult& result) {
  const auto ml = [](double value) { return QLocale().toString(value, 'f', 1); };
  switch (result.stop) {
    case labelling::GrowStop::done:
      return say(result.touchesReach ? tr("%1 ml grew, up to the farthest distance; it may go on beyond it.").arg(ml(result.volume_ml))
                                     : QString());
    case labelling::GrowStop::tooLarge:
      return say(
          tr("More than %1 ml are like this place, so it would have run out of the structure; nothing was labelled. Click elsewhere, "
             "allow more, or paint a border first.")
              .arg(ml(result.volume_ml)));
    case labelling::GrowStop::nothing:
      return say(tr("Nothing grows from here: the place is an edge, or no echo was recorded there. Click inside the structure."));
  }
}

QString PaintWork::undoText() const { return painting_ ? words(painting_->edits().undoText()) : QString(); }
QString PaintWork::redoText() const { return painting_ ? words(painting_->edits().redoText()) : QString(); }

void PaintWork::undo() {
  if (isBusy_ || undoText().isEmpty()) return;
  painting_->edits().undo();
  painted();
}

void PaintWork::redo() {
  if (isBusy_ || redoText().isEmpty()) return;
  painting_->edits().redo();
  painted();
}

void PaintWork::fillBetween() {
  if (isBusy_ || !painting_ || !settings_) return;
  const auto filled = painting_->fillBetween(label_, settings_->onlyUnlabelled, tr("Fill between outlines").toStdString(), noProgress());
  if (!filled) return say(filled.error());
  say(QString());
  painted();
}

void PaintWork::keepLargest() {
  if (isBusy_ || label_ == 0 || !begin()) return;
  if (const auto kept = painting_->keepLargest(label_, tr("Keep the largest piece").toStdString(), noProgress()); !kept)
    return say(kept.error());
  painted();
}

void PaintWork::smooth() {
  if (isBusy_ || label_ == 0 || !begin()) return;
  if (const auto smoothed = painting_->smooth(label_, tr("Smooth").toStdString(), noProgress()); !smoothed) return say(smoothed.error());
  painted();
}

}  // namespace ew::case_authoring
