#pragma once

#include <QString>
#include <QStringList>
#include <filesystem>
#include <functional>
#include <vector>

#include "ew/core/output_set.h"
#include "ew/core/result.h"

class QWidget;

namespace ew::ui {

/// Where something is saved.
struct SaveFile {
  QString title;        ///< of the dialog
  QString proposal;     ///< a name, with its folder when it has one
  QString filter;       ///< "MetaImage (*.mha *.mhd)"
  QStringList endings;  ///< that can be written (".mha"); a name that ends with none of them gets the first
  /// The names that saving under a complete name writes, each with the files it stands for (filesNamedBy). Empty: that name alone.
  std::function<QStringList(const QString& file)> written = {};
};

/// Asks for a name, and then, by the names that will really be written, whether what is there may be replaced.
/// @return the complete name; empty: the user does not want to save
[[nodiscard]] QString askSaveFile(QWidget* parent, const SaveFile& asked);

/// Writes files aside and puts them in place together when all are there; what was there before stays until then.
/// @param write writes each of `files` to the place that the set names for it
/// @error as OutputSet::announce, `write` and OutputSet::commit, in the names of `files`
[[nodiscard]] Result<void> saveTogether(const std::vector<std::filesystem::path>& files,
                                        const std::function<Result<void>(const OutputSet& outputs)>& write);

}  // namespace ew::ui
