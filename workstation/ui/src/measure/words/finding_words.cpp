#include "measure/words/finding_words.h"

#include <QStringList>

#include "ew/widgets/figures.h"
#include "ew/widgets/words.h"
#include "measure/words/caliper_words.h"

namespace ew::ui {

using measurement::CaliperFigure;
using measurement::Combination;
using measurement::CombinationKind;
using measurement::Finding;
using measurement::Findings;

QString FindingWords::nameOf(CombinationKind kind) {
  switch (kind) {
    case CombinationKind::ratio:
      return tr("Ratio A / B");
    case CombinationKind::percent:
      return tr("A in percent of B");
    case CombinationKind::reduction:
      return tr("Stenosis, 1 - A / B");
    case CombinationKind::ellipsoid:
      return tr("Volume, ellipsoid");
    case CombinationKind::biplane:
      return tr("Volume, discs of two planes");
  }
  return {};
}

QString FindingWords::inputOf(CombinationKind kind, std::size_t n) {
  switch (kind) {
    case CombinationKind::reduction:
      return n == 0 ? tr("A, narrow") : tr("B, normal");
    case CombinationKind::ellipsoid:
      return n == 0 ? tr("Length") : n == 1 ? tr("Width") : tr("Height");
    case CombinationKind::biplane:
      return n == 0 ? tr("First plane") : tr("Second plane");
    case CombinationKind::ratio:
    case CombinationKind::percent:
      return n == 0 ? tr("A") : tr("B");
  }
  return {};
}

QString FindingWords::numberOf(const Combination& combination) {
  return tr("R%1", "number of a result over several measurements").arg(combination.number);
}

QString FindingWords::placeOf(const Findings& findings, const Finding& finding) {
  const bool isStrip = finding.image >= measurement::kStripImage;
  const QString what =
      QStringLiteral("%1 %2").arg(CaliperWords::numberOf(isStrip ? Where::strip : Where::image, finding.measurement.number),
                                  CaliperWords::titleOf(finding.measurement));
  return isStrip ? what : tr("Image %1: %2", "an image's number, and a measurement in it").arg(findings.ordinalOf(finding.image)).arg(what);
}

QString FindingWords::textOf(const Findings& findings, const Finding& finding, const CaliperFigure& figure) {
  return tr("%1, %2 %3", "a measurement, what of it, its value")
      .arg(placeOf(findings, finding), CaliperWords::nameOf(figure.kind), CaliperWords::textOf(figure.quantity));
}

QString FindingWords::valueOf(const Findings& findings, const Combination& combination) {
  const auto combined = findings.combine(combination.kind, combination.of);
  return combined ? CaliperWords::textOf(combined->quantity) : QStringLiteral("–");
}

QString FindingWords::howItCameAbout(const Findings& findings, const Combination& combination) {
  const auto combined = findings.combine(combination.kind, combination.of);
  if (!combined) return words(combined.error().message);
  QStringList said, from;
  for (std::size_t n = 0; n < combination.of.size(); ++n) {
    const Finding* finding = findings.find(combination.of[n].image, combination.of[n].number);
    const CaliperFigure* figure = finding != nullptr ? finding->measured.figure(combination.of[n].figure) : nullptr;
    if (figure != nullptr)
      from << tr("%1 = %2", "an input and what it is").arg(inputOf(combination.kind, n), textOf(findings, *finding, *figure));
  }
  said << tr("From %1.").arg(from.join(QStringLiteral("; ")));
  if (combined->quantity.uncertainty > 0.0 && combination.kind != CombinationKind::biplane)
    said << (combined->correlation == 0.0
                 ? tr("± from those of its inputs, which share no point: correlation 0.")
                 : tr("± from those of its inputs, which share points: correlation %1.").arg(figure(combined->correlation, 2)));
  for (const Message& remark : combined->remarks) said << words(remark);
  return said.join(QLatin1Char(' '));
}

}  // namespace ew::ui
