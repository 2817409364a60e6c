#include "import/opener.h"

#include <QFileInfo>
#include <QMetaObject>
#include <algorithm>
#include <future>
#include <utility>

#include "body/hand_input.h"
#include "body/view3d.h"
#include "case/case_preparation.h"
#include "ew/core/ending.h"
#include "ew/core/quiet_progress.h"
#include "ew/core/quiet_work.h"
#include "ew/io/image_stack.h"
#include "ew/io/sequence.h"
#include "ew/io/volume_file.h"
#include "ew/library/bundle.h"
#include "ew/library/case_echoes.h"
#include "ew/library/first_look.h"
#include "ew/library/preparation.h"
#include "ew/library/voxel_source.h"
#include "ew/scanning/contact.h"
#include "ew/widgets/words.h"
#include "import/opener_scan.h"
#include "jobs/message_bar.h"
#include "start/recent_files.h"

namespace ew::ui {
namespace {

namespace fs = std::filesystem;

/// The mannequin a case asks for: in the case folder, else among the shipped ones; the default when it names none.
Result<fs::path> mannequinFileOf(const std::optional<Case>& opened) {
  auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  const std::string name = opened && !opened->mannequin.empty() ? opened->mannequin : std::string("adult.json");
  std::error_code ignored;
  if (opened && fs::exists(opened->folder / name, ignored)) return opened->folder / name;
  return *resources / "mannequin" / name;
}

Result<std::shared_ptr<const bridge::Mannequin>> readMannequin(const fs::path& file, Progress& progress) {
  auto loaded = bridge::loadMannequin(file, {}, progress);
  if (!loaded) return passOn(loaded.error());
  return std::make_shared<const bridge::Mannequin>(std::move(*loaded));
}

/// NIfTI files often carry a geometry that means nothing: then the spacing is asked for.
bool isNifti(const QString& path) {
  return path.endsWith(QLatin1String(".nii"), Qt::CaseInsensitive) || path.endsWith(QLatin1String(".nii.gz"), Qt::CaseInsensitive);
}

/// Nice: a second of all cores, begun with the window, which is to be drawn first. The first image needs body and volume, so it comes no
/// later.
constexpr int kBehindTheWindow = 10;
constexpr double kLong_s = 5.0;  ///< worth waiting for behind something else

QString openingOf(const Case& opened) { return Opener::tr("Opening %1").arg(shownTitle(opened)); }

/// Whether a case has to be made, and how long that takes; empty: it is there.
std::optional<CaseToMake> toBeMade(const Case& read) {
  if (!caseNeedsPreparation(read)) return std::nullopt;
  const auto estimate = estimatePreparation(read);
  return CaseToMake{read, estimate ? estimate->seconds : 0.0, mayBeDrafted(read)};
}

/// Moved without turning: the box's middle under the xiphoid; as deep as the trunk it is centred, a shallower one begins at the front
/// skin, where a probe can see it.
Grid inMiddleOfTrunk(const Grid& grid, const Skin& skin) {
  const Bounds bounds = boundsOf(grid);
  const glm::dvec3 extent_mm = bounds.highest_mm - bounds.lowest_mm;
  glm::dvec3 middle_mm(0.0);
  const double front_mm = skinInFrontOf(skin, middle_mm).point_mm.y;
  middle_mm.y = std::min(0.0, front_mm + extent_mm.y / 2.0);
  Grid moved = grid;
  moved.origin_mm += middle_mm - centreOf(grid);
  return moved;
}

}  // namespace

bool CaseToMake::takesLong() const { return !isDrafted && seconds >= kLong_s; }

/// What the job that loads a case hands over to the window's thread.
struct Opener::Loading {
  std::optional<Case> opened;
  Fingerprint asRead;  ///< of its manifest
  Contents contents;
  std::shared_ptr<const bridge::Mannequin> mannequin;  ///< null: the present one is the right one
  fs::path mannequinFile;
  std::optional<CaseToMake> left;  ///< it takes long and was not loaded
};

/// What the job that looks at any other file hands over.
struct Opener::Image {
  ScanVoxels voxels;
  std::vector<Message> notes;
  std::vector<Message> warnings;  ///< of the notes, those that are told first
  bool isSweep = false;
  std::shared_ptr<const ScanRecording> recording;  ///< null: the file is none
  FileKind kind = FileKind::volume;
  bool asks = false;
  Message question;
};

Opener::Opener(Session& session, CaseDocument& document, Jobs& jobs, MessageBar& messages, View3D& view, HandInput& hand, QObject* parent)
    : QObject(parent), session_(session), document_(document), jobs_(jobs), messages_(messages), view_(view), hand_(hand) {
  connect(&document_, &CaseDocument::changed, this, &Opener::followDocument);
  connect(&view_, &View3D::mannequinChanged, this, [this] {
    session_.probeControl().setSkin(view_.skin());
    if (!startTaken_) {
      takeStart();
    } else if (session_.subject()) {
      session_.probeControl().setHold(
          movedTo(session_.probeControl().hold(), view_.skin()->nearest(session_.probeControl().hold().contact.point_mm)));
    }
  });
  connect(&hand_, &HandInput::moved, &session_.probeControl(), &ProbeControl::setHold);
  connect(&session_.console(), &ScanConsole::echoesWanted, this, &Opener::findTissue);
  constexpr int kLookAgain_ms = 500;
  finerSoon_.setInterval(kLookAgain_ms);
  connect(&finerSoon_, &QTimer::timeout, this, &Opener::takeFiner);
  connect(&session_, &Session::subjectReplaced, this, [this] {
    if (tissueJob_ != 0) jobs_.cancel(std::exchange(tissueJob_, 0));
  });
}

void Opener::findTissue() {
  if (tissueJob_ != 0) return;
  auto found = std::make_shared<std::shared_ptr<const TissueMaps>>();
  auto id = std::make_shared<int>(0);
  *id = jobs_.start(
      tr("Preparing live echoes"),
      [found, voxels = session_.subject()->voxels, scene = session_.console().scene()](Progress& progress) -> Result<void> {
        auto made = recordedTissueOf(voxels, scene, 0, progress);
        if (!made) return passOn(made.error());
        *found = std::move(*made);
        return {};
      },
      [this, found, id](const Result<void>& outcome) {
        if (*id != tissueJob_) return;
        tissueJob_ = 0;
        if (outcome) {
          session_.know(*found);
        } else if (outcome.error().code != ErrorCode::cancelled) {
          messages_.showError(outcome.error());
        }
      });
  tissueJob_ = *id;
}

void Opener::loadDefaultMannequin() {
  const auto file = mannequinFileOf(std::nullopt);
  if (!file) {
    messages_.showError(file.error());
    return;
  }
  mannequinFile_ = *file;
  auto loaded = std::make_shared<std::shared_ptr<const bridge::Mannequin>>();
  ++busy_;
  jobs_.start(
      tr("Preparing the mannequin"),
      [loaded, file = *file](Progress& progress) -> Result<void> {
        const QuietWork quietly(kBehindTheWindow);
        auto read = readMannequin(file, progress);
        if (!read) return passOn(read.error());
        *loaded = std::move(*read);
        return {};
      },
      [this, loaded, file = *file](const Result<void>& outcome) {
        --busy_;
        if (mannequinFile_ != file) return;  // a case came first, with a body of its own
        if (outcome) return showMannequin(*loaded);
        mannequinFile_.clear();
        if (outcome.error().code != ErrorCode::cancelled) messages_.showError(outcome.error());
      });
}

void Opener::showMannequin(std::shared_ptr<const bridge::Mannequin> mannequin) {
  if (!mannequin) return;
  messages_.showNotes(tr("The mannequin was read; %n notes say how.", nullptr, static_cast<int>(mannequin->notes.size())),
                      mannequin->notes);
  view_.setMannequin(std::move(mannequin));
}

void Opener::tellOpened(const QString& path, const std::vector<Message>& notes, const std::vector<Message>& warnings) {
  // What makes the volume doubtful stands in front, not among the details.
  messages_.showNotes(
      warnings.empty()
          ? tr("%1 is open; %n notes say how it was read.", nullptr, static_cast<int>(notes.size())).arg(QFileInfo(path).fileName())
          : words(joined(warnings)),
      notes, openingTopic());
}

void Opener::open(const QString& path, LongCases longOnes) {
  const QFileInfo info(path);
  if (!info.exists()) {
    const Error error{ErrorCode::notFound,
                      verbatim(tr("There is no file or folder '%1'; check the name, or choose it with Open.").arg(path).toStdString()),
                      {}};
    messages_.showError(error, openingTopic());
    Q_EMIT failed(error);
    return;
  }
  if (info.isFile() && hasEnding(pathOf(path), kBundleEnding)) {
    Q_EMIT bundleChosen(info.absoluteFilePath());
    return;
  }
  // The second click of a double click asks for what is already on its way.
  if (info.absoluteFilePath() == openingPath_) return;
  const bool isCaseFolder = info.isDir() && (QFileInfo::exists(path + QStringLiteral("/case.json")) || !stackFiles(pathOf(path)));
  if (isCaseFolder || info.suffix() == QLatin1String("json")) {
    openCase(path, longOnes);
  } else {
    openImage(path);
  }
}

void Opener::startOpening(const QString& path, const QString& title, Jobs::Work work, std::function<void()> taken,
                          std::function<void()> refused) {
  // Whoever chooses something else while a case is prepared wants that, not whatever happens to be ready last.
  giveUpOpening();
  ++busy_;
  auto id = std::make_shared<int>(0);
  *id =
      jobs_.start(title, std::move(work), [this, id, taken = std::move(taken), refused = std::move(refused)](const Result<void>& outcome) {
        --busy_;
        if (*id != openingJob_) return;
        openingJob_ = 0;
        openingPath_.clear();
        reloading_.reset();
        beingMade_.reset();
        if (outcome) {
          taken();
        } else {
          if (refused) refused();
          if (outcome.error().code != ErrorCode::cancelled) messages_.showError(outcome.error(), openingTopic());
          Q_EMIT failed(outcome.error());
        }
        Q_EMIT ended();
      });
  openingJob_ = *id;
  openingPath_ = QFileInfo(path).absoluteFilePath();
}

bool Opener::isOpening(const QString& path) const { return openingJob_ != 0 && QFileInfo(path).absoluteFilePath() == openingPath_; }

void Opener::giveUpOpening() {
  if (openingJob_ == 0) return;
  jobs_.cancel(openingJob_);
  openingJob_ = 0;
  openingPath_.clear();
  reloading_.reset();
  beingMade_.reset();
  Q_EMIT ended();
}

Opener::Sources Opener::sourcesOf(const Case& opened) {
  Sources sources{opened.volume, opened.mannequin};
  sources.volume.fileToWorld = {};
  return sources;
}

/// Fills everything but `into.opened`, which says what to load.
Result<void> Opener::load(Loading& into, const fs::path& presentMannequin, Progress& progress) {
  const Case& opened = *into.opened;
  auto body = mannequinFileOf(opened);
  if (!body) return passOn(body.error());
  into.contents.sources = sourcesOf(opened);
  // The body is read beside the contents: neither waits for the other.
  std::future<Result<std::shared_ptr<const bridge::Mannequin>>> mannequin;
  if (*body != presentMannequin)
    mannequin = std::async(std::launch::async, [file = *body, &progress] {
      QuietProgress silent(progress);
      return readMannequin(file, silent);
    });
  Result<void> contents;
  if (!hasNoVolume(opened)) {
    auto read = readContents(opened, progress, {.draft = true});
    if (read)
      into.contents.read = std::move(*read);
    else
      contents = passOn(read.error());
  }
  if (mannequin.valid()) {
    auto read = mannequin.get();
    if (!contents) return contents;
    if (!read) return passOn(read.error());
    into.mannequin = std::move(*read);
  }
  if (!contents) return contents;
  into.mannequinFile = std::move(*body);
  return {};
}

void Opener::takeContents(Loading& loaded) {
  // Until its volume is shown the session holds that of another case, which this one must not move.
  showsCase_ = false;
  contents_ = std::move(loaded.contents);
  refused_.reset();
  mannequinFile_ = loaded.mannequinFile;
  showMannequin(loaded.mannequin);
}

void Opener::openCase(const QString& path, LongCases longOnes) {
  auto loaded = std::make_shared<Loading>();
  const auto job = std::make_shared<int>(0);
  startOpening(
      path, tr("Opening a case"),
      [this, loaded, path, longOnes, job, present = mannequinFile_](Progress& progress) -> Result<void> {
        auto read = readCase(pathOf(path));
        if (!read) return passOn(read.error());
        loaded->opened = std::move(read->opened);
        loaded->asRead = read->manifest;
        tellTitle(*loaded->opened, job);
        auto toMake = toBeMade(*loaded->opened);
        if (toMake && longOnes == LongCases::leave && toMake->takesLong()) {
          loaded->left = std::move(toMake);
          return {};
        }
        if (toMake) tellPreparing(path, std::move(*toMake), job);
        return load(*loaded, present, progress);
      },
      [this, loaded, path] {
        if (loaded->left) {
          Q_EMIT tooLong(path, *loaded->left);
          return;
        }
        if (!mayReplace_(shownTitle(*loaded->opened))) return;
        messages_.forgetWhatIsPast();
        takeContents(*loaded);
        patient_.reset();
        document_.open(*loaded->opened, loaded->asRead);
        scanCase();
        tellOpened(path, contents_->read.notes);
        Q_EMIT opened(path);
      });
  *job = openingJob_;
}

void Opener::tellTitle(const Case& read, const std::shared_ptr<const int>& job) {
  QMetaObject::invokeMethod(
      this, [this, title = openingOf(read), job] { jobs_.rename(*job, title); }, Qt::QueuedConnection);
}

void Opener::tellPreparing(const QString& path, CaseToMake toMake, const std::shared_ptr<const int>& job) {
  QMetaObject::invokeMethod(
      this,
      [this, path, toMake = std::move(toMake), job] {
        if (*job != openingJob_) return;
        const QString caseId = words(toMake.wanted.id);
        beingMade_ = toMake;
        Q_EMIT preparing(path, caseId);
      },
      Qt::QueuedConnection);
}

void Opener::reloadCase(const Case& edited) {
  const Sources wanted = sourcesOf(edited);
  if (reloading_ == wanted || refused_ == wanted) return;
  auto loaded = std::make_shared<Loading>();
  loaded->opened = edited;
  const auto job = std::make_shared<int>(0);
  const QString path = wordsOf(edited.folder);
  startOpening(
      path, openingOf(edited),
      [this, loaded, path, job, present = mannequinFile_](Progress& progress) {
        if (auto toMake = toBeMade(*loaded->opened)) tellPreparing(path, std::move(*toMake), job);
        return load(*loaded, present, progress);
      },
      [this, loaded, path] {
        // Edits that go on meanwhile, of the title or the placement, count; those of another volume have asked for another loading.
        const auto& now = document_.current();
        if (!now || !(sourcesOf(*now) == loaded->contents.sources)) return;
        if (!mayScanCase(loaded->contents.sources)) return stayWith(loaded->contents.sources);
        takeContents(*loaded);
        scanCase();
        tellOpened(path, contents_->read.notes);
      },
      [this, wanted] {
        // Nothing is scanned rather than what the case does not hold any more; "Scan the case's volume" tries again.
        refused_ = wanted;
        if (!std::exchange(showsCase_, false)) return;
        session_.clear(Session::Patient::same);  // until something else is scanned
      });
  *job = openingJob_;
  openingPath_.clear();  // whoever opens the case meanwhile wants what its folder holds
  reloading_ = wanted;
}

void Opener::loadChanged(const Case& edited) {
  Sources but = sourcesOf(edited);
  but.volume.labels = contents_->sources.volume.labels;
  if (!showsCase_ || !(but == contents_->sources)) return reloadCase(edited);
  reloadLabels(edited);
  followEdits(edited);
}

void Opener::reloadLabels(const Case& edited) {
  const Sources wanted = sourcesOf(edited);
  if (reloading_ == wanted || refused_ == wanted) return;
  auto read = std::make_shared<std::shared_ptr<const Volume>>();
  startOpening(
      wordsOf(edited.folder), openingOf(edited),
      [read, edited, contents = contents_->read](Progress& progress) -> Result<void> {
        auto labels = readLabelsFor(edited, contents, progress);
        if (!labels) return passOn(labels.error());
        *read = std::move(*labels);
        return {};
      },
      [this, read, wanted] {
        const auto& now = document_.current();
        if (!now || !(sourcesOf(*now) == wanted) || !contents_) return;
        contents_->sources = wanted;
        contents_->read.labels = std::move(*read);
        if (showsCase_) session_.setLabels(contents_->read.labels);
      },
      [this, wanted] {
        // As with voxels: no labels rather than those that the case does not hold any more.
        refused_ = wanted;
        if (showsCase_) session_.setLabels(nullptr);
      });
  openingPath_.clear();
  reloading_ = wanted;
}

void Opener::openImage(const QString& path) {
  auto loaded = std::make_shared<Image>();
  startOpening(
      path, tr("Opening %1").arg(fileNameOf(path)),
      [loaded, path](Progress& progress) -> Result<void> {
        const auto kind = kindOfFile(pathOf(path));
        if (!kind) return passOn(kind.error());
        loaded->kind = *kind;
        loaded->isSweep = *kind == FileKind::sweep;
        if (loaded->isSweep && isRecording(pathOf(path)).value_or(false)) {
          auto recording = readRecording(pathOf(path), progress);
          if (!recording) return passOn(recording.error());
          loaded->recording = std::make_shared<const ScanRecording>(std::move(*recording));
        }
        if (loaded->isSweep) return {};
        loaded->asks = *kind == FileKind::film;
        if (loaded->asks) return {};
        PartOfProgress most(progress, 0.0, 0.9);
        std::shared_ptr<const Volume> read;
        if (*kind == FileKind::volume && !isNifti(path)) {
          auto volume = readVolume(pathOf(path), most);
          if (!volume) return passOn(volume.error());
          // A file that has to be asked about (a time step, a unit that is none or another) goes the way of all others that have.
          if (volume->timeSteps > 1 || !volume->spacingProblem.empty() ||
              !questionAboutVoxels(pathOf(path), volume->volume.grid.spacing_mm).empty()) {
            const auto asking = importFile(pathOf(path), {}, most);
            if (!asking) loaded->question = asking.error().message;
            loaded->asks = true;
            return {};
          }
          loaded->notes = std::move(volume->notes);
          loaded->warnings = std::move(volume->warnings);
          read = std::make_shared<const Volume>(std::move(volume->volume));
        } else {
          auto made = importFile(pathOf(path), {}, most);
          if (!made && askedFor(made.error()).empty()) return passOn(made.error());
          if (!made) loaded->question = made.error().message;
          loaded->asks = !made || !made->volume;
          if (loaded->asks) return {};
          loaded->notes = std::move(made->notes);
          loaded->warnings = std::move(made->warnings);
          for (Message& sentence : sentencesOf(made->removed)) loaded->notes.push_back(std::move(sentence));
          read = std::make_shared<const Volume>(std::move(*made->volume));
        }
        PartOfProgress rest(progress, 0.9, 1.0);
        auto voxels = ScanVoxels::of(std::move(read), rest);
        if (!voxels) return passOn(voxels.error());
        loaded->voxels = std::move(*voxels);
        return {};
      },
      [this, loaded, path] {
        if (loaded->recording) {
          Q_EMIT recordingOpened(path, loaded->recording);
          return;
        }
        if (loaded->isSweep) {
          Q_EMIT sweepChosen(path);
          return;
        }
        if (loaded->asks) {
          Q_EMIT answersNeeded(path, loaded->kind, words(loaded->question));
          return;
        }
        if (!mayReplace_(QFileInfo(path).fileName())) return;
        messages_.forgetWhatIsPast();
        document_.close();
        showVolume(loaded->voxels, QFileInfo(path).fileName(), false, nullptr, {pathOf(path)});
        tellOpened(path, loaded->notes, loaded->warnings);
        Q_EMIT opened(path);
      });
}

void Opener::showVolume(const ScanVoxels& voxels, const QString& title, bool keepPlace, std::shared_ptr<const Provenance> provenance,
                        std::vector<fs::path> madeFrom) {
  const Grid& own = voxels.grid();
  if (auto usable = checkGrid(own); !usable) {
    messages_.showError(usable.error());
    return;
  }
  ScanSubject subject = subjectOf(voxels, title.toStdString());
  subject.placedGrid = inMiddleOfTrunk(own, *view_.skin());
  if (keepPlace) {
    const glm::dvec3 centre_mm = centreOf(own);
    const Skin::Contact nearest = view_.skin()->nearest(centre_mm);
    if (glm::dot(centre_mm - nearest.point_mm, nearest.outward) < 0.0) subject.placedGrid = own;
  }
  PlacingShape shape = placingShapeOf(own, {});
  if (provenance && voxels.volume()) {
    // A recording knows its beams: it lies on the skin as its own probe saw it, and not as its tracker's axes happen to lie.
    const auto known = landmarksOf({});
    const PlacingSite* const site = known ? siteFor(*known, {}) : nullptr;
    if (auto place = site == nullptr ? std::nullopt : firstPlaceOf(*voxels.volume(), *provenance, *view_.skin(), *site)) {
      subject.placedGrid = placed(own, place->fileToWorld);
      subject.startPose = place->start;
      shape = std::move(place->shape);
    }
  }
  if (provenance) madeFrom.push_back(provenance->sweep);
  shownFrom_ = std::move(madeFrom);
  patient_.reset();
  subject.provenance = std::move(provenance);
  showsCase_ = false;
  startTaken_ = false;
  session_.show(std::move(subject));
  session_.console().setNeutral();
  lookAtWhole(shape);
  takeStart();
}

std::vector<fs::path> Opener::sources() const {
  std::vector<fs::path> all = shownFrom_;
  if (const auto& opened = document_.current()) {
    all.push_back(opened->folder / "case.json");
    for (const std::string& named :
         {opened->volume.file, opened->volume.labels, opened->volume.frames, opened->volume.level, opened->volume.recipe})
      if (!named.empty()) all.push_back(opened->folder / named);
    for (const std::string& named : echoFilesOf(*opened)) all.push_back(opened->folder / named);
  }
  return all;
}

void Opener::openVolume(std::shared_ptr<const Volume> volume, const QString& title, std::function<bool()> mayShow,
                        std::vector<fs::path> madeFrom) {
  if (ScanVoxels::isSmall(*volume)) {
    if (mayShow()) showVolume(ScanVoxels::asStored(std::move(volume)), title, true, nullptr, std::move(madeFrom));
    return;
  }
  auto voxels = std::make_shared<ScanVoxels>();
  startOpening(
      title, tr("Opening %1").arg(fileNameOf(title)),
      [voxels, volume = std::move(volume)](Progress& progress) -> Result<void> {
        auto made = ScanVoxels::of(volume, progress);
        if (!made) return passOn(made.error());
        *voxels = std::move(*made);
        return {};
      },
      [this, voxels, title, mayShow = std::move(mayShow), madeFrom = std::move(madeFrom)] {
        if (mayShow()) showVolume(*voxels, title, true, nullptr, madeFrom);
      });
}

void Opener::followDocument() {
  const auto& opened = document_.current();
  if (!opened) {
    contents_.reset();
    if (reloading_) giveUpOpening();
    if (showsCase_) {
      showsCase_ = false;
      session_.clear();
    }
    return;
  }
  if (!contents_) return;
  if (!(contents_->sources == sourcesOf(*opened))) {
    loadChanged(*opened);
    return;
  }
  if (reloading_ || refused_) {  // undone before it was loaded
    giveUpOpening();
    refused_.reset();
    if (showsCase_)
      session_.setLabels(contents_->read.labels);
    else
      showCaseVolume();
  }
  followEdits(*opened);
}

}  // namespace ew::ui
