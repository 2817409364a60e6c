#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <set>

#include "ew/library/index.h"
#include "jobs/jobs.h"

namespace ew::ui {

/// The library's index in the window: opened when it is first asked for, refreshed in the background.
class LibraryBrowser final : public QObject {
  Q_OBJECT

 public:
  explicit LibraryBrowser(Jobs& jobs, QObject* parent = nullptr);

  /// The folders whose cases are shown: shipped, the user's own, published.
  [[nodiscard]] static std::vector<LibraryRoot> roots();

  /// Null when there is none (a message has said so). Another one once the roots or the language are others; the one before stays until
  /// then.
  [[nodiscard]] LibraryIndex* index() const { return index_.get(); }
  /// Opens the index where that is needed, then looks for what changed; when it is looking already, once more afterwards.
  void refresh();
  [[nodiscard]] bool isRefreshing() const { return job_ != 0; }
  /// The folder of a case, the user's own first; empty when there is none.
  [[nodiscard]] std::filesystem::path folderOf(const std::string& caseId) const;

 Q_SIGNALS:
  void opened();   ///< another index
  void changed();  ///< the index may say something new
  void refreshed();
  void noted(const QString& note);
  void failed(const ew::Error& error);

 private:
  void open();
  void start();
  void tellNews(const RefreshReport& report);
  Jobs& jobs_;
  std::vector<LibraryRoot> roots_;
  std::string language_;
  std::shared_ptr<LibraryIndex> index_;
  std::set<std::string> told_;  ///< folders whose problem was told
  QTimer poll_;                 ///< while a library is read for the first time its cases appear one after another
  int job_ = 0;
  bool again_ = false;
};

}  // namespace ew::ui
