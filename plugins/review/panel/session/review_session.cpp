#include "panel/session/review_session.h"

#include <QLocale>
#include <utility>

#include "ew/core/progress.h"
#include "ew/library/folders.h"
#include "ew/sdk/person.h"
#include "ew/sdk/window.h"
#include "ew/widgets/words.h"
#include "logic/class_attempts.h"
#include "panel/session/opening.h"

namespace ew::review {
namespace {

namespace fs = std::filesystem;

}  // namespace

ReviewSession::ReviewSession(sdk::Host& host)
    : host_(host),
      scans_(host),
      playback_(host, scans_),
      comments_(host, scans_, playback_, reviewer_),
      scores_(host, selection_, reviewer_),
      document_(selection_, comments_),
      reports_(host, selection_, reviewer_, document_) {
  connect(&reviewer_, &Reviewer::namesChanged, this, [this] {
    Q_EMIT selection_.shelfChanged();
    Q_EMIT selection_.changed();
    Q_EMIT scans_.changed();
  });
}

void ReviewSession::readShelf() {
  if (selection_.isReading()) return;
  selection_.setReading(true);
  Q_EMIT selection_.shelfChanged();
  auto made = std::make_shared<ScanShelf>();
  auto records = std::make_shared<ClassRecords>();
  auto results = std::make_shared<AttemptResults>(libraryFolder());
  host_.jobs().start(
      tr("Looking for attempts").toStdString(),
      [made, records, results, open = host_.cases().currentFolder(),
       language = QLocale().name().toStdString()](Progress& progress) -> Result<void> {
        auto read = review::readShelf(libraryFolder(), open, progress, language);
        if (!read) return passOn(read.error());
        *made = std::move(*read);
        auto found = readClassRecords(*made, libraryFolder(), progress);
        if (!found) return passOn(found.error());
        *records = std::move(*found);
        readTriedLessons(*made, *results);
        return {};
      },
      [this, made, records, results, alive = std::weak_ptr(alive_)](const Result<void>& done) {
        if (alive.expired()) return;
        selection_.setReading(false);
        if (done) {
          selection_.takeShelf(made);
          if (!made->problems.empty()) host_.window().warn(words(made->problems.front()).toStdString(), "review shelf");
          scores_.takeRecords(std::move(*records), std::move(*results));
          scores_.readPlan();
        } else if (done.error().code != ErrorCode::cancelled) {
          host_.window().error(words(done.error()).toStdString(), "review shelf");
        }
        Q_EMIT selection_.shelfChanged();
        if (!selection_.lessonNumber() && !selection_.shelf().lessons.empty()) chooseLesson(0);
      });
}

void ReviewSession::chooseLesson(std::size_t number) {
  if (number >= selection_.shelf().lessons.size() || !document_.keepAll()) return Q_EMIT selection_.changed();
  selection_.setLesson(number);
  scores_.readPlan();
  Q_EMIT scores_.changed();
  if (selection_.lesson()->attempts.empty()) {
    openChosen();
    return;
  }
  chooseAttempt(0);
}

void ReviewSession::chooseAttempt(std::size_t number) {
  const LessonAttempts* of = selection_.lesson();
  if (of == nullptr || number >= of->attempts.size() || !document_.keepAll()) return Q_EMIT selection_.changed();
  selection_.setAttempt(number);
  openChosen();
}

void ReviewSession::chooseStep(const std::string& stepId) {
  if (selection_.lesson() == nullptr || stepId == selection_.stepId() || !document_.keepAll()) return Q_EMIT selection_.changed();
  selection_.setStep(stepId);
  openChosen();
}

void ReviewSession::compareWith(std::optional<std::size_t> comparison) {
  if ((comparison && *comparison >= selection_.comparisons().size()) || !document_.keepAll()) return Q_EMIT selection_.changed();
  selection_.setComparison(comparison);
  const ReviewScan* first = scans_.opened(kReviewed);
  start({first != nullptr ? std::optional(first->scan->choice) : std::nullopt,
         comparison ? std::optional(selection_.comparisons()[*comparison]) : std::nullopt});
  Q_EMIT selection_.changed();
}

void ReviewSession::openFile(Side side, const fs::path& file) {
  if (!document_.keepAll()) return Q_EMIT selection_.changed();
  ScanChoice choice;
  choice.title = file.filename().string();
  choice.file = file;
  std::array<std::optional<ScanChoice>, 2> choices;
  for (const Side each : kSides)
    if (scans_.opened(each) != nullptr) choices[each] = scans_.opened(each)->scan->choice;
  choices[side] = choice;
  if (side == kCompared) selection_.addComparison(choice);
  start(std::move(choices));
  Q_EMIT selection_.changed();
}

/// What is chosen in the column: the attempt's step, beside what it is usually compared with.
void ReviewSession::openChosen() {
  start(selection_.listScans());
  Q_EMIT selection_.changed();
}

void ReviewSession::start(std::array<std::optional<ScanChoice>, 2> choices) {
  playback_.pause();
  scans_.open(std::move(choices), selection_.sharedShelf(), selection_.step(), [this](Opening& made) { take(made); });
}

void ReviewSession::take(Opening& made) {
  // Something may have been written while the scans were opened: nothing is closed before it is kept.
  if (!document_.keepAll())
    return scans_.keepWith(
        tr("What was written about the scan before could not be kept, so that one stays open; see to the message and choose again."));
  scans_.take(made);
  playback_.takeScans();
  comments_.takeScans();
  Q_EMIT scans_.changed();
  Q_EMIT comments_.changed();
  Q_EMIT playback_.clockChanged();
  Q_EMIT playback_.timeChanged();
  document_.tell();
}

void ReviewSession::setReviewer(const QString& name) {
  const QString tidy = name.simplified().left(sdk::kLongestPersonName);
  // What nobody had signed yet stays begun, and is signed by whoever is named now.
  if (tidy == reviewer_.name() || !(reviewer_.name().isEmpty() ? comments_.save() : document_.keepAll())) return Q_EMIT reviewer_.changed();
  reviewer_.setName(tidy);
  comments_.takeReviewer();
  Q_EMIT reviewer_.changed();
  Q_EMIT comments_.changed();
  document_.tell();
}

void ReviewSession::setShowsClass(bool shown) {
  if (shown == showsClass_) return;
  playback_.pause();
  showsClass_ = shown;
  Q_EMIT pageChanged();
}

}  // namespace ew::review
