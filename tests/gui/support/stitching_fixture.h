#pragma once

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QScrollArea>
#include <QStandardPaths>
#include <QTabWidget>
#include <QTableWidget>
#include <QThread>
#include <QTimer>
#include <QTranslator>
#include <QUrl>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <random>

#include "ew/phantom/patient.h"
#include "gui/support/window_fixture.h"
#include "places.h"

namespace ew::ui::testing {

/// A window with the stitching panel in front, and pieces of one patient to stitch. ECHOWEAVE_TEST_PICTURES names a folder for what was
/// seen on the way.
class StitchingFixture : public WindowFixture {
 protected:
  struct Part {
    QString file;
    glm::dvec3 at_mm{0.0};  ///< of its origin in the patient: nothing in the file tells
  };
  std::vector<Part> parts_;
  Volume truth_;

  /// A piece of the patient in coordinates of its own.
  [[nodiscard]] Part writePart(const QString& name, const glm::ivec3& from, const glm::ivec3& dims) const {
    Volume piece;
    piece.grid = truth_.grid;
    piece.grid.dims = dims;
    piece.grid.origin_mm = {0.0, 0.0, 0.0};
    for (int k = 0; k < dims.z; ++k)
      for (int j = 0; j < dims.y; ++j)
        for (int i = 0; i < dims.x; ++i) piece.echo.push_back(truth_.echo[truth_.grid.indexOf(from.x + i, from.y + j, from.z + k)]);
    const QString file = files_.path(name);
    if (!writeVolume(piece, file.toStdString())) qFatal("'%s' was not written", qPrintable(file));
    return {file, truth_.grid.spacing_mm * glm::dvec3(from)};
  }

  /// The same piece as a tracked sweep: one frame a layer, seen by a tracker whose origin nobody knows.
  [[nodiscard]] Part writeSweep(const QString& name, const glm::ivec3& from, const glm::ivec3& dims) const {
    Sequence sweep;
    sweep.width = dims.x;
    sweep.height = dims.y;
    sweep.orientation = "MF";
    sweep.imageType = "BRIGHTNESS";
    const glm::dvec3 spacing = truth_.grid.spacing_mm;
    for (int k = 0; k < dims.z; ++k) {
      SequenceFrame frame;
      frame.time_s = 0.1 * k;
      glm::dmat4 imageToReference(1.0);
      for (int axis = 0; axis < 3; ++axis) imageToReference[axis][axis] = spacing[axis];
      imageToReference[3] = glm::dvec4(0.0, 0.0, spacing.z * k, 1.0);
      frame.transforms.push_back({"Image", "Reference", imageToReference, PoseStatus::ok});
      sweep.frames.push_back(frame);
      for (int j = 0; j < dims.y; ++j)
        for (int i = 0; i < dims.x; ++i) sweep.pixels.push_back(truth_.echo[truth_.grid.indexOf(from.x + i, from.y + j, from.z + k)]);
    }
    const QString file = files_.path(name);
    if (!writeSequence(sweep, file.toStdString())) qFatal("'%s' was not written", qPrintable(file));
    return {file, spacing * glm::dvec3(from)};
  }

  /// A volume of nobody's tissue: clouds of a few millimetres.
  [[nodiscard]] QString writeStranger(const QString& name) const {
    Volume clouds;
    clouds.grid.dims = {46, 46, 40};
    clouds.grid.spacing_mm = truth_.grid.spacing_mm;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> phase(0.0, 2.0 * M_PI), wave(-0.9, 0.9);
    std::array<glm::dvec4, 40> waves{};
    for (auto& one : waves) one = {wave(random), wave(random), wave(random), phase(random)};
    for (int k = 0; k < clouds.grid.dims.z; ++k)
      for (int j = 0; j < clouds.grid.dims.y; ++j)
        for (int i = 0; i < clouds.grid.dims.x; ++i) {
          double sum = 0.0;
          for (const auto& one : waves) sum += std::cos(one.x * i + one.y * j + one.z * k + one.w);
          clouds.echo.push_back(static_cast<std::uint8_t>(std::clamp(110.0 + 12.0 * sum, 1.0, 255.0)));
        }
    const QString file = files_.path(name);
    if (!writeVolume(clouds, file.toStdString())) qFatal("'%s' was not written", qPrintable(file));
    return file;
  }

  /// How far the tissue of a warped piece was pushed, at a point of the patient (mm).
  static glm::dvec3 push(const glm::dvec3& p) {
    constexpr double kWave = 2.0 * M_PI / 90.0;
    return {2.5 * std::sin(kWave * p.y), 3.5 * std::sin(kWave * (p.z + 10.0)), 2.0 * std::sin(kWave * p.x)};
  }
  /// A piece as if a probe had pressed: at q it shows what lay at q + push(q).
  [[nodiscard]] Part writeWarpedPart(const QString& name, const glm::ivec3& from, const glm::ivec3& dims) const {
    Volume piece;
    piece.grid = truth_.grid;
    piece.grid.dims = dims;
    piece.grid.origin_mm = {0.0, 0.0, 0.0};
    const glm::dvec3 spacing = truth_.grid.spacing_mm;
    for (int k = 0; k < dims.z; ++k)
      for (int j = 0; j < dims.y; ++j)
        for (int i = 0; i < dims.x; ++i) {
          const glm::dvec3 q = spacing * glm::dvec3(from.x + i, from.y + j, from.z + k);
          const glm::dvec3 at = glm::clamp((q + push(q)) / spacing, glm::dvec3(0.0), glm::dvec3(truth_.grid.dims) - 1.001);
          const glm::ivec3 low(at);
          const glm::dvec3 part = at - glm::dvec3(low);
          double sum = 0.0;
          for (int corner = 0; corner < 8; ++corner) {
            const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
            double weight = 1.0;
            for (int axis = 0; axis < 3; ++axis) weight *= step[axis] == 1 ? part[axis] : 1.0 - part[axis];
            sum += weight * truth_.echo[truth_.grid.indexOf(low.x + step.x, low.y + step.y, low.z + step.z)];
          }
          piece.echo.push_back(static_cast<std::uint8_t>(std::lround(sum)));
        }
    const QString file = files_.path(name);
    if (!writeVolume(piece, file.toStdString())) qFatal("'%s' was not written", qPrintable(file));
    return {file, spacing * glm::dvec3(from)};
  }

  void keepImage(const char* name) const {
    const QString folder = qEnvironmentVariable("ECHOWEAVE_TEST_PICTURES");
    if (folder.isEmpty()) return;
    QTest::qWait(80);
    window_->grab().save(folder + QLatin1Char('/') + QLatin1String(name) + QStringLiteral(".png"));
  }
  [[nodiscard]] QTabWidget* tabs() const { return find<QTabWidget>("authorPanel"); }
  [[nodiscard]] QWidget* panel() const { return find<QWidget>("stitchPanel"); }
  [[nodiscard]] QWidget* view(const char* name) const { return find<QWidget>(name); }
  [[nodiscard]] QObject* stitching() const { return find<QObject>("stitchDoor"); }
  template <class Value, class... Args>
  Value ask(QObject* whom, const char* what, Args... args) const {
    Value answer{};
    const QReturnArgument<Value> returned(QMetaType::typeName(qMetaTypeId<Value>()), answer);
    if (!QMetaObject::invokeMethod(whom, what, Qt::DirectConnection, returned, args...)) qFatal("nobody answers '%s'", what);
    return answer;
  }
  [[nodiscard]] QString verdict(int a, int b) const { return ask<QString>(stitching(), "verdictOf", Q_ARG(int, a), Q_ARG(int, b)); }
  [[nodiscard]] QJsonObject project() const {
    return QJsonDocument::fromJson(ask<QString>(stitching(), "projectAsText").toUtf8()).object();
  }
  [[nodiscard]] int strokes() const {
    return static_cast<int>(ask<QString>(stitching(), "projectAsText").count(QStringLiteral("radius_mm")));
  }
  [[nodiscard]] bool jobsEnd() const {
    return waitUntil(
        [this] {
          QApplication::processEvents();
          return !window_->jobs().isRunning();
        },
        4.0 * test::kPatience_ms);
  }
  void click(const char* button) const { QTest::mouseClick(find<QPushButton>(button), Qt::LeftButton); }
  /// Shows what a click needs to reach: the inspector scrolls.
  void clickInspector(const char* button) const {
    auto* target = find<QPushButton>(button);
    for (QWidget* above = target->parentWidget(); above != nullptr; above = above->parentWidget())
      if (auto* scroll = qobject_cast<QScrollArea*>(above)) scroll->ensureWidgetVisible(target);
    QTest::mouseClick(target, Qt::LeftButton);
  }
  /// Every text of inspector and column has the room its lines take.
  void checkNoTextIsCut() const {
    QTest::qWait(50);
    for (const char* part : {"pairInspector", "stitchPanel"})
      for (const auto* label : find<QWidget>(part)->findChildren<QLabel*>()) {
        if (!label->isVisible() || label->text().isEmpty()) continue;
        const int high = label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
        QVERIFY2(label->height() >= high - 1, qPrintable(label->text()));
        if (!label->wordWrap()) QVERIFY2(label->width() >= label->minimumSizeHint().width() - 1, qPrintable(label->text()));
      }
  }
  [[nodiscard]] QString problem() const {
    const auto* label = panel()->findChild<QLabel*>(QStringLiteral("problem"));
    return label->isVisible() ? label->text() : QString();
  }
  void drop(const std::vector<QString>& files) const {
    QMimeData data;
    QList<QUrl> urls;
    for (const auto& file : files) urls << QUrl::fromLocalFile(file);
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(panel(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent event(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(panel(), &event);
  }
  void choose(const char* box, int data) const {
    auto* combo = find<QComboBox>(box);
    const int at = combo->findData(data);
    QVERIFY2(at >= 0, box);
    combo->setCurrentIndex(at);
    Q_EMIT combo->activated(at);
  }
  void openWindow(const QString& folder) {
    showWindowWithCase(folder);
    window_->openPlugins();
    window_->setWorkspace(Workspace::author);
    for (int n = 0; n < tabs()->count(); ++n)
      if (tabs()->widget(n)->objectName() == QLatin1String("panel_stitching")) tabs()->setCurrentIndex(n);
    QVERIFY(panel() != nullptr);
    QVERIFY(view("stitchStage") != nullptr);
    QVERIFY(view("stitchStage")->isVisible());
    QVERIFY(!window_->scanView().isVisible());
  }
  /// How far the pair's transform is from what the cutting of the parts says, at the middle of the fixed one.
  [[nodiscard]] double error_mm(int a, int b) const {
    return errorBetween_mm(parts_[static_cast<std::size_t>(a)], parts_[static_cast<std::size_t>(b)]);
  }
  [[nodiscard]] double errorBetween_mm(const Part& a, const Part& b) const {
    const auto m = ask<QList<double>>(stitching(), "transformNow");
    const glm::dvec3 p{50.0, 40.0, 40.0};
    const glm::dvec3 expected = p + a.at_mm - b.at_mm;
    const glm::dvec3 found{m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3], m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
                           m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]};
    return glm::length(found - expected);
  }
  void cutPieces() {
    auto patient = readPatient(std::string(EW_SOURCE_DIR) + "/cases/upper-abdomen-normal/patient.json");
    QVERIFY2(patient.has_value(), patient ? "" : patient.error().sentence().c_str());
    VoxeliseOptions options;
    options.spacing_mm = 2.0;
    auto voxels = voxelise(**patient, options, noProgress());
    QVERIFY(voxels.has_value());
    truth_ = std::move(voxels->volume);
    parts_ = {writePart(QStringLiteral("right lateral.mha"), {36, 12, 64}, {48, 48, 40}),
              writePart(QStringLiteral("right oblique with a rather long name.mha"), {58, 18, 70}, {48, 46, 40}),
              writePart(QStringLiteral("midline.mha"), {50, 14, 86}, {46, 48, 38})};
  }
  void closeAndForget() {
    window_.reset();
    // What one test leaves unsaved is not the next one's.
    QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation)).removeRecursively();
  }
};

}  // namespace ew::ui::testing

/// A main that keeps what the panel keeps in a folder of its own.
#define EW_STITCHING_TEST_MAIN(Test)                                                                                          \
  int main(int argc, char** argv) {                                                                                           \
    QTemporaryDir data;                                                                                                       \
    qputenv("XDG_DATA_HOME", data.path().toUtf8());                                                                           \
    QSurfaceFormat::setDefaultFormat(ew::ui::testing::windowFormat());                                                        \
    QApplication app(argc, argv);                                                                                             \
    QApplication::setOrganizationName(QStringLiteral("EchoWeave"));                                                           \
    QApplication::setApplicationName(QStringLiteral("EchoWeave tests"));                                                      \
    Q_INIT_RESOURCE(translations);                                                                                            \
    QTranslator translator;                                                                                                   \
    if (qEnvironmentVariable("ECHOWEAVE_TEST_LANGUAGE") == QLatin1String("de")) {                                             \
      if (translator.load(QStringLiteral(":/ew/translations/echoweave_de.qm"))) QApplication::installTranslator(&translator); \
    }                                                                                                                         \
    Test test;                                                                                                                \
    return QTest::qExec(&test, argc, argv);                                                                                   \
  }
