#include "ew/sdk/plugin.h"

#include <QApplication>
#include <memory>

#include "ew/sdk/window.h"
#include "ew/sdk/workspaces.h"
#include "guide_panel.h"

namespace {

using guided_sweep::Guide;

constexpr const char* kIcon =
    R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24" fill="none" stroke="currentColor" stroke-width="2"
  stroke-linecap="round"><path d="M4 18c4-10 12 2 16-8"/><circle cx="4" cy="18" r="1.5"/><path d="M20 10l-4 0M20 10l0.5 4"/></svg>)";

std::string translated(const char* text) { return QCoreApplication::translate("guided_sweep", text).toStdString(); }

/// `guided-sweep CASE`: what sweep a case holds, for scripts.
ew::Result<ew::sdk::Commands::Outcome> describe(ew::sdk::Host& host, const std::vector<std::string>& args) {
  if (args.size() != 1)
    return ew::failure(ew::ErrorCode::badUsage, ew::say<"Name one case. Usage: echoweave guided-sweep CASE/case.json.">());
  const auto opened = host.cases().read(args.front());
  if (!opened) return ew::passOn(opened.error());
  if (const auto problems = host.cases().check(*opened); !problems.empty()) return ew::passOn(problems.front());
  const auto section = opened->otherFields.value("parts", nlohmann::json::object()).value("guided_sweep", nlohmann::json::object());
  const auto plan = guided_sweep::planOf(section);
  if (!plan.isWhole())
    return ew::failure(ew::ErrorCode::notFound, ew::say<"The case holds no guided sweep; keep one in the window first.">());
  ew::sdk::Commands::Outcome outcome;
  outcome.quality = {{"length_mm", guided_sweep::length_mm(plan)}, {"duration_s", plan.duration_s}};
  return outcome;
}

class GuidedSweep final : public ew::sdk::Plugin {
 public:
  explicit GuidedSweep(ew::sdk::Host& host)
      : guide_(host, qobject_cast<QApplication*>(QCoreApplication::instance()) == nullptr
                         ? guided_sweep::Words{}
                         : guided_sweep::Words{translated("Start"), translated("End"), translated("Target"),
                                               translated("Target, %1 mm out of the image")}) {
    host.commands().add("guided-sweep", "guided-sweep CASE/case.json",
                        [&host](const std::vector<std::string>& args, ew::Progress&) { return describe(host, args); });
    host.workspaces().add(
        {.id = "guide", .title = translated("Guide"), .tip = translated("Follow a sweep that the case holds"), .icon = kIcon});
    host.panels().add(
        "guided_sweep", translated("Guided sweep"),
        [this, &host](QWidget* parent) -> QWidget* { return new guided_sweep::GuidePanel(host, guide_, parent); }, "guide");
    entry_ = host.window().addEntry({.title = translated("&Show the guided sweep"), .keys = "Ctrl+G"}, [this, &host] {
      host.workspaces().show("guide");
      guide_.run();
    });
    closing_ =
        host.window().onClosing([this] { return guide_.isRunning() ? translated("The guided sweep is still going on.") : std::string(); });
  }

 private:
  Guide guide_;
  ew::sdk::Ticket entry_, closing_;
};

}  // namespace

extern "C" EW_EXPORT std::uint32_t ewPluginAbi() { return ew::sdk::kAbi; }
extern "C" EW_EXPORT ew::sdk::Plugin* ewPluginCreate(ew::sdk::Host& host) { return new GuidedSweep(host); }
extern "C" EW_EXPORT void ewPluginDestroy(ew::sdk::Plugin* plugin) { delete plugin; }
