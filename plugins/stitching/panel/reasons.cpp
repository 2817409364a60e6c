#include "panel/reasons.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "ew/sdk/panel.h"

namespace ew::stitching {
namespace {

using registration::Remark;
using registration::Says;
using sdk::words;

constexpr std::size_t kMostNames = 8;  // a sentence that names more is not read

/// Gives the sentences their place in the translations.
class Reasons {
  Q_DECLARE_TR_FUNCTIONS(ew::stitching::Reasons)

 public:
  static QString number(double value, int decimals) { return QLocale().toString(value, 'f', decimals); }
  static QString millimetres(double mm) { return std::isfinite(mm) ? tr("%1 mm").arg(number(mm, 1)) : tr("any distance"); }
  static QString degrees(double deg) { return QStringLiteral("%1°").arg(number(deg, 1)); }
  static QString percent(double share) { return tr("%1 %").arg(number(100.0 * share, 0)); }

  /// "a, b and c"
  static QString listOf(QStringList names) {
    if (names.size() > static_cast<int>(kMostNames)) {
      const int more = names.size() - static_cast<int>(kMostNames);
      names = names.mid(0, static_cast<int>(kMostNames));
      return tr("%1 and %2 more").arg(names.join(QStringLiteral(", "))).arg(more);
    }
    if (names.size() < 2) return names.join(QString());
    const QString last = names.takeLast();
    return tr("%1 and %2", "end of a list").arg(names.join(QStringLiteral(", ")), last);
  }
  /// Places [from, to) by name, or by the number that stands from figure `numbers` on.
  static QString places(const Remark& remark, std::size_t from, std::size_t to, std::size_t numbers) {
    QStringList names;
    for (std::size_t n = from; n < std::min(to, remark.names.size()); ++n)
      names << (remark.names[n].empty() ? tr("number %1").arg(remark.figure(numbers + n), 0, 'f', 0)
                                        : tr("'%1'").arg(words(remark.names[n])));
    return listOf(names);
  }
  static QString places(const Remark& remark, std::size_t numbers) { return places(remark, 0, remark.names.size(), numbers); }

  static QString say(const Remark& remark);
  static QString sayGraph(const ChainState& found, const StitchProject& asked);
};

QString Reasons::say(const Remark& remark) {
  const bool fixed = remark.figure(0) == 0.0;
  switch (remark.what) {
    case Says::noEcho:
      return fixed ? tr("The fixed volume holds no echo.") : tr("The moving volume holds no echo.");
    case Says::tooThin:
      if (remark.figure(2) != 0.0)
        return (fixed ? tr("The fixed volume covers nothing as thick as three voxels of %1. Without coverage, black at the border is "
                           "outside.")
                      : tr("The moving volume covers nothing as thick as three voxels of %1. Without coverage, black at the border is "
                           "outside."))
            .arg(millimetres(remark.figure(1)));
      return (fixed ? tr("The fixed volume is too thin: it takes three voxels of %1 in every direction.")
                    : tr("The moving volume is too thin: it takes three voxels of %1 in every direction."))
          .arg(millimetres(remark.figure(1)));
    case Says::noStructure:
      return fixed ? tr("The fixed volume shows no structure: it is the same grey nearly everywhere.")
                   : tr("The moving volume shows no structure: it is the same grey nearly everywhere.");
    case Says::apartAtTheStart:
      return tr("The two do not overlap at the start: bring them closer, or search without places.");
    case Says::fewSharedVoxels:
      return tr("The overlap is too small: fewer than 50 voxels are covered by both volumes.");
    case Says::poseNotHeld:
      return tr("What overlaps does not hold the pose: it may slide or turn.");
    case Says::overlapTooSmall:
      return tr("The overlap is too small to tell.");
    case Says::unrelatedNearStart:
      return tr("Near this start the images agree no better than unrelated tissue does.");
    case Says::hardlyBetter:
      return tr("The images agree hardly better than unrelated tissue does.");
    case Says::startMayBeFar:
      return tr("Halves of the overlap, matched apart, contradict each other by %1: the start may be too far off.")
          .arg(millimetres(remark.figure(0)));
    case Says::halvesAgree:
      return tr("Halves of the overlap, matched apart, agree to %1.").arg(millimetres(remark.figure(0)));
    case Says::foundAboutTheStart:
      return tr("Descending from the start led nowhere; a search about it found a pose %1 and %2 from it.")
          .arg(millimetres(remark.figure(0)), degrees(remark.figure(1)));
    case Says::noPoseAgrees:
      return tr("No pose brings the two into agreement over %1 overlap.").arg(percent(remark.figure(0)));
    case Says::foundTooSmall:
      return tr("The overlap found is too small to tell it from chance.");
    case Says::unrelatedEverywhere:
      return tr("The best of %1 turns with all shifts agrees no better than unrelated tissue does.")
          .arg(QLocale().toString(remark.figure(0), 'f', 0));
    case Says::bestHardlyBetter:
      return tr("The best pose agrees hardly better than unrelated tissue does.");
    case Says::twoPosesAlike:
      return tr("Two different poses agree almost equally (margin %1): the structure repeats. A start or landmarks must choose.")
          .arg(number(remark.figure(0), 2));
    case Says::halvesContradict:
      return tr("Halves of the overlap, matched apart, contradict each other by %1.").arg(millimetres(remark.figure(0)));
    case Says::onePoseStandsOut:
      return tr("One pose stands out by a margin of %1; halves of the overlap, matched apart, agree to %2.")
          .arg(number(remark.figure(0), 1), millimetres(remark.figure(1)));
    case Says::streaksTakenOut:
      return tr("Shadows and other streaks were taken out, which drew the volumes %1 and %2 elsewhere.")
          .arg(millimetres(remark.figure(0)), degrees(remark.figure(1)));
    case Says::onlyStreaksAgree:
      return tr(
          "What agrees are mostly streaks, such as shadows along the beam, which turn with the probe: without them the volumes agree "
          "hardly better than unrelated tissue does.");
    case Says::streaksDecide:
      return tr("What agrees are mostly streaks, such as shadows along the beam, which turn with the probe: without them the pose lies %1 "
                "and %2 elsewhere. A tracker or landmarks can decide.")
          .arg(millimetres(remark.figure(0)), degrees(remark.figure(1)));
    case Says::tooFewPlaces:
      return tr("Three places that are not on one line are needed; mark %n more.", nullptr,
                std::clamp(3 - static_cast<int>(remark.figure(0)), 1, 3));
    case Says::placesRepeat:
      return tr("%1: the place of an earlier pair again.").arg(places(remark, 0));
    case Says::placesOnALine:
      return tr("The places lie on one line, so that the turn about it is free: add one beside the line.");
    case Says::placesMirrored:
      return tr(
          "The places in one volume are the mirror image of those in the other: left and right were confused, or one file is "
          "mirrored.");
    case Says::threePlacesDisagree:
      return tr("The three pairs contradict each other by %1, and three cannot say which is wrong: correct one or add a fourth.")
          .arg(millimetres(remark.figure(0)));
    case Says::placesDisagree:
      return tr("The pairs contradict each other: no rigid transform brings more than %1 of %2 together. Pick them again.")
          .arg(number(remark.figure(0), 0), number(remark.figure(1), 0));
    case Says::twoReadings: {
      const auto first = static_cast<std::size_t>(std::max(0.0, remark.figure(0)));
      return tr("One can read the pairs in two ways: without %1, or without %2. Add a pair or correct one.")
          .arg(places(remark, 0, first, 1), places(remark, first, remark.names.size(), 1));
    }
    case Says::placesAgree:
      return tr("%1 pairs agree within %2.").arg(number(remark.figure(0), 0), millimetres(remark.figure(1)));
    case Says::placesAgreeBut:
      return tr("%1 pairs agree within %2; off by %3: %4.")
          .arg(number(remark.figure(0), 0), millimetres(remark.figure(1)), millimetres(remark.figure(2)), places(remark, 3));
    case Says::placedByHand:
      return tr("Placed by hand.");
    case Says::nothingBelieved:
      return tr("One of the volumes has no part that may be believed.");
    case Says::apartWherePlaced:
      return tr("The volumes do not overlap where they were placed.");
    case Says::nothingToFollow:
      return tr("The overlap shows no structure that could be followed.");
    case Says::startKeptGood:
      return tr("No bending brought the volumes closer than they were; none was made.");
    case Says::startKept:
      return tr("No bending brought the volumes together; none was made.");
    case Says::bendContradicts:
      return tr("The volumes contradict each other: bent, they agree no better than unrelated tissue does.");
    case Says::bendTooLittleShared:
      return tr("Too little structure is shared to tell whether the bend is right.");
    case Says::bendAgrees:
      return tr("Bent, the volumes agree.");
    case Says::motionIsLeft:
      return tr("The bend misses motion: at %1 of the places that can tell, tissue lies %2 from where the bend puts it.")
          .arg(percent(remark.figure(0)), millimetres(remark.figure(1)));
    case Says::count_:
      break;
  }
  return {};
}

QString Reasons::sayGraph(const ChainState& found, const StitchProject& asked) {
  const registration::GraphResult& graph = *found.graph;
  const auto nameOf = [&](std::size_t volume) {
    return volume < asked.volumes.size() ? tr("'%1'").arg(words(asked.volumes[volume].name)) : QString();
  };
  const auto pairName = [&](const PairOutcome& pair) { return tr("%1 with %2").arg(nameOf(pair.fixed), nameOf(pair.moving)); };
  const auto trackerOf = [&](std::size_t volume) { return tr("the tracker's pose of %1").arg(nameOf(volume)); };
  QStringList sentences;
  if (graph.parts > 1) {
    QStringList parts;
    for (int part = 0; part < graph.parts; ++part) {
      QStringList names;
      for (std::size_t v = 0; v < graph.part.size(); ++v)
        if (graph.part[v] == part) names << nameOf(v);
      parts << listOf(names);
    }
    if (parts.size() > static_cast<int>(kMostNames)) parts = parts.mid(0, static_cast<int>(kMostNames)) << QStringLiteral("…");
    sentences << tr("Nothing joins these %1 parts: %2. Match a pair between them.").arg(graph.parts).arg(parts.join(QStringLiteral("; ")));
  }
  if (!graph.undetermined.empty()) {
    QStringList names;
    for (const std::size_t v : graph.undetermined) names << nameOf(v);
    sentences << tr("The pairs leave %1 free to slide or turn.").arg(listOf(names));
  }
  QStringList wrong, suspects, unchecked;
  for (const PairOutcome& pair : found.pairs) {
    if (!pair.inGraph) continue;
    if (pair.wrong)
      wrong << tr("%1 (by %2 and %3)").arg(pairName(pair), millimetres(pair.inGraph->residual_mm), degrees(pair.inGraph->residual_deg));
    else if (!pair.inGraph->confirmed)
      unchecked << pairName(pair);
    if (pair.suspect) suspects << pairName(pair);
  }
  for (const std::size_t v : graph.wrongPriors) wrong << trackerOf(v);
  for (const std::size_t v : graph.suspectPriors) suspects << trackerOf(v);
  if (!wrong.isEmpty()) sentences << tr("Wrong, and left out: %1.").arg(listOf(wrong));
  if (!suspects.isEmpty())
    sentences << tr("It could as well be %1: they lie on the same loop. Match another pair across it.").arg(listOf(suspects));
  if (!unchecked.isEmpty()) sentences << tr("No loop checks %1.").arg(listOf(unchecked));
  if (graph.stop == registration::StopReason::iterationLimit || graph.stop == registration::StopReason::singular)
    sentences << tr("The optimisation of the poses did not converge.");
  return sentences.join(QLatin1Char(' '));
}

}  // namespace

QString sentenceOf(const Remark& remark) { return Reasons::say(remark); }

QString sentencesOf(const std::vector<Remark>& remarks, const std::string& otherwise) {
  if (remarks.empty()) return words(otherwise);
  QStringList sentences;
  for (const Remark& remark : remarks) sentences << Reasons::say(remark);
  return sentences.join(QLatin1Char(' '));
}

QString reasonOf(const ChainState& found, const StitchProject& asked) {
  const QString said = found.graph ? Reasons::sayGraph(found, asked) : QString();
  return said.isEmpty() ? words(found.reason) : said;
}

}  // namespace ew::stitching
