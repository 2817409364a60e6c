#include <algorithm>
#include <ostream>

#include "bench/teaching/bench_metrics.h"
#include "bench/teaching/bench_teaching.h"
#include "bench/teaching/bench_teaching_commands.h"
#include "run/arguments.h"
#include "run/volume_input.h"

namespace ew::cli {
namespace {

using nlohmann::json;

struct TeachingArguments {
  std::vector<std::string> cases;
  int starts = 100;
  int threads = 0;
  std::uint64_t seed = 1;
};

Result<int> compass(const TeachingArguments& arguments, Run& run) {
  auto cases = namedOrShipped(arguments.cases);
  if (!cases) return passOn(cases.error());
  run.report.options = {{"starts", arguments.starts}, {"seed", arguments.seed}};
  run.report.seed = arguments.seed;
  auto measured = benchCompass({*std::move(cases), arguments.starts, arguments.seed, arguments.threads}, run.progress);
  if (!measured) return passOn(measured.error());
  run.progress.clear();
  measured->erase("steps");
  if (!run.quiet()) {
    for (const json& row : (*measured)["planes"])
      run.out() << row["case"].get<std::string>() << ", " << row["name"].get<std::string>() << " ("
                << rounded(row["position_mm"].get<double>(), 0) << " mm, " << rounded(row["angle_deg"].get<double>(), 0)
                << " degrees): " << row["reached"].get<int>() << " of " << row["starts"].get<int>() << ", median "
                << rounded(row["median_s"].get<double>(), 1) << " s, the slowest " << rounded(row["worst_s"].get<double>(), 1) << " s"
                << (row["reachable"].get<bool>() ? "" : "; NOT REACHABLE FROM THE SKIN") << "\n";
    for (const json& row : (*measured)["results"])
      if (row.contains("share"))
        run.out() << row["name"].get<std::string>() << ": " << rounded(100.0 * row["share"].get<double>(), 1) << " %, median "
                  << rounded(row["median_s"].get<double>(), 1) << " s\n";
      else
        run.out() << row["name"].get<std::string>() << ": expects no plane\n";
  }
  run.report.quality = *std::move(measured);
  return kDone;
}

Result<int> exercises(const TeachingArguments& arguments, Run& run) {
  auto cases = namedOrShipped(arguments.cases);
  if (!cases) return passOn(cases.error());
  run.report.options = {{"draws", arguments.starts}, {"seed", arguments.seed}};
  run.report.seed = arguments.seed;
  auto measured = benchExercises({*std::move(cases), arguments.starts, arguments.seed, arguments.threads}, run.progress);
  if (!measured) return passOn(measured.error());
  run.progress.clear();
  if (!run.quiet()) {
    for (const json& row : (*measured)["exercises"])
      run.out() << row["id"].get<std::string>() << ", level " << row["level"].get<int>() << ": the expert passes "
                << row["expert"].get<int>() << " of " << row["draws"].get<int>() << ", chance " << row["chance"].get<int>() << "\n";
    for (const json& row : (*measured)["withheld"])
      run.out() << row["id"].get<std::string>() << " is not offered: " << row["why"].get<std::string>() << "\n";
    for (const json& row : (*measured)["results"]) {
      const double draws = std::max(1.0, row["draws"].get<double>());
      run.out() << row["name"].get<std::string>() << ": " << row["offered"].get<int>() << " exercises, the expert passes "
                << rounded(100.0 * row["expert"].get<double>() / draws, 1) << " %, chance "
                << rounded(100.0 * row["chance"].get<double>() / draws, 1) << " %\n";
    }
  }
  run.report.quality = *std::move(measured);
  return kDone;
}

void addOptions(CLI::App& app, TeachingArguments& arguments, const char* count, const char* description) {
  app.add_option("--case", arguments.cases, "A case; may be given several times (every shipped one)")->type_name("CASE");
  addCount(app, count, arguments.starts, 1, 10000, description);
  addCount(app, "--threads", arguments.threads, 0, 256, "Threads; 0: one per processor (0)");
  addSeed(app, "--seed", arguments.seed, "Which starts, and which hands (1)");
}

}  // namespace

Result<std::vector<Case>> namedOrShipped(const std::vector<std::string>& names) {
  std::vector<Case> cases;
  for (const std::string& name : names) {
    auto found = findCase(name);
    if (!found) return passOn(found.error());
    cases.push_back(*std::move(found));
  }
  if (!names.empty()) return cases;
  const auto shipped = shippedCasesFolder();
  if (!shipped) return passOn(shipped.error());
  for (Case& each : listCases(*shipped).cases) cases.push_back(std::move(each));
  return cases;
}

void addTeachingBenches(CLI::App& group, Selection& selection) {
  const auto arguments = std::make_shared<TeachingArguments>();
  auto& app =
      addCommand(group, selection, "compass", "Hands that follow nothing but the compass, to every plane that the shipped cases expect",
                 {"bench compass", "bench compass --starts 20 --case neck-carotid-thyroid", "bench compass --report compass.json"},
                 [arguments](Run& run) { return compass(*arguments, run); });
  addOptions(app, *arguments, "--starts", "Random starts for each plane (100)");
  const auto others = std::make_shared<TeachingArguments>();
  others->starts = 20;
  auto& tried =
      addCommand(group, selection, "exercises", "Every exercise that the shipped cases give by themselves, by an expert and by chance",
                 {"bench exercises", "bench exercises --draws 5 --case focused-trauma", "bench exercises --report exercises.json"},
                 [others](Run& run) { return exercises(*others, run); });
  addOptions(tried, *others, "--draws", "Tries of each exercise and level (20)");
  addMetricBenches(group, selection);
}

}  // namespace ew::cli
