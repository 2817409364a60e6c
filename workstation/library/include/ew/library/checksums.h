#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew {

class JsonFields;

/// SHA-256 (FIPS 180-4, by OpenSSL) of bytes that come in pieces.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;
  void add(std::span<const std::byte> bytes);
  /// 64 hexadecimal digits in small letters, of everything that was added; nothing can be added afterwards.
  [[nodiscard]] std::string hex();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

/// @error notFound, notReadable, cancelled
[[nodiscard]] Result<std::string> sha256Of(const std::filesystem::path& file, Progress& progress = noProgress());

/// A file of a case, as the lists in sums.json and in bundles have it.
struct FileSum {
  std::string path;  ///< relative to the case folder, parts separated by '/'
  std::uint64_t size_bytes = 0;
  std::string sha256;  ///< 64 hexadecimal digits
  bool operator==(const FileSum&) const = default;
};

/// What a list of files may ask of whoever reads it.
struct CaseFileLimits {
  std::uint64_t maxBytes = 64ull << 30;  ///< of all files
  std::size_t maxFiles = 100'000;
  std::size_t maxPath_bytes = 240;  ///< of a path in the list, so that a folder of usual depth can hold it on any machine
};

inline constexpr const char* kSumsName = "sums.json";

/// What belongs to the case of a folder: every regular file below it, by path, sorted by its bytes. Hidden files and folders are left out
/// (drafts, leases, saves in progress), and so is the library's own sums.json. A link that leads to a file inside of the folder stands for
/// that file.
/// @error notFound, notReadable, unsupported (another link, a device, a pipe), badField (a name that other machines cannot have, see
///        checkFileList)
[[nodiscard]] Result<std::vector<FileSum>> filesOfCase(const std::filesystem::path& folder);  // sizes, no sums yet
/// The same with the sum of each. @error as filesOfCase, cancelled
[[nodiscard]] Result<std::vector<FileSum>> sumsOfCase(const std::filesystem::path& folder, Progress& progress = noProgress());

/// Why a path cannot stand in a list: it is absolute, leads upwards, is hidden, too long, not UTF-8, holds characters that other systems
/// do not know or is called like a file of the library. In words that complete "is refused (…)"; nothing when it can.
[[nodiscard]] std::optional<Message> problemOfPath(const std::string& path, const CaseFileLimits& limits = {});

/// Why a list cannot be a case's: problems of paths, two that are the same but for capitals, a file that is also a folder, too many or too
/// large files.
/// @param where the list stands in, at the beginning of a sentence: say<"The bundle '%1'">(file)
/// @error badField, tooLarge
[[nodiscard]] Result<void> checkFileList(const std::vector<FileSum>& files, const Message& where, const CaseFileLimits& limits = {});

/// "files" of a document: [{"path", "size", "sha256"}]; and back. Problems are left with the fields' reading.
[[nodiscard]] std::vector<FileSum> fileSumsIn(const JsonFields& document, const CaseFileLimits& limits = {});
[[nodiscard]] nlohmann::ordered_json jsonOf(const std::vector<FileSum>& files);

/// Writes sums.json: {"format": 1, "files": […]}. @error notWritable
[[nodiscard]] Result<void> writeSums(const std::vector<FileSum>& files, const std::filesystem::path& folder);
/// @error notFound, notReadable, badHeader, badField, newerFormat, tooLarge
[[nodiscard]] Result<std::vector<FileSum>> readSums(const std::filesystem::path& folder);

/// What verifying a case has found.
struct CaseCheck {
  bool hasSums = false;  ///< false: an author's own case, of which it is not known what it should hold
  std::size_t files = 0;
  std::uint64_t bytes = 0;
  std::vector<Error> problems;  ///< each names its file in the context "file"; empty: everything is as it should be
};

/// Reads every file of a case folder: with a sums.json, that none is missing, changed or more than there should be; volumes that are named
/// by their content (content_name.h), that they hold it; and that the case can be opened.
/// @error notFound, notReadable, cancelled; what is wrong with the case is no error of verifying it
[[nodiscard]] Result<CaseCheck> verifyCase(const std::filesystem::path& folder, Progress& progress = noProgress());

}  // namespace ew
