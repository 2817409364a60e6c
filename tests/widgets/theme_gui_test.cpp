// Theme, size of text and looks, as the program and a plugin with a copy of the library see them.

#include <QLabel>
#include <QLibrary>
#include <QtTest>

#include "ew/widgets/apply_theme.h"
#include "ew/widgets/icons.h"
#include "ew/widgets/look.h"

namespace ew {

class ThemeTest final : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    setTextSize(100);
    applyTheme(darkTheme());
  }

  void aCopyOfTheLibrarySeesTheThemeOfTheProgram() {
    const auto isDark = symbol<bool (*)()>("copyIsDark");
    QVERIFY(isDark());
    applyTheme(lightTheme());
    QVERIFY(!isDark());
    QVERIFY(!currentTheme().dark);
  }

  void aCopyOfTheLibrarySeesTheSizeOfText() {
    const auto scaledByCopy = symbol<int (*)(int)>("copyScaled");
    setTextSize(150);
    QCOMPARE(scaledByCopy(10), 15);
    const UsualTextSize usual;
    QCOMPARE(scaledByCopy(10), 10);
  }

  void aSizeThatACopyHoldsFollowsTheProgram() {
    QWidget widget;
    symbol<void (*)(QWidget*, int)>("copyHoldsWidth")(&widget, 40);
    QCOMPARE(widget.maximumWidth(), 40);
    setTextSize(200);
    applyTheme(darkTheme());
    QCOMPARE(widget.maximumWidth(), 80);
  }

  void iconsComeWithTheTheme() { QVERIFY(!icon(QStringLiteral("play")).isNull()); }

  void aLookIsSeenAtOnceAndTakenAway() {
    QLabel label(QStringLiteral("saved"));
    label.ensurePolished();
    setLook(&label, Look::quiet);
    QVERIFY(hasLook(&label, Look::quiet));
    QCOMPARE(label.palette().color(QPalette::WindowText), currentTheme().quiet);
    setLook(&label, Look::quiet, false);
    QVERIFY(!hasLook(&label, Look::quiet));
    QCOMPARE(label.palette().color(QPalette::WindowText), currentTheme().text);
  }

  void theThreeSegmentsAreOneLookEach() {
    QWidget widget;
    setLook(&widget, Look::firstOf);
    QVERIFY(hasLook(&widget, Look::firstOf) && !hasLook(&widget, Look::lastOf) && !hasLook(&widget, Look::segment));
  }

 private:
  template <class Function>
  Function symbol(const char* name) {
    const auto found = reinterpret_cast<Function>(QLibrary::resolve(QStringLiteral(EW_COPY_OF_WIDGETS), name));
    if (found == nullptr) qFatal("%s is not in the copy of the library", name);
    return found;
  }
};

}  // namespace ew

QTEST_MAIN(ew::ThemeTest)
#include "theme_gui_test.moc"
