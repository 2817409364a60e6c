// What the page of keys (F1) says.
#include <QKeySequence>
#include <set>

#include "keys/effect_words.h"
#include "widgets/words.h"
#include "window/main_window_parts.h"

namespace ew::ui {
namespace {

using Group = ShortcutsOverlay::Group;

/// Collects lines that name commands, several on one where they belong together; what no line names gets one of its own as soon as it has a
/// key, so that the page is whole whatever the user chose.
class Page {
 public:
  explicit Page(const KeyMap& keys) : keys_(keys) {}

  void begin(KeyGroup group) {
    group_ = group;
    now_ = {titleOf(group), {}};
  }
  /// @param mouse what does the same, "Wheel, %1"; empty: keys alone
  void add(const std::string& commands, const QString& what, const QString& mouse = {}, ProbeMotion motion = ProbeMotion::none) {
    for (const QString& each : QString::fromStdString(commands).split(QStringLiteral(" | "))) named_.insert(each.toStdString());
    const QString words = keys_.words(commands);
    if (mouse.isEmpty() && words.isEmpty()) return;
    now_.lines.push_back({mouse.isEmpty() ? words : mouse.contains(QStringLiteral("%1")) ? mouse.arg(words) : mouse, what, motion});
  }
  void addMouse(const QString& mouse, const QString& what) { now_.lines.push_back({mouse, what}); }
  /// Where the arrows are as they were they are called so.
  [[nodiscard]] bool areUsual(const std::string& commands) const {
    for (const QString& each : QString::fromStdString(commands).split(QStringLiteral(" | ")))
      if (!keys_.hasUsualKeys(each.toStdString())) return false;
    return true;
  }
  void end() {
    for (const KeyCommand& each : keys_.commands())
      if (each.group == group_ && !named_.contains(each.id)) add(each.id, each.name());
    if (!now_.lines.empty()) groups_.push_back(std::move(now_));
  }
  [[nodiscard]] std::vector<Group> takeGroups() { return std::move(groups_); }
  void put(Group group) { groups_.push_back(std::move(group)); }

 private:
  const KeyMap& keys_;
  KeyGroup group_ = KeyGroup::window;
  Group now_;
  std::set<std::string> named_;
  std::vector<Group> groups_;
};

void addScan(Page& page) {
  page.begin(KeyGroup::probe);
  const std::string slide = "hand.left | hand.right | hand.up | hand.down";
  page.add(slide, MainWindow::tr("slide over the skin, with Shift faster"),
           page.areUsual(slide) ? MainWindow::tr("Drag, arrows") : MainWindow::tr("Drag, %1"), ProbeMotion::slide);
  page.add("hand.rockLeft | hand.rockRight", MainWindow::tr("rock, along the image"), MainWindow::tr("Shift+wheel, %1"), ProbeMotion::rock);
  page.add("hand.tiltForward | hand.tiltBack", MainWindow::tr("tilt, out of the image"), MainWindow::tr("Wheel, %1"), ProbeMotion::tilt);
  page.add("hand.rotateLeft | hand.rotateRight", MainWindow::tr("rotate"), MainWindow::tr("Ctrl+wheel, %1"), ProbeMotion::rotate);
  page.add("hand.home", MainWindow::tr("back to the start"));
  page.end();

  page.begin(KeyGroup::image);
  page.add("freeze", MainWindow::tr("freeze"));
  page.add("record", MainWindow::tr("record, end recording"));
  page.add("record.mark", MainWindow::tr("mark this moment of a recording"));
  page.add("tracker", MainWindow::tr("tracker: what moves the probe"));
  page.add("depth.less | depth.more", MainWindow::tr("depth"));
  page.add("gain.more | gain.less", MainWindow::tr("gain"));
  page.add("tgc.reset", MainWindow::tr("reset TGC"));
  page.add("zoom.in | zoom.out", MainWindow::tr("zoom"));
  page.add("zoom.box", MainWindow::tr("magnify a box"));
  page.add("zoom.whole", MainWindow::tr("the whole image"));
  page.addMouse(MainWindow::tr("Drag in a zoomed image"), MainWindow::tr("move the detail"));
  page.add("wide", MainWindow::tr("wide image: begin, give up, hide"));
  page.add("breathing.free", MainWindow::tr("breathe freely"));
  page.add("breathing.in | breathing.out", MainWindow::tr("breathe in and hold, breathe out and hold"));
  page.add("flip.sides | flip.upsideDown", MainWindow::tr("invert left/right, up/down"));
  page.add("mode.next", MainWindow::tr("B, B + M, M"));
  page.add("pictures.count", MainWindow::tr("one, two, four pictures"));
  page.add("pictures.next", MainWindow::tr("take another picture in hand, the next one"), MainWindow::tr("Click, %1"));
  page.add("mode.lineLeft | mode.lineRight", MainWindow::tr("M line"));
  page.add("mode.slower | mode.faster", MainWindow::tr("sweep of the M-mode"));
  page.end();

  page.begin(KeyGroup::frozen);
  const std::string steps = "cine.stepBack | cine.stepOn";
  if (page.areUsual(steps)) {
    page.add("cine.back | cine.on", MainWindow::tr("an image back, on; with Shift ten"), MainWindow::tr("Wheel on the scan, arrows, %1"));
    page.add(steps, {}, {});
  }
  page.add("cine.first | cine.last", MainWindow::tr("first, last image"));
  page.add("cine.play", MainWindow::tr("play in a loop, stop"));
  page.add("cine.in | cine.out", MainWindow::tr("the loop begins, ends with this image"));
  page.end();
}

void addPictures(Page& page) {
  page.begin(KeyGroup::measure);
  using measurement::CaliperKind;
  const auto tools = [](std::initializer_list<CaliperKind> kinds) {
    std::string all;
    for (const CaliperKind kind : kinds) all += (all.empty() ? "" : " | ") + caliperCommand(kind);
    return all;
  };
  page.add(tools({CaliperKind::distance, CaliperKind::polyLine, CaliperKind::trace}), MainWindow::tr("distance, poly-line, outline"));
  page.add(tools({CaliperKind::ellipse, CaliperKind::fittedEllipse, CaliperKind::angle}), MainWindow::tr("ellipse, fitted ellipse, angle"));
  page.add(tools({CaliperKind::discs}), MainWindow::tr("volume by discs"));
  page.add(tools({CaliperKind::interval, CaliperKind::heartRate}), MainWindow::tr("time, heart rate in the strip of the M-mode"));
  page.add(tools({CaliperKind::slope, CaliperKind::depthDistance}), MainWindow::tr("slope, depth in the strip"));
  page.add("calipers.followEdges", MainWindow::tr("outlines follow edges"));
  page.add("calipers.snap", MainWindow::tr("points snap; hold Ctrl to do the opposite once"));
  page.add("calipers.combine", MainWindow::tr("combine: ratio, stenosis, volume"));
  page.addMouse(MainWindow::tr("Drag a cross"), MainWindow::tr("move a point"));
  const std::string cross = "cross.left | cross.right | cross.up | cross.down";
  if (page.areUsual(cross)) {
    page.add("cross.set", MainWindow::tr("move the cross, set a point; with Ctrl by a pixel"), MainWindow::tr("Arrows, %1"));
    page.add(cross, {}, {});
  }
  page.add("cross.takeBack | escape", MainWindow::tr("take back, put the tool down"));
  page.add("calipers.clear", MainWindow::tr("delete all measurements"));
  page.end();

  page.begin(KeyGroup::annotate);
  page.add("text.writeStill", MainWindow::tr("write, with words of the region"), MainWindow::tr("Frozen: %1"));
  page.add("text.write | text.arrow", MainWindow::tr("freeze and write, draw an arrow"));
  page.add("writing.firstWord | writing.home", MainWindow::tr("first word offered, home position"));
  page.addMouse(MainWindow::tr("Drag, double click"), MainWindow::tr("move, write anew"));
  page.add("chosen.delete | chosen.deleteWord", MainWindow::tr("delete what is chosen, its last word"));
  page.add("mark.show", MainWindow::tr("body mark"));
  page.end();

  page.begin(KeyGroup::view3d);
  page.addMouse(MainWindow::tr("Right drag"), MainWindow::tr("rotate the body"));
  page.addMouse(MainWindow::tr("Middle drag"), MainWindow::tr("move the body"));
  page.addMouse(MainWindow::tr("Ctrl+right drag"), MainWindow::tr("closer, farther"));
  page.add("look.front | look.back | look.right | look.left | look.head", MainWindow::tr("front, back, right, left, head"));
  page.add("look.volume", MainWindow::tr("look at the volume"));
  page.addMouse(MainWindow::tr("Double click"), MainWindow::tr("in a small window: swap body and scan"));
  page.end();
}

void addConsole(Page& page) {
  page.begin(KeyGroup::settings);
  page.add("console.nextPage", MainWindow::tr("next page of the console"));
  page.add("focus.shallower | focus.deeper", MainWindow::tr("focus depth"));
  page.add("focus.zones", MainWindow::tr("number of focal zones"));
  page.add("range.wider | range.narrower", MainWindow::tr("dynamic range"));
  page.add("greyMap.next", MainWindow::tr("grey map"));
  page.add("edges.more | edges.less", MainWindow::tr("edge enhancement"));
  page.add("persistence.more | persistence.less", MainWindow::tr("persistence"));
  page.add("compound.next", MainWindow::tr("directions of compounding"));
  page.end();

  // An effect and its part on one line, as their keys stand side by side.
  page.begin(KeyGroup::effects);
  for (const EffectInfo& effect : sceneEffects()) {
    const std::string command = effectCommand(effect.key);
    if (effect.option)
      page.add(command + " | " + effectCommand(effect.option->key),
               effectText(effect.shortName) + QStringLiteral(", ") + effectText(effect.option->shortName));
    else
      page.add(command, effectText(effect.shortName));
  }
  page.add("probe.next | frequency.next | harmonic", MainWindow::tr("next transducer, next frequency, harmonics"));
  page.add("steering.less | steering.more | trapezoid", MainWindow::tr("steer a linear array, trapezoid"));
  page.end();
}

void addAuthor(Page& page) {
  page.begin(KeyGroup::author);
  page.add("save | save.as", MainWindow::tr("save the case, save it elsewhere"));
  page.add("undo | redo", MainWindow::tr("undo, redo"));
  page.add("source", MainWindow::tr("which frame a point came from"), MainWindow::tr("%1, Alt+click"));
  page.add("quality.fast | quality.fine | quality.cubic", MainWindow::tr("nearest, linear, cubic"));
  page.add("focus.model", MainWindow::tr("focus model"));
  page.add("quality.adaptive", MainWindow::tr("adaptive quality"));
  page.add("cost", MainWindow::tr("performance"));
  page.end();
}

void addWindow(Page& page) {
  page.begin(KeyGroup::window);
  page.add("start", MainWindow::tr("cases"));
  page.add("open", MainWindow::tr("open"));
  page.add("save.picture", MainWindow::tr("save the image"));
  page.add("picture.store | examination", MainWindow::tr("store the image, images and archive"));
  page.add("scanOnly", MainWindow::tr("scan only"));
  page.add("fullScreen", MainWindow::tr("full screen"));
  page.add("workspace.explore | workspace.author", MainWindow::tr("Explore, Author"));
  page.add("keys", MainWindow::tr("this page"));
  page.end();
}

}  // namespace

void MainWindow::showKeys() {
  Parts& p = *parts_;
  if (p.shortcuts) {
    p.shortcuts->close();
    return;
  }
  // Only what acts where one is: a trainee has no panels, and a stage takes the keys of the scan.
  Page page(p.keys);
  if (!p.staged) {
    addScan(page);
    addPictures(page);
    addConsole(page);
  }
  for (const sdk::StagedPanel* panel : p.host->panelsAdded()) {
    if (panel->keys.empty() || panel->workspace != p.workspace || (p.isAuthor() && !p.staged)) continue;
    Group group{words(panel->title), {}};
    for (const auto& [key, what] : panel->keys) group.lines.push_back({words(key), words(what)});
    page.put(std::move(group));
  }
  if (p.isAuthor()) addAuthor(page);
  addWindow(page);
  Group tools{titleOf(KeyGroup::tools), {}};
  for (const auto& tool : p.tools)
    if (tool.action->isEnabled() && !tool.action->shortcut().isEmpty())
      tools.lines.push_back({tool.action->shortcut().toString(QKeySequence::NativeText), tool.action->text().remove(QLatin1Char('&'))});
  if (!tools.lines.empty()) page.put(std::move(tools));
  p.shortcuts = new ShortcutsOverlay(page.takeGroups(), p.central);
}

}  // namespace ew::ui
