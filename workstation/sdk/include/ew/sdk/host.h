#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ew/core/beams.h"
#include "ew/core/memory.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/library/case_values.h"
#include "ew/sdk/ticket.h"

class QWidget;  // only named here; a plugin without a panel never includes Qt

namespace ew::sdk {

// Each in a header of its own: ew/sdk/scan.h, workspaces.h, overlays.h, case_parts.h, window.h.
class Scan;
class Workspaces;
class Overlays;
class CaseParts;
class Window;

/// What a file holds, from its header alone.
struct VolumeInfo {
  bool sweep = false;                        ///< frames with poses, to be reconstructed; then `grid` says nothing
  Grid grid;                                 ///< of a volume
  std::vector<std::filesystem::path> files;  ///< that hold it: header and samples
};

/// How a sweep becomes a volume.
struct SweepOptions {
  double spacing_mm = 0.0;            ///< of the volume; 0: from the pixels and the distance of the frames
  std::filesystem::path calibration;  ///< device set; empty: the recording says everything itself
  int threads = 0;
  std::uint64_t maxBytes = kLargestVolume_bytes;
};
struct SweepPlan {
  Grid grid;
  double spacing_mm = 0.0;  ///< that will be used
  std::uint64_t bytes = 0;  ///< at the peak
  std::size_t frames = 0;   ///< with a pose
};
struct SweepVolume {
  Volume volume;                         ///< with coverage
  std::vector<std::uint8_t> confidence;  ///< per voxel, 255 for 1: how far the echoes may be trusted; less in shadow and without contact
  std::optional<Beams> beams;            ///< in the volume's own frame; empty: they cancel out
  std::vector<Message> notes;
};

/// A volume file that is written block by block, in any order, and need not fit into memory. Without finish() nothing is left of it.
class VolumeWriter {
 public:
  virtual ~VolumeWriter();
  /// @param corner first voxel of the block; `values` holds size.x * size.y * size.z of them, i fastest
  virtual void put(const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> values) = 0;
  /// @error notWritable, cancelled
  [[nodiscard]] virtual Result<void> finish(Progress& progress) = 0;
};

/// What is scanned where that is no case's: a file that was opened, or a recording that was reconstructed here.
struct DisplayVolume {
  std::shared_ptr<const Volume> volume;  ///< in its own frame; not null
  std::string title;
  /// Where the recording's frames look in that frame, of length 1: away from the probe, and to its marker. Empty: nobody knows.
  std::optional<std::pair<glm::dvec3, glm::dvec3>> depthAndLateral = {};
};

/// Volumes in files and in the workstation.
class Volumes {
 public:
  virtual ~Volumes();
  /// @error as read, but for what only the samples show
  [[nodiscard]] virtual Result<VolumeInfo> inspect(const std::filesystem::path& file) = 0;
  [[nodiscard]] virtual Result<Volume> read(const std::filesystem::path& file, Progress& progress) = 0;
  [[nodiscard]] virtual Result<void> write(const Volume& volume, const std::filesystem::path& file, Progress& progress) = 0;
  [[nodiscard]] virtual Result<void> writeCoverage(const Volume& volume, const std::filesystem::path& file, Progress& progress) = 0;
  /// Fills volume.coverage from a file of the same grid.
  [[nodiscard]] virtual Result<void> readCoverageInto(Volume& volume, const std::filesystem::path& file, Progress& progress) = 0;
  /// How far each voxel of a volume may be trusted, 0 to 255 for 0 to 1, as a volume of the same grid.
  [[nodiscard]] virtual Result<std::vector<std::uint8_t>> readConfidence(const Grid& grid, const std::filesystem::path& file,
                                                                         Progress& progress) = 0;
  [[nodiscard]] virtual Result<void> writeConfidence(const Grid& grid, std::span<const std::uint8_t> confidence,
                                                     const std::filesystem::path& file, Progress& progress) = 0;
  /// What reconstructing a sweep will make and need. Its frames are read for it.
  [[nodiscard]] virtual Result<SweepPlan> planSweep(const std::filesystem::path& sweep, const SweepOptions& options,
                                                    Progress& progress) = 0;
  /// A sweep as a volume, holes between its frames filled. The voxels do not depend on the number of threads.
  /// @error what reading says, noValidPose, missingCalibration, tooLarge, cancelled
  [[nodiscard]] virtual Result<SweepVolume> reconstruct(const std::filesystem::path& sweep, const SweepOptions& options,
                                                        Progress& progress) = 0;
  /// Begins a volume file (.mha) that is written in blocks. Room on the medium is taken at once.
  /// @error notWritable, unsupported (another ending), tooLarge
  [[nodiscard]] virtual Result<std::unique_ptr<VolumeWriter>> writeInBlocks(const Grid& grid, const std::filesystem::path& file) = 0;
  /// Puts a volume into the scan view of the workstation; without a window it does nothing.
  virtual void show(Volume volume, const std::string& title) = 0;
  /// The same of a volume that was made from files: while it is shown nothing is saved over them.
  virtual void showMade(Volume volume, const std::string& title, const std::vector<std::filesystem::path>& madeFrom);
  /// Empty: nothing is scanned, it is a case's, it stays in its file, or there is no window.
  [[nodiscard]] virtual std::optional<DisplayVolume> shown() const;
  /// A shown volume was put into a file by somebody else, so that the window need not ask about it any more.
  virtual void wasKept(const std::shared_ptr<const Volume>& volume);
};

/// Text files: settings, projects, reports. The text may hold any bytes.
class Files {
 public:
  virtual ~Files();
  /// @error notFound, notReadable, tooLarge
  [[nodiscard]] virtual Result<std::string> readText(const std::filesystem::path& file) = 0;
  /// Complete or not at all: written aside, synced, renamed.
  /// @error notWritable
  [[nodiscard]] virtual Result<void> writeText(const std::filesystem::path& file, const std::string& text) = 0;
};

/// The case that is open, as a value. What a case may be is the host's to say: a plugin changes values, the host checks them. A plugin's
/// own section of a case is JSON: see CaseParts.
class Cases {
 public:
  virtual ~Cases();
  /// The open case with its edits and its folder; empty when none is open. While an instructor has locked the library for trainees
  /// (isLocked) it is what trainees may read: no finding, no target, no section of any plugin; then nothing can be edited or saved either.
  [[nodiscard]] virtual std::optional<Case> current() const = 0;
  /// The same for practising it: with everything that a lesson is judged by, also while the library is locked. For a plugin whose manifest
  /// names the capability "practice", which an instructor can read there; others are given what current() gives.
  [[nodiscard]] virtual std::optional<Case> forPractice() const;
  [[nodiscard]] virtual std::filesystem::path currentFolder() const = 0;
  [[nodiscard]] virtual bool isLocked() const { return false; }
  /// Reads a case that need not be open, on the thread of whoever calls.
  /// @param folderOrManifest its folder, or its case.json
  /// @error notFound, badHeader, badField, newerFormat, notRigid; badUsage while the library is locked for trainees
  [[nodiscard]] virtual Result<Case> read(const std::filesystem::path& folderOrManifest) const = 0;
  /// Everything that is wrong with a case, one sentence each; `context` names the "field" of case.json ("patient.age_years"). Empty: it is
  /// valid. Its files are looked for in currentFolder().
  [[nodiscard]] virtual std::vector<Error> check(const Case& edited) const = 0;
  /// Puts `edited` in place of the open case as one undoable step named `what`; checked first. Steps with the same non-empty mergeKey in a
  /// row become one. Its folder does not count: the case stays where it is.
  [[nodiscard]] virtual Result<void> edit(const Case& edited, const std::string& what, const std::string& mergeKey) = 0;
  /// Saves the open case, crash-safely; into `folder` when given. Asks the user where somebody has to decide: a shipped case, or one that
  /// another program has saved meanwhile.
  /// @error badUsage, notWritable, badField, cancelled (the user wants it unsaved for now)
  [[nodiscard]] virtual Result<void> save(const std::filesystem::path& folder = {}) = 0;
  /// Asks the user for a new folder and saves a copy of the open case there, which is then the open one.
  /// @error badUsage (no case is open, or there is no window), cancelled (the user wants no copy), notWritable, badField
  [[nodiscard]] virtual Result<void> saveCopy();
  /// To be called before files are put into currentFolder(): a shipped case is first copied to a folder of the user's own, which is
  /// asked for and becomes currentFolder(). So is one that somebody else is editing. Any other case stays where it is.
  /// @error badUsage (no case is open), cancelled (the user wants no copy), notWritable
  [[nodiscard]] virtual Result<void> makeOwn();
  [[nodiscard]] virtual bool hasUnsavedChanges() const = 0;
  /// Begins to open another case in place of this one, as if the user had chosen it; the user is asked about what would be lost, and may
  /// stay. It is there when CaseParts::onOpened says so.
  /// @error badUsage (no window)
  [[nodiscard]] virtual Result<void> open(const std::filesystem::path& folder);

  /// How the volume of the open case is scanned at this moment.
  struct Scan {
    std::string probe;                                        ///< its id
    Transform<frame::World, frame::Probe> probeToWorld = {};  ///< rigid
    double depth_mm = 0.0;                                    ///< how far the image reaches
    double halfWidth_rad = 0.0;                               ///< of the image about the beam in its middle; 0: its lines are parallel
    double halfFace_mm = 0.0;                                 ///< half the width of the probe's face
    Grid volume;                                              ///< where the volume lies in the world, with the case's edits
  };
  /// Empty: the case's volume is not the one that is scanned, or there is no window.
  [[nodiscard]] virtual std::optional<Scan> scan() const;
  /// What the program has for a case to choose from.
  struct Choices {
    std::vector<std::pair<std::string, std::string>> probes;      ///< id and name
    std::vector<std::pair<std::string, std::string>> mannequins;  ///< file and name, in the window's language
    std::vector<std::pair<std::string, std::string>> presets;     ///< of the console: id and name, in the window's language
    std::vector<std::pair<std::string, std::string>> bodyMarks;   ///< id and name, in the window's language
    std::vector<std::string> regions;                             ///< that body marks and word lists are made for
    std::filesystem::path ownCases;                               ///< where the user keeps cases of their own; it need not be there yet
  };
  [[nodiscard]] virtual Choices choices() const;

  /// Called on the window's thread whenever the open case or its saved state changed, also by undo. Returns a ticket; the callback lives
  /// until the ticket is destroyed.
  using Ticket = sdk::Ticket;
  [[nodiscard]] virtual Ticket onChanged(std::function<void()> callback) = 0;
};

/// Long work off the window's thread, shown as a progress card with cancel.
class Jobs {
 public:
  virtual ~Jobs();
  /// @param work runs on a worker; @param done runs on the window's thread afterwards, also after a failure or cancel
  virtual void start(const std::string& title, std::function<Result<void>(Progress&)> work,
                     std::function<void(const Result<void>&)> done) = 0;
  /// The same for work that writes what a user wants to keep: a window that is closed meanwhile asks before it is lost.
  virtual void startSaving(const std::string& title, std::function<Result<void>(Progress&)> work,
                           std::function<void(const Result<void>&)> done);
};

/// What a panel edits when that is not the open case: while the panel is in front, the window's undo, redo and save are its own, and its
/// title and remarks stand where the case's stand. Called on the window's thread.
class PanelDocument {
 public:
  virtual ~PanelDocument();
  [[nodiscard]] virtual std::string title() const = 0;     ///< for the top bar
  [[nodiscard]] virtual std::string remark() const = 0;    ///< beside it: "not saved"
  [[nodiscard]] virtual std::string note() const = 0;      ///< what still needs a look, for the status line; may be empty
  [[nodiscard]] virtual std::string undoText() const = 0;  ///< name of the last step, in the user's words; empty: nothing to undo
  [[nodiscard]] virtual std::string redoText() const = 0;
  virtual void undo() = 0;
  virtual void redo() = 0;
  virtual void save(bool elsewhere) = 0;  ///< asks for a file when there is none, or `elsewhere`
  /// What would be lost if the window closed now, as a sentence; empty: nothing. The window asks before it closes, and offers to save.
  [[nodiscard]] virtual std::string unsaved() const;
  /// As Cases::onChanged.
  [[nodiscard]] virtual std::shared_ptr<void> onChanged(std::function<void()> callback) = 0;
};

/// A panel that brings more than a column.
struct StagePanel {
  using Make = std::function<QWidget*(QWidget* parent)>;
  std::string id;
  std::string title;
  Make make;            ///< the column at the left; it is made first
  Make makeStage = {};  ///< in place of 3D view, scan view and console while the panel is in front; may be empty
  /// The plugin keeps it; once it is gone there is nothing to undo or to save. None: the panel edits the open case.
  std::weak_ptr<PanelDocument> document = {};
  std::vector<std::pair<std::string, std::string>> keys = {};  ///< keys and what they do, for the page of keys
  /// Where it belongs: "explore", "author", or a workspace that a plugin adds (ew/sdk/workspaces.h). One that nobody adds is never seen.
  std::string workspace = "author";
};

/// Panels beside the views, one tab each in their workspace.
class Panels {
 public:
  virtual ~Panels();
  /// Adds a panel. Its widgets are made when it is first opened; without a window nothing is made. A host that has no place for a stage
  /// shows the column alone.
  virtual void addStaged(StagePanel panel) = 0;
  /// One that is a column alone.
  void add(const std::string& id, const std::string& title, StagePanel::Make make, const std::string& workspace = "author");
  /// Takes a panel's tab out of its column while it has nothing to show, and puts it back; a column without tabs gives its room to the
  /// views. A panel is shown when it is added. An id that is none does nothing.
  virtual void setShown(const std::string& id, bool shown);
  /// Puts a panel, another plugin's as well, in front of the others of its workspace. An id that is none does nothing.
  virtual void bringToFront(const std::string& id);
};

/// Headless commands: `echoweave NAME args…`.
class Commands {
 public:
  virtual ~Commands();
  struct Outcome {
    std::vector<std::string> outputs;                     ///< files written, or put in place by `putInPlace`
    std::vector<std::pair<std::string, double>> quality;  ///< figures by name, unit in the name: for the report
    /// "aligned", "not aligned" or "cannot tell", where the command judges: in the report, and what is not "aligned" ends the program with
    /// exit status 3 after the sentence `reason`. Everything was done and written all the same.
    std::optional<std::string> verdict = {};
    std::string reason = {};
    std::vector<std::pair<std::string, double>> steps = {};  ///< seconds by name, in the order they ran: for the report
    std::vector<Message> notes = {};                         ///< what the user should know, a sentence each; told as remarks
    /// Moves the outputs to their names, all or none. The host calls it at the very end, when its own files (the report) lie in place, and
    /// takes those back when it fails; not called when the command is stopped before. Empty: the outputs are in place.
    std::function<Result<void>()> putInPlace = {};
  };
  /// @param usage one line, and after an empty line what else `--help` should say; `args` are the words after the name without --report and
  /// --quiet, which the host handles
  using Run = std::function<Result<Outcome>(const std::vector<std::string>& args, Progress& progress)>;
  virtual void add(const std::string& name, const std::string& usage, Run run) = 0;
};

class Log {
 public:
  virtual ~Log();
  virtual void info(const std::string& text) = 0;
  virtual void warn(const std::string& text) = 0;
  virtual void error(const std::string& text) = 0;
};

/// Everything a plugin may touch, handed in at creation; a test hands in a fake.
class Host {
 public:
  virtual ~Host();
  virtual Volumes& volumes() = 0;
  virtual Files& files() = 0;
  virtual Cases& cases() = 0;
  virtual Jobs& jobs() = 0;
  virtual Panels& panels() = 0;
  virtual Commands& commands() = 0;
  virtual Scan& scan() = 0;
  virtual Workspaces& workspaces() = 0;
  virtual Overlays& overlays() = 0;
  virtual CaseParts& caseParts() = 0;
  virtual Window& window() = 0;
  virtual Log& log() = 0;
};

}  // namespace ew::sdk
