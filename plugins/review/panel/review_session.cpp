#include "panel/review_session.h"

#include <QLocale>
#include <QSettings>
#include <algorithm>

#include "ew/library/learning.h"
#include "ew/sdk/case_parts.h"
#include "ew/sdk/person.h"
#include "ew/sdk/window.h"
#include "ew/sdk/words.h"
#include "panel/opening.h"
#include "panel/style.h"

namespace ew::review {
namespace {

namespace fs = std::filesystem;
using sdk::words;

const QString kReviewerSetting = QStringLiteral("review/reviewer");
const QString kNamesSetting = QStringLiteral("review/names");

/// Work that somebody no longer waits for ends like one that was stopped.
class NewestOnly final : public Progress {
 public:
  NewestOnly(Progress& whole, std::shared_ptr<const std::atomic<int>> wish, int number)
      : whole_(whole), wish_(std::move(wish)), number_(number) {}
  void report(const Message& what, double fraction) override { whole_.report(what, fraction); }
  [[nodiscard]] bool cancelRequested() const override { return whole_.cancelRequested() || *wish_ != number_; }

 private:
  Progress& whole_;
  std::shared_ptr<const std::atomic<int>> wish_;
  int number_;
};

constexpr int kPauseInSaying_ms = 5000;

}  // namespace

ReviewSession::ReviewSession(sdk::Host& host) : host_(host), shelf_(std::make_shared<const ScanShelf>()) {
  reviewer_ = QSettings().value(kReviewerSetting).toString();
  showsNames_ = QSettings().value(kNamesSetting, false).toBool();
  timer_.setInterval(33);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &ReviewSession::tick);
  pause_.setSingleShot(true);
  pause_.setInterval(kPauseInSaying_ms);
  connect(this, &ReviewSession::commentsChanged, &pause_, qOverload<>(&QTimer::start));
  connect(&pause_, &QTimer::timeout, this, &ReviewSession::saveComments);
}

ReviewSession::~ReviewSession() { ++*wish_; }

void ReviewSession::readShelf() {
  if (reading_) return;
  reading_ = true;
  Q_EMIT shelfChanged();
  auto made = std::make_shared<ScanShelf>();
  auto records = std::make_shared<ClassRecords>();
  host_.jobs().start(
      tr("Looking for attempts").toStdString(),
      [made, records, open = host_.cases().currentFolder()](Progress& progress) -> Result<void> {
        auto read = review::readShelf(libraryFolder(), open, progress);
        if (!read) return passOn(read.error());
        *made = std::move(*read);
        auto found = readClassRecords(*made, libraryFolder(), progress);
        if (!found) return passOn(found.error());
        *records = std::move(*found);
        return {};
      },
      [this, made, records, alive = std::weak_ptr(alive_)](const Result<void>& done) {
        if (alive.expired()) return;
        reading_ = false;
        if (done) {
          const std::string lessonId = lesson() ? lesson()->lesson.id : std::string(),
                            caseId = lesson() ? lesson()->home.id : std::string();
          const std::string attemptId = attempt() ? attempt()->second.id : std::string();
          shelf_ = made;
          records_ = std::move(*records);
          results_ = AttemptResults(libraryFolder());
          hasShelf_ = true;
          lesson_.reset();
          attempt_.reset();
          for (std::size_t n = 0; n < shelf_->lessons.size(); ++n)
            if (shelf_->lessons[n].lesson.id == lessonId && shelf_->lessons[n].home.id == caseId) lesson_ = n;
          if (lesson())
            for (std::size_t n = 0; n < lesson()->attempts.size(); ++n)
              if (lesson()->attempts[n].second.id == attemptId) attempt_ = n;
          if (!shelf_->problems.empty()) host_.window().warn(words(shelf_->problems.front()).toStdString(), "review shelf");
          if (records_.problem) host_.window().error(words(*records_.problem).toStdString(), "review standings");
          readPlan();
        } else if (done.error().code != ErrorCode::cancelled) {
          host_.window().error(words(done.error()).toStdString(), "review shelf");
        }
        Q_EMIT shelfChanged();
        if (!lesson_ && !shelf_->lessons.empty()) chooseLesson(0);
      });
}

const LessonAttempts* ReviewSession::lesson() const {
  return lesson_ && *lesson_ < shelf_->lessons.size() ? &shelf_->lessons[*lesson_] : nullptr;
}

const std::pair<fs::path, Attempt>* ReviewSession::attempt() const {
  const LessonAttempts* of = lesson();
  return of != nullptr && attempt_ && *attempt_ < of->attempts.size() ? &of->attempts[*attempt_] : nullptr;
}

const LessonStep* ReviewSession::step() const {
  if (lesson() == nullptr) return nullptr;
  for (const LessonStep& each : lesson()->lesson.steps)
    if (each.id == stepId_) return &each;
  return nullptr;
}

void ReviewSession::chooseLesson(std::size_t number) {
  if (number >= shelf_->lessons.size() || !keepAll()) return Q_EMIT choiceChanged();
  lesson_ = number;
  attempt_.reset();
  stepId_.clear();
  readPlan();
  Q_EMIT scoresChanged();
  if (lesson()->attempts.empty()) {
    openChosen();
    return;
  }
  chooseAttempt(0);
}

void ReviewSession::chooseAttempt(std::size_t number) {
  if (lesson() == nullptr || number >= lesson()->attempts.size() || !keepAll()) return Q_EMIT choiceChanged();
  attempt_ = number;
  const auto& [folder, tried] = *attempt();
  const auto isRecorded = [&, &folder = folder, &tried = tried](const LessonStep& each) {
    return scanOfStep(folder, tried, each).has_value();
  };
  const auto& steps = lesson()->lesson.steps;
  if (step() == nullptr || !isRecorded(*step())) {
    const auto first = std::find_if(steps.begin(), steps.end(), isRecorded);
    stepId_ = first != steps.end() ? first->id : steps.empty() ? std::string() : steps.front().id;
  }
  openChosen();
}

void ReviewSession::chooseStep(const std::string& stepId) {
  if (lesson() == nullptr || stepId == stepId_ || !keepAll()) return Q_EMIT choiceChanged();
  stepId_ = stepId;
  openChosen();
}

void ReviewSession::compareWith(std::optional<std::size_t> comparison) {
  if ((comparison && *comparison >= comparisons_.size()) || !keepAll()) return Q_EMIT choiceChanged();
  comparison_ = comparison;
  const ReviewScan* first = opened(kReviewed);
  start({first != nullptr ? std::optional(first->scan->choice) : std::nullopt,
         comparison_ ? std::optional(comparisons_[*comparison_]) : std::nullopt});
  Q_EMIT choiceChanged();
}

void ReviewSession::openFile(Side side, const fs::path& file) {
  if (!keepAll()) return Q_EMIT choiceChanged();
  ScanChoice choice;
  choice.title = file.filename().string();
  choice.file = file;
  std::array<std::optional<ScanChoice>, 2> choices;
  for (const Side each : kSides)
    if (opened(each) != nullptr) choices[each] = opened(each)->scan->choice;
  choices[side] = choice;
  if (side == kCompared) {
    comparisons_.push_back(choice);
    comparison_ = comparisons_.size() - 1;
  }
  start(std::move(choices));
  Q_EMIT choiceChanged();
}

/// What is chosen in the column: the attempt's step, beside what it is usually compared with.
void ReviewSession::openChosen() {
  comparisons_.clear();
  comparison_.reset();
  std::array<std::optional<ScanChoice>, 2> choices;
  if (const LessonAttempts* of = lesson(); of != nullptr) {
    comparisons_ = expertScansOf(of->home, of->lesson);
    if (!comparisons_.empty()) comparison_ = usualExpertFor(of->lesson, stepId_, comparisons_);
    for (std::size_t n = 0; step() != nullptr && n < of->attempts.size(); ++n) {
      const auto& [folder, tried] = of->attempts[n];
      auto scan = scanOfStep(folder, tried, *step());
      if (!scan) continue;
      if (attempt_ == n)
        choices[kReviewed] = std::move(scan);
      else
        comparisons_.push_back(std::move(*scan));
    }
    if (!comparison_ && !comparisons_.empty()) comparison_ = 0;
    if (comparison_) choices[kCompared] = comparisons_[*comparison_];
  }
  start(std::move(choices));
  Q_EMIT choiceChanged();
}

void ReviewSession::start(std::array<std::optional<ScanChoice>, 2> choices) {
  pause();
  const int number = ++*wish_;
  problem_.clear();
  auto made = std::make_shared<Opening>();
  made->choices = std::move(choices);
  made->shelf = shelf_;
  made->contents = contents_;
  made->mannequin = mannequin_;
  made->mannequinFile = mannequinFile_;
  if (step() != nullptr) made->step = *step();
  if (!made->choices[kReviewed] && !made->choices[kCompared]) {
    take(*made);
    return;
  }
  ++opening_;
  Q_EMIT scansChanged();
  host_.jobs().start(
      tr("Opening the scans").toStdString(),
      [made, wish = wish_, number](Progress& progress) {
        NewestOnly newest(progress, wish, number);
        return made->run(newest);
      },
      [this, made, number, alive = std::weak_ptr(alive_)](const Result<void>& done) {
        if (alive.expired()) return;
        --opening_;
        if (number != *wish_) return;  // a newer choice is on its way
        if (!done) {
          made->opened = {};
          problem_ = done.error().code == ErrorCode::cancelled ? tr("Opening was stopped; choose the step again.") : words(done.error());
        }
        if (made->problem) problem_ = words(*made->problem);
        take(*made);
      });
}

void ReviewSession::take(Opening& made) {
  // Something may have been written while the scans were opened: nothing is closed before it is kept.
  if (!keepAll()) {
    problem_ = tr("What was written about the scan before could not be kept, so that one stays open; see to the message and choose again.");
    return Q_EMIT scansChanged();
  }
  opened_ = made.opened;
  contents_ = std::move(made.contents);
  if (made.mannequin) {
    mannequin_ = made.mannequin;
    mannequinFile_ = made.mannequinFile;
  }
  alignment_.reset();
  offset_s_ = 0.0;
  scans_ =
      TwoScans(opened_[kReviewed] ? opened_[kReviewed]->scan->part : Part{}, opened_[kCompared] ? opened_[kCompared]->scan->part : Part{});
  clock_ = ReviewClock();
  chosenComment_.clear();
  // The comments stay open, with their steps of undo, while only what they are compared with changes.
  const bool isSame = comments_ && opened_[kReviewed] && comments_->attempt() == opened_[kReviewed]->scan->choice.attempt &&
                      comments_->author() == reviewer_.toStdString();
  if (!isSame && !openComments()) comments_.reset();
  setTracks();
  setRange();
  clock_.seek(0.0);
  Q_EMIT scansChanged();
  Q_EMIT commentsChanged();
  Q_EMIT clockChanged();
  Q_EMIT timeChanged();
  tellDocument();
}

Who ReviewSession::whoOf(Side side) const {
  // The one that is reviewed is always the trainee's, so that two attempts are told apart.
  return side == kReviewed ? Who::trainee : Who::expert;
}

QString ReviewSession::titleOfScan(Side side) const {
  const ReviewScan* scan = opened(side);
  if (scan == nullptr) return {};
  const ScanChoice& choice = scan->scan->choice;
  if (choice.attempt.empty()) return words(choice.title);
  if (lesson() != nullptr)
    for (const auto& [folder, tried] : lesson()->attempts)
      if (folder == choice.attempt) return tr("%1: %2", "person: step").arg(personOf(tried), words(choice.title));
  return words(choice.title);
}

void ReviewSession::setShowsNames(bool names) {
  if (names == showsNames_) return;
  showsNames_ = names;
  QSettings().setValue(kNamesSetting, names);
  Q_EMIT shelfChanged();
  Q_EMIT choiceChanged();
  Q_EMIT scansChanged();
}

const Pseudonyms* ReviewSession::codes() const {
  if (!codes_)
    if (auto read = Pseudonyms::ofLibrary(libraryFolder())) codes_ = *read;
  return codes_ ? &*codes_ : nullptr;
}

QString ReviewSession::reviewerCalled(const std::string& name) const {
  if (showsNames_) return name.empty() ? tr("somebody") : words(name);
  return codes() != nullptr ? words(codes()->ofReviewer(name)) : tr("without a code");
}

QString ReviewSession::personOf(const Attempt& tried) const {
  if (showsNames_) return tried.person.empty() ? tr("without a name") : words(tried.person);
  return codes() != nullptr ? words(codes_->ofPerson(tried.person)) : tr("without a code");
}

void ReviewSession::setReviewer(const QString& name) {
  const QString tidy = name.simplified().left(sdk::kLongestPersonName);
  // What nobody had signed yet stays begun, and is signed by whoever is named now.
  if (tidy == reviewer_ || !(reviewer_.isEmpty() ? saveComments() : keepAll())) return Q_EMIT reviewerChanged();
  reviewer_ = tidy;
  QSettings().setValue(kReviewerSetting, tidy);
  if (!openComments()) comments_.reset();
  setTracks();
  Q_EMIT reviewerChanged();
  Q_EMIT commentsChanged();
  tellDocument();
}

}  // namespace ew::review
