#pragma once

#include <string_view>
#include <vector>

#include "ew/core/message.h"
#include "ew/measurement/worksheet.h"

namespace ew::measurement {

/// What a row of a worksheet says, in window and on paper alike.
struct WorksheetLine {
  Message title;                 ///< with its side
  Message value;                 ///< or the answer; "–" when there is none
  std::vector<Message> origin;   ///< measured several times, by a formula, from other rows; remarks
  std::vector<Message> against;  ///< usual ranges and charts, with what they say of the value
};
/// @param language of titles: "en", "de"
[[nodiscard]] WorksheetLine lineOf(const WorksheetRow& row, std::string_view language = "en");

}  // namespace ew::measurement
