#include "run/console_progress.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "ew/core/printable.h"

namespace ew::cli {
namespace {

constexpr int kBarWidth = 32;
constexpr auto kRedrawEvery = std::chrono::milliseconds(80);

}  // namespace

ConsoleProgress::~ConsoleProgress() { clear(); }

bool ConsoleProgress::cancelRequested() const { return surroundings_.cancel && surroundings_.cancel->load(std::memory_order_relaxed); }

void ConsoleProgress::report(const Message& what, double fraction) {
  if (quiet_ || !std::isfinite(fraction)) return;
  const std::lock_guard lock(mutex_);
  fraction = fraction_ =
      std::max(fraction_, std::clamp(fraction, 0.0, 1.0));  // a step that is done in two ways begins anew, a bar does not
  const bool newStep = what != what_;
  if (newStep) what_ = what;
  if (surroundings_.errIsTerminal) {
    const auto now = std::chrono::steady_clock::now();
    if (!newStep && now - lastDrawn_ < kRedrawEvery && fraction < 1.0) return;
    lastDrawn_ = now;
    drawBar(fraction);
    return;
  }
  const int tenth = static_cast<int>(fraction * 10.0);
  if (!newStep && tenth <= shownTenth_) return;
  shownTenth_ = std::max(tenth, shownTenth_);
  writeLine(fraction);
}

void ConsoleProgress::drawBar(double fraction) {
  const int full = static_cast<int>(std::lround(fraction * kBarWidth));
  std::string bar = "\r\x1b[2K[";
  for (int cell = 0; cell < kBarWidth; ++cell) bar += cell < full ? '#' : '.';
  const std::string percent = std::to_string(std::lround(fraction * 100.0));
  bar += "] " + std::string(3 - std::min<std::size_t>(3, percent.size()), ' ') + percent + " %  " + printableLine(what_.english());
  surroundings_.err << bar << std::flush;
  barShown_ = true;
}

void ConsoleProgress::writeLine(double fraction) {
  const std::string percent = std::to_string(std::lround(fraction * 100.0));
  surroundings_.err << std::string(3 - std::min<std::size_t>(3, percent.size()), ' ') + percent + " %  " + printableLine(what_.english()) +
                           "\n"
                    << std::flush;
}

void ConsoleProgress::clear() {
  const std::lock_guard lock(mutex_);
  if (!barShown_) return;
  surroundings_.err << "\r\x1b[2K" << std::flush;
  barShown_ = false;
}

}  // namespace ew::cli
