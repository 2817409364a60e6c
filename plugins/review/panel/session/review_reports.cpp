#include "panel/session/review_reports.h"

#include <QLocale>
#include <utility>
#include <vector>

#include "ew/assessment/attempt_result.h"
#include "ew/assessment/pseudonym.h"
#include "ew/io/safe_file.h"
#include "ew/library/folders.h"
#include "ew/reports/attempt_report.h"
#include "ew/reports/class_report.h"
#include "ew/reports/html.h"
#include "ew/reports/report_pdf.h"
#include "ew/widgets/words.h"

namespace ew::review {

namespace {

namespace fs = std::filesystem;

/// What people print on where the window's locale is at home.
PaperSize usualPaper() { return QLocale().measurementSystem() == QLocale::ImperialUSSystem ? PaperSize::letter : PaperSize::a4; }

/// The attempts that a report is on, and how it is told.
struct ReportWork {
  std::vector<fs::path> attempts;
  bool isOfClass = false;
  ReportOptions options;

  Result<void> run(const fs::path& file, Progress& progress) const {
    auto document = made(progress);
    if (!document) return passOn(document.error());
    const bool isPaper = words(file.string()).endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive);
    return isPaper ? writeReportPdf(*document, options, usualPaper(), file) : writeFileSafely(file, htmlOf(*document, options));
  }

 private:
  Result<ReportDocument> made(Progress& progress) const {
    const fs::path library = libraryFolder();
    AttemptResults results(library);
    std::vector<ReportAttempt> read;
    for (const fs::path& folder : attempts) {
      if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Stopped as asked.">());
      progress.report(say<"Reading attempts">(), static_cast<double>(read.size()) / static_cast<double>(attempts.size()));
      auto one = readReportedAttempt(folder, &results);
      if (!one) return passOn(one.error());
      read.push_back(std::move(*one));
    }
    auto codes = Pseudonyms::ofLibrary(library);
    if (!codes) return passOn(codes.error());
    const Attempt& first = read.front().attempt;
    const ReportLesson lesson = readReportedLesson(first.caseId, first.lessonId, library, options);
    if (isOfClass) return classReport(read, lesson, *codes, {}, options);
    return attemptReport(read.front(), lesson, *codes, options);
  }
};

}  // namespace

void ReviewReports::ask(const sdk::SaveFile& asked, bool isOfClass) {
  if (const auto file = host_.window().askSaveFile(asked)) write(*file, isOfClass);
}

void ReviewReports::write(const fs::path& file, bool isOfClass) {
  auto work = std::make_shared<ReportWork>();
  work->isOfClass = isOfClass;
  work->options.names = reviewer_.showsNames();
  work->options.language = QLocale().name().toStdString();
  work->options.words = [](const Message& message) { return words(message).toStdString(); };
  if (isOfClass && selection_.lesson() != nullptr)
    for (const auto& [folder, tried] : selection_.lesson()->attempts) work->attempts.push_back(folder);
  else if (!isOfClass && selection_.attempt() != nullptr)
    work->attempts.push_back(selection_.attempt()->first);
  if (work->attempts.empty() || !document_.keepAll()) return;
  host_.jobs().startSaving(
      tr("Writing the report").toStdString(), [work, file](Progress& progress) { return work->run(file, progress); },
      [this, file, alive = std::weak_ptr(alive_)](const Result<void>& done) {
        if (alive.expired()) return;
        if (done)
          host_.window().info(tr("The report is in %1.").arg(words(file.string())).toStdString(), "review report");
        else if (done.error().code != ErrorCode::cancelled)
          host_.window().error(words(done.error()).toStdString(), "review report");
      });
}

}  // namespace ew::review
