#include "ew/sdk/plugin.h"

#include <QApplication>
#include <QPointer>

#include "ew/sdk/case_parts.h"
#include "ew/sdk/window.h"
#include "logic/landmark_pairs.h"
#include "panel/case_panel.h"
#include "panel/new_case_dialog.h"
#include "panel/place_panel.h"
#include "panel/targets_panel.h"

namespace {

class CaseAuthoringPlugin final : public ew::sdk::Plugin {
 public:
  ~CaseAuthoringPlugin() override { delete asking_; }  // it uses the host, which goes next
  explicit CaseAuthoringPlugin(ew::sdk::Host& host) {
    newCase_ = host.window().addEntry({.title = QCoreApplication::translate("ew::case_authoring", "&New case…").toStdString(),
                                       .keys = "Ctrl+N",
                                       .place = ew::sdk::MenuPlace::start},
                                      [this, &host] { askForCase(host); });
    host.panels().add("case_authoring", QCoreApplication::translate("ew::case_authoring", "Case").toStdString(),
                      [this, &host](QWidget* parent) -> QWidget* {
                        return new ew::case_authoring::CasePanel(
                            host, [this, &host] { askForCase(host); }, parent);
                      });
    if (auto section = host.caseParts().add(ew::case_authoring::kPlacingPart, ew::case_authoring::placingSchema()))
      placing_ = std::move(*section);
    else
      host.log().warn(section.error().sentence());
    host.panels().add("placing", QCoreApplication::translate("ew::case_authoring", "Place").toStdString(),
                      [&host](QWidget* parent) -> QWidget* { return new ew::case_authoring::PlacePanel(host, parent); });
    host.panels().add("targets", QCoreApplication::translate("ew::case_authoring", "Targets").toStdString(),
                      [&host](QWidget* parent) -> QWidget* { return new ew::case_authoring::TargetsPanel(host, parent); });
  }

 private:
  void askForCase(ew::sdk::Host& host) {
    if (!asking_) {
      asking_ = new ew::case_authoring::NewCaseDialog(host, QApplication::activeWindow());
      QObject::connect(asking_, &QDialog::rejected, asking_, &QObject::deleteLater);
    }
    asking_->open();
    asking_->raise();
  }

  QPointer<ew::case_authoring::NewCaseDialog> asking_;
  ew::sdk::Ticket newCase_;
  ew::sdk::Ticket placing_;  ///< the section of places
};

}  // namespace

extern "C" EW_EXPORT std::uint32_t ewPluginAbi() { return ew::sdk::kAbi; }
extern "C" EW_EXPORT ew::sdk::Plugin* ewPluginCreate(ew::sdk::Host& host) { return new CaseAuthoringPlugin(host); }
extern "C" EW_EXPORT void ewPluginDestroy(ew::sdk::Plugin* plugin) { delete plugin; }
