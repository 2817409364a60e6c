#pragma once

#include <atomic>
#include <string_view>
#include <vector>

#include "one_file.h"

namespace ew::fuzz {

/// Parts that a line of its own, "%%", separates: several files in one input.
inline std::vector<std::string_view> partsOf(const std::uint8_t* bytes, std::size_t size) {
  constexpr std::string_view kLine = "\n%%\n";
  std::string_view rest(reinterpret_cast<const char*>(bytes), size);
  std::vector<std::string_view> parts;
  for (auto at = rest.find(kLine); at != std::string_view::npos; at = rest.find(kLine)) {
    parts.push_back(rest.substr(0, at));
    rest.remove_prefix(at + kLine.size());
  }
  parts.push_back(rest);
  return parts;
}

/// A folder of this process alone, in memory where the system has a place for that; the same one every time.
inline const std::filesystem::path& ownFolder() {
  static const std::filesystem::path folder = [] {
    const std::filesystem::path memory =
        std::filesystem::is_directory("/dev/shm") ? std::filesystem::path("/dev/shm") : std::filesystem::temp_directory_path();
    const auto own = memory / ("ew-fuzz-" + std::to_string(getpid()));
    std::filesystem::create_directories(own);
    // Whatever a reader keeps, it keeps here.
    ::setenv("ECHOWEAVE_CACHE", (own / "cache").c_str(), 1);
    return own;
  }();
  return folder;
}

inline std::filesystem::path put(const std::string& name, std::string_view text) {
  const auto file = ownFolder() / name;
  std::ofstream(file, std::ios::binary | std::ios::trunc).write(text.data(), static_cast<std::streamsize>(text.size()));
  return file;
}

/// A sentence and no more: never the file.
inline void checkSentence(const Error& error) {
  checkError(error);
  mustHold(error.sentence().size() < 100000);
}

/// Stops the work when it has been asked for so often: an input may describe more than anyone would wait for.
class SoMuch final : public Progress {
 public:
  explicit SoMuch(int questions) : left_(questions) {}
  void report(const Message&, double fraction) override { mustHold(fraction >= 0.0 && fraction <= 1.0); }
  [[nodiscard]] bool cancelRequested() const override { return left_.fetch_sub(1) <= 0; }

 private:
  mutable std::atomic<int> left_;
};

}  // namespace ew::fuzz
