#include "window/features/help.h"

#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <utility>
#include <vector>

#include "ew/core/version.h"
#include "plugins/plugins_dialog.h"
#include "window/features/keys_page.h"
#include "window/features/own_keys.h"
#include "window/frame/columns.h"
#include "window/frame/commands.h"
#include "window/frame/tour.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"
#include "window/layout/window_layout.h"

namespace ew::ui {
namespace {

const auto kTourSetting = QStringLiteral("tourSeen");

}  // namespace

Help::~Help() {
  delete tour_;
  delete keys_;
}

void Help::addMenu(QMenu& help) {
  Commands& commands = *parts_.commands;
  commands.add(help, "tour", [this] { beginTour(); });
  commands.add(help, "keys", [this] { showKeys(); });
  commands.add(help, "keys.edit", [this] { parts_.ownKeys->edit(); });
  commands.add(help, "plugins", [this] {
    PluginsDialog(parts_.plugins ? parts_.plugins->states() : std::vector<door::PluginStatus>{}, &parts_.window).exec();
  });
  commands.add(help, "about", [this] { showAbout(); });
}

void Help::showAbout() {
  QMessageBox about(&parts_.window);
  about.setWindowTitle(tr("About EchoWeave"));
  about.setText(
      tr("EchoWeave %1\n\nA workstation for building and using ultrasound training cases. A simulation, not for diagnosis.\n\n"
         "Apache License 2.0. Slicing and console follow D. Aiger and D. Cohen-Or, Real-Time Ultrasound Imaging Simulation, 1998.")
          .arg(QLatin1String(kVersion)));
  about.exec();
}

void Help::showKeys() {
  if (keys_) {
    keys_->close();
    return;
  }
  keys_ = new ShortcutsOverlay(keysPage(parts_), parts_.central);
}

void Help::offerTour() {
  if (QSettings().value(kTourSetting, false).toBool()) return;
  beginTour();
}

bool Help::goTo(TourPlace place) {
  WindowParts& p = parts_;
  if (place == TourPlace::start) {
    p.workspaces->showStartPage();
    return true;
  }
  if (place == TourPlace::explore && !p.session.subject()) return false;  // somebody has to open something first
  p.workspaces->show(place == TourPlace::author ? kAuthor : kExplore);
  p.pages->setCurrentWidget(p.workspacePage);
  return true;
}

bool Help::leaveTour() {
  if (tour_ == nullptr) return false;
  tour_->leave();
  return true;
}

void Help::beginTour() {
  WindowParts& p = parts_;
  QSettings().setValue(kTourSetting, true);
  if (tour_ != nullptr) tour_->deleteLater();
  const auto named = [&p](const char* name) { return [&p, name] { return p.window.findChild<QWidget*>(QLatin1String(name)); }; };
  std::vector<Tour::Step> steps;
  steps.push_back({tr("The probe on the body"),
                   tr("Drag the body's skin and the probe slides there. The wheel tilts it, with Shift it rocks, with Ctrl it rotates. "
                      "The arrow keys do the same."),
                   TourPlace::explore, [&p] { return static_cast<QWidget*>(p.view3d); }, [&p] { p.columns->show(Column::body); }});
  steps.push_back({tr("The scan"),
                   tr("What the probe sees, as on a machine: the marker's dot shows which side is which, the scale how deep it is, and the "
                      "sliders at the left set the gain for each depth."),
                   TourPlace::explore, [&p] { return static_cast<QWidget*>(p.scanView); }});
  steps.push_back(
      {tr("The console"),
       tr("Gain, depth, focus, transducer and what the machine does to the sound. Every control says in a tip which key it has; "
          "%1 lists them all.")
           .arg(p.keys.words("keys")),
       TourPlace::explore, [&p] { return static_cast<QWidget*>(p.console); }, [&p] { p.columns->show(Column::console); }});
  steps.push_back({tr("Lessons"), tr("A case may bring lessons: find a plane, measure, answer. They are led through here, step by step."),
                   TourPlace::explore, named("panel_lessons"), [&p] { p.columns->show(Column::panels); }});
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
  tour_ = new Tour(
      std::move(steps), [this](TourPlace place) { return goTo(place); }, p.central);
  connect(tour_, &Tour::left, tour_, &QObject::deleteLater);
  tour_->begin();
}

}  // namespace ew::ui
