#include "prepared_store.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <xxhash.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <thread>

#include "ew/core/json_fields.h"
#include "ew/core/numbers.h"
#include "ew/io/safe_file.h"
#include "ew/io/volume_file.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

std::string hashOf(const std::vector<std::uint8_t>& values) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(XXH3_64bits(values.data(), values.size())));
  return text.data();
}

/// Of where a volume lies: its header can be damaged as well as its samples.
std::string hashOf(const Grid& grid) {
  ContentHash hash;
  for (int axis = 0; axis < 3; ++axis) {
    hash.add(static_cast<double>(grid.dims[axis])).add(grid.spacing_mm[axis]).add(grid.origin_mm[axis]);
    for (int along = 0; along < 3; ++along) hash.add(grid.directions[axis][along]);
  }
  return hash.text();
}

bool hasVoxels(const Volume& volume) { return !volume.echo.empty(); }

}  // namespace

ContentHash& ContentHash::add(std::string_view text) {
  collected_ += std::to_string(text.size());
  collected_ += ':';
  collected_ += text;
  return *this;
}

ContentHash& ContentHash::add(double number) { return add(std::string_view(textOf(number))); }

ContentHash& ContentHash::add(std::uint64_t number) { return add(std::string_view(std::to_string(number))); }

std::string ContentHash::text() const {
  const XXH128_hash_t hash = XXH3_128bits(collected_.data(), collected_.size());
  std::array<char, 33> text{};
  std::snprintf(text.data(), text.size(), "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  return text.data();
}

bool PreparedStore::isThere() const {
  std::error_code ignored;
  return fs::exists(fileWithEnding(".json"), ignored);
}

Result<Prepared> PreparedStore::read(Progress& progress) const {
  auto text = readTextFile(fileWithEnding(".json"), 1u << 16);
  if (!text) return passOn(text.error());
  auto ready = parseJson(*text, name_ + ".json");
  if (!ready) return passOn(ready.error());
  const auto promised = [&](const char* field) {
    return ready->is_object() && ready->contains(field) && (*ready)[field].is_string() ? (*ready)[field].get<std::string>() : std::string();
  };
  // Results of programs that did not keep it yet say nothing about their place.
  const auto elsewhere = [&](const char* field, const Grid& grid) { return !promised(field).empty() && promised(field) != hashOf(grid); };
  const auto damaged = [&] {
    return failure(ErrorCode::badHeader, "A prepared volume in the cache was damaged; it is made again.",
                   {{"file", fileWithEnding(".json").string()}});
  };
  Prepared found;
  if (!promised("echo").empty()) {
    auto loaded = readVolume(fileWithEnding(".mha"), progress);
    if (!loaded) return passOn(loaded.error());
    found.volume = std::move(loaded->volume);
    if (auto read = readCoverageInto(found.volume, fileWithEnding(".coverage.mha"), progress); !read) return passOn(read.error());
    if (promised("echo") != hashOf(found.volume.echo) || promised("coverage") != hashOf(found.volume.coverage) ||
        elsewhere("grid", found.volume.grid))
      return damaged();
  }
  if (!promised("labels").empty()) {
    auto labels = readLabelVolume(fileWithEnding(".labels.mha"), progress);
    if (!labels) return passOn(labels.error());
    found.labels = std::move(labels->volume);
    if (promised("labels") != hashOf(found.labels.echo) || elsewhere("labels_grid", found.labels.grid)) return damaged();
  }
  if (!hasVoxels(found.volume) && !hasVoxels(found.labels)) return damaged();
  std::error_code ignored;
  fs::last_write_time(fileWithEnding(".json"), fs::file_time_type::clock::now(), ignored);  // used today: see removeOldResults
  return found;
}

Result<void> PreparedStore::write(const Prepared& made, Progress& progress) const {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error)
    return failure(ErrorCode::notWritable,
                   "The cache folder cannot be made (" + error.message() + "); set ECHOWEAVE_CACHE to a folder you may write to.",
                   {{"file", folder_.string()}});
  // Speckle hardly compresses, and an uncompressed file opens several times faster.
  const WriteOptions plain{.compress = false};
  PartOfProgress first(progress, 0.0, 0.33);
  PartOfProgress second(progress, 0.33, 0.67);
  PartOfProgress third(progress, 0.67, 1.0);
  nlohmann::json ready = nlohmann::json::object();
  if (hasVoxels(made.volume)) {
    if (auto written = writeVolume(made.volume, fileWithEnding(".mha"), first, plain); !written) return written;
    if (auto written = writeCoverage(made.volume, fileWithEnding(".coverage.mha"), second, plain); !written) return written;
    ready["echo"] = hashOf(made.volume.echo);
    ready["coverage"] = hashOf(made.volume.coverage);
    ready["grid"] = hashOf(made.volume.grid);
  }
  if (hasVoxels(made.labels)) {
    if (auto written = writeVolume(made.labels, fileWithEnding(".labels.mha"), third, plain); !written) return written;
    ready["labels"] = hashOf(made.labels.echo);
    ready["labels_grid"] = hashOf(made.labels.grid);
  }
  return writeFileSafely(fileWithEnding(".json"), ready.dump(2) + "\n");
}

Result<PreparationLock> PreparationLock::take(const fs::path& file, Progress& progress) {
  std::error_code ignored;
  fs::create_directories(file.parent_path(), ignored);
  PreparationLock lock(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
  if (lock.descriptor_ < 0) return lock;
  while (::flock(lock.descriptor_, LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR) return lock;
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, "Preparing the case was stopped.");
    progress.report("Waiting for another EchoWeave that prepares the same case", 0.0);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return lock;
}

PreparationLock::~PreparationLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace ew
