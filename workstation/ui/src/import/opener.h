#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "case/case_document.h"
#include "ew/bridge/mannequin.h"
#include "ew/library/file_import.h"
#include "ew/library/placing.h"
#include "ew/scanning/recording.h"
#include "ew/scanning/subject.h"
#include "jobs/jobs.h"
#include "scan/session.h"

namespace ew::ui {

class HandInput;
class MessageBar;
class View3D;

/// A case whose volume has to be made before it is shown.
struct CaseToMake {
  Case wanted;
  double seconds = 0.0;    ///< about, on this machine; 0: nobody knows
  bool isDrafted = false;  ///< shown coarsely within seconds meanwhile
  [[nodiscard]] bool takesLong() const;
};

/// Opens cases, volumes and sweeps as jobs and puts what came out into the session: placed, with the probe on the skin in front of it.
/// Nothing is replaced before the new thing is there in full, and then only what may be lost (see askBeforeReplacing). A case whose volume
/// is exchanged by an edit is loaded again as opening it does, so that the scan shows what the case holds; while its volume stays the same,
/// in whatever body, its examination goes on. It is the only one that replaces what is scanned.
class Opener final : public QObject {
  Q_OBJECT

 public:
  Opener(Session& session, CaseDocument& document, Jobs& jobs, MessageBar& messages, View3D& view, HandInput& hand,
         QObject* parent = nullptr);

  /// @param mayReplace asked when something opened is about to take the place of what is open, and not before: whoever answers decides
  /// about the edits of that moment; `next` names what was opened. False: all stays as it is
  /// @param mayScan the same where the case stays open and another volume is scanned
  void askBeforeReplacing(std::function<bool(const QString& next)> mayReplace, std::function<bool(const QString& next)> mayScan) {
    mayReplace_ = std::move(mayReplace);
    mayScan_ = std::move(mayScan);
  }

  /// What becomes of a case that takes long to be made: it is opened, however long that is, or left to whoever is told of it (tooLong).
  enum class LongCases { open, leave };
  /// By what it is: a folder or case.json is a case, a file with poses a sweep, any other image a volume.
  void open(const QString& path, LongCases longOnes = LongCases::open);
  void loadDefaultMannequin();
  /// Shows a volume that belongs to no case. @param keepPlace whether its own coordinates are to be used when they lie in the body
  /// @param provenance of the same voxels, or null @param madeFrom see sources()
  void showVolume(const ScanVoxels& voxels, const QString& title, bool keepPlace, std::shared_ptr<const Provenance> provenance = nullptr,
                  std::vector<std::filesystem::path> madeFrom = {});
  /// The same of a volume that somebody made, where its own coordinates say if that lies in the body; a large one is first made ready in a
  /// job. @param mayShow asked when it is about to take the place of what is shown @param madeFrom see sources()
  void openVolume(std::shared_ptr<const Volume> volume, const QString& title, std::function<bool()> mayShow,
                  std::vector<std::filesystem::path> madeFrom = {});
  /// Back to the volume of the open case, when what is scanned may be left.
  void showCaseVolume();
  [[nodiscard]] bool showsCase() const { return showsCase_; }
  [[nodiscard]] bool hasCaseVolume() const { return contents_.has_value(); }
  /// Whether the open case is scanned as a draft, until its volume is made.
  [[nodiscard]] bool showsDraft() const { return showsCase_ && contents_ && contents_->read.isDraft; }
  /// The volume of the open case was made: reads it in the background, or makes it once more where it could not be kept, and puts it in the
  /// place of the draft as soon as that disturbs nobody.
  void refine();
  [[nodiscard]] bool isBusy() const { return busy_ > 0; }
  /// Whether anything is being opened; ended() follows.
  [[nodiscard]] bool isOpening() const { return openingJob_ != 0; }
  /// What is being opened; empty: nothing, or what an edit of the open case asks for.
  [[nodiscard]] const QString& openingPath() const { return openingPath_; }
  /// Whether this is what is being opened now; ended() follows.
  [[nodiscard]] bool isOpening(const QString& path) const;
  /// Of what is being opened, from preparing() to ended(): what has to be made.
  [[nodiscard]] const std::optional<CaseToMake>& beingMade() const { return beingMade_; }
  /// The files that what is shown was read or made from, those of the open case among them: nothing may be saved over them.
  [[nodiscard]] std::vector<std::filesystem::path> sources() const;

 Q_SIGNALS:
  /// A case is being opened whose volume has to be made first: told once it is read, and before ended().
  void preparing(const QString& path, const QString& caseId);
  /// A case was not opened, for it takes long to be made (LongCases::leave): what was open stays open. Told before ended().
  void tooLong(const QString& path, const ew::ui::CaseToMake& left);
  void ended();  ///< nothing is being opened any more, whatever came of it; another opening may follow
  void opened(const QString& path);
  void draftShown();                       ///< the volume of the open case is still to be made
  void refined();                          ///< the open case is scanned as it asks for
  void sweepChosen(const QString& path);   ///< a sweep needs answers before it becomes a volume
  void bundleChosen(const QString& path);  ///< a case of another workstation, which goes into the library before it is opened
  /// A file of another kind leaves something open, or holds images that are no volume.
  void answersNeeded(const QString& path, ew::FileKind kind, const QString& question);
  /// A file is a recorded scan. Nothing was replaced.
  void recordingOpened(const QString& path, std::shared_ptr<const ew::ScanRecording> recording);
  void failed(const Error& error);

 private:
  struct Image;
  struct Loading;
  /// What decides which voxels a case shows and in which body. Everything else, the placement too, is edited without loading again.
  struct Sources {
    CaseVolume volume;  ///< not placed
    std::string mannequin;
    bool operator==(const Sources&) const = default;
  };
  [[nodiscard]] static Sources sourcesOf(const Case& opened);
  /// What the open case is scanned as.
  struct Contents {
    Sources sources;
    CaseContents read;
  };
  void openCase(const QString& path, LongCases longOnes);
  /// From the thread of a job, as tellPreparing: whose case it opens.
  void tellTitle(const Case& read, const std::shared_ptr<const int>& job);
  /// From the thread of a job: preparing() on the window's, if that job is still the opening there is. @param job its id, known and looked
  /// at on the window's thread alone
  void tellPreparing(const QString& path, CaseToMake toMake, const std::shared_ptr<const int>& job);
  void openImage(const QString& path);
  /// Loads what the open case names since it was edited.
  void reloadCase(const Case& edited);
  [[nodiscard]] static Result<void> load(Loading& into, const std::filesystem::path& presentMannequin, Progress& progress);
  /// The same where the case names other labels and all else is there: the scan goes on as it stands.
  void reloadLabels(const Case& edited);
  void loadChanged(const Case& edited);
  void takeContents(Loading& loaded);
  /// Scans what was loaded of the open case; whoever might mind was asked.
  void scanCase();
  /// Goes on with what is scanned although the case holds something else now.
  void stayWith(const Sources& refused);
  /// Whether the case's volume may be scanned: asks when that is somebody else.
  [[nodiscard]] bool mayScanCase(const Sources& next) const;
  /// Whose examination goes on when a case's volume is scanned now.
  [[nodiscard]] Session::Patient patientOf(const Sources& next) const;
  /// Runs `work` as the one opening there is: a later one cancels it, and then `taken` is not called.
  /// @param title of the job
  void startOpening(const QString& path, const QString& title, Jobs::Work work, std::function<void()> taken,
                    std::function<void()> refused = {});
  void giveUpOpening();
  /// One message of what reading it had to decide.
  void tellOpened(const QString& path, const std::vector<Message>& notes, const std::vector<Message>& warnings = {});
  /// Finds out what live echoes of the voxels that are shown are formed from.
  void findTissue();
  void showMannequin(std::shared_ptr<const bridge::Mannequin> mannequin);
  void followDocument();
  /// What the scan takes over from edits at once: title, scene, placement.
  void followEdits(const Case& edited);
  void takeStart();
  void takeFiner();
  /// Another probe and depth where the present ones would show a stamp, or cut the volume off.
  void lookAtWhole(const PlacingShape& shape);

  Session& session_;
  CaseDocument& document_;
  Jobs& jobs_;
  MessageBar& messages_;
  View3D& view_;
  HandInput& hand_;
  std::function<bool(const QString& next)> mayReplace_ = [](const QString&) { return true; };
  std::function<bool(const QString& next)> mayScan_ = [](const QString&) { return true; };
  std::optional<Contents> contents_;  ///< of the open case; empty without one
  std::optional<Contents> finer_;     ///< waits to take the place of a draft
  QTimer finerSoon_;
  std::optional<CaseToMake> beingMade_;
  std::optional<Sources> reloading_;              ///< what the open case is being loaded for again
  std::optional<Sources> refused_;                ///< that could not be loaded: not tried again until they change or are asked for
  std::filesystem::path mannequinFile_;           ///< of the body that is shown or on its way
  std::optional<CaseVolume> patient_;             ///< of the open case, whose examination it is; empty: another's
  std::vector<std::filesystem::path> shownFrom_;  ///< of a volume that belongs to no case
  bool showsCase_ = false;
  bool startTaken_ = false;  ///< the probe stands where the opened thing wants it; false until a skin is there
  QString openingPath_;      ///< what is being opened; empty: nothing
  int openingJob_ = 0;
  int tissueJob_ = 0;
  int refineJob_ = 0;
  int busy_ = 0;
};

}  // namespace ew::ui
