#pragma once

#include <QDateTime>
#include <QString>
#include <filesystem>

#include "ew/core/result.h"
#include "ew/measurement/worksheet.h"

namespace ew::ui {

/// Writes a worksheet by the name's ending: .pdf (A4, to print), .csv or .json. Titles are in the window's language. All say that they are
/// for training only.
/// @param title of the case @error notWritable
[[nodiscard]] Result<void> writeWorksheet(const measurement::Worksheet& sheet, const QString& title, const QDateTime& at,
                                          const std::filesystem::path& file);

}  // namespace ew::ui
