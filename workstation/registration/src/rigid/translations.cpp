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
  const glm::ivec3 fixedDims = fixed.grid.dims;
  const glm::ivec3 movingDims = moving.grid.dims;
  const glm::ivec3 size = sizeFor(fixedDims, movingDims);
  const std::size_t cells = static_cast<std::size_t>(size.x) * size.y * size.z;
  const auto at = [&](int i, int j, int k) { return (static_cast<std::size_t>(k) * size.y + j) * size.x + i; };

  // Fixed image in the real part, its weight in the imaginary one; their spectra come apart by symmetry.
  std::vector<Complex> fixedSpectrum(cells);
  double fixedCells = 0.0;
  double fixedEnergy = 0.0;
  {
    std::vector<Complex> space(cells);
    for (int k = 0; k < fixedDims.z; ++k) {
      for (int j = 0; j < fixedDims.y; ++j) {
        for (int i = 0; i < fixedDims.x; ++i) {
          const std::size_t q = fixed.grid.indexOf(i, j, k);
          const float w = static_cast<float>(fixed.weight[q]) / 255.0f;
          space[at(i, j, k)] = {fixed.value[q] * w, w};
          fixedCells += static_cast<double>(w);
          fixedEnergy += static_cast<double>(w * fixed.value[q] * fixed.value[q]);
        }
      }
    }
    Plan(size, false).run(space, fixedSpectrum);
  }
  // Moving image with an empty rim, so that interpolation needs no tests at its border.
  const glm::ivec3 rim = movingDims + 2;
  std::vector<Complex> padded(static_cast<std::size_t>(rim.x) * rim.y * rim.z);
  double movingCells = 0.0;
  double movingEnergy = 0.0;
  for (int k = 0; k < movingDims.z; ++k) {
    for (int j = 0; j < movingDims.y; ++j) {
      for (int i = 0; i < movingDims.x; ++i) {
        const std::size_t q = moving.grid.indexOf(i, j, k);
        const float w = static_cast<float>(moving.weight[q]) / 255.0f;
        padded[(static_cast<std::size_t>(k + 1) * rim.y + j + 1) * rim.x + i + 1] = {moving.value[q] * w, w};
        movingCells += static_cast<double>(w);
        movingEnergy += static_cast<double>(w * moving.value[q] * moving.value[q]);
      }
    }
  }
  if (!(fixedEnergy > 0.0) || !(movingEnergy > 0.0)) return {};
  const double leastCells = std::max(8.0, options.leastOverlap * std::min(fixedCells, movingCells));
  const double perEnergy = 1.0 / std::sqrt(fixedEnergy / fixedCells * movingEnergy / movingCells);

  std::vector<std::unique_ptr<Workspace>> workspaces(threadCount(options.threads));
  std::vector<std::vector<Coarse>> found(turns.size());
  const double cell_mm = fixed.grid.spacing_mm.x;
  const glm::dvec3 fixedMiddle(fixed.grid.voxelToWorld().matrix * glm::dvec4(0.5 * glm::dvec3(fixedDims - 1), 1.0));
  const glm::dvec3 movingMiddle(moving.grid.voxelToWorld().matrix * glm::dvec4(0.5 * glm::dvec3(movingDims - 1), 1.0));

  const bool done = forEachTask(
      static_cast<int>(turns.size()), options.threads, progress, "Searching poses", [&](int task, int worker, const auto& stopped) {
        auto& own = workspaces[worker];
        if (!own) own = std::make_unique<Workspace>(size, cells);
        Workspace& w = *own;
        // fixed world -> moving world turns by R; from fixed lattice steps to moving lattice steps.
        const glm::dmat3 r = options.base * rotationBy(turns[task]);
        const glm::dmat3 lattice = glm::transpose(moving.grid.directions) * r * fixed.grid.directions;
        const glm::ivec3 box = turnedDims(movingDims, glm::transpose(lattice), size);
        std::fill(w.space.begin(), w.space.end(), Complex(0.0f, 0.0f));
        const glm::dvec3 boxMiddle = 0.5 * glm::dvec3(box - 1);
        const glm::vec3 step(lattice[0]);
        for (int k = 0; k < box.z; ++k) {
          if (stopped()) return;
          for (int j = 0; j < box.y; ++j) {
            const glm::dvec3 start = lattice * (glm::dvec3(0.0, j, k) - boxMiddle) + 0.5 * glm::dvec3(movingDims - 1) + 1.0;
            double low = 0.0;
            double high = box.x - 1.0;
            for (int a = 0; a < 3; ++a) {
              const double top = rim[a] - 1.001;
              if (std::abs(lattice[0][a]) < 1e-9) {
                if (start[a] < 0.0 || start[a] > top) high = -1.0;
                continue;
              }
              const double to0 = (0.0001 - start[a]) / lattice[0][a];
              const double toTop = (top - start[a]) / lattice[0][a];
              low = std::max(low, std::min(to0, toTop));
              high = std::min(high, std::max(to0, toTop));
            }
            Complex* row = w.space.data() + at(0, j, k);
            for (int i = static_cast<int>(std::ceil(low)); i <= static_cast<int>(std::floor(high)); ++i) {
              const glm::vec3 p = glm::vec3(start) + static_cast<float>(i) * step;
              const glm::ivec3 q = glm::clamp(glm::ivec3(p), glm::ivec3(0), rim - 2);
              const glm::vec3 f = p - glm::vec3(q);
              const Complex* c = padded.data() + (static_cast<std::size_t>(q.z) * rim.y + q.y) * rim.x + q.x;
              const std::size_t up = rim.x;
              const std::size_t over = static_cast<std::size_t>(rim.x) * rim.y;
              const auto along = [&](const Complex* s) { return s[0] + f.x * (s[1] - s[0]); };
              const Complex low0 = along(c) + f.y * (along(c + up) - along(c));
              const Complex low1 = along(c + over) + f.y * (along(c + over + up) - along(c + over));
              row[i] = low0 + f.z * (low1 - low0);
            }
          }
        }
        w.forward.run(w.space, w.spectrum);
        if (stopped()) return;
        // F conj(M) + i W conj(V), with F, W (fixed image, weight) and M, V (moving) from the two packed spectra.
        for (int k = 0; k < size.z; ++k) {
          const int mk = (size.z - k) % size.z;
          for (int j = 0; j < size.y; ++j) {
            const int mj = (size.y - j) % size.y;
            const Complex* a = fixedSpectrum.data() + at(0, j, k);
            const Complex* am = fixedSpectrum.data() + at(0, mj, mk);
            const Complex* b = w.spectrum.data() + at(0, j, k);
            const Complex* bm = w.spectrum.data() + at(0, mj, mk);
            Complex* out = w.space.data() + at(0, j, k);
            for (int i = 0; i < size.x; ++i) {
              const int mi = i == 0 ? 0 : size.x - i;
              const float far = 0.5f * (a[i].real() + am[mi].real());
              const float fai = 0.5f * (a[i].imag() - am[mi].imag());
              const float war = 0.5f * (a[i].imag() + am[mi].imag());
              const float wai = -0.5f * (a[i].real() - am[mi].real());
              const float fbr = 0.5f * (b[i].real() + bm[mi].real());
              const float fbi = 0.5f * (b[i].imag() - bm[mi].imag());
              const float wbr = 0.5f * (b[i].imag() + bm[mi].imag());
              const float wbi = -0.5f * (b[i].real() - bm[mi].real());
              const float imageR = far * fbr + fai * fbi;
              const float imageI = fai * fbr - far * fbi;
              const float weightR = war * wbr + wai * wbi;
              const float weightI = wai * wbr - war * wbi;
              out[i] = {imageR - weightI, imageI + weightR};
            }
          }
        }
        if (stopped()) return;
        w.backward.run(w.space, w.spectrum);
        const float perCell = 1.0f / static_cast<float>(cells);
        const float least = static_cast<float>(leastCells);
        for (std::size_t q = 0; q < cells; ++q) {
          const float n = w.spectrum[q].imag() * perCell;
          const float sum = w.spectrum[q].real() * perCell;
          w.score[q] = n >= least ? sum / std::sqrt(n) : -1e30f;
        }
        for (int peak = 0; peak < options.peaks; ++peak) {
          const auto best = std::max_element(w.score.begin(), w.score.end());
          if (*best < 0.0f) break;
          const std::size_t q = best - w.score.begin();
          glm::ivec3 place(static_cast<int>(q % size.x), static_cast<int>(q / size.x % size.y), static_cast<int>(q / size.x / size.y));
          Coarse c;
          c.overlapCells = static_cast<double>(w.spectrum[q].imag() * perCell);
          c.correlation = std::clamp(static_cast<double>(w.spectrum[q].real() * perCell) / c.overlapCells * perEnergy, -0.99, 0.99);
          c.score = std::atanh(c.correlation) * std::sqrt(c.overlapCells);
          // Of the two shifts that wrap to this place, the one with the middles closer.
          glm::dvec3 shift;
          for (int a = 0; a < 3; ++a) {
            const double whole = place[a];
            const double toMiddle = 0.5 * (fixedDims[a] - 1) - boxMiddle[a];
            shift[a] = std::abs(whole - toMiddle) <= std::abs(whole - size[a] - toMiddle) ? whole : whole - size[a];
          }
          // Box cell x lies on fixed cell x + shift; the box's middle is the moving image's.
          const glm::dvec3 onFixed(fixed.grid.voxelToWorld().matrix * glm::dvec4(boxMiddle + shift, 1.0));
          c.fixedToMoving = glm::dmat4(r);
          c.fixedToMoving[3] = glm::dvec4(movingMiddle - r * onFixed, 1.0);
          found[task].push_back(c);
          for (int dk = -2; dk <= 2; ++dk) {
            for (int dj = -2; dj <= 2; ++dj) {
              for (int di = -2; di <= 2; ++di) {
                w.score[at((place.x + di + size.x) % size.x, (place.y + dj + size.y) % size.y, (place.z + dk + size.z) % size.z)] = -1e30f;
              }
            }
          }
        }
      });
  if (!done) return {};
  static_cast<void>(cell_mm);
  static_cast<void>(fixedMiddle);
  std::vector<Coarse> all;
  for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
  std::stable_sort(all.begin(), all.end(), [](const Coarse& a, const Coarse& b) { return a.score > b.score; });
  return all;
}

std::uint64_t forecastTranslations_bytes(const Grid& fixed, const Grid& moving, int threads, std::size_t turns) {
  const glm::ivec3 size = sizeFor(fixed.dims, moving.dims);
  const std::uint64_t cells = static_cast<std::uint64_t>(size.x) * size.y * size.z;
  // Per thread two complex volumes, the library's own copy in each of two plans, and the score; once the fixed spectrum and its source.
  return cells * (static_cast<std::uint64_t>(threads) * (2 * 8 + 2 * 8 + 4) + 2 * 8) + moving.voxelCount() * 8 + turns * 1024;
}

}  // namespace ew::registration
