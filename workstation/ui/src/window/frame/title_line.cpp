#include "window/frame/title_line.h"

#include <optional>

#include "ew/library/access.h"
#include "ew/library/case.h"
#include "ew/library/new_case.h"
#include "ew/widgets/words.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {

void TitleLine::connectParts() {
  const auto refreshAll = [this] { parts_.refresh(); };
  connect(&parts_.session, &Session::subjectChanged, this, refreshAll);
  connect(&parts_.document, &CaseDocument::changed, this, refreshAll);
  connect(parts_.host, &WorkstationHost::panelDocumentChanged, this, refreshAll);
}

void TitleLine::refresh() {
  WindowParts& p = parts_;
  const auto& opened = p.document.current();
  const auto& subject = p.session.subject();
  const bool showsCase = opened && p.opener->showsCase();
  QString title = subject ? words(subject->title) : QString();
  QString remark;
  if (subject && !p.opener->showsCase()) remark = tr("a volume without a case");
  const std::optional<Case> seen = showsCase ? std::optional(shownCase(*opened, p.access)) : std::nullopt;
  p.caseInfo->showCase(seen ? &*seen : nullptr);
  const bool isAuthor = p.workspaces->isAuthor();
  if (showsCase) {
    title = words(isAuthor ? opened->title : p.caseInfo->caseWords().of(titleForTrainees(*opened)));
    remark = words(opened->patient.name);
    const auto add = [&remark](const QString& more) { remark += (remark.isEmpty() ? QString() : QStringLiteral("   ")) + more; };
    // Who explores need not know whose folder a case lies in.
    if (p.document.isShippedCase() && isAuthor) add(tr("shipped case"));
    if (p.document.isPublishedCase() && isAuthor) add(tr("published case"));
    if (p.document.lost() && isAuthor) add(tr("edited by somebody else"));
    if (p.document.hasUnsavedChanges()) add(tr("● unsaved changes"));
  }
  p.scanView->setNothing(!showsCase || !hasNoVolume(*opened) ? QString()
                         : isAuthor ? tr("This case has no volume yet. Choose 'Give the case a volume…' in the Case panel.")
                                    : tr("This case has no volume yet, so there is nothing to scan. An author gives it one in Author."));
  if (const auto document = p.workspaces->panelDocument()) {
    title = words(document->title());
    remark = words(document->remark());
  }
  const bool isStart = p.workspaces->isAtStart();
  p.topBar->setTitle(isStart ? QString() : title, isStart ? QString() : remark);
  p.window.setWindowTitle(title.isEmpty() ? QStringLiteral("EchoWeave") : QStringLiteral("%1 - EchoWeave").arg(title));
}

}  // namespace ew::ui
