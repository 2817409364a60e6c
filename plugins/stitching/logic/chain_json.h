#pragma once

#include <nlohmann/json.hpp>

#include "ew/registration/pose_graph.h"
#include "ew/stitching/equalise_views.h"
#include "ew/stitching/join.h"
#include "logic/chain.h"

/// What steps leave on disk, to the last bit: what is read back equals what was written. The ...From functions throw nlohmann's exceptions
/// when a file was damaged.
namespace ew::stitching {

[[nodiscard]] nlohmann::ordered_json jsonOf(const Grid& grid);
[[nodiscard]] Grid gridFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::ordered_json jsonOf(const registration::Agreement& agreement);
[[nodiscard]] nlohmann::ordered_json jsonOf(const std::vector<registration::Level>& levels);
[[nodiscard]] std::vector<registration::Level> levelsFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::ordered_json jsonOf(const PairOutcome& outcome);
[[nodiscard]] PairOutcome pairFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::ordered_json jsonOf(const BentPair& bent);  ///< without the two views it speaks of
[[nodiscard]] BentPair bentFrom(const nlohmann::json& data);
[[nodiscard]] nlohmann::ordered_json jsonOf(const registration::GraphResult& graph);
[[nodiscard]] registration::GraphResult graphFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::ordered_json jsonOf(const std::optional<Beams>& beams);
[[nodiscard]] std::optional<Beams> beamsFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::ordered_json jsonOf(const GreyCorrection& correction);
[[nodiscard]] GreyCorrection correctionFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::ordered_json jsonOf(const JoinReport& report);
[[nodiscard]] JoinReport reportFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::ordered_json jsonOf(const glm::dmat4& matrix);
[[nodiscard]] glm::dmat4 matrixFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::ordered_json jsonOf(const glm::dvec3& v);
[[nodiscard]] glm::dvec3 vectorFrom(const nlohmann::json& json);

}  // namespace ew::stitching
