#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "ew/core/history.h"
#include "ew/library/case.h"
#include "ew/library/folder_lease.h"

namespace ew::ui {

/// What a user has decided to write over.
struct CaseOverwrite {
  bool changedOnDisk = false;  ///< what somebody else has saved since the case was opened
  bool shipped = false;        ///< a case, or a folder, of the program's own
};

/// The open case and its undo history. Everything that edits a case goes through edit(); the console's knobs are not edits.
/// What saving would destroy is refused until somebody has decided: changes that another program made in the folder meanwhile, and the
/// shipped cases, which belong to the program. A published revision never changes: it can only be saved elsewhere.
/// With its first edit the document takes the folder of a case of one's own for itself (FolderLease), until it is closed; whoever only
/// looks keeps nobody from editing.
class CaseDocument final : public QObject {
  Q_OBJECT

 public:
  explicit CaseDocument(QObject* parent = nullptr);

  /// @param asRead of case.json when the case was read; empty: saving compares with nothing
  void open(Case opened, std::optional<Fingerprint> asRead = {});
  void close();
  /// Takes over edits that a crash has interrupted, as one step of the open case.
  /// @param asRead of the case.json that they began with: saving asks when it is another now
  /// @error as edit
  [[nodiscard]] Result<void> restore(Case left, const std::string& what, const Fingerprint& asRead);
  [[nodiscard]] const std::optional<Fingerprint>& asRead() const { return asRead_; }
  [[nodiscard]] const std::optional<Case>& current() const { return current_; }

  /// Puts `next` in place of the open case as one step named `what`; steps with the same non-empty mergeKey in a row become one. The case
  /// stays in its folder.
  /// @error badUsage (no case is open), notWritable (somebody else is editing it: who and since when), and what checkCase refuses; then
  /// nothing changed
  [[nodiscard]] Result<void> edit(Case next, const std::string& what, const std::string& mergeKey);
  /// @param folder empty: where the case was opened. Another folder gives the case an id of its own, so that a library can hold both
  /// @param idThere that id; empty: idForFolder is asked, which reads the cases beside it and so is not for a window's thread
  /// @error badUsage (no case is open), notWritable (see CaseOverwrite; also when the folder is somebody else's by now), as saveCase; then
  /// the case stays unsaved
  [[nodiscard]] Result<void> save(const std::filesystem::path& folder = {}, const CaseOverwrite& decided = {},
                                  const std::string& idThere = {});
  [[nodiscard]] bool hasUnsavedChanges() const { return current_.has_value() && history_.kept() != saved_; }
  /// Whether somebody else has saved the case since it was opened or saved here.
  [[nodiscard]] bool isChangedOnDisk() const;
  [[nodiscard]] bool isShippedCase() const { return current_.has_value() && isShipped_; }
  [[nodiscard]] bool isPublishedCase() const { return current_.has_value() && isPublished_; }
  /// Takes the folder for this document, if it is one of the user's own that can be written to and it has it not yet.
  /// @error notWritable: somebody else is editing the case, or has taken it over since this document had it
  [[nodiscard]] Result<void> reserve();
  /// Why the case can only be saved elsewhere although it was edited here; empty: it can be saved where it is.
  [[nodiscard]] const std::optional<Error>& lost() const { return lost_; }
  /// Looks whether the folder is still this document's; done every 30 s by itself.
  void refreshLease();
  [[nodiscard]] const History<Case>& history() const { return history_; }
  void undo();
  void redo();
  /// The case stays as it is and cannot be undone any more; it counts as saved.
  void forgetSteps();

 Q_SIGNALS:
  void changed();                        ///< the case or its saved state
  void stepped();                        ///< after changed(): undo and redo are others
  void opened();                         ///< another case, or this one under another name
  void closed();                         ///< none is open any more
  void leaseLost(const ew::Error& why);  ///< somebody else has taken the folder over: what is edited here can only be saved elsewhere

 private:
  void release();
  void begin(Case first);
  void tell();
  std::optional<Case> current_;
  std::optional<Fingerprint> asRead_;
  bool isShipped_ = false;
  bool isPublished_ = false;
  std::optional<FolderLease> lease_;  ///< of the folder; empty: not edited yet, or not to be had
  std::optional<Error> lost_;
  QTimer refreshing_;
  History<Case> history_;
  std::shared_ptr<const Case> saved_ = history_.kept();
};

}  // namespace ew::ui
