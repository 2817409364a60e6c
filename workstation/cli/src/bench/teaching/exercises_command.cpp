#include <algorithm>
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

struct ExercisesArguments : TeachingArguments {
  int draws = 20;  ///< of each exercise and level
};

void printExercises(std::ostream& out, const json& measured) {
  for (const json& row : measured["exercises"])
    out << row["id"].get<std::string>() << ", level " << row["level"].get<int>() << ": the expert passes " << row["expert"].get<int>()
        << " of " << row["draws"].get<int>() << ", chance " << row["chance"].get<int>() << "\n";
  for (const json& row : measured["withheld"])
    out << row["id"].get<std::string>() << " is not offered: " << row["why"].get<std::string>() << "\n";
  for (const json& row : measured["results"]) {
    const double draws = std::max(1.0, row["draws"].get<double>());
    out << row["name"].get<std::string>() << ": " << row["offered"].get<int>() << " exercises, the expert passes "
        << rounded(100.0 * row["expert"].get<double>() / draws, 1) << " %, chance "
        << rounded(100.0 * row["chance"].get<double>() / draws, 1) << " %\n";
  }
}

Result<int> exercises(const ExercisesArguments& arguments, Run& run) {
  auto cases = namedOrShipped(arguments.cases);
  if (!cases) return passOn(cases.error());
  run.report.options = {{"draws", arguments.draws}, {"seed", arguments.seed}};
  run.report.seed = arguments.seed;
  auto measured = benchExercises({*std::move(cases), arguments.draws, arguments.seed, arguments.threads}, run.progress);
  if (!measured) return passOn(measured.error());
  run.progress.clear();
  if (!run.quiet()) printExercises(run.out(), *measured);
  run.report.quality = *std::move(measured);
  return kDone;
}

}  // namespace

void addExercisesBench(CLI::App& group, Selection& selection) {
  const auto arguments = std::make_shared<ExercisesArguments>();
  auto& app =
      addCommand(group, selection, "exercises", "Every exercise that the shipped cases give by themselves, by an expert and by chance",
                 {"bench exercises", "bench exercises --draws 5 --case focused-trauma", "bench exercises --report exercises.json"},
                 [arguments](Run& run) { return exercises(*arguments, run); });
  addTeachingCases(app, *arguments);
  addCount(app, "--draws", arguments->draws, 1, 10000, "Tries of each exercise and level (20)");
  addTeachingThreads(app, *arguments);
  addSeed(app, "--seed", arguments->seed, "Which starts, and which hands (1)");
}

}  // namespace ew::cli
