#pragma once

#include <string>
#include <string_view>

namespace ew {

/// A text of others (titles, names of files, what a server said) as it may be written to a terminal: a control character, which could move
/// the cursor, hide or overwrite what stands there or set the terminal's title (C0 but for the end of a line and the tabulator, DEL, C1
/// also as UTF-8), and each byte that is no UTF-8, becomes U+FFFD. The carriage return of "\r\n" is left out. All else stays as it is.
[[nodiscard]] std::string printable(std::string_view text);

/// The same on one line: ends of lines and tabulators become spaces, so that a title cannot pretend to be a line of its own.
[[nodiscard]] std::string printableLine(std::string_view text);

/// How many bytes of `text`, taken from its end, are the beginning of a character of UTF-8 whose rest has not come yet: 0 to 3.
[[nodiscard]] std::size_t unfinishedBytes(std::string_view text);

}  // namespace ew
