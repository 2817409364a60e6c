#include <QCoreApplication>

#include "ew/sdk/plugin.h"

#include "logic/chain.h"
#include "panel/stitch_panel.h"

namespace {

class StitchingPlugin final : public ew::sdk::Plugin {
 public:
  explicit StitchingPlugin(ew::sdk::Host& host) {
    const std::string usage = std::string(ew::stitching::kStitchUsage) + "\n\n" + ew::stitching::kStitchHelp;
    host.commands().add("stitch", usage, [&host](const std::vector<std::string>& args, ew::Progress& progress) {
      return ew::stitching::runStitchCommand(args, host.volumes(), host.files(), host.log(), progress);
    });
    host.panels().add("stitching", QCoreApplication::translate("ew::stitching", "Stitching").toStdString(),
                      [&host](QWidget* parent) -> QWidget* { return new ew::stitching::StitchPanel(host, parent); });
  }
};

}  // namespace

extern "C" EW_EXPORT std::uint32_t ewPluginAbi() { return ew::sdk::kAbi; }
extern "C" EW_EXPORT ew::sdk::Plugin* ewPluginCreate(ew::sdk::Host& host) { return new StitchingPlugin(host); }
extern "C" EW_EXPORT void ewPluginDestroy(ew::sdk::Plugin* plugin) { delete plugin; }
