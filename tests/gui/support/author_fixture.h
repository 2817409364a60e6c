#pragma once

#include <QAction>
#include <QComboBox>
#include <QPushButton>
#include <QToolButton>

#include "ew/library/case.h"
#include "ew/library/new_case.h"
#include "ew/library/probe_side.h"
#include "gui/support/window_fixture.h"

namespace ew::ui::testing {

/// A window with an author in it: cases of the test's own, the Case panel, the dialogs that make and publish a case.
class AuthorFixture : public WindowFixture {
 protected:
  [[nodiscard]] CaseDocument& document() const { return window_->document(); }
  [[nodiscard]] QWidget* panel() const { return window_->findChild<QWidget*>(QStringLiteral("casePanel")); }
  template <class Widget>
  [[nodiscard]] Widget* inPanel(const char* name) const {
    return panel() != nullptr ? panel()->findChild<Widget*>(QLatin1String(name)) : nullptr;
  }
  [[nodiscard]] QAction* action(const QString& text) const {
    for (QAction* each : window_->findChildren<QAction*>())
      if (each->text().contains(text)) return each;
    return nullptr;
  }
  [[nodiscard]] bool waitForRest() const {
    return waitUntil([this] { return window_->isSettled(); });
  }
  void showWindow() {
    window_ = std::make_unique<MainWindow>();
    window_->resize(1280, 720);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get(), static_cast<int>(test::kPatience_ms)));
    QApplication::setActiveWindow(window_.get());
    session().frames().setAdaptive(false);
    window_->openPlugins();
    QVERIFY(waitUntil([this] { return !window_->jobs().isRunning(); }));
  }
  /// Opens a case in Author, with the Case panel in front.
  void author(const QString& folder) {
    QVERIFY(openCase(folder));
    window_->setWorkspace(Workspace::author);
    QTest::qWait(50);
    QVERIFY(panel() != nullptr);
  }
  [[nodiscard]] QWidget* newCaseDialog() {
    action(QStringLiteral("New case"))->trigger();
    QWidget* dialog = nullptr;
    if (!waitUntil([&] { return (dialog = topLevel("newCaseDialog")) != nullptr && dialog->isVisible(); })) return nullptr;
    return dialog;
  }
  [[nodiscard]] static QWidget* topLevel(const char* name) {
    for (QWidget* each : QApplication::topLevelWidgets())
      if (each->objectName() == QLatin1String(name) && each->isVisible()) return each;
    return nullptr;
  }
  /// Answers from which side the chosen volume was scanned, once that is asked.
  static void chooseFront(const QWidget& dialog) {
    auto* side = dialog.findChild<QComboBox*>(QStringLiteral("sourceSide"));
    QVERIFY(waitUntil([&] { return side->isVisible(); }));
    side->setCurrentIndex(side->findData(static_cast<int>(VolumeSide::front)));
  }
  /// Everything a case needs before it is published, but for what its volume and its start decide.
  void fill() {
    Case filled = withRights(*document().current(), {"Made by a test.", "CC0 1.0"});
    filled.titleForTrainees = "Upper abdomen, routine";
    filled.region = "upper abdomen";
    filled.indication = "To be looked at.";
    filled.findings = {"Nothing remarkable."};
    filled.diagnosis = "Healthy.";
    filled.difficulty = 1;
    filled.startPose.emplace().probeToWorld = session().probeControl().pose().probeToWorld;
    const auto edited = document().edit(filled, "Fill in", {});
    QVERIFY2(edited, edited ? "" : edited.error().sentence().c_str());
  }
  [[nodiscard]] QWidget* publishDialog() {
    inPanel<QPushButton>("publishCase")->click();
    QWidget* dialog = nullptr;
    if (!waitUntil([&] { return (dialog = topLevel("publishDialog")) != nullptr; })) return nullptr;
    if (!waitUntil([&] { return dialog->findChild<QToolButton*>(QStringLiteral("checkItem_0")) != nullptr; })) return nullptr;
    return dialog;
  }
  [[nodiscard]] static QToolButton* itemFor(const QWidget& dialog, const QString& field) {
    for (auto* each : dialog.findChildren<QToolButton*>())
      if (each->property("field").toString() == field) return each;
    return nullptr;
  }
};

}  // namespace ew::ui::testing
