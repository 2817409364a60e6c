#include "ew/library/folder_lease.h"

#include <fcntl.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>
#include <vector>

#include "ew/core/json_fields.h"
#include "ew/core/machine_mark.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kLease = ".ew-lease-";
constexpr long long kMostLeases = 1'000'000'000'000ll;

std::optional<long long> leaseNumber(const std::string& name) {
  if (!name.starts_with(kLease)) return std::nullopt;
  long long number = 0;
  const char* const end = name.data() + name.size();
  const auto read = std::from_chars(name.data() + kLease.size(), end, number);
  if (read.ec != std::errc{} || read.ptr != end || number < 1 || number > kMostLeases) return std::nullopt;
  return number;
}

fs::path leaseFile(const fs::path& folder, long long number) { return folder / (std::string(kLease) + std::to_string(number)); }

std::vector<long long> leaseNumbers(const fs::path& folder) {
  std::vector<long long> numbers;
  std::error_code problem;
  for (fs::directory_iterator at(folder, problem), end; !problem && at != end; at.increment(problem))
    if (const auto number = leaseNumber(at->path().filename().string())) numbers.push_back(*number);
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

std::string hostNow() {
  std::array<char, 256> name{};
  ::gethostname(name.data(), name.size() - 1);
  return name.data();
}

std::string userNow() {
  std::array<char, 4096> room{};
  passwd entry{};
  passwd* found = nullptr;
  if (::getpwuid_r(::geteuid(), &entry, room.data(), room.size(), &found) == 0 && found != nullptr) return found->pw_name;
  return std::to_string(::geteuid());
}

/// When a process began, in the system's own count: its number may be another process's by now. 0: there is none, or the system does not
/// tell.
unsigned long long startOf(long long process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/stat");
  std::string text((std::istreambuf_iterator<char>(in)), {});
  const auto name = text.rfind(')');  // a name may hold anything
  if (name == std::string::npos) return 0;
  std::istringstream rest(text.substr(name + 1));
  std::string skipped;
  constexpr int kFieldsBefore = 19;
  for (int n = 0; n < kFieldsBefore; ++n) rest >> skipped;
  unsigned long long start = 0;
  rest >> start;
  return start;
}

/// What a lease says.
struct Lease {
  LeaseHolder holder;
  unsigned long long processStart = 0;
  std::string machine;  ///< whose processes the number is one of; empty: of a program that did not say
  bool isFree = false;
  timespec touched{};
};

std::string textOf(const LeaseHolder& holder, bool isFree) {
  const nlohmann::ordered_json document = {{"user", holder.user},
                                           {"host", holder.host},
                                           {"process", holder.process},
                                           {"process_start", startOf(holder.process)},
                                           {"machine", machineMark()},
                                           {"since", holder.since.time_since_epoch().count()},
                                           {"free", isFree}};
  return document.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace) + "\n";
}

/// Nothing when it is not there. One that cannot be read belongs to somebody nobody knows, as long as it is young.
std::optional<Lease> readLease(const fs::path& file) {
  // Opened, not asked by name: only then a network file system asks its server.
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor < 0) return std::nullopt;
  Lease lease;
  struct stat found {};
  std::string text(4096, '\0');
  const bool known = ::fstat(descriptor, &found) == 0;
  const ssize_t got = ::read(descriptor, text.data(), text.size());
  ::close(descriptor);
  if (!known) return std::nullopt;
  lease.touched = found.st_mtim;
  text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  const Message where = verbatim(file.string());
  const auto document = parseJsonObject(text, where);
  if (!document) return lease;
  JsonReading reading(where);
  const JsonFields fields(*document, reading);
  constexpr long long kMost = 1ll << 52;
  lease.holder = {.user = fields.text("user", std::string(), 0),
                  .host = fields.text("host", std::string(), 0, 300),
                  .process = fields.whole("process", 0, kMost, 0),
                  .since = std::chrono::sys_seconds(std::chrono::seconds(fields.whole("since", 0, 1ll << 40, 0)))};
  lease.processStart = static_cast<unsigned long long>(fields.whole("process_start", 0, kMost, 0));
  lease.machine = fields.text("machine", std::string(), 0);
  lease.isFree = fields.flag("free", false);
  return lease;
}

double secondsFromTo(const timespec& from, const timespec& to) {
  return static_cast<double>(to.tv_sec - from.tv_sec) + 1e-9 * static_cast<double>(to.tv_nsec - from.tv_nsec);
}

/// Whether the process that made a lease has ended, as far as this machine can tell: a process of another machine or container it does not
/// know, and of another account's it may see the number alone.
bool hasEnded(const Lease& lease) {
  if (lease.machine != machineMark()) return false;
  const auto process = static_cast<pid_t>(lease.holder.process);
  if (!isProcessThere(process)) return true;
  const auto start = startOf(process);
  return start != 0 && lease.processStart != 0 && start != lease.processStart;
}

/// Nobody holds it any more. @param now by the clock of whoever keeps the files
bool isOver(const Lease& lease, const std::optional<timespec>& now, const LeaseOptions& options) {
  if (lease.isFree || hasEnded(lease)) return true;
  return now && secondsFromTo(lease.touched, *now) > static_cast<double>(options.staleAfter.count());
}

/// A file of our own in the folder, with a lease's text; its time is the server's.
class Candidate {
 public:
  static Result<Candidate> write(const fs::path& folder, const std::string& text) {
    static std::atomic<unsigned> counter{0};
    const fs::path file = folder / (".ew-leasing-" + hostNow() + "-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
    ::unlink(file.c_str());  // of a process of the same number that was killed
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) return cannot(folder);
    Candidate made(file);
    const bool written = ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size()) && ::fsync(descriptor) == 0;
    struct stat found {};
    const bool known = ::fstat(descriptor, &found) == 0;
    if (::close(descriptor) != 0 || !written || !known) return cannot(folder);
    made.now_ = found.st_mtim;
    return made;
  }
  ~Candidate() {
    if (!file_.empty()) ::unlink(file_.c_str());
  }
  Candidate(Candidate&& other) noexcept : file_(std::exchange(other.file_, {})), now_(other.now_) {}
  Candidate& operator=(Candidate&&) = delete;

  [[nodiscard]] const timespec& now() const { return now_; }
  /// Gives it a second name that nobody has. Some servers say no although they did it: the file knows.
  [[nodiscard]] bool linkTo(const fs::path& name) const {
    if (::link(file_.c_str(), name.c_str()) == 0) return true;
    const int reason = errno;
    struct stat found {};
    if (::stat(file_.c_str(), &found) == 0 && found.st_nlink == 2) return true;
    if (reason == EEXIST) return false;
    // A file system without links: the file is made in place, and for a moment it is one that cannot be read.
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) return false;
    std::ifstream in(file_, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    const bool written = ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    return ::close(descriptor) == 0 && written;
  }
  [[nodiscard]] bool replace(const fs::path& name) {
    if (::rename(file_.c_str(), name.c_str()) != 0) return false;
    file_.clear();
    return true;
  }

  static tl::unexpected<Error> cannot(const fs::path& folder) {
    return failure(ErrorCode::notWritable,
                   say<"The folder '%1' cannot be reserved for editing (%2); check that you may write there, or save the case elsewhere.">(
                       folder, verbatim(std::generic_category().message(errno))),
                   {{"file", folder.string()}});
  }

 private:
  explicit Candidate(fs::path file) : file_(std::move(file)) {}
  fs::path file_;
  timespec now_{};
};

LeaseHolder ourselves() {
  return {.user = userNow(),
          .host = hostNow(),
          .process = ::getpid(),
          .since = std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::system_clock::now())};
}

std::string timeText(std::chrono::sys_seconds since) {
  const std::time_t time = since.time_since_epoch().count();
  std::tm local{};
  ::localtime_r(&time, &local);
  std::array<char, 64> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &local);
  return text.data();
}

std::vector<std::pair<std::string, std::string>> contextOf(const fs::path& folder, const LeaseHolder& holder) {
  return {{"file", folder.string()}, {"user", holder.user}, {"host", holder.host}, {"process", std::to_string(holder.process)}};
}

tl::unexpected<Error> isHeld(const fs::path& folder, const LeaseHolder& holder) {
  if (holder.host.empty())
    return failure(
        ErrorCode::notWritable,
        say<"The folder '%1' is being edited by somebody who cannot be told; wait two minutes, or save the case elsewhere.">(folder),
        contextOf(folder, holder));
  return failure(ErrorCode::notWritable,
                 say<"The folder '%1' is being edited by %2 on the computer %3 since %4; wait until it is closed there, or save the case "
                     "elsewhere.">(folder, holder.user, holder.host, timeText(holder.since)),
                 contextOf(folder, holder));
}

tl::unexpected<Error> isLost(const fs::path& folder, const LeaseHolder& holder) {
  return failure(ErrorCode::notWritable,
                 say<"The folder '%1' was taken over by %2 on the computer %3 while this program did not run; save your work as another "
                     "case.">(folder, holder.user, holder.host),
                 contextOf(folder, holder));
}

}  // namespace

bool isLeaseFile(const fs::path& name) {
  const std::string text = name.filename().string();
  return text.starts_with(".ew-leas");
}

Result<FolderLease> FolderLease::take(const fs::path& folder, const LeaseOptions& options) {
  auto candidate = Candidate::write(folder, textOf(ourselves(), false));
  if (!candidate) return passOn(candidate.error());
  constexpr int kAttempts = 20;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const auto before = leaseNumbers(folder);
    const long long last = before.empty() ? 0 : before.back();
    if (last > 0) {
      const auto lease = readLease(leaseFile(folder, last));
      if (!lease) continue;  // taken away between listing and reading
      if (!isOver(*lease, candidate->now(), options)) return isHeld(folder, lease->holder);
    }
    if (!candidate->linkTo(leaseFile(folder, last + 1))) continue;  // somebody was faster
    FolderLease taken(folder, last + 1);
    // Who was slow may have made a number that others have long passed and taken away.
    const auto after = leaseNumbers(folder);
    if (after.empty() || after.back() != last + 1) {
      ::unlink(leaseFile(folder, last + 1).c_str());
      taken.number_ = 0;
      continue;
    }
    for (const long long number : after)
      if (number < last + 1) ::unlink(leaseFile(folder, number).c_str());
    return taken;
  }
  errno = EAGAIN;
  return Candidate::cannot(folder);
}

Result<void> FolderLease::refresh() {
  const auto numbers = leaseNumbers(folder_);
  if (!numbers.empty() && numbers.back() > number_) {
    const auto lease = readLease(leaseFile(folder_, numbers.back()));
    number_ = 0;  // it is theirs to free
    return isLost(folder_, lease ? lease->holder : LeaseHolder());
  }
  // No time is given: the server's is taken.
  if (number_ != 0 && ::utimensat(AT_FDCWD, leaseFile(folder_, number_).c_str(), nullptr, AT_SYMLINK_NOFOLLOW) == 0) return {};
  return Candidate::cannot(folder_);
}

std::optional<LeaseHolder> FolderLease::holderOf(const fs::path& folder, const LeaseOptions& options) {
  const auto numbers = leaseNumbers(folder);
  if (numbers.empty()) return std::nullopt;
  const auto lease = readLease(leaseFile(folder, numbers.back()));
  if (!lease || lease->isFree) return std::nullopt;
  // The server's time; where nothing can be written the lease counts while its process may live.
  const auto clock = Candidate::write(folder, "");
  if (isOver(*lease, clock ? std::optional(clock->now()) : std::nullopt, options)) return std::nullopt;
  return lease->holder;
}

void FolderLease::free() {
  if (number_ == 0) return;
  const fs::path file = leaseFile(folder_, std::exchange(number_, 0));
  if (!readLease(file)) return;  // the folder is gone
  if (auto ended = Candidate::write(folder_, textOf(ourselves(), true)); ended) (void)ended->replace(file);
}

FolderLease::~FolderLease() { free(); }

FolderLease::FolderLease(FolderLease&& other) noexcept : folder_(std::move(other.folder_)), number_(std::exchange(other.number_, 0)) {}

FolderLease& FolderLease::operator=(FolderLease&& other) noexcept {
  if (this == &other) return *this;
  free();
  folder_ = std::move(other.folder_);
  number_ = std::exchange(other.number_, 0);
  return *this;
}

}  // namespace ew
