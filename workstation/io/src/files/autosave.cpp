#include "ew/io/autosave.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <condition_variable>
#include <deque>
#include <exception>
#include <map>
#include <mutex>
#include <system_error>
#include <thread>

#include "ew/core/contract.h"
#include "ew/core/json_fields.h"
#include "ew/io/own_folder.h"
#include "ew/io/private_file.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr const char* kAboutItem = "about.json";
constexpr std::size_t kLongestAbout_bytes = 1u << 20;
constexpr auto kSyncEvery = std::chrono::seconds(2);  // a kill loses nothing of what is written; a power cut no more than this

bool isPlainName(const std::string& item) {
  return !item.empty() && item.front() != '.' && item != OwnFolder::kLock && item.find('/') == std::string::npos;
}

std::optional<json> aboutOf(const fs::path& folder) {
  const auto text = readTextFile(folder / kAboutItem, kLongestAbout_bytes);
  if (!text) return std::nullopt;
  auto about = parseJsonObject(*text, verbatim(kAboutItem));
  return about ? std::optional(std::move(*about)) : std::nullopt;
}

/// When a file of the folder was written last.
std::chrono::system_clock::time_point latestIn(const fs::path& folder) {
  std::error_code failed;
  fs::file_time_type latest = fs::file_time_type::min();
  for (fs::directory_iterator at(folder, failed); !failed && at != fs::directory_iterator(); at.increment(failed)) {
    std::error_code gone;
    const auto written = at->last_write_time(gone);
    if (!gone) latest = std::max(latest, written);
  }
  return latest == fs::file_time_type::min() ? std::chrono::system_clock::now() : systemTimeOf(latest);
}

/// On the medium, so that a power cut does not take it; false with errno.
bool syncAt(const fs::path& place) {
  const int opened = ::open(place.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (opened < 0) return false;
  const int problem = ::fsync(opened) == 0 ? 0 : errno;
  ::close(opened);
  errno = problem;
  return problem == 0;
}

/// What lies beyond was written in part.
bool cutTo(int file, std::uint64_t bytes) {
  struct stat found {};
  if (::fstat(file, &found) != 0) return false;
  return static_cast<std::uint64_t>(found.st_size) <= bytes || ::ftruncate(file, static_cast<off_t>(bytes)) == 0;
}

/// At the end of a file; false with errno: not all of it.
bool addTo(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written == 0) errno = ENOSPC;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

Autosave::Left::Left(Left&& other) noexcept
    : folder_(std::move(other.folder_)), lock_(std::exchange(other.lock_, std::nullopt)), about_(std::move(other.about_)), at_(other.at_) {}

Autosave::Left& Autosave::Left::operator=(Left&& other) noexcept {
  std::swap(folder_, other.folder_);
  std::swap(lock_, other.lock_);
  std::swap(about_, other.about_);
  std::swap(at_, other.at_);
  return *this;
}

Autosave::Left::~Left() = default;

void Autosave::Left::release() { lock_.reset(); }

bool Autosave::Left::has(const std::string& item) const {
  std::error_code ignored;
  return fs::is_regular_file(folder_ / item, ignored);
}

std::vector<std::string> Autosave::Left::items() const {
  std::vector<std::string> names;
  std::error_code failed;
  for (fs::directory_iterator at(folder_, failed); !failed && at != fs::directory_iterator(); at.increment(failed))
    if (std::string name = at->path().filename().string(); isPlainName(name) && name != kAboutItem) names.push_back(std::move(name));
  std::sort(names.begin(), names.end());
  return names;
}

void Autosave::Left::discard() {
  if (!lock_) return;
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  lock_.reset();
}

/// The thread that writes, with what waits for it. Everything but the queue is the thread's own.
class Autosave::Writer {
 public:
  Writer(fs::path root, std::function<void(const Error&)> onProblem, Limits limits)
      : own_(std::move(root)), onProblem_(std::move(onProblem)), limits_(limits) {}

  ~Writer() {
    {
      const std::lock_guard lock(mutex_);
      tasks_.clear();  // it would be forgotten all the same
      ends_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
    others_.clear();  // who asks next decides
    forget();
  }

  enum class Does { write, other };
  void add(std::function<void()> task, Does does = Does::write) {
    {
      const std::lock_guard lock(mutex_);
      tasks_.push_back({std::move(task), does});
      if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
    }
    changed_.notify_all();
  }

  void flush() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return tasks_.empty() && !isAtWork_; });
  }

  /// What has not been written yet need not be.
  void dropWrites() {
    const std::lock_guard lock(mutex_);
    std::erase_if(tasks_, [](const Task& task) { return task.does == Does::write; });
  }

  /// Of an item that is replaced again before its turn came, the last one alone is written.
  std::uint64_t announce(const std::string& item) {
    const std::lock_guard lock(mutex_);
    return latest_[item] = ++announced_;
  }

  void describe(const json& about) {
    about_ = about.dump(-1, ' ', false, json::error_handler_t::replace);
    isAboutBehind_ = true;
    tell(makeReady());
  }

  void replace(const std::string& name, std::uint64_t number, const std::function<Result<std::string>()>& make) {
    if (!isLatest(name, number)) return leaveToLater(name);
    std::uint64_t size = 0;
    const auto written = [&]() -> Result<void> {
      if (auto made = makeReady(); !made) return made;
      const auto bytes = attempt<Result<std::string>>(make);
      if (!bytes) return passOn(bytes.error());
      if (auto room = roomFor(bytes->size(), name); !room) return room;
      size = bytes->size();
      return writePrivateFile(own_.path() / name, *bytes);
    }();
    settleReplaced(name, written, {.size = size});
  }

  void replaceFile(const std::string& name, std::uint64_t number, std::uint64_t bytes,
                   const std::function<Result<void>(const fs::path&)>& write) {
    if (!isLatest(name, number)) return leaveToLater(name);
    std::error_code failed;
    const auto written = [&]() -> Result<void> {
      if (auto made = makeReady(); !made) return made;
      if (auto room = roomFor(bytes, name); !room) return room;
      const fs::path aside = own_.path() / (".new-" + name);  // keeps the ending, by which writers choose a form
      auto made = attempt<Result<void>>([&] { return write(aside); });
      if (made) {
        fs::permissions(aside, fs::perms::owner_read | fs::perms::owner_write, failed);
        fs::rename(aside, own_.path() / name, failed);
        if (failed) made = refuse(failed.message());
      }
      if (!made) fs::remove(aside, failed);
      return made;
    }();
    const auto size = written ? fs::file_size(own_.path() / name, failed) : 0;
    settleReplaced(name, written, {.size = failed ? bytes : size, .isSynced = false});
  }

  void append(const std::string& name, std::string_view bytes) {
    Item& item = items_[name];
    if (item.isEnded) return;  // and was told
    item.held += bytes;
    item.isBehind = true;
    const auto added = addHeld(name, item);
    if (!added && item.held.size() > limits_.most_held_bytes) end(item);
    tell(added);
    if (added) catchUp();
  }

  void remove(const std::string& name) {
    std::error_code ignored;
    if (own_.isMade()) fs::remove(own_.path() / name, ignored);
    items_.erase(name);
    catchUp();  // there may be room now
  }

  void forget() {
    for (const std::shared_ptr<Left>& other : others_) other->discard();
    others_.clear();
    items_.clear();
    about_.clear();
    isAboutBehind_ = false;
    own_.remove();
  }

  void discardOnceKept(std::shared_ptr<Left> left) { others_.push_back(std::move(left)); }

 private:
  struct Item {
    std::uint64_t size = 0;  ///< bytes that are whole; a file that has more has them from a write that broke off
    std::string held = {};   ///< to be added, once that can be done
    bool isSynced = true;
    bool isBehind = false;  ///< something of it is not written
    bool isEnded = false;   ///< what is added to it would come after a gap
  };

  void run() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return ends_ || !tasks_.empty(); });
      if (tasks_.empty()) return;
      const std::function<void()> task = std::move(tasks_.front().work);
      tasks_.pop_front();
      isAtWork_ = true;
      lock.unlock();
      task();
      discardOthers();
      lock.lock();
      isAtWork_ = false;
      changed_.notify_all();
    }
  }

  bool isLatest(const std::string& item, std::uint64_t number) {
    const std::lock_guard lock(mutex_);
    return latest_[item] == number;
  }

  /// What comes later for the item takes the place of this.
  void leaveToLater(const std::string& name) { items_[name].isBehind = true; }

  static void end(Item& item) {
    item.isBehind = item.isEnded = true;
    item.held = std::string();  // gives the memory back
  }

  void settleReplaced(const std::string& name, const Result<void>& written, Item now) {
    if (written)
      items_[name] = std::move(now);
    else
      end(items_[name]);
    tell(written);
    if (written) catchUp();
  }

  /// Where something can be written, what waits may be as well; whoever handed it over was told when it could not.
  void catchUp() {
    for (auto& [name, item] : items_)
      if (!item.held.empty() && !addHeld(name, item)) return;
  }

  /// All that waits for an item, or nothing of it.
  [[nodiscard]] Result<void> addHeld(const std::string& name, Item& item) {
    if (auto made = makeReady(); !made) return made;
    if (auto room = roomFor(item.size + item.held.size(), name); !room) return room;
    const int file = ::open((own_.path() / name).c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0600);
    Result<void> outcome;
    if (file < 0 || !cutTo(file, item.size) || !addTo(file, item.held)) outcome = refuse(std::generic_category().message(errno));
    if (outcome) {
      item.size += item.held.size();
      item.held = std::string();
      item.isSynced = item.isBehind = false;
      if (const auto now = Clock::now(); now - syncedAt_ > kSyncEvery) {
        syncedAt_ = now;
        item.isSynced = ::fdatasync(file) == 0;
        if (!item.isSynced) {  // what of it is on the medium nobody knows
          outcome = refuse(std::generic_category().message(errno));
          end(item);
        }
      }
    } else if (file >= 0) {
      cutTo(file, item.size);  // else the next attempt does
    }
    if (file >= 0) ::close(file);
    return outcome;
  }

  /// Whether a power cut would leave the description and every item as they were handed over last.
  [[nodiscard]] bool isAllKept() {
    if (items_.empty() && !isAboutBehind_) return true;
    if (isAboutBehind_ || about_.empty()) return false;
    if (std::any_of(items_.begin(), items_.end(), [](const auto& each) { return each.second.isBehind; })) return false;
    for (auto& [name, item] : items_) {
      if (item.isSynced) continue;
      item.isSynced = syncAt(own_.path() / name);
      if (item.isSynced) continue;
      end(item);
      tell(refuse(std::generic_category().message(errno)));
      return false;
    }
    for (const fs::path& folder : {own_.path(), own_.root()}) syncAt(folder);  // some media cannot
    return true;
  }

  void discardOthers() {
    if (others_.empty() || !isAllKept()) return;
    for (const std::shared_ptr<Left>& other : others_) other->discard();
    others_.clear();
  }

  /// None of what a caller's function throws crosses the thread.
  template <class Outcome>
  Outcome attempt(const std::function<Outcome()>& work) const {
    try {
      return work();
    } catch (const std::exception& thrown) {
      return refuse(thrown.what());
    }
  }

  [[nodiscard]] tl::unexpected<Error> refuse(const std::string& reason) const {
    return failure(
        ErrorCode::notWritable,
        say<"Unsaved work cannot be kept in '%1' (%2), so a crash would lose it; save it yourself.">(own_.root().string(), reason),
        {{"folder", own_.root().string()}});
  }

  /// The folder, with the description.
  [[nodiscard]] Result<void> makeReady() {
    if (auto made = makeFolder(); !made) return made;
    if (!isAboutBehind_) return {};
    auto written = writePrivateFile(own_.path() / kAboutItem, about_);
    isAboutBehind_ = !written;
    return written;
  }

  [[nodiscard]] Result<void> makeFolder() {
    if (const std::string problem = own_.make(); !problem.empty()) return refuse(problem);
    return {};
  }

  /// Whether an item may have so many bytes.
  [[nodiscard]] Result<void> roomFor(std::uint64_t bytes, const std::string& item) const {
    std::uint64_t all = bytes, before = 0;
    for (const auto& [name, each] : items_) (name == item ? before : all) += each.size;
    std::error_code failed;
    const auto space = fs::space(own_.path(), failed);
    const std::uint64_t more = bytes > before ? bytes - before : 0;
    if (all <= limits_.most_bytes && (failed || space.available >= more + limits_.least_free_bytes)) return {};
    return failure(
        ErrorCode::tooLarge,
        say<"There is too little room in '%1' to keep what is not saved yet (%2 MiB), so a crash would lose it; save it yourself.">(
            own_.root().string(), std::max<std::uint64_t>(1, bytes >> 20)),
        {{"folder", own_.root().string()}});
  }

  void tell(const Result<void>& outcome) {
    if (outcome) {
      isTold_ = false;
    } else if (!std::exchange(isTold_, true) && onProblem_) {
      onProblem_(outcome.error());
    }
  }

  OwnFolder own_;
  std::function<void(const Error&)> onProblem_;
  Limits limits_;
  std::string about_;
  bool isAboutBehind_ = false;  ///< as described last it is not written
  std::map<std::string, Item> items_;
  std::vector<std::shared_ptr<Left>> others_;  ///< whose work is kept here, once it is
  Clock::time_point syncedAt_{};
  bool isTold_ = false;

  std::mutex mutex_;
  std::condition_variable changed_;
  struct Task {
    std::function<void()> work;
    Does does = Does::write;
  };
  std::deque<Task> tasks_;
  std::map<std::string, std::uint64_t> latest_;
  std::uint64_t announced_ = 0;
  bool isAtWork_ = false;
  bool ends_ = false;
  std::thread thread_;
};

Autosave::Autosave(fs::path root, std::function<void(const Error&)> onProblem, Limits limits)
    : root_(std::move(root)), writer_(std::make_unique<Writer>(root_, std::move(onProblem), limits)) {}

Autosave::Autosave(fs::path root, std::function<void(const Error&)> onProblem)
    : Autosave(std::move(root), std::move(onProblem), Limits{}) {}

Autosave::~Autosave() = default;

void Autosave::describe(json about) {
  writer_->add([this, about = std::move(about)] { writer_->describe(about); });
}

void Autosave::replace(const std::string& item, std::function<Result<std::string>()> make) {
  EW_EXPECTS(isPlainName(item));
  writer_->add([this, item, number = writer_->announce(item), make = std::move(make)] { writer_->replace(item, number, make); });
}

void Autosave::replace(const std::string& item, std::string bytes) {
  replace(item, [bytes = std::move(bytes)]() -> Result<std::string> { return bytes; });
}

void Autosave::replaceFile(const std::string& item, std::uint64_t bytes, std::function<Result<void>(const fs::path&)> write) {
  EW_EXPECTS(isPlainName(item));
  writer_->add([this, item, number = writer_->announce(item), bytes, write = std::move(write)] {
    writer_->replaceFile(item, number, bytes, write);
  });
}

void Autosave::append(const std::string& item, std::string bytes) {
  EW_EXPECTS(isPlainName(item));
  writer_->add([this, item, bytes = std::move(bytes)] { writer_->append(item, bytes); });
}

void Autosave::remove(const std::string& item) {
  writer_->announce(item);
  writer_->add([this, item] { writer_->remove(item); });
}

void Autosave::forget() {
  writer_->dropWrites();
  writer_->add([this] { writer_->forget(); }, Writer::Does::other);
}

void Autosave::discardOnceKept(std::shared_ptr<Left> left) {
  EW_EXPECTS(left != nullptr);
  writer_->add([this, left = std::move(left)] { writer_->discardOnceKept(left); }, Writer::Does::other);
}

void Autosave::flush() { writer_->flush(); }

std::vector<Autosave::Left> Autosave::takeLeft() const {
  return takeLeft([](const json&) { return true; });
}

std::vector<Autosave::Left> Autosave::takeLeft(const std::function<bool(const json& about)>& isWanted) const {
  std::vector<Left> found;
  std::error_code failed;
  for (fs::directory_iterator at(root_, failed); !failed && at != fs::directory_iterator(); at.increment(failed)) {
    std::error_code ignored;
    if (!fs::is_directory(at->symlink_status(ignored))) continue;
    auto lock = OwnFolder::lockOfAbandoned(at->path());
    if (!lock) continue;
    auto about = aboutOf(at->path());
    Left left(at->path(), std::move(*lock), about ? std::move(*about) : json(), latestIn(at->path()));
    if (left.about_.is_object() && isWanted(left.about_)) found.push_back(std::move(left));
  }
  std::sort(found.begin(), found.end(), [](const Left& a, const Left& b) { return a.at_ > b.at_; });
  return found;
}

}  // namespace ew
