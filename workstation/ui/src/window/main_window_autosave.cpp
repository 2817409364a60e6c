// What a crash has left behind, and where one was: offered at the next start, and gone on with.
#include <QDateTime>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <algorithm>
#include <chrono>
#include <utility>

#include "ew/io/volume_file.h"
#include "widgets/words.h"
#include "window/main_window_parts.h"

namespace ew::ui {
namespace {

const auto kOpenSetting = QStringLiteral("open/last");
const auto kOpeningSetting = QStringLiteral("open/opening");  ///< set while it is being opened: a crash there must not come again
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
  return MainWindow::tr("'%1' could not be opened, so what was not saved of it is kept and offered at the next start.").arg(what);
}

QString notOpened(const QString& what) {
  return MainWindow::tr("'%1' was not opened, so what was not saved of it is kept and offered at the next start.").arg(what);
}

QString titleOf(const LeftWork& work) { return work.title.isEmpty() ? wordsOf(work.left->folder()) : work.title; }

/// As all that is said of kept work it concerns what lies in the program's own folder: it has no topic, and stays whatever is opened
/// meanwhile.
QString unreadIn(const LeftWork& work) {
  QStringList sentences(keptForLater(wordsOf(work.left->folder())));
  for (const Message& why : work.unread) sentences << words(why);
  return sentences.join(QLatin1Char(' '));
}

enum class Decision { goOn, discard, later };

Decision askAboutLeftWork(QWidget* parent, const LeftWork& work) {
  QMessageBox question(parent);
  question.setObjectName(QStringLiteral("unsavedWorkQuestion"));
  question.setIcon(QMessageBox::NoIcon);
  question.setTextFormat(Qt::PlainText);
  const auto at = QDateTime::fromSecsSinceEpoch(std::chrono::system_clock::to_time_t(work.left->at()));
  question.setText(
      MainWindow::tr("The program ended at %1 before this was saved; it was kept:").arg(QLocale().toString(at, QLocale::ShortFormat)));
  QStringList lines = linesOf(work);
  if (!work.title.isEmpty()) lines.prepend(MainWindow::tr("Of '%1':").arg(work.title));
  question.setInformativeText(lines.join(QLatin1Char('\n')));
  auto* goOn = question.addButton(MainWindow::tr("Go on"), QMessageBox::AcceptRole);
  auto* discard = question.addButton(MainWindow::tr("Discard"), QMessageBox::DestructiveRole);
  auto* later = question.addButton(MainWindow::tr("Decide later"), QMessageBox::RejectRole);
  goOn->setObjectName(QStringLiteral("goOnUnsaved"));
  discard->setObjectName(QStringLiteral("discardUnsaved"));
  question.setDefaultButton(goOn);
  question.setEscapeButton(later);
  question.exec();
  if (question.clickedButton() == goOn) return Decision::goOn;
  return question.clickedButton() == discard ? Decision::discard : Decision::later;
}

}  // namespace

void MainWindow::openWhereOneWas() {
  QSettings settings;
  const QString last = settings.value(kOpenSetting).toString();
  const bool isKnown = settings.contains(kOpenSetting);
  if (isKnown && (last.isEmpty() || settings.value(kOpeningSetting).toString() == last)) {
    settings.remove(kOpeningSetting);
    return showStartPage();  // it stood there, or what was open could not be opened
  }
  if (!isKnown || !QFileInfo::exists(last) || !mayOpenPath(last)) return openDefaultCase();
  settings.setValue(kOpeningSetting, last);
  settings.sync();
  parts_->opener->open(last);
}

void MainWindow::rememberOpen(const QString& path) {
  const auto& current = parts_->document.current();
  // A volume that was made here lies in no file; its sweep would ask again how it is to be made.
  const QString again = current ? wordsOf(current->folder) : shownMadeVolume() != nullptr ? QString() : path;
  QSettings settings;
  settings.remove(kOpeningSetting);
  if (current || !again.isEmpty()) settings.setValue(kOpenSetting, again);
  settings.sync();  // a kill must not take it
  // A volume that belongs to no case may be scanned beside an open one, and is nobody of that.
  parts_->autosave.setOpen(current && !parts_->opener->showsCase() ? QString() : again);
  followPatient();
}

void MainWindow::rememberClosing() {
  QSettings settings;
  settings.remove(kOpeningSetting);  // it was not the end of the program
  if (parts_->pages->currentWidget() == parts_->startPage) settings.setValue(kOpenSetting, QString());
}

void MainWindow::keepMadeVolumes() {
  std::vector<WorkAutosave::MadeHere> made;
  const MadeVolume* shown = shownMadeVolume();
  for (const MadeVolume& each : parts_->made) made.push_back({each.path, each.title, each.voxels.volume(), &each == shown});
  parts_->autosave.setVolumes(made);
}

void MainWindow::offerUnsavedWork() {
  auto left = std::make_shared<std::vector<LeftWork>>();
  parts_->jobs.start(
      tr("Looking for unsaved work"),
      [left, root = parts_->autosave.keeper().root()](Progress&) -> Result<void> {
        for (Autosave::Left& each : Autosave(root).takeLeft()) left->push_back(readLeftWork(std::move(each)));
        return {};
      },
      [this, left](const Result<void>& outcome) {
        if (outcome) askAboutLeft(std::move(*left));
      },
      Jobs::Kind::background);
}

void MainWindow::askAboutLeft(std::vector<LeftWork> left) {
  Parts& p = *parts_;
  for (LeftWork& work : left) {
    if (work.kind == kExpertScanWork && p.access.isLocked()) continue;  // it is an author's, and waits
    if (work.isEmpty()) {
      if (!work.unread.empty()) {
        p.messages->showError(unreadIn(work));
      } else if (work.kind == kWindowWork) {
        work.left->discard();
      }
      continue;
    }
    switch (askAboutLeftWork(this, work)) {
      case Decision::goOn:
        p.resumed.push_back(std::move(work));
        break;
      case Decision::discard:
        work.left->discard();
        break;
      case Decision::later:
        break;
    }
  }
  // A lesson last: whatever is opened after it would lead out of it.
  std::stable_partition(p.resumed.begin(), p.resumed.end(), [](const LeftWork& work) { return !work.step; });
  resumeNext();
}

bool MainWindow::isOpenFor(const LeftWork& work) const {
  const auto& current = parts_->document.current();
  const auto& subject = parts_->session.subject();
  if (work.scanned && subject && subject->voxels.volume() == work.scanned) return true;
  const QString open = current && parts_->opener->showsCase() ? wordsOf(current->folder) : parts_->autosave.path();
  return !work.path.isEmpty() && !open.isEmpty() && isSamePath(open, work.path);
}

void MainWindow::resumeNext() {
  Parts& p = *parts_;
  if (p.isResuming) return;
  // What waits until its own volume is shown is gone on with then.
  std::stable_partition(p.resumed.begin(), p.resumed.end(), [](const LeftWork& work) { return !work.scanned; });
  if (p.resumed.empty() || p.resumed.front().scanned) return;
  const LeftWork& next = p.resumed.front();
  if (next.step || next.path.isEmpty() || isOpenFor(next)) {
    // What is still being opened would take the place of what is shown here.
    if (p.opener->isBusy() && !next.step) return QTimer::singleShot(kLookAgain_ms, this, &MainWindow::resumeNext);
    return resume();
  }
  p.opener->open(next.path);
  p.isResuming = p.opener->isOpening(next.path);  // what was being opened before has been given up
  if (!p.isResuming) leaveForLater();
}

void MainWindow::resumeIfOpen() {
  Parts& p = *parts_;
  if (p.isResuming && !p.resumed.empty() && isOpenFor(p.resumed.front())) return resume();
  const auto waiting =
      std::find_if(p.resumed.begin(), p.resumed.end(), [this](const LeftWork& work) { return work.scanned && isOpenFor(work); });
  if (waiting == p.resumed.end()) return;
  const LeftWork work = std::move(*waiting);
  p.resumed.erase(waiting);
  showLeftMeasured(work);
}

void MainWindow::resumeWithAnswersOf(const QDialog& dialog, const QString& path) {
  Parts& p = *parts_;
  if (!p.isResuming || p.resumed.empty() || !isSamePath(p.resumed.front().path, path)) return;
  p.resumed.front().isAsked = true;
  // One that is hidden while it makes something, and then closes, is never finished. Without the window nobody is told.
  connect(&dialog, &QObject::destroyed, &p.autosave, [this, asked = p.resumed.front().left.get()] {
    Parts& now = *parts_;
    if (now.resumed.empty() || now.resumed.front().left.get() != asked) return;  // it was opened, and gone on with
    now.isResuming = false;
    leaveForLater();
  });
}

void MainWindow::leaveForLater() {
  Parts& p = *parts_;
  if (p.resumed.empty()) return;
  p.messages->showError(notOpened(p.resumed.front().path));
  p.resumed.erase(p.resumed.begin());
  QTimer::singleShot(0, this, &MainWindow::resumeNext);
}

void MainWindow::leaveUnshown(const LeftWork& work) {
  Parts& p = *parts_;
  const auto made = std::find_if(p.made.begin(), p.made.end(),
                                 [&](const MadeVolume& each) { return work.scanned && each.voxels.volume() == work.scanned; });
  if (made != p.made.end()) {
    p.messages->showNote(tr("The volume made from %1 is kept: View, Show the volume made from %1.").arg(made->title) + QLatin1Char(' ') +
                         tr("What was recorded and measured of it comes back when it is shown, and is else offered at the next start."));
    return p.resumed.push_back(work);
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
          if (work.measured.isEmpty() && work.unread.empty()) parts_->autosave.keeper().discardOnceKept(work.left);
        };
        if (!saveRecordingAs(work.recording, tr("Save the recording"), tr("scan"), saved)) leaveUnshown(work);
      },
      kResuming + QLatin1Char(' ') + folder);
}

void MainWindow::resume() {
  Parts& p = *parts_;
  p.isResuming = false;
  if (p.resumed.empty()) return;
  const LeftWork work = std::move(p.resumed.front());
  p.resumed.erase(p.resumed.begin());
  if (!work.step && !work.volumes.empty()) return takeLeftVolumes(work);
  if (!p.resumed.empty()) QTimer::singleShot(0, this, &MainWindow::resumeNext);
  if (work.step) {
    work.left->release();  // the lessons take it up when they go on
    return openLesson(work.path, QString::fromStdString(work.step->lesson));
  }
  showLeftMeasured(work);
}

void MainWindow::takeLeftVolumes(const LeftWork& left) {
  struct Made {
    LeftWork::MadeVolume of;
    ScanVoxels voxels;
  };
  auto made = std::make_shared<std::vector<Made>>();
  parts_->jobs.start(
      tr("Reading what was not saved"),
      [made, volumes = left.volumes](Progress& progress) -> Result<void> {
        for (const LeftWork::MadeVolume& each : volumes) {
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
          parts_->messages->showError(outcome.error());
          return resumeNext();
        }
        LeftWork work = left;
        std::optional<MadeVolume> shown;
        for (const Made& each : *made) {
          parts_->made.push_back({each.of.path, each.of.title, each.voxels, nullptr});
          if (each.of.isShown) shown = parts_->made.back();
        }
        if (shown) work.scanned = shown->voxels.volume();
        keepMadeVolumes();
        if (shown && mayReplaceShown(shown->title)) showMade(*shown);
        showTitle();
        showLeftMeasured(work);
        resumeNext();  // not before: somebody was asked
      });
}

void MainWindow::showLeftMeasured(const LeftWork& work) {
  Parts& p = *parts_;
  if (work.isOfPatient() && !isOpenFor(work)) return leaveUnshown(work);
  if (work.isOfPatient() &&
      (p.recorder.isRecording() || isRecordingUnsaved() || p.calipers.isUnsaved() || p.worksheets.unsaved() != nullptr))
    return p.messages->showError(tr("What was recorded or measured here is not saved yet, so what was not saved of '%1' before is kept and "
                                    "offered at the next start.")
                                     .arg(titleOf(work)));
  std::vector<StillPicture> frames;
  auto shown = work.recording;
  if (!work.measured.images.empty() && !shown) {
    ScanRecording images = statesOf(work.measured);
    images.caseId = recordedCase();
    images.title = p.session.subject() ? p.session.subject()->title : std::string();
    for (std::size_t n = 0; n < images.log.frameCount(); ++n)
      frames.push_back({true, false, images.log.frameTime_s(n), images.log.frame(n).number});
    shown = std::make_shared<const ScanRecording>(std::move(images));
  }
  if (shown && !p.session.subject())  // what it is a scan of is not there
    return p.messages->showError(keptForLater(titleOf(work)));
  if (shown) {
    if (!work.recording) p.savedRecording = shown;  // images that were measured are no recording that one would miss
    p.replayed.clear();
    p.replayBar->load(shown);
    p.replayBar->setSaved(!isRecordingUnsaved());
    p.pages->setCurrentWidget(p.workspacePage);
    p.session.makePictureNow();
    if (work.recording) p.autosave.takeRecording(work.recording);
    showRecordingState();
  }
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
