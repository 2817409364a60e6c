#include "logic/edits.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "ew/core/frames.h"
#include "ew/library/echoes_field.h"

namespace ew::case_authoring {

CaseText fieldAt(std::string Case::*text) {
  return {[text](const Case& shown) { return shown.*text; },
          [text](Case edited, std::string value) {
            edited.*text = std::move(value);
            return edited;
          }};
}

CaseText fieldAt(std::string CasePatient::*text) {
  return {[text](const Case& shown) { return shown.patient.*text; },
          [text](Case edited, std::string value) {
            edited.patient.*text = std::move(value);
            return edited;
          }};
}

CaseText fieldAt(std::string RecordingRights::*text) {
  return {[text](const Case& shown) { return rightsOf(shown).*text; },
          [text](Case edited, std::string value) {
            RecordingRights rights = rightsOf(edited);
            rights.*text = std::move(value);
            return withRights(std::move(edited), rights);
          }};
}

CaseTexts fieldAt(std::vector<std::string> Case::*texts) {
  return {[texts](const Case& shown) { return shown.*texts; },
          [texts](Case edited, std::vector<std::string> values) {
            edited.*texts = std::move(values);
            return edited;
          }};
}

std::vector<std::string> withListed(std::vector<std::string> ids, const std::string& id, bool listed) {
  const bool isListed = std::find(ids.begin(), ids.end(), id) != ids.end();
  if (isListed == listed) return ids;
  if (listed)
    ids.push_back(id);
  else
    std::erase(ids, id);
  return ids;
}

std::string linesOf(const std::vector<std::string>& texts) {
  std::string lines;
  for (const std::string& one : texts) lines += (lines.empty() ? "" : "\n") + one;
  return lines;
}

std::vector<std::string> textsIn(const std::string& lines) {
  std::vector<std::string> texts;
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);)
    if (line.find_first_not_of(" \t\r") != std::string::npos) texts.push_back(line);
  return texts;
}

Case withStartPose(Case edited, const std::optional<Transform<frame::World, frame::Probe>>& probeToWorld) {
  edited.startPose.reset();
  if (probeToWorld) edited.startPose.emplace().probeToWorld = *probeToWorld;
  return edited;
}

Case withVolumeGiven(Case present, const Case& given) {
  present.volume = given.volume;
  present.targets = given.targets;
  present.measurements = given.measurements;
  // A recording has its own.
  if (!given.scene.attenuation) present.scene.attenuation.reset();
  if (!given.scene.reverberation) present.scene.reverberation.reset();
  // Rights and the probe's side are said of the volume, and stand beside it.
  if (given.otherFields.contains("volume"))
    present.otherFields["volume"] = given.otherFields["volume"];
  else
    present.otherFields.erase("volume");
  return withoutEchoes(std::move(present));
}

bool seesVolume(const sdk::Cases::Scan& scan, const Transform<frame::World, frame::Probe>& probeToWorld) {
  constexpr double kDepthStep_mm = 4.0;
  constexpr int kLines = 17;
  const auto probeToVoxel = scan.volume.worldToVoxel() * probeToWorld;
  const bool isFan = scan.halfWidth_rad > 0.0;
  // Lines of a fan meet this far behind the face.
  const double radius_mm = isFan ? scan.halfFace_mm / std::sin(scan.halfWidth_rad) : 0.0;
  for (int line = 0; line < kLines; ++line) {
    const double across = 2.0 * line / (kLines - 1) - 1.0;
    const double angle_rad = across * scan.halfWidth_rad;
    for (double depth_mm = 0.0; depth_mm <= scan.depth_mm; depth_mm += kDepthStep_mm) {
      const glm::dvec3 p_probe =
          isFan ? glm::dvec3((radius_mm + depth_mm) * std::sin(angle_rad), (radius_mm + depth_mm) * std::cos(angle_rad) - radius_mm, 0.0)
                : glm::dvec3(across * scan.halfFace_mm, depth_mm, 0.0);
      const glm::dvec3 p_voxel = carried(probeToVoxel, p_probe);
      if (glm::all(glm::greaterThanEqual(p_voxel, glm::dvec3(-0.5))) &&
          glm::all(glm::lessThan(p_voxel, glm::dvec3(scan.volume.dims) - 0.5)))
        return true;
    }
  }
  return false;
}

std::string fieldOf(const Error& problem) {
  for (const auto& [name, value] : problem.context)
    if (name == "field") return value.substr(0, value.find('['));
  return {};
}

}  // namespace ew::case_authoring
