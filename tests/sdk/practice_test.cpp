#include <gtest/gtest.h>

#include "plugin_host.h"
#include "sdk/panel_host.h"

// What of a locked case the door hands to whom.
namespace ew::door {
namespace {

/// As the window while an instructor has locked the library.
class LockedCase final : public sdk::Cases {
 public:
  [[nodiscard]] std::optional<Case> current() const override { return called("Pain after meals"); }
  [[nodiscard]] std::optional<Case> forPractice() const override { return called("Gall stone"); }
  [[nodiscard]] bool isLocked() const override { return true; }
  [[nodiscard]] std::filesystem::path currentFolder() const override { return {}; }
  [[nodiscard]] Result<Case> read(const std::filesystem::path&) const override { return refused(); }
  [[nodiscard]] std::vector<Error> check(const Case&) const override { return {}; }
  Result<void> edit(const Case&, const std::string&, const std::string&) override { return refused(); }
  Result<void> save(const std::filesystem::path&) override { return refused(); }
  [[nodiscard]] bool hasUnsavedChanges() const override { return false; }
  Ticket onChanged(std::function<void()>) override { return nullptr; }

 private:
  static std::optional<Case> called(const std::string& title) {
    Case made;
    made.title = title;
    return made;
  }
  static tl::unexpected<Error> refused() { return failure(ErrorCode::badUsage, verbatim("Locked.")); }
};

class LockedHost final : public test::PanelHost {
 public:
  sdk::Cases& cases() override { return locked; }
  LockedCase locked;
};

TEST(ForPractice, IsTheWholeCaseForAPluginWhoseManifestSaysSo) {
  LockedHost inner;
  PluginManifest plugin;
  plugin.title = "Some plugin";
  plugin.capabilities = {"panel", "practice"};
  PluginHost host(inner, plugin, {});
  EXPECT_EQ(host.cases().forPractice()->title, "Gall stone");
  EXPECT_EQ(host.cases().current()->title, "Pain after meals");
}

TEST(ForPractice, IsWhatTraineesMayReadForAnyOther) {
  LockedHost inner;
  PluginManifest plugin;
  plugin.title = "Some plugin";
  plugin.capabilities = {"panel"};
  PluginHost host(inner, plugin, {});
  EXPECT_EQ(host.cases().forPractice()->title, "Pain after meals");
}

}  // namespace
}  // namespace ew::door
