#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "ew/library/case.h"
#include "jobs.h"

namespace ew::ui {

/// Makes the volumes of the cases that have none yet, one after the other, quietly in the background: the job's threads give way to
/// everything else. Whatever stops it (a cancel, another case to be opened, the end of the program) loses nothing but the step in work.
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

  explicit CasePreparation(Jobs& jobs, QObject* parent = nullptr);

  /// Prepares these in the order of preparationOrder; cases that were stopped by the user are not asked again.
  void start(const std::vector<Case>& cases);
  /// Gives the machine to something that a user waits for.
  void pause();
  void resume();
  /// A case whose preparation the user stopped: it waits until it is asked for again.
  void stop(const std::string& caseId);
  /// What is known of a case, by its files; quick.
  [[nodiscard]] Seen seen(const Case& shown) const;
  [[nodiscard]] bool isIdle() const { return job_ == 0 && waiting_.empty(); }

 Q_SIGNALS:
  void changed();  ///< a state or the progress of one
  void prepared(const QString& caseId);
  void failed(const Error& error);
  void noted(const QString& note);

 private:
  void next();

  Jobs& jobs_;
  std::deque<Case> waiting_;
  std::vector<std::string> stopped_;
  std::optional<Case> running_;
  QTimer poll_;
  int job_ = 0;
  bool paused_ = false;
};

}  // namespace ew::ui
