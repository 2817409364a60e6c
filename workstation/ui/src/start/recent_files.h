#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace ew::ui {

/// A file or case folder that was opened before, in the words in which it is offered again.
struct RecentFile {
  QString path;
  QString name;  ///< of a case its title, of a file its name
  QString tip;   ///< where it lies; of a case only for authors, because a folder's name may say what the case shows
  bool operator==(const RecentFile&) const = default;
};

/// The case's title, or the file's name. @param forAuthors whether the title may name the finding
[[nodiscard]] RecentFile recentFileOf(const QString& path, bool forAuthors);

/// The same for each, without what lies in `shownElsewhere` (absolute paths of case folders).
[[nodiscard]] std::vector<RecentFile> recentFilesOf(const QStringList& paths, bool forAuthors, const QStringList& shownElsewhere = {});

}  // namespace ew::ui
