#pragma once

#include <string>
#include <string_view>

namespace ew::annotation {

/// Without blanks at both ends, with a blank for each run of blanks, tabs and ends of lines, without other control characters, and at most
/// `longest` bytes, cut in front of a letter rather than within it.
[[nodiscard]] std::string oneLine(std::string_view text, std::size_t longest);

/// Small letters in place of large ones, in ASCII and the letters of Western Europe (U+00C0 to U+00DE): words are found however they are
/// typed. As many bytes as before.
[[nodiscard]] std::string smallLetters(std::string_view text);

}  // namespace ew::annotation
