#include "window/features/keys_page.h"

#include <QCoreApplication>
#include <QKeySequence>
#include <set>
#include <utility>

#include "ew/widgets/words.h"
#include "keys/effect_words.h"
#include "keys/key_map.h"
#include "keys/key_table.h"
#include "window/features/plugin_hosting.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {
namespace {

using Group = ShortcutsOverlay::Group;

/// Gives the page's words to the translators.
struct KeysPage {
  Q_DECLARE_TR_FUNCTIONS(ew::ui::KeysPage)
};

/// As a line on its own begins, in whatever language.
QString capitalised(const QString& what) { return what.left(1).toUpper() + what.mid(1); }

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
    leaveOut(commands);
    const QString words = keys_.words(commands);
    if (mouse.isEmpty() && words.isEmpty()) return;
    now_.lines.push_back({mouse.isEmpty()                        ? words
                          : mouse.contains(QStringLiteral("%1")) ? mouse.arg(words)
                                                                 : mouse,
                          capitalised(what), motion});
  }
  void addMouse(const QString& mouse, const QString& what) { now_.lines.push_back({mouse, capitalised(what)}); }
  /// Commands that another line has told already, or that are of no use here: they get none of their own.
  void leaveOut(const std::string& commands) {
    for (const QString& each : QString::fromStdString(commands).split(QStringLiteral(" | "))) named_.insert(each.toStdString());
  }
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
  page.add(slide, KeysPage::tr("slide over the skin, with Shift faster"),
           page.areUsual(slide) ? KeysPage::tr("Drag, arrows") : KeysPage::tr("Drag, %1"), ProbeMotion::slide);
  page.add("hand.rockLeft | hand.rockRight", KeysPage::tr("rock, along the image"), KeysPage::tr("Shift+wheel, %1"), ProbeMotion::rock);
  page.add("hand.tiltForward | hand.tiltBack", KeysPage::tr("tilt, out of the image"), KeysPage::tr("Wheel, %1"), ProbeMotion::tilt);
  page.add("hand.rotateLeft | hand.rotateRight", KeysPage::tr("rotate"), KeysPage::tr("Ctrl+wheel, %1"), ProbeMotion::rotate);
  page.add("hand.home", KeysPage::tr("back to the start"));
  page.end();

  page.begin(KeyGroup::image);
  page.add("freeze", KeysPage::tr("freeze"));
  page.add("record", KeysPage::tr("record, end recording"));
  page.add("record.mark", KeysPage::tr("mark this moment of a recording"));
  page.add("tracker", KeysPage::tr("tracker: what moves the probe"));
  page.add("depth.less | depth.more", KeysPage::tr("depth"));
  page.add("gain.more | gain.less", KeysPage::tr("gain"));
  page.add("tgc.reset", KeysPage::tr("reset TGC"));
  page.add("zoom.in | zoom.out", KeysPage::tr("zoom"));
  page.add("zoom.box", KeysPage::tr("magnify a box"));
  page.add("zoom.whole", KeysPage::tr("the whole image"));
  page.addMouse(KeysPage::tr("Drag in a zoomed image"), KeysPage::tr("move the detail"));
  page.add("wide", KeysPage::tr("wide image: begin, give up, hide"));
  page.add("breathing.free", KeysPage::tr("breathe freely"));
  page.add("breathing.in | breathing.out", KeysPage::tr("breathe in and hold, breathe out and hold"));
  page.add("flip.sides | flip.upsideDown", KeysPage::tr("invert left/right, up/down"));
  page.add("mode.next", KeysPage::tr("B, B + M, M"));
  page.add("pictures.count", KeysPage::tr("one, two, four images"));
  page.add("pictures.next", KeysPage::tr("take another image in hand, the next one"), KeysPage::tr("Click, %1"));
  page.add("mode.lineLeft | mode.lineRight", KeysPage::tr("M line"));
  page.add("mode.slower | mode.faster", KeysPage::tr("sweep of the M-mode"));
  page.end();

  page.begin(KeyGroup::frozen);
  const std::string steps = "cine.stepBack | cine.stepOn";
  if (page.areUsual(steps)) {
    page.add("cine.back | cine.on", KeysPage::tr("an image back, on; with Shift ten"), KeysPage::tr("Wheel on the scan, arrows, %1"));
    page.leaveOut(steps);
  }
  page.add("cine.first | cine.last", KeysPage::tr("first, last image"));
  page.add("cine.play", KeysPage::tr("play in a loop, stop"));
  page.add("cine.in | cine.out", KeysPage::tr("the loop begins, ends with this image"));
  page.end();
}

/// What moves and turns by keys has them in Author alone, where volumes are placed.
void addHandles(Page& page, bool isAuthor) {
  const std::string moves = "handles.left | handles.right | handles.up | handles.down", along = "handles.nearer | handles.farther";
  const std::string sideways = "handles.turnLeft | handles.turnRight", over = "handles.turnUp | handles.turnDown",
                    about = "handles.turnBack | handles.turnOn";
  if (!isAuthor) return page.leaveOut(moves + " | " + along + " | " + sideways + " | " + over + " | " + about);
  if (page.areUsual(moves)) {
    page.add(along, KeysPage::tr("move what has handles by 1 mm; nearer, away"), KeysPage::tr("Arrows, %1"));
    page.leaveOut(moves);
  }
  page.add(sideways, KeysPage::tr("turn what has handles by 1° to the left, to the right"));
  page.add(over, KeysPage::tr("turn what has handles by 1° up, down"));
  page.add(about, KeysPage::tr("turn what has handles by 1° anticlockwise, clockwise"));
}

void addImages(Page& page, bool isAuthor) {
  page.begin(KeyGroup::measure);
  using measurement::CaliperKind;
  const auto tools = [](std::initializer_list<CaliperKind> kinds) {
    std::string all;
    for (const CaliperKind kind : kinds) all += (all.empty() ? "" : " | ") + caliperCommand(kind);
    return all;
  };
  page.add(tools({CaliperKind::distance, CaliperKind::polyLine, CaliperKind::trace}), KeysPage::tr("distance, poly-line, outline"));
  page.add(tools({CaliperKind::ellipse, CaliperKind::fittedEllipse, CaliperKind::angle}), KeysPage::tr("ellipse, fitted ellipse, angle"));
  page.add(tools({CaliperKind::discs}), KeysPage::tr("volume by discs"));
  page.add(tools({CaliperKind::interval, CaliperKind::heartRate}), KeysPage::tr("time, heart rate in the strip of the M-mode"));
  page.add(tools({CaliperKind::slope, CaliperKind::depthDistance}), KeysPage::tr("slope, depth in the strip"));
  page.add("calipers.followEdges", KeysPage::tr("outlines follow edges"));
  page.add("calipers.snap", KeysPage::tr("points snap; hold Ctrl to do the opposite once"));
  page.add("calipers.combine", KeysPage::tr("combine: ratio, stenosis, volume"));
  page.addMouse(KeysPage::tr("Drag a cross"), KeysPage::tr("move a point"));
  const std::string cross = "cross.left | cross.right | cross.up | cross.down";
  if (page.areUsual(cross)) {
    page.add("cross.set", KeysPage::tr("move the cross, set a point; with Ctrl by a pixel"), KeysPage::tr("Arrows, %1"));
    page.leaveOut(cross);
  }
  page.add("cross.takeBack | escape", KeysPage::tr("take back, put the tool down"));
  page.add("calipers.clear", KeysPage::tr("delete all measurements"));
  page.end();

  page.begin(KeyGroup::annotate);
  page.add("text.writeStill", KeysPage::tr("write, with words of the region"), KeysPage::tr("Frozen: %1"));
  page.add("text.write | text.arrow", KeysPage::tr("freeze and write, draw an arrow"));
  page.add("writing.firstWord | writing.home", KeysPage::tr("first word offered, home position"));
  page.addMouse(KeysPage::tr("Drag, double click"), KeysPage::tr("move, write anew"));
  page.add("chosen.delete | chosen.deleteWord", KeysPage::tr("delete what is chosen, its last word"));
  page.add("mark.show", KeysPage::tr("body mark"));
  page.end();

  page.begin(KeyGroup::view3d);
  page.addMouse(KeysPage::tr("Right drag"), KeysPage::tr("rotate the body"));
  page.addMouse(KeysPage::tr("Middle drag"), KeysPage::tr("move the body"));
  page.addMouse(KeysPage::tr("Ctrl+right drag"), KeysPage::tr("closer, farther"));
  page.add("look.front | look.back | look.right | look.left | look.head", KeysPage::tr("front, back, right, left, head"));
  page.add("look.volume", KeysPage::tr("look at the volume"));
  page.addMouse(KeysPage::tr("Double click"), KeysPage::tr("in a small window: swap body and scan"));
  addHandles(page, isAuthor);
  page.end();
}

void addConsole(Page& page) {
  page.begin(KeyGroup::settings);
  page.add("console.nextPage", KeysPage::tr("next page of the console"));
  page.add("focus.shallower | focus.deeper", KeysPage::tr("focus depth"));
  page.add("focus.zones", KeysPage::tr("number of focal zones"));
  page.add("range.wider | range.narrower", KeysPage::tr("dynamic range"));
  page.add("greyMap.next", KeysPage::tr("grey map"));
  page.add("edges.more | edges.less", KeysPage::tr("edge enhancement"));
  page.add("persistence.more | persistence.less", KeysPage::tr("persistence"));
  page.add("compound.next", KeysPage::tr("directions of compounding"));
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
  page.add("probe.next | frequency.next | harmonic", KeysPage::tr("next transducer, next frequency, harmonics"));
  page.add("steering.less | steering.more | trapezoid", KeysPage::tr("steer a linear array, trapezoid"));
  page.end();
}

void addAuthor(Page& page) {
  page.begin(KeyGroup::author);
  page.add("save | save.as", KeysPage::tr("save the case, save it elsewhere"));
  page.add("undo | redo", KeysPage::tr("undo, redo"));
  page.add("source", KeysPage::tr("which frame a point came from"), KeysPage::tr("%1, Alt+click"));
  page.add("quality.fast | quality.fine | quality.cubic", KeysPage::tr("nearest, linear, cubic"));
  page.add("focus.model", KeysPage::tr("focus model"));
  page.add("quality.adaptive", KeysPage::tr("adaptive quality"));
  page.add("cost", KeysPage::tr("performance"));
  page.end();
}

void addWindow(Page& page) {
  page.begin(KeyGroup::window);
  page.add("start", KeysPage::tr("cases"));
  page.add("open", KeysPage::tr("open"));
  page.add("save.picture", KeysPage::tr("save the image"));
  page.add("picture.store | examination", KeysPage::tr("store the image, images and archive"));
  page.add("scanOnly", KeysPage::tr("scan only"));
  page.add("fullScreen", KeysPage::tr("full screen"));
  page.add("workspace.explore | workspace.author", KeysPage::tr("Explore, Author"));
  page.add("keys", KeysPage::tr("this page"));
  page.end();
}

}  // namespace

std::vector<ShortcutsOverlay::Group> keysPage(const WindowParts& parts) {
  const Workspaces& front = *parts.workspaces;
  Page page(parts.keys);
  if (!front.isStaged()) {
    addScan(page);
    addImages(page, front.isAuthor());
    addConsole(page);
  }
  for (const sdk::StagePanel* panel : parts.host->panelsAdded()) {
    if (panel->keys.empty() || panel->workspace != front.current() || (front.isAuthor() && !front.isStaged())) continue;
    Group group{words(panel->title), {}};
    for (const auto& [key, what] : panel->keys) group.lines.push_back({words(key), capitalised(words(what))});
    page.put(std::move(group));
  }
  if (front.isAuthor()) addAuthor(page);
  addWindow(page);
  Group tools{titleOf(KeyGroup::tools), {}};
  for (const PluginHosting::Tool& tool : parts.pluginHosting->tools())
    if (tool.action->isEnabled() && !tool.action->shortcut().isEmpty())
      tools.lines.push_back(
          {tool.action->shortcut().toString(QKeySequence::NativeText), capitalised(tool.action->text().remove(QLatin1Char('&')))});
  if (!tools.lines.empty()) page.put(std::move(tools));
  return page.takeGroups();
}

}  // namespace ew::ui
