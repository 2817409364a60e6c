#include "panel/session/review_document.h"

#include <utility>

namespace ew::review {

ReviewDocument::ReviewDocument(const ReviewSelection& selection, AttemptComments& comments) : selection_(selection), comments_(comments) {
  connect(&comments_, &AttemptComments::documentChanged, this, &ReviewDocument::tell);
}

std::string ReviewDocument::title() const {
  const LessonAttempts* of = selection_.lesson();
  return of != nullptr ? of->words.of(of->lesson.title) : tr("Review").toStdString();
}

std::string ReviewDocument::remark() const { return comments_.isSaved() ? std::string() : tr("not saved").toStdString(); }

std::string ReviewDocument::undoText() const { return comments_.history() != nullptr ? comments_.history()->undoName() : std::string(); }

std::string ReviewDocument::redoText() const { return comments_.history() != nullptr ? comments_.history()->redoName() : std::string(); }

std::string ReviewDocument::unsaved() const {
  std::string lost = comments_.isSaved() ? std::string() : tr("Comments on an attempt are not saved.").toStdString();
  for (const auto& each : works_)
    if (const auto work = each.lock())
      if (const std::string more = work->unsaved(); !more.empty()) lost += (lost.empty() ? "" : " ") + more;
  return lost;
}

std::shared_ptr<void> ReviewDocument::holdWork(PageWork work) {
  auto kept = std::make_shared<PageWork>(std::move(work));
  std::erase_if(works_, [](const auto& each) { return each.expired(); });
  works_.push_back(kept);
  return kept;
}

std::shared_ptr<void> ReviewDocument::onChanged(std::function<void()> callback) {
  auto kept = std::make_shared<std::function<void()>>(std::move(callback));
  listeners_.push_back(kept);
  return kept;
}

void ReviewDocument::tell() {
  std::erase_if(listeners_, [](const auto& each) { return each.expired(); });
  const auto all = listeners_;
  for (const auto& each : all)
    if (const auto callback = each.lock()) (*callback)();
}

bool ReviewDocument::keepAll() {
  bool areKept = true;
  const auto works = works_;
  for (const auto& each : works)
    if (const auto work = each.lock()) areKept = work->keep() && areKept;
  return comments_.save() && areKept;
}

void ReviewDocument::save(bool) { static_cast<void>(keepAll()); }

}  // namespace ew::review
