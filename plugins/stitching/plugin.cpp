#include <QApplication>
#include <memory>

#include "ew/sdk/plugin.h"

#include "logic/command.h"
#include "panel/stitch_panel.h"
#include "panel/stitch_session.h"
#include "panel/stitch_stage.h"

namespace {

class StitchingPlugin final : public ew::sdk::Plugin {
 public:
  explicit StitchingPlugin(ew::sdk::Host& host) {
    const std::string usage = std::string(ew::stitching::kStitchUsage) + "\n\n" + ew::stitching::kStitchHelp;
    host.commands().add("stitch", usage, ew::stitching::runStitchCommand);
    // Without a window there is no panel, and the command line stays free of timers and folders.
    if (qobject_cast<QApplication*>(QCoreApplication::instance()) == nullptr) return;
    session_ = std::make_shared<ew::stitching::StitchSession>(host);
    ew::stitching::StitchSession& session = *session_;
    host.panels().addStaged({"stitching", QCoreApplication::translate("ew::stitching", "Stitching").toStdString(),
                             [&session](QWidget* parent) -> QWidget* { return new ew::stitching::StitchPanel(session, parent); },
                             [&session](QWidget* parent) -> QWidget* { return new ew::stitching::StitchStage(session, parent); }, session_,
                             ew::stitching::StitchStage::keyLines()});
  }

 private:
  std::shared_ptr<ew::stitching::StitchSession> session_;
};

}  // namespace

extern "C" EW_EXPORT std::uint32_t ewPluginAbi() { return ew::sdk::kAbi; }
extern "C" EW_EXPORT ew::sdk::Plugin* ewPluginCreate(ew::sdk::Host& host) { return new StitchingPlugin(host); }
extern "C" EW_EXPORT void ewPluginDestroy(ew::sdk::Plugin* plugin) { delete plugin; }
