#include "ew/door/headless_host.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "ew/io/safe_file.h"
#include "ew/io/volume_file.h"
#include "ew/library/case.h"

namespace ew::door {
namespace {

class FileVolumes final : public sdk::Volumes {
 public:
  Result<Volume> read(const std::filesystem::path& file, Progress& progress) override {
    auto loaded = readVolume(file, progress);
    if (!loaded) return passOn(loaded.error());
    for (const auto& note : loaded->notes) spdlog::warn("{}: {}", file.string(), note);
    return std::move(loaded->volume);
  }
  Result<void> write(const Volume& volume, const std::filesystem::path& file, Progress& progress) override {
    return writeVolume(volume, file, progress);
  }
  Result<void> writeCoverage(const Volume& volume, const std::filesystem::path& file, Progress& progress) override {
    return ew::writeCoverage(volume, file, progress);
  }
  Result<void> readCoverageInto(Volume& volume, const std::filesystem::path& file, Progress& progress) override {
    return ew::readCoverageInto(volume, file, progress);
  }
  void show(Volume, const std::string&) override {}
};

class PlainFiles final : public sdk::Files {
 public:
  Result<std::string> readText(const std::filesystem::path& file) override { return readTextFile(file); }
  Result<void> writeText(const std::filesystem::path& file, const std::string& text) override { return writeFileSafely(file, text); }
};

class NoOpenCase final : public sdk::Cases {
 public:
  std::optional<nlohmann::json> current() const override { return std::nullopt; }
  std::filesystem::path currentFolder() const override { return {}; }
  std::vector<Error> check(const nlohmann::json& manifest) const override { return checkManifest(manifest, {}); }
  Result<void> edit(const nlohmann::json&, const std::string&, const std::string&) override { return noCase(); }
  Result<void> save(const std::filesystem::path&) override { return noCase(); }
  bool hasUnsavedChanges() const override { return false; }
  Ticket onChanged(std::function<void()>) override { return nullptr; }

 private:
  static Result<void> noCase() { return failure(ErrorCode::notFound, "No case is open; open one in the workstation first."); }
};

class JobsAtOnce final : public sdk::Jobs {
 public:
  explicit JobsAtOnce(Progress& progress) : progress_(progress) {}
  void start(const std::string& title, std::function<Result<void>(Progress&)> work,
             std::function<void(const Result<void>&)> done) override {
    const Result<void> outcome = [&]() -> Result<void> {
      try {
        return work(progress_);
      } catch (const std::exception& problem) {
        return failure(ErrorCode::internal, "'" + title + "' stopped unexpectedly (" + problem.what() + ").");
      }
    }();
    if (done) done(outcome);
  }

 private:
  Progress& progress_;
};

class PanelNames final : public sdk::Panels {
 public:
  void add(const std::string&, const std::string& title, std::function<QWidget*(QWidget*)>) override { titles.push_back(title); }
  std::vector<std::string> titles;
};

class CommandList final : public sdk::Commands {
 public:
  void add(const std::string& name, const std::string& usage, Run run) override {
    if (std::any_of(commands.begin(), commands.end(), [&](const Command& c) { return c.name == name; })) {
      spdlog::warn("A plugin offers the command '{}', which another plugin already gave; the first one is kept.", name);
      return;
    }
    // An exception must not cross from a plugin into the program.
    auto guarded = [name, run = std::move(run)](const std::vector<std::string>& args, Progress& progress) -> Result<Outcome> {
      try {
        return run(args, progress);
      } catch (const std::bad_alloc&) {
        return failure(ErrorCode::tooLarge, "There is not enough memory for '" + name + "'; use a coarser spacing or a smaller input.");
      } catch (const std::exception& problem) {
        return failure(ErrorCode::internal, "'" + name + "' stopped unexpectedly (" + problem.what() + "); please report this.");
      }
    };
    commands.push_back({name, usage, std::move(guarded)});
  }
  std::vector<Command> commands;
};

class SpdLog final : public sdk::Log {
 public:
  void info(const std::string& text) override { spdlog::info("{}", text); }
  void warn(const std::string& text) override { spdlog::warn("{}", text); }
  void error(const std::string& text) override { spdlog::error("{}", text); }
};

}  // namespace

struct HeadlessHost::Parts {
  explicit Parts(Progress& progress) : jobs(progress) {}
  FileVolumes volumes;
  PlainFiles files;
  NoOpenCase cases;
  JobsAtOnce jobs;
  PanelNames panels;
  CommandList commands;
  SpdLog log;
};

HeadlessHost::HeadlessHost(Progress& progress) : parts_(std::make_unique<Parts>(progress)) {}
HeadlessHost::~HeadlessHost() = default;
sdk::Volumes& HeadlessHost::volumes() { return parts_->volumes; }
sdk::Files& HeadlessHost::files() { return parts_->files; }
sdk::Cases& HeadlessHost::cases() { return parts_->cases; }
sdk::Jobs& HeadlessHost::jobs() { return parts_->jobs; }
sdk::Panels& HeadlessHost::panels() { return parts_->panels; }
sdk::Commands& HeadlessHost::commands() { return parts_->commands; }
sdk::Log& HeadlessHost::log() { return parts_->log; }
const std::vector<Command>& HeadlessHost::registered() const { return parts_->commands.commands; }
const Command* HeadlessHost::find(const std::string& name) const {
  const auto at = std::find_if(registered().begin(), registered().end(), [&](const Command& c) { return c.name == name; });
  return at == registered().end() ? nullptr : &*at;
}
const std::vector<std::string>& HeadlessHost::offeredPanels() const { return parts_->panels.titles; }

}  // namespace ew::door
