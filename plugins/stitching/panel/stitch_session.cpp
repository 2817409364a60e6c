#include "panel/stitch_session.h"

#include <utility>

#include "ew/widgets/words.h"

namespace ew::stitching {

StitchSession::StitchSession(sdk::Host& host, std::filesystem::path folder)
    : host_(host),
      notices_(host.log()),
      document_(host, notices_, std::move(folder)),
      inputs_(host, notices_, document_),
      results_(document_, inputs_),
      mosaic_(host, notices_, document_),
      look_(document_, inputs_, results_),
      runs_(host, notices_, document_, results_, mosaic_),
      edits_(notices_, document_, results_, look_, runs_) {
  setObjectName(QStringLiteral("stitchSession"));
  connectParts();
  connectSignals();
}

/// Who follows whom. Where several follow one signal, they do so in the order of these lines.
void StitchSession::connectParts() {
  connect(&document_, &ProjectDocument::replaced, &results_, &StitchResults::forget);
  connect(&document_, &ProjectDocument::replaced, &mosaic_, &Mosaic::forget);
  connect(&document_, &ProjectDocument::replaced, &look_, &StitchLook::forget);
  connect(&document_, &ProjectDocument::fileOpened, &inputs_, &ProjectInputs::forgetFailures);
  connect(&document_, &ProjectDocument::edited, &look_, &StitchLook::followProject);
  connect(&document_, &ProjectDocument::edited, &inputs_, &ProjectInputs::readVolumes);
  connect(&document_, &ProjectDocument::edited, this, &StitchSession::tellAll);
  connect(&document_, &ProjectDocument::resultsWanted, &runs_, &StitchRuns::resume);
  connect(&document_, &ProjectDocument::workFolderChanged, &runs_, &StitchRuns::moveWork);
  connect(&inputs_, &ProjectInputs::volumesRead, &look_, &StitchLook::fit);
  connect(&inputs_, &ProjectInputs::volumesRead, &document_, &ProjectDocument::announce);
  connect(&inputs_, &ProjectInputs::mendingWanted, &look_, &StitchLook::chooseVolume);
  connect(&results_, &StitchResults::settled, &look_, &StitchLook::followResults);
  connect(&look_, &StitchLook::landmarkPicked, &edits_, &AlignmentEdits::addLandmark);
  connect(&runs_, &StitchRuns::ended, this, &StitchSession::tellAll);
}

void StitchSession::connectSignals() {
  connect(&document_, &ProjectDocument::saved, this, &StitchSession::changed);
  connect(&document_, &ProjectDocument::saved, this, &StitchSession::tellWindow);
  connect(&document_, &ProjectDocument::leftChanged, this, &StitchSession::changed);
  connect(&look_, &StitchLook::changed, this, &StitchSession::lookChanged);
  connect(&look_, &StitchLook::choiceChanged, this, &StitchSession::changed);
  connect(&look_, &StitchLook::pairChosen, this, &StitchSession::levelsChanged);
  connect(&runs_, &StitchRuns::begun, this, &StitchSession::changed);
  connect(&runs_, &StitchRuns::levelsChanged, this, &StitchSession::levelsChanged);
  connect(&edits_, &AlignmentEdits::refused, this, &StitchSession::changed);
}

void StitchSession::tellAll() {
  Q_EMIT changed();
  Q_EMIT lookChanged();
  Q_EMIT levelsChanged();
  tellWindow();
}

std::shared_ptr<void> StitchSession::onChanged(std::function<void()> callback) {
  auto kept = std::make_shared<std::function<void()>>(std::move(callback));
  callbacks_.push_back(kept);
  return kept;
}

void StitchSession::tellWindow() {
  std::erase_if(callbacks_, [](const auto& one) { return one.expired(); });
  const auto now = callbacks_;
  for (const auto& weak : now)
    if (const auto callback = weak.lock()) (*callback)();
}

std::string StitchSession::title() const {
  const auto count = static_cast<int>(document_.project().volumes.size());
  const QString name = document_.file().empty() ? QString() : words(document_.file().stem().string());
  if (count == 0 && name.isEmpty()) return tr("Stitching").toStdString();
  const QString subvolumes = count == 1 ? tr("1 subvolume") : tr("%1 subvolumes").arg(count);
  return (name.isEmpty() ? tr("Stitching: %1").arg(subvolumes) : tr("Stitching: %1, %2").arg(name, subvolumes)).toStdString();
}

std::string StitchSession::remark() const {
  if (document_.project().volumes.empty()) return {};
  return document_.hasUnsavedChanges() ? tr("not saved").toStdString() : tr("saved").toStdString();
}

std::string StitchSession::note() const { return results_.pairSummary(look_.pair()).toStdString(); }

}  // namespace ew::stitching
