#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/io/vector_file.h"

namespace ew {

/// Another program that registers two volumes, with one sensible setting. Run as a process on one thread; found on the path.
struct RegisterPeer {
  std::string program;  ///< "elastix"
  std::string setting;  ///< "B-splines of 10 mm, mutual information"
};
[[nodiscard]] std::vector<RegisterPeer> registerPeers();
[[nodiscard]] bool isInstalled(const std::string& program);

struct PeerRun {
  VectorField field;
  double cpu_s = 0.0;  ///< of the registering process alone
};
/// @param folder a folder of its own; files are left there
/// @error notFound (not installed), notWritable, internal (the process failed), cancelled (it is ended)
[[nodiscard]] Result<PeerRun> runPeer(const RegisterPeer& peer, const std::filesystem::path& fixed, const std::filesystem::path& moving,
                                      const std::filesystem::path& folder, Progress& progress);

}  // namespace ew
