#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/result.h"

namespace ew::cli {

/// The files a command will write: checked before the work starts, written aside, and put in place together when everything is there.
/// What was not put in place is removed, so a failed or cancelled command leaves what it found.
class Outputs {
 public:
  Outputs() = default;
  ~Outputs();
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;

  /// Files the command reads; none of them may be written over.
  void protect(const std::filesystem::path& input);

  /// Announces a file. `endings` are the ones the writer knows, separated by blanks (".mha .mhd"); empty: any.
  /// @error notWritable (no such folder, a folder of that name, no permission: found by trying), badUsage (ending, an input, twice the
  /// same)
  [[nodiscard]] Result<void> announce(const std::filesystem::path& file, std::string_view endings = {});

  /// Announces a folder, which is made when it is not there.
  /// @error notWritable
  [[nodiscard]] Result<void> announceFolder(const std::filesystem::path& folder);

  /// Where to write an announced file now: a neighbour of the same ending. A .mhd is written in place because its header names its
  /// pixels' file.
  [[nodiscard]] std::filesystem::path staged(const std::filesystem::path& file) const;

  /// The same text with every staged file called by the name it was given: what a writer says is for the user.
  [[nodiscard]] std::string inGivenNames(std::string text) const;

  /// Puts every staged file in place.
  /// @error notWritable
  [[nodiscard]] Result<void> commit();

 private:
  struct Entry {
    std::filesystem::path given;   // as on the command line
    std::filesystem::path target;  // what a symbolic link points to
    std::filesystem::path staged;
    bool existedBefore = false;
  };
  std::vector<Entry> entries_;
  std::vector<std::filesystem::path> inputs_;
  std::vector<std::filesystem::path> madeFolders_;
  bool committed_ = false;
};

}  // namespace ew::cli
