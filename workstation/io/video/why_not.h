#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>

/// Puts a reason where the module's caller has room for it, cut to fit.
inline void tell(const char* reason, char* why, std::size_t room) {
  if (room == 0) return;
  const std::size_t length = std::min(std::strlen(reason), room - 1);
  std::memcpy(why, reason, length);
  why[length] = '\0';
}
