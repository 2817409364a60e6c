#include "window/features/resuming.h"

#include <QDateTime>
#include <QDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "ew/core/volume.h"
#include "ew/io/volume_file.h"
#include "ew/scanning/recording.h"
#include "ew/widgets/words.h"
#include "scan/still_image.h"
#include "window/features/case_saving.h"
#include "window/features/opening.h"
#include "window/features/recording.h"
#include "window/features/unsaved_volumes.h"
#include "window/frame/window_parts.h"

namespace ew::ui {
namespace {

constexpr int kLookAgain_ms = 100;
const auto kResuming = QStringLiteral("unsaved work");

bool isSamePath(const QString& a, const QString& b) { return QFileInfo(a).absoluteFilePath() == QFileInfo(b).absoluteFilePath(); }

/// A volume that was made before the crash, with which of its voxels were measured.
Result<std::shared_ptr<const Volume>> readMade(const std::filesystem::path& file, Progress& progress) {
  auto read = readVolume(file, progress);
  if (!read) return passOn(read.error());
  Volume volume = std::move(read->volume);
  std::error_code ignored;
  if (const std::filesystem::path coverage = file.string() + "-coverage.mha"; std::filesystem::exists(coverage, ignored))
    if (auto taken = readCoverageInto(volume, coverage, progress); !taken) return passOn(taken.error());
  return std::make_shared<const Volume>(std::move(volume));
}

QString keptForLater(const QString& what) {
  return Resuming::tr("'%1' could not be opened, so what was not saved of it is kept and offered at the next start.").arg(what);
}

QString notOpened(const QString& what) {
  return Resuming::tr("'%1' was not opened, so what was not saved of it is kept and offered at the next start.").arg(what);
}

QString titleOf(const RecoverableWork& work) { return work.title.isEmpty() ? wordsOf(work.left->folder()) : work.title; }

/// As all that is said of kept work it concerns what lies in the program's own folder: it has no topic, and stays whatever is opened
/// meanwhile.
QString unreadIn(const RecoverableWork& work) {
  QStringList sentences(keptForLater(wordsOf(work.left->folder())));
  for (const Message& why : work.unread) sentences << words(why);
  return sentences.join(QLatin1Char(' '));
}

enum class Decision { goOn, discard, later };

Decision askAboutLeftWork(QWidget* parent, const RecoverableWork& work) {
  QMessageBox question(parent);
  question.setObjectName(QStringLiteral("unsavedWorkQuestion"));
  question.setIcon(QMessageBox::NoIcon);
  question.setTextFormat(Qt::PlainText);
  const auto at = QDateTime::fromSecsSinceEpoch(std::chrono::system_clock::to_time_t(work.left->at()));
  question.setText(
      Resuming::tr("The program ended at %1 before this was saved; it was kept:").arg(QLocale().toString(at, QLocale::ShortFormat)));
  QStringList lines = linesOf(work);
  if (!work.title.isEmpty()) lines.prepend(Resuming::tr("Of '%1':").arg(work.title));
  question.setInformativeText(lines.join(QLatin1Char('\n')));
  auto* goOn = question.addButton(Resuming::tr("Go on"), QMessageBox::AcceptRole);
  auto* discard = question.addButton(Resuming::tr("Discard"), QMessageBox::DestructiveRole);
  auto* later = question.addButton(Resuming::tr("Decide later"), QMessageBox::RejectRole);
  goOn->setObjectName(QStringLiteral("goOnUnsaved"));
  discard->setObjectName(QStringLiteral("discardUnsaved"));
  question.setDefaultButton(goOn);
  question.setEscapeButton(later);
  question.exec();
  if (question.clickedButton() == goOn) return Decision::goOn;
  return question.clickedButton() == discard ? Decision::discard : Decision::later;
}

}  // namespace

void Resuming::connectParts() {
  connect(&parts_.autosave, &WorkAutosave::failed, this,
          [this](const Error& error) { parts_.messages->showError(error, kKeepingWorkTopic); });
}

void Resuming::offer() {
  auto left = std::make_shared<std::vector<RecoverableWork>>();
  parts_.jobs.start(
      tr("Looking for unsaved work"),
      [left, root = parts_.autosave.keeper().root()](Progress&) -> Result<void> {
        for (Autosave::Left& each : Autosave(root).takeLeft()) left->push_back(readLeftWork(std::move(each)));
        return {};
      },
      [this, left](const Result<void>& outcome) {
        if (outcome) ask(std::move(*left));
      },
      Jobs::Kind::background);
}

void Resuming::ask(std::vector<RecoverableWork> left) {
  WindowParts& p = parts_;
  if (p.caseSaving->isOffering())  // one question after the other
    return QTimer::singleShot(kLookAgain_ms, this, [this, left = std::move(left)]() mutable { ask(std::move(left)); });
  for (RecoverableWork& work : left) {
    if (work.kind == kExpertScanWork && p.access.isLocked()) continue;  // it is an author's, and waits
    if (work.isEmpty()) {
      if (!work.unread.empty()) {
        p.messages->showError(unreadIn(work));
      } else if (work.kind == kWindowWork) {
        work.left->discard();
      }
      continue;
    }
    switch (askAboutLeftWork(&p.window, work)) {
      case Decision::goOn:
        left_.push_back(std::move(work));
        break;
      case Decision::discard:
        work.left->discard();
        break;
      case Decision::later:
        break;
    }
  }
  // A lesson last: whatever is opened after it would lead out of it.
  std::stable_partition(left_.begin(), left_.end(), [](const RecoverableWork& work) { return !work.step; });
  next();
}

bool Resuming::isOpenFor(const RecoverableWork& work) const {
  const auto& current = parts_.document.current();
  const auto& subject = parts_.session.subject();
  if (work.scanned && subject && subject->voxels.volume() == work.scanned) return true;
  const QString open = current && parts_.opener->showsCase() ? wordsOf(current->folder) : parts_.autosave.path();
  return !work.path.isEmpty() && !open.isEmpty() && isSamePath(open, work.path);
}

void Resuming::next() {
  WindowParts& p = parts_;
  if (isResuming_) return;
  // What waits until its own volume is shown is gone on with then.
  std::stable_partition(left_.begin(), left_.end(), [](const RecoverableWork& work) { return !work.scanned; });
  if (left_.empty() || left_.front().scanned) return;
  const RecoverableWork& first = left_.front();
  if (first.step || first.path.isEmpty() || isOpenFor(first)) {
    // What is still being opened would take the place of what is shown here.
    if (p.opener->isBusy() && !first.step) return QTimer::singleShot(kLookAgain_ms, this, &Resuming::next);
    return resume();
  }
  p.opener->open(first.path);
  isResuming_ = p.opener->isOpening(first.path);  // what was being opened before has been given up
  if (!isResuming_) leaveForLater();
}

void Resuming::opened() {
  if (isResuming_ && !left_.empty() && isOpenFor(left_.front())) return resume();
  const auto waiting =
      std::find_if(left_.begin(), left_.end(), [this](const RecoverableWork& work) { return work.scanned && isOpenFor(work); });
  if (waiting == left_.end()) return;
  const RecoverableWork work = std::move(*waiting);
  left_.erase(waiting);
  showMeasured(work);
}

void Resuming::openingEnded() {
  // What a dialog asks about may still be opened.
  const bool isAsked = !left_.empty() && left_.front().isAsked;
  if (!isAsked && std::exchange(isResuming_, false)) leaveForLater();
}

void Resuming::waitFor(const QDialog& dialog, const QString& path) {
  if (!isResuming_ || left_.empty() || !isSamePath(left_.front().path, path)) return;
  left_.front().isAsked = true;
  // One that is hidden while it makes something, and then closes, is never finished. Without the window nobody is told.
  connect(&dialog, &QObject::destroyed, this, [this, asked = left_.front().left.get()] {
    if (left_.empty() || left_.front().left.get() != asked) return;  // it was opened, and gone on with
    isResuming_ = false;
    leaveForLater();
  });
}

void Resuming::leaveForLater() {
  WindowParts& p = parts_;
  if (left_.empty()) return;
  p.messages->showError(notOpened(left_.front().path));
  left_.erase(left_.begin());
  QTimer::singleShot(0, this, &Resuming::next);
}

void Resuming::leaveUnshown(const RecoverableWork& work) {
  WindowParts& p = parts_;
  const std::vector<UnsavedVolume>& all = p.volumes->all();
  const auto made =
      std::find_if(all.begin(), all.end(), [&](const UnsavedVolume& each) { return work.scanned && each.voxels.volume() == work.scanned; });
  if (made != all.end()) {
    p.messages->showNote(UnsavedVolumes::saysKept(*made) + QLatin1Char(' ') +
                         tr("What was recorded and measured of it comes back when it is shown, and is else offered at the next start."));
    return left_.push_back(work);
  }
  if (!work.path.isEmpty()) return p.messages->showError(notOpened(titleOf(work)));
  const QString folder = wordsOf(work.left->folder());
  const QString sentence =
      tr("'%1' lies in no file and is not here any more, so what was recorded and measured of it cannot be shown. It is "
         "kept in %2 and offered again at the next start.")
          .arg(titleOf(work), folder);
  if (!work.recording) return p.messages->showError(sentence);
  p.messages->showOffer(
      sentence, tr("Save recording as…"),
      [this, work] {
        const auto saved = [this, work] {
          if (work.measured.isEmpty() && work.unread.empty()) parts_.autosave.keeper().discardOnceKept(work.left);
        };
        if (!parts_.recording->saveAs(work.recording, tr("Save the recording"), saved)) leaveUnshown(work);
      },
      kResuming + QLatin1Char(' ') + folder);
}

void Resuming::resume() {
  isResuming_ = false;
  if (left_.empty()) return;
  const RecoverableWork work = std::move(left_.front());
  left_.erase(left_.begin());
  if (!work.step && !work.volumes.empty()) return takeVolumes(work);
  if (!left_.empty()) QTimer::singleShot(0, this, &Resuming::next);
  if (work.step) {
    work.left->release();  // the lessons take it up when they go on
    return parts_.opening->openLesson(work.path, QString::fromStdString(work.step->lesson));
  }
  showMeasured(work);
}

void Resuming::takeVolumes(const RecoverableWork& left) {
  struct Made {
    RecoverableWork::VolumeDraft of;
    ScanVoxels voxels;
  };
  auto made = std::make_shared<std::vector<Made>>();
  parts_.jobs.start(
      tr("Reading what was not saved"),
      [made, volumes = left.volumes](Progress& progress) -> Result<void> {
        for (const RecoverableWork::VolumeDraft& each : volumes) {
          if (each.file.empty()) continue;
          auto volume = readMade(each.file, progress);
          if (!volume) return passOn(volume.error());
          auto voxels = ScanVoxels::of(std::move(*volume), progress);
          if (!voxels) return passOn(voxels.error());
          made->push_back({each, std::move(*voxels)});
        }
        return {};
      },
      [this, made, left](const Result<void>& outcome) {
        if (!outcome) {
          parts_.messages->showError(outcome.error());
          return next();
        }
        std::vector<UnsavedVolume> volumes;
        std::optional<std::size_t> shown;
        for (const Made& each : *made) {
          if (each.of.isShown) shown = volumes.size();
          volumes.push_back({each.of.path, each.of.title, each.voxels, nullptr});
        }
        RecoverableWork work = left;
        if (auto scanned = parts_.volumes->takeLeft(volumes, shown ? &volumes[*shown] : nullptr)) work.scanned = std::move(scanned);
        showMeasured(work);
        next();  // not before: somebody was asked
      });
}

void Resuming::showMeasured(const RecoverableWork& work) {
  WindowParts& p = parts_;
  if (work.isOfPatient() && !isOpenFor(work)) return leaveUnshown(work);
  if (work.isOfPatient() &&
      (p.recorder.isRecording() || p.recording->isUnsaved() || p.calipers.isUnsaved() || p.worksheets.unsaved() != nullptr))
    return p.messages->showError(tr("What was recorded or measured here is not saved yet, so what was not saved of '%1' before is kept and "
                                    "offered at the next start.")
                                     .arg(titleOf(work)));
  std::vector<StillImage> frames;
  auto shown = work.recording;
  if (!work.measured.images.empty() && !shown) {
    ScanRecording images = statesOf(work.measured);
    images.caseId = p.recording->caseId();
    images.title = p.session.subject() ? p.session.subject()->title : std::string();
    for (std::size_t n = 0; n < images.log.frameCount(); ++n)
      frames.push_back({true, false, images.log.frameTime_s(n), images.log.frame(n).number});
    shown = std::make_shared<const ScanRecording>(std::move(images));
  }
  if (shown && !p.session.subject())  // what it is a scan of is not there
    return p.messages->showError(keptForLater(titleOf(work)));
  if (shown) p.recording->showAgain(shown, !work.recording);
  if (!work.measured.isEmpty()) {
    p.calipers.restore(work.measured.images, frames, work.measured.combinations);
    p.worksheets.restore(work.measured);
    p.autosave.restore(work.measured);
  }
  p.messages->showNote(work.kind == kExpertScanWork
                           ? tr("The expert's scan is here again. Save it, then choose it in its step of the lesson (Choose a recording…).")
                           : tr("What was not saved when the program ended is here again. Save what is to stay."),
                       kResuming);
  if (!work.unread.empty()) return p.messages->showError(unreadIn(work));  // it stays there, with what is here again
  // Here first, before it is gone there.
  p.autosave.keeper().discardOnceKept(work.left);
}

}  // namespace ew::ui
