// What the page of keys (F1) says.
#include <QKeySequence>

#include "effect_words.h"
#include "main_window_parts.h"
#include "words.h"

namespace ew::ui {
namespace {

using Group = ShortcutsOverlay::Group;

/// Keys as the system's language calls them: "Ctrl+O" is "Strg+O" in German.
QString keysOf(const char* names) {
  QStringList shown;
  for (const QString& name : QString::fromLatin1(names).split(QStringLiteral(" | "))) {
    shown << QKeySequence(name).toString(QKeySequence::NativeText);
  }
  return shown.join(QStringLiteral(", "));
}

std::vector<Group> keysOfTheScan() {
  return {{MainWindow::tr("Probe"),
           {{MainWindow::tr("Drag, arrows"), MainWindow::tr("slide over the skin, with Shift faster"), ProbeMotion::slide},
            {MainWindow::tr("Shift+wheel, %1").arg(keysOf("A | D")), MainWindow::tr("rock, along the image"), ProbeMotion::rock},
            {MainWindow::tr("Wheel, %1").arg(keysOf("W | S")), MainWindow::tr("tilt, out of the image"), ProbeMotion::tilt},
            {MainWindow::tr("Ctrl+wheel, %1").arg(keysOf("Q | E")), MainWindow::tr("rotate"), ProbeMotion::rotate},
            {keysOf("Home"), MainWindow::tr("back to the start")}}},
          {MainWindow::tr("Image"),
           {{keysOf("Space | F"), MainWindow::tr("freeze")},
            {keysOf("Ctrl+R"), MainWindow::tr("record, end recording")},
            {keysOf("K"), MainWindow::tr("mark this moment of a recording")},
            {keysOf("PgUp | PgDown"), MainWindow::tr("depth")},
            {keysOf("Ctrl+Up | Ctrl+Down"), MainWindow::tr("gain")},
            {keysOf("Ctrl+0"), MainWindow::tr("reset TGC")},
            {keysOf("Z | Shift+Z"), MainWindow::tr("zoom")},
            {MainWindow::tr("Drag in a zoomed image"), MainWindow::tr("move the detail")},
            {keysOf("C"), MainWindow::tr("breathe freely")},
            {keysOf("Shift+C | Ctrl+Shift+C"), MainWindow::tr("breathe in and hold, breathe out and hold")},
            {keysOf("X | U"), MainWindow::tr("invert left/right, up/down")},
            {keysOf("M"), MainWindow::tr("B, B + M, M")},
            {keysOf("Ctrl+Left | Ctrl+Right"), MainWindow::tr("M line")},
            {keysOf("Y | Shift+Y"), MainWindow::tr("sweep of the M-mode")}}},
          {MainWindow::tr("Frozen image"),
           {{MainWindow::tr("Wheel on the scan, arrows, %1").arg(keysOf(", | .")), MainWindow::tr("an image back, on; with Shift ten")},
            {keysOf("Home | End"), MainWindow::tr("first, last image")},
            {keysOf("C"), MainWindow::tr("play in a loop, stop")},
            {keysOf("Shift+I | Shift+O"), MainWindow::tr("the loop begins, ends with this image")}}},
          {MainWindow::tr("Measure"),
           {{keysOf("4 | 5 | 6"), MainWindow::tr("distance, poly-line, outline")},
            {keysOf("7 | 8 | 9"), MainWindow::tr("ellipse, fitted ellipse, angle")},
            {keysOf("0"), MainWindow::tr("outlines follow edges")},
            {MainWindow::tr("Drag a cross"), MainWindow::tr("move a point")},
            {MainWindow::tr("Arrows, %1").arg(keysOf("Return")), MainWindow::tr("move the cross, set a point; with Ctrl by a pixel")},
            {keysOf("Backspace | Esc"), MainWindow::tr("take back, put the tool down")},
            {keysOf("Ctrl+Del"), MainWindow::tr("delete all measurements")}}},
          {MainWindow::tr("Annotate"),
           {{MainWindow::tr("Frozen: %1").arg(keysOf("T")), MainWindow::tr("write, with words of the region")},
            {keysOf("Ctrl+T | Shift+T"), MainWindow::tr("freeze and write, draw an arrow")},
            {keysOf("Tab | Ctrl+Home"), MainWindow::tr("first word offered, home position")},
            {MainWindow::tr("Drag, double click"), MainWindow::tr("move, write anew")},
            {keysOf("Del | Backspace"), MainWindow::tr("delete what is chosen, its last word")},
            {keysOf("Ctrl+B"), MainWindow::tr("body mark")}}},
          {MainWindow::tr("3D view"),
           {{MainWindow::tr("Right drag"), MainWindow::tr("rotate the body")},
            {MainWindow::tr("Middle drag"), MainWindow::tr("move the body")},
            {MainWindow::tr("Ctrl+right drag"), MainWindow::tr("closer, farther")},
            {keysOf("Alt+1") + QStringLiteral(" … ") + keysOf("Alt+5"), MainWindow::tr("front, back, right, left, head")},
            {keysOf("Alt+0"), MainWindow::tr("look at the volume")},
            {MainWindow::tr("Double click"), MainWindow::tr("in a small window: swap body and scan")}}},
          {MainWindow::tr("Settings"),
           {{keysOf("F10"), MainWindow::tr("next page of the console")},
            {keysOf(", | ."), MainWindow::tr("focus depth")},
            {keysOf("N"), MainWindow::tr("number of focal zones")},
            {keysOf("R | Shift+R"), MainWindow::tr("dynamic range")},
            {keysOf("G"), MainWindow::tr("grey map")},
            {keysOf("B | Shift+B"), MainWindow::tr("edge enhancement")},
            {keysOf("P | Shift+P"), MainWindow::tr("persistence")}}}};
}

/// An effect and its part on one line, as their keys stand side by side.
Group keysOfEffects() {
  Group group{MainWindow::tr("Effects and probe"), {}};
  for (const EffectInfo& effect : sceneEffects()) {
    QStringList strokes, names;
    const auto add = [&](const char* keyStroke, const char* name) {
      if (*keyStroke == '\0') return;
      strokes << keysOf(keyStroke);
      names << effectText(name);
    };
    add(effect.keyStroke, effect.shortName);
    if (effect.option) add(effect.option->keyStroke, effect.option->shortName);
    if (!strokes.isEmpty()) group.lines.push_back({strokes.join(QStringLiteral(", ")), names.join(QStringLiteral(", "))});
  }
  group.lines.push_back({keysOf("T | H"), MainWindow::tr("next transducer, next frequency")});
  group.lines.push_back({keysOf("J | L | V"), MainWindow::tr("steer a linear array, trapezoid")});
  return group;
}

Group keysOfTheWindow() {
  return {MainWindow::tr("Window"),
          {{keysOf("Ctrl+H"), MainWindow::tr("cases")},
           {keysOf("Ctrl+O"), MainWindow::tr("open")},
           {keysOf("Ctrl+P"), MainWindow::tr("save the image")},
           {keysOf("F12"), MainWindow::tr("scan only")},
           {keysOf("F11"), MainWindow::tr("full screen")},
           {keysOf("Ctrl+1 | Ctrl+2"), MainWindow::tr("Explore, Author")},
           {keysOf("F1"), MainWindow::tr("this page")}}};
}

Group keysOfAuthors() {
  return {MainWindow::tr("Author"),
          {{keysOf("Ctrl+S | Ctrl+Shift+S"), MainWindow::tr("save the case, save it elsewhere")},
           {keysOf("Ctrl+Z | Ctrl+Shift+Z"), MainWindow::tr("undo, redo")},
           {MainWindow::tr("%1, Alt+click").arg(keysOf("I")), MainWindow::tr("which frame a point came from")},
           {keysOf("1 | 2 | 3"), MainWindow::tr("nearest, linear, cubic")},
           {keysOf("Shift+N"), MainWindow::tr("focus model")},
           {keysOf("F9"), MainWindow::tr("adaptive quality")},
           {keysOf("Ctrl+K"), MainWindow::tr("performance")}}};
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
  if (!p.staged) {
    groups = keysOfTheScan();
    groups.push_back(keysOfEffects());
  }
  for (const sdk::StagedPanel* panel : p.host->panelsAdded()) {
    if (panel->keys.empty() || panel->workspace != p.workspace || (p.isAuthor() && !p.staged)) continue;
    Group group{words(panel->title), {}};
    for (const auto& [key, what] : panel->keys) group.lines.push_back({words(key), words(what)});
    groups.push_back(std::move(group));
  }
  if (p.isAuthor()) groups.push_back(keysOfAuthors());
  Group window = keysOfTheWindow();
  for (const auto& own : p.ownWorkspaces)  // behind Explore and Author
    if (!own.action->shortcut().isEmpty())
      window.lines.insert(window.lines.end() - 1,
                          ShortcutsOverlay::Line{own.action->shortcut().toString(QKeySequence::NativeText), words(own.what.title)});
  groups.push_back(std::move(window));
  Group tools{MainWindow::tr("Tools"), {}};
  for (const auto& tool : p.tools)
    if (tool.action->isEnabled() && !tool.action->shortcut().isEmpty())
      tools.lines.push_back({tool.action->shortcut().toString(QKeySequence::NativeText), tool.action->text().remove(QLatin1Char('&'))});
  if (!tools.lines.empty()) groups.push_back(std::move(tools));
  p.shortcuts = new ShortcutsOverlay(groups, p.central);
}

}  // namespace ew::ui
