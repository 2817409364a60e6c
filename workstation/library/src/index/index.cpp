#include "ew/library/index.h"

#include <algorithm>
#include <cstdio>
#include <mutex>

#include "ew/core/fingerprint.h"
#include "ew/library/case.h"
#include "index/index_folders.h"
#include "index/index_store.h"
#include "making/old_results.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kStoredAtOnce = 64;  // a search between two of these waits for some milliseconds

void removeIndexFiles(const fs::path& file) {
  std::error_code ignored;
  for (const char* ending : {"", "-wal", "-shm", "-journal"}) fs::remove(file.string() + ending, ignored);
}

/// Indexes of roots that nobody has opened for long.
void removeOldIndexes(const fs::path& folder) {
  std::error_code failed;
  const auto now = fs::file_time_type::clock::now();
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
    if (entry->path().extension() != ".index") continue;
    const auto used = entry->last_write_time(failed);
    if (!failed && now - used > kOldResult) removeIndexFiles(entry->path());
  }
}

class SqliteIndex final : public LibraryIndex {
 public:
  SqliteIndex(fs::path file, std::string language) : file_(std::move(file)), language_(std::move(language)) {}

  /// Throws when there is not even memory.
  void open() {
    if (file_.empty()) return openInMemory();
    std::error_code ignored;
    fs::create_directories(file_.parent_path(), ignored);
    removeOldIndexes(file_.parent_path());
    try {
      openFile();
    } catch (const sqlite::Failed& failed) {
      keepInMemory(failed);
    }
  }

  Result<RefreshReport> refresh(const std::vector<LibraryRoot>& roots, Progress& progress) override {
    const std::lock_guard oneAtATime(refreshing_);
    // A file that turns out to be damaged, and then a disk that turns out to be full.
    for (int attempt = 0;; ++attempt) {
      try {
        return refreshOnce(roots, progress);
      } catch (const sqlite::Failed& failed) {
        if (attempt == 2 || !recover(failed))
          return failure(ErrorCode::notWritable, say<"The index of the library cannot be written (%1); close other programs that use it.">(
                                                     std::string(failed.what())));
      }
    }
  }

  Result<std::vector<CaseFound>> find(const CaseQuery& query) override {
    return guarded([&] { return store_->find(query); });
  }
  Result<std::vector<CaseRow>> rows(std::span<const std::int64_t> numbers, bool forTrainees) override {
    return guarded([&] { return store_->rows(numbers, forTrainees); });
  }
  Result<CaseChoices> choices() override {
    return guarded([&] { return store_->choices(); });
  }
  Result<std::vector<CaseProblem>> problems() override {
    return guarded([&] { return store_->problems(); });
  }
  Result<std::vector<fs::path>> foldersOf(const std::string& caseId) override {
    return guarded([&] { return store_->foldersOf(caseId); });
  }
  std::vector<Message> takeNotes() override {
    const std::lock_guard lock(mutex_);
    return std::exchange(notes_, {});
  }

 private:
  template <class Read>
  auto guarded(Read read) -> Result<decltype(read())> {
    const std::lock_guard lock(mutex_);
    try {
      return read();
    } catch (const sqlite::Failed& failed) {
      return failure(ErrorCode::notReadable,
                     say<"The index of the library cannot be read (%1); it is made anew when the start page is opened again.">(
                         std::string(failed.what())),
                     {{"file", file_.string()}});
    }
  }

  template <class Use>
  auto locked(Use use) {
    const std::lock_guard lock(mutex_);
    return use();
  }

  void openInMemory() { store_ = std::make_unique<IndexStore>(fs::path()); }

  void openFile() {
    try {
      store_ = std::make_unique<IndexStore>(file_);
    } catch (const sqlite::Failed& failed) {
      if (failed.trouble != sqlite::Trouble::damaged) throw;
      makeAnew();
    }
  }

  void makeAnew() {
    store_.reset();
    removeIndexFiles(file_);
    store_ = std::make_unique<IndexStore>(file_);
    notes_.push_back(say<"The index of the library was damaged or made by another version, and was made anew from the folders.">());
  }

  void keepInMemory(const sqlite::Failed& why) {
    openInMemory();
    notes_.push_back(
        say<"The index of the library cannot be kept in '%1' (%2), so the library is read anew at every start; make room there "
            "or choose another folder with ECHOWEAVE_CACHE.">(file_, std::string(why.what())));
    file_.clear();
  }

  /// @return whether it is worth another attempt
  bool recover(const sqlite::Failed& failed) {
    const std::lock_guard lock(mutex_);
    if (file_.empty() || failed.trouble == sqlite::Trouble::other) return false;
    try {
      if (failed.trouble == sqlite::Trouble::damaged)
        makeAnew();
      else
        keepInMemory(failed);
    } catch (const sqlite::Failed& again) {
      keepInMemory(again);
    }
    return true;
  }

  Result<RefreshReport> refreshOnce(const std::vector<LibraryRoot>& roots, Progress& progress) {
    progress.report(say<"Looking at the folders of the library">(), 0.0);
    const CaseFolders found = findCases(roots, language_);
    const auto known = locked([&] { return store_->known(); });
    RefreshReport report;
    report.seen = found.cases.size();
    if (auto stored = storeChanged(changedAmong(found.cases, known), progress); !stored)
      return passOn(stored.error());
    else
      report.read = *stored;
    report.removed = removeGone(found.cases, known);
    report.problems = found.problems;
    const auto broken = locked([&] { return store_->problems(); });
    report.problems.insert(report.problems.end(), broken.begin(), broken.end());
    progress.report(say<"Looking at the folders of the library">(), 1.0);
    return report;
  }

  [[nodiscard]] static std::vector<CaseFolder> changedAmong(const std::vector<CaseFolder>& found,
                                                            const std::map<std::string, IndexStore::Known>& known) {
    std::vector<CaseFolder> changed;
    for (const CaseFolder& each : found) {
      const auto before = known.find(each.folder.native());
      if (before == known.end() || before->second.stamp != each.stamp || before->second.kind != each.kind ||
          before->second.revision != each.revision)
        changed.push_back(each);
    }
    return changed;
  }

  Result<std::size_t> storeChanged(const std::vector<CaseFolder>& changed, Progress& progress) {
    std::vector<IndexStore::Stamped> waiting;
    for (std::size_t n = 0; n < changed.size(); ++n) {
      if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Reading the library was stopped.">());
      const CaseFolder& each = changed[n];
      waiting.push_back({readIndexEntry(each.folder, each.kind, each.revision, language_), each.stamp});
      if (!isSettled(each.folder, language_, std::chrono::system_clock::now())) waiting.back().stamp.clear();
      if (waiting.size() < kStoredAtOnce && n + 1 < changed.size()) continue;
      locked([&] { store_->store(waiting); });
      waiting.clear();
      progress.report(say<"Reading the cases of the library">(), static_cast<double>(n + 1) / static_cast<double>(changed.size()));
    }
    return changed.size();
  }

  std::size_t removeGone(const std::vector<CaseFolder>& found, const std::map<std::string, IndexStore::Known>& known) {
    std::vector<std::string> gone;
    auto there = found.begin();  // both are sorted by folder
    for (const auto& [folder, ignored] : known) {
      while (there != found.end() && there->folder.native() < folder) ++there;
      if (there == found.end() || there->folder.native() != folder) gone.push_back(folder);
    }
    for (std::size_t n = 0; n < gone.size(); n += kStoredAtOnce) {
      const auto end = gone.begin() + static_cast<std::ptrdiff_t>(std::min(gone.size(), n + kStoredAtOnce));
      locked([&] { store_->remove({gone.begin() + static_cast<std::ptrdiff_t>(n), end}); });
    }
    return gone.size();
  }

  fs::path file_;  ///< empty: in memory
  const std::string language_;
  std::mutex refreshing_;
  std::mutex mutex_;  ///< of what follows
  std::unique_ptr<IndexStore> store_;
  std::vector<Message> notes_;
};

}  // namespace

LibraryIndex::~LibraryIndex() = default;

Result<CasePage> search(LibraryIndex& index, const CaseQuery& query, std::size_t offset, std::size_t limit) {
  auto found = index.find(query);
  if (!found) return passOn(found.error());
  std::vector<std::int64_t> numbers;
  for (std::size_t n = offset; n < found->size() && n - offset < limit; ++n) numbers.push_back((*found)[n].number);
  auto rows = index.rows(numbers, query.forTrainees);
  if (!rows) return passOn(rows.error());
  return CasePage{std::move(*rows), found->size()};
}

fs::path indexFile(const std::vector<LibraryRoot>& roots, const std::string& language) {
  std::string all = language;
  for (const LibraryRoot& root : roots) {
    std::error_code failed;
    const fs::path place = fs::absolute(root.folder, failed).lexically_normal();
    all += '\n' + std::to_string(static_cast<int>(root.kind)) + ' ' + (failed ? root.folder : place).string();
  }
  char name[32];
  std::snprintf(name, sizeof name, "%016llx.index", static_cast<unsigned long long>(fingerprintOf(all).hash));
  return cacheFolder() / "index" / name;
}

Result<std::unique_ptr<LibraryIndex>> openIndex(const fs::path& file, const std::string& language) {
  auto index = std::make_unique<SqliteIndex>(file, language);
  try {
    index->open();
  } catch (const sqlite::Failed& failed) {
    return failure(ErrorCode::notWritable,
                   say<"No index of the library can be made (%1); close other programs to have more memory.">(std::string(failed.what())));
  }
  return std::unique_ptr<LibraryIndex>(std::move(index));
}

}  // namespace ew
