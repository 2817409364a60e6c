#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/library/checksums.h"
#include "ew/library/published.h"

namespace ew {

// A bundle (.ewcase) carries a case to another workstation: a tar (pax, regular files alone) compressed as one zstd stream. Its first entry
// is bundle.json, {"format": 1, "kind": "case", "id", "title", "revision", "program", "files": [{"path", "size", "sha256"}]}; the files
// follow in the order of that list. It is read as what a stranger sent: nothing is believed that was not checked, and nothing is put in
// place before everything was.

inline constexpr int kBundleFormat = 1;
inline constexpr const char* kBundleEnding = ".ewcase";

struct BundleHeader {
  std::string id;
  std::string title;
  int revision = 0;  ///< as it was published where it comes from; 0: an author's case that was not
  std::string program;
  std::vector<FileSum> files;
  bool operator==(const BundleHeader&) const = default;
};

/// What a bundle may take.
struct BundleLimits : CaseFileLimits {
  /// How many times larger than the bundle its files may be, beyond `freeExpansion_bytes`: recorded and made volumes stay below 100.
  double maxExpansion = 1000.0;
  std::uint64_t freeExpansion_bytes = 64ull << 20;
};

/// Writes a case into a bundle: every file that belongs to it (filesOfCase). The same case gives the same bytes: files are sorted, times
/// and owners are not kept.
/// @param file ends in .ewcase; replaced, if it is there, when the new one is complete
/// @return what stands in bundle.json
/// @error as loadCase and sumsOfCase; badField (a published revision that is not as its sums say), badUsage (ending;
///        holdsExamination(file)), notWritable, cancelled (within 0.5 s)
[[nodiscard]] Result<BundleHeader> exportBundle(const std::filesystem::path& caseFolder, const std::filesystem::path& file,
                                                Progress& progress = noProgress());

/// What a bundle says about itself; of its files the list alone, checked as a list.
/// @error notFound, notReadable, badHeader (no bundle, damaged), truncated, newerFormat, unsupported (not a case), badField (a path that is
///        refused), tooLarge
[[nodiscard]] Result<BundleHeader> readBundleHeader(const std::filesystem::path& file, const BundleLimits& limits = {});

/// Whether there is a bundle of an examination of that name: attempts at it are judged with this file alone, so nothing replaces it.
[[nodiscard]] bool holdsExamination(const std::filesystem::path& file);

/// Reads the whole bundle and checks it as importBundle does, without writing anything.
/// @error as importBundle, but for what writing needs
[[nodiscard]] Result<BundleHeader> verifyBundle(const std::filesystem::path& file, const BundleLimits& limits = {},
                                                Progress& progress = noProgress());

/// Takes a bundle into a library as published/ID/REVISION; as the revision after the highest when another content has that number or the
/// bundle has none. Refused are files with absolute paths or upward ones, links, devices, folders, names twice, files that are not listed
/// or do not come, sizes and sums that are not as listed, more than `limits` allow, and a case that this program cannot open.
/// @return the revision; wasThere when the library has this very content already, and nothing was done
/// @error as readBundleHeader and loadCase; truncated, badField (also: a file is not as listed), unsupported, tooLarge, notWritable (also:
///        no room), cancelled (within 0.5 s); after any of them the library is as it was
[[nodiscard]] Result<CaseRevision> importBundle(const std::filesystem::path& file, const std::filesystem::path& library,
                                                const BundleLimits& limits = {}, Progress& progress = noProgress());

}  // namespace ew
