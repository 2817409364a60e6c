#pragma once

#include <QString>

#include "ew/stitching/chain.h"

/// What the libraries say about a result, in the language of the window.
namespace ew::stitching {

/// Figures of agreement are left out: they stand in lines of their own below.
[[nodiscard]] QString sentenceOf(const registration::Remark& remark);
/// @param otherwise what is said when there are no remarks
[[nodiscard]] QString sentencesOf(const std::vector<registration::Remark>& remarks, const std::string& otherwise);

/// Why the whole is not aligned: what is wrong, apart, free or unchecked, by the names of the volumes.
[[nodiscard]] QString reasonOf(const ChainState& found, const StitchProject& asked);

}  // namespace ew::stitching
