#include "ew/sdk/plugin.h"

#include <QCoreApplication>

#include "panel/case_panel.h"

namespace {

class CaseAuthoringPlugin final : public ew::sdk::Plugin {
 public:
  explicit CaseAuthoringPlugin(ew::sdk::Host& host) {
    host.panels().add("case_authoring", QCoreApplication::translate("ew::case_authoring", "Case").toStdString(),
                      [&host](QWidget* parent) -> QWidget* { return new ew::case_authoring::CasePanel(host, parent); });
  }
};

}  // namespace

extern "C" EW_EXPORT std::uint32_t ewPluginAbi() { return ew::sdk::kAbi; }
extern "C" EW_EXPORT ew::sdk::Plugin* ewPluginCreate(ew::sdk::Host& host) { return new CaseAuthoringPlugin(host); }
extern "C" EW_EXPORT void ewPluginDestroy(ew::sdk::Plugin* plugin) { delete plugin; }
