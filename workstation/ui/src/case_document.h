#pragma once

#include <QObject>
#include <QUndoStack>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "ew/library/case.h"

namespace ew::ui {

/// The open case and its undo history. Everything that edits a case goes through edit(); the console's knobs are not edits.
class CaseDocument final : public QObject {
  Q_OBJECT

 public:
  explicit CaseDocument(QObject* parent = nullptr);

  void open(Case opened);
  void close();
  [[nodiscard]] const std::optional<Case>& current() const { return current_; }
  [[nodiscard]] nlohmann::json manifest() const;  ///< of the open case; null when none is open

  /// Replaces the manifest as one step named `what`; steps with the same non-empty mergeKey in a row become one.
  /// @error badUsage (no case is open), and what the case's schema refuses; then nothing changed
  [[nodiscard]] Result<void> edit(const nlohmann::json& manifest, const std::string& what, const std::string& mergeKey);
  /// @param folder empty: where the case was opened
  /// @error badUsage (no case is open), as saveCase; then the case stays unsaved
  [[nodiscard]] Result<void> save(const std::filesystem::path& folder = {});
  [[nodiscard]] bool hasUnsavedChanges() const { return current_.has_value() && !history_.isClean(); }
  [[nodiscard]] QUndoStack& history() { return history_; }

 Q_SIGNALS:
  void changed();  ///< the case or its saved state

 private:
  friend class ReplaceCase;
  void replace(const Case& next);
  std::optional<Case> current_;
  QUndoStack history_;
};

}  // namespace ew::ui
