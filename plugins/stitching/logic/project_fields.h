#pragma once

#include <array>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "logic/project.h"

namespace ew::stitching {

/// A value of the file as an error shows it.
[[nodiscard]] std::string shown(const nlohmann::json& value);
/// @param found, expected as they stand in the sentence "FIELD is FOUND; it must be EXPECTED"
[[nodiscard]] tl::unexpected<Error> badField(const std::string& field, const std::string& found, const std::string& expected);

/// One object of a project file with its place in it. Every read says by name what it does not like; a field that is not there leaves
/// `into` as it is. Lives no longer than the document.
class Fields {
 public:
  /// @param prefix of the names of its fields: "pairs[2]"; empty for the whole file
  Fields(const nlohmann::json& object, std::string prefix) : object_(object), prefix_(std::move(prefix)) {}

  [[nodiscard]] std::string nameOf(const char* field) const { return prefix_.empty() ? field : prefix_ + "." + field; }
  [[nodiscard]] const nlohmann::json* find(const char* field) const;  ///< null when it is not there

  /// @error badField (a field that is none of these)
  [[nodiscard]] Result<void> only(std::initializer_list<const char*> known) const;
  /// @error badField (no number, or not from `least` to `most`)
  [[nodiscard]] Result<void> number(const char* field, double& into, double least, double most, const char* expected) const;
  /// @error badField
  [[nodiscard]] Result<void> yesOrNo(const char* field, bool& into) const;
  /// Empty when it is not there. @error badField (no text, or an empty one)
  [[nodiscard]] Result<std::string> text(const char* field, const char* expected) const;
  /// Three numbers, which have to be there. @error badField
  [[nodiscard]] Result<void> point(const char* field, glm::dvec3& into) const;
  /// A rigid matrix of a field that is there: 16 numbers, or a file of them.
  /// @error badField, notRigid, and what reading the file says
  [[nodiscard]] Result<glm::dmat4> place(const char* field, const std::filesystem::path& folder, sdk::Files& files) const;
  /// A list of objects, or nothing when it is not there. @error badField
  [[nodiscard]] Result<std::vector<Fields>> objects(const char* field, const char* expected) const;
  /// An object, or an empty one when it is not there. @error badField
  [[nodiscard]] Result<Fields> object(const char* field) const;

  /// One of the words that stitching::nameOf gives for `known`. @error badField
  template <class Word, std::size_t n>
  [[nodiscard]] Result<void> word(const char* field, Word& into, const std::array<Word, n>& known) const {
    const nlohmann::json* value = find(field);
    if (value == nullptr) return {};
    std::string expected;
    for (std::size_t i = 0; i < n; ++i) {
      const char* name = stitching::nameOf(known[i]);
      if (*value == name) {
        into = known[i];
        return {};
      }
      expected += std::string(i == 0 ? "" : i + 1 == n ? " or " : ", ") + "\"" + name + "\"";
    }
    return badField(nameOf(field), shown(*value), expected);
  }

 private:
  const nlohmann::json& object_;
  std::string prefix_;
};

}  // namespace ew::stitching
