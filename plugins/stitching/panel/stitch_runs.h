#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/registration/rigid.h"
#include "ew/sdk/host.h"
#include "ew/stitching/chain.h"
#include "panel/stitch_results.h"

namespace ew::stitching {

class Mosaic;
class Notices;
class ProjectDocument;
struct ChainMade;

/// Long work on the project: runs of the chain in the host's jobs, which show how far they are and can be stopped there, on copies. One at
/// a time. On the window's thread.
class StitchRuns final : public QObject {
  Q_OBJECT

 public:
  StitchRuns(sdk::Host& host, Notices& notices, ProjectDocument& document, StitchResults& results, Mosaic& mosaic);

  [[nodiscard]] bool isRunning() const { return running_; }
  [[nodiscard]] bool isBusy();  ///< says so
  /// Matches every pair by its images; what a person said about how a pair lies stays for pairs that were accepted or have landmarks, and
  /// is told. @param withoutPlaces whatever is recorded; else from the places as they are
  void matchAll(bool withoutPlaces);
  void run(Step until, const QString& title);
  void resume();  ///< reads back what earlier runs of this project finished
  /// What was found goes along with a project that is saved as another file.
  void moveWork(const std::filesystem::path& before, const std::filesystem::path& after);

  /// Of matching a pair: growing while it runs, else of its result.
  [[nodiscard]] std::vector<registration::Level> levels(const std::optional<VolumePair>& pair) const;
  [[nodiscard]] std::vector<registration::Level> warpLevels(const std::optional<VolumePair>& pair) const;  ///< the same of deforming it

 Q_SIGNALS:
  void begun();
  void ended();  ///< what was found is there
  void levelsChanged();
  void resultMade();  ///< a run that was asked for has made a whole; ended() comes after it

 private:
  struct LevelSeen {
    std::size_t fixed = 0;
    std::size_t moving = 0;
    registration::Level level;
  };
  struct Inbox;
  [[nodiscard]] const StitchProject& project() const;
  void takeLevels();
  /// @param until empty: as far as it was finished before
  void begin(std::optional<Step> until, const QString& title);
  /// @param wasAsked somebody waits for the answer @param number of the project that was worked on
  void finish(const Result<void>& outcome, ChainMade& made, const StitchProject& asked, bool wasAsked, int number);
  [[nodiscard]] std::vector<registration::Level> levelsSeen(const VolumePair& pair, bool ofWarp) const;  ///< since the last run began

  sdk::Host& host_;
  Notices& notices_;
  ProjectDocument& document_;
  StitchResults& results_;
  Mosaic& mosaic_;
  QTimer poll_;
  std::shared_ptr<Inbox> inbox_;
  bool running_ = false;
  std::vector<LevelSeen> runningLevels_;
  std::vector<std::string> runningKeys_;  ///< of the volumes that runningLevels_ numbers
};

}  // namespace ew::stitching
