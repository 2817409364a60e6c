#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "ew/phantom/patient.h"
#include "patient/recipe.h"

namespace ew::phantom {

/// A patient's recipe as one plain object: what it extends merged into it, every expression replaced by its number.
struct WholeRecipe {  // NOLINT(bugprone-exception-escape): JSON is moved without an exception
  nlohmann::json json;
  std::vector<PatientParameter> parameters;  ///< by name
};

/// A file that a recipe names, without a folder: beside `file`, in `folder`, in resources/<kind> of the folders above the recipe, then of
/// $ECHOWEAVE_RESOURCES. Empty when it is in none of them.
[[nodiscard]] std::filesystem::path findNamed(const std::string& name, const std::string& kind, const std::filesystem::path& file,
                                              const std::filesystem::path& folder);

/// A mannequin's recipe as one plain object. "extends" names one beside it or in resources/mannequin that extends none: entries of "parts"
/// whose name is taken replace those of its body's union, entries of "frames" and of its body's "relief" change the fields they give,
/// others are added, and "remove" lists names of parts and relief that go. @error as readBodyShape
[[nodiscard]] Result<nlohmann::json> readWholeMannequin(const std::filesystem::path& file);

/// Merges a recipe into what it extends and works out its expressions.
/// - "extends" names a recipe beside this one or in resources/anatomy; at most 8 follow one another.
/// - "remove" lists names of tissues, shapes, organs, measurements and planes that go.
/// - An entry of these lists whose name is taken changes the fields it gives (null takes a field away; a shape is replaced as a whole);
///   a new entry goes to the end, or directly "before" or "after" the entry named there.
/// - "parameters" and "motion" change field by field, "flow" too, its waves and streams as those lists do; a parameter given as a plain
/// number has that as its default.
/// - Any text that begins with "=" is an expression of the parameters.
/// @error as readPatient, as far as it goes
[[nodiscard]] Result<WholeRecipe> readWholeRecipe(const std::filesystem::path& file, const std::filesystem::path& mannequins,
                                                  const ParameterValues& parameters);

}  // namespace ew::phantom
