#include <algorithm>
#include <ostream>
#include <set>

#include "commands/records_arguments.h"
#include "ew/assessment/attempt_result.h"
#include "ew/assessment/attempt_scoring.h"
#include "ew/assessment/pseudonym.h"
#include "ew/core/foreign_json.h"
#include "ew/library/case.h"
#include "ew/library/course.h"
#include "ew/library/learning_progress.h"
#include "ew/records/record_store_settings.h"
#include "ew/records/statement_outbox.h"
#include "ew/records/xapi.h"
#include "run/arguments.h"

namespace ew::cli {
namespace {

namespace fs = std::filesystem;

Result<std::vector<fs::path>> attemptsNamed(const RecordsArguments& arguments) {
  std::set<fs::path> found;
  std::vector<fs::path> places(arguments.attempts.begin(), arguments.attempts.end());
  if (places.empty()) places = {attemptsFolder(arguments.libraryPlace())};
  std::error_code ignored;
  for (const fs::path& place : places) {
    const std::size_t before = found.size();
    if (fs::is_regular_file(place / "attempt.json", ignored)) found.insert(place);
    for (fs::directory_iterator entry(place, ignored); entry != fs::directory_iterator(); entry.increment(ignored))
      if (fs::is_regular_file(entry->path() / "attempt.json", ignored)) found.insert(entry->path());
    if (found.size() == before)
      return failure(ErrorCode::notFound, say<"There is no attempt in '%1'; name the folder of an attempt, or one that holds some.">(place),
                     {{"file", place.string()}});
  }
  return std::vector<fs::path>(found.begin(), found.end());
}

std::string courseWith(const Attempt& attempt) {
  const auto file = shippedCourseFile();
  const auto course = file ? readCourse(*file) : passOn(file.error());
  if (!course) return {};
  const CourseLesson wanted{attempt.caseId, attempt.lessonId};
  return std::find(course->lessons.begin(), course->lessons.end(), wanted) != course->lessons.end() ? course->id : std::string();
}

/// The metrics of the score that counts, step by step.
std::vector<XapiMetric> metricsFor(const AttemptResult& result) {
  std::vector<XapiMetric> metrics;
  for (const StepScore& step : result.counted.steps)
    for (const MetricValue& each : step.metrics) {
      const Metric* known = metricOf(each.id);
      metrics.push_back({each.id, each.version, each.value, known != nullptr ? std::string(known->unit) : std::string(), step.stepId});
    }
  return metrics;
}

/// Scores what has none by its plan yet, at once, so that what many attempts share is read once. What fails is told of one by one.
Result<void> scoreBefore(const std::vector<fs::path>& folders, AttemptResults& results, const fs::path& library, Run& run) {
  std::vector<fs::path> unscored;
  for (const fs::path& folder : folders) {
    const auto kept = AttemptFolder::open(folder);
    if (!kept) continue;
    const auto& plan = results.planOf(kept->attempt());
    if (plan && needsScore(results.of(folder, kept->attempt()), *plan)) unscored.push_back(folder);
  }
  if (unscored.empty()) return {};
  for (const auto& each : assess(unscored, library, {.threads = 1}, run.progress))
    if (each.problem && each.problem->code == ErrorCode::cancelled) return passOn(*each.problem);
  return {};
}

/// How statements of this machine speak of people and activities.
Result<XapiOptions> sayingsOf(const RecordsArguments& arguments) {
  const auto place = arguments.settingsPlace();
  if (!place) return passOn(place.error());
  const auto settings = readRecordStoreSettings(*place);
  if (!settings) return passOn(settings.error());
  XapiOptions options;
  options.homePage = homePageOf(*settings);
  options.activityBase = settings->activityBase;
  options.names = arguments.names;
  options.language = arguments.language;
  return options;
}

Result<std::vector<nlohmann::json>> statementsOfFolder(const fs::path& folder, XapiOptions options, const RecordsArguments& arguments,
                                                       const Pseudonyms& codes, AttemptResults& results, Run& run) {
  const auto kept = AttemptFolder::open(folder);
  if (!kept) return passOn(kept.error());
  const Attempt& attempt = kept->attempt();
  options.pseudonym = codes.ofPerson(attempt.person);
  addLessonTo(options, attempt, results, arguments.language);
  options.courseId = courseWith(attempt);
  auto result = resultToTell(folder, attempt, results, arguments.libraryPlace(), !arguments.dryRun, run);
  if (!result) return passOn(result.error());
  options.metrics = metricsFor(*result);
  options.result = std::move(*result);
  return statementsOf(attempt, options);
}

Result<int> takeRecords(const RecordsArguments& arguments, Run& run) {
  const auto folders = attemptsNamed(arguments);
  if (!folders) return passOn(folders.error());
  const auto options = sayingsOf(arguments);
  if (!options) return passOn(options.error());
  const auto codes = Pseudonyms::ofLibrary(arguments.libraryPlace());
  if (!codes) return passOn(codes.error());
  std::optional<StatementOutbox> outbox;
  if (!arguments.dryRun) {
    auto opened = StatementOutbox::open(arguments.outboxPlace());
    if (!opened) return passOn(opened.error());
    if (opened->damage()) run.remark(*opened->damage());
    outbox.emplace(std::move(*opened));
    staysDone(run);
  }
  std::size_t taken = 0, known = 0, leftOut = 0;
  AttemptResults results(arguments.libraryPlace());
  if (!arguments.dryRun)
    if (auto scored = scoreBefore(*folders, results, arguments.libraryPlace(), run); !scored) return passOn(scored.error());
  nlohmann::json shown = nlohmann::json::array();
  for (const fs::path& folder : *folders) {
    if (auto read = run.input(folder / "attempt.json"); !read) return passOn(read.error());
    const auto statements = statementsOfFolder(folder, *options, arguments, *codes, results, run);
    if (!statements && statements.error().code == ErrorCode::cancelled) return passOn(statements.error());
    if (!statements) {  // the others are none the worse for it
      ++leftOut;
      run.remark(say<"The attempt in '%1' is left out: %2">(folder, statements.error().message));
      continue;
    }
    for (const nlohmann::json& each : *statements) {
      if (arguments.dryRun) {
        shown.push_back(each);
        continue;
      }
      const auto isNew = outbox->add(each);
      if (!isNew) return passOn(isNew.error());
      *isNew ? ++taken : ++known;
    }
  }
  const Error someLeftOut{
      ErrorCode::badField, say<"Left out: %1 of %2 attempts, see the remarks; nothing of them was taken.">(leftOut, folders->size()), {}};
  if (arguments.dryRun) {
    run.out() << shown.dump(2) << "\n";
    run.isPublished = false;
    return leftOut == 0 ? kDone : run.answer(someLeftOut);
  }
  run.report.options = {{"names", arguments.names}, {"language", arguments.language}};
  run.report.quality = {{"attempts", folders->size()}, {"left_out", leftOut}, {"taken", taken}, {"known", known}};
  run.say("Took " + counted(taken, "statement") + " of " + counted(folders->size() - leftOut, "attempt") + "; " + std::to_string(known) +
          " were in the outbox or sent before. 'echoweave records send' sends them.");
  return leftOut == 0 ? kDone : run.answer(someLeftOut);
}

Result<int> tellSent(const SendStatementsResult& sent, const StatementOutbox& outbox, Run& run) {
  run.progress.clear();
  constexpr std::size_t kMostRemarks = 5;
  std::size_t told = 0;
  for (const OutboxEntry& each : outbox.entries())
    if (each.status == OutboxStatus::refused && told++ < kMostRemarks)
      run.remark(say<"The record store refuses %1: %2.">(each.id, verbatim(each.problem)));
  if (told > kMostRemarks) run.remark(say<"... and %1 more; 'echoweave records list' shows all.">(told - kMostRemarks));
  run.report.quality = {{"sent", sent.sent}, {"refused", sent.refused}, {"left", sent.left}, {"rounds", sent.rounds}};
  run.say("The record store has " + counted(sent.sent, "statement") + " more now.");
  const std::size_t refused = outbox.count(OutboxStatus::refused);
  if (sent.left > 0)
    return run.answer({ErrorCode::notWritable,
                       say<"Not in the record store yet, but safe in the outbox: %1. Send again to go on. %2">(sent.left, sent.problem),
                       {}});
  if (refused > 0)
    return run.answer(
        {ErrorCode::notWritable,
         say<"Refused by the record store: %1, see the remarks. They stay in the outbox; send with --retry when it would take "
             "them.">(refused),
         {}});
  return kDone;
}

Result<int> sendRecords(const RecordsArguments& arguments, Run& run) {
  staysDone(run);
  const auto place = arguments.settingsPlace();
  if (!place) return passOn(place.error());
  auto store = recordStoreOf(*place, arguments.secrets());
  if (!store) return passOn(store.error());
  store->timeout_s = arguments.timeout_s;
  auto outbox = StatementOutbox::open(arguments.outboxPlace());
  if (!outbox) return passOn(outbox.error());
  if (outbox->damage()) run.remark(*outbox->damage());
  if (arguments.retriesRefused)
    if (auto waits = outbox->retryRefused(); !waits) return passOn(waits.error());
  SendStatementsOptions options;
  options.mostRounds = arguments.rounds;
  const auto sent = sendStatements(*outbox, *store, options, run.progress);
  if (!sent) return passOn(sent.error());
  run.report.options = {{"endpoint", store->endpoint}, {"rounds", arguments.rounds}};
  return tellSent(*sent, *outbox, run);
}

Result<int> listRecords(const RecordsArguments& arguments, Run& run) {
  const auto outbox = StatementOutbox::open(arguments.outboxPlace());
  if (!outbox) return passOn(outbox.error());
  if (outbox->damage()) run.remark(*outbox->damage());
  nlohmann::json rows = nlohmann::json::array();
  for (const OutboxEntry& each : outbox->entries()) {
    const auto text = outbox->textOf(each.id);
    const auto statement = text ? jsonOrNull(*text) : nlohmann::json();
    const auto word = [&](const char* path) {
      const nlohmann::json::json_pointer at(path);
      return statement.is_object() && statement.contains(at) && statement[at].is_string() ? statement[at].get<std::string>()
                                                                                          : std::string("?");
    };
    run.out() << each.id << "  " << wordOf(each.status) << "  " << word("/timestamp") << "  " << word("/verb/display/en") << "  "
              << word("/object/id") << (each.problem.empty() ? "" : "  " + each.problem) << "\n";
    rows.push_back({{"id", each.id}, {"status", std::string(wordOf(each.status))}, {"problem", each.problem}});
  }
  run.report.details["statements"] = std::move(rows);
  run.report.quality = {{"waiting", outbox->count(OutboxStatus::waiting) + outbox->count(OutboxStatus::doubtful)},
                        {"refused", outbox->count(OutboxStatus::refused)},
                        {"sent", outbox->count(OutboxStatus::arrived)}};
  run.out() << counted(outbox->entries().size() - outbox->count(OutboxStatus::refused), "statement") << " to send, "
            << outbox->count(OutboxStatus::refused) << " refused, " << outbox->count(OutboxStatus::arrived) << " sent so far.\n";
  return kDone;
}

void addPlaces(CLI::App& app, RecordsArguments& arguments) {
  app.add_option("--library", arguments.library, "The library with attempts and cases (the user's own)")->type_name("DIR");
  app.add_option("--outbox", arguments.outbox, "Where statements wait (LIBRARY/records)")->type_name("DIR");
}

}  // namespace

void addRecords(CLI::App& root, Selection& selection) {
  auto& group = *root.add_subcommand("records", "Tell attempts to a learning record store (xAPI), through an outbox");
  group.require_subcommand(1);
  auto arguments = std::make_shared<RecordsArguments>();

  auto& added = addCommand(group, selection, "add",
                           "Make statements of attempts and put them into the outbox; what is there or was sent is not taken twice",
                           {"records add", "records add ~/EchoWeave/attempts/20261126-093000-4f2a91c7 --dry-run"},
                           [arguments](Run& run) { return takeRecords(*arguments, run); });
  added.add_option("ATTEMPT", arguments->attempts, "Folders of attempts, or folders that hold some (those of the library)")->type_name("");
  added.add_flag("--names", arguments->names, "Say who tried by name as well; else by a code alone that stays the same in this library");
  added.add_flag("--dry-run", arguments->dryRun, "Show the statements, take none");
  added.add_option("--language", arguments->language, "Of titles, where the case has them: en, de (en)")->type_name("LANGUAGE");
  addPlaces(added, *arguments);
  addSettingsPlace(added, *arguments);

  auto& sent = addCommand(group, selection, "send", "Send what waits in the outbox", {"records send", "records send --retry --rounds 20"},
                          [arguments](Run& run) { return sendRecords(*arguments, run); });
  addCount(sent, "--rounds", arguments->rounds, 1, 1000,
           "Tries in a row that bring nothing new, with 1 s in between, then twice as long each time, at most 300 s (8)");
  addNumber(sent, "--timeout", arguments->timeout_s, {1.0, 600.0}, "Seconds until a record store that is silent counts as away (60)");
  sent.add_flag("--retry", arguments->retriesRefused, "Also send what was refused before");
  addPlaces(sent, *arguments);
  addSettingsPlace(sent, *arguments);

  auto& listed = addCommand(group, selection, "list", "What waits in the outbox, and what was refused and why", {"records list"},
                            [arguments](Run& run) { return listRecords(*arguments, run); });
  addPlaces(listed, *arguments);

  addRecordSettings(group, selection, arguments);
  addRecordLaunch(group, selection, arguments);
}

}  // namespace ew::cli
