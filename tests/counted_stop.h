#pragma once

#include <atomic>
#include <limits>
#include <string_view>

#include "ew/core/progress.h"

namespace ew::test {

/// Asks work to stop and counts how far it goes on all the same: in its own questions and reports, which are the same on a busy, a slow and
/// a fast machine, where seconds are not. Work asks between pieces of bounded size and reports what it finished, so few questions and
/// reports after the wish mean a short way to the end; that it could be stopped at question n means that it asks at least n times.
class CountedStop final : public Progress {
 public:
  /// @param question that is the first to be answered with yes; counted from 1
  static CountedStop atQuestion(long question) { return {question, std::numeric_limits<long>::max(), 2.0}; }
  static CountedStop atReport(long report) { return {std::numeric_limits<long>::max(), report, 2.0}; }
  /// At the first report of at least this fraction.
  static CountedStop atFraction(double fraction) { return {std::numeric_limits<long>::max(), std::numeric_limits<long>::max(), fraction}; }
  /// Only counts.
  static CountedStop never() { return atQuestion(std::numeric_limits<long>::max()); }

  void report(const Message&, double fraction) override {
    if (wished_) ++reportsAfter_;
    if (++reports_ >= atReport_ || fraction >= atFraction_) wished_ = true;
  }
  [[nodiscard]] bool cancelRequested() const override {
    if (wished_) ++questionsAfter_;
    if (++questions_ >= atQuestion_) wished_ = true;
    return wished_;
  }

  [[nodiscard]] bool wished() const { return wished_; }
  [[nodiscard]] long questions() const { return questions_; }
  [[nodiscard]] long reports() const { return reports_; }
  [[nodiscard]] long questionsAfter() const { return questionsAfter_; }  ///< the wish
  [[nodiscard]] long reportsAfter() const { return reportsAfter_; }

 private:
  CountedStop(long question, long report, double fraction) : atQuestion_(question), atReport_(report), atFraction_(fraction) {}

  long atQuestion_, atReport_;
  double atFraction_;
  mutable std::atomic<bool> wished_{false};
  mutable std::atomic<long> questions_{0}, questionsAfter_{0};
  std::atomic<long> reports_{0}, reportsAfter_{0};
};

/// How often all threads together may ask once more, and how many pieces they may still finish, until work has ended: each its own piece,
/// and a few levels of calls above it.
inline constexpr long kMostQuestionsAfter = 64;
inline constexpr long kMostReportsAfter = 16;

}  // namespace ew::test
