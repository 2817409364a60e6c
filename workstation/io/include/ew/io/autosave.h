#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ew/core/result.h"
#include "ew/io/file_lock.h"

namespace ew {

/// Work that is not saved yet, kept where a crash or a kill does not take it, while it grows. Every program that keeps something has a
/// folder of its own below `root` (0700, its files 0600) and a lock on it for as long as it lives: what lies in a folder that nobody holds
/// was left behind by one that ended without being asked. A thread writes, one thing after another; whoever hands something over does not
/// wait. A program that ends in order leaves nothing.
class Autosave {
 public:
  /// What a program left behind. As long as this object lives nobody else is offered it; when it goes undecided, the next start is.
  class Left {
   public:
    Left(Left&& other) noexcept;
    Left& operator=(Left&& other) noexcept;
    Left(const Left&) = delete;
    Left& operator=(const Left&) = delete;
    ~Left();

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    /// As describe() had it last.
    [[nodiscard]] const nlohmann::json& about() const { return about_; }
    /// When something was written last.
    [[nodiscard]] std::chrono::system_clock::time_point at() const { return at_; }
    [[nodiscard]] bool has(const std::string& item) const;
    [[nodiscard]] std::filesystem::path fileOf(const std::string& item) const { return folder_ / item; }
    /// All that was kept, by name.
    [[nodiscard]] std::vector<std::string> items() const;
    /// Somebody decided: it goes.
    void discard();
    /// It is offered to whoever asks next.
    void release();

   private:
    friend class Autosave;
    Left(std::filesystem::path folder, FileLock lock, nlohmann::json about, std::chrono::system_clock::time_point at)
        : folder_(std::move(folder)), lock_(std::move(lock)), about_(std::move(about)), at_(at) {}

    std::filesystem::path folder_;
    std::optional<FileLock> lock_;
    nlohmann::json about_;
    std::chrono::system_clock::time_point at_;
  };

  struct Limits {
    std::uint64_t most_bytes = std::uint64_t{4} << 30;          ///< of one program
    std::uint64_t least_free_bytes = std::uint64_t{256} << 20;  ///< that stay free on the medium
    std::uint64_t most_held_bytes = std::uint64_t{64} << 20;    ///< of an item, in memory, while they cannot be added to it
  };

  /// @param root need not be there yet; nothing is made before something is kept
  /// @param onProblem called on the writing thread when something cannot be kept, once until something can again
  explicit Autosave(std::filesystem::path root, std::function<void(const Error&)> onProblem, Limits limits);
  explicit Autosave(std::filesystem::path root, std::function<void(const Error&)> onProblem = {});
  ~Autosave();  ///< forgets; what others left and is not kept here whole is offered again
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /// Says of what and of whom everything is, for whoever offers it later. Without a word nothing is ever offered; one that could not be
  /// written is tried again before whatever is written next.
  void describe(nlohmann::json about);
  /// An item in place of what it was. @param item name of a file @param make called on the writing thread; its error means: not kept
  void replace(const std::string& item, std::function<Result<std::string>()> make);
  void replace(const std::string& item, std::string bytes);
  /// An item as a file that `write` makes. @param bytes about as many as it will have: asked before whether there is room
  void replaceFile(const std::string& item, std::uint64_t bytes, std::function<Result<void>(const std::filesystem::path&)> write);
  /// Adds to the end of an item; a crash in the middle leaves all that was added before. What cannot be added leaves the item as it was
  /// and waits until something can be written again; nothing that comes later goes before it. When too much waits (Limits), or a
  /// replacement could not be kept, the item stays as it is until it is replaced or removed.
  void append(const std::string& item, std::string bytes);
  void remove(const std::string& item);
  /// Everything goes, the folder as well, and what discardOnceKept() still waits with.
  void forget();
  /// Something left behind has been handed over here: it is discarded once the description and every item are on the medium as they were
  /// handed over last, synced. As long as one of them could not be written it stays.
  void discardOnceKept(std::shared_ptr<Left> left);
  /// Waits until all that was handed over before was written, or could not be.
  void flush();

  [[nodiscard]] const std::filesystem::path& root() const { return root_; }
  /// What others left behind, the latest first, and each to one asker alone. What has no readable description is not among them.
  [[nodiscard]] std::vector<Left> takeLeft() const;
  /// The same of one kind: those for which `isWanted` says so. The others stay for whoever wants them.
  [[nodiscard]] std::vector<Left> takeLeft(const std::function<bool(const nlohmann::json& about)>& isWanted) const;

 private:
  class Writer;
  std::filesystem::path root_;
  std::unique_ptr<Writer> writer_;
};

}  // namespace ew
