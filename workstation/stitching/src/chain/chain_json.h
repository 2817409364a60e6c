#pragma once

#include "chain/registration_json.h"
#include "ew/stitching/chain.h"
#include "ew/stitching/equalise_views.h"
#include "ew/stitching/join.h"

/// What steps leave on disk, to the last bit: what is read back equals what was written. The ...From functions throw nlohmann's exceptions
/// when a file was damaged.
namespace ew::stitching {

[[nodiscard]] nlohmann::ordered_json jsonOf(const PairOutcome& outcome);
[[nodiscard]] PairOutcome pairFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::ordered_json jsonOf(const PairDeformation& warped);  ///< without the two views it speaks of
[[nodiscard]] PairDeformation warpedFrom(const nlohmann::json& data);
[[nodiscard]] nlohmann::ordered_json jsonOf(const std::optional<Beams>& beams);
[[nodiscard]] std::optional<Beams> beamsFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::ordered_json jsonOf(const GreyCorrection& correction);
[[nodiscard]] GreyCorrection correctionFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::ordered_json jsonOf(const JoinReport& report);
[[nodiscard]] JoinReport reportFrom(const nlohmann::json& json);

}  // namespace ew::stitching
