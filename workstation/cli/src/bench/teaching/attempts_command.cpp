#include <memory>
#include <string>
#include <utility>

#include "bench/teaching/bench_metrics.h"
#include "bench/teaching/teaching_commands.h"
#include "bench/tools/bench_options.h"
#include "run/arguments.h"

namespace ew::cli {
namespace {

struct AttemptsArguments : TeachingArguments {
  int count = 1000;
  double minutes = 5.0;  ///< of scanning in each
  std::string output;    ///< folder
};

Result<int> attempts(const AttemptsArguments& arguments, Run& run) {
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

}  // namespace

void addAttemptsBench(CLI::App& group, Selection& selection) {
  const auto arguments = std::make_shared<AttemptsArguments>();
  auto& app =
      addCommand(group, selection, "attempts", "Write attempts of simulated people, for whoever measures scoring",
                 {"bench attempts --count 1000 --minutes 5 -o attempts"}, [arguments](Run& run) { return attempts(*arguments, run); });
  addTeachingCases(app, *arguments);
  addTeachingThreads(app, *arguments);
  addSeed(app, "--seed", arguments->seed, "Which people (1)");
  addCount(app, "--count", arguments->count, 1, 100000, "Attempts (1000)");
  addNumber(app, "--minutes", arguments->minutes, {0.0, 60.0}, "Of scanning in each at least (5)");
  app.add_option("-o,--output", arguments->output, "A new folder")->required()->type_name("DIR");
}

}  // namespace ew::cli
