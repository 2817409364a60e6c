#include <fstream>
#include <memory>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>

#include "bench/teaching/bench_metrics.h"
#include "bench/teaching/teaching_commands.h"
#include "bench/tools/bench_options.h"
#include "ew/io/safe_file.h"
#include "run/arguments.h"

namespace ew::cli {
namespace {

using nlohmann::json;

struct MetricsArguments : TeachingArguments {
  int people = 30;       ///< of each level
  int draws = 2000;      ///< of the people, for the intervals
  std::string keep;      ///< folder
  std::string page;      ///< Markdown
  std::string defaults;  ///< JSON
};

void printMetrics(std::ostream& out, const json& measured) {
  const auto value = [](const json& estimate) {
    if (estimate.is_null()) return std::string("-");
    return rounded(estimate["value"].get<double>(), 2) + " (" + rounded(estimate["low"].get<double>(), 2) + " to " +
           rounded(estimate["high"].get<double>(), 2) + ")";
  };
  for (const json& row : measured["rows"]) {
    const std::string name = row["name"].get<std::string>();
    out << (name.empty() ? "all steps" : name) << ", " << row["metric"].get<std::string>() << ": AUC " << value(row["auc"]) << ", g "
        << value(row["g"]) << ", novice and intermediate " << value(row["auc_novice_intermediate"]) << ", intermediate and expert "
        << value(row["auc_intermediate_expert"]) << (row["on"].get<bool>() ? "" : "; OFF BY DEFAULT") << "\n";
  }
}

Result<void> writeMetrics(const MetricsArguments& arguments, const json& measured, const std::string& before, Run& run) {
  if (!arguments.page.empty()) {
    const std::string page = withMetricsSection(before, metricsSection(measured));
    if (auto written = writeFileSafely(run.outputs.staged(arguments.page), page); !written) return written;
    run.say("Wrote " + arguments.page + ".");
  }
  if (!arguments.defaults.empty()) {
    const std::string text = defaultMetrics(measured).dump(1) + "\n";
    if (auto written = writeFileSafely(run.outputs.staged(arguments.defaults), text); !written) return written;
    run.say("Wrote " + arguments.defaults + ".");
  }
  return {};
}

Result<int> metrics(const MetricsArguments& arguments, Run& run) {
  auto cases = namedOrShipped(arguments.cases);
  if (!cases) return passOn(cases.error());
  std::ostringstream before;
  if (!arguments.page.empty()) {
    if (auto announced = run.output(arguments.page, ".md"); !announced) return passOn(announced.error());
    if (std::ifstream old(arguments.page, std::ios::binary); old) before << old.rdbuf();
  }
  if (!arguments.defaults.empty())
    if (auto announced = run.output(arguments.defaults, ".json"); !announced) return passOn(announced.error());
  MetricsBenchOptions options{*std::move(cases), arguments.people, arguments.seed, arguments.threads, arguments.draws, {}};
  if (!arguments.keep.empty()) {
    if (auto announced = run.outputs.announceNewFolder(arguments.keep); !announced) return passOn(announced.error());
    options.keep = run.outputs.staged(arguments.keep);
  }
  run.report.options = {{"people", arguments.people}, {"seed", arguments.seed}, {"draws", arguments.draws}};
  run.report.seed = arguments.seed;
  auto measured = benchMetrics(options, run.progress);
  if (!measured) return passOn(measured.error());
  run.progress.clear();
  if (!run.quiet()) printMetrics(run.out(), *measured);
  if (auto written = writeMetrics(arguments, *measured, before.str(), run); !written) return passOn(written.error());
  run.report.quality = *std::move(measured);
  return kDone;
}

}  // namespace

void addMetricsBench(CLI::App& group, Selection& selection) {
  const auto arguments = std::make_shared<MetricsArguments>();
  auto& app = addCommand(group, selection, "metrics",
                         "How far every metric tells simulated novices, intermediates and experts apart, on every lesson",
                         {"bench metrics", "bench metrics --case focused-trauma --people 10",
                          "bench metrics --page metrics-study.md --defaults default-metrics.json"},
                         [arguments](Run& run) { return metrics(*arguments, run); });
  addTeachingCases(app, *arguments);
  addTeachingThreads(app, *arguments);
  addSeed(app, "--seed", arguments->seed, "Which people (1)");
  addCount(app, "--people", arguments->people, 3, 1000, "Of each level (30)");
  addCount(app, "--draws", arguments->draws, 10, 100000, "Of the people, for the intervals (2000)");
  app.add_option("--keep", arguments->keep, "Also write every attempt, as the window keeps attempts, to this new folder")->type_name("DIR");
  app.add_option("--page", arguments->page, "Also write the tables; of a page that is there what stands around them stays")
      ->type_name("PAGE.md");
  app.add_option("--defaults", arguments->defaults, "Also write which metrics are on by default")->type_name("FILE.json");
}

}  // namespace ew::cli
