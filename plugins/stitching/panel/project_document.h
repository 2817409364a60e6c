#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <filesystem>
#include <string>
#include <vector>

#include "ew/sdk/host.h"
#include "logic/recovery.h"
#include "logic/stitch_document.h"

namespace ew::stitching {

class Notices;

/// The project that is open: what is edited, with its steps, its file, and what is kept of it against a crash. On the window's thread.
class ProjectDocument final : public QObject {
  Q_OBJECT

 public:
  /// @param folder for results and the recovery file; empty: the application's own data folder
  ProjectDocument(sdk::Host& host, Notices& notices, std::filesystem::path folder);
  ~ProjectDocument() override;

  [[nodiscard]] const StitchProject& project() const { return document_.project(); }
  [[nodiscard]] const std::filesystem::path& file() const { return document_.file(); }  ///< empty: never saved
  [[nodiscard]] bool hasUnsavedChanges() const { return document_.hasUnsavedChanges(); }
  [[nodiscard]] int number() const { return number_; }  ///< counts the projects that were opened or begun

  void edit(StitchProject next, const QString& what, const std::string& mergeKey = {});
  void endMerging() { document_.endMerging(); }
  /// As of StitchDocument.
  [[nodiscard]] const StitchProject* beforeMerging(const std::string& mergeKey) const { return document_.beforeMerging(mergeKey); }
  [[nodiscard]] std::string undoName() const { return document_.undoName(); }
  [[nodiscard]] std::string redoName() const { return document_.redoName(); }
  void undo();
  void redo();
  /// Tells everybody to look at the project anew, and keeps it soon.
  void announce();

  void startAnew();
  bool openProject(const std::filesystem::path& file);
  void save(bool elsewhere);  ///< asks by a dialog where it must
  bool saveAs(const std::filesystem::path& file);

  /// What an earlier run left unsaved: the latest that nobody decided about.
  [[nodiscard]] const StitchDocument::Left* left() const { return left_.empty() ? nullptr : &left_.front().work; }
  [[nodiscard]] int leftCount() const { return static_cast<int>(left_.size()); }
  void reopenLeft();
  void discardLeft();

  /// Where runs of this project keep their steps.
  [[nodiscard]] std::filesystem::path workFolder() const;
  /// Where sweeps become volumes while they are read.
  [[nodiscard]] std::filesystem::path readingFolder() const;

 Q_SIGNALS:
  void edited();         ///< or more of it was read: whoever holds something about the project follows
  void replaced();       ///< by another project; edited() comes after it
  void fileOpened();     ///< replaced() comes after it: what could not be read before may be there now
  void resultsWanted();  ///< after both: it may have been worked on before
  void saved();
  void workFolderChanged(const std::filesystem::path& before, const std::filesystem::path& after);  ///< as it was saved
  void leftChanged();                                                                               ///< one that was left is gone

 private:
  struct RecoverableWork {
    int place = 0;  ///< of recovery_
    StitchDocument::Left work;
  };
  enum class OnDisk { reload, overwrite, saveElsewhere, cancel };
  [[nodiscard]] OnDisk askAboutFileOnDisk();
  [[nodiscard]] std::filesystem::path askForSaveName(const std::filesystem::path& before);  ///< empty: nobody wants to
  [[nodiscard]] std::filesystem::path untitledFolder(int place) const;
  void replace();
  void keep();

  sdk::Host& host_;
  Notices& notices_;
  std::filesystem::path folder_;
  RecoveryPlace recovery_;
  StitchDocument document_;
  std::vector<RecoverableWork> left_;  ///< offered; whoever works on without deciding finds it offered at the next start
  QTimer keepSoon_;
  int number_ = 0;
};

}  // namespace ew::stitching
