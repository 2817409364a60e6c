#pragma once

#include <QPushButton>

#include "panel/review_session.h"

namespace ew::review {

/// A button that asks for a file and writes a report into it.
class ReportButton final : public QPushButton {
  Q_OBJECT

 public:
  /// @param isOfClass on all attempts of the lesson; else on the one that is chosen
  ReportButton(ReviewSession& session, bool isOfClass, QWidget* parent = nullptr);

 private:
  void ask();

  ReviewSession& session_;
  bool isOfClass_;
};

}  // namespace ew::review
