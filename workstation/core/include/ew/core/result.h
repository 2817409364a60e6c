#pragma once

#include <iosfwd>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "ew/core/message.h"

namespace ew {

/// What went wrong, for code that must decide; the sentence is for the person.
enum class ErrorCode {
  notFound,
  notReadable,
  notWritable,
  truncated,           ///< the file ends before its header says so
  tooLarge,            ///< a size that no memory or limit allows
  badHeader,           ///< not the format it claims to be
  badField,            ///< one field is missing or has a value that cannot be used
  unsupported,         ///< well formed, but a variant that is not read
  newerFormat,         ///< written by a newer version of the program
  noValidPose,         ///< a sweep without a single usable pose
  missingCalibration,  ///< no way from pixels to the asked frame
  emptyVolume,         ///< a volume without voxels or without any measured voxel
  notRigid,            ///< a pose that is not a rotation and a translation
  abiMismatch,         ///< a plugin built for another program
  badUsage,            ///< the words of a command do not fit together
  cancelled,           ///< the user asked to stop
  internal             ///< a library failed in a way the program did not foresee
};

const char* nameOf(ErrorCode code);

/// A failure of the outside world: what is wrong and what to do, in one sentence a user can act on, plus what was being done.
struct Error {
  ErrorCode code = ErrorCode::internal;
  Message message;                                           ///< a sentence that ends with a full stop
  std::vector<std::pair<std::string, std::string>> context;  ///< for logs and reports: ("file", "a.mha"), ("field", "DimSize") ...

  /// In English, as commands and logs write it; the window has its own words for the message.
  [[nodiscard]] std::string sentence() const { return message.english(); }
  bool operator==(const Error&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Error& error);

template <class T>
using Result = tl::expected<T, Error>;

/// `return failure(ErrorCode::notFound, say<"%1 is not there; …">(quoted(path)), {{"file", path}});`
[[nodiscard]] tl::unexpected<Error> failure(ErrorCode code, Message message, std::vector<std::pair<std::string, std::string>> context = {});

/// Passes an error of a called function on: `if (!opened) return passOn(opened.error());`
[[nodiscard]] tl::unexpected<Error> passOn(Error error);

}  // namespace ew
