#include "ew/sdk/plugin.h"

#include <QCoreApplication>
#include <nlohmann/json.hpp>

#include "editor/editor_panel.h"
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
        [this, &host](QWidget* parent) -> QWidget* {
          return new ew::lessons::PlayerPanel(
              host,
              [this, &host](bool working) {
                isWorking_ = working;
                showPanel(host);
              },
              parent);
        },
        "explore");
    host.panels().add("lesson_editor", QCoreApplication::translate("ew::lessons", "Lessons").toStdString(),
                      [&host](QWidget* parent) -> QWidget* { return new ew::lessons::EditorPanel(host, parent); });
    changed_ = host.cases().onChanged([this, &host] { showPanel(host); });
    opened_ = host.caseParts().onOpened([this, &host](const std::filesystem::path&) { showPanel(host); });
    showPanel(host);
  }

 private:
  /// A case that teaches nothing leaves its room to the scan; a lesson may lead through such a case.
  void showPanel(ew::sdk::Host& host) const {
    const auto opened = host.cases().forPractice();
    host.panels().setShown("lessons", isWorking_ || (opened && teaches(*opened)));
  }
  static bool teaches(const ew::Case& opened) {
    if (!opened.targets.empty() || !opened.measurements.empty()) return true;
    const auto lessons = nlohmann::json::json_pointer("/parts/lessons/lessons");
    return opened.otherFields.contains(lessons) && !opened.otherFields.at(lessons).empty();
  }

  ew::sdk::Ticket section_, changed_, opened_;
  bool isWorking_ = false;
};

}  // namespace

extern "C" EW_EXPORT std::uint32_t ewPluginAbi() { return ew::sdk::kAbi; }
extern "C" EW_EXPORT ew::sdk::Plugin* ewPluginCreate(ew::sdk::Host& host) { return new LessonsPlugin(host); }
extern "C" EW_EXPORT void ewPluginDestroy(ew::sdk::Plugin* plugin) { delete plugin; }
