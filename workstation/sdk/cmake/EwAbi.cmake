# ew_write_abi(HEADER): makes HEADER, which holds the ABI number of the SDK and what it was made from. Nobody raises the number by hand: it is a
# hash of every header that a plugin compiles against, followed from those of ew/sdk through their includes of ours, without comments and
# blanks, and of the libraries whose types cross the door. Its last eight bits are the compiler's generation, for people to read.

# All headers below `workstation` that those of ew/sdk include, directly or through others, themselves among them, each once.
function(ew_headers_of_the_door workstation result)
  file(GLOB ahead ${workstation}/sdk/include/ew/sdk/*.h)
  set(seen "")
  file(GLOB homes LIST_DIRECTORIES true ${workstation}/*/include)
  while(ahead)
    list(POP_FRONT ahead header)
    if(header IN_LIST seen)
      continue()
    endif()
    list(APPEND seen ${header})
    file(STRINGS ${header} includes REGEX "^#include \"ew/")
    foreach(line ${includes})
      string(REGEX REPLACE "^#include \"(ew/[^\"]*)\".*" "\\1" name "${line}")
      foreach(home ${homes})
        if(EXISTS ${home}/${name})
          list(APPEND ahead ${home}/${name})
        endif()
      endforeach()
    endforeach()
  endwhile()
  set(${result} ${seen} PARENT_SCOPE)
endfunction()

# `NAME` as a header defines it: what a plugin is compiled with must be the same.
function(ew_defined_in header name result)
  file(STRINGS ${header} line REGEX "^#define[ \t]+${name}[ \t]+[0-9]+" LIMIT_COUNT 1)
  string(REGEX REPLACE ".*${name}[ \t]+([0-9]+).*" "\\1" number "${line}")
  if(NOT number MATCHES "^[0-9]+$")
    message(FATAL_ERROR "${header} does not define ${name}, which the ABI number of the SDK is made from.")
  endif()
  set(${result} ${number} PARENT_SCOPE)
endfunction()

function(ew_header_of target path result)
  unset(header)
  get_target_property(folders ${target} INTERFACE_INCLUDE_DIRECTORIES)
  find_file(header ${path} PATHS ${folders} /usr/include NO_CACHE REQUIRED)
  set(${result} ${header} PARENT_SCOPE)
endfunction()

# What the headers say to the compiler, as text to be hashed further.
function(ew_hash_of_headers result)
  set(all "")
  foreach(header ${ARGN})
    file(READ ${header} text)
    string(REGEX REPLACE "//[^\n]*" "" text "${text}")
    string(REGEX REPLACE "[ \t\r\n]+" " " text "${text}")
    string(SHA256 hash "${text}")
    string(APPEND all ${hash})
  endforeach()
  set(${result} ${all} PARENT_SCOPE)
endfunction()

function(ew_write_abi into)
  ew_headers_of_the_door(${CMAKE_SOURCE_DIR}/workstation headers)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${headers})
  ew_hash_of_headers(all ${headers})

  ew_header_of(glm::glm glm/detail/setup.hpp glm)
  ew_defined_in(${glm} GLM_VERSION EW_ABI_GLM)
  ew_header_of(tl::expected tl/expected.hpp expected)
  ew_defined_in(${expected} TL_EXPECTED_VERSION_MAJOR EW_ABI_EXPECTED)
  string(REGEX REPLACE "^([0-9]+)\\.([0-9]+).*" "\\1*100+\\2" EW_ABI_JSON "${nlohmann_json_VERSION}")
  math(EXPR EW_ABI_JSON "${EW_ABI_JSON}")
  string(REGEX REPLACE "^([0-9]+\\.[0-9]+).*" "\\1" EW_ABI_QT "${Qt5_VERSION}")
  # GCC's own number; clang says 4 whatever it is.
  set(EW_ABI_COMPILER 4)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    string(REGEX REPLACE "\\..*" "" EW_ABI_COMPILER "${CMAKE_CXX_COMPILER_VERSION}")
  endif()
  include(CheckCXXSourceCompiles)
  check_cxx_source_compiles("#include <cstddef>\n#if !_GLIBCXX_USE_CXX11_ABI\n#error\n#endif\nint main() {}" EW_HAS_CXX11_ABI)
  set(EW_ABI_CXX11 0)
  if(EW_HAS_CXX11_ABI)
    set(EW_ABI_CXX11 1)
  endif()

  string(SHA256 hash "${all} Qt ${EW_ABI_QT} GLM ${EW_ABI_GLM} expected ${EW_ABI_EXPECTED} JSON ${EW_ABI_JSON} C++11 ABI ${EW_ABI_CXX11}")
  string(SUBSTRING ${hash} 0 6 hash)
  math(EXPR EW_ABI_NUMBER "(0x${hash} << 8) | (${EW_ABI_COMPILER} & 0xff)")
  file(CONFIGURE OUTPUT ${into} @ONLY CONTENT [[#pragma once

// Made when EchoWeave is configured (EwAbi.cmake).

#include <cstdint>

#define EW_ABI_COMPILER @EW_ABI_COMPILER@
#define EW_ABI_CXX11 @EW_ABI_CXX11@
#define EW_ABI_GLM @EW_ABI_GLM@
#define EW_ABI_EXPECTED @EW_ABI_EXPECTED@
#define EW_ABI_JSON @EW_ABI_JSON@
#define EW_ABI_QT "@EW_ABI_QT@"

namespace ew::sdk {

/// What must agree for C++ values to cross the door: 24 bits of a hash of headers and libraries, 8 bits of the compiler's generation.
inline constexpr std::uint32_t kAbi = @EW_ABI_NUMBER@u;

}  // namespace ew::sdk
]])
endfunction()
