#include "opener.h"

#include <unistd.h>

#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "ew/io/image_stack.h"
#include "ew/io/sequence.h"
#include "ew/io/volume_file.h"
#include "hand_input.h"
#include "message_bar.h"
#include "recent_files.h"
#include "view3d.h"
#include "words.h"

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

/// The voxels in bricks, where that makes slices faster and at least half of the free memory stays free; null where not: slicing then reads
/// the volume as it is.
/// @error cancelled
Result<std::shared_ptr<const BrickedVolume>> bricksWhereThereIsRoom(const Volume& volume, Progress& progress) {
  if (!worthBricking(volume.grid.dims)) return nullptr;
  const double free_bytes = static_cast<double>(sysconf(_SC_AVPHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  constexpr int kLevels = 4;  // the coarsest an eighth as fine as the volume
  if (static_cast<double>(bricksForecast_bytes(volume.grid.dims, kLevels)) > 0.5 * free_bytes) return nullptr;
  auto bricks = bricksOf(volume.view(), kLevels, 0, progress);
  if (bricks) return std::make_shared<const BrickedVolume>(std::move(*bricks));
  if (bricks.error().code == ErrorCode::cancelled) return passOn(bricks.error());
  return nullptr;
}

/// NIfTI files often carry a geometry that means nothing: then the spacing is asked for.
bool isNifti(const QString& path) {
  return path.endsWith(QLatin1String(".nii"), Qt::CaseInsensitive) || path.endsWith(QLatin1String(".nii.gz"), Qt::CaseInsensitive);
}

const QString kOpening = QStringLiteral("open");  ///< topic of what opening something has to say

glm::dvec3 centreOf(const Grid& grid) {
  const Bounds bounds = boundsOf(grid);
  return (bounds.lowest_mm + bounds.highest_mm) / 2.0;
}

/// Where the skin lies in front of a point, seen from the front.
Skin::Contact skinInFrontOf(const Skin& skin, const glm::dvec3& p_mm) {
  const auto hit = skin.hit({p_mm.x, -2000.0, p_mm.z}, {0.0, 1.0, 0.0});
  return hit ? *hit : skin.nearest(p_mm);
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

/// What the open case is scanned as.
struct Opener::Contents {
  Sources sources;
  glm::dmat4 fileToWorld{1.0};  ///< the grids of the volumes are placed with it
  std::shared_ptr<const Volume> volume;
  std::shared_ptr<const BrickedVolume> bricks;
  std::shared_ptr<const Volume> labels;  ///< null when the case has none
  std::vector<TissueAcoustics> tissues;  ///< of the labels, as the recipe has them
};

/// What the job that loads a case hands over to the window's thread.
struct Opener::Loading {
  std::optional<Case> opened;
  Fingerprint asRead;  ///< of its manifest
  Contents contents;
  std::shared_ptr<const bridge::Mannequin> mannequin;  ///< null: the present one is the right one
  fs::path mannequinFile;
  std::vector<std::string> notes;
};

/// What the job that looks at any other file hands over.
struct Opener::Image {
  std::shared_ptr<const Volume> volume;
  std::shared_ptr<const BrickedVolume> bricks;
  std::vector<std::string> notes;
  bool isSweep = false;
  FileKind kind = FileKind::volume;
  bool asks = false;
  std::string question;
};

Opener::Opener(Session& session, CaseDocument& document, Jobs& jobs, MessageBar& messages, View3D& view, HandInput& hand, QObject* parent)
    : QObject(parent), session_(session), document_(document), jobs_(jobs), messages_(messages), view_(view), hand_(hand) {
  connect(&document_, &CaseDocument::changed, this, &Opener::followDocument);
  connect(&view_, &View3D::mannequinChanged, this, [this] {
    session_.setSkin(view_.skin());
    if (!startTaken_) {
      takeStart();
    } else if (session_.subject()) {
      showHold(movedTo(session_.hold(), view_.skin()->nearest(session_.hold().contact.point_mm)));
    }
  });
  connect(&hand_, &HandInput::holdChanged, &session_, &Session::setHold);
  connect(&session_, &Session::holdChanged, this, [this] { hand_.setHold(session_.hold()); });  // another probe is pressed on otherwise
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
        auto read = readMannequin(file, progress);
        if (!read) return passOn(read.error());
        *loaded = std::move(*read);
        return {};
      },
      [this, loaded](const Result<void>& outcome) {
        --busy_;
        if (!outcome) {
          mannequinFile_.clear();
          if (outcome.error().code != ErrorCode::cancelled) messages_.showError(outcome.error());
          return;
        }
        showMannequin(*loaded);
      });
}

void Opener::showMannequin(std::shared_ptr<const bridge::Mannequin> mannequin) {
  if (!mannequin) return;
  messages_.showNotes(tr("The mannequin was read; %n notes say how.", nullptr, static_cast<int>(mannequin->notes.size())),
                      mannequin->notes);
  view_.setMannequin(std::move(mannequin));
}

void Opener::tellOpened(const QString& path, const std::vector<std::string>& notes) {
  messages_.showNotes(
      tr("%1 is open; %n notes say how it was read.", nullptr, static_cast<int>(notes.size())).arg(QFileInfo(path).fileName()), notes,
      kOpening);
}

void Opener::open(const QString& path) {
  const QFileInfo info(path);
  if (!info.exists()) {
    const Error error{
        ErrorCode::notFound, tr("There is no file or folder '%1'; check the name, or choose it with Open.").arg(path).toStdString(), {}};
    messages_.showError(error, kOpening);
    Q_EMIT failed(error);
    return;
  }
  // The second click of a double click asks for what is already on its way.
  if (info.absoluteFilePath() == openingPath_) return;
  const bool isCaseFolder = info.isDir() && (QFileInfo::exists(path + QStringLiteral("/case.json")) || !stackFiles(pathOf(path)));
  if (isCaseFolder || info.suffix() == QLatin1String("json")) {
    openCase(path);
  } else {
    openImage(path);
  }
}

void Opener::startOpening(const QString& path, Jobs::Work work, std::function<void()> taken, std::function<void()> refused) {
  // Whoever chooses something else while a case is prepared wants that, not whatever happens to be ready last.
  giveUpOpening();
  ++busy_;
  auto id = std::make_shared<int>(0);
  *id = jobs_.start(tr("Opening %1").arg(recentFileOf(path, false).name), std::move(work),
                    [this, id, taken = std::move(taken), refused = std::move(refused)](const Result<void>& outcome) {
                      --busy_;
                      if (*id != openingJob_) return;
                      openingJob_ = 0;
                      openingPath_.clear();
                      reloading_.reset();
                      if (outcome) {
                        taken();
                      } else {
                        if (refused) refused();
                        if (outcome.error().code != ErrorCode::cancelled) messages_.showError(outcome.error(), kOpening);
                        Q_EMIT failed(outcome.error());
                      }
                      Q_EMIT ended();
                    });
  openingJob_ = *id;
  openingPath_ = QFileInfo(path).absoluteFilePath();
}

void Opener::giveUpOpening() {
  if (openingJob_ == 0) return;
  jobs_.cancel(openingJob_);
  openingJob_ = 0;
  openingPath_.clear();
  reloading_.reset();
  Q_EMIT ended();
}

Opener::Sources Opener::sourcesOf(const Case& opened) {
  Sources sources{opened.volume, opened.mannequin};
  sources.volume.fileToWorld = glm::dmat4(1.0);
  return sources;
}

/// Fills everything but `into.opened`, which says what to load.
Result<void> Opener::load(Loading& into, const fs::path& presentMannequin, Progress& progress) {
  const Case& opened = *into.opened;
  auto body = mannequinFileOf(opened);
  if (!body) return passOn(body.error());
  PartOfProgress most(progress, 0.0, 0.85);
  auto echo = loadCaseVolume(opened, most);
  if (!echo) return passOn(echo.error());
  into.notes = std::move(echo->notes);
  Contents& contents = into.contents;
  contents.sources = sourcesOf(opened);
  contents.fileToWorld = opened.volume.fileToWorld;
  contents.volume = std::make_shared<const Volume>(std::move(echo->volume));
  if (echo->labels) contents.labels = std::make_shared<const Volume>(std::move(*echo->labels));
  contents.tissues = std::move(echo->tissues);
  PartOfProgress next(progress, 0.85, 0.9);
  auto bricks = bricksWhereThereIsRoom(*contents.volume, next);
  if (!bricks) return passOn(bricks.error());
  contents.bricks = std::move(*bricks);
  if (*body != presentMannequin) {
    PartOfProgress rest(progress, 0.9, 1.0);
    auto mannequin = readMannequin(*body, rest);
    if (!mannequin) return passOn(mannequin.error());
    into.mannequin = std::move(*mannequin);
  }
  into.mannequinFile = std::move(*body);
  return {};
}

void Opener::takeContents(Loading& loaded) {
  // Until its volume is shown the session holds that of another case, which this one must not move.
  showsCase_ = false;
  contents_ = std::make_shared<const Contents>(std::move(loaded.contents));
  refused_.reset();
  mannequinFile_ = loaded.mannequinFile;
  showMannequin(loaded.mannequin);
}

void Opener::openCase(const QString& path) {
  auto loaded = std::make_shared<Loading>();
  startOpening(
      path,
      [loaded, path, present = mannequinFile_](Progress& progress) -> Result<void> {
        auto read = readCase(pathOf(path));
        if (!read) return passOn(read.error());
        loaded->opened = std::move(read->opened);
        loaded->asRead = read->manifest;
        return load(*loaded, present, progress);
      },
      [this, loaded, path] {
        if (!mayReplace_(words(loaded->opened->title))) return;
        messages_.forgetWhatIsPast();
        takeContents(*loaded);
        document_.open(*loaded->opened, loaded->asRead);
        showCaseVolume();
        tellOpened(path, loaded->notes);
        Q_EMIT opened(path);
      });
  if (const auto chosen = loadCase(pathOf(path)); chosen && caseNeedsPreparation(*chosen)) Q_EMIT preparing(path);
}

void Opener::reloadCase(const Case& edited) {
  const Sources wanted = sourcesOf(edited);
  if (reloading_ == wanted || refused_ == wanted) return;
  auto loaded = std::make_shared<Loading>();
  loaded->opened = edited;
  const QString path = wordsOf(edited.folder);
  startOpening(
      path, [loaded, present = mannequinFile_](Progress& progress) { return load(*loaded, present, progress); },
      [this, loaded, path] {
        // Edits that go on meanwhile, of the title or the placement, count; those of another volume have asked for another loading.
        const auto& now = document_.current();
        if (!now || !(sourcesOf(*now) == loaded->contents.sources)) return;
        takeContents(*loaded);
        showCaseVolume();
        tellOpened(path, loaded->notes);
      },
      [this, wanted] {
        // Nothing is scanned rather than what the case does not hold any more; "Scan the case's volume" tries again.
        refused_ = wanted;
        if (!std::exchange(showsCase_, false)) return;
        session_.clear();
      });
  openingPath_.clear();  // whoever opens the case meanwhile wants what its folder holds
  reloading_ = wanted;
  if (caseNeedsPreparation(edited)) Q_EMIT preparing(path);
}

glm::dmat4 Opener::loadedToNow() const {
  const auto& opened = document_.current();
  return opened && contents_ ? opened->volume.fileToWorld * glm::inverse(contents_->fileToWorld) : glm::dmat4(1.0);
}

void Opener::showCaseVolume() {
  const auto& opened = document_.current();
  if (!opened || !contents_) return;
  if (!(contents_->sources == sourcesOf(*opened))) {
    refused_.reset();
    reloadCase(*opened);
    return;
  }
  showsCase_ = true;
  Subject subject;
  subject.title = words(titleForTrainees(*opened));
  subject.volume = contents_->volume;
  subject.placedGrid = placed(contents_->volume->grid, loadedToNow());
  subject.bricks = contents_->bricks;
  subject.labels = contents_->labels;
  if (contents_->labels) subject.placedLabels = placed(contents_->labels->grid, loadedToNow());
  subject.scene = sceneWithTissues(opened->scene, contents_->tissues);
  subject.probes = opened->probes;
  startPose_ = opened->startPose;
  startTaken_ = false;
  session_.show(std::move(subject));
  takeStart();
}

void Opener::openImage(const QString& path) {
  auto loaded = std::make_shared<Image>();
  startOpening(
      path,
      [loaded, path](Progress& progress) -> Result<void> {
        const auto kind = kindOfFile(pathOf(path));
        if (!kind) return passOn(kind.error());
        loaded->kind = *kind;
        loaded->isSweep = *kind == FileKind::sweep;
        if (loaded->isSweep) return {};
        PartOfProgress most(progress, 0.0, 0.9);
        if (*kind == FileKind::volume && !isNifti(path)) {
          auto volume = readVolume(pathOf(path), most);
          if (!volume) return passOn(volume.error());
          loaded->notes = std::move(volume->notes);
          loaded->volume = std::make_shared<const Volume>(std::move(volume->volume));
        } else {
          auto made = importFile(pathOf(path), {}, most);
          if (!made && askedFor(made.error()).empty()) return passOn(made.error());
          if (!made) loaded->question = made.error().sentence;
          loaded->asks = !made || !made->volume;
          if (loaded->asks) return {};
          loaded->notes = std::move(made->notes);
          for (std::string& sentence : sentencesOf(made->removed)) loaded->notes.push_back(std::move(sentence));
          loaded->volume = std::make_shared<const Volume>(std::move(*made->volume));
        }
        PartOfProgress rest(progress, 0.9, 1.0);
        auto bricks = bricksWhereThereIsRoom(*loaded->volume, rest);
        if (!bricks) return passOn(bricks.error());
        loaded->bricks = std::move(*bricks);
        return {};
      },
      [this, loaded, path] {
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
        showVolume(loaded->volume, QFileInfo(path).fileName(), false, loaded->bricks);
        tellOpened(path, loaded->notes);
        Q_EMIT opened(path);
      });
}

void Opener::showVolume(std::shared_ptr<const Volume> volume, const QString& title, bool keepPlace,
                        std::shared_ptr<const BrickedVolume> bricks, std::shared_ptr<const Provenance> provenance) {
  if (auto usable = checkGrid(volume->grid); !usable) {
    messages_.showError(usable.error());
    return;
  }
  Subject subject;
  subject.title = title;
  subject.placedGrid = inMiddleOfTrunk(volume->grid, *view_.skin());
  if (keepPlace) {
    const glm::dvec3 centre_mm = centreOf(volume->grid);
    const Skin::Contact nearest = view_.skin()->nearest(centre_mm);
    if (glm::dot(centre_mm - nearest.point_mm, nearest.outward) < 0.0) subject.placedGrid = volume->grid;
  }
  subject.volume = std::move(volume);
  subject.bricks = std::move(bricks);
  subject.provenance = std::move(provenance);
  showsCase_ = false;
  startPose_.reset();
  startTaken_ = false;
  session_.show(std::move(subject));
  takeStart();
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
    reloadCase(*opened);
    return;
  }
  if (reloading_ || refused_) {  // undone before it was loaded
    giveUpOpening();
    refused_.reset();
    if (!showsCase_) showCaseVolume();
  }
  if (!showsCase_) return;
  session_.setTitle(words(titleForTrainees(*opened)));
  session_.setCaseScene(sceneWithTissues(opened->scene, contents_->tissues));
  session_.place(loadedToNow());
}

void Opener::takeStart() {
  if (!session_.subject()) return;
  const std::shared_ptr<const Skin> skin = view_.skin();
  session_.setSkin(skin);
  Hold hold;
  if (startPose_) {
    hold = holdFor(*startPose_, *skin);
  } else {
    hold.contact = skinInFrontOf(*skin, centreOf(session_.subject()->placedGrid));
    hold.press_mm = usualPress_mm(session_.probe());
  }
  // Before the mannequin is there the skin is a rough ellipsoid: the start is taken again when it comes.
  startTaken_ = view_.scene().mannequin() != nullptr;
  hand_.setStartHold(hold);
  showHold(hold);
}

void Opener::showHold(const Hold& hold) {
  hand_.setHold(hold);
  session_.setHold(hold);
}

}  // namespace ew::ui
