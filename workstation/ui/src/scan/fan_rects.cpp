#include "scan/fan_rects.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace ew::ui {
namespace {

constexpr int kBand_px = 8;  // rows that share a rectangle

}  // namespace

std::vector<QRect> rectsOfFan(const Spans& spans, const QPoint& at, double pixelRatio) {
  std::vector<QRect> rects;
  const int rows = static_cast<int>(spans.size());
  for (int top = 0; top < rows; top += kBand_px) {
    const int end = std::min(rows, top + kBand_px);
    std::optional<std::pair<int, int>> widest;
    for (int row = top; row < end; ++row) {
      for (const RowSpan& run : spans[static_cast<std::size_t>(row)]) {
        if (!widest) widest.emplace(run.begin, run.end);
        widest->first = std::min(widest->first, run.begin);
        widest->second = std::max(widest->second, run.end);
      }
    }
    if (!widest) continue;
    const auto before = [&](int pixel) { return static_cast<int>(std::floor(pixel / pixelRatio)); };
    const auto after = [&](int pixel) { return static_cast<int>(std::ceil(pixel / pixelRatio)); };
    const QPoint first(before(widest->first), before(top)), last(after(widest->second), after(end));
    rects.emplace_back(at + first, QSize(last.x() - first.x(), last.y() - first.y()));
  }
  return rects;
}

}  // namespace ew::ui
