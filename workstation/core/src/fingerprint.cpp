#include "ew/core/fingerprint.h"

namespace ew {

Fingerprint fingerprintOf(std::string_view content) {
  // FNV-1a of 64 bits: http://www.isthe.com/chongo/tech/comp/fnv
  std::uint64_t hash = 14695981039346656037ull;
  for (const char one : content) hash = (hash ^ static_cast<unsigned char>(one)) * 1099511628211ull;
  return {content.size(), hash};
}

}  // namespace ew
