#pragma once

#include <QDateTime>
#include <QImage>
#include <QString>
#include <filesystem>
#include <vector>

#include "ew/core/result.h"
#include "ew/measurement/findings.h"
#include "ew/measurement/worksheet.h"

namespace ew::ui {

/// An image of the examination with the words it must carry.
struct WorksheetImage {
  QImage image;
  QString caption;
};

/// Writes a worksheet by the name's ending: .pdf (A4, to print), .csv or .json. Titles are in the window's language. All say that they are
/// for training only.
/// @param title of the case @param images that follow the worksheet in a PDF, two in a row @param person who measured, as they call
/// themselves; may be empty @error notWritable, unsupported (a PDF, and no font is installed)
[[nodiscard]] Result<void> writeWorksheet(const measurement::Worksheet& sheet, const QString& title, const QDateTime& at,
                                          const std::filesystem::path& file, const std::vector<WorksheetImage>& images = {},
                                          const QString& person = {});

/// Writes all that was measured by the name's ending: .csv or .json. @param title of the case @error notWritable
[[nodiscard]] Result<void> writeMeasurements(const measurement::Findings& findings, const QString& title,
                                             const std::filesystem::path& file);

}  // namespace ew::ui
