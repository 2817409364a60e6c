#include "cli/cli_world.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "ew/cli/run_command.h"

namespace ew::test {

Outcome run(const std::vector<std::string>& args, const std::atomic<bool>* cancel, bool terminal) {
  std::ostringstream out, err;
  Outcome outcome;
  outcome.status = cli::runCommand(args, {out, err, terminal, cancel});
  outcome.out = out.str();
  outcome.err = err.str();
  return outcome;
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "ew-cli-test-XXXXXX").string();
  path_ = ::mkdtemp(pattern.data());
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::vector<std::string> TemporaryFolder::names() const {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(path_)) found.push_back(entry.path().filename().string());
  std::sort(found.begin(), found.end());
  return found;
}

void writeText(const std::string& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

std::string readText(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

nlohmann::json readJson(const std::string& file) { return nlohmann::json::parse(readText(file), nullptr, false); }

EnvironmentValue::EnvironmentValue(const char* name, const std::string& value) : name_(name) {
  if (const char* before = std::getenv(name)) {
    wasSet_ = true;
    before_ = before;
  }
  ::setenv(name, value.c_str(), 1);
}

EnvironmentValue::~EnvironmentValue() {
  if (wasSet_)
    ::setenv(name_, before_.c_str(), 1);
  else
    ::unsetenv(name_);
}

Volume rampVolume(const glm::ivec3& dims) {
  Volume volume;
  volume.grid.dims = dims;
  volume.echo.resize(volume.grid.voxelCount());
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i) volume.echo[volume.grid.indexOf(i, j, k)] = static_cast<std::uint8_t>(3 * i + 5 * j + 7 * k + 20);
  return volume;
}

std::uint8_t parallelSweepPixel(int x, int y, int frame) { return static_cast<std::uint8_t>(1 + x + 10 * y + 20 * frame); }

Sequence parallelSweep(int width, int height, int frames) {
  Sequence sweep;
  sweep.width = width;
  sweep.height = height;
  sweep.orientation = "MF";
  sweep.imageType = "BRIGHTNESS";
  for (int n = 0; n < frames; ++n) {
    SequenceFrame frame;
    frame.time_s = 0.1 * n;
    FrameTransform imageToReference{"Image", "Reference", glm::dmat4(1.0), PoseStatus::ok};
    imageToReference.matrix[3] = glm::dvec4(0.0, 0.0, n, 1.0);
    frame.transforms.push_back(imageToReference);
    sweep.frames.push_back(frame);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) sweep.pixels.push_back(parallelSweepPixel(x, y, n));
  }
  return sweep;
}

}  // namespace ew::test
