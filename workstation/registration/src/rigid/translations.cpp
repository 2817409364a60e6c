#include "translations.h"

#include <kiss_fftnd.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>

#include "ew/core/parallel.h"
#include "pose_search.h"

namespace ew::registration {
namespace {

using Complex = std::complex<float>;

/// Least size at or above n without prime factors beyond 5, in multiples of 2.
int transformSize(int n) {
  for (int size = std::max(2, n + (n & 1));; size += 2) {
    int rest = size;
    for (const int p : {2, 3, 5}) {
      while (rest % p == 0) rest /= p;
    }
    if (rest == 1) return size;
  }
}

struct Plan {
  Plan(const glm::ivec3& size, bool inverse) {
    const int dims[3]{size.z, size.y, size.x};
    config.reset(kiss_fftnd_alloc(dims, 3, inverse ? 1 : 0, nullptr, nullptr));
  }
  void run(const std::vector<Complex>& in, std::vector<Complex>& out) const {
    kiss_fftnd(config.get(), reinterpret_cast<const kiss_fft_cpx*>(in.data()), reinterpret_cast<kiss_fft_cpx*>(out.data()));
  }
  struct Free {
    void operator()(kiss_fftnd_state* state) const { kiss_fft_free(state); }
  };
  std::unique_ptr<kiss_fftnd_state, Free> config;
};

/// Cells of the turned moving image, about its middle, and the box that holds them.
glm::ivec3 turnedDims(const glm::ivec3& dims, const glm::dmat3& latticeTurn, const glm::ivec3& most) {
  glm::ivec3 out;
  for (int a = 0; a < 3; ++a) {
    double extent = 0.0;
    for (int b = 0; b < 3; ++b) extent += std::abs(latticeTurn[b][a]) * dims[b];
    out[a] = std::min(most[a], static_cast<int>(std::ceil(extent - 1e-6)));
  }
  return out;
}

glm::ivec3 sizeFor(const glm::ivec3& fixed, const glm::ivec3& moving) {
  // Shifts that wrap around touch corners of the turned box only, with less overlap than counts.
  glm::ivec3 size;
  for (int a = 0; a < 3; ++a) size[a] = transformSize(fixed[a] + moving[a] - 2);
  return size;
}

/// What one thread needs.
struct Workspace {
  Workspace(const glm::ivec3& size, std::size_t cells)
      : forward(size, false), backward(size, true), space(cells), spectrum(cells), score(cells) {}
  Plan forward;
  Plan backward;
  std::vector<Complex> space;
  std::vector<Complex> spectrum;
  std::vector<float> score;
};

/// What an image's weights let count.
struct Weighed {
  double cells = 0.0;
  double energy = 0.0;
};

/// Value times weight in the real part, weight in the imaginary one.
/// @param place where in `into` a cell goes
template <class Place>
Weighed pack(const ComparableImage& image, const Place& place, std::vector<Complex>& into) {
  Weighed sum;
  for (int k = 0; k < image.grid.dims.z; ++k) {
    for (int j = 0; j < image.grid.dims.y; ++j) {
      for (int i = 0; i < image.grid.dims.x; ++i) {
        const std::size_t q = image.grid.indexOf(i, j, k);
        const float w = static_cast<float>(image.weight[q]) / 255.0F;
        into[place(i, j, k)] = {image.value[q] * w, w};
        sum.cells += static_cast<double>(w);
        sum.energy += static_cast<double>(w * image.value[q] * image.value[q]);
      }
    }
  }
  return sum;
}

/// The moving image at one rotation.
struct Turned {
  glm::dmat3 turn;     ///< fixed world to moving world
  glm::dmat3 lattice;  ///< steps of the fixed lattice to steps of the moving one
  glm::ivec3 box;      ///< cells of the fixed lattice that hold it, about its middle
  glm::dvec3 boxMiddle;
};

/// Masked correlation over all translations (Padfield 2012, equations 24-27, see translations.h): both images stand with their weights in
/// one complex volume, so that two transforms a rotation give the sums of products and the overlap for every shift at once.
/// resources/docs/science/registration.md, "By the images".
class TranslationSearch {
 public:
  TranslationSearch(const ComparableImage& fixed, const ComparableImage& moving, const TranslationOptions& options);

  [[nodiscard]] bool showsSomething() const { return fixedWeighed_.energy > 0.0 && movingWeighed_.energy > 0.0; }
  [[nodiscard]] std::unique_ptr<Workspace> workspace() const { return std::make_unique<Workspace>(size_, cells_); }
  /// The peaks of one rotation, best first; none when stopped.
  template <class Stopped>
  void search(const glm::dvec3& turn, const Stopped& stopped, Workspace& own, std::vector<Coarse>& found) const;

 private:
  [[nodiscard]] std::size_t at(int i, int j, int k) const { return (static_cast<std::size_t>(k) * size_.y + j) * size_.x + i; }
  [[nodiscard]] std::size_t atRim(int i, int j, int k) const { return (static_cast<std::size_t>(k) * rim_.y + j) * rim_.x + i; }
  [[nodiscard]] Turned turnedBy(const glm::dvec3& turn) const;
  template <class Stopped>
  [[nodiscard]] bool draw(const Turned& turned, const Stopped& stopped, std::vector<Complex>& space) const;
  void drawRow(const glm::dvec3& start, const glm::dvec3& step, int cells, Complex* row) const;
  void multiplySpectra(const std::vector<Complex>& movingSpectrum, std::vector<Complex>& product) const;
  void scoreShifts(const std::vector<Complex>& sums, std::vector<float>& score) const;
  [[nodiscard]] glm::ivec3 placeOf(std::size_t q) const;
  [[nodiscard]] Coarse coarseAt(std::size_t q, const Turned& turned, const std::vector<Complex>& sums) const;
  void clearAround(const glm::ivec3& place, std::vector<float>& score) const;

  const ComparableImage& fixed_;
  const ComparableImage& moving_;
  const TranslationOptions& options_;
  glm::ivec3 size_;  ///< of the transforms
  glm::ivec3 rim_;   ///< of the moving image with its rim
  std::size_t cells_;
  float perCell_;  ///< the library's inverse transform is not divided by the cells
  std::vector<Complex> fixedSpectrum_;
  std::vector<Complex> padded_;  ///< moving image with an empty rim, so that interpolation needs no tests at its border
  Weighed fixedWeighed_;
  Weighed movingWeighed_;
  double leastCells_ = 0.0;
  double perEnergy_ = 0.0;
};

TranslationSearch::TranslationSearch(const ComparableImage& fixed, const ComparableImage& moving, const TranslationOptions& options)
    : fixed_(fixed),
      moving_(moving),
      options_(options),
      size_(sizeFor(fixed.grid.dims, moving.grid.dims)),
      rim_(moving.grid.dims + 2),
      cells_(static_cast<std::size_t>(size_.x) * size_.y * size_.z),
      perCell_(1.0F / static_cast<float>(cells_)),
      fixedSpectrum_(cells_),
      padded_(static_cast<std::size_t>(rim_.x) * rim_.y * rim_.z) {
  {
    std::vector<Complex> space(cells_);
    fixedWeighed_ = pack(
        fixed, [this](int i, int j, int k) { return at(i, j, k); }, space);
    Plan(size_, false).run(space, fixedSpectrum_);
  }
  movingWeighed_ = pack(
      moving, [this](int i, int j, int k) { return atRim(i + 1, j + 1, k + 1); }, padded_);
  if (!showsSomething()) return;
  leastCells_ = std::max(8.0, options.leastOverlap * std::min(fixedWeighed_.cells, movingWeighed_.cells));
  perEnergy_ = 1.0 / std::sqrt(fixedWeighed_.energy / fixedWeighed_.cells * movingWeighed_.energy / movingWeighed_.cells);
}

template <class Stopped>
void TranslationSearch::search(const glm::dvec3& turn, const Stopped& stopped, Workspace& own, std::vector<Coarse>& found) const {
  const Turned turned = turnedBy(turn);
  if (!draw(turned, stopped, own.space)) return;
  own.forward.run(own.space, own.spectrum);
  if (stopped()) return;
  multiplySpectra(own.spectrum, own.space);
  if (stopped()) return;
  own.backward.run(own.space, own.spectrum);
  scoreShifts(own.spectrum, own.score);
  for (int peak = 0; peak < options_.peaks; ++peak) {
    const auto best = std::max_element(own.score.begin(), own.score.end());
    if (*best < 0.0F) break;
    const std::size_t q = best - own.score.begin();
    found.push_back(coarseAt(q, turned, own.spectrum));
    clearAround(placeOf(q), own.score);
  }
}

Turned TranslationSearch::turnedBy(const glm::dvec3& turn) const {
  Turned turned;
  turned.turn = options_.base * rotationBy(turn);
  turned.lattice = glm::transpose(moving_.grid.directions) * turned.turn * fixed_.grid.directions;
  turned.box = turnedDims(moving_.grid.dims, glm::transpose(turned.lattice), size_);
  turned.boxMiddle = 0.5 * glm::dvec3(turned.box - 1);
  return turned;
}

/// The turned moving image on the fixed lattice, from the first cell of `space` on.
template <class Stopped>
bool TranslationSearch::draw(const Turned& turned, const Stopped& stopped, std::vector<Complex>& space) const {
  std::fill(space.begin(), space.end(), Complex(0.0F, 0.0F));
  for (int k = 0; k < turned.box.z; ++k) {
    if (stopped()) return false;
    for (int j = 0; j < turned.box.y; ++j) {
      const glm::dvec3 start = turned.lattice * (glm::dvec3(0.0, j, k) - turned.boxMiddle) + 0.5 * glm::dvec3(moving_.grid.dims - 1) + 1.0;
      drawRow(start, turned.lattice[0], turned.box.x, space.data() + at(0, j, k));
    }
  }
  return true;
}

/// Trilinear, along the stretch that lies in the moving image with its rim.
/// @param start,step in cells of that image
void TranslationSearch::drawRow(const glm::dvec3& start, const glm::dvec3& step, int cells, Complex* row) const {
  double low = 0.0;
  double high = cells - 1.0;
  for (int a = 0; a < 3; ++a) {
    const double top = rim_[a] - 1.001;
    if (std::abs(step[a]) < 1e-9) {
      if (start[a] < 0.0 || start[a] > top) high = -1.0;
      continue;
    }
    const double to0 = (0.0001 - start[a]) / step[a];
    const double toTop = (top - start[a]) / step[a];
    low = std::max(low, std::min(to0, toTop));
    high = std::min(high, std::max(to0, toTop));
  }
  const glm::vec3 first(start);
  const glm::vec3 each(step);
  const glm::ivec3 rim = rim_;
  const std::size_t up = rim.x;
  const std::size_t over = static_cast<std::size_t>(rim.x) * rim.y;
  for (int i = static_cast<int>(std::ceil(low)); i <= static_cast<int>(std::floor(high)); ++i) {
    const glm::vec3 p = first + static_cast<float>(i) * each;
    const glm::ivec3 q = glm::clamp(glm::ivec3(p), glm::ivec3(0), rim - 2);
    const glm::vec3 f = p - glm::vec3(q);
    const Complex* c = padded_.data() + atRim(q.x, q.y, q.z);
    const auto along = [&](const Complex* s) { return s[0] + f.x * (s[1] - s[0]); };
    const Complex low0 = along(c) + f.y * (along(c + up) - along(c));
    const Complex low1 = along(c + over) + f.y * (along(c + over + up) - along(c + over));
    row[i] = low0 + f.z * (low1 - low0);
  }
}

/// F conj(M) + i W conj(V), with F, W (fixed image, weight) and M, V (moving) from the two packed spectra: they come apart by symmetry, as
/// the spectrum of a real volume at -f is the conjugate of that at f. Transformed back, its real part is the sum of the products of values
/// and its imaginary part that of the weights, for every shift.
void TranslationSearch::multiplySpectra(const std::vector<Complex>& movingSpectrum, std::vector<Complex>& product) const {
  const glm::ivec3 size = size_;
  for (int k = 0; k < size.z; ++k) {
    const int mk = (size.z - k) % size.z;
    for (int j = 0; j < size.y; ++j) {
      const int mj = (size.y - j) % size.y;
      const Complex* a = fixedSpectrum_.data() + at(0, j, k);
      const Complex* am = fixedSpectrum_.data() + at(0, mj, mk);
      const Complex* b = movingSpectrum.data() + at(0, j, k);
      const Complex* bm = movingSpectrum.data() + at(0, mj, mk);
      Complex* out = product.data() + at(0, j, k);
      for (int i = 0; i < size.x; ++i) {
        const int mi = i == 0 ? 0 : size.x - i;
        const float far = 0.5F * (a[i].real() + am[mi].real());
        const float fai = 0.5F * (a[i].imag() - am[mi].imag());
        const float war = 0.5F * (a[i].imag() + am[mi].imag());
        const float wai = -0.5F * (a[i].real() - am[mi].real());
        const float fbr = 0.5F * (b[i].real() + bm[mi].real());
        const float fbi = 0.5F * (b[i].imag() - bm[mi].imag());
        const float wbr = 0.5F * (b[i].imag() + bm[mi].imag());
        const float wbi = -0.5F * (b[i].real() - bm[mi].real());
        const float imageR = far * fbr + fai * fbi;
        const float imageI = fai * fbr - far * fbi;
        const float weightR = war * wbr + wai * wbi;
        const float weightI = wai * wbr - war * wbi;
        out[i] = {imageR - weightI, imageI + weightR};
      }
    }
  }
}

/// Correlation times the root of the overlap, but for a factor; far below 0 where too little overlaps.
void TranslationSearch::scoreShifts(const std::vector<Complex>& sums, std::vector<float>& score) const {
  const float perCell = perCell_;
  const float least = static_cast<float>(leastCells_);
  for (std::size_t q = 0; q < cells_; ++q) {
    const float n = sums[q].imag() * perCell;
    const float sum = sums[q].real() * perCell;
    score[q] = n >= least ? sum / std::sqrt(n) : -1e30F;
  }
}

glm::ivec3 TranslationSearch::placeOf(std::size_t q) const {
  return {static_cast<int>(q % size_.x), static_cast<int>(q / size_.x % size_.y), static_cast<int>(q / size_.x / size_.y)};
}

Coarse TranslationSearch::coarseAt(std::size_t q, const Turned& turned, const std::vector<Complex>& sums) const {
  Coarse c;
  c.overlapCells = static_cast<double>(sums[q].imag() * perCell_);
  c.correlation = std::clamp(static_cast<double>(sums[q].real() * perCell_) / c.overlapCells * perEnergy_, -0.99, 0.99);
  c.score = std::atanh(c.correlation) * std::sqrt(c.overlapCells);
  // Of the two shifts that wrap to this place, the one with the middles closer.
  const glm::ivec3 place = placeOf(q);
  glm::dvec3 shift;
  for (int a = 0; a < 3; ++a) {
    const double whole = place[a];
    const double toMiddle = 0.5 * (fixed_.grid.dims[a] - 1) - turned.boxMiddle[a];
    shift[a] = std::abs(whole - toMiddle) <= std::abs(whole - size_[a] - toMiddle) ? whole : whole - size_[a];
  }
  // Box cell x lies on fixed cell x + shift; the box's middle is the moving image's.
  const glm::dvec3 onFixed = carried(fixed_.grid.voxelTo<frame::Fixed>(), turned.boxMiddle + shift);
  const glm::dvec3 movingMiddle = carried(moving_.grid.voxelTo<frame::Moving>(), 0.5 * glm::dvec3(moving_.grid.dims - 1));
  c.fixedToMoving.matrix = glm::dmat4(turned.turn);
  c.fixedToMoving.matrix[3] = glm::dvec4(movingMiddle - turned.turn * onFixed, 1.0);
  return c;
}

void TranslationSearch::clearAround(const glm::ivec3& place, std::vector<float>& score) const {
  for (int dk = -2; dk <= 2; ++dk) {
    for (int dj = -2; dj <= 2; ++dj) {
      for (int di = -2; di <= 2; ++di) {
        const glm::ivec3 near = (place + glm::ivec3(di, dj, dk) + size_) % size_;
        score[at(near.x, near.y, near.z)] = -1e30F;
      }
    }
  }
}

}  // namespace

std::vector<glm::dvec3> rotationLattice(double most, double step) {
  const double side = 0.866 / 0.559 * step;  // of the body-centred cell with the cubic lattice's covering radius
  const double half = 0.5 * side;
  const double reach = most <= 0.0 ? 0.0 : std::min(most + 0.5 * step, 3.14159265358979 + 1e-9);
  const int n = static_cast<int>(std::ceil(reach / half)) + 1;
  std::vector<glm::dvec3> turns;
  for (int z = -n; z <= n; ++z) {
    for (int y = -n; y <= n; ++y) {
      for (int x = -n; x <= n; ++x) {
        const bool odd = (x & 1) != 0;
        if (((y & 1) != 0) != odd || ((z & 1) != 0) != odd) continue;
        const glm::dvec3 turn = half * glm::dvec3(x, y, z);
        if (glm::length(turn) <= reach) turns.push_back(turn);
      }
    }
  }
  std::stable_sort(turns.begin(), turns.end(), [](const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(a, a) < glm::dot(b, b); });
  if (most <= 1.1) return turns;
  // Rotation vectors crowd towards half a turn: leave out what lies close to one already taken.
  std::vector<glm::dvec3> kept;
  std::vector<glm::dvec4> quaternions;
  const double nearest = std::cos(0.5 * 0.55 * side);
  for (const glm::dvec3& turn : turns) {
    const double angle = glm::length(turn);
    const glm::dvec3 axis = angle > 0.0 ? turn / angle : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec4 q(axis * std::sin(0.5 * angle), std::cos(0.5 * angle));
    const bool close = angle > 0.9 && std::any_of(quaternions.begin(), quaternions.end(),
                                                  [&](const glm::dvec4& other) { return std::abs(glm::dot(q, other)) > nearest; });
    if (close) continue;
    kept.push_back(turn);
    quaternions.push_back(q);
  }
  return kept;
}

std::vector<Coarse> correlateOverTranslations(const ComparableImage& fixed, const ComparableImage& moving,
                                              const std::vector<glm::dvec3>& turns, const TranslationOptions& options, Progress& progress) {
  const TranslationSearch search(fixed, moving, options);
  if (!search.showsSomething()) return {};
  std::vector<std::unique_ptr<Workspace>> workspaces(threadCount(options.threads));
  std::vector<std::vector<Coarse>> found(turns.size());
  const bool done = forEachTask(static_cast<int>(turns.size()), options.threads, progress, say<"Searching poses">(),
                                [&](int task, int worker, const auto& stopped) {
                                  auto& own = workspaces[worker];
                                  if (!own) own = search.workspace();
                                  search.search(turns[task], stopped, *own, found[task]);
                                });
  if (!done) return {};
  std::vector<Coarse> all;
  for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
  std::stable_sort(all.begin(), all.end(), [](const Coarse& a, const Coarse& b) { return a.score > b.score; });
  return all;
}

std::uint64_t forecastTranslations_bytes(const Grid& fixed, const Grid& moving, int threads, std::size_t turns) {
  const glm::ivec3 size = sizeFor(fixed.dims, moving.dims);
  const std::uint64_t cells = static_cast<std::uint64_t>(size.x) * size.y * size.z;
  constexpr std::uint64_t kComplex_bytes = 8;
  // Per thread two complex volumes, the library's own copy in each of two plans, and the score; once the fixed spectrum and its source.
  return cells * (static_cast<std::uint64_t>(threads) * (2 * kComplex_bytes + 2 * kComplex_bytes + 4) + 2 * kComplex_bytes) +
         moving.voxelCount() * 8 + turns * 1024;
}

}  // namespace ew::registration
