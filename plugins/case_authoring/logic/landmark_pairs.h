#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ew/library/placing.h"

namespace ew::case_authoring {

/// The section of a case in which pairs of places are kept, so that work on a placement can go on later.
inline constexpr const char* kPlacingPart = "placing";
[[nodiscard]] std::string placingSchema();

/// The same place in the volume and on the body; one side may still be missing.
struct DraftPair {
  std::string name;  ///< the author's; may be empty
  std::optional<glm::dvec3> file_mm = {};
  std::optional<glm::dvec3> world_mm = {};
  std::string landmark = {};  ///< of the mannequin (BodyLandmark::id), when its place on the body comes from there
  [[nodiscard]] bool isComplete() const { return file_mm && world_mm; }
  bool operator==(const DraftPair&) const = default;
};

/// Of a section; what is no pair is left out.
[[nodiscard]] std::vector<DraftPair> pairsIn(const std::optional<nlohmann::json>& section);
/// The section with these pairs, its other fields as they were; nothing when nothing is left of it.
[[nodiscard]] std::optional<nlohmann::json> withPairs(std::optional<nlohmann::json> section, std::span<const DraftPair> pairs);

/// What the complete pairs say.
struct PairsFit {
  Result<LandmarkFit> fit;
  std::vector<std::optional<double>> residuals_mm;  ///< one per draft; of incomplete ones, and without a fit, nothing
  std::size_t complete = 0;
  std::optional<std::size_t> wrong = {};  ///< of the drafts
  std::optional<std::size_t> worst = {};  ///< of the drafts, where there is a fit
};
[[nodiscard]] PairsFit fitOf(std::span<const DraftPair> pairs);

}  // namespace ew::case_authoring
