#include "window/features/cine.h"

#include <QAction>
#include <QFileInfo>
#include <QMenu>
#include <cstddef>
#include <filesystem>
#include <utility>

#include "ew/core/ending.h"
#include "ew/export/dicom_study.h"
#include "ew/export/examination_files.h"
#include "ew/scanning/display_image_file.h"
#include "ew/scanning/recording.h"
#include "ew/scanning/replay.h"
#include "ew/widgets/save_file.h"
#include "ew/widgets/words.h"
#include "window/features/recording.h"
#include "window/features/storing.h"
#include "window/frame/commands.h"
#include "window/frame/window_parts.h"

namespace ew::ui {
namespace {

namespace fs = std::filesystem;

constexpr double kClipRate_hz = 25.0;

/// Forms every image of a clip again and writes it: at even times into a film, or with its own time into a DICOM object.
Result<void> writeClipFile(const ScanRecording& clip, ScanSubject subject, const DicomStudy& study, const fs::path& file,
                           Progress& progress) {
  Replay replay(clip.log, std::move(subject), 1);
  const auto stopped = [] { return failure(ErrorCode::cancelled, say<"Stopped as asked; nothing was written.">()); };
  std::vector<std::size_t> frames;
  if (hasEnding(file, ".dcm")) {
    for (std::size_t n = 0; n < clip.log.frameCount(); ++n) frames.push_back(n);
    const auto make = [&](std::size_t n) -> Result<std::pair<DisplayImage, DisplayGeometry>> {
      if (progress.cancelRequested()) return stopped();
      const DisplayImage image = replay.make(frames[n], clip.size_px.x, clip.size_px.y);
      return std::pair(image, replay.scanner().geometry());
    };
    auto written = writeDicomScan(clip.log, frames, make, study, file, progress);
    return written ? Result<void>() : passOn(written.error());
  }
  const double begin_s = clip.log.frameTime_s(0), length_s = clip.log.frameTime_s(clip.log.frameCount() - 1) - begin_s;
  for (int n = 0; n <= static_cast<int>(length_s * kClipRate_hz); ++n) frames.push_back(clip.log.frameAt(begin_s + n / kClipRate_hz));
  auto film = ImageClip::open(file, clip.size_px.x, clip.size_px.y, kClipRate_hz);
  if (!film) return passOn(film.error());
  for (std::size_t n = 0; n < frames.size(); ++n) {
    // What is not shown is formed all the same: it shows in what follows.
    for (std::size_t frame = n == 0 ? 0 : frames[n - 1] + 1; frame < frames[n]; ++frame) replay.make(frame, clip.size_px.x, clip.size_px.y);
    if (progress.cancelRequested()) return stopped();
    if (auto added = film->add(replay.make(frames[n], clip.size_px.x, clip.size_px.y)); !added) return added;
    progress.report(say<"Making images">(), static_cast<double>(n + 1) / static_cast<double>(frames.size()));
  }
  return film->finish();
}

}  // namespace

void Cine::addFreezeAction(QMenu& scan) {
  freeze_ = parts_.commands->add(scan, "freeze", [this] {
    ReplayBar& replay = *parts_.replayBar;
    if (!replay.recording()) return parts_.session.setFrozen(!parts_.session.isFrozen());
    replay.setPlaying(!replay.isPlaying());
    freeze_->setChecked(false);
  });
  freeze_->setCheckable(true);
}

void Cine::addMenu(QMenu& cine) {
  Commands& commands = *parts_.commands;
  CineBar& bar = *parts_.cineBar;
  ofLoop_ = {
      commands.add(cine, "cine.play", [&bar] { bar.setPlaying(!bar.isPlaying()); }),
      commands.add(cine, "cine.back", [&bar] { bar.step(-1); }),
      commands.add(cine, "cine.on", [&bar] { bar.step(1); }),
      commands.add(cine, "cine.in", [&bar] { bar.markIn(); }),
      commands.add(cine, "cine.out", [&bar] { bar.markOut(); }),
      commands.add(cine, "cine.save", [this] { saveClip(); }),
  };
}

void Cine::connectParts() {
  WindowParts& p = parts_;
  connect(&p.session, &Session::frozenChanged, this, [this](bool frozen) { freeze_->setChecked(frozen); });
  connect(&p.session.console(), &ScanConsole::changeRefused, this, &Cine::sayWhyRefused);
  connect(p.cineBar, &CineBar::openChanged, this, &Cine::showState);
  connect(p.cineBar, &CineBar::saveAsked, this, &Cine::saveClip);
  showState();
}

void Cine::showState() {
  const bool isOpen = parts_.cineBar->isOpen();
  parts_.status->setCineShown(isOpen);
  for (QAction* action : ofLoop_) action->setEnabled(isOpen);
  for (QAction* action : ofRunningScan_) action->setEnabled(!isOpen);
  parts_.commands->showKeys();
}

void Cine::saveClip() {
  WindowParts& p = parts_;
  const auto clip = p.cineBar->clip(p.recording->caseId());
  if (!clip || !p.session.subject()) return;
  const QString file =
      askSaveFile(&p.window, dated({tr("Save the clip"),
                                    words(p.session.subject()->title) + QLatin1Char(' ') + tr("clip") + QStringLiteral(".seq.mha"),
                                    tr("Scan to look at again (*.seq.mha);;Films (*.mp4 *.avi);;DICOM clips (*.dcm)"),
                                    {QStringLiteral(".seq.mha"), QStringLiteral(".mha"), QStringLiteral(".mp4"), QStringLiteral(".avi"),
                                     QStringLiteral(".dcm")}}));
  if (file.isEmpty()) return;
  if (hasEnding(pathOf(file), ".mha")) return void(p.recording->startSaving(clip, file, [] {}));
  p.jobs.start(
      tr("Saving %1").arg(QFileInfo(file).fileName()),
      [clip, subject = *p.session.subject(), study = p.storing->studyNow(), file](Progress& progress) {
        return saveTogether({pathOf(file)}, [&](const OutputSet& outputs) {
          return writeClipFile(*clip, subject, study, outputs.staged(pathOf(file)), progress);
        });
      },
      [this, file](const Result<void>& outcome) {
        if (outcome)
          parts_.messages->showNote(tr("Saved to %1.").arg(file), kStoringTopic);
        else if (outcome.error().code != ErrorCode::cancelled)
          parts_.messages->showError(outcome.error(), kStoringTopic);
      },
      Jobs::Kind::saving);
}

void Cine::sayWhyRefused() {
  WindowParts& p = parts_;
  const QString freeze = p.keys.words("freeze");
  p.scanView->say(p.session.wide() != nullptr
                      ? tr("The wide image is frozen, and made of images that are done: it can be magnified, measured and saved. "
                           "%1 ends it.")
                            .arg(freeze)
                      : tr("The image is frozen, and this needs new echoes: %1 lets it run. Grey map, dynamic range, zoom and "
                           "inversion can be changed now.")
                            .arg(freeze));
}

}  // namespace ew::ui
