#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include "ew/core/result.h"
#include "ew/export/dicom_study.h"
#include "library/temporary_folder.h"

namespace ew::test {

template <class T>
::testing::AssertionResult succeeded(const Result<T>& result) {
  if (result) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << result.error();
}

/// Names in a folder.
inline std::set<std::string> namesIn(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

/// Whether a program is installed.
inline bool hasProgram(const std::string& name) {
  for (const std::string folder : {"/usr/bin/", "/usr/sbin/", "/usr/local/bin/"})
    if (::access((folder + name).c_str(), X_OK) == 0) return true;
  return false;
}

struct Said {
  int status = 0;
  std::string text;  ///< output and errors
};
/// Runs a program to its end. @param words of a shell: names of files of these tests need no quotes
inline Said said(const std::string& words) {
  Said result;
  FILE* const pipe = ::popen((words + " 2>&1").c_str(), "r");
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) result.text.append(buffer.data(), count);
  result.status = ::pclose(pipe);
  return result;
}

inline DicomStudy someStudy() {
  DicomStudy study;
  study.patient = {"Änne von der Ödland", "EWSIM-test", "female", 29};
  study.title = "Pregnancy: biometry";
  study.region = "pregnant womb";
  study.operators = "Trainee One";
  study.studyUid = dicomUidOf(1, 1);
  study.imagesUid = dicomUidOf(1, 2);
  study.reportsUid = dicomUidOf(1, 3);
  study.begun = std::chrono::sys_days(std::chrono::year(2026) / 11 / 25) + std::chrono::hours(7) + std::chrono::seconds(5);
  return study;
}

}  // namespace ew::test

/// Skips a test whose program is not installed (resources/packages/test.txt).
#define EW_NEEDS_PROGRAM(name) \
  if (!::ew::test::hasProgram(name)) GTEST_SKIP() << "for want of a program: " << (name) << " is not installed"
