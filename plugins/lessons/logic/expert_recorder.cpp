#include "logic/expert_recorder.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <functional>

#include "ew/core/machine_mark.h"
#include "ew/io/safe_file.h"
#include "ew/library/checksums.h"

namespace ew::lessons {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kNameDigits = 16;  // of the SHA-256, as volumes of a case are called

constexpr std::string_view kAside = ".ew-new-";

/// A name that nobody else uses and that no list of a case's files has.
fs::path nameAside(const fs::path& folder, std::string_view ending) {
  static std::atomic<int> count = 0;
  return folder /
         (std::string(kAside) + std::to_string(::getpid()) + "-" + machineMark() + "-" + std::to_string(++count) + std::string(ending));
}

/// What programs that were killed have left aside goes; what another machine has aside in a folder that both share stays for two days.
void sweepOut(const fs::path& folder) {
  constexpr std::chrono::hours kLongestWork(48);
  std::error_code ignored;
  for (const auto& each : fs::directory_iterator(folder, ignored)) {
    const std::string name = each.path().filename().string();
    if (!name.starts_with(kAside)) continue;
    pid_t maker = 0;
    const auto read = std::from_chars(name.data() + kAside.size(), name.data() + name.size(), maker);
    if (read.ec != std::errc{} || maker <= 0 || maker == ::getpid()) continue;
    const bool isFromHere =
        std::string_view(read.ptr, static_cast<std::size_t>(name.data() + name.size() - read.ptr)).starts_with("-" + machineMark() + "-");
    const auto changed = fs::last_write_time(each.path(), ignored);
    const bool isOld = !ignored && fs::file_time_type::clock::now() - changed > kLongestWork;
    if (isFromHere ? !isProcessThere(maker) : isOld) fs::remove(each.path(), ignored);
  }
}

/// That a name is there has to reach the medium before a case names it.
void syncFolder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

Result<std::string> keepFile(const fs::path& partFolder, std::string_view folder, std::string_view ending,
                             const std::function<Result<void>(const fs::path&)>& write) {
  const fs::path into = partFolder / folder;
  std::error_code problem;
  fs::create_directories(into, problem);
  if (problem)
    return failure(ErrorCode::notWritable, say<"The folder '%1' cannot be made (%2); check its permissions.">(into, problem.message()),
                   {{"file", into.string()}});
  sweepOut(into);
  const fs::path aside = nameAside(into, ending);
  const auto written = write(aside);
  const auto sum = written ? sha256Of(aside) : Result<std::string>(tl::unexpected(written.error()));
  if (!sum) {
    fs::remove(aside, problem);
    return passOn(sum.error());
  }
  const std::string name = std::string(folder) + "/" + sum->substr(0, kNameDigits) + std::string(ending);
  fs::rename(aside, partFolder / name, problem);  // over a file of that name: it holds the same
  if (!problem) {
    syncFolder(into);
    return name;
  }
  const std::string why = problem.message();
  fs::remove(aside, problem);
  return failure(ErrorCode::notWritable, say<"'%1' cannot be written (%2); check its permissions.">(partFolder / name, why),
                 {{"file", (partFolder / name).string()}});
}

}  // namespace

void ExpertRecorder::start(std::string caseId, std::string title, double now_s) {
  discard();
  recording_.caseId = std::move(caseId);
  recording_.title = std::move(title);
  running_ = true;
  since_s_ = now_s;
}

void ExpertRecorder::pause(double now_s) {
  if (!running_ || !since_s_) return;
  before_s_ = length_s(now_s);
  since_s_.reset();
}

void ExpertRecorder::goOn(double now_s) {
  if (isPaused()) since_s_ = now_s;
}

void ExpertRecorder::see(const ScanEvent& event, const std::optional<ScanState>& image, glm::ivec2 size_px) {
  if (!running_ || isPaused() || event.time_s < *since_s_ || isFull(event.time_s)) return;
  if (std::holds_alternative<FrameMade>(event.what)) {
    if (!image) return;
    if (recording_.log.frameCount() == 0) recording_.size_px = size_px;
    ScanState mine = *image;
    mine.time_s = length_s(event.time_s);
    recording_.log.addFrame(mine);
  } else if (const auto* freeze = std::get_if<FreezeChanged>(&event.what); freeze != nullptr && recording_.log.frameCount() > 0) {
    recording_.log.setFrozen(length_s(event.time_s), freeze->isFrozen);
  }
}

double ExpertRecorder::length_s(double now_s) const { return before_s_ + (since_s_ ? std::max(0.0, now_s - *since_s_) : 0.0); }

void ExpertRecorder::mark(double now_s) {
  if (running_) marks_s_.push_back(length_s(now_s));
}

Result<ScanRecording> ExpertRecorder::stop(double now_s) {
  pause(now_s);
  if (recording_.log.frameCount() == 0) {
    discard();
    return failure(ErrorCode::badUsage, say<"Nothing was scanned while it was recorded; put the probe on the body and record again.">());
  }
  return recording_;
}

void ExpertRecorder::discard() {
  recording_ = {};
  running_ = false;
  since_s_.reset();
  before_s_ = 0.0;
  marks_s_.clear();
}

Result<std::string> keepRecording(const ScanRecording& recording, const fs::path& partFolder, Progress& progress) {
  return keepFile(partFolder, "scans", ".seq.mha", [&](const fs::path& to) { return writeRecording(recording, to, progress); });
}

Result<std::string> keepBytes(std::string_view bytes, const fs::path& partFolder, std::string_view folder, std::string_view ending) {
  return keepFile(partFolder, folder, ending, [&](const fs::path& to) { return writeFileSafely(to, bytes); });
}

}  // namespace ew::lessons
