// The whole window as people meet it who read large type, German or from the right, who use keys alone or have it read aloud, and who see
// it for the first time.
#include <QCheckBox>
#include <QRegularExpression>
#include <QScreen>
#include <cmath>
#include <cstdio>

#include "ew/ui_test_door/window.h"
#include "ew/widgets/apply_theme.h"
#include "ew/widgets/focus_ring.h"
#include "gui/support/usability_fixture.h"

namespace ew::ui::testing {

class UsabilityTest : public UsabilityFixture {
  Q_OBJECT

  static void addLanguages() {
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << QStringLiteral("en");
    QTest::newRow("German") << QStringLiteral("de");
  }
  static void addLanguagesAndSizesOfText() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<int>("text_percent");
    addLanguagesAndSizes();
  }
  static void failOn(const QStringList& wrong) {
    for (const QString& each : wrong) fprintf(stderr, "  %s\n", qPrintable(each));  // a long message would be cut
    QVERIFY2(wrong.isEmpty(), qPrintable(QString::number(wrong.size())));
  }
  [[nodiscard]] QRect inWindow(const QWidget* widget) const { return {widget->mapTo(window_.get(), QPoint()), widget->size()}; }

 private Q_SLOTS:
  void initTestCase() { initUsabilityTranslations(); }
  void cleanup() { beSilent(); }

  void aSmallWindowKeepsItsSize_data() { addLanguages(); }
  void aSmallWindowKeepsItsSize() {
    QFETCH(QString, language);
    showWindow(language, 100, {1024, 640});
    QStringList wrong;
    walkPages([&](const QString& page) {
      window_->resize(1024, 640);
      QTest::qWait(10);
      if (window_->size() == QSize(1024, 640)) return;
      wrong << QStringLiteral("%1: %2 x %3").arg(page).arg(window_->width()).arg(window_->height());
      wrong << wideWidgets(*window_, window_->width());
    });
    failOn(wrong);
  }

  void noTextIsCut_data() { addLanguagesAndSizesOfText(); }
  void noTextIsCut() {
    QFETCH(QString, language);
    QFETCH(int, text_percent);
    showWindow(language, text_percent);
    QStringList wrong;
    const auto look = [&](const QString& page, QWidget& root) {
      // The window keeps the size it was given; a dialog takes what it needs of the screen.
      const QSize room = &root == window_.get() ? QSize(1440, 900) : root.screen()->availableSize();
      if (root.width() > room.width() || root.height() > room.height())
        wrong << QStringLiteral("%1 is as large as %2 x %3").arg(page).arg(root.width()).arg(root.height())
              << wideWidgets(root, room.width());
      // A panel may still be looking at its case.
      static_cast<void>(waitUntil([&root] { return cutTexts(root).isEmpty(); }, 2000.0));
      // Paragraphs whose page or form gives them too few lines with large words; accessibility.md says so.
      const QRegularExpression known(QStringLiteral("/importFrames|/importSize|/importMemory|/contactVerdict|/contactFigures"));
      const bool isLarge = text_percent > 100;
      for (const QString& each : cutTexts(root))
        if (!isLarge || !(each.contains(known) || page.contains(QStringLiteral("panel_placing"))))
          wrong << page + QStringLiteral(": ") + each;
      keepScreenshot(root, qPrintable(QStringLiteral("%1-%2-%3").arg(language).arg(text_percent).arg(QString(page).replace(' ', '_'))));
    };
    walkPages([&](const QString& page) { look(page, *window_); });
    walkDialogs(look);
    wrong.removeDuplicates();
    failOn(wrong);
  }

  /// Whoever scans has the console at any size: by itself, or behind a tab that is there.
  void theConsoleIsReachedAtAnySize_data() { addLanguagesAndSizesOfText(); }
  void theConsoleIsReachedAtAnySize() {
    QFETCH(QString, language);
    QFETCH(int, text_percent);
    showWindow(language, text_percent);
    failOn(whatIsNotReachedBeforeAndInALesson(QStringLiteral("%1-%2").arg(language).arg(text_percent)));
  }

  void theFirstMessageIsWholeWhateverTheSizeOfWords() {
    showWindow(QStringLiteral("en"), 200, {1366, 768});
    window_->messages().showNote(
        QStringLiteral("The step goes on where it stood when the program ended; what was entered by hand has to be entered again."));
    QTest::qWait(100);
    const auto* said = window_->messages().findChild<QLabel*>(QStringLiteral("messageText"));
    QVERIFY(said != nullptr && said->isVisible());
    QVERIFY2(said->height() >= said->heightForWidth(said->width()),
             qPrintable(QStringLiteral("%1 of %2 px").arg(said->height()).arg(said->heightForWidth(said->width()))));
  }

  void theScanAloneHasAnEdgeThatLeadsBack() {
    showWindow(QStringLiteral("en"), 100, {1280, 720});
    action("Scan &only")->trigger();
    QTest::qWait(20);
    QVERIFY(!window_->console().isVisible() && !find<QWidget>("panel_lessons")->isVisible());
    auto* back = find<QPushButton>("showColumns");
    QVERIFY(isReachedByMouse(back));
    QTest::mouseClick(back, Qt::LeftButton);
    QVERIFY(window_->console().isVisible() && !back->isVisible());
    QVERIFY(find<QWidget>("panel_lessons")->isVisible());
    action("&Body and case")->trigger();
    QVERIFY(window_->view3d().isVisible() && !find<QWidget>("panel_lessons")->isVisible());
    action("&Next column")->trigger();
    QVERIFY(!window_->view3d().isVisible() && find<QWidget>("panel_lessons")->isVisible());
  }

  void theTextSizeIsChosenInTheMenuAndKept() {
    showWindow(QStringLiteral("en"));
    auto* brand = find<QLabel>("title");
    const int usual_px = brand->fontMetrics().height();
    const int console_px = window_->console().width();
    action("&Larger text")->trigger();
    QVERIFY(brand->fontMetrics().height() > usual_px);
    for (int n = 0; n < 5; ++n) action("&Larger text")->trigger();
    QCOMPARE(textSize_percent(), 200);
    QVERIFY2(brand->fontMetrics().height() >= 2 * usual_px - 2, "twice as high");
    QCOMPARE(window_->console().width(), 2 * console_px);
    window_.reset();
    setTextSize(100);
    showWindowWithCase(case_);
    QCOMPARE(textSize_percent(), 200);
    for (int n = 0; n < 9; ++n) action("&Smaller text")->trigger();
    QCOMPARE(find<QLabel>("title")->fontMetrics().height(), usual_px);
    QCOMPARE(window_->console().width(), console_px);
  }

  void everyControlHasAName_data() { addLanguages(); }
  void everyControlHasAName() {
    QFETCH(QString, language);
    showWindow(language);
    QStringList wrong;
    const auto look = [&](const QString& page, QWidget& root) {
      for (const QString& each : namelessControls(root)) wrong << page + QStringLiteral(": ") + each;
    };
    walkPages([&](const QString& page) { look(page, *window_); });
    walkDialogs(look);
    wrong.removeDuplicates();
    failOn(wrong);
  }

  void everyTextPassesThroughATranslation() {
    showWindow(kPseudoLanguage);
    QStringList wrong;
    // Names of this test's own case, of languages, units and keys are the same in every language.
    const QRegularExpression words(QStringLiteral("[A-Za-z]{4,}"));
    const QStringList data{"Window test",
                           "upper abdomen",
                           "Test Person",
                           "window-test",
                           "The ball",
                           "A ball is found and measured.",
                           "English",
                           "Deutsch",
                           "EchoWeave",
                           "Title of ",
                           "What to do",
                           "Healthy.",
                           "To be looked at.",
                           "volume.mha",
                           "case.json",
                           "Pain.",
                           "window-test-",
                           "sweep.igs.mha",
                           "one with a long name"};
    const QStringList lists{QStringLiteral("/probe"),       QStringLiteral("/mannequin"),
                            QStringLiteral("probe_"),       QStringLiteral("worksheetChoice"),
                            QStringLiteral("regionFilter"), QStringLiteral("tagFilter"),
                            QStringLiteral("courseTitle"),  QStringLiteral("worksheetDialog/QLabel"),
                            QStringLiteral("QWidget/frame")};  // of data that have names
    const auto look = [&](const QString& page, QWidget& root) {
      for (const auto& [where, text] : textsIn(root)) {
        const QString shown = plain(text);
        if (std::any_of(lists.begin(), lists.end(), [&, at = where](const QString& each) { return at.contains(each); })) continue;
        if (shown.contains(QLatin1Char('[')) || !shown.contains(words) || shown.contains(files_.path({}))) continue;
        if (std::any_of(data.begin(), data.end(), [&](const QString& each) { return shown.contains(each); })) continue;
        wrong << QStringLiteral("%1: %2 '%3'").arg(page, where, shown.left(80));
      }
      keepScreenshot(root, qPrintable(QStringLiteral("rtl-%1").arg(QString(page).replace(' ', '_'))));
    };
    walkPages([&](const QString& page) { look(page, *window_); });
    walkDialogs(look);
    wrong.removeDuplicates();
    failOn(wrong);
  }

  void aWindowReadFromTheRightIsMirroredButNotItsImages() {
    showWindow(QStringLiteral("en"));
    const QPoint scan = inWindow(&window_->scanView()).center(), console = inWindow(&window_->console()).center();
    session().makeImageNow();
    const std::vector<std::uint8_t> image = pixelsOf(session());
    const QSize size = window_->scanView().size();
    const QImage shown = window_->scanView().grab(QRect(0, 60, size.width(), size.height() - 120)).toImage();
    QVERIFY(scan.x() < console.x());
    beSilent();
    showWindow(kPseudoLanguage);
    QVERIFY(inWindow(&window_->scanView()).center().x() > inWindow(&window_->console()).center().x());
    QVERIFY(inWindow(&window_->view3d()).center().x() > inWindow(&window_->scanView()).center().x());
    QCOMPARE(window_->scanView().size(), size);
    session().makeImageNow();
    QVERIFY(pixelsOf(session()) == image);
    const QImage mirrored = window_->scanView().grab(QRect(0, 60, size.width(), size.height() - 120)).toImage();
    QVERIFY2(mirrored.copy(90, 0, size.width() - 180, mirrored.height()) == shown.copy(90, 0, size.width() - 180, shown.height()),
             "image, marker and sliders stay at their sides");
    QCOMPARE(find<QSlider>("dgc1")->layoutDirection(), Qt::LeftToRight);
    QCOMPARE(find<QWidget>("cineLine")->layoutDirection(), Qt::LeftToRight);
    QCOMPARE(find<QSlider>("gain")->layoutDirection(), Qt::RightToLeft);
  }

  void everyControlIsReachedWithTabAndShowsIt_data() {
    QTest::addColumn<bool>("dark");
    QTest::newRow("dark") << true;
    QTest::newRow("light") << false;
  }
  void everyControlIsReachedWithTabAndShowsIt() {
    QFETCH(bool, dark);
    showWindow(QStringLiteral("en"));
    window_->setDarkTheme(dark);
    QStringList wrong;
    const auto look = [&](const QString& page, QWidget& root) {
      root.activateWindow();
      QApplication::setActiveWindow(&root);
      const std::vector<QWidget*> stops = tabStops(root);
      if (stops.empty()) return;
      QTest::keyClick(&root, Qt::Key_Tab);
      stops.front()->setFocus(Qt::TabFocusReason);
      std::set<const QWidget*> reached;
      QString way;
      for (std::size_t n = 0; n < 3 * stops.size() + 20; ++n) {
        QWidget* at = QApplication::focusWidget();
        if (at == nullptr || at->window() != &root) break;
        const bool isNew = reached.insert(at).second;
        if (isNew) {
          const QRect around = QRect(at->mapTo(&root, QPoint()), at->size()).adjusted(-3, -3, 3, 3).intersected(root.rect());
          const QImage with = root.grab(around).toImage();
          at->clearFocus();
          const QImage without = root.grab(around).toImage();
          at->setFocus(Qt::TabFocusReason);
          if (with == without && at->isEnabled() && qobject_cast<QScrollArea*>(at) == nullptr)
            wrong << page + QStringLiteral(": no mark of the focus: ") + nameOf(*at);
        }
        QTest::keyClick(at, Qt::Key_Tab);
        if (QApplication::focusWidget() == at) {
          wrong << page + QStringLiteral(": the tab key does not leave ") + nameOf(*at);
          QTest::keyClick(at, Qt::Key_Tab, Qt::ControlModifier);
          if (QApplication::focusWidget() == at) break;
        }
      }
      for (const QWidget* each : stops)
        if (!isReached(*each, reached) && each->isVisible() && each->isEnabled())
          wrong << page + QStringLiteral(": not reached: ") + nameOf(*each);
    };
    walkPages([&](const QString& page) { look(page, *window_); });
    walkDialogs(look);
    wrong.removeDuplicates();
    failOn(wrong);
  }

  void spacePressesAButtonThatWasReachedByKeysAndElseFreezes() {
    showWindow(QStringLiteral("en"));
    auto* flip = find<QPushButton>("flip");
    QVERIFY(flip->isVisible() && !flip->isChecked());
    flip->setFocus(Qt::TabFocusReason);
    QTest::keyClick(flip, Qt::Key_Space);
    QVERIFY(flip->isChecked());
    QVERIFY(!session().isFrozen());
    flip->setFocus(Qt::MouseFocusReason);
    window_->scanView().setFocus(Qt::MouseFocusReason);
    QTest::keyClick(&window_->scanView(), Qt::Key_Space);
    QVERIFY(session().isFrozen());
  }

  void aScreenReaderLearnsOfCardsAndTimeLines() {
    showWindow(QStringLiteral("en"));
    auto* line = find<QWidget>("cineLine");
    QAccessibleInterface* told = QAccessible::queryAccessibleInterface(line);
    QVERIFY(told);
    QCOMPARE(told->role(), QAccessible::Slider);
    QVERIFY(told->valueInterface());
    window_->showStartPage();
    QVERIFY(waitUntil([this] { return window_->isSettled(); }));
    QAccessibleInterface* cards = QAccessible::queryAccessibleInterface(find<QWidget>("caseCards"));
    QVERIFY(cards);
    for (int n = 0; n < cards->childCount(); ++n) QVERIFY(!cards->child(n)->text(QAccessible::Name).isEmpty());
  }

  void coloursKeepApart() {
    const auto light = [](const QColor& colour) {
      const auto linear = [](double share) { return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4); };
      return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
    };
    // W3C, Web Content Accessibility Guidelines 2.1: contrast ratio.
    const auto contrast = [&](const QColor& a, const QColor& b) {
      return (std::max(light(a), light(b)) + 0.05) / (std::min(light(a), light(b)) + 0.05);
    };
    QCOMPARE(std::round(contrast(Qt::black, Qt::white)), 21.0);
    QStringList wrong;
    const auto check = [&](const char* theme, const char* what, const QColor& a, const QColor& b, double least) {
      if (contrast(a, b) < least) wrong << QStringLiteral("%1, %2: %3").arg(QLatin1String(theme), QLatin1String(what)).arg(contrast(a, b));
    };
    for (const auto& [name, t] : {std::pair{"dark", darkTheme()}, std::pair{"light", lightTheme()}, std::pair{"scan", scanTheme()}}) {
      for (const QColor& ground : {t.panel, t.ground, t.raised}) {
        check(name, "text", t.text, ground, 4.5);
        check(name, "quiet text", t.quiet, ground, 4.5);
        check(name, "accent", t.accent, ground, 4.5);
        check(name, "edge", t.edge, ground, 3.0);
      }
      for (const QColor& ground : {t.panel, t.ground}) check(name, "danger", t.danger, ground, 4.5);
      check(name, "on the accent", t.onAccent, t.accent, 4.5);
    }
    failOn(wrong);
  }

  void theTourShowsTheWindowAndIsLeftAtAnyMoment_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<int>("text_percent");
    QTest::addColumn<QSize>("size");
    QTest::newRow("English") << QStringLiteral("en") << 100 << QSize(1440, 900);
    QTest::newRow("German, small window") << QStringLiteral("de") << 100 << QSize(1024, 640);
    QTest::newRow("German, large words") << QStringLiteral("de") << 200 << QSize(1440, 900);
    QTest::newRow("from the right") << kPseudoLanguage << 100 << QSize(1280, 720);
  }
  void theTourShowsTheWindowAndIsLeftAtAnyMoment() {
    QFETCH(QString, language);
    QFETCH(int, text_percent);
    QFETCH(QSize, size);
    showWindow(language, text_percent, size);
    window_->offerTour();
    auto* tour = find<Tour>("tourBubble");
    QVERIFY(tour && tour->isVisible());
    QStringList names;
    for (int n = 0; n < 12 && tour->isVisible(); ++n) {
      QTest::qWait(200);
      auto* name = tour->findChild<QLabel*>(QStringLiteral("tourName"));
      names << name->text();
      keepScreenshot(*window_, qPrintable(QStringLiteral("tour-%1-%2-%3").arg(language).arg(text_percent).arg(n)));
      QVERIFY2(window_->rect().contains(inWindow(tour)), qPrintable(name->text()));
      failOn(cutTexts(*tour));
      auto* ring = find<QWidget>("tourRing");
      QVERIFY2(ring->isVisible(), qPrintable(name->text()));
      QVERIFY2(!ring->mask().contains(ring->rect().center()), "what is pointed at is not covered");
      QTest::keyClick(QApplication::focusWidget(), language == kPseudoLanguage ? Qt::Key_Left : Qt::Key_Right);
    }
    QVERIFY2(!tour->isVisible(), "it ends");
    QCOMPARE(names.removeDuplicates(), 0);
    QVERIFY2(names.size() >= 5 && names.size() <= 8, qPrintable(names.join(QLatin1Char('\n'))));
  }

  void theTourComesOnceBlocksNothingAndComesBackOnRequest() {
    showWindow(QStringLiteral("en"));
    window_->offerTour();
    auto* tour = find<Tour>("tourBubble");
    QVERIFY(tour);
    // The window is worked with beside it, by mouse and by keys.
    auto* flip = find<QPushButton>("flip");
    QTest::mouseClick(flip, Qt::LeftButton);
    QVERIFY(flip->isChecked() && tour->isVisible());
    window_->scanView().setFocus(Qt::MouseFocusReason);
    const Hold before = session().probeControl().hold();
    QTest::keyClick(&window_->scanView(), Qt::Key_Left);
    QVERIFY(!(session().probeControl().hold() == before));
    QTest::keyClick(&window_->scanView(), Qt::Key_Escape);
    QVERIFY(!tour->isVisible());
    QTest::qWait(50);
    window_->offerTour();
    QVERIFY(find<Tour>("tourBubble") == nullptr);
    action("&Tour")->trigger();
    QVERIFY(find<Tour>("tourBubble") != nullptr);
    QTest::mouseClick(find<QPushButton>("tourLeave"), Qt::LeftButton);
    QTest::qWait(50);
    QVERIFY(find<Tour>("tourBubble") == nullptr);
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::UsabilityTest)
#include "usability_test.moc"
