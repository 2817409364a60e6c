#include "ew/reports/report_files.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <set>

#include "ew/core/parallel.h"
#include "ew/io/safe_file.h"
#include "ew/reports/attempt_report.h"
#include "ew/reports/class_report.h"
#include "ew/reports/csv.h"
#include "ew/reports/html.h"
#include "ew/reports/report_pdf.h"
#include "page_names.h"
#include "report_words.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
constexpr const char* kIndex = "index.html";

/// The attempts of one lesson and their pages.
struct Class {
  std::string caseId, lessonId;
  std::string page;                     ///< of the class
  std::vector<ReportAttempt> attempts;  ///< by their beginning
  std::vector<std::string> pages;
};

/// All that reports are on.
struct Read {
  std::vector<Class> classes;
  std::vector<ReportBlock> leftOut;  ///< a sentence for each attempt that cannot be read
};

std::string pageOf(const Attempt& attempt, std::set<std::string>& taken) {
  const std::string name = "attempt-" + reports::plainName(attempt.id);
  std::string page = name + ".html";
  for (int n = 2; !taken.insert(page).second; ++n) page = name + "-" + std::to_string(n) + ".html";
  return page;
}

/// What a page is called on paper.
fs::path paperOf(const std::string& page) { return fs::path(page).replace_extension(".pdf"); }

Result<Read> readClasses(const ReportRequest& request, Progress& progress) {
  if (request.attempts.empty()) return failure(ErrorCode::badUsage, say<"There are no attempts to report on.">());
  std::map<std::pair<std::string, std::string>, Class> byLesson;
  Read all;
  std::optional<Error> problem;
  AttemptResults results(request.library);
  for (std::size_t n = 0; n < request.attempts.size(); ++n) {
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Writing reports was stopped.">());
    progress.report(say<"Reading attempts">(), static_cast<double>(n) / static_cast<double>(request.attempts.size()));
    auto read = readReportedAttempt(request.attempts[n], &results);
    if (!read) {
      problem = read.error();
      const Message why = reports::inWordsOf({}, read.error().message);
      all.leftOut.emplace_back(
          ReportParagraph{say<"The attempt '%1' is left out: %2">(request.attempts[n].filename(), why), ReportTone::caution});
      continue;
    }
    byLesson[{read->attempt.caseId, read->attempt.lessonId}].attempts.push_back(std::move(*read));
  }
  if (byLesson.empty()) return passOn(*problem);
  std::vector<Class>& classes = all.classes;
  std::set<std::string> taken;
  for (auto& [name, one] : byLesson) {
    std::tie(one.caseId, one.lessonId) = name;
    one.page = byLesson.size() == 1 ? kIndex : "lesson-" + std::to_string(classes.size() + 1) + ".html";
    std::stable_sort(one.attempts.begin(), one.attempts.end(),
                     [](const ReportAttempt& a, const ReportAttempt& b) { return a.attempt.startedAt < b.attempt.startedAt; });
    for (const ReportAttempt& each : one.attempts) one.pages.push_back(pageOf(each.attempt, taken));
    classes.push_back(std::move(one));
  }
  return all;
}

/// The lessons, each with its page.
ReportDocument indexOf(const std::vector<Class>& classes, const std::vector<ReportLesson>& lessons) {
  ReportDocument document;
  document.title = say<"Reports of lessons">();
  ReportTable table{
      say<"Lessons">(),
      {{say<"Lesson">()}, {say<"Case">()}, {say<"Attempts">(), true}, {say<"Passed">(), true}, {say<"Not scored yet">(), true}},
      {}};
  for (std::size_t n = 0; n < classes.size(); ++n) {
    const auto& attempts = classes[n].attempts;
    const auto count = [&](auto is) { return verbatim(std::to_string(std::count_if(attempts.begin(), attempts.end(), is))); };
    table.rows.push_back({{verbatim(reports::lessonName(attempts.front().attempt, lessons[n])), ReportTone::plain, classes[n].page},
                          {verbatim(lessons[n].caseTitle)},
                          {verbatim(std::to_string(attempts.size()))},
                          {count([](const ReportAttempt& one) { return one.result().isKnown && one.result().passed().value_or(false); })},
                          {count([](const ReportAttempt& one) { return !one.result().isKnown || !one.result().passed(); })}});
  }
  document.blocks.emplace_back(std::move(table));
  document.blocks.emplace_back(ReportParagraph{validitySentence()});
  return document;
}

/// Writes what was asked for, file by file.
class Writing {
 public:
  Writing(const ReportRequest& request, const std::function<fs::path(const fs::path&)>& staged, Progress& progress)
      : request_(request), staged_(staged), progress_(progress) {}

  Result<void> all(const Read& read) {
    auto codes = Pseudonyms::ofLibrary(request_.library);
    if (!codes) return passOn(codes.error());
    if (!request_.html.empty() || !request_.pdf.empty())
      if (auto written = pages(read, *codes); !written) return written;
    if (request_.csv.empty()) return {};
    std::vector<ReportAttempt> attempts;
    for (const Class& one : read.classes) attempts.insert(attempts.end(), one.attempts.begin(), one.attempts.end());
    return write(request_.csv, csvOf(attempts, *codes, request_.options.names));
  }

 private:
  Result<void> write(const fs::path& file, const std::string& text) const {
    if (staged_) return writeFileSafely(staged_(file), text);
    std::error_code ignored;  // writing says what is wrong
    if (file.has_parent_path()) fs::create_directories(file.parent_path(), ignored);
    return writeFileSafely(file, text);
  }

  /// A report as every kind that was asked for. @param page its name as a page
  Result<void> write(const std::string& page, const ReportDocument& document) const {
    if (!request_.html.empty())
      if (auto written = write(request_.html / page, htmlOf(document, request_.options)); !written) return written;
    if (request_.pdf.empty()) return {};
    const auto pdf = pdfOf(document, request_.options);
    if (!pdf) return passOn(pdf.error());
    return write(request_.pdf / paperOf(page), *pdf);
  }

  Result<void> pages(const Read& read, const Pseudonyms& codes) {
    const auto& classes = read.classes;
    std::vector<ReportLesson> lessons;
    for (const Class& one : classes) {
      lessons.push_back(readReportedLesson(one.caseId, one.lessonId, request_.library, request_.options));
      auto document = classReport(one.attempts, lessons.back(), codes, one.pages, request_.options);
      if (classes.size() > 1)
        document.links = {{say<"All lessons">(), kIndex}};
      else
        document.blocks.insert(document.blocks.begin(), read.leftOut.begin(), read.leftOut.end());
      if (auto written = write(one.page, document); !written) return written;
      if (auto written = attemptPages(one, lessons.back(), codes); !written) return written;
    }
    if (classes.size() == 1) return {};
    ReportDocument index = indexOf(classes, lessons);
    index.blocks.insert(index.blocks.begin(), read.leftOut.begin(), read.leftOut.end());
    return write(kIndex, index);
  }

  Result<void> attemptPages(const Class& one, const ReportLesson& lesson, const Pseudonyms& codes) {
    std::mutex guard;
    std::optional<Error> problem;
    const bool isDone =
        forEachTask(static_cast<int>(one.attempts.size()), request_.threads, progress_, say<"Writing reports">(), [&](int task) {
          const auto n = static_cast<std::size_t>(task);
          auto document = attemptReport(one.attempts[n], lesson, codes, request_.options);
          document.links = {{say<"The whole class">(), one.page}};
          const auto written = write(one.pages[n], document);
          const std::lock_guard lock(guard);
          if (!written && !problem) problem = written.error();
        });
    if (problem) return passOn(*problem);
    if (!isDone) return failure(ErrorCode::cancelled, say<"Writing reports was stopped.">());
    return {};
  }

  const ReportRequest& request_;
  const std::function<fs::path(const fs::path&)>& staged_;
  Progress& progress_;
};

}  // namespace

Result<std::vector<fs::path>> reportFiles(const ReportRequest& request) {
  const auto read = readClasses(request, noProgress());
  if (!read) return passOn(read.error());
  std::vector<fs::path> files;
  std::vector<std::string> pages = {kIndex};
  for (const Class& one : read->classes) {
    if (one.page != kIndex) pages.push_back(one.page);
    pages.insert(pages.end(), one.pages.begin(), one.pages.end());
  }
  for (const std::string& page : pages) {
    if (!request.html.empty()) files.push_back(request.html / page);
    if (!request.pdf.empty()) files.push_back(request.pdf / paperOf(page));
  }
  if (!request.csv.empty()) files.push_back(request.csv);
  return files;
}

Result<void> writeReports(const ReportRequest& request, const std::function<fs::path(const fs::path&)>& staged, Progress& progress) {
  const auto read = readClasses(request, progress);
  if (!read) return passOn(read.error());
  return Writing(request, staged, progress).all(*read);
}

}  // namespace ew
