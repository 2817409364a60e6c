// Images kept of an examination, and how they leave: as DICOM files and to an archive.
#include <QDateTime>
#include <QFileDialog>
#include <QFileInfo>
#include <chrono>

#include "ew/core/ending.h"
#include "ew/export/outbox.h"
#include "ew/scanning/picture_file.h"
#include "ew/scanning/replay.h"
#include "ew/sdk/person.h"
#include "images/examination_dialog.h"
#include "widgets/save_file.h"
#include "widgets/words.h"
#include "window/main_window_parts.h"

namespace ew::ui {
namespace {

namespace fs = std::filesystem;

const auto kStoring = QStringLiteral("storing");
const auto kSending = QStringLiteral("sending");
constexpr int kRounds = 3;  // while somebody waits; what is left is sent the next time
constexpr double kClipRate_hz = 25.0;

fs::path outboxFolder() { return ownCasesFolder().parent_path() / "outbox"; }

std::chrono::sys_seconds secondsNow() { return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()); }

/// Where the outbox stands: "3 objects wait". Empty: nothing waits, or somebody else has it.
QString waitingIn(const fs::path& folder) {
  std::error_code failed;
  if (!fs::exists(folder, failed)) return {};
  const auto outbox = Outbox::open(folder);
  if (!outbox) return words(outbox.error());
  const auto waiting = static_cast<int>(outbox->count(OutboxStatus::waiting) + outbox->count(OutboxStatus::stored));
  const auto refused = static_cast<int>(outbox->count(OutboxStatus::refused));
  QString sentence;
  if (waiting > 0) sentence = MainWindow::tr("Waiting in the outbox, sent with what comes next: %1.").arg(waiting);
  if (refused == 0) return sentence;
  for (const OutboxEntry& entry : outbox->entries())
    if (entry.status == OutboxStatus::refused)
      return sentence + (sentence.isEmpty() ? QString() : QStringLiteral(" ")) +
             MainWindow::tr("Refused by the archive, and offered to it again: %1 (%2).")
                 .arg(QString::number(refused), words(entry.problem));
  return sentence;
}

/// Puts everything into the outbox and sends what is there. @param sent what came of it
Result<void> sendThroughOutbox(const ExaminationFiles& examination, const DicomArchive& archive, const fs::path& folder, SendResult& sent,
                               Progress& progress) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  auto outbox = Outbox::open(folder);
  if (!outbox) return passOn(outbox.error());
  const fs::path incoming = folder / "incoming";
  fs::remove_all(incoming, failed);
  if (!fs::create_directory(incoming, failed))
    return failure(ErrorCode::notWritable, say<"'%1' cannot be made; check permissions and room of the disk.">(incoming.string()));
  const auto files = writeExamination(examination, incoming, progress);
  if (files)
    for (const fs::path& file : *files)
      if (auto added = outbox->add(file); !added) return passOn(added.error());
  fs::remove_all(incoming, failed);
  if (!files) return passOn(files.error());
  if (auto again = outbox->retryRefused(); !again) return again;
  SendOptions options;
  options.mostRounds = kRounds;
  auto result = sendOutbox(*outbox, archive, options, progress);
  if (!result) return passOn(result.error());
  sent = std::move(*result);
  return {};
}

/// The worksheets as they are written now.
std::vector<measurement::Examination> filledNow(const Worksheets& worksheets) {
  std::vector<measurement::Examination> all;
  for (const measurement::Examination* each : worksheets.filled()) all.push_back(*each);
  return all;
}

/// Pictures and worksheets as they were when the job began are safe now; what came since is not.
void setSaved(StoredExamination& stored, Worksheets& worksheets, std::uint64_t revision,
              const std::vector<measurement::Examination>& sheets) {
  stored.setSaved(revision);
  std::vector<const measurement::Examination*> written;
  for (const measurement::Examination& each : sheets) written.push_back(&each);
  worksheets.setSaved(written);
}

/// Forms every image of a clip again and writes it: at even times into a film, or with its own time into a DICOM object.
Result<void> writeClipFile(const ScanRecording& clip, ScanSubject subject, const DicomStudy& study, const fs::path& file,
                           Progress& progress) {
  Replay replay(clip.log, std::move(subject), 1);
  const auto stopped = [] { return failure(ErrorCode::cancelled, say<"Stopped as asked; nothing was written.">()); };
  std::vector<std::size_t> frames;
  if (hasEnding(file, ".dcm")) {
    for (std::size_t n = 0; n < clip.log.frameCount(); ++n) frames.push_back(n);
    const auto make = [&](std::size_t n) -> Result<std::pair<Picture, DisplayGeometry>> {
      if (progress.cancelRequested()) return stopped();
      const Picture picture = replay.make(frames[n], clip.size_px.x, clip.size_px.y);
      return std::pair(picture, replay.scanner().geometry());
    };
    auto written = writeDicomScan(clip.log, frames, make, study, file, progress);
    return written ? Result<void>() : passOn(written.error());
  }
  const double begin_s = clip.log.frameTime_s(0), length_s = clip.log.frameTime_s(clip.log.frameCount() - 1) - begin_s;
  for (int n = 0; n <= static_cast<int>(length_s * kClipRate_hz); ++n) frames.push_back(clip.log.frameAt(begin_s + n / kClipRate_hz));
  auto film = PictureClip::open(file, clip.size_px.x, clip.size_px.y, kClipRate_hz);
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

void MainWindow::addStoringMenu(QMenu& file) {
  Parts& p = *parts_;
  p.storeAction = addMenuAction(file, "picture.store", [this] { storePicture(); });
  addMenuAction(file, "examination", [this] { showExamination(); });
}

void MainWindow::followPatient() {
  Parts& p = *parts_;
  if (!p.session.subject()) return;
  const std::string person = sdk::personWhoLearns();
  if (person != p.storesFor) {
    if (p.stored.atRiskCount() > 0) return;  // whoever stores the next one is asked about them
    p.stored.clear();
    p.storesFor = person;
  }
  const std::string scanned = recordedCase();
  // While the patient is the same the images stay together: what the case holds by now, or where it was saved, does not part them. A case
  // that has another id is opened again as that, so that its images are kept there as well.
  if (scanned.empty() && !p.stored.folder().empty()) return;
  const QString& file = p.autosave.path();
  const std::string patient = !scanned.empty()  ? "case " + scanned
                              : !file.isEmpty() ? "file " + QFileInfo(file).absoluteFilePath().toStdString()
                                                : std::string();
  if (!patient.empty()) p.stored.keepIn(ImageStore::folderOf(libraryFolder(), patient, person));
}

DicomStudy MainWindow::studyNow() const {
  const auto& opened = parts_->document.current();
  if (opened && parts_->opener->showsCase()) return beginStudy(*opened, secondsNow());
  const auto& subject = parts_->session.subject();
  return beginStudy(subject ? words(subject->title).toStdString() : std::string(), secondsNow());
}

void MainWindow::storePicture() {
  Parts& p = *parts_;
  if (p.pages->currentWidget() != p.workspacePage || !p.keepsScan()) return;
  // Somebody else may have begun to learn here.
  if (p.stored.atRiskCount() > 0 && p.storesFor != sdk::personWhoLearns()) {
    if (!mayLeaveStored({})) return;
    p.stored.clear();
  }
  followPatient();
  if (!p.stored.store(shownParts(), pictureColumns(), studyNow(), QDateTime::currentDateTime())) return;
  p.scanView->say(tr("Image %1 is stored.").arg(p.stored.items().size()));
}

void MainWindow::showExamination() {
  Parts& p = *parts_;
  if (p.examination.isNull()) {
    p.examination = new ExaminationDialog(p.stored, p.worksheets, p.jobs, this);
    p.examination->setAttribute(Qt::WA_DeleteOnClose);
    connect(p.examination, &ExaminationDialog::saveAsked, this, &MainWindow::saveExamination);
    connect(p.examination, &ExaminationDialog::sendAsked, this, &MainWindow::sendExamination);
  }
  p.examination->setSending(p.isSending);
  if (!p.isSending) p.examination->setWaiting(waitingIn(outboxFolder()));
  p.examination->show();
  p.examination->raise();
  p.examination->activateWindow();
}

bool MainWindow::saveExamination() {
  Parts& p = *parts_;
  const QDateTime now = QDateTime::currentDateTime();
  const QString inside = QFileDialog::getExistingDirectory(this, tr("Folder in which the examination gets a folder of its own"));
  if (inside.isEmpty()) return false;
  const fs::path folder = pathOf(inside) / ("examination-" + now.toString(QStringLiteral("yyyyMMdd-HHmmss")).toStdString());
  p.jobs.start(
      tr("Saving the examination"),
      [files = p.stored.files(studyNow(), now), folder](Progress& progress) -> Result<void> {
        OutputSet outputs;
        if (auto announced = outputs.announceNewFolder(folder); !announced) return announced;
        if (auto written = writeExamination(files, outputs.staged(folder), progress); !written) return passOn(written.error());
        return outputs.commit();
      },
      [this, folder, revision = p.stored.revision(), sheets = filledNow(p.worksheets)](const Result<void>& outcome) {
        if (outcome) {
          setSaved(parts_->stored, parts_->worksheets, revision, sheets);
          parts_->messages->showNote(tr("Saved to %1.").arg(wordsOf(folder)), kStoring);
        } else if (outcome.error().code != ErrorCode::cancelled) {
          parts_->messages->showError(outcome.error(), kStoring);
        }
      },
      Jobs::Kind::saving);
  return true;
}

void MainWindow::sendExamination() {
  Parts& p = *parts_;
  if (p.isSending || p.examination.isNull()) return;
  const DicomArchive archive = p.examination->archive();
  auto sent = std::make_shared<SendResult>();
  p.isSending = true;
  p.examination->setSending(true);
  p.jobs.start(
      tr("Sending to %1").arg(words(archive.aeTitle)),
      [files = p.stored.files(studyNow(), QDateTime::currentDateTime()), archive, sent](Progress& progress) {
        return sendThroughOutbox(files, archive, outboxFolder(), *sent, progress);
      },
      [this, sent, archive, revision = p.stored.revision(), sheets = filledNow(p.worksheets)](const Result<void>& outcome) {
        Parts& parts = *parts_;
        parts.isSending = false;
        // What is in the outbox is lost no more, whether the archive has it or not.
        if (outcome) setSaved(parts.stored, parts.worksheets, revision, sheets);
        if (!outcome) {
          parts.messages->showError(outcome.error(), kSending);
        } else if (sent->left == 0 && sent->refused == 0) {
          parts.messages->showNote(
              sent->accepted > 0
                  ? tr("The archive %1 said that it stored everything (%2); it cannot be asked what it has, so this counts as delivered.")
                        .arg(words(archive.aeTitle), QString::number(sent->accepted + sent->verified))
              : sent->verified == 0
                  ? tr("The archive %1 has everything already.").arg(words(archive.aeTitle))
                  : tr("The archive %1 has everything now; new to it: %2.").arg(words(archive.aeTitle), QString::number(sent->verified)),
              kSending);
        } else {
          parts.messages->showError(tr("Not in the archive yet, but safe in the outbox: %1. %2")
                                        .arg(QString::number(sent->left + sent->refused), words(sent->problem)),
                                    kSending);
        }
        if (parts.examination.isNull()) return;
        parts.examination->setSending(false);
        parts.examination->setWaiting(waitingIn(outboxFolder()));
      });
}

void MainWindow::saveClip() {
  Parts& p = *parts_;
  const auto clip = p.cineBar->clip(recordedCase());
  if (!clip || !p.session.subject()) return;
  const QString file = askSaveFile(
      this, {tr("Save the clip"),
             tr("clip") + QStringLiteral(".seq.mha"),
             tr("Scan to look at again (*.seq.mha);;Films (*.mp4 *.avi);;DICOM clips (*.dcm)"),
             {QStringLiteral(".seq.mha"), QStringLiteral(".mha"), QStringLiteral(".mp4"), QStringLiteral(".avi"), QStringLiteral(".dcm")}});
  if (file.isEmpty()) return;
  if (hasEnding(pathOf(file), ".mha")) return void(startSavingRecording(clip, file, [] {}));
  p.jobs.start(
      tr("Saving %1").arg(QFileInfo(file).fileName()),
      [clip, subject = *p.session.subject(), study = studyNow(), file](Progress& progress) {
        return saveTogether({pathOf(file)}, [&](const OutputSet& outputs) {
          return writeClipFile(*clip, subject, study, outputs.staged(pathOf(file)), progress);
        });
      },
      [this, file](const Result<void>& outcome) {
        if (outcome)
          parts_->messages->showNote(tr("Saved to %1.").arg(file), kStoring);
        else if (outcome.error().code != ErrorCode::cancelled)
          parts_->messages->showError(outcome.error(), kStoring);
      },
      Jobs::Kind::saving);
}

}  // namespace ew::ui
