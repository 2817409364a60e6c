#include "logic/content_key.h"

#include <bit>
#include <cstdio>
#include <cstring>

namespace ew::stitching {
namespace {

/// The finaliser of splitmix64 (public domain): each bit in changes half the bits out.
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

}  // namespace

ContentKey& ContentKey::add(std::uint64_t number) {
  a_ = mixed(a_ ^ number);
  b_ = mixed(std::rotl(b_, 23) + number * 0x9fb21c651e98df25u);
  return *this;
}

ContentKey& ContentKey::add(std::span<const std::uint8_t> bytes) {
  std::size_t at = 0;
  for (; at + 8 <= bytes.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, 8);
    add(word);
  }
  std::uint64_t rest = 0;
  for (int shift = 0; at < bytes.size(); ++at, shift += 8) rest |= static_cast<std::uint64_t>(bytes[at]) << shift;
  return add(rest).add(static_cast<std::uint64_t>(bytes.size()));
}

ContentKey& ContentKey::add(std::string_view text) {
  return add(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

ContentKey& ContentKey::add(double number) { return add(std::bit_cast<std::uint64_t>(number)); }

ContentKey& ContentKey::add(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) add(matrix[column][row]);
  return *this;
}

std::string ContentKey::text() const {
  char digits[33] = {};
  std::snprintf(digits, sizeof digits, "%016llx%016llx", static_cast<unsigned long long>(a_), static_cast<unsigned long long>(b_));
  return digits;
}

}  // namespace ew::stitching
