#include "ew/registration/remark.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "ew/core/numbers.h"

namespace ew::registration {
namespace {

constexpr std::array<const char*, static_cast<std::size_t>(Says::count_)> kNames = {"no echo",
                                                                                    "too thin",
                                                                                    "no structure",
                                                                                    "apart at the start",
                                                                                    "few shared voxels",
                                                                                    "pose not held",
                                                                                    "overlap too small",
                                                                                    "unrelated near start",
                                                                                    "hardly better",
                                                                                    "start may be far",
                                                                                    "halves agree",
                                                                                    "found about the start",
                                                                                    "no pose agrees",
                                                                                    "found too small",
                                                                                    "unrelated everywhere",
                                                                                    "best hardly better",
                                                                                    "two poses alike",
                                                                                    "halves contradict",
                                                                                    "one pose stands out",
                                                                                    "streaks taken out",
                                                                                    "only streaks agree",
                                                                                    "streaks decide",
                                                                                    "too few places",
                                                                                    "places repeat",
                                                                                    "places on a line",
                                                                                    "places mirrored",
                                                                                    "three places disagree",
                                                                                    "places disagree",
                                                                                    "two readings",
                                                                                    "places agree",
                                                                                    "places agree but",
                                                                                    "placed by hand",
                                                                                    "nothing believed",
                                                                                    "apart where placed",
                                                                                    "nothing to follow",
                                                                                    "start kept, good",
                                                                                    "start kept",
                                                                                    "bend contradicts",
                                                                                    "bend shares too little",
                                                                                    "bend agrees",
                                                                                    "motion is left"};

std::string withDigits(double value, int digits) {
  if (!std::isfinite(value)) return "any amount";
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}
std::string millimetres(double mm) { return std::isfinite(mm) ? withDigits(mm, 1) + " mm" : "any distance"; }
/// As people write who measured with a ruler: no zero behind the point.
std::string plainMillimetres(double mm) { return std::isfinite(mm) ? textOf(std::round(mm * 10.0) / 10.0) + " mm" : "any distance"; }
std::string percent(double share) { return withDigits(100.0 * share, 0) + " %"; }
std::string whole(double count) { return withDigits(count, 0); }

/// "correlation 0.82 over 12 % overlap, 33.1 deviations above chance"
std::string agreementOf(const Remark& remark, std::size_t first) {
  return "correlation " + withDigits(remark.figure(first), 2) + " over " + percent(remark.figure(first + 1)) + " overlap, " +
         withDigits(remark.figure(first + 2), 1) + " deviations above chance";
}

/// Of names [from, to), whose numbers stand from figure `numbers` on.
std::string listOf(const Remark& remark, std::size_t from, std::size_t to, std::size_t numbers) {
  std::string text;
  to = std::min(to, remark.names.size());
  for (std::size_t n = from; n < to; ++n) {
    if (n > from) text += n + 1 == to ? " and " : ", ";
    text += remark.names[n].empty() ? "number " + whole(remark.figure(numbers + n)) : "'" + remark.names[n] + "'";
  }
  return text;
}
std::string listOf(const Remark& remark, std::size_t numbers) { return listOf(remark, 0, remark.names.size(), numbers); }

std::string bentOver(const Remark& remark) {
  return "a correlation of " + withDigits(remark.figure(0), 2) + " over " + percent(remark.figure(1)) + " of the smaller volume";
}

}  // namespace

const char* nameOf(Says what) { return what < Says::count_ ? kNames[static_cast<std::size_t>(what)] : ""; }

std::optional<Says> saysFrom(std::string_view name) {
  const auto at = std::find(kNames.begin(), kNames.end(), name);
  if (at == kNames.end()) return std::nullopt;
  return static_cast<Says>(at - kNames.begin());
}

std::string sentenceOf(const Remark& remark) {
  const auto agreement = [&](std::size_t first) { return " (" + agreementOf(remark, first) + ")"; };
  const auto volume = [&] { return std::string("The ") + (remark.figure(0) == 0.0 ? "fixed" : "moving") + " volume "; };
  switch (remark.what) {
    case Says::noEcho:
      return volume() + "holds no echo.";
    case Says::tooThin:
      if (remark.figure(2) != 0.0)
        return volume() + "covers nothing as thick as three voxels of " + withDigits(remark.figure(1), 1) +
               " mm. Where no coverage is given, black that reaches the border counts as outside: give the coverage that reconstruct "
               "wrote.";
      return volume() + "is too thin to be registered in three dimensions: it takes three voxels of " + withDigits(remark.figure(1), 1) +
             " mm in every direction.";
    case Says::noStructure:
      return volume() + "shows no structure: it is the same grey nearly everywhere.";
    case Says::apartAtTheStart:
      return "The two volumes do not overlap at the start: bring them closer, or match without a start.";
    case Says::fewSharedVoxels:
      return "The overlap is too small to register: fewer than 50 voxels are covered by both volumes.";
    case Says::poseNotHeld:
      if (remark.figure(0) > 0.0)
        return "The overlap does not hold the pose: moved by " + millimetres(remark.figure(1)) +
               " along or about what holds it least, the images still agree " + percent(remark.figure(0)) + " as well.";
      return "The overlap does not hold the pose: the normal equations are singular.";
    case Says::overlapTooSmall:
      return "The overlap is too small to tell" + agreement(0) + ".";
    case Says::unrelatedNearStart:
      return "Near this start the images agree no better than unrelated tissue does" + agreement(0) + ".";
    case Says::hardlyBetter:
      return "The images agree hardly better than unrelated tissue does" + agreement(0) + ".";
    case Says::startMayBeFar:
      return "Halves of the overlap registered apart contradict each other by " + millimetres(remark.figure(0)) + agreement(1) +
             ": the start may be too far off.";
    case Says::halvesAgree:
      return "Halves of the overlap registered apart agree to " + millimetres(remark.figure(0)) + agreement(1) + ".";
    case Says::foundAboutTheStart:
      return "Descending from the start led nowhere; a search about it found a pose " + millimetres(remark.figure(0)) + " and " +
             withDigits(remark.figure(1), 1) + " degrees from it.";
    case Says::noPoseAgrees:
      return "No pose brings the two volumes into agreement over " + percent(remark.figure(0)) + " overlap.";
    case Says::foundTooSmall:
      return "The overlap found is too small to tell it from chance" + agreement(0) + ".";
    case Says::unrelatedEverywhere:
      return "The best of " + whole(remark.figure(0)) + " turns with all shifts agrees no better than unrelated tissue does" +
             agreement(1) + ".";
    case Says::bestHardlyBetter:
      return "The best pose agrees hardly better than unrelated tissue does" + agreement(0) + ".";
    case Says::twoPosesAlike:
      return "Two different poses agree almost equally (margin " + withDigits(remark.figure(0), 2) +
             "): the structure repeats, a close start or landmarks must choose" + agreement(1) + ".";
    case Says::halvesContradict:
      return "Halves of the overlap registered apart contradict each other by " + millimetres(remark.figure(0)) + agreement(1) + ".";
    case Says::onePoseStandsOut:
      return "One pose stands out by a margin of " + withDigits(remark.figure(0), 1) +
             ", and halves of the overlap registered apart agree to " + millimetres(remark.figure(1)) + agreement(2) + ".";
    case Says::streaksTakenOut:
      return "Shadows and other streaks were taken out, which drew the volumes " + millimetres(remark.figure(0)) + " and " +
             withDigits(remark.figure(1), 1) + " degrees elsewhere.";
    case Says::onlyStreaksAgree:
    case Says::streaksDecide: {
      const std::string why = "What agrees are mostly streaks, such as shadows along the beam, which turn with the probe: ";
      if (remark.what == Says::onlyStreaksAgree)
        return why + "without them the volumes agree hardly better than unrelated tissue does" + agreement(0) + ".";
      return why + "without them the pose lies " + millimetres(remark.figure(0)) + " and " + withDigits(remark.figure(1), 1) +
             " degrees elsewhere. A tracker, landmarks or the direction of the beams can decide.";
    }
    case Says::tooFewPlaces: {
      const double count = remark.figure(0);
      return std::string(count == 0.0   ? "There is no pair of landmarks"
                         : count == 1.0 ? "One place is too few"
                                        : "Two places are too few") +
             ": a turn needs three places that are not on one line.";
    }
    case Says::placesRepeat:
      return listOf(remark, 0) + (remark.names.size() == 1 ? " repeats" : " repeat") + " the place of an earlier pair.";
    case Says::placesOnALine:
      return "The places lie on one line, so that the turn about it is free: add a pair beside the line.";
    case Says::placesMirrored:
      return "The places in one volume are the mirror image of those in the other: left and right were confused when they were picked, or "
             "one file is mirrored.";
    case Says::threePlacesDisagree:
      return "The three pairs contradict each other by " + plainMillimetres(remark.figure(0)) +
             ", and three cannot say which of them is wrong: correct one or add a fourth.";
    case Says::placesDisagree:
      return "The pairs contradict each other: no rigid transform brings more than " + whole(remark.figure(0)) + " of " +
             whole(remark.figure(1)) + " together. Pick them again.";
    case Says::twoReadings: {
      const auto first = static_cast<std::size_t>(std::max(0.0, remark.figure(0)));
      return "One can read the pairs in two ways: without " + listOf(remark, 0, first, 1) + ", or without " +
             listOf(remark, first, remark.names.size(), 1) + ". Add a pair or correct one.";
    }
    case Says::placesAgree:
      return whole(remark.figure(0)) + " pairs agree within " + plainMillimetres(remark.figure(1)) + " (rms).";
    case Says::placesAgreeBut:
      return whole(remark.figure(0)) + " pairs agree within " + plainMillimetres(remark.figure(1)) + " (rms); " + listOf(remark, 3) +
             (remark.names.size() == 1 ? " does" : " do") + " not fit, by " + plainMillimetres(remark.figure(2)) + ".";
    case Says::placedByHand:
      return "Placed by hand.";
    case Says::nothingBelieved:
      return "One of the volumes has no part that may be believed.";
    case Says::apartWherePlaced:
      return "The volumes do not overlap where they were placed; place them, or match them first.";
    case Says::nothingToFollow:
      return "The overlap shows no structure that could be followed: the normal equations are singular.";
    case Says::startKeptGood:
      return "No bending brought the volumes closer than they were; the start is kept.";
    case Says::startKept:
      return "No bending brought the volumes together; the start is kept.";
    case Says::bendContradicts:
      return "The volumes contradict each other: bent, they reach " + bentOver(remark) + ", which unrelated tissue reaches as well.";
    case Says::bendTooLittleShared:
      return "Too little structure is shared to tell: bent, the volumes reach " + bentOver(remark) + ".";
    case Says::bendAgrees:
      return "The volumes agree: " + bentOver(remark) + ", " + withDigits(remark.figure(2), 2) + " before.";
    case Says::motionIsLeft:
      return "Motion is left that the bend does not follow: at " + percent(remark.figure(0)) +
             " of the places that can tell, tissue lies elsewhere, by " + millimetres(remark.figure(1)) + " in the mean (bent, " +
             bentOver({remark.what, {remark.figure(2), remark.figure(3)}}) + ").";
    case Says::count_:
      break;
  }
  return {};
}

std::string sentencesOf(const std::vector<Remark>& remarks) {
  std::string text;
  for (const Remark& remark : remarks) text += (text.empty() ? "" : " ") + sentenceOf(remark);
  return text;
}

}  // namespace ew::registration
