#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ew/door/headless_host.h"
#include "ew/library/case.h"

namespace ew::test {

/// One case in memory with a list of what was done to it, checked as the workstation checks it.
class OneCase final : public sdk::Cases {
 public:
  std::optional<Case> current() const override { return opened; }
  Result<Case> read(const std::filesystem::path& folderOrManifest) const override { return loadCase(folderOrManifest); }
  std::filesystem::path currentFolder() const override { return folder; }
  std::vector<Error> check(const Case& next) const override { return checkCase(next); }
  Result<void> edit(const Case& next, const std::string& what, const std::string& mergeKey) override {
    if (auto problems = check(next); !problems.empty()) return passOn(problems.front());
    if (done.empty() || mergeKey.empty() || done.back().second != mergeKey) before.push_back(*opened);
    done.emplace_back(what, mergeKey);
    opened = next;
    unsaved = true;
    tell();
    return {};
  }
  Result<void> save(const std::filesystem::path&) override {
    unsaved = false;
    ++saves;
    tell();
    return {};
  }
  bool hasUnsavedChanges() const override { return unsaved; }
  std::optional<Scan> scan() const override { return present; }
  Choices choices() const override {
    Choices all;
    all.probes = {{"convex-3.5", "Convex"}, {"linear-12", "Linear"}};
    all.mannequins = {{"adult.json", "Adult"}, {"gravid.json", "Pregnant"}};
    return all;
  }
  Ticket onChanged(std::function<void()> callback) override {
    const int key = next_++;
    callbacks_[key] = std::move(callback);
    return {nullptr, [this, key](void*) { callbacks_.erase(key); }};
  }
  void undo() {
    opened = before.back();
    before.pop_back();
    tell();
  }
  void tell() {
    const auto copy = callbacks_;
    for (const auto& [key, callback] : copy) callback();
  }

  std::optional<Case> opened;  ///< without a folder: its files need not be there
  std::optional<Scan> present;
  std::filesystem::path folder = "/cases/one";
  std::vector<std::pair<std::string, std::string>> done;
  std::vector<Case> before;
  bool unsaved = false;
  int saves = 0;

 private:
  std::map<int, std::function<void()>> callbacks_;
  int next_ = 0;
};

/// Keeps what a plugin shows and offers; everything else is the headless host's.
class PanelHost : public sdk::Host, public sdk::Panels, public sdk::Volumes {
 public:
  sdk::Volumes& volumes() override { return *this; }
  sdk::Files& files() override { return inner_.files(); }
  sdk::Cases& cases() override { return theCase; }
  sdk::Jobs& jobs() override { return inner_.jobs(); }
  sdk::Panels& panels() override { return *this; }
  sdk::Commands& commands() override { return inner_.commands(); }
  sdk::Scan& scan() override { return inner_.scan(); }
  sdk::Workspaces& workspaces() override { return inner_.workspaces(); }
  sdk::Overlays& overlays() override { return inner_.overlays(); }
  sdk::CaseParts& caseParts() override { return inner_.caseParts(); }
  sdk::Window& window() override { return inner_.window(); }
  sdk::Log& log() override { return inner_.log(); }

  void addStaged(sdk::StagePanel panel) override { made[panel.id] = std::move(panel.make); }

  Result<Volume> read(const std::filesystem::path& file, Progress& p) override { return inner_.volumes().read(file, p); }
  Result<void> write(const Volume& v, const std::filesystem::path& file, Progress& p) override {
    return inner_.volumes().write(v, file, p);
  }
  Result<void> writeCoverage(const Volume& v, const std::filesystem::path& file, Progress& p) override {
    return inner_.volumes().writeCoverage(v, file, p);
  }
  Result<void> readCoverageInto(Volume& v, const std::filesystem::path& file, Progress& p) override {
    return inner_.volumes().readCoverageInto(v, file, p);
  }
  Result<sdk::VolumeInfo> inspect(const std::filesystem::path& file) override { return inner_.volumes().inspect(file); }
  Result<std::vector<std::uint8_t>> readConfidence(const Grid& grid, const std::filesystem::path& file, Progress& p) override {
    return inner_.volumes().readConfidence(grid, file, p);
  }
  Result<void> writeConfidence(const Grid& grid, std::span<const std::uint8_t> confidence, const std::filesystem::path& file,
                               Progress& p) override {
    return inner_.volumes().writeConfidence(grid, confidence, file, p);
  }
  Result<sdk::SweepPlan> planSweep(const std::filesystem::path& sweep, const sdk::SweepOptions& options, Progress& p) override {
    return inner_.volumes().planSweep(sweep, options, p);
  }
  Result<sdk::SweepVolume> reconstruct(const std::filesystem::path& sweep, const sdk::SweepOptions& options, Progress& p) override {
    return inner_.volumes().reconstruct(sweep, options, p);
  }
  Result<std::unique_ptr<sdk::VolumeWriter>> writeInBlocks(const Grid& grid, const std::filesystem::path& file) override {
    return inner_.volumes().writeInBlocks(grid, file);
  }
  void show(Volume volume, const std::string& title) override { shown.emplace_back(title, std::move(volume)); }

  OneCase theCase;
  std::map<std::string, std::function<QWidget*(QWidget*)>> made;
  std::vector<std::pair<std::string, Volume>> shown;

 private:
  door::HeadlessHost inner_;
};

}  // namespace ew::test
