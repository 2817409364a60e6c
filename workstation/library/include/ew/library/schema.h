#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "ew/core/result.h"

namespace ew {

/// The schemas of resources/schemas, compiled in, so that checking a file depends on no other file.
enum class SchemaName { caseManifest, pluginManifest };

/// Everything in which `document` departs from the schema, each as a sentence a user can act on, with the context "field"
/// ("patient.age_years", "start_pose[3]"), "found" and "expected"; empty when it conforms.
/// @param documentName how the file is called in the sentences: "case.json"
/// @error codes: badField throughout
[[nodiscard]] std::vector<Error> schemaProblems(const nlohmann::json& document, SchemaName schema, const std::string& documentName);

}  // namespace ew
