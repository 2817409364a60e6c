#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ew {

/// A text cut into words, runs of digits and single other characters; white space lies between pieces.
struct TextPiece {
  enum class Kind { word, digits, mark };
  Kind kind = Kind::mark;
  std::string_view text;
  std::size_t at = 0;    ///< byte in the text
  bool isApart = false;  ///< white space before it
  [[nodiscard]] bool is(std::string_view other) const { return text == other; }
  [[nodiscard]] std::size_t end() const { return at + text.size(); }
};

/// Bytes beyond ASCII count as letters: nothing here depends on which ones they are.
[[nodiscard]] std::vector<TextPiece> piecesOf(std::string_view text);

/// The value of a run of at most nine digits; -1 for a longer one.
[[nodiscard]] long valueOf(const TextPiece& digits);

/// Whether a word begins with a capital, also one beyond ASCII.
[[nodiscard]] bool isCapitalised(std::string_view word);

/// ASCII letters small, others as they are.
[[nodiscard]] std::string inSmallLetters(std::string_view text);

}  // namespace ew
