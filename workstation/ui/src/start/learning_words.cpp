#include "start/learning_words.h"

#include <QDateTime>
#include <QLocale>
#include <algorithm>

#include "start/course_strip.h"

namespace ew::ui {
QString standingWords(const LessonStanding& standing, std::size_t steps) {
  if (standing.interrupted) return CourseStrip::tr("Stopped in step %1 of %2").arg(std::min(standing.interruptedAt + 1, steps)).arg(steps);
  if (standing.isPassed(steps)) return CourseStrip::tr("Passed");
  if (standing.attempts > 0) return CourseStrip::tr("%1 of %2 steps passed").arg(standing.bestPassed).arg(standing.counting(steps));
  return CourseStrip::tr("Not begun yet");
}

QString standingSign(const LessonStanding& standing, std::size_t steps) {
  if (standing.isPassed(steps)) return QStringLiteral("\u2713");
  return standing.attempts > 0 || standing.interrupted ? QStringLiteral("\u25d0") : QStringLiteral("\u25cb");
}

QString startWords(const LessonStanding& standing, std::size_t steps) {
  if (standing.interrupted) return CourseStrip::tr("Go on");
  return standing.isPassed(steps) ? CourseStrip::tr("Once more") : CourseStrip::tr("Start");
}

QString dayWords(std::chrono::sys_seconds moment) {
  const QDateTime at = QDateTime::fromSecsSinceEpoch(moment.time_since_epoch().count());
  return QLocale().toString(at.date(), QLocale::ShortFormat);
}

}  // namespace ew::ui
