#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "window/frame/feature.h"

class QAction;
class QMenu;

namespace ew {
struct ScanRecording;
}

namespace ew::ui {

/// What is opened: a case, a volume, a sweep, a recording; what is asked before it takes the place of what is open; what was open before.
class Opening final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;

  void addFileActions(QMenu& file);
  void addRecentMenu(QMenu& file);
  [[nodiscard]] QAction* firstAction() const { return first_; }  ///< in the menu of files: before it stands what plugins begin a case with
  void connectParts() override;
  void refresh() override;
  void holdUnsavedWork(UnsavedWork& list) override;

  /// A case folder, a case.json, a volume or a sweep; a problem becomes a message and changes nothing.
  void open(const QString& path);
  /// Several files, one of which may be the calibration of a sweep.
  void openDropped(const QStringList& paths);
  /// Opens a case, or goes back to it, and begins or goes on with a lesson of it.
  void openLesson(const QString& folder, const QString& lessonId);
  void openDefaultCase();
  /// Whether something is being opened, or the case that is to be.
  [[nodiscard]] bool isUnderWay() const;
  void openWhereOneWas();
  void remember(const QString& path);      ///< as opened recently
  void readRecent();                       ///< what is called how, by now
  void showRecent();                       ///< on the start page and in the menu
  void rememberOpen(const QString& path);  ///< for openWhereOneWas
  void rememberClosing();
  /// Asks about everything that is lost when something else is shown. @param next what that is. @return whether to go on
  [[nodiscard]] bool mayReplaceShown(const QString& next);
  /// The same where the case stays open and another volume is scanned.
  [[nodiscard]] bool mayReplaceScan(const QString& next);

 private:
  void openHere(const QString& path);
  /// What was chosen last does not come, refused or made behind what is open: what gave way to it is opened after all.
  /// @param tell why, which is said again once that is there
  void goBack(std::function<void()> tell);
  void connectImports();  ///< what has to be asked or made before it can be scanned
  void choose();
  void opened(const QString& path);
  void ended();
  void playRecording(const QString& path, const std::shared_ptr<const ScanRecording>& recording);

  QStringList calibrations_;  ///< dropped together with the sweep that is opened
  QString preparing_;         ///< the case that is opened and has to be made first; empty: none
  std::string preparingId_;   ///< its id
  struct {
    QString path;
    std::shared_ptr<const ScanRecording> recording;
  } waiting_;            ///< for its case, which is being opened
  QString interrupted_;  ///< was being opened, and gave way to what is being opened now
  struct {
    QString path;
    std::function<void()> tell;
  } goesBack_;                            ///< is opened after all; empty: nothing
  bool isChoosing_ = false;               ///< the case to begin with is being looked for
  bool isBehind_ = false;                 ///< what was opened is made behind what is open instead
  std::optional<bool> recentForAuthors_;  ///< for whom the menu was filled; empty: not yet
  QMenu* recent_ = nullptr;
  QAction* first_ = nullptr;
};

}  // namespace ew::ui
