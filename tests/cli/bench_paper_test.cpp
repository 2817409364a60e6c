#include <gtest/gtest.h>

#include <filesystem>

#include "bench/volumes/bench_paper.h"
#include "ew/io/image_file.h"

namespace bench_paper_test {
namespace {

using namespace ew;
namespace fs = std::filesystem;

TEST(BenchPaper, ShowsThatOneResolutionFailsWhereThePyramidSucceeds) {
  const fs::path folder = fs::temp_directory_path() / "ew-bench-paper-test";
  fs::remove_all(folder);
  fs::create_directories(folder);
  PaperBenchOptions options;
  options.sweep_mm = 10.0;
  const auto report = benchPaper(
      options, [&](const std::string& name) { return Result<std::filesystem::path>(folder / name); }, noProgress());
  ASSERT_TRUE(report) << report.error().sentence();
  const auto& rows = (*report)["figure8"]["rows"];
  ASSERT_EQ(rows.size(), 6U);
  const double single_mm = rows[1]["error_mm"], pyramid_mm = rows[5]["error_mm"];
  EXPECT_GT(single_mm, 0.8) << rows.dump(1);
  EXPECT_LT(pyramid_mm, 0.2) << rows.dump(1);
  EXPECT_GT(rows[5]["correlation"].get<double>(), rows[1]["correlation"].get<double>() + 0.05);
  EXPECT_LT(rows[2]["correlation"].get<double>(), rows[3]["correlation"].get<double>());
  const auto& seam = (*report)["figure7"]["seam"];
  EXPECT_LT(seam["warped"].get<double>(), seam["pasted"].get<double>()) << (*report)["figure7"].dump(1);
  EXPECT_LT((*report)["figure7"]["error_mm"].get<double>(), 0.6) << (*report)["figure7"].dump(1);
  for (const char* name : {"figure-6-first.png", "figure-7-warped.png", "figure-8-fixed.png", "figure-8-5.png", "paper.html", "paper.json"})
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  EXPECT_EQ(paperSections(*report).size(), 2U);
  const auto image = readImage(folder / "figure-8-moving.png");
  ASSERT_TRUE(image);
  EXPECT_EQ(image->width, 250);
  fs::remove_all(folder);
}

TEST(BenchPaper, RefusesMotionsBeyondItsRange) {
  PaperBenchOptions options;
  options.peak_mm = 100.0;
  const auto report = benchPaper(options, {}, noProgress());
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, ErrorCode::badUsage);
}

}  // namespace
}  // namespace bench_paper_test
