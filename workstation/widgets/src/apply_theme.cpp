#include "ew/widgets/apply_theme.h"

#include <QApplication>
#include <QFile>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QRegularExpression>
#include <QStyleFactory>
#include <cstdlib>
#include <map>

#include "ew/core/contract.h"
#include "theme_state.h"

/// A static library's resources come along where they are asked for; outside of any namespace, as the macro demands.
static void initWidgets() {
  Q_INIT_RESOURCE(icons);
  Q_INIT_RESOURCE(style);
}

namespace ew {
namespace {

/// Fusion without a line under every menu's letter; the letters still work with Alt.
class QuietFusion final : public QProxyStyle {
 public:
  QuietFusion() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
    const int px = QProxyStyle::pixelMetric(metric, option, widget);
    return metric == PM_SmallIconSize || metric == PM_ButtonIconSize || metric == PM_TabBarScrollButtonWidth ? scaled(px) : px;
  }
  /// Beside an icon a style sheet asks for words at the left, and means the side of the icon.
  void drawItemText(QPainter* painter, const QRect& box, int flags, const QPalette& palette, bool enabled, const QString& text,
                    QPalette::ColorRole role) const override {
    const bool isMirrored =
        painter->layoutDirection() == Qt::RightToLeft && (flags & Qt::AlignLeft) != 0 && (flags & Qt::AlignAbsolute) == 0;
    const int own = isMirrored ? (flags & ~Qt::AlignLeft) | Qt::AlignRight | Qt::AlignAbsolute : flags;
    QProxyStyle::drawItemText(painter, box, own, palette, enabled, text, role);
  }
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget, QStyleHintReturn* answer) const override {
    return hint == SH_UnderlineShortcut ? 0 : QProxyStyle::styleHint(hint, option, widget, answer);
  }
};

QPalette paletteOf(const Theme& t) {
  QPalette p;
  p.setColor(QPalette::Window, t.panel);
  p.setColor(QPalette::WindowText, t.text);
  p.setColor(QPalette::Base, t.ground);
  p.setColor(QPalette::AlternateBase, t.panel);
  p.setColor(QPalette::Text, t.text);
  p.setColor(QPalette::Button, t.raised);
  p.setColor(QPalette::ButtonText, t.text);
  p.setColor(QPalette::BrightText, t.danger);
  p.setColor(QPalette::ToolTipBase, t.raised);
  p.setColor(QPalette::ToolTipText, t.text);
  p.setColor(QPalette::PlaceholderText, t.quiet);
  p.setColor(QPalette::Highlight, t.accent);
  p.setColor(QPalette::HighlightedText, t.onAccent);
  p.setColor(QPalette::Link, t.accent);
  p.setColor(QPalette::Light, t.raised);
  p.setColor(QPalette::Midlight, t.raised);
  p.setColor(QPalette::Mid, t.line);
  p.setColor(QPalette::Dark, t.line);
  p.setColor(QPalette::Shadow, t.ground);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) p.setColor(QPalette::Disabled, role, t.quiet);
  return p;
}

/// What the names in the style sheet stand for.
std::map<QString, QString> namedValues(const Theme& t) {
  const Theme scan = scanTheme();
  return {{"panel", t.panel.name()},
          {"ground", t.ground.name()},
          {"raised", t.raised.name()},
          {"line", t.line.name()},
          {"edge", t.edge.name()},
          {"text", t.text.name()},
          {"quiet", t.quiet.name()},
          {"hint", t.quiet.name()},
          {"accent", t.accent.name()},
          {"onAccent", t.onAccent.name()},
          {"danger", t.danger.name()},
          {"handle", t.dark ? "#e9ebed" : "#ffffff"},
          {"handleEdge", t.dark ? t.panel.name() : t.quiet.name()},
          {"handleRadius", QStringLiteral("%1px").arg(scaled(12) / 2 + 1)},  // half of its side; more is drawn as a square
          {"dotRadius", QStringLiteral("%1px").arg(scaled(14) / 2 + 1)},
          {"veil", t.dark ? "rgba(18, 19, 21, 200)" : "rgba(255, 255, 255, 210)"},
          {"scheme", t.dark ? "dark" : "light"},
          {"scanLine", scan.line.name()},
          {"scanEdge", scan.edge.name()},
          {"scanText", scan.text.name()},
          {"scanQuiet", scan.quiet.name()},
          {"scanAccent", scan.accent.name()}};
}

/// resources/style/window.qss, which names colours as @panel, @ground ... so that it reads the same for both themes, and sizes that hold
/// text as @px(13).
QString sheetOf(const Theme& theme) {
  initWidgets();
  QFile file(QStringLiteral(":/ew/style/window.qss"));
  [[maybe_unused]] const bool isThere = file.open(QIODevice::ReadOnly);
  EW_EXPECTS(isThere);
  const QString source = QString::fromUtf8(file.readAll());
  const std::map<QString, QString> values = namedValues(theme);
  static const QRegularExpression name(QStringLiteral("@([A-Za-z]+)(?:\\((\\d+)\\))?"));
  QString sheet;
  int from = 0;
  for (auto found = name.globalMatch(source); found.hasNext();) {
    const QRegularExpressionMatch match = found.next();
    sheet += source.mid(from, match.capturedStart() - from);
    if (match.captured(1) == QLatin1String("px")) {
      sheet += QStringLiteral("%1px").arg(scaled(match.captured(2).toInt()));
    } else {
      const auto value = values.find(match.captured(1));
      EW_EXPECTS(value != values.end());
      sheet += value->second;
    }
    from = match.capturedEnd();
  }
  return sheet + source.mid(from);
}

/// As the palette was before a theme replaced it.
bool systemIsDark() {
  static const bool isDark = QApplication::palette().color(QPalette::Window).lightness() < 128;
  return isDark;
}

}  // namespace

void rememberSystemTheme() { (void)systemIsDark(); }

Theme themeCalled(const QString& choice) {
  const bool isLight = choice == QLatin1String("light") || (choice == QLatin1String("system") && !systemIsDark());
  return isLight ? lightTheme() : darkTheme();
}

void applyTheme(const Theme& theme) {
  keepTheme(theme.dark);
  QApplication::setStyle(new QuietFusion);
  QApplication::setPalette(paletteOf(theme));
  QApplication::setFont(textFont());
  qApp->setStyleSheet(sheetOf(theme));
  setHeldSizes();
}

void setTextSize(int percent) {
  int size = kTextSizes_percent.front();
  for (const int offered : kTextSizes_percent)
    if (std::abs(offered - percent) < std::abs(size - percent)) size = offered;
  keepTextSize(size);
}

}  // namespace ew
