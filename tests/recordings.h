#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "places.h"

namespace ew::test {

/// A file or folder of the real recordings that may lie beside a checkout; a user's clone has none.
inline std::filesystem::path recording(const std::string& name) {
  return std::filesystem::path(EW_SOURCE_DIR) / ".." / "shared" / "data" / name;
}

}  // namespace ew::test

/// Skips a test whose recordings are not there. `./check` counts these by their first words.
#define EW_NEEDS_RECORDING(name)                             \
  if (!std::filesystem::exists(::ew::test::recording(name))) \
  GTEST_SKIP() << "for want of recordings: ../shared/data/" << (name) << " is not there"
