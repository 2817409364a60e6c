#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "logic/painting_autosave.h"

namespace ew::case_authoring {

/// Keeps painting aside in jobs, one after the other and always the latest: what is left in the end is what was painted last, whichever job
/// would have been quicker. On the window's thread, but for the work.
class KeepingAside final : public std::enable_shared_from_this<KeepingAside> {
 public:
  /// What is kept, with the case it belongs to as it was then.
  struct Painted {
    Volume labels;
    std::filesystem::path caseFolder;
    std::string before;  ///< what the case names as its labels; may be empty
  };
  using Work = std::function<Result<void>(Progress&)>;
  using Done = std::function<void(const Result<void>&)>;
  /// Runs work on a worker and then `done` on the window's thread.
  using Start = std::function<void(Work work, Done done)>;

  KeepingAside(std::filesystem::path root, Start start) : kept_(std::move(root)), start_(std::move(start)) {}

  /// From now on work is started so.
  void startWith(Start start) { start_ = std::move(start); }
  /// In place of what was kept before, and of what waits for its turn. @param told what came of it; not called for what was replaced
  void keep(Painted painted, Done told);
  /// The user has decided: nothing is kept any more, also not what is on its way.
  void forget();
  /// What is kept, or on its way, stays as if the program had ended.
  void leave();
  [[nodiscard]] bool isBusy() const { return isBusy_; }
  [[nodiscard]] const PaintingAutosave& kept() const { return kept_; }

 private:
  struct Next {
    Painted painted;
    Done told;
  };
  enum class Then { goOn, forget, leave };
  void begin(Next next);
  void ended();

  PaintingAutosave kept_;
  Start start_;
  bool isBusy_ = false;
  std::optional<Next> waiting_;
  Then then_ = Then::goOn;  ///< once the last job has ended
};

}  // namespace ew::case_authoring
