#pragma once

#include <QImage>
#include <QPainter>

#include "start/case_catalogue.h"

namespace ew::ui {

inline constexpr int kCardImage_px = 160;  ///< height of a card's image
inline constexpr int kCardMargin_px = 12;
inline constexpr int kCardGap_px = 16;  ///< between cards

struct CardLook {
  const CaseRow* row = nullptr;   ///< null: an empty card, for a case that is gone
  const QImage* image = nullptr;  ///< null: a fan is drawn
  CaseCatalogue::State state;
  bool isCurrent = false;  ///< where the keys are
  bool isUnderMouse = false;
  bool isLessonsUnderMouse = false;  ///< the mouse is where its lessons are asked for
  Qt::LayoutDirection direction = Qt::LeftToRight;
};

/// What every card takes: the texts have as many lines as there may be, so that cards of one row stand alike.
[[nodiscard]] int cardHeight_px();
/// Where a card's lessons are asked for, in the corner of its image; empty: it has none.
[[nodiscard]] QRect lessonsRect(const QRect& box, const CaseRow& row, Qt::LayoutDirection direction);
void paintCard(QPainter& painter, const QRect& box, const CardLook& look);

}  // namespace ew::ui
