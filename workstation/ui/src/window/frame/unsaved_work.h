#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

namespace ew::ui {

/// What is about to take something a person made away.
enum class Loss {
  scan,     ///< another patient is scanned, and the case stays open
  opening,  ///< something else is opened in the place of case and scan
  closing   ///< the window closes
};

/// Who holds work that lies in memory alone: one list, and every way to lose something asks it. A holder that is not in it is asked by
/// nobody, so whoever keeps what a person made is added where it is made. Without Qt; what asks a person is the holder's.
class UnsavedWork {
 public:
  struct Holder {
    std::string name;                 ///< for tests and the log
    std::vector<Loss> lostWith;       ///< what takes its work away
    std::function<bool()> isUnsaved;  ///< whether there is any now
    /// Asks what is to become of it, and saves it when that is wanted. @param next what is ready to be shown in its place; empty: nothing
    /// @return whether it may go: it was given up, or is saved
    std::function<bool(Loss loss, const std::string& next)> mayGo;
  };

  void add(Holder holder) { holders_.push_back(std::move(holder)); }
  /// Asks every holder that would lose something, in the order they were added, until one wants to stay. @return whether to go on
  [[nodiscard]] bool mayLose(Loss loss, const std::string& next) const;
  /// The names of those that would be asked now.
  [[nodiscard]] std::vector<std::string> heldAgainst(Loss loss) const;

 private:
  [[nodiscard]] static bool loses(const Holder& holder, Loss loss);
  std::vector<Holder> holders_;
};

}  // namespace ew::ui
