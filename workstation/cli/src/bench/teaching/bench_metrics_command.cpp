#include <fstream>
#include <ostream>
#include <sstream>

#include "bench/teaching/bench_metrics.h"
#include "bench/teaching/bench_teaching_commands.h"
#include "ew/io/safe_file.h"
#include "run/arguments.h"

namespace ew::cli {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

struct MetricBenchArguments {
  std::vector<std::string> cases;
  int people = 30;
  int draws = 2000;
  int threads = 0;
  std::uint64_t seed = 1;
  std::string keep;      ///< folder
  std::string page;      ///< Markdown
  std::string defaults;  ///< JSON
  int count = 1000;
  double minutes = 5.0;
  std::string output;
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

Result<void> writeMetrics(const MetricBenchArguments& arguments, const json& measured, const std::string& before, Run& run) {
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

Result<int> metricsStudied(const MetricBenchArguments& arguments, Run& run) {
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

Result<int> attemptsWritten(const MetricBenchArguments& arguments, Run& run) {
  auto cases = namedOrShipped(arguments.cases);
  if (!cases) return passOn(cases.error());
  if (auto announced = run.outputs.announceNewFolder(arguments.output); !announced) return passOn(announced.error());
  run.report.options = {{"count", arguments.count}, {"minutes", arguments.minutes}, {"seed", arguments.seed}};
  run.report.seed = arguments.seed;
  auto made = benchAttempts(
      {*std::move(cases), arguments.count, arguments.minutes, arguments.seed, arguments.threads, run.outputs.staged(arguments.output)},
      run.progress);
  if (!made) return passOn(made.error());
  run.progress.clear();
  run.say("Wrote " + counted(static_cast<std::size_t>(arguments.count), "attempt") + " with " +
          rounded((*made)["seconds"].get<double>() / 60.0, 0) + " minutes of scanning, " + rounded((*made)["mib"].get<double>(), 0) +
          " MiB, to " + arguments.output + ".");
  run.report.quality = *std::move(made);
  return kDone;
}

void addStudyOptions(CLI::App& app, MetricBenchArguments& arguments) {
  app.add_option("--case", arguments.cases, "A case; may be given several times (every shipped one)")->type_name("CASE");
  addCount(app, "--threads", arguments.threads, 0, 256, "Threads; 0: one per processor (0)");
  addSeed(app, "--seed", arguments.seed, "Which people (1)");
}

}  // namespace

void addMetricBenches(CLI::App& group, Selection& selection) {
  const auto study = std::make_shared<MetricBenchArguments>();
  auto& studied = addCommand(group, selection, "metrics",
                             "How far every metric tells simulated novices, intermediates and experts apart, on every lesson",
                             {"bench metrics", "bench metrics --case focused-trauma --people 10",
                              "bench metrics --page metrics-study.md --defaults default-metrics.json"},
                             [study](Run& run) { return metricsStudied(*study, run); });
  addStudyOptions(studied, *study);
  addCount(studied, "--people", study->people, 3, 1000, "Of each level (30)");
  addCount(studied, "--draws", study->draws, 10, 100000, "Of the people, for the intervals (2000)");
  studied.add_option("--keep", study->keep, "Also write every attempt, as the window keeps attempts, to this new folder")->type_name("DIR");
  studied.add_option("--page", study->page, "Also write the tables; of a page that is there what stands around them stays")
      ->type_name("PAGE.md");
  studied.add_option("--defaults", study->defaults, "Also write which metrics are on by default")->type_name("FILE.json");

  const auto written = std::make_shared<MetricBenchArguments>();
  auto& wrote =
      addCommand(group, selection, "attempts", "Write attempts of simulated people, for whoever measures scoring",
                 {"bench attempts --count 1000 --minutes 5 -o attempts"}, [written](Run& run) { return attemptsWritten(*written, run); });
  addStudyOptions(wrote, *written);
  addCount(wrote, "--count", written->count, 1, 100000, "Attempts (1000)");
  addNumber(wrote, "--minutes", written->minutes, {0.0, 60.0}, "Of scanning in each at least (5)");
  wrote.add_option("-o,--output", written->output, "A new folder")->required()->type_name("DIR");
}

}  // namespace ew::cli
