#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace ew {

/// A new folder below that of temporary files which only this user can read and write, under a name nobody can foresee: nothing planted
/// there beforehand is ever written to. Gone with everything in it when this object ends.
class PrivateFolder {
 public:
  /// Nothing when there is no room for temporary files.
  [[nodiscard]] static std::optional<PrivateFolder> make();
  /// Beside a file that is to be written instead: on the same medium, which has to have the room anyway.
  [[nodiscard]] static std::optional<PrivateFolder> makeBeside(const std::filesystem::path& file);
  ~PrivateFolder();
  PrivateFolder(PrivateFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}
  PrivateFolder& operator=(PrivateFolder&& other) noexcept {
    std::swap(path_, other.path_);
    return *this;
  }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  [[nodiscard]] static std::optional<PrivateFolder> makeNamed(std::string pattern);
  explicit PrivateFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

/// This user's own folder below that of temporary files, the same in every run: `NAME-UID`, of mode 700. Where something else has that name
/// (another user's folder, a link), a folder as above takes its place until the program ends.
[[nodiscard]] std::filesystem::path ownTemporaryFolder(const std::string& name);

}  // namespace ew
