#pragma once

#include <QFileInfo>
#include <QSettings>
#include <QString>

/// Where file dialogs begin: the folder that was used last, here or in an earlier run.
namespace ew::stitching {

inline constexpr const char* kFolderSetting = "stitching/folder";

[[nodiscard]] inline QString lastFolder() {
  const QString folder = QSettings().value(QLatin1String(kFolderSetting)).toString();
  return QFileInfo(folder).isDir() ? folder : QString();
}

inline void keepFolderOf(const QString& file) { QSettings().setValue(QLatin1String(kFolderSetting), QFileInfo(file).absolutePath()); }

}  // namespace ew::stitching
