#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>

#include "ew/scanning/cine.h"
#include "keys/key_map.h"

class QComboBox;
class QKeyEvent;
class QPushButton;
class QWheelEvent;

namespace ew {
class FigureLabel;
class TimeLine;
}  // namespace ew

namespace ew::ui {

class Session;

/// Looks through the last seconds of a frozen scan: step, drag along, play between two marks in a loop, save what runs as a recording. It
/// is open while the scan is frozen and there is more than one image to look at.
class CineBar final : public QWidget {
  Q_OBJECT

 public:
  explicit CineBar(Session& session, QWidget* parent = nullptr);

  /// Keys in the scan and in the body's view, and the wheel over the scan, step through the images while the bar is open. Who watches later
  /// sees an event first.
  void watch(QWidget* scan, QWidget* body);
  [[nodiscard]] bool isOpen() const { return review_.has_value(); }
  /// Expects the bar to be open.
  [[nodiscard]] const CineReview& review() const { return *review_; }
  void step(int frames);
  void goTo(std::size_t frame);
  void markIn();
  void markOut();
  void setPlaying(bool playing);
  [[nodiscard]] bool isPlaying() const { return tick_.isActive(); }
  /// Arrows left and right an image, with Shift ten; Home and End. @return whether it was such a key, and the bar is open
  bool handleKey(const QKeyEvent& key);
  /// Does what a key of a command "cine.…" of a view does. @param far as with Shift @return whether there is such a command now
  bool run(const std::string& command, bool far = false);
  void setKeys(const KeyMap& keys) { keys_ = &keys; }
  /// What runs, as a recording; null while the bar is not open.
  [[nodiscard]] std::shared_ptr<const ScanRecording> clip(const std::string& caseId) const;
  void refreshIcons();

 Q_SIGNALS:
  void saveAsked();
  void openChanged(bool open);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void hideEvent(QHideEvent*) override { setPlaying(false); }

 private:
  void follow();  ///< the session: opens and closes
  void close();
  void advance();
  void stepByWheel(const QWheelEvent& wheel);
  void showFrame();
  void showState();
  void showPlaying();

  Session& session_;
  const KeyMap* keys_ = &usualKeys();
  QWidget* scan_ = nullptr;
  std::optional<CineReview> review_;
  QTimer tick_;
  QElapsedTimer sinceTick_;
  int wheel_ = 0;  ///< of a notch, in eighths of a degree
  QPushButton* play_ = nullptr;
  QPushButton* back_ = nullptr;
  QPushButton* on_ = nullptr;
  TimeLine* line_ = nullptr;
  FigureLabel* time_ = nullptr;
  QPushButton* in_ = nullptr;
  QPushButton* out_ = nullptr;
  QComboBox* speed_ = nullptr;
  QPushButton* save_ = nullptr;
};

}  // namespace ew::ui
