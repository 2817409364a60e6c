#pragma once

#include <functional>
#include <string>

#include "ew/sdk/ticket.h"

namespace ew::sdk {

/// Where an entry stands: in the menu of tools, first in the menu of files, or there and as a button on the page of cases, where authors
/// and whoever has no case yet look for what begins one.
enum class MenuPlace { tools, file, start };

/// An entry of the window's menus; one with keys stands on the page of keys as well.
struct MenuEntry {
  std::string title;  ///< as shown, "&" before the letter for Alt
  std::string keys =
      {};  ///< "Ctrl+Shift+G", with Ctrl or Alt; keys that the window has stay the window's, and the log says so. Empty: none
  std::string workspace = {};  ///< the entry works in this one alone; empty: everywhere
  MenuPlace place = MenuPlace::tools;
};

/// The window around it all: sentences, entries of menus, a word before it closes. On the window's thread; headless the sentences go to the
/// log and the rest is not needed.
class Window {
 public:
  virtual ~Window();
  /// One sentence in the window's message bar. A later one with the same topic takes the place of the earlier; without a topic each stays
  /// until it is dismissed.
  virtual void info(const std::string& sentence, const std::string& topic = {}) = 0;
  virtual void warn(const std::string& sentence, const std::string& topic = {}) = 0;
  virtual void error(const std::string& sentence, const std::string& topic = {}) = 0;

  /// There until the ticket is destroyed.
  [[nodiscard]] virtual Ticket addEntry(const MenuEntry& entry, std::function<void()> run) = 0;

  /// Asked when the window is about to close: a sentence about what would be lost ("The plan has changes that are not saved."), or nothing.
  /// The user decides. A panel with a document says it there (PanelDocument::unsaved) and can be saved from the question.
  [[nodiscard]] virtual Ticket onClosing(std::function<std::string()> unsaved) = 0;
};

}  // namespace ew::sdk
