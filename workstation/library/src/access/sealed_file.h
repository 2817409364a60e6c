#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "ew/core/result.h"
#include "ew/library/instructor_key.h"
#include "files/file_pieces.h"

namespace ew {

// answers.sealed: "EWSEALED", its format (4 bytes, the lowest first), the length of its header (likewise), the header, JSON: {"case",
// "view", "slots": [{"for", "box"}]}; then a stream (libsodium's crypto_secretstream, XChaCha20-Poly1305) in pieces of 64 KiB. The
// stream's key lies in each slot, for one instructor each (crypto_box_seal). All that stands before the stream goes into the sum of each
// of its pieces, and the last piece says that it is the last: nothing can be exchanged, moved, cut off or put behind.

/// Writes the file. @param write gives the content, piece by piece
/// @error notWritable, of `write`
[[nodiscard]] Result<void> sealFile(const std::filesystem::path& file, const std::string& caseId, const std::string& view,
                                    const std::vector<PublicKey>& instructors, const std::function<Result<void>(const TakePiece&)>& write);

/// What the file says without a key.
struct SealHeader {
  std::string caseId;  ///< of the examination
  std::string view;    ///< SHA-256 over everything that trainees may read, so that neither goes with another revision's other half
  std::vector<std::string> forWhom;  ///< short names of the keys that open it
  bool operator==(const SealHeader&) const = default;
};
/// @error notFound, notReadable, badHeader, badField, newerFormat
[[nodiscard]] Result<SealHeader> readSealedFileHeader(const std::filesystem::path& file);

/// Reads the file to its end. What `take` gets has been checked piece by piece, and that nothing is missing only when this returns.
/// @error as readSealedFileHeader; badUsage (another's key), badField (changed), cancelled, of `take`
[[nodiscard]] Result<void> openSealedFile(const std::filesystem::path& file, const SecretKey& key, ByteCount& count, const TakePiece& take);

}  // namespace ew
