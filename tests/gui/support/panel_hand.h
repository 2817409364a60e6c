#pragma once

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTest>
#include <QWidget>

#include "gui/support/window_fixture.h"

namespace ew::ui::testing {

/// A user's hand in one panel or dialog: it finds what can be seen there, by name, and does with it what a user does. What is not there
/// fails the test with its name.
class PanelHand {
 public:
  explicit PanelHand(QWidget* panel) : panel_(panel) {}

  template <class Widget>
  [[nodiscard]] Widget* seen(const char* name) const {
    if (panel_ == nullptr) return nullptr;
    for (Widget* each : panel_->findChildren<Widget*>(QLatin1String(name)))
      if (each->isVisible()) return each;
    return nullptr;
  }
  [[nodiscard]] QString text(const char* name) const {
    const auto* label = seen<QLabel>(name);
    return label == nullptr ? QString() : label->text();
  }
  void press(const char* name) const {
    QVERIFY2(waitUntil([&] { return seen<QAbstractButton>(name) != nullptr && seen<QAbstractButton>(name)->isEnabled(); }), name);
    seen<QAbstractButton>(name)->click();
    QCoreApplication::processEvents();
  }
  void type(const char* name, const QString& text) const {
    QVERIFY2(waitUntil([&] { return seen<QLineEdit>(name) != nullptr || seen<QPlainTextEdit>(name) != nullptr; }), name);
    if (auto* line = seen<QLineEdit>(name)) {
      line->selectAll();
      QTest::keyClicks(line, text);
    } else {
      seen<QPlainTextEdit>(name)->selectAll();
      QTest::keyClicks(seen<QPlainTextEdit>(name), text);
    }
  }
  void set(const char* name, double value) const {
    QVERIFY2(seen<QDoubleSpinBox>(name), name);
    seen<QDoubleSpinBox>(name)->setValue(value);
  }
  void choose(const char* name, const QString& text) const {
    auto* choice = seen<QComboBox>(name);
    QVERIFY2(choice, name);
    const int at = choice->findText(text);
    QVERIFY2(at >= 0, qPrintable(text));
    choice->setCurrentIndex(at);
    Q_EMIT choice->activated(at);
    QCoreApplication::processEvents();
  }
  /// An entry of the menu that a button opens.
  void pick(const char* button, const QString& entry) const {
    auto* opens = seen<QPushButton>(button);
    QVERIFY2(opens && opens->menu(), button);
    Q_EMIT opens->menu()->aboutToShow();
    for (QAction* action : opens->menu()->actions())
      if (action->objectName() == entry) {
        action->trigger();
        QCoreApplication::processEvents();
        return;
      }
    QFAIL(qPrintable(entry));
  }

 private:
  QWidget* panel_;
};

}  // namespace ew::ui::testing
