#pragma once

#include <vector>

#include "window/frame/feature.h"
#include "window/frame/work_autosave.h"

class QDialog;

namespace ew::ui {

/// Goes on with what a crash has left: recordings, measurements, volumes that were made, a running lesson.
class Resuming final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;

  void connectParts() override;

  /// Reads what was left in a job, then asks about it.
  void offer();
  /// Something is open now: goes on with what is of it.
  void opened();
  /// Nothing is being opened any more.
  void openingEnded();
  /// What is resumed is opened by a dialog that asks about its file: the dialog's end decides.
  void waitFor(const QDialog& dialog, const QString& path);

 private:
  void ask(std::vector<RecoverableWork> left);
  void next();  ///< opens what the first of them belongs to
  /// Whether what it was recorded and measured on is scanned now.
  [[nodiscard]] bool isOpenFor(const RecoverableWork& work) const;
  void resume();         ///< the first of them, as it is open
  void leaveForLater();  ///< it was not opened: the next start offers it again
  /// What it is of is not scanned: it stays where it is, and says how it comes back.
  void leaveUnshown(const RecoverableWork& work);
  void showMeasured(const RecoverableWork& work);
  void takeVolumes(const RecoverableWork& work);

  std::vector<RecoverableWork> left_;  ///< gone on with one after the other, the first first
  bool isResuming_ = false;            ///< what the first one belongs to is being opened
};

}  // namespace ew::ui
