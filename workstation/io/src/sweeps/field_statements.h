#pragma once

#include <functional>
#include <optional>
#include <string>

#include "ew/core/result.h"
#include "ew/io/sequence.h"
#include "files/header_fields.h"

namespace ew::detail {

/// What a DeviceSet takes from the attributes of VolumeReconstruction; the clip and the fan also from the header of a recording.
enum class SetField { spacing, clipOrigin, clipSize, fanAngles, fanOrigin, fanStart, fanStop, interpolation, compounding, reference };

/// Who states the fields, and how they are looked up and refused.
struct FieldStatements {
  bool isRecording = false;                                                 ///< a recording's header, not a device set
  std::function<std::optional<std::string>(const std::string&)> look = {};  ///< the text of a field by its name; empty: there is none
  std::function<Error(const std::string& name, const std::string& found, const Message& needed)> refusal = {};
};

/// Takes one field into `set`. Every field passes here, so that each is told apart in one way: one that is absent changes nothing, one that
/// sets nothing is named in the set's notes with what was found and what holds without it, one that cannot be used is refused.
/// @return absent, notSet or value
/// @error that of `from.refusal`
[[nodiscard]] Result<FieldState> takeField(SetField field, const FieldStatements& from, DeviceSet& set);

}  // namespace ew::detail
