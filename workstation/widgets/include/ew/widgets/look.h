#pragma once

class QWidget;

namespace ew {

/// How a widget looks where it is not as all of its kind: what the style sheet (resources/style/window.qss) tells them apart by.
enum class Look {
  heading,    ///< a label or button above what it names
  quiet,      ///< a label with a hint, in the theme's quiet colour
  small,      ///< with the smaller of the two text sizes
  primary,    ///< the one button that does what comes next, in the accent
  compact,    ///< a button with little room at its sides
  flat,       ///< a button without ground and edge
  fold,       ///< a button that folds what is below it
  listed,     ///< a button that is a line of a list
  segment,    ///< a button between others that it stands against; the two at the ends are
  firstOf,    ///< ... the first
  lastOf,     ///< ... and the last
  onScan,     ///< on black in either theme
  panels,     ///< tabs that hold panels
  lowPanels,  ///< tabs within one
  edge,       ///< a strip at an edge of the window that brings something back
  workspace,  ///< a button that changes the workspace
};

/// Gives a look, or takes it away, also when the widget is seen. @param is whether it has it
void setLook(QWidget* widget, Look look, bool is = true);
[[nodiscard]] bool hasLook(const QWidget* widget, Look look);

}  // namespace ew
