#include "publishing/stamped_place.h"

#include <chrono>

#include "ew/library/timestamp.h"

namespace ew {

std::filesystem::path stampedPlace(const std::filesystem::path& parent, const std::string& ending) {
  std::error_code ignored;
  std::filesystem::create_directories(parent, ignored);
  std::string stamp = timestampText(std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()));
  std::erase(stamp, ':');
  std::filesystem::path place = parent / (stamp + ending);
  for (int n = 2; std::filesystem::exists(place, ignored); ++n) place = parent / (stamp + ending + "-" + std::to_string(n));
  return place;
}

}  // namespace ew
