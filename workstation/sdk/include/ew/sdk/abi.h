#pragma once

#include <cstddef>  // defines _GLIBCXX_USE_CXX11_ABI
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <tl/expected.hpp>

#include "ew/sdk/abi_number.h"  // kAbi, made when EchoWeave is configured

// The door compares kAbi before it calls anything else, so a plugin that carries the number must be built as the program is: with another
// compiler or another version of these libraries it does not compile.
#ifndef __clang_analyzer__  // clang-tidy, which says it is GCC 4, builds nothing
static_assert(__GNUC__ == EW_ABI_COMPILER, "EchoWeave was built by another generation of the compiler; build the plugin by the same one");
#endif
static_assert(_GLIBCXX_USE_CXX11_ABI == EW_ABI_CXX11, "EchoWeave was built with the other ABI of std::string; set _GLIBCXX_USE_CXX11_ABI");
static_assert(GLM_VERSION == EW_ABI_GLM, "EchoWeave was built with another version of GLM; its vectors cross the door");
static_assert(TL_EXPECTED_VERSION_MAJOR == EW_ABI_EXPECTED,
              "EchoWeave was built with another version of tl::expected; it crosses the door");
static_assert(NLOHMANN_JSON_VERSION_MAJOR * 100 + NLOHMANN_JSON_VERSION_MINOR == EW_ABI_JSON,
              "EchoWeave was built with another version of the JSON library; its values cross the door");
