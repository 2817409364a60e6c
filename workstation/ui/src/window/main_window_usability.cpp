// How large the words are, and the tour.
#include <QActionGroup>
#include <QSettings>
#include <QTabBar>
#include <algorithm>

#include "widgets/theme.h"
#include "window/main_window_parts.h"
#include "window/tour.h"

namespace ew::ui {
namespace {

const auto kTextSizeSetting = QStringLiteral("textSize");
const auto kTourSetting = QStringLiteral("tourSeen");

}  // namespace

int MainWindow::keptTextSize_percent() { return QSettings().value(kTextSizeSetting, kTextSizes_percent.front()).toInt(); }

void MainWindow::addTextSizeMenu(QMenu& sizes) {
  auto* group = new QActionGroup(this);
  for (const int percent : kTextSizes_percent) {
    QAction* action = addPlainAction(sizes, tr("%1 %").arg(percent), [this, percent] { chooseTextSize(percent); });
    action->setCheckable(true);
    action->setChecked(percent == textSize_percent());
    action->setData(percent);
    group->addAction(action);
  }
  parts_->textSizes = group;
  sizes.addSeparator();
  addMenuAction(sizes, "words.larger", [this] { stepTextSize(1); });
  addMenuAction(sizes, "words.smaller", [this] { stepTextSize(-1); });
}

void MainWindow::stepTextSize(int steps) {
  const auto at = std::find(kTextSizes_percent.begin(), kTextSizes_percent.end(), textSize_percent()) - kTextSizes_percent.begin();
  const auto last = static_cast<std::ptrdiff_t>(kTextSizes_percent.size()) - 1;
  chooseTextSize(kTextSizes_percent[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at + steps, 0, last))]);
}

void MainWindow::chooseTextSize(int percent) {
  setTextSize(percent);
  QSettings().setValue(kTextSizeSetting, textSize_percent());
  for (QAction* action : parts_->textSizes->actions()) action->setChecked(action->data().toInt() == textSize_percent());
  applyTheme(currentTheme());
  refreshTheme();
  showPanels();
  showTitle();
  centralWidget()->layout()->activate();
  placeOverlays();
}

void MainWindow::offerTour() {
  if (QSettings().value(kTourSetting, false).toBool()) return;
  beginTour();
}

bool MainWindow::goToForTour(TourPlace place) {
  Parts& p = *parts_;
  if (place == TourPlace::start) {
    showStartPage();
    return true;
  }
  if (place == TourPlace::explore && !p.session.subject()) return false;  // somebody has to open something first
  setWorkspace(place == TourPlace::author ? Workspace::author : Workspace::explore);
  p.pages->setCurrentWidget(p.workspacePage);
  return true;
}

void MainWindow::beginTour() {
  Parts& p = *parts_;
  QSettings().setValue(kTourSetting, true);
  if (p.tour != nullptr) p.tour->deleteLater();
  const auto named = [this](const char* name) { return [this, name] { return findChild<QWidget*>(QLatin1String(name)); }; };
  std::vector<Tour::Step> steps;
  steps.push_back({tr("The probe on the body"),
                   tr("Drag the body's skin and the probe slides there. The wheel tilts it, with Shift it rocks, with Ctrl it rotates. "
                      "The arrow keys do the same."),
                   TourPlace::explore, [this] { return static_cast<QWidget*>(parts_->view3d); }, [this] { showColumn(Column::body); }});
  steps.push_back({tr("The scan"),
                   tr("What the probe sees, as on a machine: the marker's dot shows which side is which, the scale how deep it is, and the "
                      "sliders at the left set the gain for each depth."),
                   TourPlace::explore, [this] { return static_cast<QWidget*>(parts_->scanView); }});
  steps.push_back(
      {tr("The console"),
       tr("Gain, depth, focus, transducer and what the machine does to the sound. Every control says in a tip which key it has; "
          "%1 lists them all.")
           .arg(p.keys.words("keys")),
       TourPlace::explore, [this] { return static_cast<QWidget*>(parts_->console); }, [this] { showColumn(Column::console); }});
  steps.push_back({tr("Lessons"), tr("A case may bring lessons: find a plane, measure, answer. They are led through here, step by step."),
                   TourPlace::explore, named("panel_lessons"), [this] { showColumn(Column::panels); }});
  steps.push_back(
      {tr("The cases"),
       tr("Each card is a patient. Click one, or choose it with the arrows and open it with Enter; the line on a card shows how far "
          "its lessons are done."),
       TourPlace::start, named("caseCards")});
  steps.push_back({tr("The search"),
                   tr("Type what is looked for: a region, a lesson, a tag. Below, filters leave only one origin, region or level."),
                   TourPlace::start, named("caseSearch")});
  steps.push_back({tr("The course"), tr("Lessons in the order in which they build on each other, and the one that comes next for you."),
                   TourPlace::start, named("courseStrip")});
  steps.push_back({tr("Making cases"),
                   tr("Here cases and their lessons are made, and volumes from sweeps. The keys %1 and %2 lead back and here again.")
                       .arg(p.keys.words("workspace.explore"), p.keys.words("workspace.author")),
                   TourPlace::author, named("workspaceAuthor")});
  p.tour = new Tour(
      std::move(steps), [this](TourPlace place) { return goToForTour(place); }, p.central);
  connect(p.tour, &Tour::left, p.tour, &QObject::deleteLater);
  p.tour->begin();
}

}  // namespace ew::ui
