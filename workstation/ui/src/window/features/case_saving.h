#pragma once

#include <QTimer>
#include <filesystem>
#include <optional>
#include <vector>

#include "ew/core/result.h"
#include "ew/library/edit_autosave.h"
#include "window/frame/feature.h"

class QAction;
class QMenu;

namespace ew::ui {

/// Saving the open case, or the document of the panel whose stage is shown; edits of cases are kept against a crash.
class CaseSaving final : public Feature {
  Q_OBJECT

 public:
  explicit CaseSaving(WindowParts& parts);

  void addActions(QMenu& file);
  void connectParts() override;
  void refresh() override;
  void holdUnsavedWork(UnsavedWork& list) override;

  [[nodiscard]] bool mayLeave(const QString& next);
  void reload();       ///< as its folder holds it; the changes made here go
  void forgetEdits();  ///< the user has decided
  /// Nothing is being opened any more: what could not be opened keeps its edits.
  void openingEnded();
  /// Looks for edits of cases that a crash has interrupted, and asks about them, one after the other. @param caseFolder empty: of whatever
  /// case
  void offerKeptEdits(const std::filesystem::path& caseFolder);
  /// Whether they are being looked for or asked about.
  [[nodiscard]] bool isOffering() const { return isLooking_ || asksAboutKept_; }
  /// A case is open: takes over the edits it was opened for, or asks about those there are.
  void caseOpened();

 private:
  /// Edits that a crash has left, and the case with them; an Error where they make no case any more.
  struct EditsLeft {
    EditAutosave::Left left;
    Result<Case> edited;
  };
  void lookForKept();
  void askAboutKept(const std::vector<EditsLeft>& all, const std::vector<std::filesystem::path>& folders);
  void save(bool elsewhere);
  bool saveCase(bool elsewhere);  ///< shows what went wrong. @return whether it is saved
  /// Asks first when the case is shipped or was saved by another program. @error cancelled: the user wants it unsaved for now
  [[nodiscard]] Result<void> saveInPlace();
  /// Asks for a new folder. @param why it is asked for; may be empty
  [[nodiscard]] Result<void> saveCopy(const QString& why);
  [[nodiscard]] Result<void> saveFor(const std::filesystem::path& folder);  ///< for a plugin; empty: in place
  /// Under an id that no case beside it has. @error as CaseDocument::save; cancelled: another case came meanwhile
  [[nodiscard]] Result<void> saveElsewhere(const std::filesystem::path& folder);
  [[nodiscard]] Result<void> makeOwn();
  void keepEdits();  ///< of the open case as it is now, or forgets them when there are none
  void restoreKeptEdits();

  EditAutosave keptEdits_;  ///< of the open case, against a crash
  QTimer keepSoon_;
  std::vector<std::filesystem::path> decideLater_;  ///< kept edits that the user wants to decide about another time
  std::optional<EditsLeft> restoring_;              ///< edits that are taken over once their case is open
  std::vector<std::filesystem::path> offeredFor_;   ///< cases whose edits are being looked for; an empty one: all
  bool isLooking_ = false;
  bool asksAboutKept_ = false;  ///< the question about kept edits is open: none is asked in the middle of it
  bool dropsEdits_ = false;     ///< the case is being opened again, and the user gave up the changes made here
  QAction* save_ = nullptr;
  QAction* saveAs_ = nullptr;
};

}  // namespace ew::ui
