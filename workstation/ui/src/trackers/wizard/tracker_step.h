#pragma once

#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace ew::ui {

/// One step on the way to a tracker that works: a sentence or two of what to do, what is seen of it, and whether it is done. What was done
/// is kept at once, so that nothing is lost by leaving.
class TrackerStep : public QWidget {
  Q_OBJECT

 public:
  /// @param title of a few words @param task what to do, for somebody who does it for the first time
  TrackerStep(const QString& title, const QString& task, QWidget* parent = nullptr);

  [[nodiscard]] const QString& title() const { return title_; }
  [[nodiscard]] virtual bool isDone() const = 0;
  /// Steps that this tracker has no need of are passed over.
  [[nodiscard]] virtual bool isNeeded() const { return true; }
  /// Whether one may go on; steps that can be left out say true before they are done.
  [[nodiscard]] virtual bool mayGoOn() const { return isDone(); }
  virtual void enter() {}  ///< it comes to the front
  virtual void leave() {}
  virtual void poll() {}  ///< about ten times a second while it is in front

 Q_SIGNALS:
  void changed();  ///< isDone() or mayGoOn() may be otherwise now

 protected:
  [[nodiscard]] QVBoxLayout& rows() { return *rows_; }
  /// A line that says how it goes; it keeps room for two lines, so that nothing jumps.
  [[nodiscard]] QLabel* addSentence(const char* objectName);
  enum class Tone { plain, good, bad };
  static void say(QLabel& label, const QString& sentence, Tone tone = Tone::plain);

 private:
  QString title_;
  QVBoxLayout* rows_ = nullptr;
};

}  // namespace ew::ui
