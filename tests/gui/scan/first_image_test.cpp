// A case that has to be made is scanned at once, as a draft, and gets finer when that disturbs nobody.
#include <QAbstractButton>
#include <QDir>
#include <QProcess>
#include <QSignalSpy>
#include <nlohmann/json.hpp>

#include "ew/library/case.h"
#include "gui/support/case_aside.h"
#include "gui/support/window_fixture.h"
#include "library/small_case.h"

namespace ew::ui::testing {
namespace {

constexpr int kPatience_ms = 300000;

}  // namespace

class FirstImageTest : public WindowFixture {
  Q_OBJECT

  /// Drawn, with voxels so small that they take longer than a draft.
  [[nodiscard]] QString writeDrawnCase(const QString& name) const {
    const QString folder = files_.path(name);
    test::makeSmallCase(folder.toStdString());
    const nlohmann::json manifest = {
        {"format", 1},
        {"id", name.toStdString()},
        {"title", "Drawn " + name.toStdString()},
        {"volume",
         {{"recipe", "patient.json"}, {"recipe_spacing_mm", 0.9}, {"file_to_world", {1, 0, 0, 0, 0, 1, 0, -50, 0, 0, 1, 0, 0, 0, 0, 1}}}},
        {"probes", {"convex-3.5"}},
        {"scene", {{"gain_and_dgc", true}, {"live_echoes", true}}}};
    return writeFileSafely(folder.toStdString() + "/case.json", manifest.dump(2)) ? folder : QString();
  }
  void showWindow() {
    const QString cache = files_.path(QStringLiteral("cache %1").arg(++caches_));
    qputenv("ECHOWEAVE_CACHE", cache.toUtf8());
    // A machine so slow that a draft is worth it.
    QVERIFY(QDir().mkpath(cache) && writeFileSafely(cache.toStdString() + "/speed.json", R"({"voxels": 5.0})"));
    window_ = std::make_unique<MainWindow>();
    window_->resize(1280, 720);
    window_->show();
    session().frames().setAdaptive(false);
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    QVERIFY(waitUntil([this] { return !window_->jobs().isRunning(); }, kPatience_ms));
  }
  [[nodiscard]] bool opens(const QString& folder) {
    window_->open(folder);
    return waitUntil(
        [&] {
          const auto& open = window_->document().current();
          return open && wordsOf(open->folder) == folder && session().subject() && !session().image().isEmpty();
        },
        kPatience_ms);
  }
  [[nodiscard]] static QString wordsOf(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }
  [[nodiscard]] bool isMade(const QString& folder) const {
    const auto opened = loadCaseAside(folder.toStdString());
    return opened && !caseNeedsPreparation(*opened);
  }

  int caches_ = 0;

 private Q_SLOTS:
  void cleanup() { window_.reset(); }

  void theDraftGetsFinerAndNothingElseChanges() {
    showWindow();
    const QString folder = writeDrawnCase(QStringLiteral("one"));
    QVERIFY(opens(folder));
    session().setFrozen(true);
    QVERIFY2(session().subject()->isDraft, "there long before the volume");
    QVERIFY(!session().canRefine());
    QVERIFY2(window_->messages().text().contains(QStringLiteral("finer")), qPrintable(window_->messages().text()));

    // Whoever looks at a frozen image keeps it; only the volume is made.
    QVERIFY(waitUntil([&] { return isMade(folder) && window_->jobs().seen().empty(); }, kPatience_ms));
    QTest::qWait(1200);
    QVERIFY(session().subject()->isDraft);
    session().setFrozen(false);

    Knobs turned = session().console().knobs();
    turned.gain_db = 3.0;
    session().console().setKnobs(turned);
    const Hold hold = session().probeControl().hold();
    const Scene scene = session().console().scene();
    QSignalSpy replaced(&session(), &Session::subjectReplaced), another(&session(), &Session::patientReplaced);
    QVERIFY(waitUntil([&] { return !session().subject()->isDraft; }, kPatience_ms));
    QCOMPARE(replaced.count(), 0);
    QCOMPARE(another.count(), 0);
    QVERIFY(session().console().knobs() == turned);
    QVERIFY(session().probeControl().hold() == hold);
    QVERIFY(session().console().scene() == scene);
    QVERIFY(!window_->messages().text().contains(QStringLiteral("finer")));

    // ... and is what whoever opens the case afterwards scans.
    const auto whole = loadCaseVolume(*loadCaseAside(folder.toStdString()), noProgress());
    QVERIFY(whole.has_value());
    QVERIFY(session().subject()->voxels.volume()->echo == whole->volume.echo);
    QVERIFY(*session().subject()->tissue == *whole->tissue);
    QVERIFY(session().subject()->labels->echo == whole->labels->echo);
  }

  void aDrawnPatientHasHarmonicsAndCompounding() {
    showWindow();
    QVERIFY(opens(writeDrawnCase(QStringLiteral("console"))));
    const auto image = [this] {
      session().makeImageNow();
      return copyOf(session().image().grey);
    };
    const auto press = [this](const char* name) {
      auto* button = find<QAbstractButton>(name);
      QVERIFY2(button != nullptr && button->isEnabled(), name);
      button->click();
    };
    Knobs linear = session().console().knobs();
    linear.quality = Quality::linear;
    session().console().setKnobs(linear);
    const GreyImage once = image();
    press("compound3");
    QCOMPARE(session().console().knobs().compoundAngles, 3);
    QVERIFY(image() != once);
    press("compound1");
    QVERIFY(image() == once);
    press("harmonic");
    QVERIFY(session().console().knobs().harmonic);
    QVERIFY(image() != once);
    press("harmonic");
    QVERIFY(image() == once);
    linear.quality = Quality::weave;
    session().console().setKnobs(linear);
    QVERIFY2(!find<QAbstractButton>("compound3")->isEnabled(), "the fast quality follows the hand");
  }

  void anotherCaseIsOpenedMeanwhile() {
    showWindow();
    const QString first = writeDrawnCase(QStringLiteral("first")), second = writeDrawnCase(QStringLiteral("second"));
    QVERIFY(opens(first));
    QVERIFY(opens(second));
    QVERIFY(waitUntil([&] { return isMade(second) && !session().subject()->isDraft; }, kPatience_ms));
    QVERIFY(waitUntil([&] { return isMade(first); }, kPatience_ms));
    QTest::qWait(700);
    QCOMPARE(wordsOf(window_->document().current()->folder), second);
    QVERIFY2(session().subject()->title == "Drawn second", session().subject()->title.c_str());
    QVERIFY(opens(first));
    QVERIFY2(!session().subject()->isDraft, "what was made behind the other is there");
  }

  void theWindowIsClosedInTheMiddle() {
    showWindow();
    const QString folder = writeDrawnCase(QStringLiteral("closed"));
    QVERIFY(opens(folder));
    QVERIFY(session().subject()->isDraft);
    window_->close();
    window_.reset();
    const auto opened = loadCaseAside(folder.toStdString());
    QVERIFY(opened.has_value());
    const auto whole = loadCaseVolume(*opened, noProgress());
    QVERIFY2(whole.has_value(), "what was begun is gone on with");
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::FirstImageTest)
#include "first_image_test.moc"
