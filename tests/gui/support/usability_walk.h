#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QButtonGroup>
#include <QComboBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QTabBar>
#include <QTest>
#include <QTextDocument>
#include <QTextEdit>
#include <algorithm>
#include <cmath>
#include <set>

#include "ew/widgets/ellipsis_label.h"
#include "ew/widgets/figures.h"

// Looks at every widget of a page as a person with large type, a keyboard or a screen reader would. Each function gives sentences about
// what is wrong; none when nothing is.
namespace ew::ui::testing {

/// How a widget is found again by who reads a failure.
inline QString nameOf(const QWidget& widget) {
  QStringList way;
  for (const QWidget* each = &widget; each != nullptr && way.size() < 4; each = each->parentWidget())
    way.prepend(each->objectName().isEmpty() ? QString::fromLatin1(each->metaObject()->className()) : each->objectName());
  return way.join(QLatin1Char('/'));
}

inline std::vector<QWidget*> visibleIn(QWidget& root) {
  std::vector<QWidget*> seen;
  for (QWidget* each : root.findChildren<QWidget*>())
    if (each->isVisible() && each->window() == root.window()) seen.push_back(each);
  return seen;
}

inline QString plain(QString text) {
  if (Qt::mightBeRichText(text)) {
    QTextDocument document;
    document.setHtml(text);
    text = document.toPlainText();
  }
  return text.remove(QLatin1Char('&'));
}

inline int widestLine_px(const QFontMetrics& metrics, const QString& text) {
  int widest = 0;
  for (const QString& line : text.split(QLatin1Char('\n'))) widest = std::max(widest, metrics.horizontalAdvance(line));
  return widest;
}

/// Words that do not fit into their widget, but for those that end in an ellipsis, and pages that are wider than what scrolls them.
inline QStringList cutTexts(QWidget& root) {
  QStringList wrong;
  const auto say = [&wrong](const QWidget& widget, const QString& text, int wanted, int has) {
    wrong << QStringLiteral("%1 '%2': %3 of %4 px").arg(nameOf(widget), text.left(60)).arg(has).arg(wanted);
  };
  for (QWidget* each : visibleIn(root)) {
    if (const auto* label = qobject_cast<const QLabel*>(each)) {
      if (label->text().isEmpty() || qobject_cast<const EllipsisLabel*>(each) != nullptr) continue;
      if (label->wordWrap()) {
        const int wanted = label->heightForWidth(label->width());
        if (label->height() + 2 < wanted) say(*each, label->text(), wanted, label->height());
      } else if (qobject_cast<const FigureLabel*>(each) != nullptr) {
        const int wanted = figuresWidth_px(label->fontMetrics(), label->text());
        if (label->width() + 1 < wanted) say(*each, label->text(), wanted, label->width());
      } else {
        const QMargins edges = label->contentsMargins();
        const int wanted = widestLine_px(label->fontMetrics(), plain(label->text())) + edges.left() + edges.right();
        if (label->minimumSizeHint().width() + 1 < wanted) continue;  // a kind of its own, which ends in an ellipsis
        if (label->width() + 1 < wanted) say(*each, label->text(), wanted, label->width());
        if (label->height() + 2 < label->fontMetrics().height()) say(*each, label->text(), label->fontMetrics().height(), label->height());
      }
    } else if (const auto* button = qobject_cast<const QAbstractButton*>(each)) {
      if (button->text().isEmpty()) continue;
      const int icon_px = button->icon().isNull() ? 0 : button->iconSize().width();
      const int wanted = widestLine_px(button->fontMetrics(), plain(button->text())) + icon_px;
      if (button->width() < wanted) say(*each, button->text(), wanted, button->width());
      if (button->height() < button->fontMetrics().height()) say(*each, button->text(), button->fontMetrics().height(), button->height());
    } else if (const auto* box = qobject_cast<const QComboBox*>(each)) {
      if (box->height() < box->fontMetrics().height()) say(*each, box->currentText(), box->fontMetrics().height(), box->height());
    } else if (const auto* tabs = qobject_cast<const QTabBar*>(each)) {
      for (int n = 0; n < tabs->count(); ++n) {
        const int wanted = tabs->fontMetrics().horizontalAdvance(plain(tabs->tabText(n)));
        if (tabs->isTabVisible(n) && tabs->tabRect(n).width() < wanted) say(*each, tabs->tabText(n), wanted, tabs->tabRect(n).width());
      }
    } else if (const auto* scrolled = qobject_cast<const QScrollArea*>(each)) {
      const QWidget* body = scrolled->widget();
      if (body == nullptr || scrolled->horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff) continue;
      if (body->width() > scrolled->viewport()->width()) say(*each, QStringLiteral("page"), body->width(), scrolled->viewport()->width());
    }
  }
  return wrong;
}

/// What keeps a window from becoming narrower than `width_px`: widgets none of whose parts is as much too wide.
inline QStringList wideWidgets(QWidget& root, int width_px) {
  QStringList wide;
  for (QWidget* each : visibleIn(root)) {
    const int wanted = std::max(each->minimumSizeHint().width(), each->minimumWidth());
    if (wanted > width_px / 4) wide << QStringLiteral("%1: %2").arg(nameOf(*each)).arg(wanted);
  }
  return wide;
}

/// Controls of which a screen reader could only say what kind they are.
inline QStringList namelessControls(QWidget& root) {
  QStringList nameless;
  for (QWidget* each : visibleIn(root)) {
    const bool isControl = each->focusPolicy() != Qt::NoFocus || qobject_cast<QAbstractButton*>(each) != nullptr ||
                           qobject_cast<QComboBox*>(each) != nullptr || qobject_cast<QAbstractSlider*>(each) != nullptr;
    const bool isPartOfAnother = qobject_cast<QScrollBar*>(each) != nullptr || each->objectName().startsWith(QStringLiteral("qt_")) ||
                                 qobject_cast<QAbstractSpinBox*>(each->parentWidget()) != nullptr ||
                                 qobject_cast<QLineEdit*>(each->parentWidget()) != nullptr ||
                                 qobject_cast<QComboBox*>(each->parentWidget()) != nullptr;
    // A page that scrolls is read by what is on it.
    if (!isControl || isPartOfAnother || each->focusProxy() != nullptr || qobject_cast<QScrollArea*>(each) != nullptr) continue;
    QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(each);
    if (interface == nullptr || interface->text(QAccessible::Name).trimmed().isEmpty())
      nameless << QStringLiteral("%1 (%2)").arg(nameOf(*each), QString::fromLatin1(each->metaObject()->className()));
  }
  return nameless;
}

/// Every text a person sees here, with where it stands. Not what was typed or read from files by views of their own.
inline std::vector<std::pair<QString, QString>> textsIn(QWidget& root) {
  std::vector<std::pair<QString, QString>> texts;
  const auto add = [&texts](const QWidget& widget, const QString& text) {
    if (!text.isEmpty()) texts.emplace_back(nameOf(widget), text);
  };
  for (QWidget* each : visibleIn(root)) {
    add(*each, each->toolTip());
    if (const auto* label = qobject_cast<const QLabel*>(each)) add(*each, label->text());
    if (const auto* button = qobject_cast<const QAbstractButton*>(each)) add(*each, button->text());
    if (const auto* group = qobject_cast<const QGroupBox*>(each)) add(*each, group->title());
    if (const auto* line = qobject_cast<const QLineEdit*>(each)) add(*each, line->placeholderText());
    if (const auto* box = qobject_cast<const QComboBox*>(each))
      for (int n = 0; n < box->count(); ++n) add(*each, box->itemText(n));
    if (const auto* tabs = qobject_cast<const QTabBar*>(each))
      for (int n = 0; n < tabs->count(); ++n) add(*each, tabs->tabText(n));
  }
  for (const QAction* action : root.findChildren<QAction*>())
    if (!action->isSeparator() && !action->text().isEmpty() && action->objectName().indexOf(QStringLiteral("qt_")) != 0)
      texts.emplace_back(QStringLiteral("menu"), action->text());
  return texts;
}

/// What the tab key is to reach: whatever takes the focus by it and is not the unchosen one of several.
inline std::vector<QWidget*> tabStops(QWidget& root) {
  std::vector<QWidget*> stops;
  for (QWidget* each : visibleIn(root)) {
    if ((each->focusPolicy() & Qt::TabFocus) == 0 || !each->isEnabled() || each->focusProxy() != nullptr) continue;
    if (each->objectName().startsWith(QStringLiteral("qt_"))) continue;
    const auto* button = qobject_cast<const QAbstractButton*>(each);
    const bool isOneOfSeveral =
        button != nullptr && (button->autoExclusive() || (button->group() != nullptr && button->group()->exclusive()));
    if (isOneOfSeveral && !button->isChecked()) continue;
    stops.push_back(each);
  }
  return stops;
}

/// Whether the tab key came to it, or to another one of those that are chosen from.
inline bool isReached(const QWidget& stop, const std::set<const QWidget*>& reached) {
  if (reached.count(&stop) != 0) return true;
  const auto* button = qobject_cast<const QAbstractButton*>(&stop);
  if (button == nullptr || button->group() == nullptr) return false;
  const auto others = button->group()->buttons();
  return std::any_of(others.begin(), others.end(), [&](const QAbstractButton* each) { return reached.count(each) != 0; });
}

}  // namespace ew::ui::testing
