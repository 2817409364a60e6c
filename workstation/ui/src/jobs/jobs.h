#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew::ui {

/// Long work off the window's thread. Each job has its own thread, because a job may wait for a disk for long; there are never many.
class Jobs final : public QObject {
  Q_OBJECT

 public:
  using Work = std::function<Result<void>(Progress&)>;
  using Done = std::function<void(const Result<void>&)>;

  /// Whether someone waits for the job. Work in the background does not keep the window from being settled. What is being saved is lost
  /// when the job is cancelled, so nobody cancels it without asking.
  enum class Kind { awaited, background, saving };

  /// What can be seen of a job from the window's thread.
  struct Seen {
    int id = 0;
    QString title;
    QString step;
    double fraction = 0.0;
    double age_s = 0.0;
    bool cancelling = false;
    Kind kind = Kind::awaited;
  };

  explicit Jobs(QObject* parent = nullptr);
  ~Jobs() override;  ///< cancels and waits

  /// @param work runs on a worker; an exception it lets through becomes an Error
  /// @param done runs on this object's thread afterwards, also after a failure or a cancel
  /// @return the job's id
  int start(const QString& title, Work work, Done done, Kind kind = Kind::awaited);
  /// The same, and comes back once it is done with its outcome: for what nobody may do anything beside. Until then the window draws, and
  /// takes no key and no click; what other jobs have made is taken over as ever.
  [[nodiscard]] Result<void> await(const QString& title, Work work);
  void cancel(int id);
  /// Of a job that knows by now what it is about; an id that is none does nothing.
  void rename(int id, const QString& title);
  /// Whether a job runs that someone waits for.
  [[nodiscard]] bool isRunning() const;
  [[nodiscard]] bool isSaving() const;
  [[nodiscard]] std::vector<Seen> seen() const;
  /// Cancels everything, waits until it has stopped, and calls every `done`.
  void cancelAllAndWait();

 Q_SIGNALS:
  void started(int id);
  void finished(int id);
  void problem(const ew::Error& error);  ///< a `done` threw
  void notSaved(int id);                 ///< a job of Kind::saving has failed or was cancelled; after its `done`

 private:
  struct Job;
  void deliver(int id);
  std::vector<std::unique_ptr<Job>> running_;
  int nextId_ = 1;
};

}  // namespace ew::ui
