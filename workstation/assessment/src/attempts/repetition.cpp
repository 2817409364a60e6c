#include "ew/assessment/repetition.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "ew/assessment/random_numbers.h"
#include "ew/core/json_fields.h"

namespace ew {
namespace {

using std::chrono::sys_seconds;

constexpr double kSecondsPerDay = 86400.0;
constexpr double kLongest_days = 3650.0;

sys_seconds later(sys_seconds when, double days) {
  return when + std::chrono::seconds(static_cast<std::chrono::seconds::rep>(std::llround(days * kSecondsPerDay)));
}

double daysBetween(sys_seconds from, sys_seconds to) { return static_cast<double>((to - from).count()) / kSecondsPerDay; }

double intervalAfter(const RepetitionState& state, sys_seconds when, double ease) {
  if (state.repetitions == 0) return 1.0;
  if (state.repetitions == 1) return std::max(state.interval_days, daysBetween(state.last, when) < 0.5 * state.interval_days ? 1.0 : 6.0);
  // Passed early, it is known for less long than was planned; growing from the plan would take a day's cramming for months.
  const double known_days = std::clamp(daysBetween(state.last, when), 0.0, std::max(state.interval_days, 0.0));
  return std::clamp(std::max(state.interval_days, known_days * ease), 1.0, kLongest_days);
}

/// An order of its own for each seed that does not depend on how a list is sorted (FNV-1a, then mixed).
std::uint64_t shuffled(const std::string& id, std::uint64_t seed) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : id) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return assessment::RandomNumbers(hash ^ (seed * 0x9E3779B97F4A7C15ULL)).bits();
}

struct Seen {
  const RepetitionState* state;
  double overdue;  ///< in its own intervals
};

/// The exercises in the three kinds, without the one tried last where there is another.
struct Choice {
  std::vector<Seen> due;
  std::vector<const RepetitionState*> notDue;
  std::vector<const Exercise*> fresh;
};

/// Times are whole seconds: of two tries in one second the later stands further back in the list (withTry).
const RepetitionState* triedLast(const std::vector<RepetitionState>& states, const std::vector<const RepetitionState*>& known) {
  const RepetitionState* last = nullptr;
  for (const RepetitionState& state : states)
    if (std::find(known.begin(), known.end(), &state) != known.end() && (last == nullptr || state.last >= last->last)) last = &state;
  return last;
}

Choice choiceOf(const std::vector<RepetitionState>& states, const std::vector<Exercise>& exercises, sys_seconds now, int& tries) {
  Choice choice;
  std::vector<const RepetitionState*> known;
  for (const Exercise& exercise : exercises) {
    const auto state =
        std::find_if(states.begin(), states.end(), [&](const RepetitionState& each) { return each.exerciseId == exercise.id; });
    if (state == states.end() || state->tries == 0)
      choice.fresh.push_back(&exercise);
    else
      known.push_back(&*state);
  }
  const RepetitionState* last = triedLast(states, known);
  tries = 0;
  for (const RepetitionState* state : known) {
    tries += state->tries;
    if (state == last && exercises.size() > 1) continue;
    const double wait_days = daysBetween(state->due, now);
    if (wait_days < 0.0)
      choice.notDue.push_back(state);
    else
      choice.due.push_back({state, wait_days / std::max(state->interval_days, daysBetween(sys_seconds{}, sys_seconds{kBackAfter}))});
  }
  return choice;
}

NextExercise planned(const RepetitionState& state) { return {state.exerciseId, state.level}; }

std::optional<NextExercise> mostOverdue(const Choice& choice) {
  if (choice.due.empty()) return std::nullopt;
  return planned(*std::max_element(choice.due.begin(), choice.due.end(), [](const Seen& a, const Seen& b) {
                    // Failures first: nothing is known of them.
                    const bool failedA = a.state->repetitions == 0, failedB = b.state->repetitions == 0;
                    return std::tie(failedA, a.overdue, b.state->exerciseId) < std::tie(failedB, b.overdue, a.state->exerciseId);
                  })->state);
}

std::optional<NextExercise> longestWaiting(const Choice& choice) {
  if (choice.due.empty()) return std::nullopt;
  return planned(*std::min_element(choice.due.begin(), choice.due.end(), [](const Seen& a, const Seen& b) {
                    return std::tie(a.state->due, a.state->exerciseId) < std::tie(b.state->due, b.state->exerciseId);
                  })->state);
}

std::optional<NextExercise> something(const Choice& choice, std::uint64_t seed) {
  if (choice.fresh.empty()) return std::nullopt;
  const Exercise* chosen = *std::min_element(choice.fresh.begin(), choice.fresh.end(), [&](const Exercise* a, const Exercise* b) {
    const std::uint64_t orderA = shuffled(a->id, seed), orderB = shuffled(b->id, seed);
    return std::tie(orderA, a->id) < std::tie(orderB, b->id);
  });
  return NextExercise{chosen->id, 1};
}

std::optional<NextExercise> soonest(const Choice& choice) {
  if (choice.notDue.empty()) return std::nullopt;
  return planned(**std::min_element(choice.notDue.begin(), choice.notDue.end(), [](const auto* a, const auto* b) {
    return std::tie(a->due, a->exerciseId) < std::tie(b->due, b->exerciseId);
  }));
}

}  // namespace

int gradeOf(const StepResult& result, int hints) {
  if (!result.passed()) return result.score >= 0.4 ? 2 : result.score > 0.0 ? 1 : 0;
  const int grade = result.score >= 0.9 ? 5 : result.score >= 0.8 ? 4 : 3;
  return std::max(3, grade - std::max(0, hints));
}

RepetitionState afterwards(const RepetitionState& state, int grade, sys_seconds when) {
  const double short_ = 5.0 - std::clamp(grade, 0, 5);
  RepetitionState next = state;
  next.last = when;
  ++next.tries;
  if (grade < 3) {
    next.repetitions = 0;
    next.interval_days = 0.0;
    next.due = when + kBackAfter;
    ++next.lapses;
    next.level = std::max(1, state.level - 1);
    return next;
  }
  next.ease = std::max(kLeastEase, state.ease + 0.1 - short_ * (0.08 + short_ * 0.02));
  next.interval_days = intervalAfter(state, when, next.ease);
  next.repetitions = state.repetitions + 1;
  next.due = later(when, next.interval_days);
  if (grade >= 4) next.level = std::min(kExerciseLevels, state.level + 1);
  return next;
}

std::optional<NextExercise> nextExercise(const std::vector<RepetitionState>& states, const std::vector<Exercise>& exercises,
                                         sys_seconds now, std::uint64_t seed) {
  int tries = 0;
  const Choice choice = choiceOf(states, exercises, now, tries);
  std::optional<NextExercise> chosen;
  if (tries % 4 == 1) chosen = longestWaiting(choice);
  if (tries % 4 == 3) chosen = something(choice, seed);
  if (!chosen) chosen = mostOverdue(choice);
  if (!chosen) chosen = something(choice, seed);
  if (!chosen) chosen = soonest(choice);
  return chosen;
}

Result<std::vector<RepetitionState>> repetitionFromJson(const nlohmann::json& document) {
  constexpr double kLatest_s = 253402300799.0;  // the end of the year 9999
  JsonReading reading(verbatim("repetition.json"));
  const JsonFields root(document, reading);
  const long long format = root.whole("format", 1, 1000000);
  if (reading.problem()) return passOn(*reading.problem());
  if (format > kRepetitionFormat)
    return failure(ErrorCode::newerFormat,
                   say<"%1 has format %2, and this program reads formats up to %3; open it with a newer EchoWeave.">(
                       std::string("repetition.json"), std::to_string(format), kRepetitionFormat),
                   {{"field", "format"}, {"found", std::to_string(format)}});
  std::vector<RepetitionState> states;
  std::set<std::string> ids;
  const auto moment = [&](const JsonFields& fields, std::string_view key) {
    return sys_seconds(std::chrono::seconds(fields.whole(key, 0, static_cast<long long>(kLatest_s))));
  };
  for (const JsonFields& each : root.objects("exercises", 0, 100000)) {
    RepetitionState state;
    state.exerciseId = each.text("id", {}, 1, 1000);
    state.ease = each.number("ease", kLeastEase, 100.0);
    state.repetitions = static_cast<int>(each.whole("repetitions", 0, 1000000));
    state.interval_days = each.number("interval_days", 0.0, kLongest_days);
    state.due = moment(each, "due_s");
    state.last = moment(each, "last_s");
    state.tries = static_cast<int>(each.whole("tries", 0, 1000000));
    state.lapses = static_cast<int>(each.whole("lapses", 0, 1000000));
    state.level = static_cast<int>(each.whole("level", 1, kExerciseLevels));
    if (each.good() && !ids.insert(state.exerciseId).second) each.refuse("id", say<"an exercise that is not in the list yet">());
    states.push_back(std::move(state));
  }
  if (reading.problem()) return passOn(*reading.problem());
  return states;
}

nlohmann::json jsonOf(const std::vector<RepetitionState>& states) {
  nlohmann::json list = nlohmann::json::array();
  for (const RepetitionState& each : states)
    list.push_back({{"id", each.exerciseId},
                    {"ease", each.ease},
                    {"repetitions", each.repetitions},
                    {"interval_days", each.interval_days},
                    {"due_s", each.due.time_since_epoch().count()},
                    {"last_s", each.last.time_since_epoch().count()},
                    {"tries", each.tries},
                    {"lapses", each.lapses},
                    {"level", each.level}});
  return {{"format", kRepetitionFormat}, {"exercises", list}};
}

}  // namespace ew
