#pragma once

#include <QCoreApplication>
#include <QString>

#include "ew/measurement/findings.h"

namespace ew::ui {

/// How the window names what was measured in several images, and results over them.
struct FindingWords {
  Q_DECLARE_TR_FUNCTIONS(ew::ui::FindingWords)

 public:
  [[nodiscard]] static QString nameOf(measurement::CombinationKind kind);
  /// What its n-th input is: "A: the narrow place".
  [[nodiscard]] static QString inputOf(measurement::CombinationKind kind, std::size_t n);
  /// "R1".
  [[nodiscard]] static QString numberOf(const measurement::Combination& combination);
  /// "Image 2, 1 Distance", of a strip "M1 Time".
  [[nodiscard]] static QString placeOf(const measurement::Findings& findings, const measurement::Finding& finding);
  /// The same with the figure and its value: what is chosen from.
  [[nodiscard]] static QString textOf(const measurement::Findings& findings, const measurement::Finding& finding,
                                      const measurement::CaliperFigure& figure);
  /// "12.3 ± 0.4 %", or why there is none.
  [[nodiscard]] static QString valueOf(const measurement::Findings& findings, const measurement::Combination& combination);
  /// What it was made from, how its uncertainty came about, and what a person should know about it.
  [[nodiscard]] static QString howItCameAbout(const measurement::Findings& findings, const measurement::Combination& combination);
};

}  // namespace ew::ui
