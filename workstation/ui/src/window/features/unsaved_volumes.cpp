#include "window/features/unsaved_volumes.h"

#include <QAction>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>
#include <filesystem>

#include "ew/core/progress.h"
#include "ew/core/volume.h"
#include "ew/io/volume_file.h"
#include "ew/library/placing.h"
#include "ew/library/voxel_source.h"
#include "ew/sdk/host.h"
#include "ew/widgets/question.h"
#include "ew/widgets/save_file.h"
#include "ew/widgets/words.h"
#include "window/features/opening.h"
#include "window/frame/commands.h"
#include "window/frame/window_parts.h"

namespace ew::ui {
namespace {

const QString kSavingVolume = QStringLiteral("save volume");  ///< topic of messages: of two only the later one is true

/// Coverage has a file of its own; without it a reopened volume would count every voxel as measured.
QString coverageBeside(const QString& file) {
  return QFileInfo(file).path() + QLatin1Char('/') + QFileInfo(file).completeBaseName() + QStringLiteral("-coverage.mha");
}

/// Never the name of a file it was made from: "sweep.igs.mha" gives "sweep-volume.mha". A title that is no file's name stays.
QString nameForVolumeOf(const QString& title) {
  QString stem = QFileInfo(title).fileName();
  for (const char* ending : {".gz",  ".mha", ".mhd", ".nrrd", ".nhdr", ".nii", ".igs", ".seq", ".dcm", ".vol",  ".v00", ".raw", ".png",
                             ".jpg", ".pgm", ".tif", ".tiff", ".avi",  ".mp4", ".mov", ".mkv", ".mpg", ".mpeg", ".wmv", ".ts",  ".webm"})
    if (const QLatin1String known(ending); stem.size() > known.size() && stem.endsWith(known, Qt::CaseInsensitive)) stem.chop(known.size());
  return stem + (stem == QFileInfo(title).fileName() ? QStringLiteral(".mha") : QStringLiteral("-volume.mha"));
}

/// Writes a volume and which voxels of it were measured, both or neither.
Result<void> writeWithCoverage(const Volume& volume, const QString& file, Progress& progress) {
  const bool covered = !volume.coverage.empty();
  const std::filesystem::path target = pathOf(file), beside = pathOf(coverageBeside(file));
  std::vector<std::filesystem::path> files{target};
  if (covered) files.push_back(beside);
  return saveTogether(files, [&](const OutputSet& outputs) -> Result<void> {
    PartOfProgress first(progress, 0.0, covered ? 0.5 : 1.0);
    if (auto written = writeVolume(volume, outputs.staged(target), first); !written || !covered) return written;
    PartOfProgress second(progress, 0.5, 1.0);
    return writeCoverage(volume, outputs.staged(beside), second);
  });
}

/// Where a file has a volume that was placed elsewhere in the body. @return empty: not saved
std::optional<bool> askWhetherPlaced(QWidget* parent) {
  // Either answer surprises someone: a volume moved here for looking must not lose its place beside others of its recording, and one
  // placed with care must not jump back.
  QMessageBox question(parent);
  question.setObjectName(QStringLiteral("volumePlace"));
  question.setWindowTitle(UnsavedVolumes::tr("Save the volume"));
  question.setText(
      UnsavedVolumes::tr("The volume lies elsewhere in the body than its own coordinates say. Which place should the file hold?"));
  question.setInformativeText(UnsavedVolumes::tr("Its own coordinates keep it in place beside other volumes of the same recording."));
  QPushButton* own = question.addButton(UnsavedVolumes::tr("Its own coordinates"), QMessageBox::AcceptRole);
  QPushButton* body = question.addButton(UnsavedVolumes::tr("Its place in the body"), QMessageBox::AcceptRole);
  own->setObjectName(QStringLiteral("ownPlace"));
  body->setObjectName(QStringLiteral("bodyPlace"));
  question.addButton(QMessageBox::Cancel);
  question.setDefaultButton(own);
  question.exec();
  if (question.clickedButton() != own && question.clickedButton() != body) return std::nullopt;
  return question.clickedButton() == body;
}

}  // namespace

void UnsavedVolumes::addSaveAction(QMenu& file) {
  save_ = parts_.commands->add(file, "save.volume", [this] { saveShown(); });
}

void UnsavedVolumes::addViewActions(QMenu& view) {
  ofCase_ = parts_.commands->add(view, "volume.ofCase", [this] { parts_.opener->showCaseVolume(); });
  made_ = parts_.commands->add(view, "volume.made", [this] { showWaiting(); });
}

void UnsavedVolumes::connectParts() {
  WindowParts& p = parts_;
  p.host->setShownVolume([this] { return shownForPlugins(); });
  connect(p.host, &WorkstationHost::volumeKept, this, [this](const std::shared_ptr<const Volume>& volume) {
    forget(volume);
    keep();  // a crash must not offer again what a plugin has saved
    parts_.refresh();
  });
  connect(p.host, &WorkstationHost::volumeShown, this,
          [this](const std::shared_ptr<const Volume>& volume, const QString& title, const std::vector<std::filesystem::path>& madeFrom) {
            const auto mayShow = [this, title] {
              if (!parts_.opening->mayReplaceScan(title)) return false;
              parts_.pages->setCurrentWidget(parts_.workspacePage);
              return true;
            };
            parts_.opener->openVolume(volume, title, mayShow, madeFrom);
          });
}

void UnsavedVolumes::refresh() {
  save_->setEnabled(parts_.session.subject().has_value());
  const UnsavedVolume* next = waiting();
  made_->setVisible(next != nullptr);
  if (next != nullptr) made_->setText(tr("Show the volume made from %1").arg(next->title));
  ofCase_->setVisible(parts_.document.current() && !parts_.opener->showsCase() && parts_.opener->hasCaseVolume());
}

void UnsavedVolumes::holdUnsavedWork(UnsavedWork& list) {
  list.add({"volume",
            {Loss::scan, Loss::opening, Loss::closing},
            [this] { return !all_.empty(); },
            [this](Loss loss, const std::string& next) { return mayLeave(loss, words(next)); }});
}

const UnsavedVolume* UnsavedVolumes::shown() const {
  const auto& subject = parts_.session.subject();
  const auto found = std::find_if(all_.begin(), all_.end(),
                                  [&](const UnsavedVolume& made) { return subject && made.voxels.volume() == subject->voxels.volume(); });
  return found == all_.end() ? nullptr : &*found;
}

std::optional<sdk::DisplayVolume> UnsavedVolumes::shownForPlugins() const {
  const auto& subject = parts_.session.subject();
  if (!subject || parts_.opener->showsCase() || !subject->voxels.volume()) return std::nullopt;
  sdk::DisplayVolume shown{subject->voxels.volume(), subject->title, {}};
  if (!subject->provenance) return shown;
  std::vector<TrackedFrame> frames;
  for (const FrameProvenance& each : subject->provenance->frames) frames.push_back({{}, each.imageToWorld, {}});
  if (const auto axes = sweepAxesOf(frames)) shown.depthAndLateral = {axes->depth, axes->lateral};
  return shown;
}

void UnsavedVolumes::forgetShown() {
  if (const UnsavedVolume* made = shown()) all_.erase(all_.begin() + (made - all_.data()));
  keep();
}

void UnsavedVolumes::take(const UnsavedVolume& made) {
  // Whatever is answered, a volume that took minutes is not lost by it.
  all_.push_back(made);
  keep();
  if (parts_.opening->mayReplaceShown(made.title)) return show(made);
  parts_.messages->showNote(saysKept(made));
  parts_.refresh();
}

void UnsavedVolumes::takeImported(const UnsavedVolume& imported) {
  // Shown it is as good as in its file; what waits took answers that nobody wants to give again.
  if (parts_.opening->mayReplaceShown(imported.title)) return show(imported);
  all_.push_back(imported);
  keep();
  parts_.messages->showNote(saysKept(imported));
  parts_.refresh();
}

std::shared_ptr<const Volume> UnsavedVolumes::takeLeft(const std::vector<UnsavedVolume>& left, const UnsavedVolume* shownBefore) {
  all_.insert(all_.end(), left.begin(), left.end());
  keep();
  if (shownBefore != nullptr && parts_.opening->mayReplaceShown(shownBefore->title)) show(*shownBefore);
  parts_.refresh();
  return shownBefore != nullptr ? shownBefore->voxels.volume() : nullptr;
}

QString UnsavedVolumes::saysKept(const UnsavedVolume& made) {
  return tr("The volume made from %1 is kept: View, Show the volume made from %1.").arg(made.title);
}

void UnsavedVolumes::show(const UnsavedVolume& made) {
  parts_.document.close();
  parts_.opener->showVolume(made.voxels, made.title, false, made.provenance, {pathOf(made.path)});
  keep();
  Q_EMIT parts_.opener->opened(made.path);
}

const UnsavedVolume* UnsavedVolumes::waiting() const {
  const UnsavedVolume* inSight = shown();
  for (const UnsavedVolume& made : all_)
    if (&made != inSight) return &made;
  return nullptr;
}

void UnsavedVolumes::showWaiting() {
  const UnsavedVolume* next = waiting();
  if (next == nullptr) return;
  const UnsavedVolume made = *next;
  if (parts_.opening->mayReplaceShown(made.title)) show(made);
}

void UnsavedVolumes::keep() {
  std::vector<WorkAutosave::SessionVolume> made;
  const UnsavedVolume* inSight = shown();
  for (const UnsavedVolume& each : all_) made.push_back({each.path, each.title, each.voxels.volume(), &each == inSight});
  parts_.autosave.setVolumes(made);
}

void UnsavedVolumes::forget(const std::shared_ptr<const Volume>& volume) {
  all_.erase(std::remove_if(all_.begin(), all_.end(), [&](const UnsavedVolume& each) { return each.voxels.volume() == volume; }),
             all_.end());
}

void UnsavedVolumes::saveShown() {
  const auto& subject = parts_.session.subject();
  if (subject) save({{}, words(subject->title), subject->voxels, nullptr});
}

bool UnsavedVolumes::save(const UnsavedVolume& made) {
  std::optional<Grid> there;
  const auto& subject = parts_.session.subject();
  const std::shared_ptr<const Volume> volume = made.voxels.volume();
  if (subject && subject->voxels.volume() == volume && !(subject->placedGrid == volume->grid)) {
    const auto isPlaced = askWhetherPlaced(&parts_.window);
    if (!isPlaced) return false;
    if (*isPlaced) there = subject->placedGrid;
  }
  const bool covered = !volume->coverage.empty();
  const QString file = askSaveFile(&parts_.window, {tr("Save the volume"),
                                                    nameForVolumeOf(made.title),
                                                    tr("MetaImage (*.mha *.mhd)"),
                                                    {QStringLiteral(".mha"), QStringLiteral(".mhd")},
                                                    [covered](const QString& chosen) {
                                                      return covered ? QStringList{chosen, coverageBeside(chosen)} : QStringList{chosen};
                                                    }});
  if (file.isEmpty()) return false;
  const QString beside = coverageBeside(file);
  parts_.jobs.start(
      tr("Saving %1").arg(QFileInfo(file).fileName()),
      [volume, there, file](Progress& progress) -> Result<void> {
        if (!there) return writeWithCoverage(*volume, file, progress);
        Volume moved = *volume;
        moved.grid = *there;
        return writeWithCoverage(moved, file, progress);
      },
      [this, volume, file, beside, covered](const Result<void>& outcome) {
        if (outcome) {
          forget(volume);
          keep();
          parts_.messages->showNote(
              covered ? tr("Saved to %1, and which voxels were measured to %2.").arg(file, beside) : tr("Saved to %1.").arg(file),
              kSavingVolume);
          parts_.refresh();
        } else if (outcome.error().code != ErrorCode::cancelled) {
          parts_.messages->showError(outcome.error(), kSavingVolume);
        }
      },
      Jobs::Kind::saving);
  return true;
}

bool UnsavedVolumes::mayLeave(Loss loss, const QString& next) {
  if (loss != Loss::closing) {
    const UnsavedVolume* inSight = shown();
    return inSight == nullptr || mayLeave(UnsavedVolume(*inSight), next);
  }
  const std::vector<UnsavedVolume> present = all_;
  return std::all_of(present.begin(), present.end(), [&](const UnsavedVolume& each) { return mayLeave(each, next); });
}

bool UnsavedVolumes::mayLeave(const UnsavedVolume& made, const QString& next) {
  const auto answer = askBeforeLeaving(&parts_.window,
                                       {"unsavedVolumeQuestion", tr("The volume made from '%1' is not saved.").arg(made.title),
                                        tr("Making it again takes as long as it did.")},
                                       next);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save(made) && parts_.isSavedNow());
}

}  // namespace ew::ui
