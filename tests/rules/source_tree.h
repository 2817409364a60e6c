#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace ew::rules {

/// One .cpp or .h of workstation/ or plugins/.
struct Source {
  std::string path;  ///< from the top of the tree: "workstation/core/src/pose.cpp"
  std::string text;
};

/// All of them, sorted by path; read once.
[[nodiscard]] const std::vector<Source>& sources();

/// The same text with comments, and with what stands between quotation marks, as spaces; lines and columns stay. The marks stay too, so
/// that `.value("` can be looked for, and no rule trips over a word in a comment or a sentence.
[[nodiscard]] std::string codeOf(std::string_view text);

/// That of a source; kept for those of the tree, so that many rules read them once. Valid until the next call.
[[nodiscard]] const std::string& codeOf(const Source& source);

/// A line that breaks a rule.
struct Offence {
  std::string path;
  int line = 0;      ///< from 1
  std::string what;  ///< the line as it stands, without the spaces around it
  bool operator==(const Offence&) const = default;
};

/// Why a file may break a rule all the same.
struct Exception {
  std::string path;    ///< as in Source; a folder when it ends in "/", all files whose names begin so when it ends in "_"
  std::string reason;  ///< a sentence
};

/// The lines of a source whose code has a match of the ECMAScript expression.
[[nodiscard]] std::vector<Offence> matchesOf(const Source& source, const std::string& expression);

/// A rule over one source.
using Rule = std::function<std::vector<Offence>(const Source&)>;

/// What breaks the rule in the whole tree, one line each, and which exceptions nothing needs any more; empty when all is well.
/// @param instead what to do about it: "parse it with parseJson() of ew/core/json_fields.h"
[[nodiscard]] std::string brokenBy(const Rule& rule, const std::vector<Exception>& exceptions, const std::string& instead);

}  // namespace ew::rules
