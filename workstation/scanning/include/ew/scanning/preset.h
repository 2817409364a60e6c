#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "ew/core/data_file.h"
#include "ew/core/result.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"

namespace ew {

inline constexpr int kPresetFormat = 1;  ///< `format` of a preset; a file with a larger one is refused with newerFormat

/// How the console is set for an examination with a probe: resources/presets/*.json, resources/schemas/preset.schema.json, and files of the
/// user's own.
struct Preset {
  std::string id;            ///< file name without ending: "abdomen-convex-3.5"
  Words title;               ///< the examination: "Abdomen"; of a user's own both languages say the same
  std::string probe;         ///< id
  Knobs knobs;               ///< as they are set; `quality` is the machine's and stays out of it
  std::string annotations;   ///< id of its word list; empty: that of the case's region
  std::string bodyMark;      ///< id; empty: the one where the probe is
  std::string measurements;  ///< id of its measurement package; empty: none
  std::string source;        ///< why it is set so
  bool operator==(const Preset&) const = default;
};

/// @param where how sentences name the document
/// @error badField, newerFormat
[[nodiscard]] Result<Preset> presetFromJson(const nlohmann::json& document, const std::string& id, const Message& where);
/// Without the id, and of the knobs what differs from the default: presetFromJson(toJson(p), p.id, where) == p.
[[nodiscard]] nlohmann::json toJson(const Preset& preset);
/// @error notFound, notReadable, tooLarge (above 4 MiB), badHeader (not JSON), otherwise as presetFromJson
[[nodiscard]] Result<Preset> readPreset(const std::filesystem::path& file);
/// Every preset of a folder, by id; a file that cannot be read is an error, not a gap.
[[nodiscard]] Result<std::vector<Preset>> readPresets(const std::filesystem::path& folder);

/// Whether the probe is there and can be set so: depth, frequency, steering, trapezoid, foci.
/// @error badField, each with the value found and the values expected
[[nodiscard]] Result<void> checkPreset(const Preset& preset, const std::vector<Probe>& probes);

/// The probes that may be used, in the order of `ids`; all when there are none.
[[nodiscard]] std::vector<Probe> usableOf(const std::vector<std::string>& ids, const std::vector<Probe>& probes);
/// The preset that a scan begins with: the first of `ids` that is among `presets`, is for one of `usable` and can be set. Presets earlier
/// in the list win over later ones of the same id.
/// @return null when there is none: the scan begins with neutral settings
[[nodiscard]] const Preset* startPreset(const std::vector<std::string>& ids, const std::vector<Preset>& presets,
                                        const std::vector<Probe>& usable);

/// The console with the preset on it: all but the quality of the machine.
[[nodiscard]] Knobs applied(const Preset& preset, const Knobs& present);
/// The console as a preset of that probe; quality, zoom and M-mode stay out of it.
[[nodiscard]] Preset presetOf(const std::string& title, const Probe& probe, const Knobs& knobs);

/// $ECHOWEAVE_PRESETS, or ~/EchoWeave/presets. It need not be there.
[[nodiscard]] std::filesystem::path ownPresetsFolder();

/// What the user keeps. One file that is damaged takes nothing from the others.
struct OwnPresets {
  std::vector<Preset> presets;  ///< by title
  std::vector<Error> problems;  ///< of files that are none
};
/// Nothing when the folder is not there.
[[nodiscard]] OwnPresets readOwnPresets(const std::filesystem::path& folder);

/// The presets of the program, then the user's own; those of the user that cannot be read are left out.
/// @param resources the program's folder of them all
/// @error as readPresets
[[nodiscard]] Result<std::vector<Preset>> presetsThere(const std::filesystem::path& resources);

/// Writes it into the folder, which is made; its file is named after title and probe, and no other preset's file is written over. One of
/// the same title and probe is replaced. Such a file can be handed on: whoever puts it into his folder has it.
/// @return the file @error badField (a title without a letter or digit, or longer than 80 bytes), notWritable
[[nodiscard]] Result<std::filesystem::path> saveOwnPreset(const Preset& preset, const std::filesystem::path& folder);

}  // namespace ew
