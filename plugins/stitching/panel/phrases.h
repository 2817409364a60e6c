#pragma once

#include <QString>
#include <QStringList>
#include <mutex>
#include <string>

#include "ew/core/progress.h"

namespace ew::stitching {

/// What the libraries say, in the window's language. They speak English and know no translator: sentences of errors and names of steps
/// are looked up among those registered in phrases.cpp, with what stands at their %1, %2, … kept (and looked up itself). A sentence that
/// is not among them stays English. A test reads the libraries' sources and fails on a sentence that is missing.
/// May be called from any thread.
[[nodiscard]] QString phraseOf(const std::string& english);

/// Whether the sentence is registered.
[[nodiscard]] bool isPhrase(const std::string& english);

/// All that are registered.
[[nodiscard]] QStringList phrases();

/// Passes steps on in the window's language.
class ProgressInWords final : public Progress {
 public:
  explicit ProgressInWords(Progress& whole) : whole_(whole) {}
  void report(std::string_view what, double fraction) override;
  [[nodiscard]] bool cancelRequested() const override { return whole_.cancelRequested(); }

 private:
  Progress& whole_;
  std::mutex mutex_;
  std::string english_, words_;  ///< the last step
};

}  // namespace ew::stitching
