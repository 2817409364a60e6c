#include "window/features/storing.h"

#include <QAction>
#include <QDateTime>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include "ew/core/output_set.h"
#include "ew/export/dicom_study.h"
#include "ew/export/examination_files.h"
#include "ew/export/outbox.h"
#include "ew/library/folders.h"
#include "ew/sdk/person.h"
#include "ew/widgets/question.h"
#include "ew/widgets/words.h"
#include "images/examination_dialog.h"
#include "images/saved_image.h"
#include "window/features/images.h"
#include "window/features/recording.h"
#include "window/frame/commands.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {
namespace {

namespace fs = std::filesystem;

const auto kSending = QStringLiteral("sending");
constexpr int kRounds = 3;  // while somebody waits; what is left is sent the next time

fs::path outboxFolder() { return ownCasesFolder().parent_path() / "outbox"; }

std::chrono::sys_seconds secondsNow() { return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()); }

/// Where the outbox stands: "3 objects wait". Empty: nothing waits, or somebody else has it.
QString waitingIn(const fs::path& folder) {
  std::error_code failed;
  if (!fs::exists(folder, failed)) return {};
  const auto outbox = DicomOutbox::open(folder);
  if (!outbox) return words(outbox.error());
  const auto waiting = static_cast<int>(outbox->count(OutboxStatus::waiting) + outbox->count(OutboxStatus::stored));
  const auto refused = static_cast<int>(outbox->count(OutboxStatus::refused));
  QString sentence = outbox->damage() ? words(*outbox->damage()) : QString();
  const auto gap = [&sentence] { return sentence.isEmpty() ? QString() : QStringLiteral(" "); };
  if (waiting > 0) sentence += gap() + Storing::tr("Waiting in the outbox, sent with what comes next: %1.").arg(waiting);
  if (refused == 0) return sentence;
  for (const OutboxEntry& entry : outbox->entries())
    if (entry.status == OutboxStatus::refused)
      return sentence + gap() +
             Storing::tr("Refused by the archive, and offered to it again: %1 (%2).").arg(QString::number(refused), words(entry.problem));
  return sentence;
}

/// What came of sending.
struct Sent {
  SendResult result;
  std::optional<Message> damage;  ///< of the outbox
};

/// Puts everything into the outbox and sends what is there.
Result<void> sendThroughOutbox(const ExaminationFiles& examination, const DicomArchive& archive, const fs::path& folder, Sent& sent,
                               Progress& progress) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  auto outbox = DicomOutbox::open(folder);
  if (!outbox) return passOn(outbox.error());
  sent.damage = outbox->damage();
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
  RetryOptions options;
  options.mostRounds = kRounds;
  auto result = sendOutbox(*outbox, archive, options, progress);
  if (!result) return passOn(result.error());
  sent.result = std::move(*result);
  return {};
}

/// The worksheets as they are written now.
std::vector<measurement::Examination> filledNow(const Worksheets& worksheets) {
  std::vector<measurement::Examination> all;
  for (const measurement::Examination* each : worksheets.filled()) all.push_back(*each);
  return all;
}

/// Images and worksheets as they were when the job began are safe now; what came since is not.
void setSaved(ExaminationStore& stored, Worksheets& worksheets, std::uint64_t revision,
              const std::vector<measurement::Examination>& sheets) {
  stored.setSaved(revision);
  std::vector<const measurement::Examination*> written;
  for (const measurement::Examination& each : sheets) written.push_back(&each);
  worksheets.setSaved(written);
}

}  // namespace

void Storing::addActions(QMenu& file) {
  store_ = parts_.commands->add(file, "picture.store", [this] { store(); });
  parts_.commands->add(file, "examination", [this] { showExamination(); });
}

void Storing::connectParts() {
  WindowParts& p = parts_;
  // A case whose volume was exchanged has its images again, and one whose own volume is scanned again its recordings. With changes that are
  // not saved its folder may hold another volume than what is scanned.
  connect(&p.session, &Session::patientReplaced, this, [this] { patientSoon_ = true; });
  connect(&p.session, &Session::subjectChanged, this, [this] {
    if (!std::exchange(patientSoon_, false) || !parts_.opener->showsCase()) return;
    if (const auto& current = parts_.document.current(); current && !parts_.document.hasUnsavedChanges())
      parts_.autosave.setOpen(wordsOf(current->folder));
    followPatient();
  });
  connect(&p.stored, &ExaminationStore::notKept, this,
          [this](const Error& error) { parts_.messages->showError(error, kKeepingWorkTopic); });
}

void Storing::refresh() { store_->setEnabled(parts_.session.subject().has_value()); }

void Storing::holdUnsavedWork(UnsavedWork& list) {
  list.add({"stored images",
            {Loss::scan, Loss::opening, Loss::closing},
            [this] { return parts_.stored.atRiskCount() > 0; },
            [this](Loss, const std::string& next) { return mayLeave(words(next)); }});
}

void Storing::followPatient() {
  WindowParts& p = parts_;
  if (!p.session.subject()) return;
  const std::string person = sdk::personWhoLearns();
  if (person != storesFor_) {
    if (p.stored.atRiskCount() > 0) return;  // whoever stores the next one is asked about them
    p.stored.clear();
    storesFor_ = person;
  }
  const std::string scanned = p.recording->caseId();
  // While the patient is the same the images stay together: what the case holds by now, or where it was saved, does not part them. A case
  // that has another id is opened again as that, so that its images are kept there as well.
  if (scanned.empty() && !p.stored.folder().empty()) return;
  const QString& file = p.autosave.path();
  const std::string patient = !scanned.empty()  ? "case " + scanned
                              : !file.isEmpty() ? "file " + QFileInfo(file).absoluteFilePath().toStdString()
                                                : std::string();
  if (!patient.empty()) p.stored.keepIn(ImageStore::folderOf(libraryFolder(), patient, person));
}

DicomStudy Storing::studyNow() const {
  const auto& opened = parts_.document.current();
  if (opened && parts_.opener->showsCase()) return beginStudy(*opened, secondsNow());
  const auto& subject = parts_.session.subject();
  return beginStudy(subject ? words(subject->title).toStdString() : std::string(), secondsNow());
}

void Storing::store() {
  WindowParts& p = parts_;
  if (!p.workspaces->showsScan()) return;
  // Somebody else may have begun to learn here.
  if (p.stored.atRiskCount() > 0 && storesFor_ != sdk::personWhoLearns()) {
    if (!mayLeave({})) return;
    p.stored.clear();
  }
  followPatient();
  if (!p.stored.store(p.images->shownParts(), p.images->columns(), studyNow(), QDateTime::currentDateTime())) return;
  p.scanView->say(tr("Image %1 is stored.").arg(p.stored.items().size()));
}

void Storing::showExamination() {
  WindowParts& p = parts_;
  if (dialog_.isNull()) {
    dialog_ = new ExaminationDialog(p.stored, p.worksheets, p.jobs, &p.window);
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog_, &ExaminationDialog::saveAsked, this, &Storing::save);
    connect(dialog_, &ExaminationDialog::sendAsked, this, &Storing::send);
  }
  dialog_->setSending(isSending_);
  if (!isSending_) dialog_->setWaiting(waitingIn(outboxFolder()));
  dialog_->show();
  dialog_->raise();
  dialog_->activateWindow();
}

bool Storing::save() {
  WindowParts& p = parts_;
  const QDateTime now = QDateTime::currentDateTime();
  const QString inside = QFileDialog::getExistingDirectory(&p.window, tr("Folder in which the examination gets a folder of its own"));
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
          setSaved(parts_.stored, parts_.worksheets, revision, sheets);
          parts_.messages->showNote(tr("Saved to %1.").arg(wordsOf(folder)), kStoringTopic);
        } else if (outcome.error().code != ErrorCode::cancelled) {
          parts_.messages->showError(outcome.error(), kStoringTopic);
        }
      },
      Jobs::Kind::saving);
  return true;
}

void Storing::send() {
  WindowParts& p = parts_;
  if (isSending_ || dialog_.isNull()) return;
  const DicomArchive archive = dialog_->archive();
  auto sent = std::make_shared<Sent>();
  isSending_ = true;
  dialog_->setSending(true);
  p.jobs.start(
      tr("Sending to %1").arg(words(archive.aeTitle)),
      [files = p.stored.files(studyNow(), QDateTime::currentDateTime()), archive, sent](Progress& progress) {
        return sendThroughOutbox(files, archive, outboxFolder(), *sent, progress);
      },
      [this, sent, archive, revision = p.stored.revision(), sheets = filledNow(p.worksheets)](const Result<void>& outcome) {
        WindowParts& parts = parts_;
        isSending_ = false;
        // What is in the outbox is lost no more, whether the archive has it or not.
        if (outcome) setSaved(parts.stored, parts.worksheets, revision, sheets);
        if (sent->damage) parts.messages->showError(words(*sent->damage));
        if (!outcome) {
          parts.messages->showError(outcome.error(), kSending);
        } else if (sent->result.left == 0 && sent->result.refused == 0) {
          parts.messages->showNote(
              sent->result.accepted > 0
                  ? tr("The archive %1 said that it stored everything (%2); it cannot be asked what it has, so this counts as delivered.")
                        .arg(words(archive.aeTitle), QString::number(sent->result.accepted + sent->result.verified))
              : sent->result.verified == 0 ? tr("The archive %1 has everything already.").arg(words(archive.aeTitle))
                                           : tr("The archive %1 has everything now; new to it: %2.")
                                                 .arg(words(archive.aeTitle), QString::number(sent->result.verified)),
              kSending);
        } else {
          parts.messages->showError(tr("Not in the archive yet, but safe in the outbox: %1. %2")
                                        .arg(QString::number(sent->result.left + sent->result.refused), words(sent->result.problem)),
                                    kSending);
        }
        if (dialog_.isNull()) return;
        dialog_->setSending(false);
        dialog_->setWaiting(waitingIn(outboxFolder()));
      });
}

bool Storing::mayLeave(const QString& next) {
  const auto answer = askBeforeLeaving(
      &parts_.window,
      {"unsavedStoredQuestion", tr("Stored images that were neither saved nor sent: %1.").arg(parts_.stored.atRiskCount()), {}}, next);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save() && parts_.isSavedNow());
}

}  // namespace ew::ui
