#include "ew/core/guarded.h"

#include <algorithm>
#include <exception>
#include <new>

namespace ew {
namespace {

constexpr std::size_t kLongestReason_bytes = 300;

/// One line of bounded length, whatever somebody wrote into what(); not cut in the middle of a UTF-8 character.
Message oneLine(const char* said) {
  const auto none = [] { return say<"no reason was given">(); };
  if (said == nullptr) return none();
  std::string line(said);
  if (line.size() > kLongestReason_bytes) {
    std::size_t end = kLongestReason_bytes;
    while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xc0u) == 0x80u) --end;
    line.resize(end);
  }
  std::replace_if(
      line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20u; }, ' ');
  while (!line.empty() && (line.back() == ' ' || line.back() == '.')) line.pop_back();
  return line.empty() ? none() : verbatim(std::move(line));
}

}  // namespace

Thrown thrownNow() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return {true, say<"there is not enough memory">()};
  } catch (const std::exception& problem) {
    return {false, oneLine(problem.what())};
  } catch (...) {
    return {false, oneLine(nullptr)};
  }
}

}  // namespace ew
