// Texts, arrows, body mark and presets: their menus and data, and who hears of them.
#include <QFileDialog>
#include <QInputDialog>
#include <QLineEdit>
#include <algorithm>

#include "ew/library/case.h"
#include "ew/library/case_start.h"
#include "widgets/words.h"
#include "window/main_window_parts.h"

namespace ew::ui {
namespace {

const auto kPreset = QStringLiteral("preset");

/// A menu shows & as the key of an entry.
QString entry(QString text) { return text.replace(QLatin1Char('&'), QStringLiteral("&&")); }

}  // namespace

bool MainWindow::Parts::editsAnnotations() const {
  const annotation::AnnotationList& list = annotated.list();
  if (staged || !(list.canUndo() || list.canRedo())) return false;
  if (isAuthor() && !annotationLayer->isWriting() && annotated.selected() == 0) return false;
  return annotated.wasWrittenLast() || !editsCalipers();
}

void MainWindow::readAnnotationData(const std::filesystem::path& resources) {
  Parts& p = *parts_;
  if (auto lists = annotation::readWordLists(resources / "annotations"))
    p.annotated.setWordLists(std::move(*lists));
  else
    p.messages->showError(lists.error());
  if (auto marks = annotation::readBodyMarks(resources / "body_marks"))
    p.bodyMark.setMarks(std::move(*marks));
  else
    p.messages->showError(marks.error());
  if (auto presets = readPresets(resources / "presets"))
    p.presets = std::move(*presets);
  else
    p.messages->showError(presets.error());
}

void MainWindow::showRegion() {
  Parts& p = *parts_;
  const auto& opened = p.document.current();
  const bool showsCase = opened && p.opener->showsCase();
  const std::string region = showsCase ? opened->region : std::string();
  const std::string mannequin =
      showsCase && !opened->mannequin.empty() ? std::filesystem::path(opened->mannequin).stem().string() : "adult";
  p.annotated.setRegion(region);
  p.bodyMark.setFirst(showsCase ? bodyMarksOf(*opened) : std::vector<std::string>());
  p.bodyMark.setBody({region, mannequin});
}

std::vector<Preset> MainWindow::presetsOfCase() const {
  const Parts& p = *parts_;
  std::vector<Preset> offered;
  const auto& opened = p.document.current();
  if (!opened || !p.opener->showsCase()) return offered;
  const std::vector<std::string> ids = presetsOf(*opened);
  if (ids.empty()) return offered;
  const std::vector<Preset> own = readOwnPresets(ownPresetsFolder()).presets;
  for (const std::string& id : ids)
    for (const std::vector<Preset>* all : {&p.presets, &own}) {
      const auto found = std::find_if(all->begin(), all->end(), [&](const Preset& each) { return each.id == id; });
      if (found == all->end()) continue;
      offered.push_back(*found);
      break;
    }
  return offered;
}

void MainWindow::beginScanOfCase() {
  Session& session = parts_->session;
  if (session.isFrozen() || session.isPlaying() || !session.subject() || !parts_->opener->showsCase()) return;
  const std::vector<Preset> offered = presetsOfCase();
  if (const Preset* start = startPreset(session.subject()->presets, offered, session.probes()))
    takePreset(*start);
  else
    session.setNeutral();
}

void MainWindow::addAnnotateMenu(QMenu& annotate) {
  Parts& p = *parts_;
  const auto isThere = [this] { return parts_->pages->currentWidget() == parts_->workspacePage && parts_->keepsScan(); };
  p.textAction = addMenuAction(annotate, "text.write", [this, isThere] {
    if (isThere()) parts_->annotationLayer->write();
  });
  p.keyedActions.push_back({p.textAction, "text.writeStill"});
  p.arrowAction = addMenuAction(annotate, "text.arrow", [this, isThere] {
    if (isThere()) parts_->annotated.takeArrow();
    parts_->arrowAction->setChecked(parts_->annotated.isArrowAtHand());
  });
  p.arrowAction->setCheckable(true);
  QMenu* terms = annotate.addMenu(tr("Words"));
  terms->setObjectName(QStringLiteral("wordMenu"));
  connect(terms, &QMenu::aboutToShow, this, [this, terms] { addWordMenu(*terms); });
  annotate.addSeparator();
  addMenuAction(annotate, "text.homeHere", [this, isThere] {
    if (isThere()) parts_->annotationLayer->setHomeHere();
  });
  addMenuAction(annotate, "text.clear", [this] { parts_->annotated.change([](annotation::AnnotationList& list) { list.clear(); }); });
}

/// The words of the region, group by group; one that is chosen stands at the home position, or behind what is being typed.
void MainWindow::addWordMenu(QMenu& menu) {
  menu.clear();
  std::vector<const annotation::WordList*> lists = parts_->annotated.commonLists();
  if (const annotation::WordList* own = parts_->annotated.wordList()) lists.insert(lists.begin(), own);
  for (const annotation::WordList* list : lists)
    for (const annotation::TermGroup& group : list->groups) {
      QMenu* terms = menu.addMenu(entry(words(group.title)));
      for (const annotation::Term& term : group.terms) {
        const QString text = words(term.text), meaning = words(term.meaning);
        QAction* action = terms->addAction(entry(meaning.isEmpty() ? text : tr("%1: %2", "a word and what it means").arg(text, meaning)));
        connect(action, &QAction::triggered, this, [this, text] {
          if (parts_->pages->currentWidget() == parts_->workspacePage && parts_->keepsScan()) parts_->annotationLayer->write(text);
        });
      }
    }
}

void MainWindow::addBodyMarkMenu(QMenu& menu) {
  Parts& p = *parts_;
  p.bodyMarkAction = addMenuAction(menu, "mark.show", [this] { parts_->bodyMark.setShown(parts_->bodyMarkAction->isChecked()); });
  p.bodyMarkAction->setCheckable(true);
  p.bodyMarkAction->setChecked(p.bodyMark.choice().isShown);
  QAction* follows = addMenuAction(menu, "mark.follow", [this] { parts_->bodyMark.putByHand(std::nullopt); });
  menu.addSeparator();
  auto* marks = new QActionGroup(&menu);
  connect(&menu, &QMenu::aboutToShow, this, [this, &menu, marks, follows] {
    for (QAction* action : marks->actions()) delete action;
    const annotation::MarkChoice choice = parts_->bodyMark.choice();
    follows->setEnabled(choice.byHand.has_value());
    const auto add = [&](const QString& text, const std::string& mark, const std::string& variant) {
      QAction* action = addPlainAction(menu, entry(text), [this, mark, variant] { parts_->bodyMark.choose(mark, variant); });
      action->setCheckable(true);
      action->setChecked(choice.mark == mark && choice.variant == variant);
      marks->addAction(action);
    };
    add(tr("Where the probe is"), {}, {});
    for (const annotation::BodyMark* mark : parts_->bodyMark.offered()) {
      add(words(mark->title), mark->id, {});
      for (const annotation::MarkVariant& variant : mark->variants)
        add(tr("%1, %2", "a body mark and its variant").arg(words(mark->title), words(variant.title)), mark->id, variant.id);
    }
  });
}

void MainWindow::addPresetMenu(QMenu& presets) {
  presets.setObjectName(QStringLiteral("presetMenu"));
  parts_->console->setPresetMenu(presets);
  connect(&presets, &QMenu::aboutToShow, this, [this, &presets] { showPresets(presets); });
}

/// Those of the probe at hand first, then the user's own, then those of the other probes.
void MainWindow::showPresets(QMenu& menu) {
  Parts& p = *parts_;
  for (QObject* child : menu.children())  // menus within it, which clear() leaves
    if (qobject_cast<QMenu*>(child) != nullptr) child->deleteLater();
  menu.clear();
  const auto& probes = p.session.probes();
  const std::string present = p.session.probe().id;
  const auto add = [&](QMenu& into, const QString& text, const Preset& preset) {
    QAction* action = addPlainAction(into, entry(text), [this, preset] { takePreset(preset); });
    action->setData(QString::fromStdString(preset.id));
    action->setEnabled(checkPreset(preset, probes).has_value());
    action->setToolTip(QString::fromStdString(preset.source));
  };
  const auto nameOf = [&](const std::string& id) {
    const auto probe = std::find_if(probes.begin(), probes.end(), [&](const Probe& each) { return each.id == id; });
    return probe != probes.end() ? nameOfProbe(probe->name) : QString::fromStdString(id);
  };
  const auto nameWithProbe = [&](const Preset& preset) {
    return preset.probe == present ? words(preset.title)
                                   : tr("%1 (%2)", "a preset and its probe").arg(words(preset.title), nameOf(preset.probe));
  };
  for (const Preset& preset : presetsOfCase()) add(menu, nameWithProbe(preset), preset);
  if (!menu.isEmpty()) menu.addSeparator();
  for (const Preset& preset : p.presets)
    if (preset.probe == present) add(menu, words(preset.title), preset);
  const OwnPresets own = readOwnPresets(ownPresetsFolder());
  for (const Error& problem : own.problems) p.messages->showError(problem, kPreset);
  if (!own.presets.empty()) menu.addSeparator();
  for (const Preset& preset : own.presets) add(menu, nameWithProbe(preset), preset);
  menu.addSeparator();
  for (const Probe& probe : probes) {
    if (probe.id == present) continue;
    QMenu* others = menu.addMenu(entry(nameOfProbe(probe.name)));
    for (const Preset& preset : p.presets)
      if (preset.probe == probe.id) add(*others, words(preset.title), preset);
    if (others->isEmpty()) others->deleteLater();
  }
  menu.addSeparator();
  addPlainAction(menu, tr("Save as preset…"), [this] { savePreset(); });
  addPlainAction(menu, tr("Take over a preset file…"), [this] { importPreset(); });
}

void MainWindow::takePreset(const Preset& preset) {
  Parts& p = *parts_;
  Session& session = p.session;
  if (!session.subject()) return;
  if (session.isFrozen() || session.isPlaying()) {
    Q_EMIT session.changeRefused();
    return;
  }
  if (session.probe().id != preset.probe) session.chooseProbe(preset.probe);
  session.setKnobs(applied(preset, session.knobs()));
  p.annotated.chooseList(preset.annotations);
  p.bodyMark.choose(preset.bodyMark);
  p.console->showPreset(words(preset.title));
  p.scanView->say(words(preset.title));
}

void MainWindow::savePreset() {
  Parts& p = *parts_;
  bool isWanted = false;
  const QString title =
      QInputDialog::getText(this, tr("Save as preset"), tr("Name of the examination:"), QLineEdit::Normal, QString(), &isWanted);
  if (!isWanted) return;
  Preset preset = presetOf(title.trimmed().toStdString(), p.session.pictureProbe(), p.session.pictureKnobs());
  if (const annotation::WordList* list = p.annotated.wordList()) preset.annotations = list->id;
  preset.bodyMark = p.bodyMark.choice().mark;
  const auto saved = saveOwnPreset(preset, ownPresetsFolder());
  if (saved)
    p.messages->showNote(tr("Saved to %1. Give this file to others who want the same.").arg(wordsOf(*saved)), kPreset);
  else
    p.messages->showError(saved.error(), kPreset);
}

void MainWindow::importPreset() {
  Parts& p = *parts_;
  const QString file = QFileDialog::getOpenFileName(this, tr("Take over a preset file"), QString(), tr("Presets (*.json)"));
  if (file.isEmpty()) return;
  const auto preset = readPreset(pathOf(file));
  if (!preset) return p.messages->showError(preset.error(), kPreset);
  if (const auto fits = checkPreset(*preset, p.session.probes()); !fits) return p.messages->showError(fits.error(), kPreset);
  const auto saved = saveOwnPreset(*preset, ownPresetsFolder());
  if (saved)
    p.messages->showNote(tr("'%1' is now among your presets.").arg(words(preset->title)), kPreset);
  else
    p.messages->showError(saved.error(), kPreset);
}

void MainWindow::connectAnnotations() {
  Parts& p = *parts_;
  connect(&p.annotated, &AnnotatedPictures::changed, this, [this] {
    parts_->arrowAction->setChecked(parts_->annotated.isArrowAtHand());
    if (parts_->annotated.isArrowAtHand() && parts_->calipers.drawing().tool())  // one tool in the hand
      parts_->calipers.change([](measurement::CaliperDrawing& drawing) {
        while (drawing.tool()) drawing.cancel();
      });
    showHistory();
  });
  connect(&p.calipers, &Calipers::changed, this, [this] {
    if (parts_->calipers.drawing().tool()) parts_->annotated.putDown();
    parts_->bodyMarkView->raise();  // the calipers came to lie over it
    const measurement::Measurements& now = parts_->calipers.drawing().shown();
    const bool isOther = std::exchange(parts_->measuredPicture, parts_->calipers.picture()) != parts_->calipers.picture();
    if (now == parts_->measured) return;
    parts_->measured = now;
    if (!isOther) parts_->annotated.setMeasuredLast();
    showHistory();
  });
  connect(p.annotationLayer, &AnnotationLayer::writingBegan, this, [this] {
    if (parts_->calipers.drawing().tool())
      parts_->calipers.change([](measurement::CaliperDrawing& drawing) {
        while (drawing.tool()) drawing.cancel();
      });
  });
  connect(&p.annotated, &AnnotatedPictures::said, p.scanView, &ScanView::say);
  connect(&p.annotated, &AnnotatedPictures::pauseAsked, &p.calipers, &Calipers::pauseAsked);
  connect(&p.bodyMark, &ShownMark::changed, this, [this] { parts_->bodyMarkAction->setChecked(parts_->bodyMark.choice().isShown); });
}

}  // namespace ew::ui
