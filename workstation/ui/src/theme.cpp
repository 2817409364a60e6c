#include "theme.h"

#include <QFontDatabase>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleFactory>

namespace ew::ui {
namespace {

Theme& theTheme() {
  static Theme theme = darkTheme();
  return theme;
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
  font.setPixelSize(size_px);
  font.setStyleStrategy(QFont::PreferAntialias);
  return font;
}

/// Fusion without a line under every menu's letter; the letters still work with Alt.
class QuietFusion final : public QProxyStyle {
 public:
  QuietFusion() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}
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

/// The style sheet names colours as @panel, @ground ... so that it reads the same for both themes.
QString sheetOf(const Theme& t) {
  QString sheet = QStringLiteral(R"(
QWidget { font-size: 13px; }
QWidget[small="true"] { font-size: 12px; }
QLabel[quiet="true"] { color: @quiet; }
QLabel[heading="true"] { font-weight: 600; }
QToolTip { color: @text; background: @raised; border: 1px solid @line; padding: 4px 8px; }

#topBar, #statusLine, #replayBar { background: @panel; }
#topBar { border-bottom: 1px solid @line; }
#statusLine, #replayBar { border-top: 1px solid @line; }
#brand { font-weight: 700; }
#console { background: @panel; border-left: 1px solid @line; }
#authorColumn { background: @panel; border-right: 1px solid @line; }
#authorPanel { background: @panel; }
#startPage, #startBody { background: @ground; }
#viewLabel, #viewHints { color: @hint; background: transparent; }
#viewHints { background: @veil; border-radius: 4px; padding: 6px 12px; }

QMenuBar { background: transparent; border: 0; }
QMenuBar::item { padding: 6px 8px; background: transparent; border-radius: 4px; color: @quiet; }
QMenuBar::item:selected { background: @raised; color: @text; }
QMenu { background: @panel; border: 1px solid @line; padding: 4px; }
QMenu::item { padding: 6px 24px 6px 16px; border-radius: 4px; }
QMenu::item:selected { background: @raised; }
QMenu::item:disabled { color: @quiet; }
QMenu::separator { height: 1px; background: @line; margin: 4px 8px; }
QMenu::indicator { width: 16px; left: 4px; }
QMenu::icon { left: 8px; }

QPushButton { background: @raised; border: 1px solid @raised; border-radius: 4px; padding: 6px 12px; min-height: 18px; }
QPushButton:hover { border-color: @quiet; }
QPushButton:pressed { background: @line; }
QPushButton:focus { border-color: @accent; outline: 0; }
QPushButton:checked, QPushButton[primary="true"] { background: @accent; border-color: @accent; color: @onAccent; }
QPushButton:checked:hover, QPushButton[primary="true"]:hover { border-color: @text; }
QPushButton:checked:focus, QPushButton[primary="true"]:focus { border-color: @text; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QPushButton:disabled { color: @quiet; background: @panel; border-color: @line; }
QPushButton[compact="true"] { padding: 6px 4px; }
QPushButton::menu-indicator { subcontrol-origin: padding; subcontrol-position: center right; }
QPushButton[flat="true"] { background: transparent; border-color: transparent; padding: 2px 8px; }
QPushButton[flat="true"]:hover { background: @raised; }
QPushButton[flat="true"]:checked { background: @accent; }
QPushButton[flat="true"]:focus { border-color: @accent; }
QPushButton[workspace="true"] { background: transparent; border-color: transparent; color: @quiet; padding: 6px 16px; }
QPushButton[workspace="true"]:hover { color: @text; }
QPushButton[workspace="true"]:checked { background: @raised; border-color: @raised; color: @text; }
QPushButton[workspace="true"]:focus { border-color: @accent; }
QPushButton:checked:disabled { color: @quiet; background: @line; border-color: @line; }
QPushButton[segment="true"] { padding: 6px 4px; border-radius: 0; }
QPushButton[segment="first"] { padding: 6px 4px; border-top-right-radius: 0; border-bottom-right-radius: 0; }
QPushButton[segment="last"] { padding: 6px 4px; border-top-left-radius: 0; border-bottom-left-radius: 0; }
QToolButton { background: transparent; border: 1px solid transparent; border-radius: 4px; padding: 3px; }
QToolButton:hover { background: @raised; }
QToolButton:focus { border-color: @accent; }

QSlider { background: transparent; }
QSlider::groove:horizontal { height: 2px; background: @line; border-radius: 1px; }
QSlider::sub-page:horizontal { height: 2px; background: @accent; border-radius: 1px; }
QSlider::add-page:horizontal { height: 2px; background: @line; border-radius: 1px; }
QSlider::handle:horizontal { width: 12px; height: 12px; margin: -6px 0; border-radius: 7px; background: @handle; border: 1px solid @handleEdge; }
QSlider::handle:horizontal:hover { background: @accent; }
QSlider::handle:horizontal:focus { border-color: @accent; background: @accent; }
QSlider::sub-page:horizontal:disabled { background: @line; }
QSlider::handle:horizontal:disabled { background: @quiet; }

QSlider[onScan="true"]::groove:horizontal, QSlider[onScan="true"]::sub-page:horizontal, QSlider[onScan="true"]::add-page:horizontal { background: @scanLine; }
QSlider[onScan="true"]::handle:horizontal { background: @scanText; border-color: #000000; }
QSlider[onScan="true"]::handle:horizontal:hover, QSlider[onScan="true"]::handle:horizontal:focus { background: @scanAccent; border-color: @scanAccent; }
QSlider[onScan="true"]::handle:horizontal:disabled { background: @scanLine; }
QPushButton[onScan="true"] { color: @scanQuiet; padding: 0; text-align: center; border: 1px solid @scanLine; }
QPushButton[onScan="true"]:hover { background: #202326; color: @scanText; }
QPushButton[onScan="true"]:disabled { color: @scanLine; background: transparent; border-color: transparent; }

QComboBox, QLineEdit, QPlainTextEdit, QTextEdit, QSpinBox, QDoubleSpinBox {
  background: @ground; border: 1px solid @line; border-radius: 4px; padding: 4px 8px; selection-background-color: @accent; selection-color: @onAccent; }
QComboBox, QLineEdit, QSpinBox, QDoubleSpinBox { min-height: 20px; }
QComboBox:focus, QLineEdit:focus, QPlainTextEdit:focus, QTextEdit:focus, QSpinBox:focus, QDoubleSpinBox:focus { border-color: @accent; }
QComboBox::drop-down { border: 0; width: 20px; }
QComboBox::down-arrow { image: url(:/ew/icons/@scheme/down.svg); width: 12px; height: 12px; }
QComboBox QAbstractItemView { background: @panel; border: 1px solid @line; selection-background-color: @raised; selection-color: @text; outline: 0; }
QSpinBox::up-button, QDoubleSpinBox::up-button, QSpinBox::down-button, QDoubleSpinBox::down-button { width: 16px; border: 0; background: transparent; }
QSpinBox::up-arrow, QDoubleSpinBox::up-arrow { image: url(:/ew/icons/@scheme/up.svg); width: 10px; height: 10px; }
QSpinBox::down-arrow, QDoubleSpinBox::down-arrow { image: url(:/ew/icons/@scheme/down.svg); width: 10px; height: 10px; }

QTabWidget::pane { border: 0; border-top: 1px solid @line; }
QTabBar { qproperty-drawBase: 0; background: transparent; }
QTabBar::tab { background: transparent; color: @quiet; padding: 10px 16px; border-bottom: 2px solid transparent; }
QTabBar::tab:hover { color: @text; }
QTabBar::tab:selected { color: @text; border-bottom: 2px solid @accent; }
#console QPushButton[segment="first"], #console QPushButton[segment="true"], #console QPushButton[segment="last"] { padding: 4px; }
#consolePages::tab-bar { left: 4px; }
#consolePages QTabBar::tab { padding: 8px 12px; }
#consolePage { background: transparent; }
QScrollArea { border: 0; background: transparent; }
QScrollBar:vertical { width: 8px; background: transparent; margin: 0; }
QScrollBar::handle:vertical { background: @line; border-radius: 4px; min-height: 24px; }
QScrollBar::handle:vertical:hover { background: @quiet; }
QScrollBar:horizontal { height: 8px; background: transparent; margin: 0; }
QScrollBar::handle:horizontal { background: @line; border-radius: 4px; min-width: 24px; }
QScrollBar::add-line, QScrollBar::sub-line, QScrollBar::add-page, QScrollBar::sub-page { width: 0; height: 0; background: transparent; }
QProgressBar { background: @line; border: 0; border-radius: 1px; max-height: 3px; min-height: 3px; }
QProgressBar::chunk { background: @accent; border-radius: 1px; }
QHeaderView::section { background: @panel; color: @quiet; border: 0; border-bottom: 1px solid @line; padding: 6px 8px; }
QTableView, QTreeView, QListView { background: @ground; border: 1px solid @line; border-radius: 4px; gridline-color: @line; outline: 0; }
QTableView::item, QTreeView::item, QListView::item { padding: 6px 8px; border: 0; background: transparent; }
QTableView::item:selected, QTreeView::item:selected, QListView::item:selected { background: @raised; color: @text; }
QSplitter::handle { background: @line; }
QSplitter::handle:horizontal { background: @panel; border-left: 1px solid @line; border-right: 1px solid @line; image: url(:/ew/icons/@scheme/grip.svg); }
QSplitter::handle:horizontal:hover { background: @raised; }
QPushButton[fold="true"] { background: transparent; border: 0; color: @quiet; padding: 6px 0; text-align: left; }
QPushButton[fold="true"]:hover, QPushButton[fold="true"]:checked { background: transparent; color: @text; }
QPushButton[fold="true"]:focus { color: @accent; }
#caseInfo, #caseInfoBody { background: @panel; }
#caseInfo { border-top: 1px solid @line; }
#caseInfoHead { padding: 0 12px; min-height: 36px; font-weight: 600; color: @text; }
QGroupBox { border: 0; border-top: 1px solid @line; margin-top: 16px; padding-top: 8px; }
QGroupBox::title { subcontrol-origin: margin; color: @quiet; padding-right: 8px; }
QCheckBox::indicator, QRadioButton::indicator { width: 14px; height: 14px; border: 1px solid @quiet; background: @ground; }
QCheckBox::indicator { border-radius: 3px; }
QRadioButton::indicator { border-radius: 8px; }
QCheckBox::indicator:checked, QRadioButton::indicator:checked { background: @accent; border-color: @accent; }
QCheckBox:disabled { color: @quiet; }
QCheckBox:focus { color: @accent; }
QCheckBox::indicator:disabled { border-color: @line; background: @panel; }
QCheckBox::indicator:checked { image: url(:/ew/icons/check-on.svg); }

#messageBar { background: @panel; border: 0; border-bottom: 1px solid @line; }
#messageBar[kind="error"] { border-left: 4px solid @danger; }
#messageBar[kind="note"] { border-left: 4px solid @accent; }
#jobCard { background: @panel; border: 1px solid @line; border-radius: 4px; }
#caseCard { background: @panel; border: 1px solid @line; border-radius: 6px; }
#caseCard:hover { border-color: @quiet; }
#caseCard:focus { border-color: @accent; }
#overlay { background: @panel; border: 1px solid @line; border-radius: 6px; }
#keyCap { background: @ground; border: 1px solid @line; border-radius: 4px; padding: 2px 8px; }
)");
  const auto put = [&sheet](const char* name, const QString& value) { sheet.replace(QLatin1Char('@') + QLatin1String(name), value); };
  // Longer names first: "@onAccent" before anything that starts like it, "@handleEdge" before "@handle".
  const Theme scan = scanTheme();
  put("scanLine", scan.line.name());
  put("scanText", scan.text.name());
  put("scanQuiet", scan.quiet.name());
  put("scanAccent", scan.accent.name());
  put("handleEdge", t.dark ? t.panel.name() : t.quiet.name());
  put("handle", t.dark ? QStringLiteral("#e9ebed") : QStringLiteral("#ffffff"));
  put("onAccent", t.onAccent.name());
  put("scheme", t.dark ? QStringLiteral("dark") : QStringLiteral("light"));
  put("veil", t.dark ? QStringLiteral("rgba(18, 19, 21, 200)") : QStringLiteral("rgba(255, 255, 255, 210)"));
  put("hint", t.quiet.name());
  put("panel", t.panel.name());
  put("ground", t.ground.name());
  put("raised", t.raised.name());
  put("line", t.line.name());
  put("text", t.text.name());
  put("quiet", t.quiet.name());
  put("accent", t.accent.name());
  put("danger", t.danger.name());
  return sheet;
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
  t.text = QColor(0xe9, 0xeb, 0xed);
  t.quiet = QColor(0x9b, 0xa1, 0xa8);
  t.accent = QColor(0x4f, 0xb3, 0xbf);
  t.onAccent = QColor(0x0d, 0x1a, 0x1c);
  t.danger = QColor(0xe0, 0x5a, 0x4e);
  return t;
}

Theme lightTheme() {
  Theme t;
  t.dark = false;
  t.panel = QColor(0xfb, 0xfb, 0xfc);
  t.ground = QColor(0xee, 0xf0, 0xf2);
  t.raised = QColor(0xe2, 0xe5, 0xe8);
  t.line = QColor(0xd0, 0xd5, 0xd9);
  t.text = QColor(0x1d, 0x20, 0x23);
  t.quiet = QColor(0x5c, 0x64, 0x6c);
  t.accent = QColor(0x0f, 0x7d, 0x8a);
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
}

QFont textFont() { return fontOf(kTextSize_px); }
QFont smallFont() { return fontOf(kSmallSize_px); }

}  // namespace ew::ui
