#pragma once

#include <QObject>
#include <filesystem>
#include <memory>

#include "ew/sdk/host.h"
#include "ew/sdk/window.h"
#include "panel/session/review_document.h"
#include "panel/session/review_selection.h"
#include "panel/session/reviewer.h"

namespace ew::review {

/// Reports on the attempt that is chosen, or on all attempts of the lesson, as the window's language has them. Names are in them when they
/// are shown.
class ReviewReports final : public QObject {
  Q_OBJECT

 public:
  ReviewReports(sdk::Host& host, const ReviewSelection& selection, const Reviewer& reviewer, ReviewDocument& document)
      : host_(host), selection_(selection), reviewer_(reviewer), document_(document) {}

  /// Asks where a report is to be written, and writes it.
  void ask(const sdk::SaveFile& asked, bool isOfClass);
  /// In a job. @param file ending in .pdf or .html
  void write(const std::filesystem::path& file, bool isOfClass);

 private:
  sdk::Host& host_;
  const ReviewSelection& selection_;
  const Reviewer& reviewer_;
  ReviewDocument& document_;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace ew::review
