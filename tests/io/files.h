#pragma once

#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew::test {

/// A folder of a test's own that goes with it.
class TempFolder {
 public:
  TempFolder() {
    static std::atomic<int> counter{0};
    path_ = std::filesystem::temp_directory_path() / ("ew-io-" + std::to_string(getpid()) + "-" + std::to_string(counter++));
    std::filesystem::create_directories(path_);
  }
  ~TempFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Writes `bytes` and gives the file's path.
  [[nodiscard]] std::filesystem::path put(const std::string& name, const std::string& bytes) const {
    // Emptying a file that exists makes some file systems write it out at once: thousands of rounds would take minutes.
    std::filesystem::remove(path_ / name);
    std::ofstream out(path_ / name, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return path_ / name;
  }

  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) found.push_back(entry.path().filename().string());
    return found;
  }

 private:
  std::filesystem::path path_;
};

inline std::string bytesOfFile(const std::filesystem::path& file) {
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

/// Packed as zlib, or as gzip.
inline std::string deflated(const std::string& bytes, bool gzip = false) {
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, gzip ? 15 + 16 : 15, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, bytes.size()) + 64, '\0');
  std::string copy = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(copy.data());
  stream.avail_in = static_cast<uInt>(copy.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

/// Samples as the bytes of a file.
template <class T>
std::string bytesOf(const std::vector<T>& samples, bool bigEndian = false) {
  std::string bytes;
  for (const T sample : samples) {
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(sample);
    if (bigEndian != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.begin(), raw.end());
  }
  return bytes;
}

/// 0, 1, 2 ... as bytes.
inline std::string ramp(std::size_t count) {
  std::string bytes(count, '\0');
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<char>(i);
  return bytes;
}

template <class T>
::testing::AssertionResult succeeded(const Result<T>& result) {
  if (result) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << result.error();
}

/// Failed with this code and a sentence that is one: it ends with a full stop and tells what to do after a semicolon or comma.
template <class T>
::testing::AssertionResult failedWith(const Result<T>& result, ErrorCode code) {
  if (result) return ::testing::AssertionFailure() << "it succeeded";
  if (result.error().code != code) return ::testing::AssertionFailure() << "other error: " << result.error();
  if (!result.error().sentence().ends_with('.')) return ::testing::AssertionFailure() << "no full stop: " << result.error();
  return ::testing::AssertionSuccess();
}

template <class T>
::testing::AssertionResult says(const Result<T>& result, const std::string& words) {
  if (result) return ::testing::AssertionFailure() << "it succeeded";
  if (result.error().sentence().find(words) == std::string::npos) return ::testing::AssertionFailure() << result.error();
  return ::testing::AssertionSuccess();
}

inline ::testing::AssertionResult contains(const std::vector<Message>& notes, const std::string& words) {
  for (const Message& note : notes)
    if (note.english().find(words) != std::string::npos) return ::testing::AssertionSuccess();
  auto failed = ::testing::AssertionFailure() << "no note says \"" << words << "\":";
  for (const Message& note : notes) failed << "\n  " << note;
  return failed;
}

/// Stops the work when it has asked `after` times.
class StopAfter final : public Progress {
 public:
  explicit StopAfter(int after) : left_(after) {}
  void report(const Message&, double fraction) override {
    EXPECT_GE(fraction, last_);
    EXPECT_LE(fraction, 1.0);
    last_ = fraction;
  }
  [[nodiscard]] bool cancelRequested() const override { return left_-- <= 0; }

 private:
  mutable int left_;
  double last_ = 0.0;
};

}  // namespace ew::test
