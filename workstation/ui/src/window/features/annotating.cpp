#include "window/features/annotating.h"

#include <QActionGroup>
#include <QMenu>
#include <utility>

#include "ew/library/case.h"
#include "ew/library/case_start.h"
#include "ew/widgets/words.h"
#include "window/frame/commands.h"
#include "window/frame/menu_text.h"
#include "window/frame/undo.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {

void Annotating::readData(const std::filesystem::path& resources) {
  WindowParts& p = parts_;
  if (auto lists = annotation::readWordLists(resources / "annotations"))
    p.annotated.setWordLists(std::move(*lists));
  else
    p.messages->showError(lists.error());
  if (auto marks = annotation::readBodyMarks(resources / "body_marks"))
    p.bodyMark.setMarks(std::move(*marks));
  else
    p.messages->showError(marks.error());
}

void Annotating::addMenu(QMenu& annotate) {
  Commands& commands = *parts_.commands;
  text_ = commands.add(annotate, "text.write", [this] {
    if (parts_.workspaces->showsScan()) parts_.annotationLayer->write();
  });
  commands.join(text_, "text.writeStill");
  arrow_ = commands.add(annotate, "text.arrow", [this] {
    if (parts_.workspaces->showsScan()) parts_.annotated.takeArrow();
    arrow_->setChecked(parts_.annotated.isArrowAtHand());
  });
  arrow_->setCheckable(true);
  QMenu* terms = annotate.addMenu(tr("Words"));
  terms->setObjectName(QStringLiteral("wordMenu"));
  connect(terms, &QMenu::aboutToShow, this, [this, terms] { fillWordMenu(*terms); });
  annotate.addSeparator();
  commands.add(annotate, "text.homeHere", [this] {
    if (parts_.workspaces->showsScan()) parts_.annotationLayer->setHomeHere();
  });
  commands.add(annotate, "text.clear", [this] { parts_.annotated.change([](annotation::AnnotationList& list) { list.clear(); }); });
}

/// The words of the region, group by group; one that is chosen stands at the home position, or behind what is being typed.
void Annotating::fillWordMenu(QMenu& menu) {
  menu.clear();
  std::vector<const annotation::WordList*> lists = parts_.annotated.commonLists();
  if (const annotation::WordList* own = parts_.annotated.wordList()) lists.insert(lists.begin(), own);
  for (const annotation::WordList* list : lists)
    for (const annotation::TermGroup& group : list->groups) {
      QMenu* terms = menu.addMenu(menuText(words(group.title)));
      for (const annotation::Term& term : group.terms) {
        const QString text = words(term.text), meaning = words(term.meaning);
        QAction* action =
            terms->addAction(menuText(meaning.isEmpty() ? text : tr("%1: %2", "a word and what it means").arg(text, meaning)));
        connect(action, &QAction::triggered, this, [this, text] {
          if (parts_.workspaces->showsScan()) parts_.annotationLayer->write(text);
        });
      }
    }
}

void Annotating::addBodyMarkMenu(QMenu& mark) {
  Commands& commands = *parts_.commands;
  bodyMark_ = commands.add(mark, "mark.show", [this] { parts_.bodyMark.setShown(bodyMark_->isChecked()); });
  bodyMark_->setCheckable(true);
  bodyMark_->setChecked(parts_.bodyMark.choice().isShown);
  QAction* follows = commands.add(mark, "mark.follow", [this] { parts_.bodyMark.putByHand(std::nullopt); });
  mark.addSeparator();
  auto* marks = new QActionGroup(&mark);
  connect(&mark, &QMenu::aboutToShow, this, [this, &menu = mark, marks, follows] {
    for (QAction* action : marks->actions()) delete action;
    const annotation::MarkChoice choice = parts_.bodyMark.choice();
    follows->setEnabled(choice.byHand.has_value());
    const auto add = [&](const QString& text, const std::string& id, const std::string& variant) {
      QAction* action = parts_.commands->addPlain(menu, menuText(text), [this, id, variant] { parts_.bodyMark.choose(id, variant); });
      action->setCheckable(true);
      action->setChecked(choice.mark == id && choice.variant == variant);
      marks->addAction(action);
    };
    add(tr("Where the probe is"), {}, {});
    for (const annotation::BodyMark* each : parts_.bodyMark.offered()) {
      add(words(each->title), each->id, {});
      for (const annotation::MarkVariant& variant : each->variants)
        add(tr("%1, %2", "a body mark and its variant").arg(words(each->title), words(variant.title)), each->id, variant.id);
    }
  });
}

void Annotating::connectParts() {
  WindowParts& p = parts_;
  connect(&p.annotated, &ImageAnnotations::changed, this, [this] {
    arrow_->setChecked(parts_.annotated.isArrowAtHand());
    if (parts_.annotated.isArrowAtHand()) putCalipersDown();  // one tool in the hand
    parts_.undo->refresh();
  });
  connect(&p.calipers, &Calipers::changed, this, [this] {
    if (parts_.calipers.drawing().tool()) parts_.annotated.putDown();
    parts_.bodyMarkView->raise();  // the calipers came to lie over it
    const measurement::Measurements& now = parts_.calipers.drawing().shown();
    const bool isOther = std::exchange(measuredImage_, parts_.calipers.image()) != parts_.calipers.image();
    if (now == measured_) return;
    measured_ = now;
    if (!isOther) parts_.annotated.setMeasuredLast();
    parts_.undo->refresh();
  });
  connect(p.annotationLayer, &AnnotationLayer::writingBegan, this, &Annotating::putCalipersDown);
  connect(&p.annotated, &ImageAnnotations::said, p.scanView, &ScanView::say);
  connect(&p.annotated, &ImageAnnotations::pauseAsked, &p.calipers, &Calipers::pauseAsked);
  connect(&p.bodyMark, &ImageBodyMark::changed, this, [this] { bodyMark_->setChecked(parts_.bodyMark.choice().isShown); });
}

void Annotating::putCalipersDown() {
  if (!parts_.calipers.drawing().tool()) return;
  parts_.calipers.change([](measurement::CaliperDrawing& drawing) {
    while (drawing.tool()) drawing.cancel();
  });
}

void Annotating::refresh() {
  WindowParts& p = parts_;
  const auto& opened = p.document.current();
  const bool showsCase = opened && p.opener->showsCase();
  const std::string region = showsCase ? opened->region : std::string();
  const std::string mannequin =
      showsCase && !opened->mannequin.empty() ? std::filesystem::path(opened->mannequin).stem().string() : "adult";
  p.annotated.setRegion(region);
  p.bodyMark.setFirst(showsCase ? bodyMarksOf(*opened) : std::vector<std::string>());
  p.bodyMark.setBody({region, mannequin});
}

}  // namespace ew::ui
