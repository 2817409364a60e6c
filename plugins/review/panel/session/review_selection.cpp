#include "panel/session/review_selection.h"

#include <algorithm>

#include "panel/session/review_scan.h"

namespace ew::review {
namespace {

namespace fs = std::filesystem;

}  // namespace

void ReviewSelection::takeShelf(std::shared_ptr<const ScanShelf> shelf) {
  const std::string lessonId = lesson() ? lesson()->lesson.id : std::string(), caseId = lesson() ? lesson()->home.id : std::string();
  const std::string attemptId = attempt() ? attempt()->second.id : std::string();
  shelf_ = std::move(shelf);
  hasShelf_ = true;
  lesson_.reset();
  attempt_.reset();
  for (std::size_t n = 0; n < shelf_->lessons.size(); ++n)
    if (shelf_->lessons[n].lesson.id == lessonId && shelf_->lessons[n].home.id == caseId) lesson_ = n;
  if (lesson())
    for (std::size_t n = 0; n < lesson()->attempts.size(); ++n)
      if (lesson()->attempts[n].second.id == attemptId) attempt_ = n;
}

const LessonAttempts* ReviewSelection::lesson() const {
  return lesson_ && *lesson_ < shelf_->lessons.size() ? &shelf_->lessons[*lesson_] : nullptr;
}

const std::pair<fs::path, Attempt>* ReviewSelection::attempt() const {
  const LessonAttempts* of = lesson();
  return of != nullptr && attempt_ && *attempt_ < of->attempts.size() ? &of->attempts[*attempt_] : nullptr;
}

const LessonStep* ReviewSelection::step() const {
  if (lesson() == nullptr) return nullptr;
  for (const LessonStep& each : lesson()->lesson.steps)
    if (each.id == stepId_) return &each;
  return nullptr;
}

void ReviewSelection::setLesson(std::size_t number) {
  lesson_ = number;
  attempt_.reset();
  stepId_.clear();
}

void ReviewSelection::setAttempt(std::size_t number) {
  attempt_ = number;
  const auto& [folder, tried] = *attempt();
  const auto isRecorded = [&, &folder = folder, &tried = tried](const LessonStep& each) {
    return scanOfStep(folder, tried, each).has_value();
  };
  const auto& steps = lesson()->lesson.steps;
  if (step() == nullptr || !isRecorded(*step())) {
    const auto first = std::find_if(steps.begin(), steps.end(), isRecorded);
    stepId_ = first != steps.end() ? first->id : steps.empty() ? std::string() : steps.front().id;
  }
}

void ReviewSelection::addComparison(const ScanChoice& choice) {
  comparisons_.push_back(choice);
  comparison_ = comparisons_.size() - 1;
}

std::array<std::optional<ScanChoice>, 2> ReviewSelection::listScans() {
  comparisons_.clear();
  comparison_.reset();
  std::array<std::optional<ScanChoice>, 2> choices;
  if (const LessonAttempts* of = lesson(); of != nullptr) {
    comparisons_ = expertScansOf(of->home, of->lesson);
    if (!comparisons_.empty()) comparison_ = usualExpertFor(of->lesson, stepId_, comparisons_);
    for (std::size_t n = 0; step() != nullptr && n < of->attempts.size(); ++n) {
      const auto& [folder, tried] = of->attempts[n];
      auto scan = scanOfStep(folder, tried, *step());
      if (!scan) continue;
      if (attempt_ == n)
        choices[kReviewed] = std::move(scan);
      else
        comparisons_.push_back(std::move(*scan));
    }
    if (!comparison_ && !comparisons_.empty()) comparison_ = 0;
    if (comparison_) choices[kCompared] = comparisons_[*comparison_];
  }
  return choices;
}

}  // namespace ew::review
