#include "keys/key_tips.h"

#include <QApplication>
#include <QEvent>
#include <QVariant>
#include <QWidget>

#include "keys/key_map.h"

namespace ew::ui {
namespace {

// Control characters that no text has: between them the commands.
const QChar kBegin(0x1E), kEnd(0x1F);
constexpr const char* kPattern = "patternOfTip";
constexpr const char* kNamed = "namedByTip";

}  // namespace

QString tipWithKeys(const QString& tip, const std::string& commands) {
  return QString(tip).replace(QStringLiteral("%1"), kBegin + QString::fromStdString(commands) + kEnd);
}

KeyTips::KeyTips(const KeyMap& keys) : keys_(keys) {
  QCoreApplication::instance()->installEventFilter(this);
  connect(&keys_, &KeyMap::changed, this, &KeyTips::showAll);
}

QString KeyTips::filledIn(const QString& pattern) const {
  const auto begin = pattern.indexOf(kBegin), end = pattern.indexOf(kEnd);
  if (begin < 0 || end < begin) return pattern;
  const QString keys = keys_.words(pattern.mid(begin + 1, end - begin - 1).toStdString());
  QString before = pattern.left(begin), after = pattern.mid(end + 1);
  if (keys.isEmpty() && before.endsWith(QStringLiteral(" (")) && after.startsWith(QLatin1Char(')'))) {
    before.chop(2);
    after.remove(0, 1);
  }
  return before + keys + after;
}

void KeyTips::show(QWidget& widget, const QString& pattern) {
  isShowing_ = true;
  widget.setProperty(kPattern, pattern);
  const QString tip = filledIn(pattern);
  if (widget.accessibleName().contains(kBegin)) widget.setProperty(kNamed, true);  // a button without words is called as its tip says
  if (widget.property(kNamed).toBool()) widget.setAccessibleName(tip);
  widget.setToolTip(tip);
  isShowing_ = false;
}

void KeyTips::showAll() {
  for (QWidget* widget : QApplication::allWidgets())
    if (const QVariant pattern = widget->property(kPattern); pattern.isValid()) show(*widget, pattern.toString());
}

bool KeyTips::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ToolTipChange || isShowing_ || !watched->isWidgetType()) return false;
  auto& widget = *static_cast<QWidget*>(watched);
  const QString tip = widget.toolTip();
  if (tip.contains(kBegin))
    show(widget, tip);
  else
    widget.setProperty(kPattern, QVariant());
  return false;
}

}  // namespace ew::ui
