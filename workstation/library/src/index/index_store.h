#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "files/sqlite.h"
#include "index/index_entry.h"

namespace ew {

inline constexpr int kIndexVersion = 1;

/// The tables of the index in one data base. Functions throw sqlite::Failed.
class IndexStore {
 public:
  /// Makes the tables where there are none and brings older ones up to date, in one transaction.
  /// @param file empty: in memory
  /// A file of a newer program, or one that is no index, counts as damaged.
  explicit IndexStore(const std::filesystem::path& file);

  struct Known {
    std::string stamp;
    LibraryKind kind = LibraryKind::own;
    int revision = 0;
  };
  [[nodiscard]] std::map<std::string, Known> known();
  struct Stamped {
    IndexEntry entry;
    std::string stamp;
  };
  void store(const std::vector<Stamped>& entries);
  void remove(const std::vector<std::string>& folders);

  [[nodiscard]] std::vector<CaseFound> find(const CaseQuery& query);
  [[nodiscard]] std::vector<CaseRow> rows(std::span<const std::int64_t> numbers, bool forTrainees);
  [[nodiscard]] CaseChoices choices();
  [[nodiscard]] std::vector<CaseProblem> problems();
  [[nodiscard]] std::vector<std::filesystem::path> foldersOf(const std::string& caseId);

 private:
  void makeTables();
  class Writer;
  /// By number, which cases have all the words; nothing when there are no words.
  [[nodiscard]] std::optional<std::vector<bool>> withWords(std::string_view typed, bool forTrainees);
  sqlite::Database database_;
};

/// The words of a query as FTS5 takes them, each the beginning of a word; empty when nothing can be searched.
/// @param plain whether all that is not ASCII separates words
[[nodiscard]] std::string matchOf(std::string_view typed, bool plain);

}  // namespace ew
