#pragma once

#include <QFrame>
#include <QTimer>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/result.h"

class QLabel;
class QPushButton;
class QScrollArea;

namespace ew::ui {

/// One sentence above the views that stays until it is dismissed or past: errors with a red edge, notes with the accent. A note that was
/// in sight for a minute is past; one that is unfolded, under the pointer or offers something stays. Several wait and
/// are counted; the newest error is in front, then the newest note. Whoever holds it lays it over what is no image and no button, so that
/// nothing moves when it comes.
///
/// A topic says what was being done ("open", "save FILE"): a later message of the same topic takes the place of the earlier ones, and all
/// messages with a topic go when something else is opened. Those without concern the program itself.
class MessageBar final : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent);

  void showError(const Error& error, const QString& topic = {});
  void showError(const QString& sentence, const QString& topic = {});
  void showNote(const QString& sentence, const QString& topic = {});
  /// What one action had to say, as one message: a single sentence as it is, several folded below `summary`. With none only what was said
  /// of the topic before goes.
  void showNotes(const QString& summary, const std::vector<Message>& sentences, const QString& topic = {});
  /// A note with a button that does something; the message goes with it.
  void showOffer(const QString& sentence, const QString& button, std::function<void()> run, const QString& topic);
  /// Something else is open: what was said with a topic is past.
  void forgetWhatIsPast();
  /// The same for one topic.
  void forget(const QString& topic);
  [[nodiscard]] QString text() const;     ///< of the message in sight; empty when there is none
  [[nodiscard]] QString details() const;  ///< that are folded below it, a line each; empty: none
  [[nodiscard]] bool isError() const;
  [[nodiscard]] int count() const { return static_cast<int>(waiting_.size()); }
  [[nodiscard]] int heightFor(int width_px) const;  ///< that its words need
  void dismiss();
  /// How long a note is in sight before it goes by itself.
  void setNotesPassAfter(int stay_ms);
  void refreshIcons();

 Q_SIGNALS:
  void rearranged();  ///< its height may have changed, or it came or went

 protected:
  bool event(QEvent* event) override;

 private:
  enum class Kind { note, error };
  struct Line {
    Kind kind = Kind::note;
    QString sentence;
    QString details;  ///< folded
    QString tip;
    QString topic;
    QString button = {};  ///< empty: nothing is offered
    std::function<void()> run = {};
    int id = 0;
  };
  void add(Line message);
  void refresh();
  void waitForPassing(bool isOther);
  [[nodiscard]] const Line* front() const;
  /// The message that was in sight when a button was pressed goes. @return it; empty: it has gone meanwhile
  std::optional<Line> takePressed();

  QTimer passes_{this};        ///< runs while a note is in sight
  std::vector<Line> waiting_;  ///< notes, then errors, each with the newest last: the last one is in sight
  int nextId_ = 1;
  int pressed_ = 0;  ///< id of the message that was in sight when a button was pressed
  QLabel* sentence_ = nullptr;
  QLabel* more_ = nullptr;
  QLabel* details_ = nullptr;
  QScrollArea* fold_ = nullptr;
  QPushButton* unfold_ = nullptr;
  QPushButton* offer_ = nullptr;
  QPushButton* close_ = nullptr;
};

}  // namespace ew::ui
