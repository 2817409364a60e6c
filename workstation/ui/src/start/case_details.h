#pragma once

#include <QHash>
#include <QImage>
#include <QObject>
#include <QStringList>
#include <atomic>
#include <optional>

#include "ew/library/case.h"
#include "ew/scanning/first_image.h"
#include "ew/widgets/worker.h"

namespace ew::ui {

/// What cards show and no index knows: the image of a case, and the case itself, whose files say whether it is prepared. Read on a thread
/// of its own and for the cards in sight alone; images that are not kept yet are scanned there.
class CaseDetails final : public QObject {
  Q_OBJECT

 public:
  explicit CaseDetails(QObject* parent = nullptr);
  ~CaseDetails() override;

  /// Reads what is not known of these; what was wanted before and has not begun is dropped.
  void want(const QStringList& folders);
  /// Everything may have changed.
  void forget();
  /// Null until it was read, and for a case that cannot be.
  [[nodiscard]] const Case* of(const QString& folder) const;
  [[nodiscard]] bool isBusy() const { return waiting_ > 0; }

 Q_SIGNALS:
  void imageRead(const QString& folder, const QImage& image);
  void caseRead(const QString& folder);
  void rested();

 private:
  struct Read {
    QString folder;
    std::optional<Case> opened;
    QImage image;
  };
  void readOne(const QString& folder, int round, int epoch);
  void take(const Read& read, int epoch);
  QHash<QString, std::optional<Case>> known_;
  int waiting_ = 0;
  std::atomic<int> round_{0};  ///< what was wanted in an earlier one is not wanted any more
  int epoch_ = 0;              ///< what was read in an earlier one is forgotten
  std::atomic<bool> ends_{false};
  Beginnings there_;  ///< of the worker
  Worker worker_;
};

}  // namespace ew::ui
