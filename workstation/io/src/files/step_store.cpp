#include "ew/io/step_store.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>
#include <tuple>

#include "ew/core/foreign_json.h"
#include "ew/core/output_set.h"
#include "ew/core/version.h"
#include "ew/io/content_key.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

tl::unexpected<Error> storeNotWritable(const fs::path& folder, const Message& reason) {
  return failure(ErrorCode::notWritable,
                 say<"The folder '%1' cannot be written (%2); choose one you may write to.">(folder.string(), reason),
                 {{"file", folder.string()}});
}

constexpr std::size_t kKeyLength = 32;

/// What stands behind the key in the name of a file; empty when there is none.
std::string_view behindKey(std::string_view name) {
  return name.size() > kKeyLength && isContentKey(name.substr(0, kKeyLength)) ? name.substr(kKeyLength) : std::string_view();
}

/// The key of a finished result by the name of its file; empty: it is something else.
std::string keyOfEntry(const std::string& name) { return behindKey(name) == ".json" ? name.substr(0, kKeyLength) : std::string(); }

/// The key of the result that a file belongs to; empty: to none.
std::string keyOfBeside(const std::string& name) { return behindKey(name).starts_with('-') ? name.substr(0, kKeyLength) : std::string(); }

/// The regular files of a folder by their names.
std::vector<std::string> namesIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (auto at = fs::directory_iterator(folder, ignored); at != fs::directory_iterator(); at.increment(ignored))
    if (at->symlink_status(ignored).type() == fs::file_type::regular) names.push_back(at->path().filename().string());
  return names;
}

/// The name of everything an entry says but this name itself.
std::string contentOfEntry(json entry) {
  entry.erase("content");
  return ContentKey().add(entry.dump(-1, ' ', false, json::error_handler_t::replace)).text();
}

}  // namespace

bool isMarkedAsOwn(std::string_view text) { return text.substr(0, 64).find(kOwner) != std::string_view::npos; }

Result<void> StepStore::takeFolder(FileLock::Kind kind) {
  std::error_code error;
  fs::create_directories(folder_ / "steps", error);
  if (error) return storeNotWritable(folder_, verbatim(error.message()));
  auto taken = FileLock::tryTake(folder_ / "steps" / ".lock", kind);
  if (!taken) return passOn(taken.error());
  if (!*taken)
    return failure(ErrorCode::notWritable,
                   say<"Another run is at work in '%1'; wait until it has ended, or choose another folder.">(folder_.string()),
                   {{"file", folder_.string()}});
  lock_ = std::move(**taken);
  isShared_ = kind == FileLock::Kind::shared;
  return {};
}

Result<StepStore> StepStore::open(const fs::path& folder, const std::vector<std::string>& steps) {
  StepStore store(folder, steps);
  if (auto taken = store.takeFolder(FileLock::Kind::alone); !taken) return passOn(taken.error());
  store.clearLeftovers();
  return store;
}

Result<StepStore> StepStore::share(const fs::path& folder, const std::vector<std::string>& steps) {
  StepStore store(folder, steps);
  if (auto taken = store.takeFolder(FileLock::Kind::shared); !taken) return passOn(taken.error());
  return store;
}

StepStore StepStore::peek(const fs::path& folder, const std::vector<std::string>& steps) { return {folder, steps}; }

fs::path StepStore::lockOf(const std::string& step, const std::string& key) const { return folder_ / "steps" / step / (key + ".lock"); }

Result<FileLock> StepStore::lock(const std::string& step, const std::string& key, const Message& waiting, Progress& progress) const {
  if (auto room = prepare(step); !room) return passOn(room.error());
  return FileLock::take(lockOf(step, key), waiting, progress);
}

void StepStore::removeUnused(std::chrono::seconds unusedFor) const {
  std::error_code error;
  const auto now = fs::file_time_type::clock::now();
  for (const auto& step : steps_) {
    const fs::path home = folder_ / "steps" / step;
    removeLeftovers(home);
    std::set<std::string> old;
    for (const auto& name : namesIn(home)) {
      const std::string beside = keyOfBeside(name), key = beside.empty() ? keyOfEntry(name) : beside;
      if (key.empty()) continue;
      const fs::path entry = home / (key + ".json");
      if (!fs::exists(entry, error) || now - fs::last_write_time(entry, error) > unusedFor) old.insert(key);
    }
    for (const std::string& key : old) {
      const auto lock = FileLock::tryTake(lockOf(step, key));
      if (!lock || !*lock) continue;
      const fs::path entry = home / (key + ".json");  // it may have been made meanwhile
      if (fs::exists(entry, error) && now - fs::last_write_time(entry, error) <= unusedFor) continue;
      remove(step, key);
    }
  }
}

void StepStore::clearLeftovers() const {
  std::error_code ignored;
  const fs::path steps = folder_ / "steps";
  removeLeftovers(steps);
  for (const auto& step : steps_) {
    removeLeftovers(steps / step);
    for (const auto& name : namesIn(steps / step)) {
      // A finished file whose .json never came is made again, so it only takes room.
      const std::string key = keyOfBeside(name);
      if (!key.empty() && !fs::exists(steps / step / (key + ".json"), ignored)) fs::remove(steps / step / name, ignored);
    }
  }
}

fs::path StepStore::fileOf(const std::string& step, const std::string& key, const std::string& name) const {
  return folder_ / "steps" / step / (key + "-" + name);
}

std::optional<json> StepStore::entryOf(const std::string& step, const std::string& key) const {
  const fs::path entry = folder_ / "steps" / step / (key + ".json");
  std::error_code ignored;
  if (!fs::is_regular_file(entry, ignored)) return std::nullopt;
  const auto text = readTextFile(entry);
  if (!text) return std::nullopt;
  json read = jsonOrNull(*text);
  if (!read.is_object() || memberOf(read, "key") != key || memberOf(read, "content") != contentOfEntry(read)) return std::nullopt;
  return read;
}

bool StepStore::claims(const std::string& step, const std::string& key) const {
  std::error_code ignored;
  return fs::is_regular_file(folder_ / "steps" / step / (key + ".json"), ignored);
}

std::optional<json> StepStore::find(const std::string& step, const std::string& key) const {
  auto entry = entryOf(step, key);
  if (!entry) return std::nullopt;
  std::error_code ignored;
  try {
    for (const auto& file : entry->at("files")) {
      const fs::path path = fileOf(step, key, file.at("name").get<std::string>());
      const auto size = fs::file_size(path, ignored);
      if (ignored || size != file.at("bytes").get<std::uintmax_t>()) return std::nullopt;
      promise(path, file.at("content").get<std::string>());
    }
    json data = std::move(entry->at("data"));
    use(step, key);
    if (isShared_) fs::last_write_time(folder_ / "steps" / step / (key + ".json"), fs::file_time_type::clock::now(), ignored);
    return data;
  } catch (const json::exception&) {
    return std::nullopt;  // damaged: made again
  }
}

std::vector<json> StepStore::all(const std::string& step) const {
  std::vector<json> found;
  for (const auto& key : keysOf(step))
    if (auto entry = entryOf(step, key); entry && entry->contains("data")) found.push_back(std::move(entry->at("data")));
  return found;
}

std::optional<std::uintmax_t> StepStore::bytesOf(const std::string& step, const std::string& key, const std::string& name) const {
  std::error_code error;
  const auto size = fs::file_size(fileOf(step, key, name), error);
  if (error) return std::nullopt;
  return size;
}

void StepStore::promise(const fs::path& file, const std::string& content) const {
  const std::lock_guard lock(known_->guard);
  Content& known = known_->contents[file.string()];
  if (known.key != content) known = {content, false};
}

std::string StepStore::promised(const fs::path& file) const {
  const std::lock_guard lock(known_->guard);
  const auto at = known_->contents.find(file.string());
  return at == known_->contents.end() ? std::string() : at->second.key;
}

bool StepStore::isSound(const std::string& step, const std::string& key, const std::string& name) const {
  const fs::path file = fileOf(step, key, name);
  {
    const std::lock_guard lock(known_->guard);
    const auto at = known_->contents.find(file.string());
    if (at == known_->contents.end()) return false;
    if (at->second.seen) return true;
  }
  const auto content = contentOf(file, noProgress());
  if (!content || !*content || **content != promised(file)) return false;
  const std::lock_guard lock(known_->guard);
  known_->contents[file.string()].seen = true;
  return true;
}

bool StepStore::readBytes(const std::string& step, const std::string& key, const std::string& name, std::span<std::byte> into) const {
  const fs::path file = fileOf(step, key, name);
  std::ifstream in(file, std::ios::binary);
  in.read(reinterpret_cast<char*>(into.data()), static_cast<std::streamsize>(into.size()));
  return in && contentOf(into) == promised(file);
}

Result<void> StepStore::prepare(const std::string& step) const {
  std::error_code error;
  fs::create_directories(folder_ / "steps" / step, error);
  if (error) return storeNotWritable(folder_, verbatim(error.message()));
  return {};
}

Result<void> StepStore::keep(const std::string& step, const std::string& key, nlohmann::ordered_json data,
                             const std::vector<std::string>& names) const {
  if (auto room = prepare(step); !room) return room;
  nlohmann::ordered_json entry = {{"key", key}, {"made_by", std::string("EchoWeave ") + kVersion}};
  entry["files"] = nlohmann::ordered_json::array();
  for (const auto& name : names) {
    std::error_code error;
    const fs::path file = fileOf(step, key, name);
    const auto size = fs::file_size(file, error);
    if (error) return storeNotWritable(folder_, verbatim(error.message()));
    const auto content = contentOf(file, noProgress());
    if (!content || !*content) return storeNotWritable(folder_, say<"what was just written cannot be read">());
    promise(file, **content);
    entry["files"].push_back({{"name", name}, {"bytes", size}, {"content", **content}});
  }
  entry["data"] = std::move(data);
  const auto textOf = [](const nlohmann::ordered_json& document) {
    return document.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  };
  entry["content"] = contentOfEntry(jsonOrNull(textOf(entry)));  // as it will be read
  use(step, key);
  return writeFileSafely(folder_ / "steps" / step / (key + ".json"), textOf(entry));
}

void StepStore::remove(const std::string& step, const std::string& key) const {
  std::error_code ignored;
  const fs::path home = folder_ / "steps" / step;
  fs::remove(home / (key + ".json"), ignored);
  for (const auto& name : namesIn(home))
    if (keyOfBeside(name) == key) fs::remove(home / name, ignored);
}

std::vector<std::string> StepStore::keysOf(const std::string& step) const {
  std::vector<std::string> keys;
  for (const auto& name : namesIn(folder_ / "steps" / step))
    if (const std::string key = keyOfEntry(name); !key.empty()) keys.push_back(key);
  return keys;
}

void StepStore::removeAllBut(const std::string& step, const std::vector<std::string>& keys) const {
  for (const auto& key : keysOf(step))
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) remove(step, key);
}

void StepStore::use(const std::string& step, const std::string& key) const {
  const std::lock_guard lock(known_->guard);
  known_->used.insert(step + "/" + key);
}

/// Of each finished result with its files, by its name.
std::map<std::string, std::uint64_t> StepStore::bytesOfAll() const {
  std::map<std::string, std::uint64_t> all;
  for (const auto& step : steps_) {
    const fs::path home = folder_ / "steps" / step;
    for (const auto& key : keysOf(step)) all[step + "/" + key] = 0;
    for (const auto& name : namesIn(home)) {
      std::error_code error;
      const std::uintmax_t bytes = fs::file_size(home / name, error);
      const auto at = all.find(step + "/" + (keyOfEntry(name).empty() ? keyOfBeside(name) : keyOfEntry(name)));
      if (!error && at != all.end()) at->second += bytes;
    }
  }
  return all;
}

std::uint64_t StepStore::prune(std::uint64_t keepBytes) const {
  const fs::path memory = folder_ / "steps" / "uses.txt";
  std::map<std::string, std::uint64_t> known;  // the number of the finished run that used a result last
  std::uint64_t latest = 0;
  std::error_code ignored;
  bool isForeign = fs::exists(fs::symlink_status(memory, ignored));
  if (auto text = readTextFile(memory); text && isMarkedAsOwn(*text)) {
    isForeign = false;
    std::istringstream in(*text);
    std::string name;
    std::getline(in, name);  // whose it is
    for (std::uint64_t run = 0; in >> run >> name; latest = std::max(latest, run)) known[name] = run;
  }
  const std::lock_guard lock(known_->guard);
  struct Unused {
    std::uint64_t lastRun = 0;
    std::string name;
    std::uint64_t bytes = 0;
  };
  std::vector<Unused> unused;
  std::map<std::string, std::uint64_t> next;
  std::uint64_t spare = 0, freed = 0;
  for (const auto& [name, bytes] : bytesOfAll()) {
    if (known_->used.contains(name)) {
      next[name] = latest + 1;
      continue;
    }
    const auto at = known.find(name);  // unknown: of a run since the last one that finished
    unused.push_back({at == known.end() ? latest : at->second, name, bytes});
    next[name] = unused.back().lastRun;
    spare += bytes;
  }
  std::sort(unused.begin(), unused.end(),
            [](const Unused& a, const Unused& b) { return std::tie(a.lastRun, a.name) < std::tie(b.lastRun, b.name); });
  for (const Unused& old : unused) {
    if (spare <= keepBytes) break;
    const std::size_t slash = old.name.find('/');
    remove(old.name.substr(0, slash), old.name.substr(slash + 1));
    next.erase(old.name);
    spare -= old.bytes;
    freed += old.bytes;
  }
  // The same run again is no news.
  std::map<std::string, std::uint64_t> again = next;
  for (auto& [name, run] : again)
    if (known_->used.contains(name)) run = latest;
  if (again == known || isForeign) return freed;
  std::string text = "# " + std::string(kOwner) + ": which finished run used what last\n";
  for (const auto& [name, run] : next) text += std::to_string(run) + " " + name + "\n";
  static_cast<void>(writeFileSafely(memory, text));  // without room the order is forgotten, and no result
  return freed;
}

}  // namespace ew
