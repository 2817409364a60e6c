#include "start/library_browser.h"

#include <QLocale>

#include "case/case_folder_dialog.h"
#include "ew/library/case.h"
#include "ew/library/published.h"
#include "ew/widgets/words.h"

namespace ew::ui {
namespace {

constexpr int kPoll_ms = 500;
constexpr std::size_t kMostProblemsAtOnce = 5;

}  // namespace

LibraryBrowser::LibraryBrowser(Jobs& jobs, QObject* parent) : QObject(parent), jobs_(jobs) {
  poll_.setInterval(kPoll_ms);
  connect(&poll_, &QTimer::timeout, this, &LibraryBrowser::changed);
}

std::vector<LibraryRoot> LibraryBrowser::roots() {
  std::vector<LibraryRoot> roots;
  if (const auto shipped = shippedCasesFolder()) roots.push_back({*shipped, LibraryKind::shipped});
  roots.push_back({CaseFolderDialog::library(), LibraryKind::own});
  roots.push_back({publishedFolder(libraryFolder()), LibraryKind::published});
  return roots;
}

void LibraryBrowser::open() {
  std::vector<LibraryRoot> roots = LibraryBrowser::roots();
  std::string language = QLocale().name().toStdString();
  if (index_ && roots == roots_ && language == language_) return;
  auto made = openIndex(indexFile(roots, language), language);
  if (!made) return Q_EMIT failed(made.error());
  const std::shared_ptr<LibraryIndex> before = std::exchange(index_, std::shared_ptr<LibraryIndex>(std::move(*made)));
  roots_ = std::move(roots);
  language_ = std::move(language);
  told_.clear();
  Q_EMIT opened();
}

void LibraryBrowser::refresh() {
  open();
  if (!index_) return;
  if (job_ != 0) {
    again_ = true;
    return;
  }
  start();
}

void LibraryBrowser::start() {
  auto report = std::make_shared<RefreshReport>();
  poll_.start();
  job_ = jobs_.start(
      tr("Reading the library"),
      [index = index_, roots = roots_, report](Progress& progress) -> Result<void> {
        auto refreshed = index->refresh(roots, progress);
        if (!refreshed) return passOn(refreshed.error());
        *report = std::move(*refreshed);
        return {};
      },
      [this, report](const Result<void>& outcome) {
        job_ = 0;
        poll_.stop();
        if (!outcome && outcome.error().code != ErrorCode::cancelled) Q_EMIT failed(outcome.error());
        if (outcome) tellNews(*report);
        for (const Message& note : index_->takeNotes()) Q_EMIT noted(words(note));
        Q_EMIT changed();
        Q_EMIT refreshed();
        if (std::exchange(again_, false) && outcome) refresh();
      },
      Jobs::Kind::background);
}

/// Each broken case once, and not a hundred at a time.
void LibraryBrowser::tellNews(const RefreshReport& report) {
  std::vector<const CaseProblem*> news;
  for (const CaseProblem& problem : report.problems)
    if (told_.insert(problem.folder.string()).second) news.push_back(&problem);
  for (std::size_t n = 0; n < news.size() && n < kMostProblemsAtOnce; ++n)
    Q_EMIT failed({ErrorCode::badField, news[n]->message, {{"folder", news[n]->folder.string()}}});
  if (news.size() > kMostProblemsAtOnce)
    Q_EMIT noted(tr("Further cases of the library that cannot be read: %1.").arg(news.size() - kMostProblemsAtOnce));
}

std::filesystem::path LibraryBrowser::folderOf(const std::string& caseId) const {
  if (!index_ || caseId.empty()) return {};
  const auto folders = index_->foldersOf(caseId);
  return folders && !folders->empty() ? folders->front() : std::filesystem::path();
}

}  // namespace ew::ui
