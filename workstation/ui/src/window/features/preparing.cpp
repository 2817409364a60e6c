#include "window/features/preparing.h"

#include <memory>
#include <utility>
#include <vector>

#include "case/case_preparation.h"
#include "ew/library/case.h"
#include "ew/library/folders.h"
#include "ew/library/preparation.h"
#include "ew/widgets/words.h"
#include "window/features/case_library.h"
#include "window/features/opening.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {
namespace {

/// Of messages about a case that is prepared behind what is open.
QString readyTopic(const std::string& caseId) { return QStringLiteral("ready ") + QString::fromStdString(caseId); }
QString draftTopic(const std::string& caseId) { return QStringLiteral("draft ") + QString::fromStdString(caseId); }

}  // namespace

void Preparing::connectParts() {
  WindowParts& p = parts_;
  connect(&p.preparation, &CasePreparation::changed, this, &Preparing::show);
  connect(&p.preparation, &CasePreparation::prepared, this, [this](const QString& caseId) {
    parts_.details.forget();
    parts_.preparation.forget();
    parts_.caseLibrary->readDetails();
    offer(caseId);
    if (const auto& shown = parts_.document.current(); shown && words(shown->id) == caseId) parts_.opener->refine();
  });
  connect(p.opener, &Opener::draftShown, this, [this] {
    const auto& shown = parts_.document.current();
    parts_.preparation.askForShown(*shown);
    if (const auto estimate = estimatePreparation(*shown))
      parts_.messages->showNote(
          tr("'%1' is shown coarsely at first and gets finer by itself, in %2.").arg(shownTitle(*shown), aboutMinutes(estimate->seconds)),
          draftTopic(shown->id));
  });
  connect(p.opener, &Opener::refined, this, [this] {
    if (const auto& shown = parts_.document.current()) parts_.messages->forget(draftTopic(shown->id));
  });
  connect(&p.preparation, &CasePreparation::failed, this, [this](const Error& error) { parts_.messages->showError(error); });
  connect(&p.preparation, &CasePreparation::noted, this, [this](const QString& note) { parts_.messages->showNote(note); });
}

void Preparing::begin() {
  // The case that is opened may be the one that would be made first here, and two at one volume wait for each other.
  waitsToBegin_ = true;
  if (!parts_.opening->isUnderWay()) openingIsRead();
}

void Preparing::openingIsRead() {
  if (!std::exchange(waitsToBegin_, false)) return;
  const auto folder = shippedCasesFolder();
  if (!folder) return;
  auto found = std::make_shared<std::vector<Case>>();
  parts_.jobs.start(
      tr("Looking for cases to prepare"),
      [found, folder = *folder](Progress&) -> Result<void> {
        *found = listCases(folder).cases;
        return {};
      },
      [this, found](const Result<void>& outcome) {
        if (outcome) parts_.preparation.start(*found);
      },
      Jobs::Kind::background);
}

void Preparing::prepareBehind(const QString& path, const CaseToMake& left) {
  WindowParts& p = parts_;
  const QString title = shownTitle(left.wanted);
  offers_[left.wanted.id] = {path, title};
  p.preparation.ask(left.wanted);
  tellBehind(left);
}

void Preparing::tellBehind(const CaseToMake& left) {
  parts_.messages->showNote(tr("'%1' is being prepared, which takes %2. What is open stays open; you are told when the case is ready.")
                                .arg(shownTitle(left.wanted), aboutMinutes(left.seconds)),
                            readyTopic(left.wanted.id));
}

void Preparing::offer(const QString& caseId) {
  const auto offer = offers_.extract(caseId.toStdString());
  if (offer.empty()) return;
  const auto& [path, title] = offer.mapped();
  parts_.messages->showOffer(
      tr("'%1' is ready.").arg(title), tr("Open"), [this, path = path] { parts_.opening->open(path); }, readyTopic(offer.key()));
}

void Preparing::show() {
  if (!parts_.workspaces->isAtStart()) return;
  for (const QString& folder : parts_.startPage->foldersInSight()) {
    const Case* shown = parts_.details.of(folder);
    if (shown == nullptr) continue;
    const auto seen = parts_.preparation.seen(*shown);
    const QString takes = aboutMinutes(seen.estimate_s);
    switch (seen.state) {
      case CasePreparation::State::ready:
        parts_.startPage->setState(folder, {}, 0.0);
        break;
      case CasePreparation::State::running:
        parts_.startPage->setState(folder, seen.step.isEmpty() ? tr("Preparing") : seen.step, seen.fraction);
        break;
      case CasePreparation::State::waiting:
        parts_.startPage->setState(folder, tr("Will be prepared, %1").arg(takes), 0.0);
        break;
      case CasePreparation::State::stopped:
        // What has no sweeps is shown at once, as a draft.
        parts_.startPage->setState(folder,
                                   shown->volume.sweeps.empty() ? tr("Coarse at first, whole in %1").arg(takes)
                                                                : tr("Not prepared yet, %1; open it to begin").arg(takes),
                                   0.0);
        break;
    }
  }
}

void Preparing::forgetOffer(const std::string& caseId) { parts_.messages->forget(readyTopic(caseId)); }

}  // namespace ew::ui
