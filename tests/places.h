#pragma once

namespace ew::test {

/// Where the sources lie and where they were built. They stand in one source (places.cpp.in) and not in the flags of every test, so that a
/// test that was compiled in one clone need not be compiled in the next.
extern const char* const kSourceFolder;
extern const char* const kBuildFolder;

}  // namespace ew::test

#define EW_SOURCE_DIR ::ew::test::kSourceFolder
#define EW_BINARY_DIR ::ew::test::kBuildFolder
