#include "bench/teaching/bench_metrics.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>

#include "bench/teaching/metric_study.h"
#include "ew/assessment/metric.h"
#include "ew/assessment/step_metrics.h"
#include "ew/assessment/step_work.h"
#include "ew/core/parallel.h"
#include "ew/core/quiet_progress.h"
#include "ew/core/simd.h"
#include "ew/core/version.h"
#include "ew/simulated_people/simulated_trainee.h"

namespace ew {
namespace {

using nlohmann::json;

constexpr const char* kTaskScore = "task_score";
constexpr std::uint64_t kReference = 999'983;  // the number of the expert whom others are compared with

/// A number for a name, the same everywhere (FNV-1a; Fowler, Noll, Vo).
std::uint64_t numberOf(const std::string& name) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char letter : name) hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211ULL;
  return hash;
}
std::uint64_t seedOfPerson(std::uint64_t seed, SkillLevel level, std::uint64_t number) {
  return seed * 1'000'000'007ULL + static_cast<std::uint64_t>(level) * 1'000'003ULL + number;
}

std::chrono::sys_seconds firstMorning() {
  using namespace std::chrono;
  return sys_days(2026y / January / 5) + 9h;
}

/// Judged as it is in the lesson.
Result<StepOutcome> judgedStep(const LessonStep& step, const SimulatedStep& made, const TraineeCase& on) {
  auto work = workOf(step, on.ground());
  if (!work) return passOn(work.error());
  for (std::size_t n = 0; n < made.log.frameCount(); ++n) (*work)->see(made.log.frame(n));
  StepOutcome outcome;
  outcome.stepId = step.id;
  outcome.seconds = made.seconds;
  outcome.hints = made.hints;
  outcome.answer = made.answer;
  outcome.result() = (*work)->judge(made.answer);
  conclude(step, step.passLevel, outcome);
  return outcome;
}

/// The study of one lesson: who works, and what comes of it.
class LessonStudy {
 public:
  LessonStudy(const Lesson& lesson, const TraineeCase& on, const MetricsBenchOptions& options)
      : lesson_(lesson), on_(on), options_(options), name_(on.teaching().opened.id + "/" + lesson.id) {
    const std::uint64_t seed = seedOfPerson(options.seed, SkillLevel::expert, kReference);
    expert_ = simulateAttempt(lesson, on, habitsOf(SkillLevel::expert), seed ^ numberOf(name_));
    cells_.resize(lesson.steps.size());
  }

  Result<void> run(Progress& progress) {
    const int people = options_.people, all = people * static_cast<int>(std::size(kSkillLevels));
    std::optional<Error> problem;
    std::mutex guard;
    const bool done = forEachTask(all, options_.threads, progress, say<"Simulated people work through %1">(name_), [&](int n) {
      if (auto worked = work(kSkillLevels[static_cast<std::size_t>(n / people)], n % people); !worked) {
        const std::lock_guard lock(guard);
        if (!problem) problem = worked.error();
      }
    });
    if (problem) return passOn(*problem);
    if (!done) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
    return {};
  }

  /// By metric.
  void collect(std::map<std::string, std::vector<StudyCell>>& cells) {
    for (auto& step : cells_)
      for (auto& [metric, cell] : step) cells[metric].push_back(std::move(cell));
  }

 private:
  Result<void> work(SkillLevel level, int number) {
    const std::uint64_t person = seedOfPerson(options_.seed, level, static_cast<std::uint64_t>(number));
    const std::uint64_t seed = person ^ numberOf(name_);
    const auto steps = simulateAttempt(lesson_, on_, onOneDay(personOf(level, person), seed), seed);
    for (std::size_t n = 0; n < steps.size(); ++n) {
      const LessonStep& step = lesson_.steps[n];
      const auto outcome = judgedStep(step, steps[n], on_);
      if (!outcome) return passOn(outcome.error());
      ExpertStep expert;
      if (const ScanLog& scan = expert_[n].log; scan.frameCount() > 0) expert = {&scan, scan.frame(scan.frameCount() - 1)};
      auto values = metricsOf({step, *outcome, steps[n].log.frameCount() > 0 ? &steps[n].log : nullptr}, *on_.ground(), expert);
      if (!values) return passOn(values.error());
      const bool isWork = !std::holds_alternative<ReadingTask>(step.task) && !std::holds_alternative<WatchTask>(step.task);
      if (isWork) values->push_back({kTaskScore, 1, outcome->score});
      keepValues(n, level, number, *values);
    }
    if (options_.keep.empty()) return {};
    const auto begun = firstMorning() + std::chrono::days(number) + std::chrono::hours(numberOf(name_) % 8);
    const auto kept = keepSimulatedAttempt(lesson_, on_, steps, {level, number + 1, seed}, begun, options_.keep);
    if (!kept) return passOn(kept.error());
    return {};
  }

  void keepValues(std::size_t step, SkillLevel level, int number, const std::vector<MetricValue>& values) {
    const std::lock_guard lock(guard_);
    for (const MetricValue& value : values) {
      StudyCell& cell = cells_[step][value.id];
      if (cell.lesson.empty()) {
        cell = {name_, lesson_.steps[step].id, std::string(taskWord(lesson_.steps[step].task)), {}};
        for (auto& each : cell.values) each.resize(static_cast<std::size_t>(options_.people));
      }
      cell.values[static_cast<std::size_t>(level)][static_cast<std::size_t>(number)] = value.value;
    }
  }

  const Lesson& lesson_;
  const TraineeCase& on_;
  const MetricsBenchOptions& options_;
  std::string name_;
  std::vector<SimulatedStep> expert_;
  std::mutex guard_;
  std::vector<std::map<std::string, StudyCell>> cells_;  ///< by step and metric
};

json jsonOf(const std::optional<Estimate>& estimate) {
  if (!estimate) return nullptr;
  return {{"value", estimate->value}, {"low", estimate->low}, {"high", estimate->high}};
}

json rowOf(const std::string& scope, const std::string& name, const std::string& id, const std::vector<const StudyCell*>& cells,
           const MetricsBenchOptions& options) {
  const Metric* metric = metricOf(id);
  const bool moreIsBetter = metric == nullptr || metric->better == Better::more;
  const Bootstrap bootstrap{options.draws, options.seed};
  const auto whole = discriminationOf(cells, SkillLevel::novice, SkillLevel::expert, moreIsBetter, bootstrap);
  const auto early = discriminationOf(cells, SkillLevel::novice, SkillLevel::intermediate, moreIsBetter, bootstrap);
  const auto late = discriminationOf(cells, SkillLevel::intermediate, SkillLevel::expert, moreIsBetter, bootstrap);
  return {{"scope", scope},
          {"name", name},
          {"metric", id},
          {"version", metric != nullptr ? metric->version : 1},
          {"unit", metric != nullptr ? std::string(metric->unit) : std::string()},
          {"better", moreIsBetter ? "more" : "less"},
          {"steps", whole.steps},
          {"n", whole.persons},
          {"auc", jsonOf(whole.area)},
          {"g", jsonOf(whole.effect)},
          {"auc_novice_intermediate", jsonOf(early.area)},
          {"auc_intermediate_expert", jsonOf(late.area)},
          {"on", whole.area && whole.area->value >= kLeastArea}};
}

/// Every metric over everything, by kind of step and by lesson, in the order of metrics().
json rowsOf(const std::map<std::string, std::vector<StudyCell>>& cells, const MetricsBenchOptions& options) {
  std::vector<std::string> ids = {kTaskScore};
  for (const Metric& metric : metrics()) ids.emplace_back(metric.id);
  json rows = json::array();
  for (const std::string& id : ids) {
    const auto found = cells.find(id);
    if (found == cells.end()) continue;
    std::map<std::pair<std::string, std::string>, std::vector<const StudyCell*>> scopes;
    for (const StudyCell& cell : found->second)
      for (auto scope : {std::pair<std::string, std::string>{"all", ""}, {"kind", cell.kind}, {"lesson", cell.lesson}})
        scopes[std::move(scope)].push_back(&cell);
    for (const auto& [scope, of] : scopes) rows.push_back(rowOf(scope.first, scope.second, id, of, options));
  }
  return rows;
}

}  // namespace

Result<json> benchMetrics(const MetricsBenchOptions& options, Progress& progress) {
  std::map<std::string, std::vector<StudyCell>> cells;
  json report = {{"people", options.people}, {"seed", options.seed},     {"draws", options.draws}, {"program", kVersion},
                 {"simd", simdInUse()},      {"lessons", json::array()}, {"attempts", 0}};
  const double part = 1.0 / static_cast<double>(options.cases.size());
  for (std::size_t n = 0; n < options.cases.size(); ++n) {
    const double begin = part * static_cast<double>(n);
    PartOfProgress preparing(progress, begin, begin + 0.1 * part);
    auto teaching = teachingCaseOf(options.cases[n], true, options.threads, preparing);
    if (!teaching) return passOn(teaching.error());
    PartOfProgress looking(progress, begin + 0.1 * part, begin + 0.2 * part);
    const auto on = TraineeCase::of(*std::move(teaching), looking);
    if (!on) return passOn(on.error());
    const double each = 0.8 * part / static_cast<double>(std::max<std::size_t>(1, on->lessons().size()));
    for (std::size_t l = 0; l < on->lessons().size(); ++l) {
      const double from = begin + 0.2 * part + each * static_cast<double>(l);
      PartOfProgress working(progress, from, from + each);
      LessonStudy study(on->lessons()[l], *on, options);
      if (auto run = study.run(working); !run) return passOn(run.error());
      study.collect(cells);
      report["lessons"].push_back(options.cases[n].id + "/" + on->lessons()[l].id);
      report["attempts"] = report["attempts"].get<int>() + 3 * options.people;
    }
  }
  report["rows"] = rowsOf(cells, options);
  return report;
}

Result<json> benchAttempts(const AttemptsBenchOptions& options, Progress& progress) {
  std::vector<TraineeCase> cases;
  std::vector<std::pair<const TraineeCase*, const Lesson*>> lessons;
  PartOfProgress preparing(progress, 0.0, 0.2), writing(progress, 0.2, 1.0);
  for (std::size_t n = 0; n < options.cases.size(); ++n) {
    PartOfProgress part(preparing, static_cast<double>(n) / static_cast<double>(options.cases.size()),
                        static_cast<double>(n + 1) / static_cast<double>(options.cases.size()));
    auto teaching = teachingCaseOf(options.cases[n], true, options.threads, part);
    if (!teaching) return passOn(teaching.error());
    auto on = TraineeCase::of(*std::move(teaching), part);
    if (!on) return passOn(on.error());
    cases.push_back(*std::move(on));
  }
  for (const TraineeCase& on : cases)
    for (const Lesson& lesson : on.lessons()) lessons.emplace_back(&on, &lesson);
  if (lessons.empty()) return failure(ErrorCode::badUsage, say<"These cases have no lessons to work through; name others.">());
  std::optional<Error> problem;
  std::mutex guard;
  std::size_t images = 0;
  double scanned_s = 0.0;
  const bool done = forEachTask(options.count, options.threads, writing, say<"Attempts are written">(), [&](int n) {
    const auto& [on, lesson] = lessons[static_cast<std::size_t>(n) % lessons.size()];
    const SkillLevel level = kSkillLevels[static_cast<std::size_t>(n) / lessons.size() % std::size(kSkillLevels)];
    const std::uint64_t seed = seedOfPerson(options.seed, level, static_cast<std::uint64_t>(n));
    SimulationOptions simulated;
    simulated.shortest_s = 60.0 * options.minutes;
    simulated.stopped = [&] { return writing.cancelRequested(); };
    // The last scan may be against the clock, and so may be over too soon for the length that is asked for.
    Lesson unhurried = *lesson;
    for (LessonStep& step : unhurried.steps) step.time_s.reset();
    const auto steps = simulateAttempt(unhurried, *on, onOneDay(personOf(level, seed), seed), seed, simulated);
    if (simulated.stopped()) return;
    QuietProgress quiet(writing);
    const auto kept = keepSimulatedAttempt(*lesson, *on, steps, {level, n + 1, seed}, firstMorning() + std::chrono::minutes(20 * n),
                                           options.folder, quiet);
    const std::lock_guard lock(guard);
    if (!kept && !problem) problem = kept.error();
    for (const SimulatedStep& step : steps) {
      images += step.log.frameCount();
      scanned_s += step.log.end_s() - step.log.begin_s();
    }
  });
  if (problem) return passOn(*problem);
  if (!done) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
  std::uintmax_t bytes = 0;
  std::error_code ignored;
  for (const auto& each : std::filesystem::recursive_directory_iterator(options.folder, ignored))
    if (each.is_regular_file(ignored)) bytes += each.file_size(ignored);
  return json{{"attempts", options.count}, {"seconds", scanned_s}, {"images", images}, {"mib", static_cast<double>(bytes) / 1048576.0}};
}

}  // namespace ew
