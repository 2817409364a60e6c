#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "ew/controls/hub.h"

namespace ew::test {

/// Control surfaces that a test plugs in, plays on and unplugs.
struct MadeDesk {
  std::mutex mutex;
  std::vector<controls::Device> plugged;
  std::map<std::string, controls::Backend::Take> listening;  ///< by path
  bool refuses = false;
  int opened = 0;

  void send(const std::string& path, const std::vector<std::uint8_t>& bytes) {
    const std::lock_guard lock(mutex);
    if (const auto found = listening.find(path); found != listening.end()) found->second(bytes);
  }
};

class MadeConnection final : public controls::Connection {
 public:
  MadeConnection(MadeDesk& desk, std::string path) : desk_(desk), path_(std::move(path)) {}
  ~MadeConnection() override {
    const std::lock_guard lock(desk_.mutex);
    desk_.listening.erase(path_);
  }
  [[nodiscard]] bool isLost() const override { return false; }

 private:
  MadeDesk& desk_;
  std::string path_;
};

class MadeBackend final : public controls::Backend {
 public:
  explicit MadeBackend(MadeDesk& desk) : desk_(desk) {}
  Result<std::vector<controls::Device>> devices() override {
    const std::lock_guard lock(desk_.mutex);
    return desk_.plugged;
  }
  Result<std::unique_ptr<controls::Connection>> open(const controls::Device& device, Take take) override {
    const std::lock_guard lock(desk_.mutex);
    if (desk_.refuses) return failure(ErrorCode::notReadable, verbatim("taken"));
    ++desk_.opened;
    desk_.listening[device.path] = std::move(take);
    return std::make_unique<MadeConnection>(desk_, device.path);
  }

 private:
  MadeDesk& desk_;
};

inline std::vector<std::unique_ptr<controls::Backend>> backendOf(MadeDesk& desk) {
  std::vector<std::unique_ptr<controls::Backend>> backends;
  backends.push_back(std::make_unique<MadeBackend>(desk));
  return backends;
}

}  // namespace ew::test
