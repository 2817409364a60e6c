#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cctype>
#include <chrono>
#include <ostream>
#include <random>
#include <set>
#include <system_error>
#include <thread>
#include <utility>

#include "commands/records_arguments.h"
#include "ew/core/numbers.h"
#include "ew/library/learning_progress.h"
#include "ew/library/sealed_answers.h"
#include "ew/records/cmi5.h"
#include "run/arguments.h"

namespace ew::cli {
namespace {

namespace fs = std::filesystem;

Cmi5Session::Moment nowInMilliseconds() { return std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now()); }

/// What goes to the system that launched us, statement by statement, through an outbox of the session's own: nothing of it is worth
/// anything later, so it does not wait with what the library sends.
class Telling {
 public:
  static Result<Telling> open(const RecordsArguments& arguments, const Cmi5Launch& launch) {
    fs::path place = arguments.outboxPlace() / "session";
    place += "-" + launch.registration + "-" + std::to_string(nowInMilliseconds().time_since_epoch().count());
    auto outbox = StatementOutbox::open(place);
    if (!outbox) return passOn(outbox.error());
    return Telling(std::move(place), std::move(*outbox));
  }
  Telling(Telling&&) = default;
  Telling& operator=(Telling&&) = delete;
  ~Telling() {
    std::error_code ignored;
    outbox_.reset();
    if (!place_.empty()) fs::remove_all(place_, ignored);
  }

  Result<void> tell(const Result<nlohmann::json>& statement) {
    if (!statement) return passOn(statement.error());
    const auto taken = outbox_->add(*statement);
    return taken ? Result<void>() : passOn(taken.error());
  }
  /// How the attempt ended, and that the session is over.
  Result<void> tellEnd(Cmi5Session& session, const std::optional<AttemptResult>& result) {
    const bool counts = result && session.data().mode == Cmi5Mode::normal;
    tellsAttempt_ = counts;
    difference_ = counts ? systemVerdictRemark(*result, session.data().masteryScore) : Message();
    if (counts)
      if (auto told = tell(session.completed(nowInMilliseconds(), result->worked_s)); !told) return told;
    if (counts && result->passed())
      if (auto told = tell(session.judged(result->score(), *result->passed(), nowInMilliseconds(), result->worked_s)); !told) return told;
    return tell(session.terminated(nowInMilliseconds()));
  }
  Result<SendStatementsResult> send(const Cmi5Session& session, const RecordsArguments& arguments, Run& run) {
    SendStatementsOptions sending;
    sending.mostRounds = arguments.rounds;
    return sendStatements(*outbox_, session.store(), sending, run.progress);
  }
  /// Whether an attempt is among what is told: none was made, or it does not count in the launch's mode.
  [[nodiscard]] bool tellsAttempt() const { return tellsAttempt_; }
  /// Where what is told differs from what the lesson says; empty: it does not.
  [[nodiscard]] const Message& difference() const { return difference_; }
  /// Why a statement was refused; empty: none was.
  [[nodiscard]] std::string refusal() const { return outbox_->entries().empty() ? std::string() : outbox_->entries().front().problem; }

 private:
  Telling(fs::path place, StatementOutbox outbox) : place_(std::move(place)), outbox_(std::move(outbox)) {}
  fs::path place_;
  std::optional<StatementOutbox> outbox_;
  bool tellsAttempt_ = false;
  Message difference_;
};

/// Sends what is told and says how it went.
Result<int> finishTelling(Telling& telling, const Cmi5Session& session, const RecordsArguments& arguments, Run& run) {
  const Cmi5Launch& launch = session.launch();
  const auto sent = telling.send(session, arguments, run);
  if (!sent) return passOn(sent.error());
  run.progress.clear();
  run.report.options = {{"endpoint", launch.endpoint}, {"activity", launch.activityId}};
  run.report.quality = {{"sent", sent->sent}, {"refused", sent->refused}, {"left", sent->left}};
  if (!telling.difference().empty()) {
    run.remark(telling.difference());
    run.report.details["difference"] = telling.difference().english();
  }
  if (sent->left > 0 || sent->refused > 0)
    return run.answer({ErrorCode::notWritable,
                       say<"%1 has not got everything: %2 Start the lesson there again, and tell the attempt to the new launch.">(
                           launchHost(launch), sent->left > 0 ? sent->problem : verbatim(telling.refusal() + ".")),
                       {}});
  run.say(launchHost(launch) +
          (telling.tellsAttempt() ? " knows of the attempt now" : " knows that the session is over; no attempt was told") +
          (session.movesOn() ? "." : "; its course asks for more before it goes on."));
  return kDone;
}

/// Who is at the window, as the system that launched it calls them.
struct Learner {
  std::string name;     ///< may be empty
  std::string account;  ///< of the system
  std::string code;     ///< the same at each of their launches
};

Learner learnerOf(const Cmi5Launch& launch) {
  constexpr std::string_view kLearnerSpace = "4d0c8a1f-6d2e-5b0b-9d55-1f7a3f1f0c61";
  const nlohmann::json& account = launch.actor["account"];
  Learner learner;
  learner.account = account["name"].get<std::string>();
  if (launch.actor.contains("name") && launch.actor["name"].is_string()) learner.name = launch.actor["name"].get<std::string>();
  learner.code = uuidOfName(kLearnerSpace, account["homePage"].get<std::string>() + "\n" + learner.account);
  return learner;
}

/// Of one launch of one learner: the window writes it into the attempts that it begins.
std::string newLaunchOf(const Learner& learner) {
  std::random_device random;
  return learner.code + "." + std::to_string(random()) + "-" + std::to_string(random());
}

/// What a window is told of the launch that opens it.
struct WindowLaunch {
  std::string id;                      ///< empty: none opens it
  std::optional<double> masteryScore;  ///< 0 to 1, where the attempt is judged by one
};

/// The environment of the window.
std::vector<std::string> environmentWith(const WindowLaunch& launch) {
  const std::string ours = std::string(kLaunchVariable) + "=", mastery = std::string(kMasteryVariable) + "=";
  std::vector<std::string> made = {ours + launch.id};
  if (launch.masteryScore) made.push_back(mastery + textOf(*launch.masteryScore));
  for (char** each = environ; each != nullptr && *each != nullptr; ++each)
    if (const std::string_view variable(*each); !variable.starts_with(ours) && !variable.starts_with(mastery)) made.emplace_back(*each);
  return made;
}

/// Where the attempt does not count, nothing is told of it that could differ from the lesson's verdict.
WindowLaunch windowLaunchOf(const Cmi5Session& session, std::string id) {
  const bool counts = session.data().mode == Cmi5Mode::normal;
  return {std::move(id), counts ? session.data().masteryScore : std::nullopt};
}

std::vector<char*> pointersTo(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// The program of the window, and the words it is started with. @param launch that its attempts belong to
Result<int> runWindow(const RecordsArguments& arguments, const std::vector<std::string>& words, const WindowLaunch& launch,
                      const Progress& progress) {
  std::error_code error;
  const fs::path program =
      !arguments.window.empty() ? fs::path(arguments.window) : fs::read_symlink("/proc/self/exe", error).parent_path() / "echoweave-window";
  std::vector<std::string> line = {program.string()};
  line.insert(line.end(), words.begin(), words.end());
  std::vector<std::string> environment = environmentWith(launch);
  pid_t child = 0;
  if (const int problem = ::posix_spawn(&child, program.c_str(), nullptr, nullptr, pointersTo(line).data(), pointersTo(environment).data());
      problem != 0)
    return failure(ErrorCode::notFound,
                   say<"The window '%1' cannot be started (%2); the lesson can be worked through there by hand, and told with 'records "
                       "launch ADDRESS ATTEMPT'.">(program, verbatim(std::generic_category().message(problem))));
  constexpr auto kLook = std::chrono::milliseconds(100);
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (progress.cancelRequested()) {
      ::kill(child, SIGTERM);
      ::waitpid(child, &status, 0);
      return failure(ErrorCode::cancelled, say<"Stopped as asked; the lesson's attempt stays, and was not told.">());
    }
    std::this_thread::sleep_for(kLook);
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

struct LessonLaunch {
  std::string caseId, lessonId;
  fs::path folder;
};

/// "CASE/LESSON" of the launch parameters; the folder is not looked for yet.
Result<LessonLaunch> lessonOf(const Cmi5Session& session) {
  const std::string& asked = session.data().launchParameters;
  const std::size_t parts = asked.find('/');
  if (parts == std::string::npos || parts == 0 || parts + 1 == asked.size())
    return failure(ErrorCode::badField,
                   say<"The course does not say which lesson it starts: its launch parameters are '%1'; its author has to put CASE/LESSON "
                       "there.">(asked),
                   {{"field", "launchParameters"}, {"found", asked}});
  return LessonLaunch{asked.substr(0, parts), asked.substr(parts + 1), {}};
}

/// The same with the folder of its case.
Result<LessonLaunch> lessonAtHand(const Cmi5Session& session, const RecordsArguments& arguments) {
  auto lesson = lessonOf(session);
  if (!lesson) return lesson;
  const auto folder = ew::findCase(lesson->caseId, arguments.libraryPlace());
  if (!folder)
    return failure(ErrorCode::notFound,
                   say<"The case '%1', which the course starts, is not in the library; import it first.">(lesson->caseId),
                   {{"case", lesson->caseId}});
  lesson->folder = *folder;
  return lesson;
}

using AttemptEntry = std::pair<fs::path, Attempt>;

Result<AttemptResult> resultOf(const AttemptEntry& attempt, const RecordsArguments& arguments, Run& run) {
  AttemptResults results(arguments.libraryPlace());
  return resultToTell(attempt.first, attempt.second, results, arguments.libraryPlace(), true, run);
}

/// Words of a name in small letters: "Lovelace, Ada" are those of "ada lovelace".
std::set<std::string> wordsOfName(const std::string& name) {
  std::set<std::string> words;
  std::string word;
  for (const char letter : name + " ") {
    const bool isLetter = std::isalnum(static_cast<unsigned char>(letter)) != 0 || static_cast<unsigned char>(letter) >= 0x80;
    if (isLetter) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    } else if (!word.empty()) {
      words.insert(std::exchange(word, {}));
    }
  }
  return words;
}

/// Whether a person's own word for themselves is one of the learner's names. @param claimed what --person says; may be empty
bool isCalled(const std::string& person, const Learner& learner, const std::string& claimed) {
  const std::set<std::string> words = wordsOfName(person);
  return person == claimed || words == wordsOfName(learner.name) || words == wordsOfName(learner.account);
}

/// Who first gave a name in the window that a launch opened: the learner, whatever they call themselves. Empty: nobody.
std::string firstPersonOf(const std::string& launch, const AttemptList& list) {
  const Attempt* first = nullptr;
  for (const auto& [folder, attempt] : list.attempts)
    if (attempt.launch == launch && !attempt.person.empty() && (first == nullptr || attempt.startedAt < first->startedAt)) first = &attempt;
  return first != nullptr ? first->person : std::string();
}

/// Whether an attempt is the learner's: their launch began it and nobody else sat down meanwhile, or it bears one of their names or none.
Result<void> expectOwn(const Attempt& attempt, const Learner& learner, const RecordsArguments& arguments) {
  const std::string& called = learner.name.empty() ? learner.account : learner.name;
  if (!attempt.launch.empty() && !attempt.launch.starts_with(learner.code + "."))
    return failure(
        ErrorCode::badUsage,
        say<"The attempt '%1' was begun by somebody else's launch, and this one is for '%2'; nothing was told.">(attempt.id, called),
        {{"attempt", attempt.id}});
  if (attempt.person.empty() || isCalled(attempt.person, learner, arguments.person)) return {};
  if (!attempt.launch.empty() && attempt.person == firstPersonOf(attempt.launch, listAttempts(attemptsFolder(arguments.libraryPlace()))))
    return {};
  return failure(
      ErrorCode::badUsage,
      say<"The attempt '%1' is by '%2', and the launch is for '%3'; give --person '%2' when this is the same person. Nothing was "
          "told.">(attempt.id, attempt.person, called),
      {{"attempt", attempt.id}});
}

/// What came of a launch.
struct LaunchOutcome {
  std::optional<AttemptEntry> finished;  ///< that this launch began, the last of several
  bool hasOthers = false;                ///< somebody finished the lesson meanwhile in an attempt that this launch did not begin
  std::string other;                     ///< who else finished it in the window that this launch opened; empty: nobody
};
LaunchOutcome attemptsOf(const std::string& launch, const Learner& learner, const LessonLaunch& lesson, std::chrono::sys_seconds since,
                         const RecordsArguments& arguments) {
  LaunchOutcome found;
  const AttemptList list = listAttempts(attemptsFolder(arguments.libraryPlace()));
  const std::string first = firstPersonOf(launch, list);
  for (const auto& each : list.attempts) {
    const Attempt& attempt = each.second;
    if (attempt.caseId != lesson.caseId || attempt.lessonId != lesson.lessonId || !attempt.finishedAt) continue;
    if (attempt.launch != launch)
      found.hasOthers = found.hasOthers || *attempt.finishedAt >= since;
    else if (!attempt.person.empty() && attempt.person != first && !isCalled(attempt.person, learner, arguments.person))
      found.other = attempt.person;
    else if (!found.finished || *found.finished->second.finishedAt < *attempt.finishedAt)
      found.finished = each;
  }
  return found;
}

/// Tells an attempt that was finished before, when it is the learner's and at the lesson that was launched.
Result<int> tellAttempt(const Cmi5Launch& launch, const Cmi5Options& options, const RecordsArguments& arguments, Run& run) {
  const fs::path folder = arguments.attempts.front();
  if (auto read = run.input(folder / "attempt.json"); !read) return passOn(read.error());
  const auto kept = AttemptFolder::open(folder);
  if (!kept) return passOn(kept.error());
  const Attempt& attempt = kept->attempt();
  if (!attempt.finishedAt)
    return failure(ErrorCode::badUsage, say<"The attempt in '%1' was stopped in the middle; finish the lesson first.">(folder),
                   {{"file", folder.string()}});
  if (auto own = expectOwn(attempt, learnerOf(launch), arguments); !own) return passOn(own.error());
  staysDone(run);
  auto session = Cmi5Session::begin(launch, options, run.progress);
  if (!session) return passOn(session.error());
  const auto lesson = lessonOf(*session);
  if (!lesson) return passOn(lesson.error());
  const TrialIdentity tried = triedAs(attempt);
  if (tried != TrialIdentity{lesson->caseId, lesson->lessonId})
    return failure(
        ErrorCode::badUsage,
        say<"The course starts the lesson %1/%2, and the attempt is at %3/%4; nothing was told. Start that lesson in the "
            "learning management system, or name an attempt at this one.">(lesson->caseId, lesson->lessonId, tried.caseId, tried.lessonId),
        {{"attempt", attempt.id}});
  const auto result = resultOf({folder, attempt}, arguments, run);
  if (!result) return passOn(result.error());
  auto telling = Telling::open(arguments, launch);
  if (!telling) return passOn(telling.error());
  if (auto told = telling->tell(session->initialized(nowInMilliseconds())); !told) return passOn(told.error());
  if (auto told = telling->tellEnd(*session, *result); !told) return passOn(told.error());
  return finishTelling(*telling, *session, arguments, run);
}

/// Asks the learner, opens the lesson in the window, and tells how it ended.
Result<int> workThrough(const Cmi5Launch& launch, const Cmi5Options& options, const RecordsArguments& arguments, Run& run) {
  staysDone(run);
  if (!arguments.isWantedByHand) {
    const auto wanted = runWindow(arguments, {"--launched-by", launchHost(launch)}, {}, run.progress);
    if (!wanted) return passOn(wanted.error());
    if (*wanted != 0) return failure(ErrorCode::cancelled, say<"The lesson was not begun; %1 was told nothing.">(launchHost(launch)));
  }
  auto session = Cmi5Session::begin(launch, options, run.progress);
  if (!session) return passOn(session.error());
  const auto lesson = lessonAtHand(*session, arguments);
  if (!lesson) return passOn(lesson.error());
  auto telling = Telling::open(arguments, launch);
  if (!telling) return passOn(telling.error());
  const auto begun = std::chrono::floor<std::chrono::seconds>(nowInMilliseconds());
  if (auto told = telling->tell(session->initialized(nowInMilliseconds())); !told) return passOn(told.error());
  // That it has begun is told at once; what the network does not take now goes with the rest.
  if (const auto sent = telling->send(*session, arguments, run); !sent && sent.error().code == ErrorCode::cancelled)
    return passOn(sent.error());
  const std::string id = newLaunchOf(learnerOf(launch));
  const auto ended =
      runWindow(arguments, {lesson->folder.string(), "--lesson", lesson->lessonId}, windowLaunchOf(*session, id), run.progress);
  if (!ended) return passOn(ended.error());
  std::optional<AttemptResult> result;
  const LaunchOutcome made = attemptsOf(id, learnerOf(launch), *lesson, begun, arguments);
  if (made.finished) {
    auto worked = resultOf(*made.finished, arguments, run);
    if (!worked) return passOn(worked.error());
    result = std::move(*worked);
  } else {
    run.remark(
        say<"The lesson was not finished in an attempt that this launch began; %1 is told that the session is over.">(launchHost(launch)));
    if (made.hasOthers)
      run.remark(
          say<"An attempt that began before, or elsewhere, was finished meanwhile and is not told: 'echoweave records launch ADDRESS "
              "ATTEMPT' tells one that is the learner's own.">());
  }
  if (!made.other.empty())
    run.remark(
        say<"'%1' finished the lesson in the same window, and is not told as '%2'; when they are the same person, 'echoweave records "
            "launch ADDRESS ATTEMPT --person NAME' tells it.">(
            made.other, learnerOf(launch).name.empty() ? learnerOf(launch).account : learnerOf(launch).name));
  if (auto told = telling->tellEnd(*session, result); !told) return passOn(told.error());
  return finishTelling(*telling, *session, arguments, run);
}

Result<int> launchRecords(const RecordsArguments& arguments, Run& run) {
  Cmi5Options options;
  options.allowsHttp = arguments.allowsHttp;
  options.certificates = arguments.certificates.value_or(std::string());
  const auto launch = cmi5LaunchOf(arguments.url, options);
  if (!launch) return passOn(launch.error());
  return arguments.attempts.empty() ? workThrough(*launch, options, arguments, run) : tellAttempt(*launch, options, arguments, run);
}

}  // namespace

void addRecordLaunch(CLI::App& group, Selection& selection, const std::shared_ptr<RecordsArguments>& arguments) {
  auto& app = addCommand(group, selection, "launch",
                         "Work through the lesson that a learning management system starts, and tell it the result (cmi5)",
                         {"records launch 'echoweave-cmi5:?endpoint=https%3A%2F%2Flms.example%2Fxapi%2F&fetch=...'",
                          "records launch 'echoweave-cmi5:?endpoint=https%3A%2F%2Flms.example%2Fxapi%2F&fetch=...' ATTEMPT"},
                         [arguments](Run& run) { return launchRecords(*arguments, run); });
  app.add_option("ADDRESS", arguments->url, "The launch: echoweave-cmi5:?endpoint=...&fetch=...&actor=...&registration=...&activityId=...")
      ->required()
      ->type_name("");
  app.add_option("ATTEMPT", arguments->attempts,
                 "The folder of an attempt that was finished before; without it the window opens the lesson")
      ->expected(0, 1)
      ->type_name("");
  app.add_option("--person", arguments->person, "What the learner is called in their attempts, when the launch calls them otherwise")
      ->type_name("NAME");
  app.add_flag("--wanted", arguments->isWantedByHand, "The learner has asked for it: begin without a question");
  app.add_option("--window", arguments->window, "The program that shows the lesson (this one's window)")->type_name("PROGRAM");
  addCount(app, "--rounds", arguments->rounds, 1, 1000, "Tries in a row that bring nothing new (8)");
  app.add_flag("--allow-http", arguments->allowsHttp, "Send without encryption, also to other machines; for a network of your own alone");
  app.add_option("--certificates", arguments->certificates, "PEM file of the authorities to trust instead of the system's")
      ->type_name("FILE");
  app.add_option("--library", arguments->library, "The library with attempts and cases (the user's own)")->type_name("DIR");
  app.add_option("--outbox", arguments->outbox, "Where statements wait while they are sent (LIBRARY/records)")->type_name("DIR");
}

}  // namespace ew::cli
