#pragma once

#include <QPushButton>

namespace ew::review {

class ReviewReports;

/// A button that asks for a file and writes a report into it.
class ReportButton final : public QPushButton {
  Q_OBJECT

 public:
  /// @param isOfClass on all attempts of the lesson; else on the one that is chosen
  ReportButton(ReviewReports& reports, bool isOfClass, QWidget* parent = nullptr);

 private:
  void ask();

  ReviewReports& reports_;
  bool isOfClass_;
};

}  // namespace ew::review
