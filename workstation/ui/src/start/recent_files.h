#pragma once

#include <QHash>
#include <QObject>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "ew/widgets/worker.h"

namespace ew::ui {

/// A file or case folder that was opened before, in the words in which it is offered again.
struct RecentFile {
  QString path;
  QString name;  ///< of a case its title, of a file its name
  QString tip;   ///< where it lies; of a case only for authors, because a folder's name may say what the case shows
  bool operator==(const RecentFile&) const = default;
};

/// What a file is called that no case is known of: the last part of its path.
[[nodiscard]] QString fileNameOf(const QString& path);

/// What was opened recently, in words. Titles stand in the cases, which are read on a thread of their own; a case that was not read yet is
/// not offered, for all that is known of it is the name of its folder.
class RecentFiles final : public QObject {
  Q_OBJECT

 public:
  explicit RecentFiles(QObject* parent = nullptr);
  ~RecentFiles() override;

  /// Reads these anew; changed() follows when a title is another than the one that is known.
  void read(const QStringList& paths);
  /// Those of `paths` that are known, without what lies in `shownElsewhere` (absolute paths of case folders).
  /// @param forAuthors whether a title may name the finding
  [[nodiscard]] std::vector<RecentFile> of(const QStringList& paths, bool forAuthors, const QStringList& shownElsewhere = {}) const;
  [[nodiscard]] bool isBusy() const { return waiting_ > 0; }

 Q_SIGNALS:
  void changed();

 private:
  /// Of a case; none of a file, or of a case that cannot be read, which is called as its path is.
  struct CaseNames {
    QString title, titleForTrainees, region;
    bool operator==(const CaseNames&) const = default;
  };
  using Known = QHash<QString, std::optional<CaseNames>>;  ///< by path
  [[nodiscard]] static std::optional<CaseNames> namesAt(const QString& path);
  void take(const Known& found);

  Known known_;
  int waiting_ = 0;
  Worker worker_;
};

}  // namespace ew::ui
