#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

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

/// Where something is to be saved, as the one question of the program about it needs to know (Window::askSaveFile).
struct SaveFile {
  using Path = std::filesystem::path;
  std::string title;                 ///< of the dialog, in the window's language
  Path proposal;                     ///< a name, with its folder when it has one; without, where this kind of file was saved last
  std::string filter;                ///< "PDF (*.pdf);;Pages for browsers (*.html)", in the window's language
  std::vector<std::string> endings;  ///< that can be written (".pdf"), in any case of letters; a name with none of them gets one
  /// The files that saving under a complete name writes. Empty: that one alone.
  std::function<std::vector<Path>(const Path& file)> written = {};
  /// Why a file that is there must never be replaced, a sentence in the window's language; "": the user is asked. Empty: always asked.
  std::function<std::string(const Path& existing)> whyKept = {};
  std::vector<Path> madeFrom = {};  ///< what is saved was made from these files or folders: they are never replaced either
  bool isDated = false;             ///< day and time join the proposal, so that the next one is another
};

/// Work that lies in memory alone.
struct UnsavedWork {
  std::function<std::string()> sentence;  ///< what would be lost now ("The plan has changes that are not saved."); "": nothing
  /// Saves it, and may ask the user for that. @return whether all is begun; what Jobs::startSaving does is waited for. Empty: the user can
  /// only drop it or stay
  std::function<bool()> save = {};
  bool goesWithScan = false;  ///< it is lost when something else is scanned, too, and not only when the window closes
};

/// The window around it all: sentences, entries of menus, where to save, a word before work is lost. On the window's thread; headless the
/// sentences go to the log and the rest is not needed.
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
  /// The same for work that can be saved from the question, or that another scan takes away. Until the ticket is destroyed.
  [[nodiscard]] virtual Ticket holdUnsaved(UnsavedWork work);

  /// Asks for a name, completes its ending, and then asks by the files that will really be written whether what is there may be replaced.
  /// What `asked` never lets go, and what is on show was made from, is refused with a sentence. Plugins ask nobody else where to save.
  /// @return the complete name; empty: the user does not want to save, or there is no window
  [[nodiscard]] virtual std::optional<std::filesystem::path> askSaveFile(const SaveFile& asked);
};

}  // namespace ew::sdk
