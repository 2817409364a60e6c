#pragma once

#include <QObject>
#include <QTimer>
#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <vector>

#include "ew/sdk/host.h"
#include "ew/stitching/chain.h"
#include "ew/stitching/expected_cost.h"
#include "ew/stitching/result_files.h"
#include "logic/recovery.h"
#include "logic/slices.h"
#include "logic/stitch_document.h"

namespace ew::stitching {

struct ChainMade;
struct FilesRead;

struct CaseWithVolume;

/// What panel and stage share: the project with its history, what was found, what is looked at. All on the window's thread; long work runs
/// in the host's jobs on copies.
class StitchSession final : public QObject, public sdk::PanelDocument {
  Q_OBJECT

 public:
  /// @param folder for results and the recovery file; empty: the application's own data folder
  explicit StitchSession(sdk::Host& host, std::filesystem::path folder = {});
  ~StitchSession() override;

  // The document, as the window sees it.
  [[nodiscard]] std::string title() const override;
  [[nodiscard]] std::string remark() const override;
  [[nodiscard]] std::string note() const override;
  [[nodiscard]] std::string undoText() const override { return document_.undoName(); }
  [[nodiscard]] std::string redoText() const override { return document_.redoName(); }
  void undo() override;
  void redo() override;
  void save(bool elsewhere) override;  ///< asks by a dialog where it must
  [[nodiscard]] std::shared_ptr<void> onChanged(std::function<void()> callback) override;

  [[nodiscard]] sdk::Host& host() { return host_; }
  [[nodiscard]] const StitchDocument& document() const { return document_; }
  [[nodiscard]] const StitchProject& project() const { return document_.project(); }
  void edit(StitchProject next, const QString& what, const std::string& mergeKey = {});
  void endMerging() { document_.endMerging(); }

  /// Volumes, sweeps, or one project (which takes the place of an empty one, else its volumes are added).
  void addFiles(const std::vector<std::filesystem::path>& files);
  bool openProject(const std::filesystem::path& file);
  bool saveAs(const std::filesystem::path& file);
  void startAnew();
  /// What an earlier run left unsaved: the latest that nobody decided about.
  [[nodiscard]] const StitchDocument::Left* left() const { return left_.empty() ? nullptr : &left_.front().work; }
  [[nodiscard]] int leftCount() const { return static_cast<int>(left_.size()); }
  void reopenLeft();
  void discardLeft();

  // What was found.
  [[nodiscard]] std::shared_ptr<const Volume> volume(std::size_t index) const;  ///< null: not read yet, or it cannot be read
  [[nodiscard]] bool isUnreadable(std::size_t index) const;
  /// So little of a sweep is kept that a person has to say it is meant, or one has said so.
  [[nodiscard]] bool asksAboutLittle(std::size_t index) const;
  void setAcceptsSmall(std::size_t index, bool accepts);
  [[nodiscard]] QString whyUnreadable(std::size_t index) const;
  [[nodiscard]] bool isSweep(std::size_t index) const;  ///< as far as it was looked at
  /// How a sweep becomes a volume; it is read again.
  void setCalibration(std::size_t volume, const std::filesystem::path& deviceSet);
  void setSweepSpacing(std::size_t volume, double spacing_mm);
  [[nodiscard]] bool isRunning() const { return running_; }
  [[nodiscard]] const ChainState* found() const { return found_ ? found_.get() : nullptr; }
  [[nodiscard]] bool isFoundFresh() const;  ///< nothing was edited since
  [[nodiscard]] std::filesystem::path workFolder() const;

  /// What holds a pair together. A pose that a person gave proves nothing about the images, and never has the sign of one that they proved.
  enum class Mark { unknown, aligned, landmarks, byHand, cannotTell, notAligned, rejected };
  struct PairLine {
    std::size_t fixed = 0;
    std::size_t moving = 0;
    Mark mark = Mark::unknown;
    bool stale = false;                    ///< edited since it was found
    bool wrong = false;                    ///< the graph does not believe it
    bool warpDoubted = false;              ///< the rigid pose holds, and the deformation of the last run was not found to be right
    bool needsLook = false;                ///< not aligned, or deformed in doubt, and nobody has decided
    const PairOutcome* outcome = nullptr;  ///< of the last run; null: none
  };
  /// Every pair that a run has looked at or a person has spoken of; before the first run all of them.
  [[nodiscard]] std::vector<PairLine> pairs() const;
  [[nodiscard]] PairLine pairLine(std::size_t fixed, std::size_t moving) const;
  [[nodiscard]] Mark markOf(std::size_t volume) const;  ///< the best of its pairs: what holds it
  [[nodiscard]] int pairsToLookAt() const;
  /// In a few words: how many pairs need a look, else how many were not matched, else that none does. Empty before the first run.
  [[nodiscard]] QString pairSummary() const;
  /// Every volume was in the last run, and nothing that shapes the places was edited since.
  [[nodiscard]] bool isMatchFresh() const;
  /// As found, else as placed. A volume placed anew since lies where it was put beside those that were not.
  [[nodiscard]] Transform<frame::World, frame::View> toWorld(std::size_t volume) const;
  /// Puts a volume where `shown` says, in the frame of toWorld.
  void setPlace(std::size_t volume, const Transform<frame::World, frame::View>& shown, const QString& what, const std::string& mergeKey);
  void setPlacement(std::size_t volume, Placement placement);

  // What is looked at.
  struct Shown {
    std::size_t fixed = 0;
    std::size_t moving = 1;
    bool operator==(const Shown&) const = default;
  };
  [[nodiscard]] const std::optional<Shown>& pair() const { return pair_; }
  void choosePair(std::size_t a, std::size_t b);
  [[nodiscard]] std::optional<std::size_t> chosenVolume() const { return chosenVolume_; }
  void chooseVolume(std::size_t volume);
  [[nodiscard]] int chosenLandmark() const { return chosenLandmark_; }
  void chooseLandmark(int landmark);

  /// Which transform the pair is seen with.
  enum class Stage { start, rigid, elastic };
  [[nodiscard]] Stage stage() const { return stage_; }
  void setStage(Stage stage);
  [[nodiscard]] bool hasElastic() const;
  [[nodiscard]] const WarpedPair* warpedOf(std::size_t a, std::size_t b) const;  ///< of the last run; null: it was not warped
  [[nodiscard]] const WarpedPair* warped() const;                                ///< of the pair; null: it was not warped
  [[nodiscard]] bool isWarpedStale() const;                                      ///< it was warped with another effort, or lay elsewhere
  [[nodiscard]] MachinePace warpPace() const;                                    ///< from the pairs that were warped
  [[nodiscard]] MachinePace searchPace() const;
  /// Fixed to moving as it is at present: nudged, found, by landmarks, or from the places.
  [[nodiscard]] Transform<frame::Moving, frame::Fixed> transform() const;
  [[nodiscard]] Transform<frame::Moving, frame::Fixed> startTransform() const;
  /// From the fixed frame to each side's own grid, for a stage.
  [[nodiscard]] Mapping fixedMapping(Stage stage) const;
  [[nodiscard]] Mapping movingMapping(Stage stage) const;

  // The two places that cross-hairs mark: linked, or each for itself.
  [[nodiscard]] const Plane& plane() const { return plane_; }       ///< fixed frame
  [[nodiscard]] const glm::dvec3& cross() const { return cross_; }  ///< fixed frame
  [[nodiscard]] Plane movingPlane() const;                          ///< the moving volume's own frame
  [[nodiscard]] glm::dvec3 movingCross() const;                     ///< the moving volume's own frame
  void setPlane(const Plane& plane);
  void setCross(const glm::dvec3& p_mm);        ///< the plane follows when the place lies off it
  void setMovingPlane(const Plane& plane);      ///< linked: moves the fixed one
  void setMovingCross(const glm::dvec3& p_mm);  ///< linked: moves the fixed one
  [[nodiscard]] bool isLinked() const { return linked_; }
  void setLinked(bool linked);
  void setCut(Cut cut);
  void setViewSide(int px);  ///< the shorter side of a view: what was seen stays seen when views grow
  void fit();                ///< the whole of both volumes in view, cross-hairs in the middle of what both cover

  // Landmarks of the pair.
  [[nodiscard]] std::vector<registration::LandmarkPair> landmarks() const;
  [[nodiscard]] const std::optional<registration::LandmarkResult>& landmarkResult() const { return landmarkResult_; }
  [[nodiscard]] std::optional<glm::dvec3> pickedFixed() const { return pickedFixed_; }
  [[nodiscard]] std::optional<glm::dvec3> pickedMoving() const { return pickedMoving_; }
  void pick(bool moving, const glm::dvec3& p_mm);  ///< the second of two makes a landmark
  void dropPick();
  void removeLandmark(int landmark);
  void renameLandmark(int landmark, const QString& name);
  void useLandmarks();  ///< the pair's method becomes landmarks, and the pair is matched again

  // Decisions and nudges.
  void setDecision(Decision decision);
  void nudge(const glm::dvec3& shift_mm, const glm::dvec3& rotation_deg);  ///< along and about the plane's right, down, normal
  void setTransform(const Transform<frame::Moving, frame::Fixed>& fixedToMoving, const QString& what, const std::string& mergeKey);
  [[nodiscard]] QuickAgreement agreement() const;  ///< at the present transform

  // Work.
  /// Matches every pair by its images; what a person said about how a pair lies stays for pairs that were accepted or have landmarks, and
  /// is told. @param withoutPlaces whatever is recorded; else from the places as they are
  void matchAll(bool withoutPlaces);
  void run(Step until, const QString& title);
  void takeUp();    ///< reads back what earlier runs of this project finished
  void pinStart();  ///< what is seen now becomes the start of the next refinement; a step with it
  void redoPair(PairMethod method, std::optional<double> maxRotation_deg);
  struct LevelSeen {
    std::size_t fixed = 0;
    std::size_t moving = 0;
    registration::Level level;
  };
  [[nodiscard]] std::vector<registration::Level> levels() const;      ///< of matching the pair: growing while it runs, else of its result
  [[nodiscard]] std::vector<registration::Level> warpLevels() const;  ///< the same of bending it
  void setEffort(registration::ElasticEffort effort);                 ///< of bending all pairs that have none of their own
  void setPairEffort(std::optional<registration::ElasticEffort> effort);
  void warpAgain();                                                               ///< runs the elastic step: what did not change is kept
  [[nodiscard]] std::shared_ptr<const Volume> result() const { return result_; }  ///< the whole; null: not made
  [[nodiscard]] bool isResultFresh() const { return result_ && resultAsked_ == project(); }
  void handToCase();
  void saveResult(const std::filesystem::path& folder);  ///< volume, coverage, source and provenance
  void showResult();
  [[nodiscard]] bool isCaseOpen() const;  ///< that could take the result over

 Q_SIGNALS:
  void changed();      ///< the project, what was found, or what is chosen
  void lookChanged();  ///< plane, cross-hairs, stage
  void levelsChanged();
  void problem(const QString& sentence);  ///< empty: none any more
  void said(const QString& sentence);     ///< what was done, where it matters
  void nextPairAsked(int step);
  void resultMade();  ///< a run that was asked for has made a whole

 private:
  struct Inbox;
  enum class OnDisk { reload, overwrite, saveElsewhere, cancel };
  [[nodiscard]] OnDisk askAboutFileOnDisk();
  [[nodiscard]] std::filesystem::path askForSaveName(const std::filesystem::path& before);  ///< empty: nobody wants to
  void afterEdit();
  void afterChoice();
  void writeIntoCase(const std::filesystem::path& caseFolder, const std::string& name);
  /// The open case with the stitched volume under a name. Expects an open case and a result.
  [[nodiscard]] CaseWithVolume caseWith(const std::string& name);
  [[nodiscard]] QString titleOfCase() const;
  void useInCase(const std::filesystem::path& caseFolder, const std::string& name);
  [[nodiscard]] static bool mayReplace(const std::filesystem::path& folder, const QStringList& names);  ///< asks
  [[nodiscard]] bool mayDropTargets(const CaseWithVolume& next);                                        ///< asks
  void readVolumes();
  void keep();
  void tell();
  void say(const Error& error);
  [[nodiscard]] std::vector<ProjectVolume> linesOf(const std::vector<std::filesystem::path>& files);  ///< says which are listed already
  void takeRead(FilesRead& read, const Result<void>& outcome);
  /// @param until empty: as far as it was finished before
  void begin(std::optional<Step> until, const QString& title);
  /// @param wasAsked somebody waits for the answer @param number of the project that was worked on
  void finish(const Result<void>& outcome, ChainMade& made, const StitchProject& asked, bool wasAsked, int number);
  void forgetFound();
  void settle(ChainState state, StitchProject asked);
  [[nodiscard]] std::optional<std::size_t> foundIndex(std::size_t volume) const;
  [[nodiscard]] bool samePlaces(std::size_t volume) const;
  [[nodiscard]] const Transform<frame::World, frame::View>* foundPlace(std::size_t volume) const;  ///< null: none, or placed anew since
  [[nodiscard]] Transform<frame::Placed, frame::View> placeGiven(std::size_t volume) const;        ///< by the project
  [[nodiscard]] Transform<frame::World, frame::Placed> placedToShown(std::size_t volume) const;
  void editPair(const std::function<void(ProjectPair&)>& change, const QString& what, const std::string& mergeKey = {});
  [[nodiscard]] QString nameOfPair() const;
  [[nodiscard]] std::vector<std::optional<Grid>> gridsFound() const;                        ///< of the volumes as found_ numbers them
  [[nodiscard]] const PairOutcome* outcomeOf(std::size_t fixed, std::size_t moving) const;  ///< of volumes as found_ numbers them
  [[nodiscard]] std::vector<registration::Level> levelsSeen(bool ofWarp) const;             ///< of the pair, since the last run began
  [[nodiscard]] bool isBusy();                                                              ///< says so

  sdk::Host& host_;
  struct LeftWork {
    int place = 0;  ///< of recovery_
    StitchDocument::Left work;
  };
  [[nodiscard]] std::filesystem::path untitledFolder(int place) const;
  [[nodiscard]] std::filesystem::path readingFolder() const;

  std::filesystem::path folder_;
  RecoveryPlace recovery_;
  StitchDocument document_;
  std::vector<LeftWork> left_;  ///< offered; whoever works on without deciding finds it offered at the next start
  std::shared_ptr<std::timed_mutex> readingTurn_ = std::make_shared<std::timed_mutex>();
  std::vector<std::weak_ptr<std::function<void()>>> callbacks_;
  QTimer keepSoon_;
  QTimer poll_;
  std::shared_ptr<Inbox> inbox_;

  std::map<std::string, std::shared_ptr<const Volume>> volumes_;  ///< by keyOf
  std::map<std::string, Message> unreadable_;                     ///< by keyOf: why
  std::set<std::string> little_;                                  ///< keyOf those of which too little is kept
  std::set<std::filesystem::path> sweeps_;                        ///< files that were seen to be some
  bool reading_ = false;
  bool running_ = false;
  std::shared_ptr<const ChainState> found_;
  std::shared_ptr<const Volume> result_;
  ResultPaths resultFiles_;                                           ///< of the stitched volume
  StitchProject resultAsked_;                                         ///< of which result_ was made
  int projectNumber_ = 0;                                             ///< counts the projects that were opened or begun
  mutable std::map<const PairOutcome*, PairOutcome> turnedOutcomes_;  ///< of found_, seen from the moving volume
  StitchProject asked_;                                               ///< of which found_ tells
  std::vector<std::string> foundKeys_;

  std::optional<Shown> pair_;
  std::optional<std::size_t> chosenVolume_;
  int chosenLandmark_ = -1;
  Stage stage_ = Stage::rigid;
  Plane plane_;
  glm::dvec3 cross_{0.0};
  Plane movingPlane_;
  glm::dvec3 movingCross_{0.0};
  bool linked_ = true;
  int viewSide_px_ = 330;
  std::optional<registration::LandmarkResult> landmarkResult_;
  std::optional<glm::dvec3> pickedFixed_, pickedMoving_;
  std::vector<LevelSeen> runningLevels_;
  std::vector<std::string> runningKeys_;  ///< of the volumes that runningLevels_ numbers
  struct AgreementOf {
    std::shared_ptr<const Volume> fixed, moving;
    Transform<frame::Moving, frame::Fixed> transform;
    QuickAgreement found;
  };
  mutable AgreementOf agreementOf_;
};

}  // namespace ew::stitching
