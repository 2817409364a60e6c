#pragma once

#include <cstddef>  // defines _GLIBCXX_USE_CXX11_ABI
#include <cstdint>

namespace ew::sdk {

/// Changes with the headers of sdk/ and core/. The door compares the full number below before it calls anything else.
inline constexpr std::uint32_t kInterfaceVersion = 7;

/// Interface version, compiler generation and standard library ABI folded into one number: what must agree for C++ values to cross.
inline constexpr std::uint32_t kAbi = (kInterfaceVersion << 16) | (static_cast<std::uint32_t>(__GNUC__) << 8) |
                                      (static_cast<std::uint32_t>(_GLIBCXX_USE_CXX11_ABI) << 4) | 0x1u;

}  // namespace ew::sdk
