#pragma once

#include <arpa/inet.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "ew/export/outbox.h"
#include "ew/io/dicom.h"
#include "library/temporary_folder.h"
#include "time_limit.h"

namespace ew::test {

inline bool hasOrthanc() { return ::access("/usr/sbin/Orthanc", X_OK) == 0; }

/// A port of this machine that nobody listens at.
inline int freePort() {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  const bool isBound = ::bind(socket, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
                       ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) == 0;
  ::close(socket);
  return isBound ? ntohs(address.sin_port) : 0;
}

inline bool listensAt(int port) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  const bool listens = ::connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof(address)) == 0;
  ::close(socket);
  return listens;
}

/// Debian's Orthanc in a folder of its own; nothing of it stays.
class Orthanc {
 public:
  explicit Orthanc(const std::filesystem::path& folder) : folder_(folder), port_(freePort()) {
    std::filesystem::create_directories(folder / "db");
    const auto text = [](const std::filesystem::path& path) { return "\"" + path.string() + "\""; };
    writeText(folder / "orthanc.json",
              "{\"Name\": \"test\", \"StorageDirectory\": " + text(folder / "db") + ", \"IndexDirectory\": " + text(folder / "db") +
                  ", \"HttpServerEnabled\": false, \"DicomPort\": " + std::to_string(port_) +
                  ", \"DicomAet\": \"ORTHANC\", \"DicomCheckCalledAet\": true, \"DicomAlwaysAllowFind\": true, \"Plugins\": []}");
  }
  ~Orthanc() { kill(); }
  Orthanc(const Orthanc&) = delete;
  Orthanc& operator=(const Orthanc&) = delete;

  /// @return whether it listens now
  [[nodiscard]] bool start() {
    process_ = ::fork();
    if (process_ == 0) {
      const std::string file = (folder_ / "orthanc.json").string(), log = (folder_ / "log").string();
      if (std::freopen(log.c_str(), "a", stdout) == nullptr || std::freopen(log.c_str(), "a", stderr) == nullptr) ::_exit(126);
      ::execl("/usr/sbin/Orthanc", "Orthanc", file.c_str(), nullptr);
      ::_exit(127);
    }
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double, std::milli>(kPatience_ms);
    while (!listensAt(port_)) {
      if (std::chrono::steady_clock::now() > end || ::waitpid(process_, nullptr, WNOHANG) != 0) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return true;
  }
  [[nodiscard]] std::string said() const { return textOf(folder_ / "log"); }
  /// As when the power goes.
  void kill() {
    if (process_ == 0) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
    process_ = 0;
  }
  [[nodiscard]] DicomArchive address() const {
    DicomArchive archive;
    archive.host = "127.0.0.1";
    archive.port = port_;
    archive.aeTitle = "ORTHANC";
    return archive;
  }
  /// The DICOM files it keeps.
  [[nodiscard]] std::vector<std::filesystem::path> kept() const {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / "db"))
      if (entry.is_regular_file() && isDicom(entry.path())) files.push_back(entry.path());
    return files;
  }

 private:
  std::filesystem::path folder_;
  int port_;
  pid_t process_ = 0;
};

}  // namespace ew::test
