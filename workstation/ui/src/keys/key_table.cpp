#include "keys/key_table.h"

#include <QCoreApplication>

#include "ew/measurement/caliper_drawing.h"
#include "keys/effect_words.h"
#include "measure/words/caliper_words.h"
#include "window/layout/window_text.h"

namespace ew::ui {
namespace {

constexpr const char* kWindow = "ew::ui::MainWindow";

/// "Space | F"
QList<QKeySequence> sequences(const char* keys) {
  QList<QKeySequence> made;
  if (*keys == '\0') return made;
  for (const QString& each : QString::fromLatin1(keys).split(QStringLiteral(" | "))) made << QKeySequence(each, QKeySequence::PortableText);
  return made;
}

struct Row {
  const char* id;
  KeyGroup group;
  const char* source;
  const char* keys;
  unsigned when = kAlways;
};

const Row kActions[] = {
    {"freeze", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Freeze"), "Space | F"},
    {"record", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Record"), "Ctrl+R"},
    {"record.mark", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Mark this moment"), "K"},
    {"record.save", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Save recording as…"), "Ctrl+Shift+R"},
    {"tracker", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Tracker…"), "Ctrl+J"},
    {"depth.more", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Deeper"), "PgDown"},
    {"depth.less", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Shallower"), "PgUp"},
    {"gain.more", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "More gain"), "Ctrl+Up"},
    {"gain.less", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Less gain"), "Ctrl+Down"},
    {"tgc.reset", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Reset TGC"), "Ctrl+0"},
    {"zoom.in", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Zoom in"), "Z"},
    {"zoom.out", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Zoom out"), "Shift+Z"},
    {"zoom.box", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Magnify a box"), "O"},
    {"zoom.whole", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Show the whole image"), "Ctrl+Backspace"},
    {"wide", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Wide image"), "Ctrl+W"},
    {"breathing.free", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Breathe freely"), "C", kWhileRunning},
    {"breathing.in", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Breathe in and hold"), "Shift+C"},
    {"breathing.out", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Breathe out and hold"), "Ctrl+Shift+C"},
    {"flip.sides", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Invert left/right"), "X"},
    {"flip.upsideDown", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Invert up/down"), "U"},
    {"mode.next", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "B, B + M, M"), "M"},
    {"pictures.one", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "One image"), ""},
    {"pictures.two", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Two images"), ""},
    {"pictures.four", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Four images"), ""},
    {"pictures.count", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Next number of images"), "Shift+M"},
    {"pictures.next", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Next image"), "Shift+L"},
    {"pictures.sameScale", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Same scale"), ""},
    {"mode.lineLeft", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "M line to the left"), "Ctrl+Left"},
    {"mode.lineRight", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "M line to the right"), "Ctrl+Right"},
    {"mode.slower", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Slower sweep"), "Y"},
    {"mode.faster", KeyGroup::image, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Faster sweep"), "Shift+Y"},
    {"cine.play", KeyGroup::frozen, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Play or stop"), "C", kWhileStill},
    {"cine.back", KeyGroup::frozen, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "An image back"), ",", kWhileStill},
    {"cine.on", KeyGroup::frozen, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "An image on"), ".", kWhileStill},
    {"cine.in", KeyGroup::frozen, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Loop from this image"), "Shift+I", kWhileStill},
    {"cine.out", KeyGroup::frozen, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Loop to this image"), "Shift+O", kWhileStill},
    {"cine.save", KeyGroup::frozen, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Save clip as…"), "", kWhileStill},
    {"calipers.followEdges", KeyGroup::measure, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Outlines follow edges"), "0"},
    {"calipers.snap", KeyGroup::measure, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Points snap"), "Ctrl+M"},
    {"calipers.combine", KeyGroup::measure, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Combine measurements…"), "Ctrl+E"},
    {"calipers.save", KeyGroup::measure, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Save measurements…"), ""},
    {"calipers.worksheet", KeyGroup::measure, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Worksheet…"), "Shift+F10"},
    {"calipers.clear", KeyGroup::measure, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Delete all measurements"), "Ctrl+Del"},
    {"text.write", KeyGroup::annotate, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Text"), "Ctrl+T"},
    {"text.writeStill", KeyGroup::annotate, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Text, on a frozen image"), "T", kWhileStill},
    {"text.arrow", KeyGroup::annotate, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Arrow"), "Shift+T"},
    {"text.homeHere", KeyGroup::annotate, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Home position here"), ""},
    {"text.clear", KeyGroup::annotate, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Delete all texts and arrows"), "Ctrl+Shift+Del"},
    {"mark.show", KeyGroup::annotate, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Show the body mark"), "Ctrl+B"},
    {"mark.follow", KeyGroup::annotate, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Follow the probe again"), ""},
    {"look.front", KeyGroup::view3d, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "From the &front"), "Alt+1"},
    {"look.back", KeyGroup::view3d, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "From the &back"), "Alt+2"},
    {"look.right", KeyGroup::view3d, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "From the patient's &right"), "Alt+3"},
    {"look.left", KeyGroup::view3d, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "From the patient's &left"), "Alt+4"},
    {"look.head", KeyGroup::view3d, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "From the &head"), "Alt+5"},
    {"look.volume", KeyGroup::view3d, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Look at the &volume"), "Alt+0"},
    {"console.nextPage", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Next page of the console"), "F10"},
    {"focus.shallower", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Focus shallower"), ",", kWhileRunning},
    {"focus.deeper", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Focus deeper"), ".", kWhileRunning},
    {"focus.zones", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Number of focal zones"), "N"},
    {"range.wider", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Wider dynamic range"), "R"},
    {"range.narrower", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Narrower dynamic range"), "Shift+R"},
    {"greyMap.next", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Next grey map"), "G"},
    {"edges.more", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "More edge enhancement"), "B"},
    {"edges.less", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Less edge enhancement"), "Shift+B"},
    {"persistence.more", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "More persistence"), "P"},
    {"persistence.less", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Less persistence"), "Shift+P"},
    {"compound.next", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Directions of compounding"), "Shift+X"},
    {"colour", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Colour Doppler"), "Shift+F"},
    {"colour.scaleMore", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Larger scale of colour"), "Ctrl+Shift+Right"},
    {"colour.scaleLess", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Smaller scale of colour"), "Ctrl+Shift+Left"},
    {"colour.gainMore", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "More gain of colour"), "Ctrl+Shift+Up"},
    {"colour.gainLess", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Less gain of colour"), "Ctrl+Shift+Down"},
    {"spectral", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Spectral Doppler"), "Shift+V"},
    {"spectral.angleMore", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Larger Doppler angle"), "Shift+K"},
    {"spectral.angleLess", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Smaller Doppler angle"), "Shift+J"},
    {"spectral.scaleMore", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Larger scale of the spectrum"), "Shift+U"},
    {"spectral.scaleLess", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Smaller scale of the spectrum"), "Shift+G"},
    {"spectral.mute", KeyGroup::settings, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Mute the Doppler sound"), ""},
    {"effect.planes", KeyGroup::effects, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Planes of the slice thickness"), "Shift+F3"},
    {"probe.next", KeyGroup::effects, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Next transducer"), "T", kWhileRunning},
    {"frequency.next", KeyGroup::effects, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Next frequency"), "H"},
    {"harmonic", KeyGroup::effects, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Harmonics"), "Shift+H"},
    {"steering.less", KeyGroup::effects, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Steer to one side"), "J"},
    {"steering.more", KeyGroup::effects, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Steer to the other side"), "L"},
    {"trapezoid", KeyGroup::effects, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Trapezoid"), "V"},
    {"save", KeyGroup::author, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Save case"), "Ctrl+S"},
    {"save.as", KeyGroup::author, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Save case &as…"), "Ctrl+Shift+S"},
    {"save.volume", KeyGroup::author, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Save &volume as…"), ""},
    {"undo", KeyGroup::author, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Undo"), "Ctrl+Z"},
    {"redo", KeyGroup::author, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Redo"), "Ctrl+Shift+Z | Ctrl+Y"},
    {"source", KeyGroup::author, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Show source &frame"), "I"},
    {"volume.ofCase", KeyGroup::author, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Scan the &case's volume"), ""},
    {"volume.made", KeyGroup::author, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Show the volume that was made"), ""},
    {"quality.fast", KeyGroup::author, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Fast: nearest voxels"), "1"},
    {"quality.fine", KeyGroup::author, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Fine: interpolated"), "2"},
    {"quality.cubic", KeyGroup::author, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Cubic: sharpest"), "3"},
    {"quality.adaptive", KeyGroup::author, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Adaptive: falls while the probe moves fast"), "F9"},
    {"focus.model", KeyGroup::author, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Next focus model"), "Shift+N"},
    {"cost", KeyGroup::author, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Performance…"), "Ctrl+K"},
    {"start", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "S&tart page"), "Ctrl+H"},
    {"search", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Sea&rch the cases"), "Ctrl+F"},
    {"open", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Open…"), "Ctrl+O"},
    {"open.folder", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Open case &folder…"), "Ctrl+Shift+O"},
    {"import.case", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Import a case bundle…"), "Ctrl+I"},
    {"save.picture", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Save &image as…"), "Ctrl+P"},
    {"picture.store", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "S&tore image"), "Ins | Ctrl+Shift+P"},
    {"examination", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Examination and archive…"), "Ctrl+Shift+E"},
    {"column.panels", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Lessons and &panels"), ""},
    {"column.body", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Body and case"), ""},
    {"column.console", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Console"), ""},
    {"column.next", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Next column"), "Shift+F12"},
    {"scanOnly", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Scan &only"), "F12"},
    {"fullScreen", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "F&ull screen"), "F11"},
    {"workspace.explore", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Explore"), "Ctrl+1"},
    {"workspace.author", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Author"), "Ctrl+2"},
    {"theme.system", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "System default"), ""},
    {"theme.dark", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Dark"), ""},
    {"theme.light", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "L&ight"), ""},
    {"words.larger", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Larger text"), "Ctrl++ | Ctrl+="},
    {"words.smaller", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Smaller text"), "Ctrl+-"},
    {"tour", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Tour"), ""},
    {"keys", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Keys and mouse"), "F1"},
    {"keys.edit", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Keys and &controls…"), ""},
    {"plugins", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Plugins…"), ""},
    {"about", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&About EchoWeave"), ""},
    {"quit", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "&Quit"), "Ctrl+Q"},
};

struct ViewRow {
  Row row;
  Qt::KeyboardModifiers widens = Qt::NoModifier;
  bool isFixed = false;
};

/// Of views that have the focus. The hand's keys belong to an image that runs; frozen, those that nothing else has say that it is.
const ViewRow kOfViews[] = {
    {{"hand.left", KeyGroup::probe, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Slide to the left"), "Left", kWhileRunning},
     Qt::ShiftModifier},
    {{"hand.right", KeyGroup::probe, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Slide to the right"), "Right", kWhileRunning},
     Qt::ShiftModifier},
    {{"hand.up", KeyGroup::probe, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Slide up"), "Up", kWhileRunning}, Qt::ShiftModifier},
    {{"hand.down", KeyGroup::probe, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Slide down"), "Down", kWhileRunning}, Qt::ShiftModifier},
    {{"hand.rotateLeft", KeyGroup::probe, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Rotate to the left"), "Q", kWhileRunning},
     Qt::ShiftModifier},
    {{"hand.rotateRight", KeyGroup::probe, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Rotate to the right"), "E", kWhileRunning},
     Qt::ShiftModifier},
    {{"hand.rockLeft", KeyGroup::probe, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Rock to the left"), "A", kWhileRunning},
     Qt::ShiftModifier},
    {{"hand.rockRight", KeyGroup::probe, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Rock to the right"), "D", kWhileRunning},
     Qt::ShiftModifier},
    {{"hand.tiltForward", KeyGroup::probe, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Tilt forward"), "W", kWhileRunning}, Qt::ShiftModifier},
    {{"hand.tiltBack", KeyGroup::probe, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Tilt back"), "S", kWhileRunning}, Qt::ShiftModifier},
    {{"hand.home", KeyGroup::probe, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Back to the start"), "Home", kWhileRunning},
     Qt::ShiftModifier},
    {{"cine.stepBack", KeyGroup::frozen, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Images back"), "Left", kWhileStill}, Qt::ShiftModifier},
    {{"cine.stepOn", KeyGroup::frozen, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Images on"), "Right", kWhileStill}, Qt::ShiftModifier},
    {{"cine.first", KeyGroup::frozen, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "First image"), "Home", kWhileStill}, Qt::ShiftModifier},
    {{"cine.last", KeyGroup::frozen, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Last image"), "End", kWhileStill}, Qt::ShiftModifier},
    {{"cross.left", KeyGroup::measure, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Cross to the left"), "Left", kWithTool},
     Qt::ShiftModifier | Qt::ControlModifier},
    {{"cross.right", KeyGroup::measure, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Cross to the right"), "Right", kWithTool},
     Qt::ShiftModifier | Qt::ControlModifier},
    {{"cross.up", KeyGroup::measure, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Cross up"), "Up", kWithTool},
     Qt::ShiftModifier | Qt::ControlModifier},
    {{"cross.down", KeyGroup::measure, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Cross down"), "Down", kWithTool},
     Qt::ShiftModifier | Qt::ControlModifier},
    {{"cross.set", KeyGroup::measure, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Set a point"), "Return", kWithTool}},
    {{"cross.takeBack", KeyGroup::measure, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Take a point back"), "Backspace | Del", kWithTool}},
    {{"handles.left", KeyGroup::view3d, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Handles: move to the left"), "Left", kWithHandles}},
    {{"handles.right", KeyGroup::view3d, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Handles: move to the right"), "Right", kWithHandles}},
    {{"handles.up", KeyGroup::view3d, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Handles: move up"), "Up", kWithHandles}},
    {{"handles.down", KeyGroup::view3d, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Handles: move down"), "Down", kWithHandles}},
    {{"handles.nearer", KeyGroup::view3d, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Handles: move nearer"), "PgUp", kWithHandles}},
    {{"handles.farther", KeyGroup::view3d, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Handles: move away"), "PgDown", kWithHandles}},
    {{"handles.turnLeft", KeyGroup::view3d, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Handles: turn to the left"), "Alt+Left",
      kWithHandles}},
    {{"handles.turnRight", KeyGroup::view3d, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Handles: turn to the right"), "Alt+Right",
      kWithHandles}},
    {{"handles.turnUp", KeyGroup::view3d, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Handles: turn up"), "Alt+Up", kWithHandles}},
    {{"handles.turnDown", KeyGroup::view3d, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Handles: turn down"), "Alt+Down", kWithHandles}},
    {{"handles.turnBack", KeyGroup::view3d, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Handles: turn anticlockwise"), "Alt+PgUp",
      kWithHandles}},
    {{"handles.turnOn", KeyGroup::view3d, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Handles: turn clockwise"), "Alt+PgDown", kWithHandles}},
    {{"chosen.delete", KeyGroup::annotate, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Delete the chosen text or arrow"), "Del", kWithChosen}},
    {{"chosen.deleteWord", KeyGroup::annotate, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Delete the last word of the chosen text"),
      "Backspace", kWithChosen}},
    {{"writing.end", KeyGroup::annotate, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "End the text"), "Return", kWhileWriting},
     Qt::NoModifier,
     true},
    {{"writing.firstWord", KeyGroup::annotate, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Take the first word offered"), "Tab",
      kWhileWriting},
     Qt::NoModifier,
     true},
    {{"writing.home", KeyGroup::annotate, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "To the home position"), "Ctrl+Home", kWhileWriting},
     Qt::NoModifier,
     true},
    {{"escape", KeyGroup::window, QT_TRANSLATE_NOOP("ew::ui::MainWindow", "Put the tool down, close, go back"), "Esc",
      kAlways | kWithTool | kWithChosen | kWhileWriting},
     Qt::NoModifier,
     true},
};

KeyCommand commandOf(const Row& row) {
  KeyCommand made;
  made.id = row.id;
  made.group = row.group;
  made.context = kWindow;
  made.source = row.source;
  made.usual = sequences(row.keys);
  made.when = row.when;
  return made;
}

KeyCommand commandOf(const char* effectKey, const char* name, const char* keyStroke) {
  KeyCommand made;
  made.id = effectCommand(effectKey);
  made.group = KeyGroup::effects;
  made.context = kEffectTexts;
  made.source = name;
  made.usual = sequences(keyStroke);
  return made;
}

}  // namespace

QString KeyCommand::text() const {
  return context != nullptr ? QCoreApplication::translate(context, source.constData()) : QString::fromUtf8(source);
}

QString KeyCommand::name() const { return text().remove(QLatin1Char('&')).remove(QStringLiteral("…")); }

std::string effectCommand(const char* effectKey) { return std::string("effect.") + effectKey; }

std::string caliperCommand(measurement::CaliperKind kind) { return "caliper." + std::string(wordOf(kind)); }

std::vector<KeyCommand> keyTable() {
  std::vector<KeyCommand> table;
  for (const Row& row : kActions) table.push_back(commandOf(row));
  for (const ViewRow& view : kOfViews) {
    table.push_back(commandOf(view.row));
    table.back().widens = view.widens;
    table.back().isFixed = view.isFixed;
    table.back().isAction = false;
  }
  for (const EffectInfo& effect : sceneEffects()) {
    table.push_back(commandOf(effect.key, effect.name, effect.keyStroke));
    if (effect.option) table.push_back(commandOf(effect.option->key, effect.option->name, effect.option->keyStroke));
  }
  const auto addTools = [&table](const std::vector<measurement::CaliperKind>& kinds, Qt::Key first, Qt::KeyboardModifiers modifiers) {
    for (std::size_t n = 0; n < kinds.size(); ++n) {
      KeyCommand made;
      made.id = caliperCommand(kinds[n]);
      made.group = KeyGroup::measure;
      made.source = CaliperWords::nameOf(kinds[n]).toUtf8();
      made.usual = {kinds[n] == measurement::CaliperKind::discs ? QKeySequence(QStringLiteral("Ctrl+D"))
                                                                : QKeySequence(static_cast<int>(modifiers) + first + static_cast<int>(n))};
      table.push_back(std::move(made));
    }
  };
  addTools(measurement::drawnKinds(), Qt::Key_4, Qt::NoModifier);
  addTools(measurement::stripKinds(), Qt::Key_6, Qt::AltModifier);
  return table;
}

QString titleOf(KeyGroup group) {
  switch (group) {
    case KeyGroup::probe:
      return WindowText::tr("Probe");
    case KeyGroup::image:
      return WindowText::tr("Image");
    case KeyGroup::frozen:
      return WindowText::tr("Frozen image");
    case KeyGroup::measure:
      return WindowText::tr("Measure");
    case KeyGroup::annotate:
      return WindowText::tr("Annotate");
    case KeyGroup::view3d:
      return WindowText::tr("3D view");
    case KeyGroup::settings:
      return WindowText::tr("Settings");
    case KeyGroup::effects:
      return WindowText::tr("Effects and probe");
    case KeyGroup::author:
      return WindowText::tr("Author");
    case KeyGroup::window:
      return WindowText::tr("Window");
    case KeyGroup::tools:
      return WindowText::tr("Tools");
  }
  return {};
}

QString wordsOfStates(unsigned when) {
  switch (when) {
    case kAlways:
      return {};
    case kWhileRunning:
      return WindowText::tr("while the image runs");
    case kWhileStill:
      return WindowText::tr("on a frozen image");
    case kWithTool:
      return WindowText::tr("with a tool in the hand");
    case kWithChosen:
      return WindowText::tr("with a text or an arrow chosen");
    case kWithHandles:
      return WindowText::tr("in the 3D view, with handles");
    case kWhileWriting:
      return WindowText::tr("while writing");
    default:
      return WindowText::tr("everywhere");
  }
}

}  // namespace ew::ui
