#include "logic/comment_history.h"

#include <algorithm>

namespace ew::review {

Result<CommentHistory> CommentHistory::open(const std::filesystem::path& attempt, const std::string& author) {
  auto file = readComments(attempt, author);
  if (!file) return passOn(file.error());
  CommentHistory made;
  made.attempt_ = attempt;
  made.saved_ = *file;
  made.states_ = History<CommentFile>(*std::move(file));
  return made;
}

const ReviewComment* CommentHistory::find(const std::string& id) const {
  for (const ReviewComment& each : comments())
    if (each.id == id) return &each;
  return nullptr;
}

std::string CommentHistory::add(ReviewComment comment, const std::string& what) {
  // One that was taken back may come again by redo: its id is not given twice.
  const auto isTaken = [&](const std::string& id) {
    return states_.wasEver([&](const CommentFile& file) {
      return std::any_of(file.comments.begin(), file.comments.end(), [&](const ReviewComment& each) { return each.id == id; });
    });
  };
  do comment.id = "comment-" + std::to_string(++given_);
  while (isTaken(comment.id));
  std::string id = comment.id;
  CommentFile next = states_.now();
  next.comments.push_back(std::move(comment));
  change(std::move(next), what, {});
  return id;
}

void CommentHistory::replace(const ReviewComment& comment, const std::string& what, const std::string& mergeKey) {
  CommentFile next = states_.now();
  for (ReviewComment& each : next.comments)
    if (each.id == comment.id) each = comment;
  change(std::move(next), what, mergeKey);
}

void CommentHistory::remove(const std::string& id, const std::string& what) {
  CommentFile next = states_.now();
  std::erase_if(next.comments, [&](const ReviewComment& each) { return each.id == id; });
  change(std::move(next), what, {});
}

void CommentHistory::change(CommentFile next, const std::string& what, const std::string& mergeKey) {
  std::stable_sort(next.comments.begin(), next.comments.end(), [](const ReviewComment& a, const ReviewComment& b) {
    return a.stepId != b.stepId ? a.stepId < b.stepId : a.time_s < b.time_s;
  });
  if (next == states_.now()) return;
  states_.step(std::move(next), what, mergeKey);
}

Result<void> CommentHistory::save() {
  if (auto written = writeComments(attempt_, states_.now()); !written) return written;
  saved_ = states_.now();
  states_.endMerging();
  return {};
}

}  // namespace ew::review
