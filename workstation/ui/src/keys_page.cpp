// What the page of keys (F1) says.
#include <QKeySequence>

#include "main_window_parts.h"
#include "words.h"

namespace ew::ui {
namespace {

using Group = ShortcutsOverlay::Group;

/// Keys as the system's language calls them: "Ctrl+O" is "Strg+O" in German.
QString keys(const char* names) {
  QStringList shown;
  for (const QString& name : QString::fromLatin1(names).split(QStringLiteral(" | "))) {
    shown << QKeySequence(name).toString(QKeySequence::NativeText);
  }
  return shown.join(QStringLiteral(", "));
}

std::vector<Group> keysOfTheScan() {
  return {{MainWindow::tr("Probe"),
           {{MainWindow::tr("Drag, arrows"), MainWindow::tr("slide over the skin, with Shift faster"), ProbeMotion::slide},
            {MainWindow::tr("Shift+wheel, %1").arg(keys("A | D")), MainWindow::tr("rock, along the image"), ProbeMotion::rock},
            {MainWindow::tr("Wheel, %1").arg(keys("W | S")), MainWindow::tr("tilt, out of the image"), ProbeMotion::tilt},
            {MainWindow::tr("Ctrl+wheel, %1").arg(keys("Q | E")), MainWindow::tr("rotate"), ProbeMotion::rotate},
            {keys("Home"), MainWindow::tr("back to the start")}}},
          {MainWindow::tr("Image"),
           {{keys("Space | F"), MainWindow::tr("freeze")},
            {keys("PgUp | PgDown"), MainWindow::tr("depth")},
            {keys("Ctrl+Up | Ctrl+Down"), MainWindow::tr("gain")},
            {keys("Ctrl+0"), MainWindow::tr("reset DGC")},
            {keys("Z | Shift+Z"), MainWindow::tr("zoom")},
            {MainWindow::tr("Drag in a zoomed image"), MainWindow::tr("move the detail")},
            {keys("X | U"), MainWindow::tr("invert left/right, up/down")},
            {keys("M"), MainWindow::tr("B, B + M, M")},
            {keys("Ctrl+Left | Ctrl+Right"), MainWindow::tr("M line")},
            {keys("Y | Shift+Y"), MainWindow::tr("sweep of the M-mode")}}},
          {MainWindow::tr("3D view"),
           {{MainWindow::tr("Right drag"), MainWindow::tr("turn the body")},
            {MainWindow::tr("Middle drag"), MainWindow::tr("move the body")},
            {MainWindow::tr("Ctrl+right drag"), MainWindow::tr("closer, farther")},
            {keys("Alt+1") + QStringLiteral(" … ") + keys("Alt+5"), MainWindow::tr("front, back, right, left, head")},
            {keys("Alt+0"), MainWindow::tr("look at the volume")},
            {MainWindow::tr("Double click"), MainWindow::tr("in a small window: swap body and scan")}}},
          {MainWindow::tr("Settings"),
           {{keys("F10"), MainWindow::tr("next page of the console")},
            {keys(", | ."), MainWindow::tr("focus depth")},
            {keys("N"), MainWindow::tr("number of focal zones")},
            {keys("R | Shift+R"), MainWindow::tr("dynamic range")},
            {keys("G"), MainWindow::tr("grey map")},
            {keys("B | Shift+B"), MainWindow::tr("edge enhancement")},
            {keys("P | Shift+P"), MainWindow::tr("persistence")}}},
          {MainWindow::tr("Effects and probe"),
           {{keys("F2 | F3"), MainWindow::tr("beam width, slice thickness")},
            {keys("F4"), MainWindow::tr("shadow and enhancement")},
            {keys("F5 | F6"), MainWindow::tr("reverberation, mirror images")},
            {keys("F7 | F8"), MainWindow::tr("noise, skin contact")},
            {keys("T | H"), MainWindow::tr("next transducer, next frequency")},
            {keys("J | L | V"), MainWindow::tr("steer a linear array, trapezoid")}}}};
}

Group keysOfTheWindow() {
  return {MainWindow::tr("Window"),
          {{keys("Ctrl+H"), MainWindow::tr("cases")},
           {keys("Ctrl+O"), MainWindow::tr("open")},
           {keys("Ctrl+P"), MainWindow::tr("save the image")},
           {keys("F12"), MainWindow::tr("scan only")},
           {keys("F11"), MainWindow::tr("full screen")},
           {keys("Ctrl+1 | Ctrl+2"), MainWindow::tr("Explore, Author")},
           {keys("F1"), MainWindow::tr("this page")}}};
}

Group keysOfAuthors() {
  return {MainWindow::tr("Author"),
          {{keys("Ctrl+S | Ctrl+Shift+S"), MainWindow::tr("save the case, save it elsewhere")},
           {keys("Ctrl+Z | Ctrl+Shift+Z"), MainWindow::tr("undo, redo")},
           {MainWindow::tr("%1, Alt+click").arg(keys("I")), MainWindow::tr("which frame a point came from")},
           {keys("1 | 2 | 3"), MainWindow::tr("nearest, linear, cubic")},
           {keys("Shift+N"), MainWindow::tr("focus model")},
           {keys("F9"), MainWindow::tr("adaptive quality")},
           {keys("Ctrl+K"), MainWindow::tr("performance")}}};
}

}  // namespace

void MainWindow::showKeys() {
  Parts& p = *parts_;
  if (p.shortcuts) {
    p.shortcuts->close();
    return;
  }
  // Only what acts where one is: a trainee has no panels, and a stage takes the keys of the scan.
  std::vector<Group> groups;
  if (!p.staged) groups = keysOfTheScan();
  if (p.workspace == Workspace::author) {
    for (const sdk::StagedPanel* panel : p.host->panelsAdded()) {
      if (panel->keys.empty() || !p.staged) continue;
      Group group{words(panel->title), {}};
      for (const auto& [key, what] : panel->keys) group.lines.push_back({words(key), words(what)});
      groups.push_back(std::move(group));
    }
    groups.push_back(keysOfAuthors());
  }
  groups.push_back(keysOfTheWindow());
  p.shortcuts = new ShortcutsOverlay(groups, p.central);
}

}  // namespace ew::ui
