#include <algorithm>

#include "ew/core/numbers.h"
#include "ew/imaging/tissue_level.h"
#include "ew/io/volume_file.h"
#include "run/arguments.h"
#include "run/command.h"
#include "run/volume_input.h"

namespace ew::cli {
namespace {

struct LevelArguments {
  std::string volume;
  std::string output;
  std::string coverage;
  double sigma_mm = LevelOptions{}.sigma_mm;
  double dynamicRange_db = LevelOptions{}.recordedDynamicRange_db;
  int threads = 0;
};

Result<int> makeLevel(const LevelArguments& arguments, Run& run) {
  if (auto kept = run.protect(arguments.volume); !kept) return passOn(kept.error());
  if (!arguments.coverage.empty())
    if (auto kept = run.input(arguments.coverage); !kept) return passOn(kept.error());
  if (auto announced = run.output(arguments.output, ".mha .mhd"); !announced) return passOn(announced.error());
  auto volume = readInputVolume(run, arguments.volume);
  if (!volume) return passOn(volume.error());
  if (!arguments.coverage.empty()) {
    PartOfProgress reading(run.progress, 0.3, 0.4);
    if (auto read = readCoverageInto(*volume, arguments.coverage, reading); !read) return passOn(read.error());
  }

  const LevelOptions options{
      .sigma_mm = arguments.sigma_mm, .recordedDynamicRange_db = arguments.dynamicRange_db, .threads = arguments.threads};
  Volume made{volume->grid, {}, {}};
  {
    const StepClock clock(run.report, "level");
    PartOfProgress levelling(run.progress, kShareOfReading, 0.95);
    auto level = levelOf(*volume, options, levelling);
    if (!level) return passOn(level.error());
    made.echo = std::move(*level);
  }
  const StepClock clock(run.report, "write");
  PartOfProgress writing(run.progress, 0.95, 1.0);
  if (auto written = writeVolume(made, run.outputs.staged(arguments.output), writing); !written) return passOn(written.error());
  const auto known = static_cast<double>(std::count_if(made.echo.begin(), made.echo.end(), [](std::uint8_t each) { return each > 0; }));
  const double share = known / static_cast<double>(made.echo.size());
  run.report.options = {{"sigma_mm", options.sigma_mm},
                        {"recorded_dynamic_range_db", options.recordedDynamicRange_db},
                        {"coverage", !arguments.coverage.empty()},
                        {"threads", arguments.threads}};
  run.report.quality = {{"voxels", made.echo.size()},
                        {"known_share", share},
                        {"forecast_mib", static_cast<double>(levelForecast_bytes(made.grid, options)) / 1048576.0}};
  run.say("Wrote " + arguments.output + ": the level of " + rounded(100.0 * share, 1) + " % of the voxels; the others have no data.");
  return kDone;
}

}  // namespace

void addLevel(CLI::App& root, Selection& selection) {
  auto arguments = std::make_shared<LevelArguments>();
  auto& app = addCommand(root, selection, "level", "Find the mean echo of a recorded volume's tissue, for live echoes",
                         {"level liver.mha -o liver-level.mha", "level volume.mha -o level.mha --coverage coverage.mha --sigma-mm 1.5"},
                         [arguments](Run& run) { return makeLevel(*arguments, run); });
  app.add_option("VOLUME", arguments->volume, "The volume: .mha, .mhd, .nrrd, .nii or .nii.gz")->required()->type_name("");
  app.add_option("-o,--output", arguments->output, "The level, which a case names as volume.level: .mha, or .mhd with its .raw")
      ->required()
      ->type_name("LEVEL.mha");
  app.add_option("--coverage", arguments->coverage,
                 "Which voxels were measured, as reconstruct and stitch write it; without it black voxels count as not recorded")
      ->type_name("COVERAGE.mha");
  addNumber(app, "--sigma-mm", arguments->sigma_mm, {0.2, 5.0},
            "Standard deviation in mm of the Gaussian over which even tissue is averaged; edges keep half of it (1.2)");
  addNumber(app, "--dynamic-range-db", arguments->dynamicRange_db, {20.0, 120.0},
            "What grey 0 to 255 of the volume spans; a case's scene says it as recorded_dynamic_range_db (60)");
  addCount(app, "--threads", arguments->threads, 0, 1000, "Threads; 0: all cores; the level does not depend on it (0)");
}

}  // namespace ew::cli
