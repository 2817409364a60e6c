#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "ew/core/progress.h"
#include "ew/library/case.h"
#include "ew/library/case_card.h"
#include "ew/library/preparation.h"
#include "ew/ui_test_door/start.h"
#include "gui/support/case_aside.h"
#include "gui/support/screenshots.h"
#include "gui/support/window_fixture.h"
#include "library/small_case.h"
#include "library/temporary_folder.h"

namespace ew::ui::testing {

/// The start page with a library of its own: what is typed, chosen and seen.
class LibraryTest final : public WindowFixture {
  Q_OBJECT

  /// Case folders that are listed and not opened; titles give "stone" away.
  static void writeCases(const QString& root, int count, const QString& word = QStringLiteral("Liver")) {
    static constexpr const char* kRegions[] = {"abdomen", "neck", "womb"};
    for (int n = 0; n < count; ++n) {
      const QString folder = QStringLiteral("%1/case-%2").arg(root).arg(n);
      QDir().mkpath(folder);
      const std::string manifest = QStringLiteral(R"({"format": 2, "id": "case-%1", "title": "Stone %1", "title_for_trainees": "%2 %3",
            "region": "%4", "indication": "To be looked at, Gefäß", "diagnosis": "Stone", "difficulty": %5, "tags": ["t%6"],
            "parts": {"lessons": {"format": 1, "lessons": [{"id": "a", "title": "Find it", "level": 2, "steps": []}]}},
            "volume": {"file": "volume.mha"}})")
                                       .arg(n)
                                       .arg(word)
                                       .arg(n, 5, 10, QLatin1Char('0'))
                                       .arg(QLatin1String(kRegions[n % 3]))
                                       .arg(1 + n % 5)
                                       .arg(n % 4)
                                       .toStdString();
      QFile file(folder + QStringLiteral("/case.json"));
      if (!file.open(QIODevice::WriteOnly)) qFatal("no room for the cases of a test");
      file.write(manifest.c_str());
    }
  }

  [[nodiscard]] QString own() const { return files_.path(QStringLiteral("own cases")); }
  [[nodiscard]] QLineEdit* search() const { return find<QLineEdit>("caseSearch"); }
  [[nodiscard]] QAbstractItemView* cards() const { return find<QAbstractItemView>("caseCards"); }
  [[nodiscard]] int shown() const { return cards()->model()->rowCount(); }
  [[nodiscard]] QString titleAt(int row) const { return cards()->model()->index(row, 0).data().toString(); }
  [[nodiscard]] bool rests() const {
    return waitUntil([this] { return window_->isSettled(); });
  }
  /// Everything that was asked of the window is painted.
  static void settle() {
    QApplication::sendPostedEvents();
    QApplication::processEvents();
  }

  void showStartPage(int width = 1280, int height = 720) {
    window_ = std::make_unique<MainWindow>();
    window_->resize(width, height);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get(), static_cast<int>(test::kPatience_ms)));
    QApplication::setActiveWindow(window_.get());
    window_->showStartPage();
    QVERIFY(rests());
  }

 private Q_SLOTS:
  void init() {
    QSettings().clear();
    qputenv("ECHOWEAVE_CACHE", files_.path(QStringLiteral("cache")).toUtf8());
    program_ = files_.path(QStringLiteral("program"));
    QDir().mkpath(program_ + QStringLiteral("/cases"));
    QFile::link(QString::fromStdString(resources_), program_ + QStringLiteral("/resources"));
    qputenv("ECHOWEAVE_RESOURCES", (program_ + QStringLiteral("/resources")).toUtf8());
  }
  void cleanup() {
    window_.reset();
    for (const QString& folder : {own(), program_, files_.path(QStringLiteral("cache")), files_.path(QStringLiteral("library"))})
      QDir(folder).removeRecursively();
    qunsetenv("ECHOWEAVE_RESOURCES");
  }

  void typingNarrowsTheListAndEscapeShowsItAgain() {
    writeCases(own(), 12);
    showStartPage();
    QCOMPARE(shown(), 12);
    QTest::keyClick(window_.get(), Qt::Key_F, Qt::ControlModifier);
    QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(search()));
    QTest::keyClicks(search(), QStringLiteral("liv 00007"));
    QCOMPARE(shown(), 1);
    QCOMPARE(titleAt(0), QStringLiteral("Liver 00007"));
    QCOMPARE(find<QLabel>("caseCount")->text(), QStringLiteral("1 case"));
    QTest::keyClick(search(), Qt::Key_Escape);
    QCOMPARE(shown(), 12);
    QTest::keyClicks(search(), QStringLiteral("gefass"));
    QCOMPARE(shown(), 12);
  }

  void aTraineeCannotSearchForTheAnswerAndAnAuthorCan() {
    writeCases(own(), 3);
    showStartPage();
    QTest::keyClicks(search(), QStringLiteral("stone"));
    QCOMPARE(shown(), 0);
    QVERIFY(find<QLabel>("startEmpty")->isVisible());
    window_->setWorkspace(Workspace::author);
    window_->showStartPage();
    QCOMPARE(shown(), 3);
    QCOMPARE(titleAt(0), QStringLiteral("Stone 0"));
  }

  void filtersNarrowAndOneButtonShowsAllAgain() {
    writeCases(own(), 12);
    showStartPage();
    auto* region = find<QComboBox>("regionFilter");
    region->setCurrentIndex(region->findText(QStringLiteral("neck")));
    QCOMPARE(shown(), 4);
    auto* level = find<QComboBox>("levelFilter");
    level->setCurrentIndex(level->findText(QStringLiteral("First steps")));
    QCOMPARE(shown(), 1);
    QTest::keyClicks(search(), QStringLiteral("nothing"));
    QCOMPARE(shown(), 0);
    QVERIFY(find<QPushButton>("startEmptyButton")->isVisible());
    keepScreenshot(*window_, "library-nothing-found");
    QTest::mouseClick(find<QPushButton>("startEmptyButton"), Qt::LeftButton);
    QCOMPARE(shown(), 12);
    QVERIFY(search()->text().isEmpty());
    QCOMPARE(region->currentIndex(), 0);
  }

  void theTabKeyGoesFromSearchByFiltersToTheListAndArrowsThroughIt() {
    writeCases(own(), 12);
    showStartPage();
    search()->setFocus();
    QStringList order;
    for (int n = 0; n < 6; ++n) {
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
      order << QApplication::focusWidget()->objectName();
    }
    QCOMPARE(order, (QStringList{QStringLiteral("regionFilter"), QStringLiteral("levelFilter"), QStringLiteral("tagFilter"),
                                 QStringLiteral("lessonsFilter"), QStringLiteral("caseCards"), order.last()}));
    cards()->setFocus(Qt::TabFocusReason);
    QCOMPARE(cards()->currentIndex().row(), 0);
    QTest::keyClick(cards(), Qt::Key_Right);
    QCOMPARE(cards()->currentIndex().row(), 1);
    QTest::keyClick(cards(), Qt::Key_Down);
    const QRect first = cards()->visualRect(cards()->model()->index(1, 0)), second = cards()->visualRect(cards()->currentIndex());
    QCOMPARE(second.left(), first.left());
    QVERIFY(second.top() > first.bottom());
    QTest::keyClick(cards(), Qt::Key_End);
    QCOMPARE(cards()->currentIndex().row(), 11);
    QVERIFY(cards()->viewport()->rect().contains(cards()->visualRect(cards()->currentIndex())));
    QSignalSpy chosen(find<StartPage>("startPage"), &StartPage::caseChosen);
    QTest::keyClick(cards(), Qt::Key_Return);
    QCOMPARE(chosen.size(), 1);
    QCOMPARE(chosen.front().front().toString(), own() + QStringLiteral("/case-11"));
    QVERIFY(rests());
    window_->showStartPage();
    // Letters mean the search, also those that mean something to the console.
    QTest::keyClick(cards(), '0');
    QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(search()));
    QTest::keyClicks(search(), QStringLiteral("0003"));
    QCOMPARE(search()->text(), QStringLiteral("00003"));
    QCOMPARE(shown(), 1);
  }

  void whatIsInSightStaysWhenTheListChanges() {
    writeCases(own(), 200, QStringLiteral("M"));
    showStartPage();
    QScrollBar& bar = *cards()->verticalScrollBar();
    bar.setValue(20 * cards()->visualRect(cards()->model()->index(0, 0)).height());
    settle();
    const QModelIndex before = cards()->indexAt(QPoint(100, cards()->viewport()->height() / 2));
    QVERIFY(before.isValid());
    const QString title = before.data().toString();
    const int y = cards()->visualRect(before).top();
    QDir().mkpath(own() + QStringLiteral("/first"));
    QFile file(own() + QStringLiteral("/first/case.json"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(R"({"format": 2, "id": "first", "title": "A first", "volume": {"file": "v.mha"}})");
    file.close();
    window_->showStartPage();
    QVERIFY(rests());
    QCOMPARE(shown(), 201);
    QModelIndex after;
    for (int row = 0; row < shown() && !after.isValid(); ++row)
      if (titleAt(row) == title) after = cards()->model()->index(row, 0);
    // A card may move to another column; a row of cards stays where it was but for that.
    QVERIFY(std::abs(cards()->visualRect(after).top() - y) <= cards()->visualRect(after).height() + 16);
  }

  void anEmptyLibrarySaysWhatToDo() {
    showStartPage();
    QCOMPARE(shown(), 0);
    QVERIFY(find<QLabel>("startEmpty")->text().contains(QLatin1String("Open")));
    QVERIFY(find<QPushButton>("startEmptyButton")->isVisible());
    keepScreenshot(*window_, "library-empty");
  }

  void ownAndShippedCasesStandBelowHeadingsOfTheirOwn() {
    writeCases(program_ + QStringLiteral("/cases"), 2, QStringLiteral("Shipped"));
    writeCases(own(), 3, QStringLiteral("Mine"));
    showStartPage();
    QCOMPARE(shown(), 5);
    QCOMPARE(titleAt(0), QStringLiteral("Shipped 00000"));
    QCOMPARE(titleAt(2), QStringLiteral("Mine 00000"));
    QVERIFY(cards()->visualRect(cards()->model()->index(2, 0)).top() > cards()->visualRect(cards()->model()->index(1, 0)).bottom());
    keepScreenshot(*window_, "library-sections");
    auto* kind = find<QComboBox>("kindFilter");
    QVERIFY(kind->isVisible());
    kind->setCurrentIndex(1);
    QCOMPARE(shown(), 2);
  }

  void aBrokenCaseIsToldOnce() {
    writeCases(own(), 1);
    QDir().mkpath(own() + QStringLiteral("/broken"));
    QFile file(own() + QStringLiteral("/broken/case.json"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("{ broken");
    file.close();
    showStartPage();
    QVERIFY(window_->messages().isError());
    QVERIFY2(window_->messages().text().contains(QLatin1String("broken")), qPrintable(window_->messages().text()));
    window_->messages().dismiss();
    window_->showStartPage();
    QVERIFY(rests());
    QVERIFY(!window_->messages().isError());
  }

  /// Prints how long a person waits; what is checked does not depend on the machine.
  /// A case that has to be made first has the image it brings with it, without the words below; one that is no such image is none.
  void aCaseThatIsNotPreparedShowsTheImageItBrings() {
    const QString folder = own() + QStringLiteral("/drawn");
    test::makeSmallCase(folder.toStdString());
    QImage brought(kCardImageWidth_px, kCardImageHeight_px + kCardStripHeight_px, QImage::Format_RGB32);
    for (int y = 0; y < brought.height(); ++y)
      for (int x = 0; x < brought.width(); ++x) brought.setPixel(x, y, qRgb(x % 251, y % 241, (x + y) % 239));
    const QString file = folder + QStringLiteral("/card.png");
    const auto shown = [&] {
      CaseDetails details;
      QSignalSpy images(&details, &CaseDetails::imageRead), rested(&details, &CaseDetails::rested);
      details.want({folder});
      if (rested.isEmpty() && !rested.wait(static_cast<int>(test::kPatience_ms))) qFatal("the case was not read");
      return images.isEmpty() ? QImage() : images.front().at(1).value<QImage>().convertToFormat(QImage::Format_RGB32);
    };
    QVERIFY2(shown().isNull(), "nothing was brought");
    QVERIFY(brought.save(file, "PNG"));
    QCOMPARE(shown(), brought.copy(0, 0, kCardImageWidth_px, kCardImageHeight_px));
    QVERIFY(brought.copy(0, 0, 300, 200).save(file, "PNG"));
    QVERIFY2(shown().isNull(), "another size");
    QVERIFY(brought.save(file, "JPG"));
    QVERIFY2(shown().isNull(), "no PNG");
    // Once it can be made, it is made: what was brought may be of an earlier state of the case.
    QVERIFY(brought.save(file, "PNG"));
    const auto prepared = loadCaseAside(folder.toStdString());
    QVERIFY(prepared && prepareCase(*prepared, {}, noProgress()));
    const QImage made = shown();
    QVERIFY(!made.isNull());
    QVERIFY(made != brought.copy(0, 0, kCardImageWidth_px, kCardImageHeight_px));
  }

  /// The case that is opened may be the first of those that are made behind: it is not made twice at once, and the others follow.
  void whatIsMadeBehindWaitsUntilTheOpenedCaseIsRead() {
    const QString first = program_ + QStringLiteral("/cases/first"), second = program_ + QStringLiteral("/cases/second");
    for (const QString& each : {first, second}) test::makeSmallCase(each.toStdString());
    const std::string file = second.toStdString() + "/case.json";
    auto manifest = nlohmann::json::parse(test::textOf(file));
    manifest["id"] = "second";
    manifest["volume"]["reconstruct"]["spacing_mm"] = 1.5;
    test::writeText(file, manifest.dump());
    const auto isPrepared = [](const QString& folder) {
      const auto read = loadCaseAside(folder.toStdString());
      return read && !caseNeedsPreparation(*read);
    };
    showStartPage();
    QVERIFY(!isPrepared(first) && !isPrepared(second));
    window_->open(first);
    window_->prepareCases();
    for (const Jobs::Seen& each : window_->jobs().seen())
      QVERIFY2(each.kind != Jobs::Kind::background || !each.title.startsWith(QStringLiteral("Preparing")), qPrintable(each.title));
    QVERIFY(waitUntil([&] { return isPrepared(second); }));
    QVERIFY(isPrepared(first));
    QVERIFY(window_->document().current() && window_->document().current()->folder == first.toStdString());
  }

  void tenThousandCasesAreSearchedAsOneTypes() {
    writeCases(own(), 10000);
    showStartPage();
    QCOMPARE(shown(), 10000);
    keepScreenshot(*window_, "library-10000");
    window_.reset();
    QElapsedTimer clock;
    window_ = std::make_unique<MainWindow>();
    window_->resize(1280, 720);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get(), static_cast<int>(test::kPatience_ms)));
    clock.start();
    window_->showStartPage();
    cards()->viewport()->repaint();
    const double opened_ms = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
    QCOMPARE(shown(), 10000);
    QVERIFY(rests());
    std::vector<double> letters_ms;
    for (const char* typed : {"liver 00042", "gefass", "neck", "liver look", "find 0999", "to be"}) {
      search()->clear();
      settle();
      for (const char* letter = typed; *letter != '\0'; ++letter) {
        clock.start();
        QTest::keyClick(search(), *letter);
        cards()->viewport()->repaint();
        letters_ms.push_back(static_cast<double>(clock.nsecsElapsed()) * 1e-6);
      }
    }
    std::sort(letters_ms.begin(), letters_ms.end());
    qInfo("10000 cases: start page with its cards after %.0f ms; a letter typed, searched and painted: median %.1f ms, worst %.1f ms",
          opened_ms, letters_ms[letters_ms.size() / 2], letters_ms.back());
    search()->setText(QStringLiteral("liver 00042"));
    QCOMPARE(shown(), 1);
    search()->clear();
    cards()->verticalScrollBar()->setValue(cards()->verticalScrollBar()->maximum());
    settle();
    QCOMPARE(cards()->indexAt(QPoint(20, cards()->viewport()->height() - 60)).isValid(), true);
    QVERIFY(rests());
  }

 private:
  const std::string resources_ = resourceFolder()->string();
  QString program_;
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::LibraryTest)
#include "library_test.moc"
