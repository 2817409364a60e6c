#include "attempts/series_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <system_error>

#include "ew/io/safe_file.h"

namespace ew::assessment {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".json";

int numberOfFile(const fs::path& file) {
  const std::string stem = file.stem().string();
  int number = 0;
  const auto [end, error] = std::from_chars(stem.data(), stem.data() + stem.size(), number);
  return file.extension() == kEnding && error == std::errc() && end == stem.data() + stem.size() ? number : 0;
}

std::string nameOfNumber(int number) {
  std::array<char, 24> text{};
  std::snprintf(text.data(), text.size(), "%04d%s", number, kEnding);
  return text.data();
}

tl::unexpected<Error> notAdded(const fs::path& folder, const std::string& why) {
  return failure(ErrorCode::notWritable,
                 say<"Nothing can be written to the folder '%1' (%2); check that you may write there.">(folder, verbatim(why)),
                 {{"file", folder.string()}});
}

}  // namespace

std::vector<SeriesFile> numberedFiles(const fs::path& folder) {
  std::vector<SeriesFile> found;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const int number = numberOfFile(entry->path());
    std::error_code ignored;
    if (number > 0 && fs::file_size(entry->path(), ignored) > 0 && !ignored) found.push_back({number, entry->path()});
  }
  std::sort(found.begin(), found.end(), [](const SeriesFile& a, const SeriesFile& b) { return a.number < b.number; });
  return found;
}

Result<SeriesFile> addNumbered(const fs::path& folder, std::string_view text) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return notAdded(folder, error.message());
  int highest = 0;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error))
    highest = std::max(highest, numberOfFile(entry->path()));
  constexpr int kTries = 1000;
  for (int tries = 0; tries < kTries; ++tries) {
    const SeriesFile next{highest + 1 + tries, folder / nameOfNumber(highest + 1 + tries)};
    const int claimed = ::open(next.file.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0600);
    if (claimed < 0 && errno == EEXIST) continue;
    if (claimed < 0) return notAdded(folder, std::generic_category().message(errno));
    ::close(claimed);
    if (auto written = writeFileSafely(next.file, text); !written) {
      fs::remove(next.file, error);
      return passOn(written.error());
    }
    return next;
  }
  return notAdded(folder, "too many at once");
}

}  // namespace ew::assessment
