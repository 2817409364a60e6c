// Every case after every other one in one window: what is scanned afterwards is the second case and nothing of the first.
// With EW_OPEN_SHIPPED_CASES=1 the same with the cases that are shipped, as far as they are prepared.
#include <QLabel>
#include <QProcess>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "ew/core/progress.h"
#include "ew/io/image_file.h"
#include "ew/library/case.h"
#include "ew/scanning/first_image.h"
#include "ew/ui_test_door/start.h"
#include "gui/support/case_aside.h"
#include "gui/support/window_fixture.h"
#include "library/small_case.h"

namespace ew::ui::testing {
namespace {

using nlohmann::json;

/// Grey levels without any symmetry, another pattern for every `seed`.
Volume patterned(const glm::ivec3& dims, double spacing_mm, const glm::dvec3& origin_mm, int seed) {
  Volume volume;
  volume.grid.dims = dims;
  volume.grid.spacing_mm = glm::dvec3(spacing_mm);
  volume.grid.origin_mm = origin_mm;
  volume.echo.resize(volume.grid.voxelCount());
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i)
        volume.echo[volume.grid.indexOf(i, j, k)] = static_cast<std::uint8_t>(20 + ((2 + seed) * i + j + (i * k) / (20 + seed)) % 200);
  return volume;
}

/// What opening a case has to lead to, found without a window.
struct Expected {
  Case opened;
  CaseEcho echo;
  std::vector<std::uint8_t> image;  ///< of a window that has opened nothing else
};

/// What a case that is scanned takes most memory for. Nobody holds it once another one is scanned.
struct Held {
  explicit Held(const ScanSubject& subject) : voxels(subject.voxels.volume()), labels(subject.labels), tissue(subject.tissue) {}
  std::weak_ptr<const Volume> voxels, labels;
  std::weak_ptr<const TissueMaps> tissue;

  [[nodiscard]] bool areGone() const { return voxels.expired() && labels.expired() && tissue.expired(); }
  [[nodiscard]] QString left() const {
    return QStringLiteral("voxels %1, labels %2, tissue %3").arg(voxels.use_count()).arg(labels.use_count()).arg(tissue.use_count());
  }
};

}  // namespace

class EveryCaseTest : public WindowFixture {
  Q_OBJECT

 private:
  std::vector<QString> folders_;
  std::vector<Expected> expected_;
  Beginnings there_;

  static constexpr int kPatience_ms = 300000;

  void writeStandIn(const std::string& id, json manifest) {
    const QString folder = files_.path(QString::fromStdString(id));
    manifest["format"] = 1;
    manifest["id"] = id;
    manifest["title"] = "Stand-in " + id;
    QVERIFY(writeFileSafely(folder.toStdString() + "/case.json", manifest.dump(2)).has_value());
    folders_.push_back(folder);
  }
  void writeVolumeOf(const std::string& id, const std::string& name, const Volume& volume) {
    const QString folder = files_.path(QString::fromStdString(id));
    QDir().mkpath(folder);
    QVERIFY(writeVolume(volume, folder.toStdString() + "/" + name).has_value());
  }
  /// Other sizes, placements, bodies, probes, effects and origins, and two of the same size.
  void writeStandIns() {
    writeVolumeOf("large", "volume.mha", patterned({96, 80, 88}, 2.0, {-95.0, -110.0, -100.0}, 0));
    writeStandIn("large", {{"volume", {{"file", "volume.mha"}}},
                           {"probes", {"convex-3.5"}},
                           {"presets", {"trauma-convex-3.5"}},
                           {"scene", {{"gain_and_dgc", true}}}});
    writeVolumeOf("labelled", "volume.mha", patterned({50, 40, 30}, 3.0, {-75.0, -110.0, -45.0}, 3));
    Volume labels = patterned({25, 20, 15}, 6.0, {-75.0, -110.0, -45.0}, 5);
    for (std::uint8_t& label : labels.echo) label = label > 120 ? 1 : 0;
    writeVolumeOf("labelled", "labels.mha", labels);
    writeStandIn(
        "labelled",
        {{"volume",
          {{"file", "volume.mha"}, {"labels", "labels.mha"}, {"file_to_world", {1, 0, 0, 12, 0, 1, 0, -4, 0, 0, 1, 30, 0, 0, 0, 1}}}},
         {"probes", {"linear-12", "linear-7.5"}},
         {"presets", {"nobodys", "carotid-linear-7.5"}},
         {"mannequin", "neck-extended.json"},
         {"scene", {{"gain_and_dgc", true}, {"tissues", {{{"label", 1}, {"attenuation_db_per_cm_mhz", 0.5}}}}}}});
    writeVolumeOf("same-size", "volume.mha", patterned({96, 80, 88}, 2.0, {-95.0, -110.0, -100.0}, 7));
    writeStandIn("same-size", {{"volume", {{"file", "volume.mha"}, {"file_to_world", {0, -1, 0, 5, 1, 0, 0, 0, 0, 0, 1, -20, 0, 0, 0, 1}}}},
                               {"probes", {"phased-2.5"}},
                               {"mannequin", "gravid.json"}});
    test::makeSmallCase(files_.path(QStringLiteral("recipe")).toStdString());
    writeStandIn(
        "recipe",
        {{"volume",
          {{"recipe", "patient.json"}, {"recipe_spacing_mm", 4.0}, {"file_to_world", {1, 0, 0, 0, 0, 1, 0, -50, 0, 0, 1, 0, 0, 0, 0, 1}}}},
         {"probes", {"microconvex-6"}},
         {"scene", {{"gain_and_dgc", true}}}});
    test::makeSmallCase(files_.path(QStringLiteral("sweeps")).toStdString());
    writeStandIn("sweeps", {{"volume",
                             {{"recipe", "patient.json"},
                              {"sweeps", {"sweeps/upper.json"}},
                              {"reconstruct", {{"spacing_mm", 2.0}, {"fill_reach_mm", 4}, {"labels_spacing_mm", 4}}},
                              {"file_to_world", {1, 0, 0, 5, 0, 1, 0, -50, 0, 0, 1, 0, 0, 0, 0, 1}}}},
                            {"probes", {"linear-7.5"}}});
  }
  void findShipped() {
    const auto folder = shippedCasesFolder();
    QVERIFY(folder.has_value());
    for (const Case& each : listCasesAside(*folder).cases) {
      if (caseNeedsPreparation(each))
        qInfo("'%s' is not prepared and left out", each.id.c_str());
      else
        folders_.push_back(QString::fromStdString(each.folder.string()));
    }
    if (folders_.size() < 2) QSKIP("fewer than two shipped cases are prepared; run 'echoweave case prepare --all' first");
  }
  void showEmptyWindow() {
    window_ = std::make_unique<MainWindow>();
    window_->resize(1280, 720);
    window_->show();
    session().frames().setAdaptive(false);  // the images of two windows are compared, whatever the machine does beside
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    QVERIFY(waitUntil([this] { return !window_->jobs().isRunning(); }, kPatience_ms));
  }
  void openAndLook(std::size_t index, const QString& after) {
    const Expected& expected = expected_[index];
    window_->open(folders_[index]);
    const QString title = QString::fromStdString(titleForTrainees(expected.opened));
    const QString what = title + QStringLiteral(" after ") + after;
    QVERIFY2(waitUntil(
                 [&] {
                   const auto& open = window_->document().current();
                   return window_->isSettled() && open && open->id == expected.opened.id;
                 },
                 kPatience_ms),
             qPrintable(what + QStringLiteral(": ") + window_->messages().text()));
    QVERIFY2(!window_->messages().isError(), qPrintable(what + QStringLiteral(": ") + window_->messages().text()));
    const auto& subject = session().subject();
    QVERIFY(subject.has_value());
    QVERIFY2(subject->title == title.toStdString(), qPrintable(what));
    QVERIFY2(window_->windowTitle().startsWith(title), qPrintable(what));
    QVERIFY2(find<QLabel>("title")->text() == title, qPrintable(what));
    QVERIFY2(subject->voxels.volume()->grid == expected.echo.volume.grid && subject->voxels.volume()->echo == expected.echo.volume.echo,
             qPrintable(what));
    QVERIFY2(subject->placedGrid == expected.echo.volume.grid, qPrintable(what));
    QVERIFY2((subject->labels != nullptr) == expected.echo.labels.has_value(), qPrintable(what));
    if (subject->labels) {
      QVERIFY2(subject->labels->echo == expected.echo.labels->echo && subject->placedLabels == expected.echo.labels->grid,
               qPrintable(what));
    }
    QVERIFY2(subject->scene == sceneWithTissues(expected.opened.scene, expected.echo.tissues), qPrintable(what));
    QVERIFY2(session().console().scene() == subject->scene, qPrintable(what));
    QVERIFY2(subject->probes == expected.opened.probes, qPrintable(what));
    // Whatever was scanned before, the console stands as a scan of this case begins.
    const auto begun = firstState(*subject, there_.probes, there_.presets);
    QVERIFY2(begun && session().console().probe().id == begun->probe.id, qPrintable(what));
    QVERIFY2(session().console().knobs() == begun->knobs, qPrintable(what));
    session().makeImageNow();
    const std::vector<std::uint8_t> image = pixelsOf(session());
    QVERIFY2(std::any_of(image.begin(), image.end(), [](std::uint8_t level) { return level > 0; }), qPrintable(what));
    // Noise is another one in every image.
    if (!expected.image.empty() && !session().console().scene().noise) QVERIFY2(image == expected.image, qPrintable(what));
  }

 private Q_SLOTS:
  void initTestCase() {
    if (qEnvironmentVariableIntValue("EW_OPEN_SHIPPED_CASES") != 0) {
      findShipped();
    } else {
      qputenv("ECHOWEAVE_CACHE", files_.path(QStringLiteral("cache")).toUtf8());
      writeStandIns();
    }
    auto there = beginningsThere();
    QVERIFY(there.has_value());
    there_ = std::move(*there);
    for (const QString& folder : folders_) {
      auto opened = loadCaseAside(folder.toStdString());
      QVERIFY2(opened, opened ? "" : opened.error().sentence().c_str());
      auto echo = loadCaseVolume(*opened, noProgress());
      QVERIFY2(echo, echo ? "" : echo.error().sentence().c_str());
      expected_.push_back({std::move(*opened), std::move(*echo), {}});
    }
  }
  void cleanup() { window_.reset(); }

  void everyCaseIsScannedInAWindowOfItsOwn() {
    for (std::size_t index = 0; index < folders_.size(); ++index) {
      showEmptyWindow();
      openAndLook(index, QStringLiteral("nothing"));
      if (QTest::currentTestFailed()) return;
      expected_[index].image = pixelsOf(session());
      window_.reset();
    }
  }

  /// One state of one case looks the same in the window, on its card, from the command and in its contact sheet.
  void windowCardCommandAndContactSheetShowTheSamePixels() {
    constexpr int kWidth = 320, kHeight = 240;
    const QStringList size{QStringLiteral("--size"), QStringLiteral("%1x%2").arg(kWidth).arg(kHeight)};
    const auto rowsOf = [](const GreyImage& image, int left, int top) {
      std::vector<std::uint8_t> pixels;
      for (int y = top; y < top + kHeight; ++y)
        pixels.insert(pixels.end(), viewOf(image).row(y) + left, viewOf(image).row(y) + left + kWidth);
      return pixels;
    };
    showEmptyWindow();
    for (std::size_t index = 0; index < folders_.size(); ++index) {
      openAndLook(index, QStringLiteral("others"));
      if (QTest::currentTestFailed()) return;
      const QString what = QString::fromStdString(expected_[index].opened.id);
      const ScanSubject subject = *session().subject();
      auto state = firstState(subject, there_.probes, there_.presets);
      QVERIFY2(state.has_value(), qPrintable(what));
      session().setImageSize(kWidth, kHeight);
      session().play(*state);
      session().makeImageNow();
      const std::vector<std::uint8_t> inWindow = pixelsOf(session());
      QCOMPARE(inWindow.size(), std::size_t{kWidth * kHeight});
      QVERIFY2(std::any_of(inWindow.begin(), inWindow.end(), [](std::uint8_t level) { return level > 0; }), qPrintable(what));
      ScanState neutral = *state;
      neutral.knobs = Knobs();
      session().play(neutral);
      session().setImageSize(kWidth, kHeight);  // another depth had fitted it to the view again
      session().makeImageNow();
      const std::vector<std::uint8_t> inSheet = pixelsOf(session());
      session().play({});

      const QImage card = thumbnailOf(subject, there_, {kWidth, kHeight});
      for (int y = 0; y < kHeight; ++y)
        QVERIFY2(std::equal(card.constScanLine(y), card.constScanLine(y) + kWidth, inWindow.data() + std::ptrdiff_t{y} * kWidth),
                 qPrintable(what));

      // The command takes its pose from the words when the case has no start of its own.
      QStringList pose;
      for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) pose << QString::number(state->pose.probeToWorld.matrix[column][row], 'g', 17);
      const QStringList words =
          QStringList{QStringLiteral("scan"), folders_[index], QStringLiteral("--pose=") + pose.join(QLatin1Char(' '))} + size;
      const QString image = files_.path(QStringLiteral("command.mha")), sheet = files_.path(QStringLiteral("sheet.png"));
      QCOMPARE(QProcess::execute(QStringLiteral(EW_PROGRAM), words + QStringList{QStringLiteral("-o"), image}), 0);
      const auto fromCommand = readImage(image.toStdString());
      QVERIFY2(fromCommand.has_value(), qPrintable(what));
      QVERIFY2(fromCommand->pixels == inWindow, qPrintable(what + QStringLiteral(": the command shows something else")));

      QCOMPARE(QProcess::execute(QStringLiteral(EW_PROGRAM), words + QStringList{QStringLiteral("--contact-sheet"), sheet}), 0);
      const auto tiles = readImage(sheet.toStdString());
      QVERIFY2(tiles.has_value(), qPrintable(what));
      constexpr int kName = 18;
      bool found = false;
      for (int top = 0; top + kHeight <= tiles->height && !found; top += kHeight + kName)
        for (int left = 0; left + kWidth <= tiles->width && !found; left += kWidth) found = rowsOf(*tiles, left, top) == inSheet;
      QVERIFY2(found, qPrintable(what + QStringLiteral(": no tile shows the case as it asks")));
    }
  }

  void everyCaseIsScannedAfterEveryOtherOne() {
    showEmptyWindow();
    for (std::size_t first = 0; first < folders_.size(); ++first) {
      for (std::size_t second = 0; second < folders_.size(); ++second) {
        if (first == second) continue;
        openAndLook(first, QStringLiteral("others"));
        if (QTest::currentTestFailed()) return;
        const Held held(*session().subject());
        openAndLook(second, QString::fromStdString(expected_[first].opened.title));
        if (QTest::currentTestFailed()) return;
        QVERIFY2(waitUntil([&] { return held.areGone(); }),
                 qPrintable(QString::fromStdString(expected_[first].opened.id) + QStringLiteral(" is still held: ") + held.left()));
      }
    }
  }
};

}  // namespace ew::ui::testing

EW_WINDOW_TEST_MAIN(ew::ui::testing::EveryCaseTest)
#include "every_case_test.moc"
