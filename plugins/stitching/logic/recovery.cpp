#include "logic/recovery.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <system_error>

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBegin = "unsaved-", kEnd = ".json";
constexpr int kMostPlaces = 10000;

/// Nothing: another window holds it, or its file cannot be made.
std::optional<FileLock> locked(const fs::path& file) {
  auto taken = FileLock::tryTake(file, FileLock::Kind::alone, 0600);
  return taken ? std::move(*taken) : std::nullopt;
}

/// 0: the name is another one's.
int numberOf(const std::string& name) {
  if (name.size() <= kBegin.size() + kEnd.size() || !name.starts_with(kBegin) || !name.ends_with(kEnd)) return 0;
  int number = 0;
  const char* const end = name.data() + name.size() - kEnd.size();
  const auto [at, problem] = std::from_chars(name.data() + kBegin.size(), end, number);
  return problem == std::errc() && at == end && number > 0 ? number : 0;
}

}  // namespace

RecoveryPlace::RecoveryPlace(fs::path folder) : folder_(std::move(folder)) {
  std::error_code ignored;
  fs::create_directories(folder_, ignored);
  for (number_ = 1; number_ < kMostPlaces; ++number_) {
    if (fs::exists(fileOf(number_), ignored)) continue;
    lock_ = locked(lockOf(number_));
    if (!lock_) {
      if (fs::exists(lockOf(number_), ignored)) continue;  // another window's
      break;
    }
    if (!fs::exists(fileOf(number_), ignored)) return;
    lock_.reset();  // written and left between the two looks
  }
}

fs::path RecoveryPlace::fileOf(int number) const { return folder_ / (std::string(kBegin) + std::to_string(number) + std::string(kEnd)); }

fs::path RecoveryPlace::lockOf(int number) const { return folder_ / (std::string(kBegin) + std::to_string(number) + ".lock"); }

std::vector<int> RecoveryPlace::left() const {
  struct Found {
    fs::file_time_type time;
    int number = 0;
  };
  std::vector<Found> found;
  std::error_code ignored;
  for (auto at = fs::directory_iterator(folder_, ignored); at != fs::directory_iterator(); at.increment(ignored)) {
    const int number = numberOf(at->path().filename().string());
    if (number == 0 || number == number_ || !at->is_regular_file(ignored)) continue;
    if (fs::exists(lockOf(number), ignored) && !locked(lockOf(number))) continue;  // of a window that lives
    found.push_back({at->last_write_time(ignored), number});
  }
  std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.time > b.time; });
  std::vector<int> numbers;
  for (const Found& each : found) numbers.push_back(each.number);
  return numbers;
}

void RecoveryPlace::forget(int number) const {
  std::error_code ignored;
  fs::remove(fileOf(number), ignored);
}

}  // namespace ew::stitching
