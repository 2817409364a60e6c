#include "index/index_store.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "ew/core/foreign_json.h"
#include "ew/core/message_json.h"

namespace ew {
namespace {

constexpr std::size_t kMostTypedWords = 32;
constexpr std::size_t kLongestTypedWord_bytes = 64;

/// What turns an index of version n into one of version n + 1, for n = 0, 1, ...
constexpr const char* kIndexMigrations[] = {
    // The texts have a row for each case, with the case's number, and hold each word once. Without positions (detail) a search of a letter
    // that is everywhere takes a quarter; the prefixes are those that are typed first and match most.
    R"sql(
CREATE TABLE case_entry(
  number INTEGER PRIMARY KEY, folder TEXT NOT NULL UNIQUE, stamp TEXT NOT NULL, kind INTEGER NOT NULL, revision INTEGER NOT NULL,
  problem TEXT, id TEXT NOT NULL, title TEXT NOT NULL, title_for_trainees TEXT NOT NULL, region TEXT NOT NULL, indication TEXT NOT NULL,
  pathology TEXT NOT NULL, level INTEGER, lesson_count INTEGER NOT NULL, author_key TEXT NOT NULL, trainee_key TEXT NOT NULL);
CREATE INDEX case_by_title ON case_entry(kind, author_key, number) WHERE problem IS NULL;
CREATE INDEX case_by_title_for_trainees ON case_entry(kind, trainee_key, number) WHERE problem IS NULL;
CREATE INDEX case_by_region ON case_entry(region) WHERE problem IS NULL;
CREATE INDEX case_by_level ON case_entry(level) WHERE problem IS NULL;
CREATE INDEX case_by_id ON case_entry(id);
CREATE INDEX case_by_problem ON case_entry(folder) WHERE problem IS NOT NULL;
CREATE TABLE lesson(
  case_number INTEGER NOT NULL REFERENCES case_entry(number) ON DELETE CASCADE, place INTEGER NOT NULL, id TEXT NOT NULL,
  title TEXT NOT NULL, aim TEXT NOT NULL, level INTEGER NOT NULL, minutes INTEGER NOT NULL, steps INTEGER NOT NULL,
  PRIMARY KEY(case_number, place)) WITHOUT ROWID;
CREATE TABLE case_tag(
  case_number INTEGER NOT NULL REFERENCES case_entry(number) ON DELETE CASCADE, tag TEXT NOT NULL,
  PRIMARY KEY(case_number, tag)) WITHOUT ROWID;
CREATE INDEX case_by_tag ON case_tag(tag, case_number);
CREATE VIRTUAL TABLE trainee_text USING fts5(words, tokenize = "unicode61 remove_diacritics 2", prefix = '1 2 3', detail = none);
CREATE VIRTUAL TABLE author_text USING fts5(words, tokenize = "unicode61 remove_diacritics 2", prefix = '1 2 3', detail = none);
)sql",
};
static_assert(std::size(kIndexMigrations) == kIndexVersion);

bool separatesWords(unsigned char byte) {
  const int small = byte | 0x20;
  return byte < 0x80 && !(byte >= '0' && byte <= '9') && !(small >= 'a' && small <= 'z');
}

/// Length of the UTF-8 sequence at `at`; 0 when there is none.
std::size_t utf8SequenceAt(std::string_view text, std::size_t at) {
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t length = first >= 0xC2 && first <= 0xDF   ? 2
                             : first >= 0xE0 && first <= 0xEF ? 3
                             : first >= 0xF0 && first <= 0xF4 ? 4
                                                              : 0;
  if (length == 0 || at + length > text.size()) return 0;
  for (std::size_t n = 1; n < length; ++n)
    if ((static_cast<unsigned char>(text[at + n]) & 0xC0) != 0x80) return 0;
  return length;
}

std::vector<std::string> typedWords(std::string_view typed) {
  std::vector<std::string> words(1);
  for (std::size_t at = 0; at < typed.size() && words.size() <= kMostTypedWords;) {
    const auto byte = static_cast<unsigned char>(typed[at]);
    const std::size_t length = byte < 0x80 ? 1 : utf8SequenceAt(typed, at);
    if (length == 0 || separatesWords(byte)) {
      if (!words.back().empty()) words.emplace_back();
      at += std::max<std::size_t>(length, 1);
      continue;
    }
    if (words.back().size() + length <= kLongestTypedWord_bytes) words.back() += typed.substr(at, length);
    at += length;
  }
  words.resize(words.back().empty() ? words.size() - 1 : std::min(words.size(), kMostTypedWords));
  return words;
}

/// Each word of a text once, parted at blanks.
std::string wordsOnce(const std::string& text) {
  std::set<std::string_view> words;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n", at);
    if (begin == std::string::npos) break;
    at = std::min(text.find_first_of(" \t\r\n", begin), text.size());
    words.insert(std::string_view(text).substr(begin, at - begin));
  }
  std::string all;
  for (const std::string_view word : words) all.append(word).push_back(' ');
  return all;
}

}  // namespace

std::string matchOf(std::string_view typed, bool plain) {
  std::string letters = searchable(std::string(typed));
  if (plain)
    std::replace_if(
        letters.begin(), letters.end(), [](char byte) { return static_cast<unsigned char>(byte) >= 0x80; }, ' ');
  std::string match;
  for (const std::string& word : typedWords(letters)) match += '"' + word + "\"* ";
  return match;
}

IndexStore::IndexStore(const std::filesystem::path& file) : database_(file) {
  database_.run("PRAGMA foreign_keys = ON; PRAGMA synchronous = NORMAL; PRAGMA temp_store = MEMORY; PRAGMA cache_size = -16000;");
  try {
    // Several processes at once read while one writes. Where memory cannot be shared this may succeed and the first write fails.
    database_.run("PRAGMA journal_mode = WAL;");
    makeTables();
  } catch (const sqlite::Failed& failed) {
    if (failed.trouble == sqlite::Trouble::damaged) throw;
    database_.run("PRAGMA journal_mode = DELETE;");
    makeTables();
  }
}

void IndexStore::makeTables() {
  sqlite::Transaction all(database_);
  int version = 0;
  const bool isNew = !sqlite::Statement(database_, "SELECT 1 FROM sqlite_master LIMIT 1").step();
  if (!isNew) {
    if (!sqlite::Statement(database_, "SELECT 1 FROM sqlite_master WHERE name = 'schema_info'").step())
      throw sqlite::Failed(sqlite::Trouble::damaged, "no index");
    sqlite::Statement read(database_, "SELECT version FROM schema_info");
    if (!read.step()) throw sqlite::Failed(sqlite::Trouble::damaged, "no version");
    version = static_cast<int>(read.number(0));
    if (version < 1 || version > kIndexVersion) throw sqlite::Failed(sqlite::Trouble::damaged, "another version");
  } else {
    database_.run("CREATE TABLE schema_info(version INTEGER NOT NULL); INSERT INTO schema_info VALUES(0);");
  }
  for (int next = version; next < kIndexVersion; ++next) database_.run(kIndexMigrations[next]);
  // Written at every start: the probe whether this file can be written at all.
  sqlite::Statement(database_, "UPDATE schema_info SET version = ?").bind(kIndexVersion).run();
  all.commit();
}

std::map<std::string, IndexStore::Known> IndexStore::known() {
  std::map<std::string, Known> all;
  sqlite::Statement read(database_, "SELECT folder, stamp, kind, revision FROM case_entry ORDER BY folder");
  while (read.step())
    all.emplace_hint(all.end(), read.text(0),
                     Known{read.text(1), static_cast<LibraryKind>(read.number(2)), static_cast<int>(read.number(3))});
  return all;
}

/// The statements of one transaction, prepared once.
class IndexStore::Writer {
 public:
  explicit Writer(sqlite::Database& database)
      : entry_(database, R"sql(
INSERT INTO case_entry(folder, stamp, kind, revision, problem, id, title, title_for_trainees, region, indication, pathology, level,
                       lesson_count, author_key, trainee_key)
VALUES(?, ?, ?, ?, nullif(?, ''), ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)
ON CONFLICT(folder) DO UPDATE SET stamp = excluded.stamp, kind = excluded.kind, revision = excluded.revision, problem = excluded.problem,
  id = excluded.id, title = excluded.title, title_for_trainees = excluded.title_for_trainees, region = excluded.region,
  indication = excluded.indication, pathology = excluded.pathology, level = excluded.level, lesson_count = excluded.lesson_count,
  author_key = excluded.author_key, trainee_key = excluded.trainee_key
RETURNING number)sql"),
        oldParts_{{database, "DELETE FROM lesson WHERE case_number = ?"},
                  {database, "DELETE FROM case_tag WHERE case_number = ?"},
                  {database, "DELETE FROM trainee_text WHERE rowid = ?"},
                  {database, "DELETE FROM author_text WHERE rowid = ?"}},
        lesson_(database, "INSERT INTO lesson VALUES(?, ?, ?, ?, ?, ?, ?, ?)"),
        tag_(database, "INSERT OR IGNORE INTO case_tag VALUES(?, ?)"),
        traineeText_(database, "INSERT INTO trainee_text(rowid, words) VALUES(?, ?)"),
        authorText_(database, "INSERT INTO author_text(rowid, words) VALUES(?, ?)") {}

  void write(const Stamped& each) {
    const CaseRow& row = each.entry.row;
    const std::int64_t number = writeEntry(each);
    for (sqlite::Statement& old : oldParts_) old.again().bind(number).run();
    for (std::size_t n = 0; n < row.lessons.size(); ++n) {
      const LessonRow& of = row.lessons[n];
      lesson_.again().bind(number).bind(static_cast<int>(n)).bind(of.id).bind(of.title).bind(of.aim).bind(of.level).bind(of.minutes);
      lesson_.bind(of.steps).run();
    }
    for (const std::string& of : row.tags) tag_.again().bind(number).bind(of).run();
    if (each.entry.problem) return;
    traineeText_.again().bind(number).bind(wordsOnce(each.entry.openText)).run();
    authorText_.again().bind(number).bind(wordsOnce(each.entry.openText + '\n' + each.entry.closedText)).run();
  }

 private:
  std::int64_t writeEntry(const Stamped& each) {
    const CaseRow& row = each.entry.row;
    const std::string folder = row.folder.string();
    const std::string problem = each.entry.problem ? nlohmann::json(*each.entry.problem).dump() : std::string();
    entry_.again().bind(folder).bind(each.stamp).bind(static_cast<int>(row.kind)).bind(row.revision).bind(problem);
    entry_.bind(row.id).bind(row.title).bind(row.titleForTrainees).bind(row.region).bind(row.indication).bind(row.pathology);
    entry_.bind(row.level).bind(static_cast<int>(row.lessons.size())).bind(sortKey(row.title)).bind(sortKey(row.titleForTrainees));
    entry_.step();
    const std::int64_t number = entry_.number(0);
    entry_.run();
    return number;
  }

  sqlite::Statement entry_;
  sqlite::Statement oldParts_[4];
  sqlite::Statement lesson_, tag_, traineeText_, authorText_;
};

void IndexStore::store(const std::vector<Stamped>& entries) {
  sqlite::Transaction all(database_);
  Writer writer(database_);
  for (const Stamped& each : entries) writer.write(each);
  all.commit();
}

void IndexStore::remove(const std::vector<std::string>& folders) {
  sqlite::Transaction all(database_);
  sqlite::Statement trainees(database_, "DELETE FROM trainee_text WHERE rowid = (SELECT number FROM case_entry WHERE folder = ?)");
  sqlite::Statement authors(database_, "DELETE FROM author_text WHERE rowid = (SELECT number FROM case_entry WHERE folder = ?)");
  sqlite::Statement entry(database_, "DELETE FROM case_entry WHERE folder = ?");
  for (const std::string& folder : folders)
    for (sqlite::Statement* each : {&trainees, &authors, &entry}) each->again().bind(folder).run();
  all.commit();
}

std::optional<std::vector<bool>> IndexStore::withWords(std::string_view typed, bool forTrainees) {
  const char* sql =
      forTrainees ? "SELECT rowid FROM trainee_text WHERE trainee_text MATCH ?" : "SELECT rowid FROM author_text WHERE author_text MATCH ?";
  for (const bool plain : {false, true}) {
    const std::string match = matchOf(typed, plain);
    if (match.empty()) break;
    try {
      std::vector<bool> numbers;
      sqlite::Statement read(database_, sql);
      read.bind(match);
      while (read.step()) {
        const auto number = static_cast<std::size_t>(read.number(0));
        if (number >= numbers.size()) numbers.resize(std::max(number + 1, 2 * numbers.size()));
        numbers[number] = true;
      }
      return numbers;
    } catch (const sqlite::Failed& failed) {
      // A sign that is no letter within a word makes a phrase of it, which needs positions.
      if (plain || failed.trouble != sqlite::Trouble::other) throw;
    }
  }
  return {};
}

std::vector<CaseFound> IndexStore::find(const CaseQuery& query) {
  const auto withAllWords = withWords(query.words, query.forTrainees);
  std::string sql = "SELECT number, kind FROM case_entry WHERE problem IS NULL";
  if (!query.region.empty()) sql += " AND region = ?";
  if (query.level) sql += " AND level = ?";
  if (query.kind) sql += " AND kind = ?";
  if (query.lessonsOnly) sql += " AND lesson_count > 0";
  for (std::size_t n = 0; n < query.tags.size(); ++n) sql += " AND number IN (SELECT case_number FROM case_tag WHERE tag = ?)";
  sql += query.forTrainees ? " ORDER BY kind, trainee_key, number" : " ORDER BY kind, author_key, number";
  sqlite::Statement read(database_, sql);
  if (!query.region.empty()) read.bind(query.region);
  if (query.level) read.bind(*query.level);
  if (query.kind) read.bind(static_cast<int>(*query.kind));
  for (const std::string& tag : query.tags) read.bind(tag);
  std::vector<CaseFound> found;
  while (read.step()) {
    const auto number = static_cast<std::size_t>(read.number(0));
    if (!withAllWords || (number < withAllWords->size() && (*withAllWords)[number]))
      found.push_back({read.number(0), static_cast<LibraryKind>(read.number(1))});
  }
  return found;
}

std::vector<CaseRow> IndexStore::rows(std::span<const std::int64_t> numbers, bool forTrainees) {
  sqlite::Statement read(database_,
                         "SELECT id, title, title_for_trainees, region, indication, pathology, folder, kind, revision, level "
                         "FROM case_entry WHERE number = ? AND problem IS NULL");
  sqlite::Statement tag(database_, "SELECT tag FROM case_tag WHERE case_number = ? ORDER BY tag");
  sqlite::Statement lesson(database_, "SELECT id, title, aim, level, minutes, steps FROM lesson WHERE case_number = ? ORDER BY place");
  std::vector<CaseRow> rows;
  for (const std::int64_t number : numbers) {
    if (!read.again().bind(number).step()) continue;
    CaseRow row;
    row.number = number;
    row.id = read.text(0);
    row.titleForTrainees = read.text(2);
    row.title = forTrainees ? row.titleForTrainees : read.text(1);
    row.region = read.text(3);
    row.indication = read.text(4);
    if (!forTrainees) row.pathology = read.text(5);
    row.folder = read.text(6);
    row.kind = static_cast<LibraryKind>(read.number(7));
    row.revision = static_cast<int>(read.number(8));
    if (!read.isNull(9)) row.level = static_cast<int>(read.number(9));
    read.again();
    tag.again().bind(number);
    while (tag.step()) row.tags.push_back(tag.text(0));
    lesson.again().bind(number);
    while (lesson.step())
      row.lessons.push_back({lesson.text(0), lesson.text(1), lesson.text(2), static_cast<int>(lesson.number(3)),
                             static_cast<int>(lesson.number(4)), static_cast<int>(lesson.number(5))});
    rows.push_back(std::move(row));
  }
  return rows;
}

CaseChoices IndexStore::choices() {
  CaseChoices made;
  sqlite::Statement region(database_, "SELECT DISTINCT region FROM case_entry WHERE problem IS NULL AND region <> '' ORDER BY region");
  while (region.step()) made.regions.push_back(region.text(0));
  sqlite::Statement tag(database_, "SELECT DISTINCT tag FROM case_tag ORDER BY tag");
  while (tag.step()) made.tags.push_back(tag.text(0));
  sqlite::Statement level(database_, "SELECT DISTINCT level FROM case_entry WHERE problem IS NULL AND level IS NOT NULL ORDER BY level");
  while (level.step()) made.levels.push_back(static_cast<int>(level.number(0)));
  sqlite::Statement kind(database_, "SELECT DISTINCT kind FROM case_entry WHERE problem IS NULL ORDER BY kind");
  while (kind.step()) made.kinds.push_back(static_cast<LibraryKind>(kind.number(0)));
  return made;
}

std::vector<CaseProblem> IndexStore::problems() {
  std::vector<CaseProblem> all;
  sqlite::Statement read(database_, "SELECT folder, problem FROM case_entry WHERE problem IS NOT NULL ORDER BY folder");
  while (read.step()) {
    all.push_back({read.text(0), jsonOrNull(read.text(1)).get<Message>()});
  }
  return all;
}

std::vector<std::filesystem::path> IndexStore::foldersOf(const std::string& caseId) {
  sqlite::Statement read(database_,
                         "SELECT folder FROM case_entry WHERE id = ? AND problem IS NULL ORDER BY kind = 1 DESC, kind DESC, folder");
  read.bind(caseId);
  std::vector<std::filesystem::path> folders;
  while (read.step()) folders.emplace_back(read.text(0));
  return folders;
}

}  // namespace ew
