#pragma once

#include <QObject>
#include <QUndoStack>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "ew/library/case.h"

namespace ew::ui {

/// What a user has decided to write over.
struct CaseOverwrite {
  bool changedOnDisk = false;  ///< what somebody else has saved since the case was opened
  bool shipped = false;        ///< a case, or a folder, of the program's own
};

/// The open case and its undo history. Everything that edits a case goes through edit(); the console's knobs are not edits.
/// What saving would destroy is refused until somebody has decided: changes that another program made in the folder meanwhile, and the
/// shipped cases, which belong to the program.
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
  [[nodiscard]] Result<void> restore(const nlohmann::json& manifest, const std::string& what, const Fingerprint& asRead);
  [[nodiscard]] const std::optional<Fingerprint>& asRead() const { return asRead_; }
  [[nodiscard]] const std::optional<Case>& current() const { return current_; }
  [[nodiscard]] nlohmann::json manifest() const;  ///< of the open case; null when none is open

  /// Replaces the manifest as one step named `what`; steps with the same non-empty mergeKey in a row become one.
  /// @error badUsage (no case is open), and what the case's schema refuses; then nothing changed
  [[nodiscard]] Result<void> edit(const nlohmann::json& manifest, const std::string& what, const std::string& mergeKey);
  /// @param folder empty: where the case was opened. Another folder gives the case an id of its own, so that a library can hold both
  /// @error badUsage (no case is open), notWritable (see CaseOverwrite), as saveCase; then the case stays unsaved
  [[nodiscard]] Result<void> save(const std::filesystem::path& folder = {}, const CaseOverwrite& decided = {});
  [[nodiscard]] bool hasUnsavedChanges() const { return current_.has_value() && !history_.isClean(); }
  /// Whether somebody else has saved the case since it was opened or saved here.
  [[nodiscard]] bool isChangedOnDisk() const;
  [[nodiscard]] bool isShippedCase() const { return current_.has_value() && isShipped_; }
  [[nodiscard]] QUndoStack& history() { return history_; }

 Q_SIGNALS:
  void changed();  ///< the case or its saved state
  void opened();   ///< another case, or this one under another name
  void closed();   ///< none is open any more

 private:
  friend class ReplaceCase;
  void replace(const Case& next);
  std::optional<Case> current_;
  std::optional<Fingerprint> asRead_;
  bool isShipped_ = false;
  QUndoStack history_;
};

}  // namespace ew::ui
