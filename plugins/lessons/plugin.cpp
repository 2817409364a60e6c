#include "ew/sdk/plugin.h"

#include <QCoreApplication>

#include "ew/library/lesson.h"
#include "ew/sdk/case_parts.h"
#include "panel/player_panel.h"

namespace {

class LessonsPlugin final : public ew::sdk::Plugin {
 public:
  explicit LessonsPlugin(ew::sdk::Host& host) {
    const std::string part(ew::kLessonsPart);
    if (auto section = host.caseParts().add(part, ew::lessonsSchema()))
      section_ = std::move(*section);
    else
      host.log().warn(section.error().sentence());
    host.panels().add(
        "lessons", QCoreApplication::translate("ew::lessons", "Lessons").toStdString(),
        [&host](QWidget* parent) -> QWidget* { return new ew::lessons::PlayerPanel(host, parent); }, "explore");
  }

 private:
  ew::sdk::Ticket section_;
};

}  // namespace

extern "C" EW_EXPORT std::uint32_t ewPluginAbi() { return ew::sdk::kAbi; }
extern "C" EW_EXPORT ew::sdk::Plugin* ewPluginCreate(ew::sdk::Host& host) { return new LessonsPlugin(host); }
extern "C" EW_EXPORT void ewPluginDestroy(ew::sdk::Plugin* plugin) { delete plugin; }
