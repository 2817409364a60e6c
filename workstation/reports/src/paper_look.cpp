#include "paper_look.h"

namespace ew::reports {

Rgb inkOf(ReportTone tone) {
  switch (tone) {
    case ReportTone::plain:
      return kInk;
    case ReportTone::soft:
      return kSoftInk;
    case ReportTone::good:
      return {0x1a, 0x6b, 0x3c};
    case ReportTone::bad:
      return {0xb3, 0x26, 0x1e};
    case ReportTone::caution:
      return {0x7a, 0x52, 0x00};
  }
  return kInk;
}

void putLines(PaperPages& pages, const PaperText& text, const PaperFont& font, const Rgb& ink, double x, double width) {
  for (int line = 0; line < text.lines(); ++line) {
    pages.makeRoom(lineHeight(font));
    pages.line(text, line, font, ink, {x, pages.y()}, width);
    pages.moveOn(lineHeight(font));
  }
}

}  // namespace ew::reports
