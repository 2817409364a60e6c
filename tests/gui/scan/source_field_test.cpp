// What a new case is made from, asked of a host whose jobs run when the test says so: an answer that comes late.
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <memory>

#include "ew/door/door.h"
#include "ew/io/volume_file.h"
#include "hard_cases/keeping_host.h"
#include "library/temporary_folder.h"
#include "places.h"
#include "time_limit.h"

namespace ew::ui::testing {

class SourceFieldTest final : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  door::door_test::KeepingHost host_;
  std::unique_ptr<door::PluginList> plugins_;
  std::unique_ptr<QWidget> panel_;  // before the plugin that made it goes

  /// @param isSpaced else it has to be asked how large its voxels are
  [[nodiscard]] QString write(const char* name, bool isSpaced) const {
    const QString file = folder_.filePath(QLatin1String(name));
    Volume volume;
    volume.grid.dims = {12, 20, 8};
    if (isSpaced) volume.grid.spacing_mm = glm::dvec3(0.5);
    for (int n = 0; n < 12 * 20 * 8; ++n) volume.echo.push_back(static_cast<std::uint8_t>(20 + 5 * ((n / 12) % 20)));
    return writeVolume(volume, file.toStdString()) ? file : QString();
  }
  [[nodiscard]] static QWidget* dialog() {
    for (QWidget* each : QApplication::topLevelWidgets())
      if (each->objectName() == QLatin1String("newCaseDialog") && each->isVisible()) return each;
    return nullptr;
  }
  template <class Widget>
  [[nodiscard]] static Widget& in(const char* name) {
    auto* found = dialog()->findChild<Widget*>(QLatin1String(name));
    if (found == nullptr) qFatal("there is no widget '%s'", name);
    return *found;
  }
  [[nodiscard]] bool comesToJobs(std::size_t count) const {
    return QTest::qWaitFor([&] { return host_.jobsKept.size() == count; }, static_cast<int>(test::kPatience_ms));
  }
  void run(std::size_t number) {
    const auto job = host_.jobsKept.at(number);
    job.done(job.work(noProgress()));
  }

 private Q_SLOTS:
  void initTestCase() {
    plugins_ = std::make_unique<door::PluginList>(std::vector<std::filesystem::path>{std::filesystem::path(EW_BINARY_DIR) / "lib/plugins"});
    plugins_->openAll(host_);
    const auto panel = std::find_if(host_.panelsKept.begin(), host_.panelsKept.end(),
                                    [](const sdk::StagePanel& each) { return each.id == "case_authoring"; });
    QVERIFY(panel != host_.panelsKept.end());
    panel_.reset(panel->make(nullptr));
  }

  void theAnswerAboutAFileThatIsNotChosenAnyMoreIsNotTaken() {
    const QString first = write("first.mha", true), second = write("second.mha", false);
    QVERIFY(!first.isEmpty() && !second.isEmpty());
    panel_->findChild<QPushButton*>(QStringLiteral("newCaseHere"))->click();
    QVERIFY(QTest::qWaitFor([] { return dialog() != nullptr; }, static_cast<int>(test::kPatience_ms)));
    const std::size_t before = host_.jobsKept.size();
    in<QLineEdit>("sourceFile").setText(first);
    QVERIFY(comesToJobs(before + 1));
    in<QLineEdit>("sourceFile").setText(folder_.filePath(QStringLiteral("nowhere.mha")));
    in<QLineEdit>("sourceFile").setText(second);
    run(before);  // it took until now
    QVERIFY2(!in<QComboBox>("sourceSide").isVisible(), "the side of the first file is asked for the second");
    QVERIFY(comesToJobs(before + 2));
    QVERIFY(!in<QPushButton>("newCaseNext").isEnabled());
    run(before + 1);
    QVERIFY2(in<QDoubleSpinBox>("sourceVoxel0").isVisible(), "what the second leaves open");
    QVERIFY(!in<QComboBox>("sourceSide").isVisible());
  }
};

}  // namespace ew::ui::testing

using ew::ui::testing::SourceFieldTest;

int main(int argc, char** argv) {
  const ew::test::TemporaryFolder data;  // where a panel keeps what is not saved yet
  qputenv("XDG_DATA_HOME", QByteArray::fromStdString(data.path().string()));
  QApplication app(argc, argv);
  SourceFieldTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "source_field_test.moc"
