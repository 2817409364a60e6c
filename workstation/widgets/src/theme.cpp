#include "ew/widgets/theme.h"

#include <QApplication>
#include <QFontDatabase>
#include <QVariant>
#include <QWidget>
#include <cmath>

#include "theme_state.h"

namespace ew {
namespace {

// The program and each plugin have a copy of this library. What all of them must agree on is therefore no variable of it but a property of
// the one application.
constexpr const char* kIsLight = "ewIsLight";
constexpr const char* kTextSize = "ewTextSize_percent";
constexpr int kUsualSize_percent = 100;

/// What a held size is called among a widget's properties, and what it sets.
struct SizeProperty {
  const char* property;
  void (QWidget::*set)(int);
};

constexpr SizeProperty kWidth{"heldWidth_px", &QWidget::setFixedWidth};
constexpr SizeProperty kHeight{"heldHeight_px", &QWidget::setFixedHeight};
constexpr SizeProperty kLeastWidth{"heldLeastWidth_px", &QWidget::setMinimumWidth};
constexpr SizeProperty kLeastHeight{"heldLeastHeight_px", &QWidget::setMinimumHeight};

void hold(QWidget& widget, const SizeProperty& size, int px) {
  widget.setProperty(size.property, px);
  (widget.*size.set)(scaled(px));
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

const Theme& currentTheme() {
  static const Theme dark = darkTheme(), light = lightTheme();
  return qApp != nullptr && qApp->property(kIsLight).toBool() ? light : dark;
}

void keepTheme(bool isDark) {
  if (qApp != nullptr) qApp->setProperty(kIsLight, !isDark);
}

void keepTextSize(int percent) {
  if (qApp != nullptr) qApp->setProperty(kTextSize, percent);
}

void setHeldSizes() {
  for (QWidget* each : QApplication::allWidgets()) {
    for (const SizeProperty& size : {kWidth, kHeight, kLeastWidth, kLeastHeight}) {
      const QVariant px = each->property(size.property);
      if (px.isValid()) (each->*size.set)(scaled(px.toInt()));
    }
  }
}

int textSize_percent() {
  const QVariant kept = qApp != nullptr ? qApp->property(kTextSize) : QVariant();
  return kept.isValid() ? kept.toInt() : kUsualSize_percent;
}
int scaled(int px) { return static_cast<int>(std::lround(scaled(static_cast<double>(px)))); }
double scaled(double px) { return px * textSize_percent() / 100.0; }

void holdFixedWidth(QWidget& widget, int px) { hold(widget, kWidth, px); }
void holdFixedHeight(QWidget& widget, int px) { hold(widget, kHeight, px); }
void holdLeastWidth(QWidget& widget, int px) { hold(widget, kLeastWidth, px); }
void holdLeastHeight(QWidget& widget, int px) { hold(widget, kLeastHeight, px); }

UsualTextSize::UsualTextSize() : before_percent_(textSize_percent()) { keepTextSize(kUsualSize_percent); }
UsualTextSize::~UsualTextSize() { keepTextSize(before_percent_); }

QFont textFont() { return fontOf(kTextSize_px); }
QFont smallFont() { return fontOf(kSmallSize_px); }
QFont bold(QFont font) {
  font.setWeight(QFont::DemiBold);
  return font;
}

}  // namespace ew
