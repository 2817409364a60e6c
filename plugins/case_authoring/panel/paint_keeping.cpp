// How what was painted gets into the case, and how it outlives a crash.
#include <QPointer>
#include <algorithm>
#include <utility>

#include "ew/io/volume_file.h"
#include "ew/library/content_name.h"
#include "ew/sdk/case_parts.h"
#include "ew/sdk/window.h"
#include "ew/widgets/words.h"
#include "panel/paint_work.h"

namespace ew::case_authoring {

void PaintWork::keepAside() {
  if (!hasUnkept()) return;
  if (aside_->isBusy() || isBusy_) return keepSoon_.start();
  startKeepingAside();
}

void PaintWork::rememberCase() {
  caseFolder_ = host_.cases().currentFolder();
  const auto opened = host_.cases().current();
  before_ = opened ? opened->volume.labels : std::string();
  title_ = opened ? words(opened->title) : QString();
  if (title_.isEmpty()) title_ = words(caseFolder_.filename().string());
}

void PaintWork::startKeepingAside() {
  aside_->keep({painting_->labels(), caseFolder_, before_},
               [self = QPointer<PaintWork>(this), aside = aside_, earlier = takenOver_](const Result<void>& outcome) {
                 if (outcome && earlier) PaintingAutosave::remove(*earlier);
                 if (!self || self->aside_ != aside) return;  // another case was opened meanwhile, and all of it is being kept
                 if (outcome) self->takenOver_.reset();
                 if (!outcome) self->say(outcome.error());
               });
}

/// What is not kept in its case is kept aside for whoever opens that again.
void PaintWork::part(const std::shared_ptr<KeepingAside>& aside) {
  auto parted = std::make_shared<Parted>(Parted{{painting_->labels(), caseFolder_, before_}, aside, takenOver_, title_});
  aside->startWith(starting(true));
  parted_.push_back(parted);
  keepParted(parted);
}

void PaintWork::keepParted(const std::shared_ptr<Parted>& parted) {
  parted->isTried = true;
  parted->aside->keep(parted->painted, [self = QPointer<PaintWork>(this), parted](const Result<void>& outcome) {
    if (outcome && parted->earlier) PaintingAutosave::remove(*parted->earlier);
    if (outcome || !self) parted->aside->leave();
    if (self) self->settle(parted, outcome);
  });
  if (onChanged) onChanged();
}

void PaintWork::settle(const std::shared_ptr<Parted>& parted, const Result<void>& outcome) {
  if (outcome) {
    std::erase(parted_, parted);
    host_.window().warn(tr("What was painted was not kept in its case; it is offered when that is opened again.").toStdString(),
                        "painting");
    const auto folder = host_.cases().currentFolder();  // its own again, perhaps
    if (!painting_) left_ = folder.empty() ? std::nullopt : aside_->kept().leftFor(folder);
  } else {
    parted->isTried = false;
    QStringList sentences;
    if (outcome.error().code != ErrorCode::cancelled) {
      host_.log().warn(outcome.error().sentence());
      sentences << words(outcome.error().message);
    }
    sentences << tr("What was painted in '%1' lies in this window alone and is lost when that closes. Open the case again to go on with "
                    "it, or try again on the page Targets.")
                     .arg(parted->title);
    host_.window().error(sentences.join(QLatin1Char(' ')).toStdString(), "painting");
  }
  if (onChanged) onChanged();
}

void PaintWork::drop(const std::shared_ptr<Parted>& parted) {
  parted->aside->forget();
  if (parted->earlier) PaintingAutosave::remove(*parted->earlier);
  std::erase(parted_, parted);
  if (onChanged) onChanged();
}

std::shared_ptr<PaintWork::Parted> PaintWork::unkeptHere() const {
  const auto found = std::find_if(parted_.begin(), parted_.end(), [folder = host_.cases().currentFolder()](const auto& each) {
    return !each->isTried && each->painted.caseFolder == folder;
  });
  return found == parted_.end() ? nullptr : *found;
}

std::shared_ptr<PaintWork::Parted> PaintWork::unkeptThere() const {
  const auto found = std::find_if(parted_.begin(), parted_.end(), [folder = host_.cases().currentFolder()](const auto& each) {
    return !each->isTried && each->painted.caseFolder != folder;
  });
  return found == parted_.end() ? nullptr : *found;
}

QString PaintWork::unkeptElsewhere() const {
  const auto parted = unkeptThere();
  return parted ? parted->title : QString();
}

void PaintWork::keepUnkept() {
  const auto now = parted_;  // what is kept is none of them any more
  for (const auto& each : now)
    if (!each->isTried) keepParted(each);
}

void PaintWork::discardElsewhere() {
  if (const auto parted = unkeptThere()) drop(parted);
}

QString PaintWork::closingSentence() const {
  const auto unkept = std::find_if(parted_.begin(), parted_.end(), [](const auto& each) { return !each->isTried; });
  return unkept == parted_.end() ? QString() : tr("What was painted in '%1' is kept neither in its case nor aside.").arg((*unkept)->title);
}

/// Nothing is painted any more.
void PaintWork::end() {
  keepSoon_.stop();
  take({});
  painting_.reset();
  voxels_.reset();
  aside_->forget();
  if (takenOver_) PaintingAutosave::remove(*std::exchange(takenOver_, std::nullopt));
  if (onChanged) onChanged();
}

void PaintWork::discard() {
  if (isBusy_ || !painting_) return;
  end();
  say(QString());
  if (const auto shown = host_.scan().showLabels({}); !shown) say(shown.error());
}

void PaintWork::keep() {
  if (isBusy_ || !hasUnkept()) return;
  take({});
  if (auto own = host_.cases().makeOwn(); !own) return say(own.error());
  addLabels(
      tr("Keeping the structures in the case"), [labels = painting_->labels()](Progress&) -> Result<Volume> { return labels; },
      [this](const std::string& file) {
        auto edited = host_.cases().current();
        if (!edited) return;
        edited->volume.labels = file;
        if (const auto done = host_.cases().edit(*edited, tr("Paint structures").toStdString(), {}); !done) return say(done.error());
        say(QString());
        end();
      });
}

void PaintWork::withLabelFile(std::function<void(const std::string& file)> done) {
  const auto opened = host_.cases().current();
  if (!opened || isBusy_) return;
  if (!opened->volume.labels.empty()) return done(opened->volume.labels);
  const auto scanned = host_.scan().scanned();
  const auto place = fileToWorld();
  if (!scanned || !place || !host_.cases().scan())
    return say(tr("The volume of this case is not what is scanned at the moment; choose View, Scan the case's volume."));
  auto empty = Painting::begin(*scanned, *place);
  if (!empty) return say(empty.error());
  if (auto own = host_.cases().makeOwn(); !own) return say(own.error());
  addLabels(
      tr("Preparing labels"), [labels = (*empty)->labels()](Progress&) -> Result<Volume> { return labels; }, std::move(done));
}

void PaintWork::withoutLabel(int label, std::function<void(const std::string& file)> done) {
  const auto opened = host_.cases().current();
  if (!opened || isBusy_) return;
  const auto erase = [label](Volume& labels) {
    const auto number = static_cast<std::uint8_t>(label);
    const auto box = labelling::boxOf(labels, number);
    std::replace(labels.echo.begin(), labels.echo.end(), number, std::uint8_t{0});
    return box;
  };
  const std::string file = opened->volume.labels;
  if (auto own = host_.cases().makeOwn(); !own) return say(own.error());
  if (painting_) {
    painting_->edits().edit(tr("Remove the structure").toStdString(), erase);
    painted();
  }
  addLabels(
      tr("Removing the structure"),
      [erase, from = host_.cases().currentFolder() / file](Progress& progress) -> Result<Volume> {
        auto read = readLabelVolume(from, progress);
        if (!read) return passOn(read.error());
        erase(read->volume);
        return std::move(read->volume);
      },
      std::move(done));
}

void PaintWork::addLabels(const QString& title, std::function<Result<Volume>(Progress&)> make,
                          std::function<void(const std::string& file)> done) {
  isBusy_ = true;
  if (onChanged) onChanged();
  auto file = std::make_shared<std::string>();
  const auto folder = host_.cases().currentFolder();
  host_.jobs().startSaving(
      title.toStdString(),
      [file, folder, make = std::move(make)](Progress& progress) -> Result<void> {
        PartOfProgress first(progress, 0.0, 0.5), second(progress, 0.5, 1.0);
        auto labels = make(first);
        if (!labels) return passOn(labels.error());
        auto added = addVolume(*labels, folder, second);
        if (!added) return passOn(added.error());
        *file = *added;
        return {};
      },
      [self = QPointer<PaintWork>(this), file, folder, done = std::move(done)](const Result<void>& outcome) {
        if (!self) return;
        self->isBusy_ = false;
        if (!outcome) self->say(outcome.error());
        if (outcome && self->host_.cases().currentFolder() == folder) done(*file);
        if (self->onChanged) self->onChanged();
      });
}

void PaintWork::followCase() {
  const auto folder = host_.cases().currentFolder();
  const auto scanned = host_.scan().scanned();
  if (painting_ && scanned && scanned->voxels == voxels_) {
    rememberCase();  // the same case, perhaps under another name
    keepSoon_.start();
    return;
  }
  if (painting_) {
    take({});
    keepSoon_.stop();
    const auto parting = std::exchange(aside_, newAside());
    if (hasUnkept())
      part(parting);
    else
      parting->forget();
    painting_.reset();
    voxels_.reset();
    takenOver_.reset();
  }
  left_ = folder.empty() ? std::nullopt : aside_->kept().leftFor(folder);
  if (onChanged) onChanged();
}

void PaintWork::goOnWithLeft() {
  const auto scanned = host_.scan().scanned();
  const auto place = fileToWorld();
  const auto unkept = unkeptHere();
  if ((!left_ && !unkept) || isBusy_ || painting_) return;
  if (!scanned || !place || !host_.cases().scan())
    return say(tr("The volume of this case is not what is scanned at the moment; choose View, Scan the case's volume."));
  auto labels = unkept ? Result<Volume>(unkept->painted.labels) : PaintingAutosave::read(*left_, noProgress());
  if (!labels) return say(labels.error());
  auto begun = Painting::goOn(std::move(*labels), *scanned, *place);
  if (!begun) return say(begun.error());
  painting_ = std::move(*begun);
  voxels_ = scanned->voxels;
  rememberCase();
  if (unkept) {
    aside_ = unkept->aside;
    aside_->startWith(starting(false));
    std::erase(parted_, unkept);
  }
  takenOver_ = unkept ? unkept->earlier : std::exchange(left_, std::nullopt);  // until it is kept aside by this program
  painted();
  keepAside();
}

void PaintWork::discardLeft() {
  if (const auto unkept = unkeptHere()) return drop(unkept);
  if (left_) PaintingAutosave::remove(*left_);
  left_.reset();
  if (onChanged) onChanged();
}

}  // namespace ew::case_authoring
