#pragma once

#include <atomic>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ew/core/volume.h"
#include "ew/io/sequence.h"

namespace ew::test {

/// What a command said and returned.
struct Outcome {
  int status = -1;
  std::string out;
  std::string err;
};

/// Runs a command in this process.
Outcome run(const std::vector<std::string>& args, const std::atomic<bool>* cancel = nullptr, bool terminal = false);

/// A folder of its own that is gone afterwards.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Names of everything in it, sorted: what a command left behind.
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

void writeText(const std::string& file, const std::string& text);
std::string readText(const std::string& file);
nlohmann::json readJson(const std::string& file);

/// Sets an environment variable for the time of a test.
class EnvironmentValue {
 public:
  EnvironmentValue(const char* name, const std::string& value);
  ~EnvironmentValue();
  EnvironmentValue(const EnvironmentValue&) = delete;
  EnvironmentValue& operator=(const EnvironmentValue&) = delete;

 private:
  const char* name_;
  bool wasSet_ = false;
  std::string before_;
};

/// A volume whose echo is a ramp along i, j and k: 3 i + 5 j + 7 k + 20, spacing 1 mm, origin 0.
Volume rampVolume(const glm::ivec3& dims);

/// A sweep of `frames` parallel frames one mm apart along z, pixels of 1 mm, given by ImageToReference: its reconstruction at 1 mm with
/// nearest interpolation has exactly the frames as its slices. Pixel (x, y) of frame n is 1 + x + 10 y + 20 n.
Sequence parallelSweep(int width, int height, int frames);
std::uint8_t parallelSweepPixel(int x, int y, int frame);

inline const std::string kIdentityPose = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";

}  // namespace ew::test
