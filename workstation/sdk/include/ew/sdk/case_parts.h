#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "ew/core/result.h"
#include "ew/sdk/ticket.h"

namespace ew::sdk {

/// Sections of a case that belong to plugins: "parts" of case.json, by name. A program that does not know a section keeps it as it is.
class CaseParts {
 public:
  virtual ~CaseParts();
  /// Makes a section known until the ticket is destroyed: meanwhile it is checked wherever a case is checked, by `case validate` as well.
  /// @param name small letters, digits, '-' and '_', at most 60, beginning with a letter; by habit the plugin's
  /// @param schema JSON Schema, draft 7, as text; its descriptions stand in sentences about what is wrong ("it must be …")
  /// @error badUsage (the name is taken, or is none), badHeader (not a schema)
  [[nodiscard]] virtual Result<Ticket> add(const std::string& name, const std::string& schema) = 0;

  /// The section of the open case; empty: it has none, or no case is open, or the library is locked for trainees (Cases::isLocked) and the
  /// case is no examination, of which there is nothing else.
  [[nodiscard]] virtual std::optional<nlohmann::json> read(const std::string& name) const = 0;
  /// Replaces the section as one undoable step named `what`; steps with the same non-empty mergeKey in a row become one. Nothing takes the
  /// section away.
  /// @error badField (the schema refuses it; then nothing changed), badUsage (no such section was added), notFound (no case is open)
  [[nodiscard]] virtual Result<void> edit(const std::string& name, const std::optional<nlohmann::json>& section, const std::string& what,
                                          const std::string& mergeKey) = 0;
  /// Where files of the section belong: "parts/NAME" in the folder of the open case, empty without one. It need not be there yet; before
  /// anything is put into it Cases::makeOwn has to be asked. A case that is saved elsewhere takes it along.
  [[nodiscard]] virtual std::filesystem::path folderOf(const std::string& name) const = 0;

  /// Told when a case has been opened, or saved under another name (its folder), and when none is open any more (an empty path).
  /// Cases::onChanged tells of edits.
  using OpenCallback = std::function<void(const std::filesystem::path& folder)>;
  [[nodiscard]] virtual Ticket onOpened(OpenCallback callback) = 0;

  /// Told when somebody asks for one item of a section, as the start page does for a lesson of a case: once that case is open.
  /// @param item its id; empty: whatever is next
  using AskCallback = std::function<void(const std::string& item)>;
  [[nodiscard]] virtual Ticket onAsked(const std::string& name, AskCallback callback);
};

}  // namespace ew::sdk
