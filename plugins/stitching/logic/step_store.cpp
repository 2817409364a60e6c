#include "logic/step_store.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>
#include <tuple>

#include "ew/core/output_set.h"
#include "ew/core/version.h"
#include "logic/content_key.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

tl::unexpected<Error> notWritable(const fs::path& folder, const std::string& reason) {
  return failure(ErrorCode::notWritable,
                 "The folder '" + folder.string() + "' cannot be written (" + reason + "); choose one you may write to.",
                 {{"file", folder.string()}});
}

std::string reasonOf(int number) { return std::generic_category().message(number); }

}  // namespace

Result<StepStore> StepStore::open(const fs::path& folder, sdk::Files& files) {
  StepStore store(folder, files);
  std::error_code error;
  fs::create_directories(folder / "steps", error);
  if (error) return notWritable(folder, error.message());
  const fs::path lock = folder / "steps" / ".lock";
  store.lock_ = ::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (store.lock_ < 0) return notWritable(folder, reasonOf(errno));
  if (::flock(store.lock_, LOCK_EX | LOCK_NB) != 0 && (errno == EWOULDBLOCK || errno == EINTR))
    return failure(ErrorCode::notWritable,
                   "Another run is at work in '" + folder.string() + "'; wait until it has ended, or choose another folder.",
                   {{"file", lock.string()}});
  removeLeftovers(folder / "steps");
  for (auto step = fs::directory_iterator(folder / "steps", error); step != fs::directory_iterator(); step.increment(error))
    if (step->is_directory(error)) removeLeftovers(step->path());
  store.clearLeftovers();
  return store;
}

StepStore StepStore::peek(const fs::path& folder, sdk::Files& files) { return {folder, files}; }

StepStore::StepStore(StepStore&& other) noexcept
    : folder_(std::move(other.folder_)), files_(other.files_), uses_(std::move(other.uses_)), lock_(other.lock_) {
  other.lock_ = -1;
}

StepStore::~StepStore() {
  if (lock_ >= 0) ::close(lock_);
}

void StepStore::clearLeftovers() const {
  std::error_code ignored;
  std::vector<fs::path> besides;  // of the memory of inputs, which is written aside as well
  for (auto at = fs::directory_iterator(folder_ / "steps", ignored); at != fs::directory_iterator(); at.increment(ignored))
    if (at->path().extension() == ".part" && at->is_regular_file(ignored)) besides.push_back(at->path());
  for (const auto& file : besides) fs::remove(file, ignored);
  for (auto step = fs::directory_iterator(folder_ / "steps", ignored); step != fs::directory_iterator(); step.increment(ignored)) {
    if (!step->is_directory(ignored)) continue;
    std::vector<fs::path> stale;
    for (auto at = fs::directory_iterator(step->path(), ignored); at != fs::directory_iterator(); at.increment(ignored)) {
      const std::string name = at->path().filename().string();
      const std::size_t dash = name.find('-');
      // Half-written neighbours begin with a dot. A finished file whose .json never came is made again, so it only takes room.
      const bool orphan = dash != std::string::npos && !fs::exists(step->path() / (name.substr(0, dash) + ".json"), ignored);
      if (name.starts_with('.') || orphan) stale.push_back(at->path());
    }
    for (const auto& file : stale) fs::remove(file, ignored);
  }
}

fs::path StepStore::fileOf(const std::string& step, const std::string& key, const std::string& name) const {
  return folder_ / "steps" / step / (key + "-" + name);
}

std::optional<json> StepStore::find(const std::string& step, const std::string& key) const {
  const fs::path entry = folder_ / "steps" / step / (key + ".json");
  std::error_code ignored;
  if (!fs::is_regular_file(entry, ignored)) return std::nullopt;
  const auto text = files_->readText(entry);
  if (!text) return std::nullopt;
  try {
    json read = json::parse(*text);
    if (read.at("key") != key) return std::nullopt;
    for (const auto& file : read.at("files")) {
      const auto size = fs::file_size(fileOf(step, key, file.at("name").get<std::string>()), ignored);
      if (ignored || size != file.at("bytes").get<std::uintmax_t>()) return std::nullopt;
    }
    json data = std::move(read.at("data"));
    use(step, key);
    return data;
  } catch (const json::exception&) {
    return std::nullopt;  // damaged: made again
  }
}

std::optional<std::uintmax_t> StepStore::bytesOf(const std::string& step, const std::string& key, const std::string& name) const {
  std::error_code error;
  const auto size = fs::file_size(fileOf(step, key, name), error);
  if (error) return std::nullopt;
  return size;
}

bool StepStore::readBytes(const std::string& step, const std::string& key, const std::string& name, std::span<std::byte> into) const {
  std::ifstream in(fileOf(step, key, name), std::ios::binary);
  in.read(reinterpret_cast<char*>(into.data()), static_cast<std::streamsize>(into.size()));
  return static_cast<bool>(in);
}

Result<void> StepStore::prepare(const std::string& step) const {
  std::error_code error;
  fs::create_directories(folder_ / "steps" / step, error);
  if (error) return notWritable(folder_, error.message());
  return {};
}

Result<void> StepStore::keep(const std::string& step, const std::string& key, nlohmann::ordered_json data,
                             const std::vector<std::string>& names) const {
  if (auto room = prepare(step); !room) return room;
  nlohmann::ordered_json entry = {{"key", key}, {"made_by", std::string("EchoWeave ") + kVersion}};
  entry["files"] = nlohmann::ordered_json::array();
  for (const auto& name : names) {
    std::error_code error;
    const auto size = fs::file_size(fileOf(step, key, name), error);
    if (error) return notWritable(folder_, error.message());
    entry["files"].push_back({{"name", name}, {"bytes", size}});
  }
  entry["data"] = std::move(data);
  use(step, key);
  return files_->writeText(folder_ / "steps" / step / (key + ".json"),
                           entry.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

void StepStore::remove(const std::string& step, const std::string& key) const {
  std::error_code ignored;
  const fs::path home = folder_ / "steps" / step;
  fs::remove(home / (key + ".json"), ignored);
  std::vector<fs::path> files;
  for (auto at = fs::directory_iterator(home, ignored); at != fs::directory_iterator(); at.increment(ignored))
    if (at->path().filename().string().starts_with(key + "-")) files.push_back(at->path());
  for (const auto& file : files) fs::remove(file, ignored);
}

void StepStore::removeAllBut(const std::string& step, const std::vector<std::string>& keys) const {
  std::error_code ignored;
  std::vector<std::string> others;
  for (auto at = fs::directory_iterator(folder_ / "steps" / step, ignored); at != fs::directory_iterator(); at.increment(ignored))
    if (at->path().extension() == ".json") {
      const std::string key = at->path().stem().string();
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) others.push_back(key);
    }
  for (const auto& key : others) remove(step, key);
}

void StepStore::use(const std::string& step, const std::string& key) const {
  const std::lock_guard lock(uses_->guard);
  uses_->names.insert(step + "/" + key);
}

/// Of each finished result with its files, by its name.
std::map<std::string, std::uint64_t> StepStore::bytesOfAll() const {
  std::map<std::string, std::uint64_t> all;
  std::error_code ignored;
  for (auto step = fs::directory_iterator(folder_ / "steps", ignored); step != fs::directory_iterator(); step.increment(ignored)) {
    if (!step->is_directory(ignored)) continue;
    const std::string home = step->path().filename().string() + "/";
    std::map<std::string, std::uint64_t> beside;
    for (auto at = fs::directory_iterator(step->path(), ignored); at != fs::directory_iterator(); at.increment(ignored)) {
      const std::uintmax_t bytes = at->file_size(ignored);
      if (ignored) continue;
      const std::string name = at->path().filename().string();
      const std::size_t dash = name.find('-');
      if (dash == std::string::npos && name.ends_with(".json")) all[home + at->path().stem().string()] += bytes;
      if (dash != std::string::npos) beside[home + name.substr(0, dash)] += bytes;
    }
    for (const auto& [name, bytes] : beside)
      if (const auto at = all.find(name); at != all.end()) at->second += bytes;
  }
  return all;
}

std::uint64_t StepStore::prune(std::uint64_t keepBytes) const {
  const fs::path memory = folder_ / "steps" / "uses.txt";
  std::map<std::string, std::uint64_t> known;  // the number of the finished run that used a result last
  std::uint64_t latest = 0;
  if (auto text = files_->readText(memory)) {
    std::istringstream in(*text);
    std::string name;
    for (std::uint64_t run = 0; in >> run >> name; latest = std::max(latest, run)) known[name] = run;
  }
  const std::lock_guard lock(uses_->guard);
  struct Unused {
    std::uint64_t lastRun = 0;
    std::string name;
    std::uint64_t bytes = 0;
  };
  std::vector<Unused> unused;
  std::map<std::string, std::uint64_t> next;
  std::uint64_t spare = 0, freed = 0;
  for (const auto& [name, bytes] : bytesOfAll()) {
    if (uses_->names.contains(name)) {
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
    if (uses_->names.contains(name)) run = latest;
  if (again == known) return freed;
  std::string text;
  for (const auto& [name, run] : next) text += std::to_string(run) + " " + name + "\n";
  static_cast<void>(files_->writeText(memory, text));  // without room the order is forgotten, and no result
  return freed;
}

FileContents::FileContents(const StepStore& store, sdk::Files& files) : memory_(store.folder() / "steps" / "inputs.json"), files_(files) {
  std::error_code ignored;
  if (fs::is_regular_file(memory_, ignored))
    if (const auto text = files.readText(memory_)) known_ = json::parse(*text, nullptr, false);
  if (!known_.is_object()) known_ = json::object();
}

Result<std::optional<std::string>> FileContents::keyOf(const fs::path& file, Progress& progress) {
  struct stat status {};
  std::ifstream in(file, std::ios::binary);
  if (!in || ::stat(file.c_str(), &status) != 0) return std::optional<std::string>();
  std::error_code ignored;
  const std::string name = fs::absolute(file, ignored).lexically_normal().string();
  const json stamp = {status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec, status.st_ino};
  if (known_.contains(name) && known_[name].is_object() && known_[name].value("stamp", json()) == stamp &&
      known_[name].contains("content") && known_[name]["content"].is_string())
    return std::optional(known_[name]["content"].get<std::string>());
  ContentKey key;
  std::vector<char> chunk(1u << 20);
  while (in) {
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, "The stitching was cancelled.");
    in.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    key.add(std::span(reinterpret_cast<const std::uint8_t*>(chunk.data()), static_cast<std::size_t>(in.gcount())));
  }
  if (in.bad())
    return failure(ErrorCode::notReadable, "\"" + file.string() + "\" cannot be read; check the medium it is on.",
                   {{"file", file.string()}});
  known_[name] = {{"stamp", stamp}, {"content", key.text()}};
  changed_ = true;
  return std::optional(key.text());
}

void FileContents::save() {
  if (!changed_) return;
  static_cast<void>(files_.writeText(memory_, known_.dump(1, ' ', false, json::error_handler_t::replace)));
  changed_ = false;
}

}  // namespace ew::stitching
