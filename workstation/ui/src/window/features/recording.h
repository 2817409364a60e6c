#pragma once

#include <QString>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "window/frame/feature.h"

class QAction;
class QMenu;

namespace ew {
struct ScanRecording;
}

namespace ew::ui {

inline const auto kRecordingTopic = QStringLiteral("recording");  ///< of messages

/// Recording a scan, playing one, and keeping what was recorded until the user has decided about it.
class Recording final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;

  void addMenu(QMenu& recording);
  void connectParts() override;
  void refresh() override;
  void holdUnsavedWork(UnsavedWork& list) override;

  [[nodiscard]] std::string caseId() const;  ///< of the case that is scanned; empty: none
  [[nodiscard]] bool isUnsaved() const;
  /// The file of what is replayed; empty: none yet.
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// Plays what was opened. @return false: it is of something else than what is scanned
  [[nodiscard]] bool play(const QString& path, const std::shared_ptr<const ScanRecording>& recording);
  /// Shows what a crash has left. @param isSaved images that were measured are no recording that one would miss
  void showAgain(const std::shared_ptr<const ScanRecording>& recording, bool isSaved);
  void close();
  [[nodiscard]] bool mayLeave(const QString& next);
  /// Asks for a name and begins to save. @param saved called when it is @return false: nothing is saved
  bool saveAs(const std::shared_ptr<const ScanRecording>& recording, const QString& title, std::function<void()> saved);
  void startSaving(const std::shared_ptr<const ScanRecording>& recording, const QString& file, std::function<void()> saved);

 private:
  void toggle();
  void end();  ///< and shows what was recorded, at rest
  bool save();
  void showState();

  std::shared_ptr<const ScanRecording> saved_;  ///< that lies in a file; another one in the replay bar does not
  std::filesystem::path file_;
  QAction* record_ = nullptr;
  QAction* mark_ = nullptr;
  QAction* save_ = nullptr;
};

}  // namespace ew::ui
