#pragma once

#include "ew/registration/landmarks.h"
#include "ew/registration/pose_graph.h"
#include "ew/registration/rigid.h"
#include "ew/stitching/value_json.h"

/// What registration finds, as it lies on disk, to the last bit. The ...From functions throw nlohmann's exceptions when a file was damaged.
namespace ew::stitching {

[[nodiscard]] nlohmann::ordered_json jsonOf(const registration::Agreement& agreement);
[[nodiscard]] registration::Agreement agreementFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::ordered_json jsonOf(const std::vector<registration::Level>& levels);
[[nodiscard]] std::vector<registration::Level> levelsFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::ordered_json jsonOf(const std::vector<registration::Remark>& remarks);
[[nodiscard]] std::vector<registration::Remark> remarksFrom(const nlohmann::json& json);
[[nodiscard]] registration::Verdict verdictFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::ordered_json jsonOf(const registration::RigidResult& rigid);
[[nodiscard]] registration::RigidResult rigidFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::ordered_json jsonOf(const registration::LandmarkResult& found);
[[nodiscard]] registration::LandmarkResult landmarksFrom(const nlohmann::json& json);
[[nodiscard]] nlohmann::ordered_json jsonOf(const registration::GraphResult& graph);
[[nodiscard]] registration::GraphResult graphFrom(const nlohmann::json& json);

/// What every result says first: a verdict and why. Its sentences are made of the remarks again.
template <class Judged>
void tellVerdict(nlohmann::ordered_json& made, const Judged& result) {
  made["verdict"] = nameOf(result.verdict);
  made["remarks"] = jsonOf(result.remarks);
}
template <class Judged>
void readVerdict(const nlohmann::json& data, Judged& result) {
  result.verdict = verdictFrom(data.at("verdict"));
  result.remarks = remarksFrom(data.at("remarks"));
  result.reason = registration::messageOf(result.remarks);
}

}  // namespace ew::stitching
