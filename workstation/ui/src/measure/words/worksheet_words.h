#pragma once

#include <QCoreApplication>
#include <QString>

#include "ew/measurement/worksheet.h"

namespace ew::ui {

/// How the window writes worksheets, in its language.
struct WorksheetWords {
  Q_DECLARE_TR_FUNCTIONS(ew::ui::WorksheetWords)

 public:
  /// "right" in the window's language; empty of no side.
  [[nodiscard]] static QString sideOf(const std::string& side);
  /// The worksheet as rich text: sections with their rows, ranges, charts and remarks, then what answers say together.
  /// @param quiet colour of what is read second, "#rrggbb"
  [[nodiscard]] static QString htmlOf(const measurement::Worksheet& sheet, const QString& quiet);
};

}  // namespace ew::ui
