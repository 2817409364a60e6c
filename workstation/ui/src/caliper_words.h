#pragma once

#include <QCoreApplication>
#include <QString>

#include "ew/measurement/caliper.h"
#include "ew/measurement/measurement_list.h"

namespace ew::ui {

/// How the window names calipers and writes what they measure, in its language.
struct CaliperWords {
  Q_DECLARE_TR_FUNCTIONS(ew::ui::CaliperWords)

 public:
  [[nodiscard]] static QString nameOf(measurement::CaliperKind kind);
  [[nodiscard]] static QString nameOf(measurement::FigureKind kind);
  /// What was measured: the item it was made for and its side, or else the caliper.
  [[nodiscard]] static QString titleOf(const measurement::Measurement& measurement);
  /// What to click.
  [[nodiscard]] static QString hintOf(measurement::CaliperKind kind);
  [[nodiscard]] static QString iconOf(measurement::CaliperKind kind);
  /// "82.0 ± 0.9 mm", areas in cm².
  [[nodiscard]] static QString textOf(const measurement::Quantity& quantity);
  /// The one that the caliper is for; empty when there is none.
  [[nodiscard]] static QString mainResult(const measurement::Measured& measured);
  /// The others, each with its name: "area 25.1 ± 0.4 cm²", joined by `between`.
  [[nodiscard]] static QString otherResults(const measurement::Measured& measured, const QString& between);
  /// Where the uncertainty of a caliper comes from: pixel, and the beam at its points. @param at as measure() was given it
  [[nodiscard]] static QString howItCameAbout(const measurement::Caliper& caliper, const measurement::UncertaintyAt& at);
};

}  // namespace ew::ui
