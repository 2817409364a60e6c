#include "surface_net.h"

#include <bit>
#include <bitset>
#include <utility>

#include "ew/core/large_pages.h"
#include "ew/core/parallel.h"
#include "mixed_cells.h"

namespace ew::labelling {
namespace {

/// Of a row of cells, which of them hold more than one label. Kept by a worker for all its rows.
class CellFinder {
 public:
  explicit CellFinder(const LabelRows& rows)
      : rows_(rows), voxels_(rows.grid().dims.x), bits_((static_cast<std::size_t>(voxels_) + 62) / 64) {}

  /// Calls visit(i) for each of the row (j, k), ascending.
  template <class Visit>
  void visit(int j, int k, const Visit& visit) {
    const std::uint8_t* const rows[4] = {rows_.at(j - 1, k - 1), rows_.at(j, k - 1), rows_.at(j - 1, k), rows_.at(j, k)};
    const auto isLabelled = [&](int i) { return (rows[0][i] | rows[1][i] | rows[2][i] | rows[3][i]) != 0; };
    if (isLabelled(0)) visit(0);
    findMixed(rows, voxels_, bits_);
    for (std::size_t word = 0; word < bits_.size(); ++word)
      for (std::uint64_t left = bits_[word]; left != 0; left &= left - 1) visit(static_cast<int>(64 * word) + std::countr_zero(left) + 1);
    if (isLabelled(voxels_ - 1)) visit(voxels_);
  }

 private:
  const LabelRows& rows_;
  int voxels_;
  std::vector<std::uint64_t> bits_;
};

/// The labels at the corners of a cell; corner n lies at (n & 1, n >> 1 & 1, n >> 2).
using Corners = std::array<std::uint8_t, 8>;

Corners cornersOf(const std::array<const std::uint8_t*, 4>& rows, int i, int voxels) {
  Corners corners{};
  for (std::size_t n = 0; n < 4; ++n) {
    if (i > 0) corners[2 * n] = rows[n][i - 1];
    if (i < voxels) corners[2 * n + 1] = rows[n][i];
  }
  return corners;
}

template <std::size_t Count>
int differentOnes(const std::array<std::uint8_t, Count>& labels) {
  int different = 0;
  for (std::size_t n = 0; n < Count; ++n) {
    bool isNew = true;
    for (std::size_t m = 0; m < n; ++m) isNew = isNew && labels[m] != labels[n];
    different += isNew ? 1 : 0;
  }
  return different;
}

/// The sides of a cell that hold more than one label, and those that its point is smoothed across.
struct SidesOfCell {
  std::uint8_t mixed = 0, pulls = 0;
};

SidesOfCell sidesOf(const Corners& corners) {
  // Corners of the sides in the order of CellSide.
  static constexpr std::uint8_t kOfSide[6][4] = {{0, 2, 4, 6}, {1, 3, 5, 7}, {0, 1, 4, 5}, {2, 3, 6, 7}, {0, 1, 2, 3}, {4, 5, 6, 7}};
  SidesOfCell found;
  std::uint8_t lines = 0;  // where three labels meet on the side
  const bool isLine = differentOnes(corners) > 2;
  for (int side = 0; side < 6; ++side) {
    std::array<std::uint8_t, 4> labels{};
    for (std::size_t n = 0; n < 4; ++n) labels[n] = corners[kOfSide[side][n]];
    const auto bit = static_cast<std::uint8_t>(1 << side);
    if (labels[0] != labels[1] || labels[0] != labels[2] || labels[0] != labels[3]) found.mixed |= bit;
    if (isLine && differentOnes(labels) > 2) lines |= bit;
  }
  found.pulls = std::popcount(lines) >= 2 ? lines : found.mixed;
  return found;
}

/// Finds the points of a neighbouring row that lie at ascending columns.
class RowCursor {
 public:
  RowCursor(const SurfaceNet& net, int j, int k) {
    if (j < 0 || k < 0 || j >= net.cells.y || k >= net.cells.z) return;
    column_ = net.column.data();
    at_ = net.rowBegin[net.rowOf(j, k)];
    end_ = net.rowBegin[net.rowOf(j, k) + 1];
  }
  /// The point at column i, which is there.
  [[nodiscard]] std::int32_t find(int i) {
    while (at_ + 1 < end_ && column_[at_] < i) ++at_;
    return at_;
  }

 private:
  const std::int32_t* column_ = nullptr;
  std::int32_t at_ = 0, end_ = 0;
};

void connectRow(const LabelRows& rows, int j, int k, SurfaceNet& net) {
  const std::array<const std::uint8_t*, 4> voxels{rows.at(j - 1, k - 1), rows.at(j, k - 1), rows.at(j - 1, k), rows.at(j, k)};
  std::array<RowCursor, 4> cursors{RowCursor(net, j - 1, k), RowCursor(net, j + 1, k), RowCursor(net, j, k - 1), RowCursor(net, j, k + 1)};
  for (std::int32_t p = net.rowBegin[net.rowOf(j, k)]; p < net.rowBegin[net.rowOf(j, k) + 1]; ++p) {
    const auto point = static_cast<std::size_t>(p);
    const int i = net.column[point];
    const SidesOfCell sides = sidesOf(cornersOf(voxels, i, net.grid.dims.x));
    net.pullSides[point] = sides.pulls;
    for (std::size_t n = 0; n < 4; ++n) {
      const bool isMixed = (sides.mixed >> (n + 2) & 1) != 0;
      const std::int32_t other = isMixed ? cursors[n].find(i) : p;
      net.pulls[point][n] = (sides.pulls >> (n + 2) & 1) != 0 ? other : p;
      if (n % 2 == 1) net.after[point][n / 2] = other;
    }
  }
}

/// Rows of cells, slab by slab. @param work work(j, k, worker). @return false when cancelled
template <class Work>
bool forEachRow(const glm::ivec3& cells, int threads, Progress& progress, const Message& what, const Work& work) {
  return forEachTask(slabsOf(cells), threads, progress, what, [&](int slab, int worker, const auto& stopped) {
    for (int k = slab * kSlab; k < std::min(cells.z, (slab + 1) * kSlab) && !stopped(); ++k)
      for (int j = 0; j < cells.y; ++j) work(j, k, worker);
  });
}

std::vector<std::uint8_t> labelsIn(const std::vector<std::bitset<256>>& seen) {
  std::bitset<256> all;
  for (const auto& each : seen) all |= each;
  std::vector<std::uint8_t> labels;
  for (std::size_t label = 1; label < all.size(); ++label)
    if (all[label]) labels.push_back(static_cast<std::uint8_t>(label));
  return labels;
}

}  // namespace

bool countPoints(const LabelRows& rows, int threads, Progress& progress, std::vector<std::int32_t>& ofRow) {
  const glm::ivec3 cells = rows.grid().dims + 1;
  ofRow.assign(static_cast<std::size_t>(cells.y) * static_cast<std::size_t>(cells.z), 0);
  std::vector<CellFinder> mixed(static_cast<std::size_t>(threadCount(threads)), CellFinder(rows));
  return forEachRow(cells, threads, progress, say<"Finding the borders of labels">(), [&](int j, int k, int worker) {
    std::int32_t count = 0;
    mixed[static_cast<std::size_t>(worker)].visit(j, k, [&](int) { ++count; });
    ofRow[static_cast<std::size_t>(k) * static_cast<std::size_t>(cells.y) + static_cast<std::size_t>(j)] = count;
  });
}

bool buildNet(const LabelRows& rows, std::vector<std::int32_t> ofRow, int threads, Progress& progress, SurfaceNet& net) {
  net.grid = rows.grid();
  net.cells = net.grid.dims + 1;
  net.rowBegin = std::move(ofRow);
  std::int32_t points = 0;
  for (std::int32_t& each : net.rowBegin) points += std::exchange(each, points);
  net.rowBegin.push_back(points);
  const auto count = static_cast<std::size_t>(points);
  if (!growInLargePages(net.column, count, progress) || !growInLargePages(net.after, count, progress) ||
      !growInLargePages(net.pulls, count, progress) || !growInLargePages(net.pullSides, count, progress) ||
      !growInLargePages(net.offsets, count, progress))
    return false;
  const auto workers = static_cast<std::size_t>(threadCount(threads));
  std::vector<CellFinder> mixed(workers, CellFinder(rows));
  std::vector<std::bitset<256>> seen(workers);
  PartOfProgress finding(progress, 0.0, 0.4), joining(progress, 0.4, 1.0);
  if (!forEachRow(net.cells, threads, finding, say<"Finding the borders of labels">(), [&](int j, int k, int worker) {
        std::int32_t* next = net.column.data() + net.rowBegin[net.rowOf(j, k)];
        const std::uint8_t* const voxels = rows.at(j, k);
        mixed[static_cast<std::size_t>(worker)].visit(j, k, [&](int i) {
          *next++ = i;
          if (i < net.grid.dims.x) seen[static_cast<std::size_t>(worker)].set(voxels[i]);
        });
      }))
    return false;
  net.labels = labelsIn(seen);
  return forEachRow(net.cells, threads, joining, say<"Joining surfaces">(), [&](int j, int k, int) { connectRow(rows, j, k, net); });
}

}  // namespace ew::labelling
