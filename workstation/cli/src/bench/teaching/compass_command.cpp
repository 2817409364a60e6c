#include <memory>
#include <ostream>
#include <string>
#include <utility>

#include "bench/teaching/bench_teaching.h"
#include "bench/teaching/teaching_commands.h"
#include "bench/tools/bench_options.h"
#include "run/arguments.h"

namespace ew::cli {
namespace {

using nlohmann::json;

struct CompassArguments : TeachingArguments {
  int starts = 100;  ///< for each plane
};

void printCompass(std::ostream& out, const json& measured) {
  for (const json& row : measured["planes"])
    out << row["case"].get<std::string>() << ", " << row["name"].get<std::string>() << " (" << rounded(row["position_mm"].get<double>(), 0)
        << " mm, " << rounded(row["angle_deg"].get<double>(), 0) << " degrees): " << row["reached"].get<int>() << " of "
        << row["starts"].get<int>() << ", median " << rounded(row["median_s"].get<double>(), 1) << " s, the slowest "
        << rounded(row["worst_s"].get<double>(), 1) << " s" << (row["reachable"].get<bool>() ? "" : "; NOT REACHABLE FROM THE SKIN")
        << "\n";
  for (const json& row : measured["results"])
    if (row.contains("share"))
      out << row["name"].get<std::string>() << ": " << rounded(100.0 * row["share"].get<double>(), 1) << " %, median "
          << rounded(row["median_s"].get<double>(), 1) << " s\n";
    else
      out << row["name"].get<std::string>() << ": expects no plane\n";
}

Result<int> compass(const CompassArguments& arguments, Run& run) {
  auto cases = namedOrShipped(arguments.cases);
  if (!cases) return passOn(cases.error());
  run.report.options = {{"starts", arguments.starts}, {"seed", arguments.seed}};
  run.report.seed = arguments.seed;
  auto measured = benchCompass({*std::move(cases), arguments.starts, arguments.seed, arguments.threads}, run.progress);
  if (!measured) return passOn(measured.error());
  run.progress.clear();
  measured->erase("steps");
  if (!run.quiet()) printCompass(run.out(), *measured);
  run.report.quality = *std::move(measured);
  return kDone;
}

}  // namespace

void addCompassBench(CLI::App& group, Selection& selection) {
  const auto arguments = std::make_shared<CompassArguments>();
  auto& app =
      addCommand(group, selection, "compass", "Hands that follow nothing but the compass, to every plane that the shipped cases expect",
                 {"bench compass", "bench compass --starts 20 --case neck-carotid-thyroid", "bench compass --report compass.json"},
                 [arguments](Run& run) { return compass(*arguments, run); });
  addTeachingCases(app, *arguments);
  addCount(app, "--starts", arguments->starts, 1, 10000, "Random starts for each plane (100)");
  addTeachingThreads(app, *arguments);
  addSeed(app, "--seed", arguments->seed, "Which starts, and which hands (1)");
}

}  // namespace ew::cli
