#include "making/old_results.h"

#include <signal.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "ew/core/output_set.h"
#include "ew/io/content_key.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDigits = 32;
constexpr auto kSettled = std::chrono::hours(24);  // another machine may write into a shared home, under a number that is free here
constexpr std::array<std::string_view, 9> kEndings{".json", ".mha",     ".coverage.mha", ".labels.mha", ".truth.json",
                                                   ".lock", ".igs.mha", ".xml",          ".raw"};

/// The key of one of the pipeline's own files; empty for any other name.
std::string keyOf(std::string_view name) {
  if (name.size() <= kDigits || !isContentKey(name.substr(0, kDigits))) return {};
  const auto ending = name.substr(kDigits);
  return std::find(kEndings.begin(), kEndings.end(), ending) == kEndings.end() ? std::string() : std::string(name.substr(0, kDigits));
}

/// The process that wrote a file aside as programs did before they used folders for that: ".KEY.ending.PID-NUMBER.part".
std::optional<pid_t> writerOf(std::string_view name) {
  constexpr std::string_view kPart = ".part";
  if (!name.starts_with('.') || !name.ends_with(kPart)) return std::nullopt;
  name.remove_prefix(1);
  name.remove_suffix(kPart.size());
  const auto dot = name.rfind('.');
  if (dot == std::string_view::npos || keyOf(name.substr(0, dot)).empty()) return std::nullopt;
  const std::string_view numbers = name.substr(dot + 1);
  pid_t pid = 0;
  const auto [end, error] = std::from_chars(numbers.data(), numbers.data() + numbers.size(), pid);
  const auto rest = numbers.substr(static_cast<std::size_t>(end - numbers.data()));
  const bool counted = rest.size() > 1 && rest.front() == '-' && rest.find_first_not_of("0123456789", 1) == std::string_view::npos;
  return error == std::errc() && pid > 0 && counted ? std::optional(pid) : std::nullopt;
}

bool hasEnded(pid_t pid) { return ::kill(pid, 0) != 0 && errno == ESRCH; }

}  // namespace

void removeOldResults(const fs::path& folder, std::chrono::seconds oldAfter) {
  removeLeftovers(folder);
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error))
    if (fs::is_regular_file(entry->symlink_status(error))) files.push_back(entry->path());
  const auto now = fs::file_time_type::clock::now();
  const auto older = [&](const fs::path& file, auto than) {
    std::error_code problem;
    const auto written = fs::last_write_time(file, problem);
    return !problem && now - written > than;
  };
  std::error_code ignored;
  std::vector<std::string> old;
  for (const fs::path& file : files) {
    const std::string name = file.filename().string();
    if (const auto writer = writerOf(name); writer && hasEnded(*writer) && older(file, kSettled)) fs::remove(file, ignored);
    const std::string key = keyOf(name);
    if (!key.empty() && name == key + ".json" && older(file, oldAfter)) old.push_back(key);
  }
  for (const std::string& key : old) fs::remove(folder / (key + ".json"), ignored);  // first: without it there is no result
  for (const fs::path& file : files) {
    const std::string key = keyOf(file.filename().string());
    if (std::find(old.begin(), old.end(), key) != old.end() && file.extension() != ".lock") fs::remove(file, ignored);
  }
}

}  // namespace ew
