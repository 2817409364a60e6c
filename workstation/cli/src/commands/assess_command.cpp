#include <algorithm>
#include <ostream>
#include <set>

#include "ew/assessment/attempt_result.h"
#include "ew/assessment/attempt_scoring.h"
#include "ew/assessment/pseudonym.h"
#include "ew/core/foreign_json.h"
#include "ew/core/numbers.h"
#include "ew/io/safe_file.h"
#include "ew/library/case.h"
#include "ew/library/learning_progress.h"
#include "ew/reports/attempt_measurements.h"
#include "ew/reports/report_document.h"
#include "ew/reports/report_files.h"
#include "run/arguments.h"
#include "run/command.h"

namespace ew::cli {
namespace {

namespace fs = std::filesystem;

struct AssessArguments {
  std::vector<std::string> attempts;
  std::string library;
  std::string lesson;
  std::string output;
  std::string html;
  std::string pdf;
  std::string csv;
  std::string dicom;
  AssessOptions options;
  bool names = false;
};

bool isAttempt(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_regular_file(folder / "attempt.json", ignored);
}

/// Folders of attempts, and those in folders that hold attempts; sorted, each once.
Result<std::vector<fs::path>> foldersOf(const std::vector<std::string>& named, const fs::path& library) {
  std::set<fs::path> found;
  std::vector<fs::path> places(named.begin(), named.end());
  if (places.empty()) places = {attemptsFolder(library)};
  for (const fs::path& place : places) {
    if (isAttempt(place)) {
      found.insert(place);
      continue;
    }
    std::error_code error;
    for (fs::directory_iterator entry(place, error); !error && entry != fs::directory_iterator(); entry.increment(error))
      if (isAttempt(entry->path())) found.insert(entry->path());
    if (error && !named.empty())
      return failure(
          ErrorCode::notFound,
          say<"'%1' is neither an attempt nor a folder of attempts (%2); name the folder of one.">(place, verbatim(error.message())),
          {{"file", place.string()}});
  }
  if (found.empty())
    return failure(ErrorCode::notFound,
                   say<"There are no attempts in '%1'; they come there when lessons are worked through.">(places.front()),
                   {{"file", places.front().string()}});
  return std::vector<fs::path>(found.begin(), found.end());
}

std::string percent(double share) { return rounded(100.0 * share, 0) + " %"; }

/// Who tried: a code, or the name when that is asked for.
class Who {
 public:
  static Result<Who> of(const fs::path& library, bool names) {
    if (names) return Who(std::nullopt);
    auto codes = Pseudonyms::ofLibrary(library);
    if (!codes) return passOn(codes.error());
    return Who(*codes);
  }
  [[nodiscard]] std::string operator()(const Attempt& attempt) const {
    if (codes_) return codes_->ofPerson(attempt.person);
    return attempt.person.empty() ? "without a name" : attempt.person;
  }

 private:
  explicit Who(std::optional<Pseudonyms> codes) : codes_(codes) {}
  std::optional<Pseudonyms> codes_;
};

nlohmann::json summaryOf(const AttemptAssessment& one, const std::string& who) {
  nlohmann::json made = {
      {"attempt", one.folder.filename().string()}, {"case", one.attempt.caseId}, {"lesson", one.attempt.lessonId}, {"who", who}};
  if (one.problem) made["problem"] = one.problem->sentence();
  if (one.score)
    made.update(
        {{"score", one.score->score}, {"passed", one.score->passed}, {"number", one.score->number}, {"up_to_date", one.wasUpToDate}});
  return made;
}

std::string lineOf(const AttemptAssessment& one, const std::string& who) {
  const std::string name = one.folder.filename().string() + "  " + one.attempt.caseId + " " + one.attempt.lessonId + "  " + who + "  ";
  if (!one.score) return name + "not scored: " + one.problem->sentence() + "\n";
  // The score is of the attempt as it is and of the plan that counts: nothing else is needed to say what it amounts to.
  const AttemptResult result = attemptResultOf(one.attempt, nullptr, AssessmentPlan(), one.score);
  return name + percent(*result.score()) + ", " + std::to_string(result.stepsPassed) + " of " + counted(result.stepsJudged, "step") + ", " +
         verdictWord(result).english() + ", " + durationText(result.worked_s).english() + (one.wasUpToDate ? "" : ", scored now") + "\n";
}

/// What is told of attempts in the end. They themselves are gone by then: there may be thousands.
class Telling {
 public:
  Telling(const AssessArguments& arguments, const Who& who, Run& run) : arguments_(arguments), who_(who), run_(run) {}

  void add(const AttemptAssessment& one) {
    ++attempts_;
    fresh_ += one.score && !one.wasUpToDate ? 1 : 0;
    problems_ += one.problem ? 1 : 0;
    const std::string who = who_(one.attempt);
    told_.push_back({lineOf(one, who), summaryOf(one, who).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), {}});
    if (!one.score) return;
    for (const Message& note : one.score->notes) told_.back().notes.push_back(say<"%1: %2">(one.folder.filename(), note));
    if (!arguments_.output.empty() && written_) written_ = writeScore(one);
  }
  void tell() {
    run_.report.details["attempts"] = nlohmann::json::array();
    for (const Told& one : told_) {
      run_.out() << one.line;
      run_.report.details["attempts"].push_back(jsonOrNull(one.summary));
      for (const Message& note : one.notes) run_.remark(note);
    }
    run_.report.quality = {
        {"attempts", attempts_}, {"scored_now", fresh_}, {"up_to_date", attempts_ - fresh_ - problems_}, {"not_scored", problems_}};
  }
  /// Of the copies of scores.
  [[nodiscard]] const Result<void>& written() const { return written_; }
  [[nodiscard]] std::size_t attempts() const { return attempts_; }
  [[nodiscard]] std::size_t fresh() const { return fresh_; }
  [[nodiscard]] std::size_t problems() const { return problems_; }

 private:
  struct Told {
    std::string line;
    std::string summary;  ///< JSON, a tenth of what its values take
    std::vector<Message> notes;
  };
  [[nodiscard]] Result<void> writeScore(const AttemptAssessment& one) const {
    const fs::path file = fs::path(arguments_.output) / (one.folder.filename().string() + ".json");
    return writeFileSafely(run_.outputs.staged(file), jsonOf(*one.score).dump(1) + "\n");
  }

  const AssessArguments& arguments_;
  const Who& who_;
  Run& run_;
  std::vector<Told> told_;
  Result<void> written_;
  std::size_t attempts_ = 0, fresh_ = 0, problems_ = 0;
};

bool hasReports(const AssessArguments& arguments) { return !arguments.html.empty() || !arguments.pdf.empty() || !arguments.csv.empty(); }

ReportRequest requestOf(const AssessArguments& arguments, const std::vector<fs::path>& folders, const fs::path& library) {
  ReportRequest request;
  request.attempts = folders;
  request.library = library;
  request.html = arguments.html;
  request.pdf = arguments.pdf;
  request.csv = arguments.csv;
  request.options.names = arguments.names;
  request.threads = arguments.options.threads;
  return request;
}

/// The measurements of attempts as DICOM reports. @return how many
Result<std::size_t> writeDicom(const AssessArguments& arguments, const std::vector<fs::path>& folders, const fs::path& library, Run& run) {
  const auto codes = Pseudonyms::ofLibrary(library);
  if (!codes) return passOn(codes.error());
  std::size_t count = 0;
  AttemptResults results(library);
  for (const fs::path& folder : folders) {
    if (run.progress.cancelRequested()) return failure(ErrorCode::cancelled, run.stopped);
    const auto attempt = readReportedAttempt(folder, &results);
    if (!attempt) continue;  // said where it is scored
    const ReportLesson lesson = readReportedLesson(attempt->attempt.caseId, attempt->attempt.lessonId, library, {});
    const auto files = writeAttemptMeasurements(*attempt, lesson, *codes, arguments.names, library, run.outputs.staged(arguments.dicom));
    if (!files) return passOn(files.error());
    count += files->size();
  }
  return count;
}

/// Every file that will be written beside the scores.
Result<void> announce(const AssessArguments& arguments, const std::vector<fs::path>& folders, const fs::path& library, Run& run) {
  if (!arguments.dicom.empty())
    if (auto made = run.outputs.announceNewFolder(arguments.dicom); !made) return made;
  for (const std::string& folder : {arguments.output, arguments.html, arguments.pdf})
    if (!folder.empty())
      if (auto made = run.outputs.announceFolder(folder); !made) return made;
  if (!arguments.output.empty())
    for (const fs::path& folder : folders)
      if (auto announced = run.output(fs::path(arguments.output) / (folder.filename().string() + ".json")); !announced) return announced;
  if (!hasReports(arguments)) return {};
  const auto files = reportFiles(requestOf(arguments, folders, library));
  if (!files) return passOn(files.error());
  for (const fs::path& file : *files)
    if (auto announced = run.output(file); !announced) return announced;
  return {};
}

Result<void> writeReportFiles(const AssessArguments& arguments, const std::vector<fs::path>& folders, const fs::path& library, Run& run) {
  if (!arguments.dicom.empty()) {
    const auto count = writeDicom(arguments, folders, library, run);
    if (!count) return passOn(count.error());
    run.report.quality["dicom_reports"] = *count;
  }
  if (!hasReports(arguments)) return {};
  const StepClock clock(run.report, "report");
  return writeReports(
      requestOf(arguments, folders, library), [&run](const fs::path& file) { return run.outputs.staged(file); }, run.progress);
}

Result<int> assessAll(const AssessArguments& arguments, Run& run) {
  run.stopped = say<"Stopped as asked; what was scored by then is kept, and the same command goes on after it.">();
  const fs::path library = arguments.library.empty() ? libraryFolder() : fs::path(arguments.library);
  auto folders = foldersOf(arguments.attempts, library);
  if (!folders) return passOn(folders.error());
  if (!arguments.lesson.empty())
    std::erase_if(*folders, [&](const fs::path& folder) {
      const auto kept = AttemptFolder::open(folder);
      return kept && kept->attempt().lessonId != arguments.lesson;
    });
  if (auto announced = announce(arguments, *folders, library, run); !announced) return passOn(announced.error());
  const auto who = Who::of(library, arguments.names);
  if (!who) return passOn(who.error());
  Telling telling(arguments, *who, run);
  {
    const StepClock clock(run.report, "score");
    assess(*folders, library, arguments.options, run.progress, [&](const AttemptAssessment& one) { telling.add(one); });
  }
  if (run.progress.cancelRequested()) return failure(ErrorCode::cancelled, run.stopped);
  run.progress.clear();
  telling.tell();
  run.report.options = {{"threads", arguments.options.threads}, {"again", arguments.options.again}, {"names", arguments.names}};
  if (!telling.written()) return passOn(telling.written().error());
  if (auto written = writeReportFiles(arguments, *folders, library, run); !written) return passOn(written.error());
  const std::size_t upToDate = telling.attempts() - telling.fresh() - telling.problems();
  run.say("Scored " + counted(telling.fresh(), "attempt") + " now; " + std::to_string(upToDate) + " were up to date.");
  if (telling.problems() == 0) return kDone;
  run.out() << std::flush;
  return run.answer({ErrorCode::notReadable,
                     say<"%1 of %2 could not be scored; the lines above say why.">(counted(telling.problems(), "attempt"),
                                                                                   std::to_string(telling.attempts())),
                     {}});
}

}  // namespace

void addAssess(CLI::App& root, Selection& selection) {
  auto arguments = std::make_shared<AssessArguments>();
  auto& app = addCommand(root, selection, "assess", "Score attempts from their raw data, as the instructors' plans say",
                         {"assess", "assess ~/EchoWeave/attempts --lesson four-windows --html class --pdf class-to-print --csv class.csv",
                          "assess carried/20261126-093000-4f2a91c7 --again"},
                         [arguments](Run& run) { return assessAll(*arguments, run); });
  app.add_option("ATTEMPT", arguments->attempts, "Folders of attempts, or folders that hold some (those of the library)")->type_name("");
  app.add_option("--library", arguments->library, "The library with cases and plans (the user's own)")->type_name("DIR");
  app.add_option("--lesson", arguments->lesson, "Only attempts of this lesson")->type_name("ID");
  app.add_option("-o,--output", arguments->output,
                 "A folder for a copy of every score that counts, ATTEMPT.json; the scores themselves stay with the attempts")
      ->type_name("DIR");
  app.add_option("--html", arguments->html, "A folder for pages to read without a network: index.html, and one of each attempt")
      ->type_name("DIR");
  app.add_option("--pdf", arguments->pdf, "A folder for the same to print: index.pdf, and one of each attempt")->type_name("DIR");
  app.add_option("--csv", arguments->csv, "A table of every step and metric")->type_name("FILE.csv");
  app.add_option("--dicom", arguments->dicom, "A new folder for what was measured, as DICOM structured reports: ATTEMPT-CASE.dcm")
      ->type_name("DIR");
  addCount(app, "--threads", arguments->options.threads, 0, 256, "Attempts at once; 0: as many as processors; no score depends on it (0)");
  app.add_flag("--again", arguments->options.again, "Also what is up to date: a new score is kept only where it differs");
  app.add_flag("--names", arguments->names, "Say who tried by name; else by a code that stays the same in this library");
}

}  // namespace ew::cli
