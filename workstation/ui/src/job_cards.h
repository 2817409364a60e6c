#pragma once

#include <QTimer>
#include <QWidget>
#include <map>

#include "jobs.h"

namespace ew::ui {

/// Cards in the lower right corner, one for each job that has run longer than half a second: name, step, percent, cancel.
class JobCards final : public QWidget {
  Q_OBJECT

 public:
  JobCards(Jobs& jobs, QWidget* parent);
  /// Keeps the cards at the lower right of `area` (in the parent's coordinates).
  void placeIn(const QRect& area);
  /// Of the cards that are shown, with the space around them; 0: there are none.
  [[nodiscard]] int heightWanted() const;

 Q_SIGNALS:
  void rearranged();  ///< there are more cards or fewer

 private:
  struct Card;
  void refresh();

  Jobs& jobs_;
  QTimer poll_;
  QRect area_;
  std::map<int, Card*> cards_;
};

}  // namespace ew::ui
