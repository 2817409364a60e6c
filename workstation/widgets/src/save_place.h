#pragma once

#include <QDateTime>
#include <QSettings>
#include <QString>
#include <QStringList>

namespace ew {

/// A text as a name that every file system takes: without what one of them refuses, not too long, no name that one keeps for itself. Empty:
/// nothing of it is left.
[[nodiscard]] QString nameForFiles(const QString& text);

/// A proposed name without a folder, with day and time before its ending so that the next one is another: "liver 2026-11-30 14.05.seq.mha".
/// @param endings that can be written; the longest that `proposal` has is its ending, else all behind the last dot is
[[nodiscard]] QString datedName(const QString& proposal, const QStringList& endings, const QDateTime& when);

/// The folder in which a question begins where to save a kind of file: the one that was used last for it, at first the user's images or
/// documents. @param endings that can be written; the first names the kind
[[nodiscard]] QString folderForSaving(const QStringList& endings, const QSettings& settings);
/// @param file that was chosen, with its folder
void keepFolderForSaving(const QStringList& endings, const QString& file, QSettings& settings);

}  // namespace ew
