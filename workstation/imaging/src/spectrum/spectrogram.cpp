#include "ew/imaging/spectrogram.h"

#include <kiss_fft.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ew/core/contract.h"

namespace ew {
namespace {

constexpr double kWindow_s = 0.016;
constexpr int kFewest = 32, kMost = 512;
constexpr double kSameMoment = 0.5;  // of a sample
constexpr double kLift = 0.6;        // exponent of the grey curve: faint blood is seen, as on machines

using Transformer = std::unique_ptr<kiss_fft_state, decltype([](kiss_fft_state* state) { kiss_fft_free(state); })>;

}  // namespace

int spectrumWindow(double prf_hz) {
  EW_EXPECTS(prf_hz > 0.0);
  const double power = std::round(std::log2(kWindow_s * prf_hz));
  return std::clamp(1 << std::clamp(static_cast<int>(power), 0, 20), kFewest, kMost);
}

struct Spectrogram::Parts {
  SpectrumSetting setting;
  int window = 0, width = 0, height = 0;
  double sweep_s = 4.0;
  MModeStrip strip;
  std::vector<float> weights;
  std::vector<std::complex<float>> waiting;  ///< samples that further windows need
  double first_s = 0.0;                      ///< of the first sample there was
  std::int64_t dropped = 0;                  ///< samples before `waiting`
  std::int64_t made = 0;                     ///< columns so far
  bool started = false;
  std::vector<float> powers;  ///< a ring of spectra
  std::vector<double> times_s;
  std::vector<std::complex<float>> in, out;
  std::vector<std::uint8_t> grey;
  Transformer transformer;

  Parts() = default;
  Parts(const Parts& other)
      : setting(other.setting),
        window(other.window),
        width(other.width),
        height(other.height),
        sweep_s(other.sweep_s),
        strip(other.strip),
        weights(other.weights),
        waiting(other.waiting),
        first_s(other.first_s),
        dropped(other.dropped),
        made(other.made),
        started(other.started),
        powers(other.powers),
        times_s(other.times_s),
        in(other.in),
        out(other.out),
        grey(other.grey) {
    makeTransformer();
  }
  [[nodiscard]] std::size_t bins() const { return static_cast<std::size_t>(2 * window); }
  void makeTransformer() {
    if (window > 0) transformer.reset(kiss_fft_alloc(2 * window, 0, nullptr, nullptr));
  }
  [[nodiscard]] double columnTime_s() const { return sweep_s / std::max(width, 1); }
  /// First sample of the window of a column, counted from the first there was.
  [[nodiscard]] std::int64_t beginOf(std::int64_t column) const {
    return std::llround(static_cast<double>(column) * columnTime_s() * setting.prf_hz);
  }

  void makeColumn() {
    const auto begin = static_cast<std::size_t>(beginOf(made) - dropped), count = static_cast<std::size_t>(window);
    std::fill(in.begin(), in.end(), std::complex<float>(0.0F));
    for (std::size_t n = 0; n < count; ++n) in[n] = weights[n] * waiting[begin + n];
    kiss_fft(transformer.get(), reinterpret_cast<const kiss_fft_cpx*>(in.data()), reinterpret_cast<kiss_fft_cpx*>(out.data()));
    const std::size_t slot = static_cast<std::size_t>(made % width);
    float* power = powers.data() + slot * bins();
    for (std::size_t n = 0; n < bins(); ++n) power[n] = std::norm(out[(n + count) % bins()]);
    times_s[slot] = first_s + (static_cast<double>(beginOf(made)) + 0.5 * (window - 1)) / setting.prf_hz;
    for (std::size_t row = 0; row < grey.size(); ++row) {
      // Rows from the highest that is shown to the lowest, around where the scale ends.
      const double place = 0.5 * (1.0 + setting.baseline) - (static_cast<double>(row) + 0.5) / static_cast<double>(bins());
      const auto bin = static_cast<std::int64_t>(std::floor((place + 0.5) * static_cast<double>(bins())));
      const auto wrapped = static_cast<std::size_t>((bin % static_cast<std::int64_t>(bins()) + static_cast<std::int64_t>(bins())) %
                                                    static_cast<std::int64_t>(bins()));
      const double level_db = 10.0 * std::log10(std::max(static_cast<double>(power[wrapped]), 1e-30) / setting.black);
      const double share = std::clamp(level_db / setting.dynamicRange_db, 0.0, 1.0);
      const auto level = static_cast<std::uint8_t>(255.0 * std::pow(share, kLift) + 0.5);
      grey[setting.invert ? grey.size() - 1 - row : row] = level;
    }
    // On the clock of the samples; a hair later, so that rounding does not put a column before its own.
    strip.add(first_s + 0.5 * (window - 1) / setting.prf_hz + (static_cast<double>(made) + 1e-6) * columnTime_s(), grey);
    ++made;
  }
};

Spectrogram::Spectrogram() : parts_(std::make_unique<Parts>()) {}
Spectrogram::~Spectrogram() = default;
Spectrogram::Spectrogram(const Spectrogram& other) : parts_(std::make_unique<Parts>(*other.parts_)) {}
Spectrogram& Spectrogram::operator=(const Spectrogram& other) {
  if (this != &other) parts_ = std::make_unique<Parts>(*other.parts_);
  return *this;
}
Spectrogram::Spectrogram(Spectrogram&&) noexcept = default;
Spectrogram& Spectrogram::operator=(Spectrogram&&) noexcept = default;

void Spectrogram::configure(const SpectrumSetting& setting, int columns, int rows, double sweep_s) {
  EW_EXPECTS(columns >= 0 && rows >= 0 && sweep_s > 0.0 && setting.black > 0.0 && setting.dynamicRange_db > 0.0);
  Parts& p = *parts_;
  const auto laidAs = [&](SpectrumSetting other) {
    other.black = setting.black;
    other.dynamicRange_db = setting.dynamicRange_db;
    return other == setting;
  };
  if (laidAs(p.setting) && columns == p.width && rows == p.height && sweep_s == p.sweep_s && p.window > 0) {
    p.setting = setting;  // how light the next columns are
    return;
  }
  p.setting = setting;
  p.width = columns;
  p.height = rows;
  p.sweep_s = sweep_s;
  p.window = spectrumWindow(setting.prf_hz);
  p.makeTransformer();
  p.strip.configure(columns, rows, sweep_s);
  double power = 0.0;
  std::vector<double> weights;
  for (int n = 0; n < p.window; ++n) {
    weights.push_back(0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * (n + 0.5) / p.window));
    power += weights.back() * weights.back();
  }
  p.weights.clear();
  for (const double weight : weights) p.weights.push_back(static_cast<float>(weight / std::sqrt(power)));
  p.in.resize(p.bins());
  p.out.resize(p.bins());
  p.grey.resize(p.bins());
  p.powers.assign(p.bins() * static_cast<std::size_t>(std::max(columns, 1)), 0.0F);
  p.times_s.assign(static_cast<std::size_t>(std::max(columns, 1)), 0.0);
  clear();
}

void Spectrogram::clear() {
  Parts& p = *parts_;
  p.strip.clear();
  p.waiting.clear();
  p.dropped = p.made = 0;
  p.started = false;
}

void Spectrogram::add(std::span<const std::complex<float>> samples, double time_s) {
  Parts& p = *parts_;
  if (p.width == 0 || p.window == 0 || samples.empty()) return;
  const double expected_s = p.first_s + static_cast<double>(p.dropped + static_cast<std::int64_t>(p.waiting.size())) / p.setting.prf_hz;
  if (p.started && std::abs(time_s - expected_s) * p.setting.prf_hz > kSameMoment) clear();
  if (!p.started) {
    p.started = true;
    p.first_s = time_s;
  }
  p.waiting.insert(p.waiting.end(), samples.begin(), samples.end());
  while (p.beginOf(p.made) + p.window <= p.dropped + static_cast<std::int64_t>(p.waiting.size())) p.makeColumn();
  const auto done = std::min(p.beginOf(p.made) - p.dropped, static_cast<std::int64_t>(p.waiting.size()));
  if (done <= 0) return;
  p.waiting.erase(p.waiting.begin(), p.waiting.begin() + done);
  p.dropped += done;
}

const MModeStrip& Spectrogram::strip() const { return parts_->strip; }
const SpectrumSetting& Spectrogram::setting() const { return parts_->setting; }
int Spectrogram::window() const { return parts_->window; }
int Spectrogram::bins() const { return 2 * parts_->window; }
int Spectrogram::columns() const { return static_cast<int>(std::min<std::int64_t>(parts_->made, parts_->width)); }
double Spectrogram::timeOf(int column) const {
  EW_EXPECTS(column >= 0 && column < columns());
  return parts_->times_s[static_cast<std::size_t>((parts_->made - columns() + column) % parts_->width)];
}
std::span<const float> Spectrogram::powers(int column) const {
  EW_EXPECTS(column >= 0 && column < columns());
  return std::span(parts_->powers)
      .subspan(static_cast<std::size_t>((parts_->made - columns() + column) % parts_->width) * parts_->bins(), parts_->bins());
}

}  // namespace ew
