#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <array>
#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "ew/assessment/assessment_plan.h"
#include "ew/assessment/attempt_result.h"
#include "ew/assessment/attempt_score.h"
#include "ew/assessment/pseudonym.h"
#include "ew/bridge/mannequin.h"
#include "ew/scanning/subject.h"
#include "ew/sdk/host.h"
#include "ew/sdk/window.h"
#include "logic/alignment.h"
#include "logic/class_attempts.h"
#include "logic/comment_history.h"
#include "logic/region_coverage.h"
#include "logic/review_tracks.h"
#include "logic/scan_path.h"
#include "logic/scan_shelf.h"

namespace ew::review {

/// The two scans that are looked at: the one that is reviewed, and what it is compared with.
enum Side { kReviewed, kCompared };
inline constexpr std::array<Side, 2> kSides{kReviewed, kCompared};

/// One scan with all that is shown of it. Never changed after it was opened.
struct ReviewScan {
  std::shared_ptr<const ScanExcerpt> scan;
  ScanSubject subject;
  SkinPath path;
  std::vector<PlaneVisit> planes;
  std::shared_ptr<const VolumeRegions> regions;  ///< null: the voxels stay in their file
  RegionCoverage seen;                           ///< of the regions
  std::vector<MetricValue> metrics;              ///< of the step that is chosen, of the part that is reviewed
};

struct Opening;

/// What column and stage share: what can be reviewed, what is, and where it stands. On the window's thread; long work runs in the host's
/// jobs on copies.
class ReviewSession final : public QObject, public sdk::PanelDocument {
  Q_OBJECT

 public:
  explicit ReviewSession(sdk::Host& host);
  ~ReviewSession() override;

  // The document: the comments on the attempt that is reviewed, and what pages hold (holdWork).
  [[nodiscard]] std::string title() const override;
  [[nodiscard]] std::string remark() const override;
  [[nodiscard]] std::string note() const override { return {}; }
  [[nodiscard]] std::string undoText() const override { return comments_ ? comments_->undoName() : std::string(); }
  [[nodiscard]] std::string redoText() const override { return comments_ ? comments_->redoName() : std::string(); }
  void undo() override;
  void redo() override;
  void save(bool elsewhere) override;
  [[nodiscard]] std::string unsaved() const override;
  [[nodiscard]] std::shared_ptr<void> onChanged(std::function<void()> callback) override;

  [[nodiscard]] sdk::Host& host() { return host_; }

  /// Work that a page holds beside the comments: typed, and not kept yet.
  struct HeldWork {
    std::function<bool()> keep;            ///< asked before anything else is reviewed @return false: it could not be kept
    std::function<std::string()> unsaved;  ///< as PanelDocument::unsaved
  };
  /// Asked for as long as the ticket lives.
  [[nodiscard]] std::shared_ptr<void> holdWork(HeldWork work);

  // What can be reviewed.
  void readShelf();  ///< in a job; shelfChanged() when it is there
  [[nodiscard]] bool isReading() const { return reading_; }
  [[nodiscard]] const ScanShelf& shelf() const { return *shelf_; }
  /// Whether the shelf was read at all.
  [[nodiscard]] bool hasShelf() const { return hasShelf_; }
  [[nodiscard]] const LessonAttempts* lesson() const;
  [[nodiscard]] std::optional<std::size_t> lessonNumber() const { return lesson_; }
  [[nodiscard]] std::optional<std::size_t> attemptNumber() const { return attempt_; }
  [[nodiscard]] const std::pair<std::filesystem::path, Attempt>* attempt() const;  ///< null: none is chosen
  [[nodiscard]] const LessonStep* step() const;
  /// The score that counts; null: it was not scored.
  [[nodiscard]] const AttemptScore* scoreOf(std::size_t attempt) const;
  /// What an attempt of the lesson amounts to, as reports and records say it. @param attempt below their number
  [[nodiscard]] AttemptResult resultOf(std::size_t attempt) const;
  /// The attempts of the lesson for the statistics of their class, in the shelf's order.
  [[nodiscard]] std::vector<ClassAttempt> classAttempts() const;
  /// Whether the reviewer may be told what raters say of an attempt. @param attempt folder
  [[nodiscard]] bool mayReadRaters(const std::filesystem::path& attempt) const;
  /// Keeps what is said of whoever made an attempt. @param standing unknown: raters decide
  /// @return false: it could not be kept, and the window was told why
  [[nodiscard]] bool keepStanding(const std::string& attemptId, Standing standing);
  void takeRating(const std::filesystem::path& attempt);  ///< a rating of it was finished
  void chooseLesson(std::size_t lesson);
  void chooseAttempt(std::size_t attempt);  ///< and the first of its steps that was recorded
  void chooseStep(const std::string& stepId);
  /// What the chosen step may be compared with: the expert's scans, then the other attempts that recorded it.
  [[nodiscard]] const std::vector<ScanChoice>& comparisons() const { return comparisons_; }
  [[nodiscard]] std::optional<std::size_t> comparison() const { return comparison_; }
  void compareWith(std::optional<std::size_t> comparison);
  /// The figures of a scan: as they were scored, where that was done for the plan that counts; else as they were worked out when it was
  /// opened.
  [[nodiscard]] std::vector<MetricValue> metricsOf(Side side) const;
  /// Any recording. It stays until another attempt or step is chosen.
  void openFile(Side side, const std::filesystem::path& file);
  /// Whether people are called by their names; else by codes.
  [[nodiscard]] bool showsNames() const { return showsNames_; }
  void setShowsNames(bool names);
  [[nodiscard]] QString personOf(const Attempt& attempt) const;
  /// Of who rates and comments, in the same way.
  [[nodiscard]] QString reviewerCalled(const std::string& name) const;
  [[nodiscard]] QString reviewer() const { return reviewer_; }
  void setReviewer(const QString& name);

  // What is reviewed.
  [[nodiscard]] const ReviewScan* opened(Side side) const { return opened_[side].get(); }
  [[nodiscard]] std::shared_ptr<const ReviewScan> sharedScan(Side side) const { return opened_[side]; }
  [[nodiscard]] bool isOpening() const { return opening_ > 0; }
  [[nodiscard]] const QString& problem() const { return problem_; }
  [[nodiscard]] const std::vector<Track>& tracks(Side side) const { return tracks_[side]; }
  [[nodiscard]] const std::shared_ptr<const bridge::Mannequin>& mannequin() const { return mannequin_; }
  [[nodiscard]] Who whoOf(Side side) const;
  [[nodiscard]] QString titleOfScan(Side side) const;

  // The clock.
  [[nodiscard]] const ReviewClock& clock() const { return clock_; }
  [[nodiscard]] const TwoScans& scans() const { return scans_; }
  [[nodiscard]] double time_s(Side side) const;                    ///< on the recording's own clock
  [[nodiscard]] double onClock_s(Side side, double time_s) const;  ///< of a recording's moment, on the review's
  [[nodiscard]] std::size_t frame(Side side) const;                ///< expects an opened scan
  void play();
  void pause();
  void setSpeed(double speed);
  void setAtEnd(AtEnd end);
  void seek(double clock_s);
  void stepFrame(int frames);  ///< of the reviewed scan
  void jump(bool forward);
  void markLoop(bool begin);
  void clearLoop();
  void setOffset(double offset_s);
  void setAligned(bool aligned);  ///< worked out in a job the first time
  [[nodiscard]] bool isAligning() const { return aligning_; }

  // Comments of this reviewer on this attempt, and everybody's.
  [[nodiscard]] const CommentHistory* comments() const { return comments_ ? &*comments_ : nullptr; }
  [[nodiscard]] const std::vector<CommentFile>& othersComments() const { return others_; }
  /// This reviewer's comments on the scan that is open.
  [[nodiscard]] std::vector<ReviewComment> commentsHere() const;
  /// At the present moment. @return its id; empty: nothing can be commented, or the reviewer has no name
  std::string addComment(const QString& text, std::vector<CommentStroke> strokes);
  void editComment(const ReviewComment& comment, const QString& what, const std::string& mergeKey = {});
  void removeComment(const std::string& id);
  void showComment(const ReviewComment& comment);  ///< goes there
  [[nodiscard]] const std::string& chosenComment() const { return chosenComment_; }
  void chooseComment(const std::string& id);

  /// The overview of the class is in front, in place of the scans.
  [[nodiscard]] bool showsClass() const { return showsClass_; }
  void setShowsClass(bool shown);

  // What counts.
  [[nodiscard]] const AssessmentPlan& plan() const { return plan_; }
  void keepPlan(AssessmentPlan plan);  ///< and scores all attempts of the lesson anew
  void scoreAll();                     ///< in a job, those whose score is out of date
  [[nodiscard]] bool isScoring() const { return scoring_; }
  /// Writes a report in a job: on the attempt that is chosen, or on all attempts of the lesson. Names are in it when they are shown.
  /// Asks where a report is to be written, and writes it.
  void askForReport(const sdk::SaveFile& asked, bool isOfClass);
  /// @param file ending in .pdf or .html
  void writeReport(const std::filesystem::path& file, bool isOfClass);
  Q_INVOKABLE void writeReportFile(const QString& file, bool isOfClass) { writeReport(file.toStdString(), isOfClass); }

 Q_SIGNALS:
  void shelfChanged();
  void choiceChanged();
  void scansChanged();
  void timeChanged();
  void clockChanged();  ///< speed, loop, mode, playing
  void commentsChanged();
  void scoresChanged();
  void reviewerChanged();
  void reviewerWanted();  ///< something is to be kept by its writer, who has not said who they are
  void pageChanged();

 private:
  void openChosen();
  void start(std::array<std::optional<ScanChoice>, 2> choices);
  void take(Opening& made);
  void setTracks();
  void setRange();
  void align();
  [[nodiscard]] bool openComments();
  [[nodiscard]] bool saveComments();
  [[nodiscard]] bool keepAll();
  void tellDocument();
  void readPlan();
  [[nodiscard]] const Pseudonyms* codes() const;  ///< null: they cannot be read
  void tick();

  sdk::Host& host_;
  std::shared_ptr<const ScanShelf> shelf_;
  bool hasShelf_ = false, reading_ = false, showsNames_ = false, aligning_ = false, scoring_ = false, showsClass_ = false;
  int opening_ = 0;
  std::optional<std::size_t> lesson_, attempt_, comparison_;
  std::string stepId_;
  std::vector<ScanChoice> comparisons_;
  QString reviewer_, problem_;
  std::array<std::shared_ptr<const ReviewScan>, 2> opened_;
  std::array<std::vector<Track>, 2> tracks_;
  std::map<std::filesystem::path, std::pair<Case, CaseContents>> contents_;  ///< of the cases of the scans that are open
  std::shared_ptr<const bridge::Mannequin> mannequin_;
  std::filesystem::path mannequinFile_;
  std::shared_ptr<std::atomic<int>> wish_ = std::make_shared<std::atomic<int>>(0);  ///< number of the newest opening
  ReviewClock clock_;
  TwoScans scans_;
  std::shared_ptr<const Alignment> alignment_;  ///< of the two scans that are open; null: not worked out
  double offset_s_ = 0.0;
  QTimer timer_;
  QTimer pause_;  ///< in what is said: then it is saved, so that a crash takes no more than this
  QElapsedTimer passed_;
  std::optional<CommentHistory> comments_;
  std::vector<CommentFile> others_;
  std::string chosenComment_;
  AssessmentPlan plan_;
  ClassRecords records_;                             ///< of the shelf's attempts
  mutable AttemptResults results_{libraryFolder()};  ///< for lessons that have changed since they were tried
  mutable std::optional<Pseudonyms> codes_;          ///< of the library, read when they are first asked for
  std::vector<std::weak_ptr<std::function<void()>>> listeners_;
  std::vector<std::weak_ptr<HeldWork>> held_;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace ew::review
