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

  /// What can be seen of a job from the window's thread.
  struct Seen {
    int id = 0;
    QString title;
    QString step;
    double fraction = 0.0;
    double age_s = 0.0;
    bool cancelling = false;
  };

  explicit Jobs(QObject* parent = nullptr);
  ~Jobs() override;  ///< cancels and waits

  /// @param work runs on a worker; an exception it lets through becomes an Error
  /// @param done runs on this object's thread afterwards, also after a failure or a cancel
  /// @return the job's id
  int start(const QString& title, Work work, Done done);
  void cancel(int id);
  [[nodiscard]] bool isRunning() const { return !running_.empty(); }
  [[nodiscard]] std::vector<Seen> seen() const;
  /// Cancels everything, waits until it has stopped, and calls every `done`.
  void cancelAllAndWait();

 Q_SIGNALS:
  void started(int id);
  void finished(int id);

 private:
  struct Job;
  void deliver(int id);
  std::vector<std::unique_ptr<Job>> running_;
  int nextId_ = 1;
};

}  // namespace ew::ui
