#pragma once

#include <string>
#include <utility>

#include "ew/sdk/host.h"
#include "one_file.h"

namespace ew::fuzz {

/// A plugin's door to files behind which every file holds the bytes under test.
class OneText final : public sdk::Files {
 public:
  explicit OneText(std::string text) : text_(std::move(text)) {}
  Result<std::string> readText(const std::filesystem::path&) override { return text_; }
  Result<void> writeText(const std::filesystem::path&, const std::string&) override { return {}; }

 private:
  std::string text_;
};

}  // namespace ew::fuzz
