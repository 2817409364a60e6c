#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ew/sdk/host.h"
#include "panel/session/attempt_comments.h"
#include "panel/session/review_selection.h"

namespace ew::review {

/// Work that a page holds beside the comments: typed, and not kept yet.
struct PageWork {
  std::function<bool()> keep;            ///< asked before anything else is reviewed @return false: it could not be kept
  std::function<std::string()> unsaved;  ///< as PanelDocument::unsaved
};

/// What the panel edits, as the window's undo, redo and save see it: the comments on the attempt that is reviewed, and what pages hold.
class ReviewDocument final : public QObject, public sdk::PanelDocument {
  Q_OBJECT

 public:
  ReviewDocument(const ReviewSelection& selection, AttemptComments& comments);

  [[nodiscard]] std::string title() const override;
  [[nodiscard]] std::string remark() const override;
  [[nodiscard]] std::string note() const override { return {}; }
  [[nodiscard]] std::string undoText() const override;
  [[nodiscard]] std::string redoText() const override;
  void undo() override { comments_.undo(); }
  void redo() override { comments_.redo(); }
  void save(bool elsewhere) override;
  [[nodiscard]] std::string unsaved() const override;
  [[nodiscard]] std::shared_ptr<void> onChanged(std::function<void()> callback) override;

  /// Asked for as long as the ticket lives.
  [[nodiscard]] std::shared_ptr<void> holdWork(PageWork work);
  /// What pages hold may become comments: it is asked for first. @return false: something could not be kept, and nothing else is opened
  [[nodiscard]] bool keepAll();
  void tell();  ///< title or comments are others

 private:
  const ReviewSelection& selection_;
  AttemptComments& comments_;
  std::vector<std::weak_ptr<std::function<void()>>> listeners_;
  std::vector<std::weak_ptr<PageWork>> works_;
};

}  // namespace ew::review
