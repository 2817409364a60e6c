// Plugins that misbehave, one per value of ODD: what the door must turn into a sentence.
#include <memory>
#include <new>
#include <stdexcept>

#include "ew/sdk/case_parts.h"
#include "ew/sdk/overlays.h"
#include "ew/sdk/plugin.h"
#include "ew/sdk/scan.h"
#include "ew/sdk/window.h"
#include "ew/sdk/workspaces.h"

#define ODD_EMPTY 0
#define ODD_ABI 1
#define ODD_THROWS 2
#define ODD_NUMBER 3
#define ODD_NULL 4
#define ODD_GOOD 5
#define ODD_LATE 6         // registers whatever can be registered, then throws
#define ODD_LATE_NUMBER 7  // the same, and throws a number
#define ODD_LATE_NULL 8    // the same, and gives nothing
#define ODD_CALLBACKS 9    // throws whenever it is called
#define ODD_END 10         // throws when it is destroyed

#if ODD == ODD_EMPTY
extern "C" EW_EXPORT int someFunction() { return 7; }
#else
namespace {

using ew::sdk::Commands;

/// What somebody threw who does not know std::exception is a number; the others say why.
[[noreturn]] void fail(bool number, const char* why) {
  if (number) throw 42;
  throw std::runtime_error(why);
}

class OddDocument final : public ew::sdk::PanelDocument {
 public:
  std::string title() const override { fail(true, ""); }
  std::string remark() const override { fail(false, "no remark"); }
  std::string note() const override { fail(false, "no note"); }
  std::string undoText() const override { fail(true, ""); }
  std::string redoText() const override { fail(false, "no redo"); }
  void undo() override { fail(true, ""); }
  void redo() override { fail(false, "nothing to redo it with"); }
  void save(bool) override { fail(false, "the dog ate the disk"); }
  std::string unsaved() const override { fail(false, "who knows"); }
  std::shared_ptr<void> onChanged(std::function<void()>) override { fail(true, ""); }
};

/// Knows the first pose it is asked for.
class OddPoses final : public ew::PoseSource {
 public:
  ew::Pose poseAt(double) const override {
    if (asked_++ > 0) fail(true, "");
    ew::Pose pose;
    pose.probeToWorld.matrix[3].x = 7.0;
    return pose;
  }
  bool movesAfter(double) const override { fail(false, "perhaps"); }

 private:
  mutable int asked_ = 0;
};

/// Registers a panel, a stage with a document, commands, a ticket and a job, all of which use this object and throw.
class Odd final : public ew::sdk::Plugin {
 public:
  explicit Odd(ew::sdk::Host& host) : host_(host) {
    host.panels().add("odd", "Odd column", [this](QWidget*) -> QWidget* { return panel(); });
    host.panels().addStaged({"staged",
                             "Odd stage",
                             [this](QWidget*) -> QWidget* { return panel(); },
                             [this](QWidget*) -> QWidget* { return panel(); },
                             document_,
                             {{"Ctrl+O", "Be odd"}}});
    host.commands().add("throw-number", "throw-number",
                        [this](const std::vector<std::string>&, ew::Progress&) -> ew::Result<Commands::Outcome> { fail(alive_, ""); });
    host.commands().add("throw-memory", "throw-memory",
                        [](const std::vector<std::string>&, ew::Progress&) -> ew::Result<Commands::Outcome> { throw std::bad_alloc(); });
    host.commands().add("throw-at-the-end", "throw-at-the-end",
                        [this](const std::vector<std::string>&, ew::Progress&) -> ew::Result<Commands::Outcome> {
                          Commands::Outcome outcome;
                          outcome.putInPlace = [this]() -> ew::Result<void> { fail(alive_, ""); };
                          return outcome;
                        });
    host.commands().add("give-up", "give-up", [this](const std::vector<std::string>&, ew::Progress&) -> ew::Result<Commands::Outcome> {
      document_.reset();
      return Commands::Outcome{};
    });
    registerWithScanAndWindow(host);
    ticket_ = host.cases().onChanged([this] { fail(alive_, ""); });
    host.jobs().startSaving(
        "Odd work", [this](ew::Progress&) -> ew::Result<void> { fail(alive_, ""); },
        [this](const ew::Result<void>&) { fail(!alive_, "no idea what to do with it"); });
    if (ODD == ODD_LATE || ODD == ODD_LATE_NUMBER) fail(ODD == ODD_LATE_NUMBER, "changed its mind");
  }
  ~Odd() override { alive_ = false; }

 private:
  void registerWithScanAndWindow(ew::sdk::Host& host) {
    events_ = host.scan().onEvent([this](const ew::ScanEvent&) { fail(alive_, ""); });
    drive_ = host.scan().drive(std::make_shared<OddPoses>(), [this] { fail(alive_, ""); });
    if (auto section = host.caseParts().add("odd", "{}")) section_ = std::move(*section);
    opened_ = host.caseParts().onOpened([this](const std::filesystem::path&) { fail(alive_, ""); });
    entry_ = host.window().addEntry({.title = "&Odd entry"}, [this] { fail(alive_, ""); });
    closing_ = host.window().onClosing([this]() -> std::string { fail(alive_, ""); });
    host.workspaces().add({.id = "odd", .title = "Odd"});
    overlay_ = host.overlays().overScan();
    overlay_->show({.labels = {{.at = {}, .text = "odd"}}});
  }
  [[nodiscard]] QWidget* panel() const { fail(alive_, ""); }
  ew::sdk::Host& host_;
  bool alive_ = true;
  std::shared_ptr<OddDocument> document_ = std::make_shared<OddDocument>();
  ew::sdk::Ticket ticket_, events_, drive_, section_, opened_, entry_, closing_;
  std::shared_ptr<ew::sdk::ScanOverlay> overlay_;
};

class Good final : public ew::sdk::Plugin {
 public:
  explicit Good(ew::sdk::Host& host) {
    host.commands().add("throw", "throw", [](const std::vector<std::string>&, ew::Progress&) -> ew::Result<Commands::Outcome> {
      throw std::runtime_error("out of cheese");
    });
  }
};

}  // namespace

extern "C" EW_EXPORT std::uint32_t ewPluginAbi() { return ODD == ODD_ABI ? 65537u : ew::sdk::kAbi; }
extern "C" EW_EXPORT ew::sdk::Plugin* ewPluginCreate(ew::sdk::Host& host) {
  if (ODD == ODD_THROWS) throw std::runtime_error("no licence for the moon");
  if (ODD == ODD_NUMBER) throw 42;
  if (ODD == ODD_NULL) return nullptr;
  if (ODD == ODD_LATE_NULL) {
    static std::unique_ptr<Odd> kept;  // what it registered is taken back while it still lives, and when it no longer does
    kept = std::make_unique<Odd>(host);
    kept.reset();
    return nullptr;
  }
  if (ODD >= ODD_LATE && ODD <= ODD_CALLBACKS) return new Odd(host);
  return new Good(host);
}
extern "C" EW_EXPORT void ewPluginDestroy(ew::sdk::Plugin* plugin) {
  delete plugin;
  if (ODD == ODD_END) throw 42;
}
#endif
