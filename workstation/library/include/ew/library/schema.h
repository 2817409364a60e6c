#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "ew/core/result.h"

namespace ew {

/// The schemas of resources/schemas, compiled in, so that checking a file depends on no other file. caseOtherFields: what that of cases
/// says of the fields that a Case keeps as JSON (Case::otherFields), of which none has to be there.
enum class SchemaName { caseManifest, caseOtherFields, pluginManifest };

/// Everything in which `document` departs from the schema, each as a sentence a user can act on, with the context "field"
/// ("patient.age_years", "start_pose[3]"), "found" and "expected"; empty when it conforms.
/// @param documentName how the file is called in the sentences: verbatim("case.json")
/// @error codes: badField throughout
[[nodiscard]] std::vector<Error> schemaProblems(const nlohmann::json& document, SchemaName schema, const Message& documentName);

/// A schema that comes at run time, with a plugin: what it says about a part of a document. Its descriptions are texts of messages, which
/// the plugin's own words can translate.
class PartSchema {
 public:
  /// @param text JSON Schema, draft 7, that refers to no other file
  /// @error badHeader (not JSON, or no such schema)
  [[nodiscard]] static Result<PartSchema> of(const std::string& text, const Message& documentName);
  /// As schemaProblems, of a part of a document. @param place of the part in it, for the sentences: "parts.lesson"
  [[nodiscard]] std::vector<Error> problems(const nlohmann::json& part, const std::string& place, const Message& documentName) const;

 private:
  struct Loaded;
  std::shared_ptr<const Loaded> loaded_;
};

}  // namespace ew
