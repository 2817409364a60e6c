#pragma once

#include <cairo.h>

#include <glm/glm.hpp>
#include <memory>
#include <string>

#include "ew/core/result.h"

namespace ew {

/// What the properties of a PDF say of it.
struct PdfAbout {
  std::string title = {};
  std::string made = {};  ///< ISO 8601, "2026-11-26T09:30:00Z"; empty: no date. So what is drawn alike is the same to the byte
};

/// A PDF while it is drawn with cairo: pages one after another, kept in memory until it is whole. Fonts go into the file.
class PdfFile {
 public:
  /// @param size_mm of the first page
  explicit PdfFile(const glm::dvec2& size_mm, const PdfAbout& about = {});

  /// Draws on the present page: points (1/72 inch) from its upper left corner, y down.
  [[nodiscard]] cairo_t* pen() { return pen_.get(); }
  /// Of the present page, on which nothing is drawn yet, and of those that follow.
  void setPageSize(const glm::dvec2& size_mm);
  /// The present page is whole.
  void endPage();
  /// An entry of the list of contents that viewers show beside the pages. @param parent of the entry above it; 0: none
  /// @param page from 1 on @param y_pt where it stands on that page @return its number, for entries below it
  int addOutline(int parent, const std::string& text, int page, double y_pt);

  /// The file as bytes; nothing can be drawn after it. @error internal (cairo says why)
  [[nodiscard]] Result<std::string> finish();

 private:
  struct Ending {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* pen) const { cairo_destroy(pen); }
  };
  std::unique_ptr<std::string> bytes_ = std::make_unique<std::string>();
  std::unique_ptr<cairo_surface_t, Ending> surface_;
  std::unique_ptr<cairo_t, Ending> pen_;
};

}  // namespace ew
