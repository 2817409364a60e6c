#include "ew/sdk/plugin.h"

#include <QApplication>
#include <memory>

#include "ew/sdk/workspaces.h"
#include "panel/review_column.h"
#include "panel/review_stage.h"
#include "panel/review_words.h"
#include "panel/session/review_session.h"

namespace {

QString in(const char* text) { return QCoreApplication::translate("ew::review", text); }

class ReviewPlugin final : public ew::sdk::Plugin {
 public:
  explicit ReviewPlugin(ew::sdk::Host& host) {
    if (qobject_cast<QApplication*>(QCoreApplication::instance()) == nullptr) return;  // headless there is nothing to look at
    session_ = std::make_shared<ew::review::ReviewSession>(host);
    ew::review::ReviewSession& session = *session_;
    host.workspaces().add({"review", in("Review").toStdString(), in("Compare trainees' scans with the expert's").toStdString(),
                           ew::review::workspaceIcon(), false, false, false});
    host.panels().addStaged({"review", in("Attempts").toStdString(),
                             [&session](QWidget* parent) -> QWidget* { return new ew::review::ReviewColumn(session, parent); },
                             [&session](QWidget* parent) -> QWidget* { return new ew::review::ReviewStage(session, parent); },
                             std::shared_ptr<ew::sdk::PanelDocument>(session_, &session.document()),  // it lives as long as the session
                             ew::review::ReviewStage::keyLines(), "review"});
  }

 private:
  std::shared_ptr<ew::review::ReviewSession> session_;
};

}  // namespace

extern "C" EW_EXPORT std::uint32_t ewPluginAbi() { return ew::sdk::kAbi; }
extern "C" EW_EXPORT ew::sdk::Plugin* ewPluginCreate(ew::sdk::Host& host) { return new ReviewPlugin(host); }
extern "C" EW_EXPORT void ewPluginDestroy(ew::sdk::Plugin* plugin) { delete plugin; }
