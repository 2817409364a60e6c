#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "ew/acquisition/import.h"

namespace ew::test {

namespace fs = std::filesystem;

/// A recording as the commands and the window take it, in one go.
Result<ImportPlan> planFile(const fs::path& file, const SweepImportOptions& options, Progress& progress) {
  auto opened = openSweep(file, options, progress);
  if (!opened) return passOn(opened.error());
  return opened->plan;
}
Result<SweepImport> importFile(const fs::path& file, const SweepImportOptions& options, Progress& progress) {
  auto opened = openSweep(file, options, progress);
  if (!opened) return passOn(opened.error());
  return importSweep(std::move(*opened), progress);
}

/// A folder of its own for each test, gone when the test ends.
class ImportSweep : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("echoweave_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Five 20 x 10 frames a millimetre apart along z, 0.5 mm to the pixel once calibrated; pixel (x, y) of frame n is 4 x + 5 y + 6 n.
  [[nodiscard]] static Sequence sweep() {
    Sequence sequence;
    sequence.width = 20;
    sequence.height = 10;
    sequence.orientation = "MF";
    sequence.imageType = "BRIGHTNESS";
    for (int n = 0; n < 5; ++n) {
      SequenceFrame frame;
      frame.time_s = 0.1 * n;
      FrameTransform probe{"Probe", "Reference", glm::dmat4(1.0), PoseStatus::ok};
      probe.matrix[3] = glm::dvec4(0.0, 0.0, n, 1.0);
      frame.transforms.push_back(probe);
      sequence.frames.push_back(frame);
      for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 20; ++x) sequence.pixels.push_back(static_cast<std::uint8_t>(4 * x + 5 * y + 6 * n));
    }
    return sequence;
  }

  [[nodiscard]] fs::path written(const Sequence& sequence) const {
    const fs::path file = folder_ / "sweep.igs.mha";
    const auto done = writeSequence(sequence, file);
    if (!done) ADD_FAILURE() << done.error();
    return file;
  }

  [[nodiscard]] fs::path deviceSet(const std::string& reconstruction) const {
    const fs::path file = folder_ / "device.xml";
    std::ofstream(file) << "<PlusConfiguration version=\"2.1\"><CoordinateDefinitions><Transform From=\"Image\" To=\"Probe\" "
                           "Matrix=\"0.5 0 0 0 0 0.5 0 0 0 0 0.5 0 0 0 0 1\"/></CoordinateDefinitions><VolumeReconstruction "
                        << reconstruction << "/></PlusConfiguration>";
    return file;
  }

  [[nodiscard]] static SweepImportOptions nearestAt(double spacing_mm, const fs::path& calibration) {
    SweepImportOptions options;
    if (!calibration.empty()) options.calibrations = {calibration};
    options.reconstruct.spacing_mm = spacing_mm;
    options.reconstruct.interpolation = Interpolation::nearest;
    return options;
  }

  fs::path folder_;
};

}  // namespace ew::test
