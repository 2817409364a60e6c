#include "logic/recovery.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <string_view>
#include <system_error>

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBegin = "unsaved-", kEnd = ".json";
constexpr int kMostPlaces = 10000;

/// Held until the file is closed. -1: another window holds it, or nothing can be locked here.
int locked(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor < 0) return -1;
  while (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    ::close(descriptor);
    return -1;
  }
  return descriptor;
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
    if (lock_ < 0) {
      if (fs::exists(lockOf(number_), ignored)) continue;  // another window's
      break;
    }
    if (!fs::exists(fileOf(number_), ignored)) return;
    ::close(lock_);  // written and left between the two looks
    lock_ = -1;
  }
}

RecoveryPlace::~RecoveryPlace() {
  if (lock_ >= 0) ::close(lock_);  // its file stays: were it removed, two windows could hold two files of one name
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
    if (fs::exists(lockOf(number), ignored)) {
      const int lock = locked(lockOf(number));
      if (lock < 0) continue;  // of a window that lives
      ::close(lock);
    }
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
