#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/io/autosave.h"
#include "logic/lesson_run.h"

namespace ew::lessons {

/// Where a window and its plugins keep what is not saved yet, the same for all of them: the window offers it at the next start.
[[nodiscard]] std::filesystem::path autosaveFolder();

/// The step of a lesson that runs, kept as it grows where a crash does not take it.
class StepAutosave {
 public:
  /// What a crash has left of a step.
  struct Left {
    std::filesystem::path attempt;  ///< its folder
    std::string stepId;
    ScanLog log;  ///< what was scanned in it, on the clock of that time
    double used_s = 0.0;
    int hints = 0;
    std::shared_ptr<Autosave::Left> kept;  ///< goes when it has been taken up, or the step began anew
  };

  explicit StepAutosave(const std::filesystem::path& root = autosaveFolder()) : kept_(root) {}

  /// A step of an attempt begins. @param caseFolder of the case that holds the lesson @param title of that case, for trainees
  void begin(const LessonRun& run, const std::filesystem::path& caseFolder, const std::string& title);
  /// What has been seen since.
  void grow(const LessonRun& run, double now_s);
  /// The step was ended or skipped. With the last one that was open the attempt is finished, and there is nothing to offer any more.
  void endStep(const LessonRun& run);
  /// The lesson was left or finished.
  void forget();
  /// What was left of an attempt's running step. When several programs left something, because one that went on with it could not keep it,
  /// it is what has most of it; the rest stays, as does what cannot be read. @param attempt its folder
  [[nodiscard]] std::optional<Left> takeLeft(const std::filesystem::path& attempt) const;
  /// The same of the first of these attempts of which something was left.
  [[nodiscard]] std::optional<Left> takeLeftOfAny(const std::vector<std::filesystem::path>& attempts) const;
  /// Once what was handed over before is kept here, what was left behind goes.
  void discardOnceKept(const std::shared_ptr<Autosave::Left>& left);
  void flush() { kept_.flush(); }

 private:
  Autosave kept_;
  std::size_t events_ = 0;  ///< of the step's log that are kept
  bool isKept_ = false;
};

}  // namespace ew::lessons
