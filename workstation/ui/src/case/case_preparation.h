#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <deque>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "ew/library/case.h"
#include "jobs/jobs.h"

namespace ew::ui {

/// Makes the volumes of the cases that have none yet, one after the other, quietly in the background: the job's threads give way to
/// everything else. A case that somebody asked for goes before those that nobody has, and waits for no other. Whatever stops a preparation
/// (a cancel, another case to be opened, the end of the program) loses next to nothing: it goes on where it was.
class CasePreparation final : public QObject {
  Q_OBJECT

 public:
  enum class State { ready, waiting, running, stopped };
  /// What a card shows of a case.
  struct Seen {
    State state = State::ready;
    double estimate_s = 0.0;  ///< of what is still to be done, before it begins
    double fraction = 0.0;    ///< while it runs
    QString step;
  };

  /// How far the threads give way, 0 to 19: to everything else when nobody waits for the case, half as far when somebody does.
  static constexpr int kMostQuiet = 19;
  explicit CasePreparation(Jobs& jobs, QObject* parent = nullptr, int quiet = kMostQuiet);

  /// Prepares these, which nobody has asked for, in the order of preparationOrder; cases that were stopped by the user are not asked again.
  void start(const std::vector<Case>& cases);
  /// Prepares a case that somebody wants, at once: behind others that were asked for, before the rest, and also while that is held.
  void ask(const Case& wanted);
  /// The same of a case whose draft is on show: before all others, on all threads, and each of them gives way to everything else.
  void askForShown(const Case& shown);
  [[nodiscard]] bool isAskedFor(const std::string& caseId) const;
  /// Whether cases that nobody has asked for wait, because somebody works with the machine.
  void hold(bool holds);
  /// Cases that nobody has asked for wait until they are opened, or for the next start.
  void later();
  /// Gives the machine to something that a user waits for.
  void pause();
  void resume();
  /// A case whose preparation the user stopped: it waits until it is asked for again.
  void stop(const std::string& caseId);
  /// What is known of a case. Its files are asked once, until a preparation ends or forget().
  [[nodiscard]] Seen seen(const Case& shown) const;
  /// Files may have changed.
  void forget() { left_.clear(); }
  [[nodiscard]] bool isIdle() const { return job_ == 0 && waiting_.empty(); }

 Q_SIGNALS:
  void changed();  ///< a state or the progress of one
  void prepared(const QString& caseId);
  void failed(const Error& error);
  void noted(const QString& note);

 private:
  void next();
  void queue(const Case& wanted, bool isFirst);
  void giveBackRunning();
  void ended(const Result<void>& outcome);
  [[nodiscard]] bool mayRun(const Case& each) const { return !isHeld_ || isAskedFor(each.id); }

  /// Of the preparation of a case.
  struct Left {
    bool isAny = false;
    double estimate_s = 0.0;
  };

  Jobs& jobs_;
  mutable std::map<std::filesystem::path, Left> left_;
  const int quiet_;
  std::deque<Case> waiting_;
  std::vector<std::string> stopped_;
  std::vector<std::string> asked_;
  std::string shown_;  ///< of these, the one whose draft is on show
  std::optional<Case> running_;
  QTimer poll_;
  int job_ = 0;
  bool paused_ = false;
  bool isHeld_ = false;
  bool isGivenBack_ = false;  ///< the running one was cancelled for another one's sake, not by somebody who wants it stopped
};

/// A case's title for trainees in the window's language.
[[nodiscard]] QString shownTitle(const Case& opened);

/// "about 3 minutes": a person's unit, and no finer than can be known.
[[nodiscard]] QString aboutMinutes(double seconds);

}  // namespace ew::ui
