#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/result.h"

namespace ew {

/// The files a name stands for: X.mhd is a header and its samples in X.raw, every other name is itself. The samples come first.
[[nodiscard]] std::vector<std::filesystem::path> filesNamedBy(const std::filesystem::path& file);

/// A file that somebody else puts at the name of an output while the output is being made.
enum class LateFile {
  refuse,  ///< commit fails and the file stays: nobody was asked about it
  replace  ///< commit replaces it, for files of the program's own such as caches, which two programs may write at once
};

/// The files that a piece of work reads and will write. Outputs are checked before the work starts, written aside, and put in place
/// together when everything is there; work that fails, is refused or is stopped leaves every folder as it was. Nothing that was not
/// announced is ever written, replaced or removed.
///
///     OutputSet outputs;
///     if (auto kept = outputs.protect(input); !kept) return ...            // every file that is read, before or after announcing
///     if (auto announced = outputs.announce("liver.mhd", ".mha .mhd"); ... // liver.raw with it
///     if (!outputs.existing().empty()) ...                                 // a window asks about these
///     writeVolume(volume, outputs.staged("liver.mhd"), progress);          // as often as there are outputs
///     return outputs.commit();                                             // or leave without it: nothing happened
///
/// Aside is a hidden folder beside each output (".ew-PID-N-MACHINE"), in which an output has the name it will have: a header can name its
/// samples, names may be as long as the file system allows, and putting in place is a renaming. After the program was killed this folder is
/// all that stays, until the next program that writes there takes it away (removeLeftovers). Not for several threads at once.
class OutputSet {
 public:
  explicit OutputSet(LateFile late = LateFile::refuse) : late_(late) {}
  ~OutputSet();
  OutputSet(OutputSet&& other) noexcept = default;
  OutputSet& operator=(OutputSet&&) = delete;

  /// A file that is read: no output may be written over it, nor over the samples that X.mhd stands for.
  /// @error badUsage (it is announced as an output)
  [[nodiscard]] Result<void> protect(const std::filesystem::path& input);

  /// Announces a file and, of X.mhd, X.raw with it. A symbolic link is followed: what it points to is replaced, the link stays.
  /// @param endings the ones the writer knows, separated by blanks (".mha .mhd"); empty: any
  /// @error notWritable (no such folder, a folder or a device of that name, no permission: found by trying; somebody else's since
  /// announceFolder), badUsage (ending, an input, twice the same)
  [[nodiscard]] Result<void> announce(const std::filesystem::path& file, std::string_view endings = {});

  /// Makes a folder for outputs when it is not there, with those above it. When nothing was put into it, it is gone again in the end. What
  /// comes to lie in it from now on is somebody else's: an output announced later under such a name is refused.
  /// @error notWritable
  [[nodiscard]] Result<void> announceFolder(const std::filesystem::path& folder);

  /// Announces a folder that is made aside as a whole, staged(folder) being there at once, and takes the place of nothing or of an empty
  /// folder; the folder it will stand in is there.
  /// @error notWritable (there is something of that name), badUsage (named twice)
  [[nodiscard]] Result<void> announceNewFolder(const std::filesystem::path& folder);

  /// Where to write an announced file now: the same name in a folder aside. A writer may leave it out; then nothing is put in place.
  [[nodiscard]] std::filesystem::path staged(const std::filesystem::path& file) const;

  /// What was announced and was there before: commit will replace these files. By the names they were announced with.
  [[nodiscard]] std::vector<std::filesystem::path> existing() const;

  /// The same text with every staged file called by the name it was given: what a writer says is for the user.
  [[nodiscard]] std::string inGivenNames(std::string text) const;
  [[nodiscard]] Error inGivenNames(Error error) const;

  /// Puts everything written so far in place, on the medium first, all or nothing: when one file cannot be put in place those before it are
  /// taken back. A file that is replaced keeps its permissions. Afterwards the set is empty but for its inputs.
  /// @param last what belongs to it and is done by somebody else, when everything is in place; its failure takes everything back
  /// @error notWritable; of `last`
  [[nodiscard]] Result<void> commit(const std::function<Result<void>()>& last = {});

 private:
  struct Output {
    std::filesystem::path given;    // as announced
    std::filesystem::path target;   // what a symbolic link points to
    std::filesystem::path staged;   // where it is written now
    std::filesystem::path earlier;  // while committing: what the target was before
    bool existedBefore = false;
    bool namesSamples = false;  // a header: of no use, or wrong, with other samples
    bool isFolder = false;
    bool inPlace = false;
  };
  struct Listed {
    std::filesystem::path folder;
    std::set<std::filesystem::path> names;  // that were there when it was announced
  };
  struct Aside {
    std::filesystem::path folder;
    std::filesystem::path path;
  };
  [[nodiscard]] Result<std::filesystem::path> asideOf(const std::filesystem::path& folder, const std::filesystem::path& wanted);
  [[nodiscard]] bool cameMeanwhile(const std::filesystem::path& file) const;
  [[nodiscard]] Result<void> announceOne(const std::filesystem::path& given, const std::filesystem::path& target);
  [[nodiscard]] Result<void> keepEarlier(Output& output);
  [[nodiscard]] Result<void> putInPlace(Output& output);
  [[nodiscard]] bool takeBack();
  void clear();

  LateFile late_;
  std::vector<Output> outputs_;
  std::vector<std::filesystem::path> inputs_;
  std::vector<Aside> asides_;
  std::vector<std::filesystem::path> madeFolders_;
  std::vector<Listed> listed_;
};

/// Removes what killed programs left aside in a folder. What a program that still runs has aside is left; what another machine or container
/// has aside, in a folder that they share, is left for two days; what holds the only copy of a file that was about to be replaced stays.
void removeLeftovers(const std::filesystem::path& folder);

}  // namespace ew
