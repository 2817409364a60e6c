#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ew/core/message.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew {

// The index of a library: what is needed to list and search many cases without reading them. The folders are the truth and the index is a
// cache of them, which may be thrown away at any time (decision 0053).

/// Where a case comes from; also the order in which they are listed.
enum class LibraryKind { shipped, own, published };

/// A folder of cases. Of shipped and own ones every sub-folder with a case.json is a case; of published ones CASE/REVISION is, and of each
/// CASE only the highest revision that has a case.json counts. Links to folders are followed, hidden folders are not looked at.
struct LibraryRoot {
  std::filesystem::path folder;
  LibraryKind kind = LibraryKind::own;
  bool operator==(const LibraryRoot&) const = default;
};

struct LessonRow {
  std::string id;
  std::string title;
  std::string aim;
  int level = 1;  ///< 1 to 5
  int minutes = 0;
  int steps = 0;
  bool operator==(const LessonRow&) const = default;
};

/// What a list shows of a case, in the language of the index where the case has words in it.
struct CaseRow {
  std::int64_t number = 0;  ///< in this index; the same as long as the folder is in it
  std::string id;
  std::string title;  ///< for authors; of a row for trainees the title for trainees
  std::string titleForTrainees;
  std::string region;
  std::string indication;
  std::string pathology;  ///< diagnosis and findings; empty in a row for trainees
  std::filesystem::path folder;
  LibraryKind kind = LibraryKind::own;
  int revision = 0;                ///< of a published case
  std::optional<int> level;        ///< 1 to 5: the case's difficulty, else that of its easiest lesson
  std::vector<std::string> tags;   ///< sorted
  std::vector<LessonRow> lessons;  ///< as the author put them
  std::optional<double> progress;  ///< 0 to 1, of whoever learns; nothing here sets it
  bool operator==(const CaseRow&) const = default;
};

struct CaseQuery {
  std::string words = {};   ///< as they are typed: each has to be the beginning of a word of the case; capitals and accents do not matter
  std::string region = {};  ///< exactly; empty: any
  std::vector<std::string> tags = {};  ///< all of them
  std::optional<int> level = {};
  std::optional<LibraryKind> kind = {};
  bool lessonsOnly = false;
  /// A search must give no answer away: title for authors, id, diagnosis, findings and differential are neither searched nor returned (but
  /// for id and folder, which nobody reads and a program needs). The list is sorted by what trainees read.
  bool forTrainees = true;
  bool operator==(const CaseQuery&) const = default;
};

struct CaseFound {
  std::int64_t number = 0;
  LibraryKind kind = LibraryKind::own;
  bool operator==(const CaseFound&) const = default;
};

/// What can be chosen among, each sorted and only what at least one case has.
struct CaseChoices {
  std::vector<std::string> regions;
  std::vector<std::string> tags;
  std::vector<int> levels;
  std::vector<LibraryKind> kinds;
  bool operator==(const CaseChoices&) const = default;
};

/// A folder that should be a case and cannot be read; or a whole root.
struct CaseProblem {
  std::filesystem::path folder;
  Message message;
  bool operator==(const CaseProblem&) const = default;
};

struct RefreshReport {
  std::size_t seen = 0;               ///< cases in the folders, those with problems too
  std::size_t read = 0;               ///< manifests that were read, because they are new or have changed
  std::size_t removed = 0;            ///< cases that are gone
  std::vector<CaseProblem> problems;  ///< of the whole library
};

/// All functions may be called from any thread; find() and rows() wait for refresh() no longer than a few rows take to be stored.
class LibraryIndex {
 public:
  virtual ~LibraryIndex();

  /// Makes the index say what the folders say: looks at the stamps of all manifests (time, size, inode) and reads those that changed. What
  /// is done when it is cancelled stays. The index of several processes may be refreshed at once. A case of the index that lies in none of
  /// the roots is removed.
  /// @error cancelled, notWritable
  [[nodiscard]] virtual Result<RefreshReport> refresh(const std::vector<LibraryRoot>& roots, Progress& progress) = 0;

  /// All that match: shipped, own, published, each by title. Any bytes may be asked for; what is no letter or digit separates words.
  /// @error notReadable
  [[nodiscard]] virtual Result<std::vector<CaseFound>> find(const CaseQuery& query) = 0;
  /// In the order of the numbers; those that are no longer there are left out. @error notReadable
  [[nodiscard]] virtual Result<std::vector<CaseRow>> rows(std::span<const std::int64_t> numbers, bool forTrainees) = 0;
  /// @error notReadable
  [[nodiscard]] virtual Result<CaseChoices> choices() = 0;
  /// Sorted by folder. @error notReadable
  [[nodiscard]] virtual Result<std::vector<CaseProblem>> problems() = 0;
  /// Folders of the cases with that id: own first, then published, then shipped. @error notReadable
  [[nodiscard]] virtual Result<std::vector<std::filesystem::path>> foldersOf(const std::string& caseId) = 0;
  /// What a person may want to know of the index itself since the last call: that it was rebuilt, or is kept in memory alone.
  [[nodiscard]] virtual std::vector<Message> takeNotes() = 0;
};

struct CasePage {
  std::vector<CaseRow> rows;
  std::size_t total = 0;  ///< that match
};
/// The matches from `offset` on, at most `limit` of them. @error notReadable
[[nodiscard]] Result<CasePage> search(LibraryIndex& index, const CaseQuery& query, std::size_t offset = 0, std::size_t limit = 50);

/// Below cacheFolder()/index, by a hash of the roots and the language.
[[nodiscard]] std::filesystem::path indexFile(const std::vector<LibraryRoot>& roots, const std::string& language);

/// Opens the index in `file` or makes it. A file that is damaged, of a newer program or no index at all is thrown away (noted); when the
/// file cannot be written, the index is kept in memory (noted). Until it is refreshed it says what it said last.
/// @param file     on a local disk; empty: in memory
/// @param language of the texts, as in a locale ("de_DE"): words/LANGUAGE.json of a case; both languages are searched
/// @error notWritable when there is no memory either
[[nodiscard]] Result<std::unique_ptr<LibraryIndex>> openIndex(const std::filesystem::path& file, const std::string& language = "en");

}  // namespace ew
