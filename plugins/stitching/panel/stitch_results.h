#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/volume.h"
#include "ew/stitching/chain.h"
#include "ew/stitching/cost_estimate.h"
#include "ew/stitching/project.h"
#include "logic/pair_review.h"

namespace ew::stitching {

class ProjectDocument;
class ProjectInputs;

/// Two volumes of the project by their numbers, the smaller first.
struct VolumePair {
  std::size_t fixed = 0;
  std::size_t moving = 1;
  bool operator==(const VolumePair&) const = default;
};

/// What the last run found about the project as it is now: how pairs lie, where volumes lie, what was deformed. Volumes are named by their
/// numbers in the project, but where it says "as found": a run numbers them as they stood when it began. On the window's thread.
class StitchResults final : public QObject {
  Q_OBJECT

 public:
  StitchResults(const ProjectDocument& document, ProjectInputs& inputs);

  void settle(ChainState state, StitchProject asked);  ///< what a run found
  void forget();
  /// Files of the result lie in another folder now.
  void moveFiles(const std::filesystem::path& before, const std::filesystem::path& after);
  [[nodiscard]] const ChainState* found() const { return found_ ? found_.get() : nullptr; }
  [[nodiscard]] bool isFoundFresh() const;  ///< nothing was edited since
  /// The number of a volume as found; empty: it was not in the run.
  [[nodiscard]] std::optional<std::size_t> foundIndex(std::size_t volume) const;

  using Mark = PairMark;
  struct PairLine {
    std::size_t fixed = 0;
    std::size_t moving = 0;
    Mark mark = Mark::unknown;
    bool stale = false;                    ///< edited since it was found
    bool wrong = false;                    ///< the graph does not believe it
    bool warpDoubted = false;              ///< as of PairReview
    bool needsLook = false;                ///< as of PairReview
    const PairOutcome* outcome = nullptr;  ///< of the last run; null: none
  };
  /// Every pair that a run has looked at or a person has spoken of, and the one that is shown; before the first run all of them.
  [[nodiscard]] std::vector<PairLine> pairs(const std::optional<VolumePair>& shown) const;
  [[nodiscard]] PairLine pairLine(std::size_t a, std::size_t b) const;
  [[nodiscard]] Mark markOf(std::size_t volume) const;  ///< the best of its pairs: what holds it
  [[nodiscard]] int pairsToLookAt() const;
  /// In a few words: how many pairs need a look, else how many were not matched, else that none does. Empty before the first run.
  [[nodiscard]] QString pairSummary(const std::optional<VolumePair>& shown) const;
  /// Every volume was in the last run, and nothing that shapes the places was edited since.
  [[nodiscard]] bool isMatchFresh() const;

  /// As found, else as placed. A volume placed anew since lies where it was put beside those that were not.
  [[nodiscard]] Transform<frame::World, frame::View> toWorld(std::size_t volume) const;
  /// From where the project places a volume to where it is shown.
  [[nodiscard]] Transform<frame::World, frame::Placed> placedToShown(std::size_t volume) const;

  [[nodiscard]] bool hasElastic(std::size_t a, std::size_t b) const;                  ///< both are deformed where they lie
  [[nodiscard]] const PairDeformation* warpedOf(std::size_t a, std::size_t b) const;  ///< of the last run; null: it was not warped
  [[nodiscard]] bool isWarpedStale(std::size_t a, std::size_t b) const;  ///< it was warped with another effort, or lay elsewhere
  [[nodiscard]] MachinePace warpPace() const;                            ///< from the pairs that were warped
  [[nodiscard]] MachinePace searchPace() const;

 Q_SIGNALS:
  void settled();

 private:
  [[nodiscard]] const StitchProject& project() const;
  [[nodiscard]] bool samePlaces(std::size_t volume) const;
  [[nodiscard]] const PairOutcome* outcomeOf(std::size_t fixed, std::size_t moving) const;         ///< of volumes as found
  [[nodiscard]] const Transform<frame::World, frame::View>* foundPlace(std::size_t volume) const;  ///< null: none, or placed anew since
  [[nodiscard]] Transform<frame::Placed, frame::View> placeGiven(std::size_t volume) const;        ///< by the project
  [[nodiscard]] std::vector<std::optional<Grid>> gridsFound() const;                               ///< of the volumes as found

  const ProjectDocument& document_;
  ProjectInputs& inputs_;
  std::shared_ptr<const ChainState> found_;
  StitchProject asked_;  ///< of which found_ tells
  std::vector<std::string> foundKeys_;
  mutable std::map<const PairOutcome*, PairOutcome> turnedOutcomes_;  ///< of found_, seen from the moving volume
};

}  // namespace ew::stitching
