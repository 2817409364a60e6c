#include "ew/registration/remark.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/core/figures.h"
#include "ew/core/numbers.h"
#include "listed.h"

namespace ew::registration {
namespace {

constexpr std::array<const char*, static_cast<std::size_t>(RemarkCode::count_)> kNames = {"no echo",
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

Message decimal(double value, int digits) { return std::isfinite(value) ? fixedNumeral(value, digits) : say<"any amount">(); }
Message millimetres(double mm) { return std::isfinite(mm) ? say<"%1 mm">(decimal(mm, 1)) : say<"any distance">(); }
/// As people write who measured with a ruler: no zero behind the point.
Message plainMillimetres(double mm) { return std::isfinite(mm) ? say<"%1 mm">(numeral(roundedText(mm, 1))) : say<"any distance">(); }
Message percent(double share) { return say<"%1 %">(decimal(100.0 * share, 0)); }
Message whole(double count) { return decimal(count, 0); }

/// " (correlation 0.82 over 12 % overlap, z score 33.1)", behind what it is said of; nothing when brief.
Message agreementOf(const Remark& remark, std::size_t first, Wording wording) {
  if (wording == Wording::brief) return {};
  return joined(
      {verbatim(" "), say<"(correlation %1 over %2 overlap, z score %3)">(
                          decimal(remark.figure(first), 2), percent(remark.figure(first + 1)), decimal(remark.figure(first + 2), 1))},
      "");
}

/// Whether a pair that is not sure enough correlates as well as sure ones do: then it is not the agreement that is small, but what it was
/// found over. The z score grows with both.
bool agreesWell(const Remark& remark, std::size_t first) { return remark.figure(first) >= kGoodCorrelation; }

/// Of names [from, to), whose numbers stand from figure `numbers` on.
Message namesOf(const Remark& remark, std::size_t from, std::size_t to, std::size_t numbers, Wording wording) {
  std::vector<Message> names;
  for (std::size_t n = from; n < std::min(to, remark.names.size()); ++n)
    names.push_back(remark.names[n].empty() ? say<"number %1">(whole(remark.figure(numbers + n))) : say<"'%1'">(remark.names[n]));
  return listed(std::move(names), wording == Wording::brief ? kMostNames : remark.names.size());
}
Message namesOf(const Remark& remark, std::size_t numbers, Wording wording) {
  return namesOf(remark, 0, remark.names.size(), numbers, wording);
}

Message warpedOver(double correlation, double share) {
  return say<"a correlation of %1 over %2 of the smaller volume">(decimal(correlation, 2), percent(share));
}

Message ofVolume(const Remark& remark) {
  const bool fixed = remark.figure(0) == 0.0;
  const Message voxel = decimal(remark.figure(1), 1);
  switch (remark.what) {
    case RemarkCode::noEcho:
      return fixed ? say<"The fixed volume holds no echo.">() : say<"The moving volume holds no echo.">();
    case RemarkCode::tooThin:
      if (remark.figure(2) != 0.0)
        return fixed ? say<"The fixed volume covers nothing as thick as three voxels of %1 mm. Where no coverage is given, black that "
                           "reaches the border counts as outside: give the coverage that reconstruct wrote.">(voxel)
                     : say<"The moving volume covers nothing as thick as three voxels of %1 mm. Where no coverage is given, black that "
                           "reaches the border counts as outside: give the coverage that reconstruct wrote.">(voxel);
      return fixed ? say<"The fixed volume is too thin to be registered in three dimensions: it takes three voxels of %1 mm in every "
                         "direction.">(voxel)
                   : say<"The moving volume is too thin to be registered in three dimensions: it takes three voxels of %1 mm in every "
                         "direction.">(voxel);
    case RemarkCode::noStructure:
      return fixed ? say<"The fixed volume shows no structure: it is the same grey nearly everywhere.">()
                   : say<"The moving volume shows no structure: it is the same grey nearly everywhere.">();
    default:
      return {};
  }
}

Message ofRefining(const Remark& remark, Wording wording) {
  const auto agreement = [&](std::size_t first) { return agreementOf(remark, first, wording); };
  switch (remark.what) {
    case RemarkCode::apartAtTheStart:
      return say<"The two volumes do not overlap at the start: bring them closer, or match without a start.">();
    case RemarkCode::fewSharedVoxels:
      return say<"The overlap is too small to register: fewer than 50 voxels are covered by both volumes.">();
    case RemarkCode::poseNotHeld:
      if (remark.figure(0) > 0.0)
        return say<
            "The overlap does not hold the pose: moved by %1 along or about what holds it least, the images still agree %2 as "
            "well.">(millimetres(remark.figure(1)), percent(remark.figure(0)));
      return say<"The overlap does not hold the pose: the normal equations are singular.">();
    case RemarkCode::overlapTooSmall:
      return say<"The overlap shows too little structure to tell%1; record more overlap, or give landmarks or a tracker's pose.">(
          agreement(0));
    case RemarkCode::unrelatedNearStart:
      return say<"Near this start the images agree no better than unrelated tissue does%1.">(agreement(0));
    case RemarkCode::hardlyBetter:
      return agreesWell(remark, 0)
                 ? say<"The images agree, but the overlap shows too little structure to rule out chance%1; look whether they fit, or give "
                       "landmarks, a tracker's pose or more overlap.">(agreement(0))
                 : say<"The images agree in part, and too little to rule out chance%1; look whether they fit, or give landmarks, a "
                       "tracker's pose or more overlap.">(agreement(0));
    case RemarkCode::startMayBeFar:
      return say<"Halves of the overlap registered apart contradict each other by %1%2: the start may be too far off.">(
          millimetres(remark.figure(0)), agreement(1));
    case RemarkCode::halvesAgree:
      return say<"Halves of the overlap registered apart agree to %1%2.">(millimetres(remark.figure(0)), agreement(1));
    case RemarkCode::foundAboutTheStart:
      return say<"Descending from the start led nowhere; a search about it found a pose %1 and %2 degrees from it.">(
          millimetres(remark.figure(0)), decimal(remark.figure(1), 1));
    default:
      return {};
  }
}

Message ofSearching(const Remark& remark, Wording wording) {
  const auto agreement = [&](std::size_t first) { return agreementOf(remark, first, wording); };
  switch (remark.what) {
    case RemarkCode::noPoseAgrees:
      return say<"No pose brings the two volumes into agreement over %1 overlap.">(percent(remark.figure(0)));
    case RemarkCode::foundTooSmall:
      return say<
          "The overlap found shows too little structure to rule out chance%1; record more overlap, or give landmarks or a tracker's "
          "pose.">(agreement(0));
    case RemarkCode::unrelatedEverywhere:
      return say<"The best of %1 turns with all shifts agrees no better than unrelated tissue does%2.">(whole(remark.figure(0)),
                                                                                                        agreement(1));
    case RemarkCode::bestHardlyBetter:
      return agreesWell(remark, 0)
                 ? say<"In the best pose the images agree, but the overlap shows too little structure to rule out chance%1; look whether "
                       "they fit, or give landmarks, a tracker's pose or more overlap.">(agreement(0))
                 : say<"In the best pose the images agree in part, and too little to rule out chance%1; look whether they fit, or give "
                       "landmarks, a tracker's pose or more overlap.">(agreement(0));
    case RemarkCode::twoPosesAlike:
      return say<"Two different poses agree almost equally (margin %1): the structure repeats, a close start or landmarks must choose%2.">(
          decimal(remark.figure(0), 2), agreement(1));
    case RemarkCode::halvesContradict:
      return say<"Halves of the overlap registered apart contradict each other by %1%2.">(millimetres(remark.figure(0)), agreement(1));
    case RemarkCode::onePoseStandsOut:
      return say<"One pose stands out by a margin of %1, and halves of the overlap registered apart agree to %2%3.">(
          decimal(remark.figure(0), 1), millimetres(remark.figure(1)), agreement(2));
    case RemarkCode::streaksTakenOut:
      return say<"Shadows and other streaks were taken out, which drew the volumes %1 and %2 degrees elsewhere.">(
          millimetres(remark.figure(0)), decimal(remark.figure(1), 1));
    case RemarkCode::onlyStreaksAgree:
      return say<
          "What agrees are mostly streaks, such as shadows along the beam, which turn with the probe: what agrees without them is too "
          "little to rule out chance%1. A tracker, landmarks or the direction of the beams can decide.">(agreement(0));
    case RemarkCode::streaksDecide:
      return say<
          "What agrees are mostly streaks, such as shadows along the beam, which turn with the probe: without them the pose lies "
          "%1 and %2 degrees elsewhere. A tracker, landmarks or the direction of the beams can decide.">(millimetres(remark.figure(0)),
                                                                                                         decimal(remark.figure(1), 1));
    default:
      return {};
  }
}

Message ofLandmarks(const Remark& remark, Wording wording) {
  switch (remark.what) {
    case RemarkCode::tooFewPlaces:
      return remark.figure(0) == 0.0   ? say<"There is no pair of landmarks: a turn needs three places that are not on one line.">()
             : remark.figure(0) == 1.0 ? say<"One place is too few: a turn needs three places that are not on one line.">()
                                       : say<"Two places are too few: a turn needs three places that are not on one line.">();
    case RemarkCode::placesRepeat:
      return remark.names.size() == 1 ? say<"%1 repeats the place of an earlier pair.">(namesOf(remark, 0, wording))
                                      : say<"%1 repeat the place of an earlier pair.">(namesOf(remark, 0, wording));
    case RemarkCode::placesOnALine:
      return say<"The places lie on one line, so that the turn about it is free: add a pair beside the line.">();
    case RemarkCode::placesMirrored:
      return say<
          "The places in one volume are the mirror image of those in the other: left and right were confused when they were "
          "picked, or one file is mirrored.">();
    case RemarkCode::threePlacesDisagree:
      return say<
          "The three pairs contradict each other by %1, and three cannot say which of them is wrong: correct one or add a "
          "fourth.">(plainMillimetres(remark.figure(0)));
    case RemarkCode::placesDisagree:
      return say<"The pairs contradict each other: no rigid transform brings more than %1 of %2 together. Pick them again.">(
          whole(remark.figure(0)), whole(remark.figure(1)));
    case RemarkCode::twoReadings: {
      const auto first = static_cast<std::size_t>(std::max(0.0, remark.figure(0)));
      return say<"One can read the pairs in two ways: without %1, or without %2. Add a pair or correct one.">(
          namesOf(remark, 0, first, 1, wording), namesOf(remark, first, remark.names.size(), 1, wording));
    }
    case RemarkCode::placesAgree:
      return say<"%1 pairs agree within %2 (rms).">(whole(remark.figure(0)), plainMillimetres(remark.figure(1)));
    case RemarkCode::placesAgreeBut: {
      const Message count = whole(remark.figure(0)), within = plainMillimetres(remark.figure(1)), off = plainMillimetres(remark.figure(2));
      const Message names = namesOf(remark, 3, wording);
      return remark.names.size() == 1 ? say<"%1 pairs agree within %2 (rms); %3 does not fit, by %4.">(count, within, names, off)
                                      : say<"%1 pairs agree within %2 (rms); %3 do not fit, by %4.">(count, within, names, off);
    }
    default:
      return {};
  }
}

Message ofBending(const Remark& remark, Wording wording) {
  const bool brief = wording == Wording::brief;
  const Message reached = warpedOver(remark.figure(0), remark.figure(1));
  switch (remark.what) {
    case RemarkCode::nothingBelieved:
      return say<"One of the volumes has no part that may be believed.">();
    case RemarkCode::apartWherePlaced:
      return say<"The volumes do not overlap where they were placed; place them, or match them first.">();
    case RemarkCode::nothingToFollow:
      return say<"The overlap shows no structure that could be followed: the normal equations are singular.">();
    case RemarkCode::startKeptGood:
      return say<"No deformation brought the volumes closer than they were; the start is kept.">();
    case RemarkCode::startKept:
      return say<"No deformation brought the volumes together; the start is kept.">();
    case RemarkCode::warpContradicts:
      return brief ? say<"The volumes contradict each other: deformed, they agree no better than unrelated tissue does.">()
                   : say<"The volumes contradict each other: deformed, they reach %1, which unrelated tissue reaches as well.">(reached);
    case RemarkCode::warpTooLittleShared:
      return brief ? say<"Too little structure is shared to tell whether the deformation is right.">()
                   : say<"Too little structure is shared to tell: deformed, the volumes reach %1.">(reached);
    case RemarkCode::warpAgrees:
      return brief ? say<"Deformed, the volumes agree.">()
                   : say<"The volumes agree: %1, %2 before.">(reached, decimal(remark.figure(2), 2));
    case RemarkCode::motionRemains: {
      const Message share = percent(remark.figure(0)), elsewhere = millimetres(remark.figure(1));
      return brief ? say<"Residual motion that the deformation does not follow: at %1 of the places that can tell, tissue lies elsewhere, "
                         "by %2 in "
                         "the mean.">(share, elsewhere)
                   : say<"Residual motion that the deformation does not follow: at %1 of the places that can tell, tissue lies elsewhere, "
                         "by %2 in "
                         "the mean (deformed, %3).">(share, elsewhere, warpedOver(remark.figure(2), remark.figure(3)));
    }
    default:
      return {};
  }
}

}  // namespace

static_assert(std::ranges::none_of(kNames, [](const char* name) { return name == nullptr; }), "each remark has a name");

const char* nameOf(RemarkCode what) { return what < RemarkCode::count_ ? kNames[static_cast<std::size_t>(what)] : ""; }

std::optional<RemarkCode> saysFrom(std::string_view name) {
  const auto at = std::find(kNames.begin(), kNames.end(), name);
  if (at == kNames.end()) return std::nullopt;
  return static_cast<RemarkCode>(at - kNames.begin());
}

Message messageOf(const Remark& remark, Wording wording) {
  if (remark.what < RemarkCode::apartAtTheStart) return ofVolume(remark);
  if (remark.what < RemarkCode::noPoseAgrees) return ofRefining(remark, wording);
  if (remark.what < RemarkCode::tooFewPlaces) return ofSearching(remark, wording);
  if (remark.what < RemarkCode::placedByHand) return ofLandmarks(remark, wording);
  if (remark.what == RemarkCode::placedByHand) return say<"Placed by hand.">();
  return ofBending(remark, wording);
}

Message messageOf(const std::vector<Remark>& remarks, Wording wording) {
  std::vector<Message> sentences;
  for (const Remark& remark : remarks) sentences.push_back(messageOf(remark, wording));
  return joined(std::move(sentences));
}

}  // namespace ew::registration
