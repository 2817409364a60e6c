#pragma once

#include <QCoreApplication>
#include <QString>

#include "ew/measurement/caliper.h"
#include "ew/measurement/measurement_list.h"
#include "ew/measurement/snap_target.h"

namespace ew::ui {

/// Where a caliper is drawn: on the scan, or in the strip of the M-mode.
enum class Where { image, strip };

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
  /// "82.0 ± 0.9 mm" (quantityText).
  [[nodiscard]] static QString textOf(const measurement::Quantity& quantity);
  /// The one that the caliper is for; empty when there is none.
  [[nodiscard]] static QString mainResult(const measurement::Measured& measured);
  /// The others, each with its name: "area 25.1 ± 0.4 cm²", joined by `between`.
  [[nodiscard]] static QString otherResults(const measurement::Measured& measured, const QString& between);
  /// "1", in a strip "M1".
  [[nodiscard]] static QString numberOf(Where where, int number);
  /// "edge", "cross 2", "level": what a point is drawn to.
  [[nodiscard]] static QString snapWord(const measurement::SnapTarget& target, bool isInStrip);
};

}  // namespace ew::ui
