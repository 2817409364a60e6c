// Worksheets in the window: items measured with their calipers, answers, results and files, as a person fills them.
#include "ew/ui_test_door/worksheets.h"

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPushButton>
#include <QTextBrowser>
#include <QTimer>
#include <algorithm>
#include <cmath>

#include "ew/ui_test_door/measure.h"
#include "gui/support/window_fixture.h"

namespace ew::ui::testing {

using measurement::CaliperKind;
using measurement::Examination;

class WorksheetsTest : public WindowFixture {
  Q_OBJECT

  [[nodiscard]] Calipers& calipers() const { return window_->calipers(); }
  [[nodiscard]] Worksheets& worksheets() const { return window_->worksheets(); }
  [[nodiscard]] CaliperLayer& layer() const { return *window_->findChild<CaliperLayer*>(QStringLiteral("caliperLayer")); }
  void click(const glm::dvec2& at_mm) const {
    const QPointF at = layer().placeOf(at_mm);
    QTest::mouseClick(&layer(), Qt::LeftButton, Qt::NoModifier, QPoint(static_cast<int>(at.x()), static_cast<int>(at.y())));
  }
  [[nodiscard]] QList<QPushButton*> items() const {
    QList<QPushButton*> all = window_->findChildren<QPushButton*>(QStringLiteral("worksheetItem"));
    all.erase(std::remove_if(all.begin(), all.end(), [](QPushButton* each) { return each->isHidden(); }), all.end());
    return all;
  }
  [[nodiscard]] QPushButton* itemCalled(const QString& title) const {
    for (QPushButton* each : items())
      if (each->accessibleName().contains(title)) return each;
    return nullptr;
  }
  void choosePackage(const char* id) const {
    auto* choice = find<QComboBox>("worksheetChoice");
    choice->setCurrentIndex(choice->findData(QLatin1String(id)));
    Q_EMIT choice->activated(choice->currentIndex());
  }
  void measure(QPushButton* item, const std::vector<glm::dvec2>& points_mm) const {
    QVERIFY(item != nullptr);
    QTest::mouseClick(item, Qt::LeftButton);
    QVERIFY(item->isChecked());
    QVERIFY(session().isFrozen());
    for (const glm::dvec2& at : points_mm) click(at);
  }
  [[nodiscard]] QString shownSheet() const { return window_->findChild<QTextBrowser*>(QStringLiteral("worksheetText"))->toPlainText(); }
  static void answerQuestion(const char* name, QMessageBox::StandardButton answer, bool* wasAsked) {
    QTimer::singleShot(0, qApp, [=] {
      auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (question == nullptr) return answerQuestion(name, answer, wasAsked);
      *wasAsked = question->objectName() == QLatin1String(name);
      question->button(answer)->click();
    });
  }

 private Q_SLOTS:
  void init() {
    QSettings().clear();
    showWindowWithCase(files_.writeCase(QStringLiteral("case")));
    window_->findChild<ConsolePanel*>()->showPage(window_->findChild<QWidget*>(QStringLiteral("measurePage")));
  }
  void cleanup() { window_.reset(); }

  void anExaminationIsFilledOverSeveralImages() {
    QVERIFY(items().isEmpty());
    choosePackage("obstetric");
    QCOMPARE(items().size(), 10);
    measure(itemCalled(QStringLiteral("Biparietal diameter")), {{0.0, 40.0}, {0.0, 122.0}});
    QCOMPARE(calipers().lines().size(), std::size_t{1});
    QCOMPARE(worksheets().current()->of("BPD", "").size(), std::size_t{1});
    QCOMPARE(calipers().lines()[0].measurement.item, std::string("BPD"));
    // Another image: calipers go, what they gave stays.
    session().setFrozen(false);
    QCOMPARE(calipers().lines().size(), std::size_t{0});
    QCOMPARE(worksheets().current()->of("BPD", "").size(), std::size_t{1});
    QPushButton* head = itemCalled(QStringLiteral("Head circumference"));
    measure(head, {{-50.0, 80.0}, {50.0, 80.0}, {0.0, 40.0}});
    QCOMPARE(calipers().drawing().tool(), std::optional(CaliperKind::ellipse));
    QCOMPARE(worksheets().current()->of("HC", "").size(), std::size_t{1});
    const auto value = head->findChild<QLabel*>(QStringLiteral("worksheetValue"))->text();
    QVERIFY2(value.endsWith(QLatin1String(" cm")), qPrintable(value));
    // Undo takes the value out, redo brings it back.
    QTest::mouseClick(find<QPushButton>("undoCaliper"), Qt::LeftButton);
    QVERIFY(worksheets().current()->of("HC", "").empty());
    QTest::mouseClick(find<QPushButton>("redoCaliper"), Qt::LeftButton);
    QCOMPARE(worksheets().current()->of("HC", "").size(), std::size_t{1});
    // The item once more puts its caliper down.
    QTest::mouseClick(head, Qt::LeftButton);
    QVERIFY(!calipers().drawing().tool());
    QVERIFY(!head->isChecked());

    QTest::mouseClick(find<QPushButton>("showWorksheet"), Qt::LeftButton);
    QVERIFY(window_->findChild<WorksheetDialog*>()->isVisible());
    QVERIFY2(shownSheet().contains(QLatin1String("Hadlock")), qPrintable(shownSheet()));
    auto* gestation = window_->findChild<QLineEdit*>(QStringLiteral("gestation"));
    QTest::keyClicks(gestation, QStringLiteral("32w1d"));
    QVERIFY(std::abs(*worksheets().current()->gestation_weeks() - (32.0 + 1.0 / 7.0)) < 1e-9);
    QTest::keyClicks(gestation, QStringLiteral("x"));
    QVERIFY(!worksheets().current()->gestation_weeks().has_value());
    QVERIFY(window_->findChild<QLabel*>(QStringLiteral("gestationProblem"))->isVisible());
  }

  void aValueThatCannotBeIsSaidAndNotEntered() {
    choosePackage("abdomen");
    measure(itemCalled(QStringLiteral("bile duct")), {{0.0, 20.0}, {0.0, 110.0}});
    QVERIFY(worksheets().current()->of("CBD", "").empty());
    QVERIFY2(window_->scanView().said().contains(QLatin1String("CBD of 90")), qPrintable(window_->scanView().said()));
  }

  void whatADragMakesImpossibleIsSaidWhenItEndsAndThePointerAloneFillsNothing() {
    choosePackage("abdomen");
    QPushButton* duct = itemCalled(QStringLiteral("bile duct"));
    measure(duct, {{0.0, 20.0}, {0.0, 26.0}});
    QCOMPARE(worksheets().current()->of("CBD", "").size(), std::size_t{1});
    int filled = 0;
    connect(&worksheets(), &Worksheets::changed, this, [&filled] { ++filled; });
    const auto pixel = [this](const glm::dvec2& at_mm) { return layer().placeOf(at_mm).toPoint(); };
    for (const double x : {5.0, 10.0, 15.0}) QTest::mouseMove(&layer(), pixel({x, 60.0}));
    QTest::qWait(20);
    QCOMPARE(filled, 0);
    QTest::mousePress(&layer(), Qt::LeftButton, Qt::NoModifier, pixel(calipers().lines()[0].measurement.caliper.parts[0].points[1]));
    for (const double y : {60.0, 110.0}) {
      const QPoint to = pixel({0.0, y});
      QMouseEvent move(QEvent::MouseMove, to, layer().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(&layer(), &move);
    }
    QVERIFY(window_->scanView().said().isEmpty());
    QVERIFY(worksheets().current()->of("CBD", "").empty());
    QTest::mouseRelease(&layer(), Qt::LeftButton, Qt::NoModifier, pixel({0.0, 110.0}));
    QVERIFY2(window_->scanView().said().contains(QLatin1String("CBD of 90")), qPrintable(window_->scanView().said()));
    disconnect(&worksheets(), nullptr, this, nullptr);
  }

  void anOutlineMayTakeTheEllipsesPlace() {
    choosePackage("obstetric");
    QPushButton* head = itemCalled(QStringLiteral("Head circumference"));
    QTest::mouseClick(head, Qt::LeftButton);
    calipers().take(CaliperKind::trace);
    QVERIFY(head->isChecked());
    for (const glm::dvec2 at : {glm::dvec2(-40.0, 40.0), glm::dvec2(40.0, 40.0), glm::dvec2(40.0, 110.0), glm::dvec2(-40.0, 110.0)})
      click(at);
    click({-40.0, 40.0});
    QCOMPARE(worksheets().current()->of("HC", "").size(), std::size_t{1});
    QVERIFY(std::abs(worksheets().current()->of("HC", "")[0].value - 300.0) <= 8.0 * session().geometry().pixel_mm);
    calipers().take(CaliperKind::distance);  // gives no circumference: it is for nothing of the worksheet
    QVERIFY(!head->isChecked());
    QVERIFY(calipers().drawing().purpose().item.empty());
  }

  void answersAreGivenAndAnUnsavedWorksheetIsAskedAbout() {
    choosePackage("trauma");
    QVERIFY(items().isEmpty());  // all of its items are answers
    QTest::mouseClick(find<QPushButton>("showWorksheet"), Qt::LeftButton);
    const auto answers = window_->findChildren<QComboBox*>(QStringLiteral("worksheetAnswer"));
    QCOMPARE(answers.size(), 8);  // two of the six have sides
    answers[0]->setCurrentIndex(1);
    Q_EMIT answers[0]->activated(1);
    QCOMPARE(worksheets().current()->answers().size(), std::size_t{1});
    QVERIFY(worksheets().unsaved() != nullptr);
    // Cancelled: the case stays, and the worksheet.
    const QString second = files_.writeCase(QStringLiteral("second"));
    bool wasAsked = false;
    answerQuestion("unsavedWorksheetQuestion", QMessageBox::Cancel, &wasAsked);
    window_->open(second);
    QVERIFY(waitUntil([&] { return wasAsked && window_->isSettled(); }));
    QCOMPARE(worksheets().current()->answers().size(), std::size_t{1});
    wasAsked = false;
    answerQuestion("unsavedWorksheetQuestion", QMessageBox::Discard, &wasAsked);
    QVERIFY(openCase(second));
    QVERIFY(waitUntil([&] { return wasAsked && window_->isSettled(); }));
    QVERIFY(worksheets().current() != nullptr);  // the same kind of examination, empty
    QVERIFY(worksheets().current()->isEmpty());
    QVERIFY(worksheets().unsaved() == nullptr);
  }

  void aSheetSaysWhoseItIsAndItsRangesReadAsSentences() {
    choosePackage("abdomen");
    session().setFrozen(true);
    worksheets().measure("AORTA", "");
    calipers().changeIn(Where::image, [](measurement::CaliperDrawing& drawing) {
      for (const glm::dvec2 at : {glm::dvec2(-17.0, 50.0), glm::dvec2(16.0, 50.0)}) {
        drawing.press(at, 1.0);
        drawing.release(at, 1.0);
      }
    });
    QVERIFY(worksheets().current() != nullptr);
    const measurement::Worksheet sheet = worksheets().current()->worksheet();
    const QString html = WorksheetWords::htmlOf(sheet, QStringLiteral("#505050"));
    QVERIFY2(html.contains(QLatin1String("high (usual: up to 2.9 cm; an aneurysm from 3.0 cm on)")), qPrintable(html));
    const QDateTime at(QDate(2026, 11, 24), QTime(10, 0));
    const auto written = [&](const char* name) {
      const QString path = files_.path(QLatin1String(name));
      if (!writeWorksheet(sheet, QStringLiteral("Pain, \"here\""), at, path.toStdString(), {}, QStringLiteral("Anna"))) return QByteArray();
      QFile file(path);
      return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    const QByteArray json = written("whose.json"), csv = written("whose.csv");
    QVERIFY(json.contains("\"patient\"") && json.contains("\"examined_by\": \"Anna\""));
    QVERIFY2(csv.contains(",patient,,,\"Pain, \"\"here\"\"\"") && csv.contains(",examined_by,,,\"Anna\""), csv.constData());
  }

  void filesCarryTheSheetAndItsCaution() {
    choosePackage("obstetric");
    measure(itemCalled(QStringLiteral("Femur")), {{0.0, 40.0}, {0.0, 103.0}});
    const measurement::Worksheet sheet = worksheets().current()->worksheet();
    const QDateTime at(QDate(2026, 1, 2), QTime(3, 4));
    const auto written = [&](const char* name) {
      const QString path = files_.path(QLatin1String(name));
      if (!writeWorksheet(sheet, QStringLiteral("Window test"), at, path.toStdString())) return QByteArray();
      QFile file(path);
      return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    QVERIFY(written("sheet.pdf").startsWith("%PDF-"));
    QVERIFY(written("sheet.csv").contains("not for diagnosis"));
    QVERIFY(written("sheet.json").contains("\"FL\""));
    QVERIFY(!writeWorksheet(sheet, {}, at, files_.path(QStringLiteral("no folder/sheet.pdf")).toStdString()));
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::WorksheetsTest)
#include "worksheets_test.moc"
