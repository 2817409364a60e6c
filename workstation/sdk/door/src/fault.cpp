#include "ew/door/fault.h"

namespace ew::door {

const char* patternOf(const PluginFault& fault) {
  switch (fault.moment) {
    case PluginMoment::start:
      return "The plugin '%1' could not start (%3); the rest of the program is not affected.";
    case PluginMoment::panel:
      return "The panel '%2' of the plugin '%1' could not be opened (%3); the rest of the program is not affected.";
    case PluginMoment::command:
      return fault.thrown.noMemory
                 ? "There is not enough memory for '%2' of the plugin '%1'; use a coarser spacing or a smaller input."
                 : "The command '%2' of the plugin '%1' stopped unexpectedly (%3); please report it with the command you gave.";
    case PluginMoment::job:
      return fault.thrown.noMemory
                 ? "There is not enough memory for '%2' of the plugin '%1'; close other programs or choose a coarser spacing."
                 : "'%2' of the plugin '%1' stopped unexpectedly (%3); please report it with what you did.";
    case PluginMoment::jobDone:
      return "The plugin '%1' could not take over the result of '%2' (%3); please report it with what you did.";
    case PluginMoment::caseChanged:
      return "The plugin '%1' could not follow a change of the case (%3); what its panel shows may be out of date.";
    case PluginMoment::undo:
      return "The plugin '%1' could not undo the last step (%3); save under another name before you go on.";
    case PluginMoment::redo:
      return "The plugin '%1' could not redo the step (%3); save under another name before you go on.";
    case PluginMoment::save:
      return "The plugin '%1' could not save (%3); try another name or folder.";
    case PluginMoment::document:
      return "The plugin '%1' could not say what its panel holds (%3); save under another name before you go on.";
    case PluginMoment::scan:
      return "The plugin '%1' could not follow the scan (%3); what it shows may be out of date.";
    case PluginMoment::drive:
      return "The plugin '%1' could not move the probe (%3); press Escape to take the probe back.";
    case PluginMoment::menu:
      return "'%2' of the plugin '%1' did not come to its end (%3); please report it with what you did.";
    case PluginMoment::closing:
      return "The plugin '%1' could not say what it still holds (%3); save your work before you close the window.";
    case PluginMoment::event:
      return "The plugin '%1' met a problem that it did not foresee (%3); save your work, and please report it with what you did.";
    case PluginMoment::end:
      return "The plugin '%1' did not end in order (%3); nothing of your work is affected.";
  }
  return "The plugin '%1' failed (%3).";
}

std::string filled(const std::string& pattern, const PluginFault& fault) {
  std::string text;
  for (std::size_t n = 0; n < pattern.size(); ++n) {
    const char place = pattern[n] == '%' && n + 1 < pattern.size() ? pattern[n + 1] : '\0';
    if (place < '1' || place > '3') {
      text += pattern[n];
      continue;
    }
    text += place == '1' ? fault.plugin : place == '2' ? fault.what : fault.thrown.reason.english();
    ++n;
  }
  return text;
}

std::string sentenceOf(const PluginFault& fault) { return filled(patternOf(fault), fault); }

Error errorOf(const PluginFault& fault) {
  return {fault.thrown.noMemory ? ErrorCode::tooLarge : ErrorCode::internal, sentenceOf(fault), {{"plugin", fault.plugin}}};
}

}  // namespace ew::door
