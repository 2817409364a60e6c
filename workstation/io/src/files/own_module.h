#pragma once

#include <filesystem>
#include <string>

namespace ew::detail {

/// A part of the program that links many libraries, and is loaded when there is work for it.
struct OwnModule {
  std::filesystem::path file;
  void* handle = nullptr;  ///< of dlopen, which is never closed; null: dlerror says why
};
/// @param name "libew_video.so": of lib/echoweave beside the program's own folder, else of the folder it was built in
[[nodiscard]] OwnModule openOwnModule(const char* name);

/// What dlerror says, or nothing.
[[nodiscard]] std::string whyNotOpened();

}  // namespace ew::detail
