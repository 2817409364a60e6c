#include <algorithm>
#include <utility>

#include "ew/door/host_parts.h"
#include "ew/library/case.h"

namespace ew::door {
namespace {

constexpr const char* kParts = "parts";
constexpr std::size_t kLongestPartName = 60;

bool isPartName(const std::string& name) {
  const auto isSmall = [](char c) { return c >= 'a' && c <= 'z'; };
  return !name.empty() && name.size() <= kLongestPartName && isSmall(name.front()) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return isSmall(c) || (c >= '0' && c <= '9') || c == '-' || c == '_'; });
}

}  // namespace

Result<sdk::Ticket> PartSchemas::add(const std::string& name, const std::string& schema) {
  if (!isPartName(name))
    return failure(ErrorCode::badUsage, say<"'%1' cannot be a section of a case; it needs small letters, digits, '-' and '_'.">(name));
  if (knows(name))
    return failure(ErrorCode::badUsage, say<"The section '%1' of a case belongs to another plugin; take another name.">(name));
  auto made = PartSchema::of(schema, say<"the schema of the section '%1'">(name));
  if (!made) return passOn(made.error());
  schemas_.emplace(name, std::move(*made));
  return sdk::Ticket(nullptr, [weak = weak_from_this(), name](void*) {
    if (const auto all = weak.lock()) all->schemas_.erase(name);
  });
}

std::vector<Error> PartSchemas::problems(const nlohmann::json& manifest) const {
  std::vector<Error> all;
  for (const auto& [name, schema] : schemas_) {
    const auto section = partOf(manifest, name);
    if (!section) continue;
    auto found = problems(name, *section);
    std::move(found.begin(), found.end(), std::back_inserter(all));
  }
  return all;
}

std::vector<Error> PartSchemas::problems(const std::string& name, const nlohmann::json& section) const {
  const auto schema = schemas_.find(name);
  if (schema == schemas_.end()) return {};
  return schema->second.problems(section, std::string(kParts) + "." + name, verbatim("case.json"));
}

std::vector<Error> PartSchemas::problemsIn(Case edited, const std::filesystem::path& folder) const {
  edited.folder = folder;
  auto all = checkCase(edited);
  auto found = problems(edited.otherFields);
  std::move(found.begin(), found.end(), std::back_inserter(all));
  return all;
}

std::optional<nlohmann::json> partOf(const nlohmann::json& manifest, const std::string& name) {
  if (!manifest.is_object() || !manifest.contains(kParts) || !manifest[kParts].is_object() || !manifest[kParts].contains(name))
    return std::nullopt;
  return manifest[kParts][name];
}

Case withPart(Case edited, const std::string& name, const std::optional<nlohmann::json>& section) {
  nlohmann::json& others = edited.otherFields;
  if (section) {
    others[kParts][name] = *section;
  } else if (partOf(others, name)) {
    others[kParts].erase(name);
    if (others[kParts].empty()) others.erase(kParts);
  }
  return edited;
}

}  // namespace ew::door
