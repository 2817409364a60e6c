#include "window/frame/undo.h"

#include "ew/sdk/host.h"
#include "ew/widgets/words.h"
#include "window/frame/commands.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {

void Undo::addMenu(QMenu& edit) {
  undo_ = parts_.commands->add(edit, "undo", [this] { undo(); });
  redo_ = parts_.commands->add(edit, "redo", [this] { redo(); });
  undo_->setEnabled(false);
  redo_->setEnabled(false);
}

void Undo::connectParts() { connect(&parts_.document, &CaseDocument::stepped, this, &Undo::refresh); }

bool Undo::editsCalipers() const {
  const measurement::CaliperDrawing& drawing = parts_.calipers.drawing();
  if (parts_.workspaces->isStaged() || !(drawing.canUndo() || drawing.canRedo())) return false;
  return !parts_.workspaces->isAuthor() || parts_.caliperLayer->hasFocus() || parts_.stripCaliperLayer->hasFocus();
}

bool Undo::editsAnnotations() const {
  const annotation::AnnotationList& list = parts_.annotated.list();
  if (parts_.workspaces->isStaged() || !(list.canUndo() || list.canRedo())) return false;
  if (parts_.workspaces->isAuthor() && !parts_.annotationLayer->isWriting() && parts_.annotated.selected() == 0) return false;
  return parts_.annotated.wasWrittenLast() || !editsCalipers();
}

void Undo::undo() {
  if (editsAnnotations())
    parts_.annotated.change([](annotation::AnnotationList& list) { list.undo(); });
  else if (editsCalipers())
    parts_.calipers.change([](measurement::CaliperDrawing& drawing) { drawing.undo(); });
  else if (const auto document = parts_.workspaces->panelDocument())
    document->undo();
  else
    parts_.document.undo();
}

void Undo::redo() {
  if (editsAnnotations())
    parts_.annotated.change([](annotation::AnnotationList& list) { list.redo(); });
  else if (editsCalipers())
    parts_.calipers.change([](measurement::CaliperDrawing& drawing) { drawing.redo(); });
  else if (const auto document = parts_.workspaces->panelDocument())
    document->redo();
  else
    parts_.document.redo();
}

void Undo::refresh() {
  WindowParts& p = parts_;
  const History<Case>& history = p.document.history();
  const auto document = p.workspaces->panelDocument();
  QString undo = document != nullptr ? words(document->undoText()) : words(history.undoName());
  QString redo = document != nullptr ? words(document->redoText()) : words(history.redoName());
  bool canUndo = document != nullptr ? !undo.isEmpty() : history.canUndo();
  bool canRedo = document != nullptr ? !redo.isEmpty() : history.canRedo();
  if (editsAnnotations()) {
    canUndo = p.annotated.list().canUndo();
    canRedo = p.annotated.list().canRedo();
    undo = canUndo ? tr("writing on the image") : QString();
    redo = canRedo ? tr("writing on the image") : QString();
  } else if (editsCalipers()) {
    canUndo = p.calipers.drawing().canUndo();
    canRedo = p.calipers.drawing().canRedo();
    undo = canUndo ? tr("measuring") : QString();
    redo = canRedo ? tr("measuring") : QString();
  }
  undo_->setEnabled(canUndo);
  redo_->setEnabled(canRedo);
  undo_->setText(undo.isEmpty() ? tr("&Undo") : tr("&Undo: %1").arg(undo));
  redo_->setText(redo.isEmpty() ? tr("&Redo") : tr("&Redo: %1").arg(redo));
  p.status->setEdit(undo.isEmpty() ? QString() : tr("Undo: %1 (%2)").arg(undo, p.keys.words("undo")));
  p.status->setNote(document != nullptr ? words(document->note()) : QString());
}

}  // namespace ew::ui
