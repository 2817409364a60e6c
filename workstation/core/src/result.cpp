#include "ew/core/result.h"

#include <ostream>

namespace ew {

const char* nameOf(ErrorCode code) {
  switch (code) {
    case ErrorCode::notFound:
      return "not found";
    case ErrorCode::notReadable:
      return "not readable";
    case ErrorCode::notWritable:
      return "not writable";
    case ErrorCode::truncated:
      return "truncated";
    case ErrorCode::tooLarge:
      return "too large";
    case ErrorCode::badHeader:
      return "bad header";
    case ErrorCode::badField:
      return "bad field";
    case ErrorCode::unsupported:
      return "unsupported";
    case ErrorCode::newerFormat:
      return "newer format";
    case ErrorCode::noValidPose:
      return "no valid pose";
    case ErrorCode::missingCalibration:
      return "missing calibration";
    case ErrorCode::emptyVolume:
      return "empty volume";
    case ErrorCode::notRigid:
      return "not rigid";
    case ErrorCode::abiMismatch:
      return "ABI mismatch";
    case ErrorCode::badUsage:
      return "bad usage";
    case ErrorCode::cancelled:
      return "cancelled";
    case ErrorCode::internal:
      return "internal";
  }
  return "unknown";
}

std::ostream& operator<<(std::ostream& out, const Error& error) {
  out << nameOf(error.code) << ": " << error.message;
  for (const auto& [name, value] : error.context) out << " [" << name << ": " << value << "]";
  return out;
}

tl::unexpected<Error> failure(ErrorCode code, Message message, std::vector<std::pair<std::string, std::string>> context) {
  return tl::unexpected<Error>(Error{code, std::move(message), std::move(context)});
}

tl::unexpected<Error> passOn(Error error) { return tl::unexpected<Error>(std::move(error)); }

}  // namespace ew
