#include <chrono>
#include <ostream>

#include "arguments.h"
#include "ew/records/cmi5.h"
#include "records_arguments.h"

namespace ew::cli {
namespace {

namespace fs = std::filesystem;

/// What an attempt amounts to, as its statements say it.
struct AttemptResult {
  std::optional<double> score;  ///< 0 to 1
  std::optional<bool> success;  ///< empty: not judged yet
  double worked_s = 0.0;
};

Result<AttemptResult> resultOf(const fs::path& folder, const Cmi5Launch& launch, const RecordsArguments& arguments) {
  const auto kept = KeptAttempt::open(folder);
  if (!kept) return passOn(kept.error());
  const Attempt& attempt = kept->attempt();
  if (!attempt.finishedAt)
    return failure(ErrorCode::badUsage, say<"The attempt in '%1' was stopped in the middle; finish the lesson first.">(folder),
                   {{"file", folder.string()}});
  XapiOptions options;
  options.actor = launch.actor;
  options.registration = launch.registration;
  addLessonTo(options, attempt, arguments.libraryPlace(), arguments.language);
  const auto statements = statementsOf(attempt, options);
  if (!statements) return passOn(statements.error());
  AttemptResult result;
  for (const StepOutcome& outcome : attempt.outcomes) result.worked_s += outcome.seconds;
  const nlohmann::json& last = statements->back();
  if (last["result"].contains("success")) result.success = last["result"]["success"].get<bool>();
  if (last["result"].contains("score")) result.score = last["result"]["score"]["scaled"].get<double>();
  return result;
}

Cmi5Session::Moment nowInMilliseconds() { return std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now()); }

/// The statements of the session, into an outbox of its own.
Result<void> tellSession(Cmi5Session& session, const AttemptResult& result, StatementOutbox& outbox) {
  const auto tell = [&](const Result<nlohmann::json>& statement) -> Result<void> {
    if (!statement) return passOn(statement.error());
    const auto taken = outbox.add(*statement);
    return taken ? Result<void>() : passOn(taken.error());
  };
  const bool counts = session.data().mode == Cmi5Mode::normal;
  if (auto told = tell(session.initialized(nowInMilliseconds())); !told) return told;
  if (counts)
    if (auto told = tell(session.completed(nowInMilliseconds(), result.worked_s)); !told) return told;
  if (counts && result.success)
    if (auto told = tell(session.judged(result.score, *result.success, nowInMilliseconds(), result.worked_s)); !told) return told;
  return tell(session.terminated(nowInMilliseconds()));
}

Result<int> launchRecords(const RecordsArguments& arguments, Run& run) {
  Cmi5Options options;
  options.allowsHttp = arguments.allowsHttp;
  options.certificates = arguments.certificates.value_or(std::string());
  const auto launch = cmi5LaunchOf(arguments.url, options);
  if (!launch) return passOn(launch.error());
  if (auto read = run.input(fs::path(arguments.attempts.front()) / "attempt.json"); !read) return passOn(read.error());
  const auto result = resultOf(arguments.attempts.front(), *launch, arguments);
  if (!result) return passOn(result.error());
  // The session's statements are worth nothing later, so they do not wait with those of the library.
  fs::path place = arguments.outboxPlace() / "session";
  place += "-" + launch->registration + "-" + std::to_string(nowInMilliseconds().time_since_epoch().count());
  auto outbox = StatementOutbox::open(place);
  if (!outbox) return passOn(outbox.error());
  staysDone(run);
  const auto clear = [&] {
    std::error_code ignored;
    fs::remove_all(place, ignored);
  };
  auto session = Cmi5Session::begin(*launch, options, run.progress);
  if (!session) {
    clear();
    return passOn(session.error());
  }
  if (auto told = tellSession(*session, *result, *outbox); !told) return passOn(told.error());
  SendStatementsOptions sending;
  sending.mostRounds = arguments.rounds;
  const auto sent = sendStatements(*outbox, session->store(), sending, run.progress);
  if (!sent) return passOn(sent.error());
  run.progress.clear();
  run.report.options = {{"endpoint", launch->endpoint}, {"activity", launch->activityId}};
  run.report.quality = {{"sent", sent->sent}, {"refused", sent->refused}, {"left", sent->left}};
  const std::string refused = outbox->entries().empty() ? std::string() : outbox->entries().front().problem;
  clear();
  if (sent->left > 0 || sent->refused > 0)
    return run.answer({ErrorCode::notWritable,
                       say<"%1 has not got everything: %2 Start the lesson there again, and tell the attempt to the new launch.">(
                           launchHost(*launch), sent->left > 0 ? sent->problem : verbatim(refused + ".")),
                       {}});
  run.say(launchHost(*launch) + " knows of the attempt now" + (session->movesOn() ? "." : "; its course asks for more before it goes on."));
  return kDone;
}

}  // namespace

void addRecordLaunch(CLI::App& group, Selection& selection, const std::shared_ptr<RecordsArguments>& arguments) {
  auto& app =
      addCommand(group, selection, "launch", "Tell an attempt to the learning management system that has launched this program (cmi5)",
                 {"records launch 'echoweave-cmi5:?endpoint=https%3A%2F%2Flms.example%2Fxapi%2F&fetch=...' ATTEMPT"},
                 [arguments](Run& run) { return launchRecords(*arguments, run); });
  app.add_option("ADDRESS", arguments->url, "The launch: echoweave-cmi5:?endpoint=...&fetch=...&actor=...&registration=...&activityId=...")
      ->required()
      ->type_name("");
  app.add_option("ATTEMPT", arguments->attempts, "The folder of a finished attempt")->required()->expected(1)->type_name("");
  addCount(app, "--rounds", arguments->rounds, 1, 1000, "Tries in a row that bring nothing new (8)");
  app.add_flag("--allow-http", arguments->allowsHttp, "Send without encryption, also to other machines; for a network of your own alone");
  app.add_option("--certificates", arguments->certificates, "PEM file of the authorities to trust instead of the system's")
      ->type_name("FILE");
  app.add_option("--library", arguments->library, "The library with attempts and cases (the user's own)")->type_name("DIR");
  app.add_option("--outbox", arguments->outbox, "Where statements wait while they are sent (LIBRARY/records)")->type_name("DIR");
}

}  // namespace ew::cli
