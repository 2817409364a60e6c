#include "ew/core/result.h"

#include <ostream>

#include "ew/core/word_table.h"

namespace ew {

constexpr WordTable<ErrorCode, 17> kErrorCodeWords{{{"not found", ErrorCode::notFound},
                                                    {"not readable", ErrorCode::notReadable},
                                                    {"not writable", ErrorCode::notWritable},
                                                    {"truncated", ErrorCode::truncated},
                                                    {"too large", ErrorCode::tooLarge},
                                                    {"bad header", ErrorCode::badHeader},
                                                    {"bad field", ErrorCode::badField},
                                                    {"unsupported", ErrorCode::unsupported},
                                                    {"newer format", ErrorCode::newerFormat},
                                                    {"no valid pose", ErrorCode::noValidPose},
                                                    {"missing calibration", ErrorCode::missingCalibration},
                                                    {"empty volume", ErrorCode::emptyVolume},
                                                    {"not rigid", ErrorCode::notRigid},
                                                    {"ABI mismatch", ErrorCode::abiMismatch},
                                                    {"bad usage", ErrorCode::badUsage},
                                                    {"cancelled", ErrorCode::cancelled},
                                                    {"internal", ErrorCode::internal}}};
const char* nameOf(ErrorCode code) { return wordIn(kErrorCodeWords, code); }

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
