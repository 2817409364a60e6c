#include "panel/mosaic.h"

#include <QApplication>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "ew/core/output_set.h"
#include "ew/widgets/words.h"
#include "logic/case_volume.h"
#include "panel/notices.h"
#include "panel/project_document.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;

/// How the files of a result end in a case, in the order of ResultFiles::kNames.
constexpr std::array<const char*, 5> kEndings = {".mha", "-coverage.mha", "-source.mha", "-level.mha", "-provenance.json"};
static_assert(kEndings.size() == ResultFiles::kNames.size());

/// Copies the files of a result beside each other into a case, all or none.
Result<void> putIntoCase(const ResultPaths& result, const fs::path& caseFolder, const std::string& name, Progress& progress) {
  const fs::path volumes = caseFolder / "volumes";
  OutputSet outputs;
  if (auto made = outputs.announceFolder(volumes); !made) return made;
  std::error_code error;
  for (std::size_t n = 0; n < result.size(); ++n)
    if (!result[n].empty())
      if (auto announced = outputs.announce(volumes / (name + kEndings[n])); !announced) return announced;
  for (std::size_t n = 0; n < result.size(); ++n) {
    if (result[n].empty()) continue;
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Saving was cancelled.">());
    const fs::path target = volumes / (name + kEndings[n]);
    fs::copy_file(result[n], outputs.staged(target), error);
    if (error)
      return failure(ErrorCode::notWritable, say<"'%1' cannot be written (%2); choose another folder.">(target, error.message()),
                     {{"file", target.string()}});
    progress.report(say<"Copying">(), static_cast<double>(n + 1) / static_cast<double>(result.size()));
  }
  return outputs.commit();
}

/// What was written for a case that does not use it after all.
void takeOutOfCase(const fs::path& caseFolder, const std::string& name) {
  std::error_code ignored;
  for (const char* ending : kEndings) fs::remove(caseFolder / "volumes" / (name + ending), ignored);
  if (fs::is_empty(caseFolder / "volumes", ignored)) fs::remove(caseFolder / "volumes", ignored);
}

/// Asks a question whose other answer is to cancel. @return true: with `answer`
bool isAnswered(QMessageBox& question, QPushButton* answer, const char* name) {
  answer->setObjectName(QLatin1String(name));
  auto* cancel = question.addButton(QMessageBox::Cancel);
  question.setDefaultButton(cancel);
  question.setEscapeButton(cancel);
  question.exec();
  return question.clickedButton() == answer;
}

}  // namespace

Mosaic::Mosaic(sdk::Host& host, Notices& notices, const ProjectDocument& document) : host_(host), notices_(notices), document_(document) {}

const StitchProject& Mosaic::project() const { return document_.project(); }

void Mosaic::take(std::shared_ptr<const Volume> volume, const ChainState& state, const StitchProject& asked) {
  volume_ = std::move(volume);
  files_ = {state.volume, state.coverage, state.source, state.level, state.provenance};
  asked_ = asked;
}

void Mosaic::forget() {
  volume_.reset();
  files_ = {};
  asked_ = {};
}

void Mosaic::moveFiles(const fs::path& before, const fs::path& after) {
  for (fs::path& path : files_)
    if (!path.empty()) path = after / path.lexically_relative(before);
}

bool Mosaic::isFresh() const { return volume_ && asked_ == project(); }

void Mosaic::saveIn(const fs::path& folder) {
  if (!volume_) {
    Q_EMIT notices_.problem(tr("There is no stitched volume yet; run 'Compute mosaic' first."));
    return;
  }
  const auto seen = ResultFiles::look(folder, {}, noProgress());
  if (!seen) return notices_.say(seen.error());
  const QStringList foreign = [&] {
    QStringList all;
    for (const std::string& name : seen->foreign()) all << words(name);
    return all;
  }();
  if (!foreign.isEmpty() && !mayReplace(folder, foreign)) return;
  const QPointer<Mosaic> here(this);
  host_.jobs().startSaving(
      tr("Saving the stitched volume").toStdString(),
      [folder, parts = files_, asked = project(), mayReplaceAll = !foreign.isEmpty()](Progress& progress) -> Result<void> {
        return copyResult(parts, asked, folder, mayReplaceAll, progress);
      },
      [here, folder](const Result<void>& outcome) {
        Mosaic* mosaic = here.data();
        if (mosaic == nullptr) return;
        if (!outcome) return mosaic->notices_.say(outcome.error());
        Q_EMIT mosaic->notices_.said(
            tr("Saved in %1: volume.mha, coverage.mha, source.mha, level.mha and provenance.json.").arg(words(folder.string())));
      });
}

bool Mosaic::isCaseOpen() const { return host_.cases().current().has_value() && !host_.cases().currentFolder().empty(); }

void Mosaic::handToCase() {
  if (!volume_) {
    Q_EMIT notices_.problem(tr("There is no stitched volume yet; run 'Compute mosaic' first."));
    return;
  }
  auto& cases = host_.cases();
  if (!isCaseOpen()) {
    Q_EMIT notices_.problem(tr("No case is open that could take the volume; open one (Ctrl+O) or save the volume as a file."));
    return;
  }
  const auto nextName = [&cases] {  // volumes are never written over: an older attempt or another case may still speak of them
    const auto isTaken = [&cases](const std::string& name) {
      std::error_code ignored;
      return std::any_of(kEndings.begin(), kEndings.end(),
                         [&](const char* ending) { return fs::exists(cases.currentFolder() / "volumes" / (name + ending), ignored); });
    };
    std::string name = "stitched";
    for (int n = 2; isTaken(name); ++n) name = "stitched-" + std::to_string(n);
    return name;
  };
  // Everything that somebody has to decide or mend is asked before anything is written.
  const CaseWithVolume next = caseWith(nextName());
  if (!next.problems.empty()) return notices_.say(next.problems.front());
  if ((next.targets + next.measurements > 0 || next.hadLabels || next.hadFrames) && !mayDropTargets(next)) return;
  // A case that belongs to the program is copied first: nothing is written into its own folder.
  if (const auto own = cases.makeOwn(); !own) {
    if (own.error().code != ErrorCode::cancelled) notices_.say(own.error());
    return;
  }
  writeIntoCase(cases.currentFolder(), nextName());
}

CaseWithVolume Mosaic::caseWith(const std::string& name) {
  auto& cases = host_.cases();
  const Case opened = *cases.current();
  VolumeForCase volume{"volumes/" + name + kEndings[0], "volumes/" + name + kEndings[3], {}};
  const std::string& before = opened.volume.file;
  if (!before.empty() && volume_)
    if (const auto seen = host_.volumes().inspect(cases.currentFolder() / before); seen && !seen->sweep)
      volume.grids = {seen->grid, volume_->grid};
  return caseWithVolume(opened, volume, [&cases](const Case& each) { return cases.check(each); });
}

QString Mosaic::titleOfCase() const {
  const auto opened = host_.cases().current();
  return opened ? words(opened->title) : QString();
}

void Mosaic::writeIntoCase(const fs::path& caseFolder, const std::string& name) {
  const QPointer<Mosaic> here(this);
  host_.jobs().startSaving(
      tr("Adding the volume to the case").toStdString(),
      [parts = files_, caseFolder, name](Progress& progress) -> Result<void> { return putIntoCase(parts, caseFolder, name, progress); },
      [here, caseFolder, name](const Result<void>& outcome) {
        if (Mosaic* mosaic = here.data()) {
          if (!outcome) return mosaic->notices_.say(outcome.error());
          mosaic->useInCase(caseFolder, name);
        }
      });
}

void Mosaic::useInCase(const fs::path& caseFolder, const std::string& name) {
  auto& open = host_.cases();
  if (!open.current() || open.currentFolder() != caseFolder) {
    takeOutOfCase(caseFolder, name);
    Q_EMIT notices_.problem(tr("Another case was opened meanwhile; no case was changed."));
    return;
  }
  const CaseWithVolume next = caseWith(name);
  const bool wasSaved = !open.hasUnsavedChanges();
  if (auto edited = open.edit(next.edited, tr("use the stitched volume").toStdString(), {}); !edited) {
    takeOutOfCase(caseFolder, name);
    return notices_.say(edited.error());
  }
  QString sentence = tr("The case '%1' now uses volumes/%2.mha.").arg(titleOfCase(), words(name));
  if (next.isMoved)
    sentence += QLatin1Char(' ') + tr("It was recorded elsewhere than the volume before and was put where that lay; check it in the panel "
                                      "Place.");
  if (wasSaved) {
    if (auto saved = open.save(); !saved) return notices_.say(saved.error());  // the case is as edited, and not saved
  } else {
    sentence += QLatin1Char(' ') + tr("It had unsaved changes before; save the case to keep them all.");
  }
  Q_EMIT notices_.said(sentence);
}

bool Mosaic::mayReplace(const fs::path& folder, const QStringList& names) {
  QMessageBox question(QApplication::activeWindow());
  question.setObjectName(QStringLiteral("replaceQuestion"));
  question.setIcon(QMessageBox::NoIcon);
  question.setText(tr("%1 lies in %2 already and was not saved there by this program. Replace it?", nullptr)
                       .arg(names.join(QStringLiteral(", ")), words(folder.string())));
  return isAnswered(question, question.addButton(tr("Replace"), QMessageBox::DestructiveRole), "replaceFiles");
}

bool Mosaic::mayDropTargets(const CaseWithVolume& next) {
  QMessageBox question(QApplication::activeWindow());
  question.setObjectName(QStringLiteral("dropTargetsQuestion"));
  question.setIcon(QMessageBox::NoIcon);
  question.setText((next.hadRecipe ? tr("The patient of the case '%1' is a recipe, and the stitched volume takes its place.")
                                   : tr("The stitched volume takes the place of the volume of the case '%1'."))
                       .arg(titleOfCase()));
  QStringList lost;
  if (next.hadLabels) lost << tr("the structures painted in it");
  if (next.hadFrames) lost << tr("the recorded images it was made of");
  if (next.targets > 0) lost << tr("%n targets", nullptr, static_cast<int>(next.targets));
  if (next.measurements > 0) lost << tr("%n measurements", nullptr, static_cast<int>(next.measurements));
  question.setInformativeText(
      (next.hadRecipe ? tr("What only the recipe knew goes with it: %1.") : tr("What only that volume knew goes with it: %1."))
          .arg(lost.join(QStringLiteral(", "))) +
      QLatin1Char(' ') + tr("To keep this case as it is, save it under another name first."));
  return isAnswered(question, question.addButton(tr("Replace the volume"), QMessageBox::AcceptRole), "dropTargets");
}

}  // namespace ew::stitching
