#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ew/scanning/subject.h"
#include "window/frame/feature.h"

class QAction;
class QMenu;

namespace ew::sdk {
struct DisplayVolume;
}

namespace ew::ui {

enum class Loss;

/// A volume that was made here and lies in no file yet.
struct UnsavedVolume {
  QString path;   ///< of what it was made from
  QString title;  ///< for people
  ScanVoxels voxels;
  std::shared_ptr<const Provenance> provenance;  ///< may be null
};

/// Volumes that were made here: the one that is shown and those that wait, and how they are saved.
class UnsavedVolumes final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;

  void addSaveAction(QMenu& file);
  void addViewActions(QMenu& view);
  void connectParts() override;
  void refresh() override;
  void holdUnsavedWork(UnsavedWork& list) override;

  [[nodiscard]] const std::vector<UnsavedVolume>& all() const { return all_; }
  [[nodiscard]] const UnsavedVolume* shown() const;  ///< null: what is shown was not made here, or is saved
  /// What was just made: shows it, or lets it wait.
  void take(const UnsavedVolume& made);
  /// Likewise of what lies in a file of another kind.
  void takeImported(const UnsavedVolume& imported);
  /// What a crash has left: it waits, and what was shown is shown again when that may be.
  /// @param shownBefore of `left`; may be null @return its volume, shown or not; null: none was shown
  [[nodiscard]] std::shared_ptr<const Volume> takeLeft(const std::vector<UnsavedVolume>& left, const UnsavedVolume* shownBefore);
  /// "The volume made from ... is kept".
  [[nodiscard]] static QString saysKept(const UnsavedVolume& made);
  void forgetShown();  ///< the user agreed to lose it

 private:
  void show(const UnsavedVolume& made);
  void showWaiting();
  [[nodiscard]] const UnsavedVolume* waiting() const;                       ///< null: none
  [[nodiscard]] std::optional<sdk::DisplayVolume> shownForPlugins() const;  ///< that is no case's; empty: none
  void keep();                                                              ///< against a crash
  void saveShown();
  /// Asks for a name and begins to save. @return false: nothing is saved
  bool save(const UnsavedVolume& made);
  void forget(const std::shared_ptr<const Volume>& volume);
  [[nodiscard]] bool mayLeave(Loss loss, const QString& next);
  [[nodiscard]] bool mayLeave(const UnsavedVolume& made, const QString& next);

  std::vector<UnsavedVolume> all_;
  QAction* save_ = nullptr;
  QAction* ofCase_ = nullptr;
  QAction* made_ = nullptr;
};

}  // namespace ew::ui
