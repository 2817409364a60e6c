#pragma once

#include <QObject>
#include <QString>
#include <array>
#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "ew/library/case.h"
#include "ew/scanning/subject.h"
#include "ew/sdk/host.h"
#include "logic/scan_shelf.h"
#include "panel/session/review_scan.h"

namespace ew::bridge {
struct Mannequin;
}

namespace ew::review {

struct Opening;

/// The scans that are open, each beside the other, and the body they were made on. They are opened in a job; of several wishes the newest
/// is taken.
class ScanPair final : public QObject {
  Q_OBJECT

 public:
  explicit ScanPair(sdk::Host& host) : host_(host) {}
  ~ScanPair() override;

  [[nodiscard]] const ReviewScan* opened(Side side) const { return opened_[side].get(); }
  [[nodiscard]] std::shared_ptr<const ReviewScan> sharedScan(Side side) const { return opened_[side]; }
  [[nodiscard]] bool isOpening() const { return opening_ > 0; }
  /// Why there is less than was chosen, as a sentence; empty: there is not.
  [[nodiscard]] const QString& problem() const { return problem_; }
  [[nodiscard]] const std::shared_ptr<const bridge::Mannequin>& mannequin() const { return mannequin_; }

  /// @param step that figures are worked out of @param whenOpened is to take it; called at once where nothing is chosen
  void open(std::array<std::optional<ScanChoice>, 2> choices, std::shared_ptr<const ScanShelf> shelf, const LessonStep* step,
            std::function<void(Opening&)> whenOpened);
  /// In place of what was open. It tells nobody: whoever takes it (ReviewSession) says when the rest has followed.
  void take(Opening& made);
  void keepWith(const QString& problem);  ///< what was opened is not taken, and why

 Q_SIGNALS:
  void changed();

 private:
  sdk::Host& host_;
  int opening_ = 0;
  QString problem_;
  std::array<std::shared_ptr<const ReviewScan>, 2> opened_;
  std::map<std::filesystem::path, std::pair<Case, CaseContents>> contents_;  ///< of the cases of the scans that are open
  std::shared_ptr<const bridge::Mannequin> mannequin_;
  std::filesystem::path mannequinFile_;
  std::shared_ptr<std::atomic<int>> wish_ = std::make_shared<std::atomic<int>>(0);  ///< number of the newest opening
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace ew::review
