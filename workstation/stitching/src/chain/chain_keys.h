#pragma once

#include <array>
#include <string>
#include <vector>

#include "chain/chain_inputs.h"
#include "ew/io/content_key.h"

namespace ew::stitching {

// Part of a step's key: raise it when the step starts to give another result for the same inputs.
inline constexpr int kInputFormat = 2;
inline constexpr int kPairFormat = 3;
inline constexpr int kGraphFormat = 2;
inline constexpr int kEqualiseFormat = 2;
inline constexpr int kWarpFormat = 2;
inline constexpr int kSeamFormat = 2;
inline constexpr int kVolumeFormat = 2;

/// Begins the key of something the chain makes: its name, its format and the program's version.
[[nodiscard]] ContentKey newKey(const char* what, int format);

/// Whether a volume lies exactly where it was recorded, so that nothing moves it.
[[nodiscard]] bool isExact(const StitchProject& project, std::size_t v);

/// One pair of the project: what it asks for and under which key its answer lies.
struct Candidate {
  std::size_t fixed = 0;
  std::size_t moving = 0;
  Decision decision = Decision::undecided;
  PairTask task;
  std::string key;  ///< of everything the answer depends on and nothing else, so that an undone edit finds it again
};
/// The pairs that are worth a look, in order: those a person spoke about, those whose places may overlap, all with an unknown place.
/// @param inputs identified
[[nodiscard]] std::vector<Candidate> candidatesOf(const StitchProject& project, const ChainInputs& inputs);

/// The keys of the steps: each of everything it depends on.
struct Keys {
  std::array<std::string, kSteps.size()> of;
  [[nodiscard]] const std::string& operator[](Step step) const { return of[static_cast<std::size_t>(step)]; }
  std::string& operator[](Step step) { return of[static_cast<std::size_t>(step)]; }
};
[[nodiscard]] Keys keysOf(const StitchProject& project, const ChainOptions& options, const ChainInputs& inputs,
                          const std::vector<Candidate>& pairs);

/// Of one pair that is warped from the poses of the graph.
/// @param start fixedToMoving
[[nodiscard]] std::string keyOfWarp(const ChainInput& fixed, const ChainInput& moving, const Transform<frame::Moving, frame::Fixed>& start,
                                    registration::ElasticEffort effort);

}  // namespace ew::stitching
