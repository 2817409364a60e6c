#include "widgets/theme.h"

#include <QFile>
#include <QFontDatabase>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QRegularExpression>
#include <QStyleFactory>
#include <QVariant>
#include <QWidget>
#include <cmath>
#include <cstdlib>
#include <map>

#include "ew/core/contract.h"

/// Outside of any namespace, as the macro demands.
static void initStyle() { Q_INIT_RESOURCE(style); }

namespace ew::ui {
namespace {

Theme& theTheme() {
  static Theme theme = darkTheme();
  return theme;
}

int& theTextSize_percent() {
  static int percent = kTextSizes_percent.front();
  return percent;
}

/// What a held size is called among a widget's properties, and what it sets.
struct HeldSize {
  const char* property;
  void (QWidget::*set)(int);
};

constexpr HeldSize kWidth{"heldWidth_px", &QWidget::setFixedWidth};
constexpr HeldSize kHeight{"heldHeight_px", &QWidget::setFixedHeight};
constexpr HeldSize kLeastWidth{"heldLeastWidth_px", &QWidget::setMinimumWidth};
constexpr HeldSize kLeastHeight{"heldLeastHeight_px", &QWidget::setMinimumHeight};

void hold(QWidget& widget, const HeldSize& size, int px) {
  widget.setProperty(size.property, px);
  (widget.*size.set)(scaled(px));
}

void setHeldSizes() {
  for (QWidget* each : QApplication::allWidgets()) {
    for (const HeldSize& size : {kWidth, kHeight, kLeastWidth, kLeastHeight}) {
      const QVariant px = each->property(size.property);
      if (px.isValid()) (each->*size.set)(scaled(px.toInt()));
    }
  }
}

QString family() {
  const QFontDatabase fonts;
  const QStringList installed = fonts.families();
  for (const QString& wanted : {QStringLiteral("Inter"), QStringLiteral("DejaVu Sans")}) {
    if (installed.contains(wanted)) return wanted;
  }
  return QFont().family();
}

QFont fontOf(int size_px) {
  static const QString name = family();
  QFont font(name);
  font.setPixelSize(scaled(size_px));
  font.setStyleStrategy(QFont::PreferAntialias);
  return font;
}

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
  initStyle();
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

Theme darkTheme() {
  Theme t;
  t.dark = true;
  t.panel = QColor(0x22, 0x24, 0x28);
  t.ground = QColor(0x1b, 0x1c, 0x1f);
  t.raised = QColor(0x30, 0x35, 0x3a);
  t.line = QColor(0x36, 0x3a, 0x3f);
  t.edge = QColor(0x78, 0x7e, 0x86);
  t.text = QColor(0xe9, 0xeb, 0xed);
  t.quiet = QColor(0x9b, 0xa1, 0xa8);
  t.accent = QColor(0x4f, 0xb3, 0xbf);
  t.onAccent = QColor(0x0d, 0x1a, 0x1c);
  t.danger = QColor(0xe8, 0x68, 0x5d);
  return t;
}

Theme lightTheme() {
  Theme t;
  t.dark = false;
  t.panel = QColor(0xfb, 0xfb, 0xfc);
  t.ground = QColor(0xee, 0xf0, 0xf2);
  t.raised = QColor(0xe2, 0xe5, 0xe8);
  t.line = QColor(0xd0, 0xd5, 0xd9);
  t.edge = QColor(0x79, 0x80, 0x87);
  t.text = QColor(0x1d, 0x20, 0x23);
  t.quiet = QColor(0x5c, 0x64, 0x6c);
  t.accent = QColor(0x0b, 0x6d, 0x79);
  t.onAccent = QColor(0xff, 0xff, 0xff);
  t.danger = QColor(0xc2, 0x35, 0x2b);
  return t;
}

Theme scanTheme() {
  Theme t = darkTheme();
  t.panel = t.ground = Qt::black;
  return t;
}

const Theme& currentTheme() { return theTheme(); }

void rememberSystemTheme() { (void)systemIsDark(); }

Theme themeCalled(const QString& choice) {
  const bool isLight = choice == QLatin1String("light") || (choice == QLatin1String("system") && !systemIsDark());
  return isLight ? lightTheme() : darkTheme();
}

void applyTheme(const Theme& theme) {
  theTheme() = theme;
  QApplication::setStyle(new QuietFusion);
  QApplication::setPalette(paletteOf(theme));
  QApplication::setFont(textFont());
  qApp->setStyleSheet(sheetOf(theme));
  setHeldSizes();
}

void setTextSize(int percent) {
  int& size = theTextSize_percent();
  size = kTextSizes_percent.front();
  for (const int offered : kTextSizes_percent)
    if (std::abs(offered - percent) < std::abs(size - percent)) size = offered;
}

int textSize_percent() { return theTextSize_percent(); }
int scaled(int px) { return static_cast<int>(std::lround(scaled(static_cast<double>(px)))); }
double scaled(double px) { return px * theTextSize_percent() / 100.0; }

void holdFixedWidth(QWidget& widget, int px) { hold(widget, kWidth, px); }
void holdFixedHeight(QWidget& widget, int px) { hold(widget, kHeight, px); }
void holdLeastWidth(QWidget& widget, int px) { hold(widget, kLeastWidth, px); }
void holdLeastHeight(QWidget& widget, int px) { hold(widget, kLeastHeight, px); }

UsualTextSize::UsualTextSize() : before_percent_(theTextSize_percent()) { theTextSize_percent() = kTextSizes_percent.front(); }
UsualTextSize::~UsualTextSize() { theTextSize_percent() = before_percent_; }

QFont textFont() { return fontOf(kTextSize_px); }
QFont smallFont() { return fontOf(kSmallSize_px); }

}  // namespace ew::ui
