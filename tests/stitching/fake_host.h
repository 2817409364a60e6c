#pragma once

#include <string>

#include "ew/sdk/host.h"

namespace ew::test {

/// Texts on disk without any care: what the logic does on top is under test.
class PlainFiles final : public sdk::Files {
 public:
  Result<std::string> readText(const std::filesystem::path& file) override;
  Result<void> writeText(const std::filesystem::path& file, const std::string& text) override;
};

}  // namespace ew::test
