#include "ew/core/output_set.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <optional>
#include <system_error>

#include "ew/core/contract.h"
#include "ew/core/ending.h"
#include "ew/core/file_errors.h"
#include "ew/core/machine_mark.h"

namespace ew {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kAside = ".ew-";
constexpr std::string_view kEarlier = ".earlier";

bool sameFile(const fs::path& a, const fs::path& b) {
  std::error_code problem;
  if (fs::equivalent(a, b, problem)) return true;
  const fs::path first = fs::weakly_canonical(a, problem);
  if (problem) return false;
  const fs::path second = fs::weakly_canonical(b, problem);
  return !problem && first == second;
}

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

tl::unexpected<Error> isSomebodyElses(const fs::path& file) {
  return failure(ErrorCode::notWritable,
                 say<"\"%1\" was made by somebody else in the meantime and is left as it is; choose another name.">(file),
                 {{"file", file.string()}});
}

tl::unexpected<Error> wrongUsage(const fs::path& file, Message what) {
  return failure(ErrorCode::badUsage, std::move(what), {{"file", file.string()}});
}

/// What a file's name leads to, by way of links, also when nothing is there yet.
fs::path behindLinks(fs::path file) {
  constexpr int kMostLinks = 40;  // as many as the kernel follows
  std::error_code problem;
  for (int n = 0; n < kMostLinks && fs::is_symlink(fs::symlink_status(file, problem)); ++n) {
    const fs::path named = fs::read_symlink(file, problem);
    if (problem) return file;
    file = named.is_absolute() ? named : folderOf(file) / named;
  }
  return file;
}

bool syncPath(const fs::path& path, int flags) {
  const int descriptor = ::open(path.c_str(), flags | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool synced = ::fsync(descriptor) == 0;
  const int number = errno;
  ::close(descriptor);
  errno = number;
  return synced;
}

/// A file, or a folder with everything in it.
bool syncAll(const fs::path& path) {
  std::error_code problem;
  if (!fs::is_directory(path, problem)) return syncPath(path, O_RDONLY);
  for (fs::recursive_directory_iterator at(path, problem), end; !problem && at != end; at.increment(problem))
    if (!at->is_symlink(problem) && !syncPath(at->path(), O_RDONLY)) return false;
  errno = problem.value();
  return !problem && syncPath(path, O_RDONLY | O_DIRECTORY);
}

/// Renames unless something has the name: at once where the file system can, else by looking first.
int renameToFreeName(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return errno;
  std::error_code problem;
  if (fs::exists(fs::symlink_status(to, problem))) return EEXIST;
  return ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

struct Maker {
  pid_t process = 0;
  bool isHere = true;  // on this machine
};

/// Who made a folder aside; empty: it is none.
std::optional<Maker> makerOf(const std::string& name) {
  if (!name.starts_with(kAside)) return std::nullopt;
  const char* const end = name.data() + name.size();
  Maker maker;
  unsigned number = 0;
  const auto first = std::from_chars(name.data() + kAside.size(), end, maker.process);
  if (first.ec != std::errc{} || first.ptr == end || *first.ptr != '-') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, number);
  if (second.ec != std::errc{} || maker.process <= 0) return std::nullopt;
  const std::string_view machine(second.ptr, static_cast<std::size_t>(end - second.ptr));
  if (machine.empty()) return maker;  // of earlier versions
  if (machine.size() != 9 || machine.front() != '-') return std::nullopt;
  maker.isHere = machine.substr(1) == machineMark();
  return maker;
}

/// Whether it holds what a file was before, of somebody who ended in the middle of putting files in place, or could not put them back: the
/// only copy there may be.
bool holdsEarlier(const fs::path& aside) {
  std::error_code problem;
  fs::directory_iterator at(aside, problem);
  for (const fs::directory_iterator end; !problem && at != end; at.increment(problem))
    if (at->path().filename().string().ends_with(kEarlier)) return true;
  return static_cast<bool>(problem);
}

/// Whether nobody can be at work in a folder aside any more, and nothing in it is missed. What another machine made is left for as long as
/// any work may last.
bool isLeftover(const fs::path& aside) {
  const auto maker = makerOf(aside.filename().string());
  std::error_code problem;
  if (!maker || !fs::is_directory(fs::symlink_status(aside, problem)) || holdsEarlier(aside)) return false;
  if (maker->isHere) return maker->process != ::getpid() && !isProcessThere(maker->process);
  constexpr std::chrono::hours kLongestWork(48);
  const auto changed = fs::last_write_time(aside, problem);
  return !problem && fs::file_time_type::clock::now() - changed > kLongestWork;
}

/// What killed programs left aside in a folder goes before the first output of this program there.
void sweepOnce(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<fs::path> swept;
  std::error_code problem;
  const fs::path whole = fs::weakly_canonical(folder, problem);
  {
    const std::lock_guard lock(mutex);
    if (problem || !swept.insert(whole).second) return;
  }
  removeLeftovers(folder);
}

}  // namespace

std::vector<fs::path> filesNamedBy(const fs::path& file) {
  if (endingOf(file) != ".mhd") return {file};
  return {fs::path(file).replace_extension(".raw"), file};
}

OutputSet::~OutputSet() { clear(); }

void OutputSet::clear() {
  std::error_code ignored;
  // What is empty goes without being opened, which may be what could not be done.
  for (const auto& aside : asides_)
    if (!fs::remove(aside.path, ignored)) fs::remove_all(aside.path, ignored);
  for (auto folder = madeFolders_.rbegin(); folder != madeFolders_.rend(); ++folder) fs::remove(*folder, ignored);  // only an empty one
  asides_.clear();
  madeFolders_.clear();
  listed_.clear();
  outputs_.clear();
}

Result<void> OutputSet::protect(const fs::path& input) {
  for (const auto& file : filesNamedBy(input)) {
    for (const auto& output : outputs_)
      if (sameFile(file, output.given))
        return wrongUsage(output.given, say<"The output '%1' is also an input; give it another name.">(output.given));
    inputs_.push_back(file);
  }
  return {};
}

Result<fs::path> OutputSet::asideOf(const fs::path& folder, const fs::path& wanted) {
  static std::atomic<unsigned> counter{0};
  for (const auto& aside : asides_)
    if (aside.folder == folder) return aside.path;
  sweepOnce(folder);
  // Asking for permissions answers for the wrong user on some file systems; making something does not.
  for (int attempt = 0; attempt < 100; ++attempt) {
    const fs::path path =
        folder / (std::string(kAside) + std::to_string(::getpid()) + "-" + std::to_string(counter++) + "-" + machineMark());
    if (::mkdir(path.c_str(), 0700) == 0) {
      asides_.push_back({folder, path});
      return path;
    }
    if (errno != EEXIST) return notWritable(wanted, errno);
  }
  return notWritable(wanted, say<"no free name beside it">());
}

bool OutputSet::cameMeanwhile(const fs::path& file) const {
  return std::any_of(listed_.begin(), listed_.end(),
                     [&](const Listed& seen) { return sameFile(seen.folder, folderOf(file)) && !seen.names.contains(file.filename()); });
}

Result<void> OutputSet::announceOne(const fs::path& given, const fs::path& target) {
  for (const auto& input : inputs_)
    if (sameFile(given, input)) return wrongUsage(given, say<"The output '%1' is also an input; give it another name.">(given));
  for (const auto& output : outputs_)
    if (sameFile(given, output.given) || sameFile(target, output.target))
      return wrongUsage(given, say<"The output '%1' is named twice; give each output its own name.">(given));
  std::error_code problem;
  const auto status = fs::status(target, problem);
  if (status.type() == fs::file_type::none)
    return notWritable(given, verbatim(problem.message()));  // a name too long, a folder nobody may look into
  const bool existed = fs::exists(fs::symlink_status(target, problem));
  if (late_ == LateFile::refuse && existed && cameMeanwhile(given)) return isSomebodyElses(given);
  if (fs::is_directory(status)) return notWritable(given, say<"it is a folder">());
  if (fs::exists(status) && !fs::is_regular_file(status))  // renaming over a device would replace the device
    return notWritable(given, say<"it is not a regular file">());
  if (fs::exists(status) && ::access(target.c_str(), W_OK) != 0) return notWritable(given, errno);
  const fs::path folder = folderOf(target);
  if (!fs::is_directory(folder, problem)) return notWritable(given, say<"its folder '%1' does not exist">(folder));
  const auto aside = asideOf(folder, given);
  if (!aside) return passOn(aside.error());
  outputs_.push_back({.given = given,
                      .target = target,
                      .staged = *aside / target.filename(),
                      .earlier = {},
                      .existedBefore = existed,
                      .namesSamples = endingOf(target) == ".mhd"});
  return {};
}

Result<void> OutputSet::announce(const fs::path& file, std::string_view endings) {
  if (file.empty()) return failure(ErrorCode::badUsage, say<"The name of an output is empty; give a file name.">());
  const std::string ending = endingOf(file);
  if (!endings.empty() && (ending.empty() || (" " + std::string(endings) + " ").find(" " + ending + " ") == std::string::npos)) {
    const auto last = endings.rfind(' ');
    std::string first(endings.substr(0, last));
    if (last == std::string_view::npos) return wrongUsage(file, say<"The output '%1' must end in %2.">(file, std::move(first)));
    for (auto at = first.find(' '); at != std::string::npos; at = first.find(' ', at + 2)) first.replace(at, 1, ", ");
    return wrongUsage(file, say<"The output '%1' must end in %2 or %3.">(file, std::move(first), std::string(endings.substr(last + 1))));
  }
  if (!file.has_filename()) return notWritable(file, say<"it names no file">());
  const auto given = filesNamedBy(file), targets = filesNamedBy(behindLinks(file));
  if (given.size() != targets.size())
    return wrongUsage(file,
                      say<"The output '%1' is a link to '%2', a file of another kind; name that file instead.">(file, targets.back()));
  const std::size_t before = outputs_.size();
  for (std::size_t n = 0; n < given.size(); ++n)
    if (auto announced = announceOne(given[n], targets[n]); !announced) {
      outputs_.resize(before);
      return announced;
    }
  return {};
}

Result<void> OutputSet::announceFolder(const fs::path& folder) {
  std::error_code problem;
  std::vector<fs::path> missing;
  for (fs::path at = folder; !at.empty() && !fs::exists(fs::symlink_status(at, problem)); at = at.parent_path()) missing.push_back(at);
  for (auto made = missing.rbegin(); made != missing.rend(); ++made) {
    if (fs::create_directory(*made, problem)) madeFolders_.push_back(*made);
    if (problem) return notWritable(folder, verbatim(problem.message()));
  }
  if (!fs::is_directory(folder, problem)) return notWritable(folder, say<"it is not a folder">());
  Listed seen{.folder = folder, .names = {}};
  for (fs::directory_iterator at(folder, problem), end; !problem && at != end; at.increment(problem))
    seen.names.insert(at->path().filename());
  if (problem) return notWritable(folder, verbatim(problem.message()));
  const auto aside = asideOf(folder, folder);
  if (!aside) return passOn(aside.error());
  listed_.push_back(std::move(seen));
  return {};
}

Result<void> OutputSet::announceNewFolder(const fs::path& folder) {
  const fs::path named = folder.has_filename() ? folder : folder.parent_path();
  const fs::path target = behindLinks(named);
  std::error_code problem;
  for (const auto& output : outputs_)
    if (sameFile(target, output.target))
      return wrongUsage(folder, say<"The output '%1' is named twice; give each output its own name.">(folder));
  const bool existed = fs::exists(target, problem);
  if (existed && !(fs::is_directory(target, problem) && fs::is_empty(target, problem)))
    return notWritable(folder, say<"there is something of that name">());
  const auto aside = asideOf(folderOf(target), folder);
  if (!aside) return passOn(aside.error());
  const fs::path staged = *aside / target.filename();
  if (!fs::create_directory(staged, problem))
    return notWritable(folder, problem ? verbatim(problem.message()) : say<"no free name beside it">());
  outputs_.push_back({.given = folder,
                      .target = target,
                      .staged = staged,
                      .earlier = {},
                      .existedBefore = existed,
                      .namesSamples = false,
                      .isFolder = true});
  return {};
}

fs::path OutputSet::staged(const fs::path& file) const {
  const auto found = std::find_if(outputs_.begin(), outputs_.end(), [&](const Output& output) { return output.given == file; });
  EW_EXPECTS(found != outputs_.end());
  return found == outputs_.end() ? fs::path() : found->staged;
}

std::vector<fs::path> OutputSet::existing() const {
  std::vector<fs::path> files;
  for (const auto& output : outputs_)
    if (output.existedBefore) files.push_back(output.given);
  return files;
}

std::string OutputSet::inGivenNames(std::string text) const {
  for (const auto& output : outputs_) {
    const std::string staged = output.staged.string(), given = output.given.string();
    for (auto at = text.find(staged); at != std::string::npos; at = text.find(staged, at + given.size()))
      text.replace(at, staged.size(), given);
  }
  return text;
}

Error OutputSet::inGivenNames(Error error) const {
  error.message = error.message.withVerbatim([this](std::string text) { return inGivenNames(std::move(text)); });
  for (auto& [name, value] : error.context) value = inGivenNames(std::move(value));
  return error;
}

Result<void> OutputSet::keepEarlier(Output& output) {
  std::error_code problem;
  if (output.isFolder || !fs::exists(fs::symlink_status(output.target, problem))) return {};
  fs::path kept = output.staged;
  kept += kEarlier;
  for (int n = 0; kept.filename().string().size() > 255 || fs::exists(kept, problem); ++n)
    kept.replace_filename(std::to_string(n) + std::string(kEarlier));
  fs::create_hard_link(output.target, kept, problem);
  if (problem) {
    problem.clear();
    fs::copy_file(output.target, kept, problem);  // file systems without hard links: slower, the same
  }
  if (problem) return notWritable(output.given, verbatim(problem.message()));
  output.earlier = kept;
  return {};
}

Result<void> OutputSet::putInPlace(Output& output) {
  int number = 0;
  if (output.isFolder || output.existedBefore || late_ == LateFile::replace)
    number = ::rename(output.staged.c_str(), output.target.c_str()) == 0 ? 0 : errno;
  else
    number = renameToFreeName(output.staged, output.target);
  // A folder takes the place of an empty one alone: it is full now.
  const bool isFull = output.isFolder && (number == ENOTEMPTY || number == EEXIST);
  if (isFull)
    return failure(ErrorCode::notWritable, say<"Another program has just made the folder \"%1\"; choose another name.">(output.given),
                   {{"file", output.given.string()}});
  if (number == EEXIST) return isSomebodyElses(output.given);
  if (number != 0) return notWritable(output.given, number);
  output.inPlace = true;
  return {};
}

bool OutputSet::takeBack() {
  bool whole = true;
  for (auto& output : outputs_) {
    std::error_code problem;
    if (!output.earlier.empty())
      fs::rename(output.earlier, output.target, problem);
    else if (output.inPlace && !output.isFolder)
      fs::remove(output.target, problem);
    else if (output.inPlace)
      fs::rename(output.target, output.staged, problem);
    if (!problem && output.inPlace && output.isFolder && output.existedBefore) fs::create_directory(output.target, problem);
    if (problem)
      whole = false;
    else
      output.earlier.clear();
    output.inPlace = false;
  }
  return whole;
}

Result<void> OutputSet::commit(const std::function<Result<void>()>& last) {
  std::error_code problem;
  std::vector<Output*> written;
  for (auto& output : outputs_)
    if (fs::exists(output.staged, problem)) written.push_back(&output);
  for (Output* output : written) {
    if (!syncAll(output->staged)) return notWritable(output->given, errno);
    if (const auto before = fs::status(output->target, problem); output->existedBefore && fs::is_regular_file(before))
      fs::permissions(output->staged, before.permissions(), problem);
  }
  auto all = [&]() -> Result<void> {
    if (written.size() > 1 || last)  // one alone needs no way back
      for (Output* output : written)
        if (output->existedBefore || late_ == LateFile::replace)
          if (auto kept = keepEarlier(*output); !kept) return kept;
    // Between two renamings an old header would describe new samples: for that moment there is none.
    for (Output* output : written)
      if (output->namesSamples && !output->earlier.empty()) fs::remove(output->target, problem);
    for (Output* output : written)
      if (auto put = putInPlace(*output); !put) return put;
    return last ? last() : Result<void>();
  }();
  if (!all) {
    if (takeBack()) return all;
    const std::string aside = asides_.front().path.string();
    asides_.clear();  // they hold what could not be put back
    Error error = all.error();
    error.message = joined({std::move(error.message), say<"What was there before could not be put back and lies in '%1'.">(aside)});
    return passOn(std::move(error));
  }
  // The renamings must survive a power cut; where a folder cannot be synced the files are complete all the same.
  for (const auto& aside : asides_) syncPath(aside.folder, O_RDONLY | O_DIRECTORY);
  clear();
  return {};
}

void removeLeftovers(const fs::path& folder) {
  std::error_code problem;
  std::vector<fs::path> left;
  for (fs::directory_iterator at(folder, problem), end; !problem && at != end; at.increment(problem))
    if (isLeftover(at->path())) left.push_back(at->path());
  for (const auto& path : left) fs::remove_all(path, problem);
}

}  // namespace ew
