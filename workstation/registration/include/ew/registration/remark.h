#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/message.h"

namespace ew::registration {

inline constexpr double kGoodCorrelation = 0.7;  ///< from which on images are said to agree, though it may be over too little

/// What can be said about a result. Behind each the figures of its remark, in order; "agreement" is three of them: correlation, share of
/// overlap, z score (Fisher's z of the correlation times the root of the independent samples: standard deviations above chance). Lengths
/// are in mm, turns in degrees, shares 0..1.
enum class RemarkCode {
  // Of the volumes.
  noEcho,       ///< which: 0 the fixed volume, 1 the moving one
  tooThin,      ///< which, mm of a voxel, 0 or 1: the volume is thick enough, what is covered of it is not
  noStructure,  ///< which
  // Refining from a start.
  apartAtTheStart,
  fewSharedVoxels,
  poseNotHeld,         ///< share of the correlation that is left when it moves, by how many mm; nothing when the equations are singular
  overlapTooSmall,     ///< agreement
  unrelatedNearStart,  ///< agreement
  hardlyBetter,        ///< agreement
  startMayBeFar,       ///< mm between halves, agreement
  halvesAgree,         ///< mm between halves, agreement
  foundAboutTheStart,  ///< mm, degrees from the start: descending had led nowhere
  // Searching without a start.
  noPoseAgrees,         ///< share of overlap asked for
  foundTooSmall,        ///< agreement
  unrelatedEverywhere,  ///< turns tried, agreement
  bestHardlyBetter,     ///< agreement
  twoPosesAlike,        ///< margin, agreement
  halvesContradict,     ///< mm between halves, agreement
  onePoseStandsOut,     ///< margin, mm between halves, agreement
  // Streaks along the beams.
  streaksTakenOut,   ///< mm, degrees they had drawn the volumes away
  onlyStreaksAgree,  ///< agreement without them
  streaksDecide,     ///< mm, degrees the pose lies elsewhere without them
  // Landmarks; names are those of the places, an empty one goes by its number, which then stands at its place behind the figures.
  tooFewPlaces,  ///< how many
  placesRepeat,  ///< numbers of the named
  placesOnALine,
  placesMirrored,
  threePlacesDisagree,  ///< mm
  placesDisagree,       ///< how many agree, of how many
  twoReadings,          ///< how many names belong to the first reading, numbers of the named
  placesAgree,          ///< how many, rms mm
  placesAgreeBut,       ///< how many, rms mm, mm by which the first named does not fit, numbers of the named
  placedByHand,
  // Bending.
  nothingBelieved,
  apartWherePlaced,
  nothingToFollow,
  startKeptGood,
  startKept,
  warpContradicts,      ///< correlation, share of overlap
  warpTooLittleShared,  ///< correlation, share of overlap
  warpAgrees,           ///< correlation, share of overlap, correlation before
  motionRemains,        ///< share of the places that tell, mm there, correlation, share of overlap
  count_                ///< none: how many there are
};
[[nodiscard]] const char* nameOf(RemarkCode what);  ///< a word for files
[[nodiscard]] std::optional<RemarkCode> saysFrom(std::string_view name);

/// One thing that is said about a result, as a code with figures; messageOf makes the sentence.
struct Remark {
  RemarkCode what = RemarkCode::noEcho;
  std::vector<double> figures = {};
  std::vector<std::string> names = {};
  bool operator==(const Remark&) const = default;
  /// 0 where there is none: a remark that was read from a damaged file still can be said.
  [[nodiscard]] double figure(std::size_t n) const { return n < figures.size() ? figures[n] : 0.0; }
};

/// How much of a remark is said.
enum class Wording {
  full,  ///< with every figure and name, for commands and reports
  brief  ///< for a window: figures of agreement stand beside it, and of more than eight names the rest is counted
};
[[nodiscard]] Message messageOf(const Remark& remark, Wording wording = Wording::full);
[[nodiscard]] Message messageOf(const std::vector<Remark>& remarks, Wording wording = Wording::full);  ///< one after the other

}  // namespace ew::registration
