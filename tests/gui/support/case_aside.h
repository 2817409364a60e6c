#pragma once

#include <filesystem>
#include <future>
#include <vector>

#include "ew/library/case.h"

namespace ew::ui::testing {

// Cases as a test reads them while its window is there: on a thread of their own, for the window's expects that nobody reads one on it
// (ew/core/responsive_thread.h).

template <class Work>
[[nodiscard]] auto aside(Work work) {
  return std::async(std::launch::async, std::move(work)).get();
}

[[nodiscard]] inline Result<Case> loadCaseAside(const std::filesystem::path& folder) {
  return aside([&] { return loadCase(folder); });
}
[[nodiscard]] inline Result<CaseAsRead> readCaseAside(const std::filesystem::path& folder) {
  return aside([&] { return readCase(folder); });
}
[[nodiscard]] inline CaseList listCasesAside(const std::filesystem::path& folder) {
  return aside([&] { return listCases(folder); });
}
[[nodiscard]] inline std::vector<Error> validateCaseAside(const std::filesystem::path& folder) {
  return aside([&] { return validateCase(folder); });
}

}  // namespace ew::ui::testing
