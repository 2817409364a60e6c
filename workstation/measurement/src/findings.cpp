#include "ew/measurement/findings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ew/core/contract.h"
#include "spreads.h"

namespace ew::measurement {
namespace {

struct CombinationInfo {
  CombinationKind kind;
  std::string_view word;
  std::size_t inputs;
};
constexpr std::array kCombinations{
    CombinationInfo{CombinationKind::ratio, "ratio", 2}, CombinationInfo{CombinationKind::percent, "percent", 2},
    CombinationInfo{CombinationKind::reduction, "reduction", 2}, CombinationInfo{CombinationKind::ellipsoid, "ellipsoid", 3},
    CombinationInfo{CombinationKind::biplane, "biplane", 2}};

const CombinationInfo& infoOfCombination(CombinationKind kind) {
  const auto found =
      std::find_if(kCombinations.begin(), kCombinations.end(), [&](const CombinationInfo& info) { return info.kind == kind; });
  EW_EXPECTS(found != kCombinations.end());
  return *found;
}

Error cannotCombine(Message why) { return {ErrorCode::badField, std::move(why), {}}; }

/// A figure that goes into a result.
struct Input {
  const Finding* finding = nullptr;
  const CaliperFigure* figure = nullptr;
  [[nodiscard]] double value() const { return figure->quantity.value; }
};

/// Uncertainty of a result from its derivative by each input, and what its inputs share.
void propagate(Combined& made, const std::vector<Input>& inputs, const std::vector<double>& slopes) {
  double variance = 0.0;
  for (std::size_t n = 0; n < inputs.size(); ++n) {
    if (!(inputs[n].figure->quantity.uncertainty > 0.0)) {
      made.remarks.push_back(say<"The uncertainty of an input is not known, so that of the result is not either.">());
      return;
    }
    for (std::size_t m = 0; m < inputs.size(); ++m) {
      const double shared = covariance(*inputs[n].finding, *inputs[n].figure, *inputs[m].finding, *inputs[m].figure);
      variance += slopes[n] * slopes[m] * shared;
      const double both = inputs[n].figure->quantity.uncertainty * inputs[m].figure->quantity.uncertainty;
      if (n < m && std::abs(shared / both) > std::abs(made.correlation)) made.correlation = shared / both;
    }
  }
  made.quantity.uncertainty = std::sqrt(std::max(0.0, variance));
}

Result<Combined> ratioOf(CombinationKind kind, const std::vector<Input>& inputs) {
  const Quantity &a = inputs[0].figure->quantity, &b = inputs[1].figure->quantity;
  if (!areComparable(a.unit, b.unit))
    return passOn(cannotCombine(
        say<"A ratio is of two quantities of one kind, but A is measured in %1 and B in %2; choose two lengths or two areas.">(
            std::string(symbolOf(a.unit)), std::string(symbolOf(b.unit)))));
  const double factor = converted(1.0, a.unit, b.unit);  // of A, to be of B's unit
  if (b.value == 0.0) return passOn(cannotCombine(say<"B is zero, and nothing can be divided by it; choose another measurement.">()));
  const double quotient = a.value * factor / b.value;
  const double scale = kind == CombinationKind::ratio ? 1.0 : kind == CombinationKind::percent ? 100.0 : -100.0;
  Combined made;
  made.quantity = {kind == CombinationKind::reduction ? 100.0 + scale * quotient : scale * quotient, 0.0,
                   kind == CombinationKind::ratio ? Unit::one : Unit::percent};
  propagate(made, inputs, {scale * factor / b.value, -scale * quotient / b.value});
  if (kind == CombinationKind::reduction && quotient > 1.0)
    made.remarks.push_back(say<"A is larger than B, so nothing is reduced; A is the narrow place, B the normal one.">());
  return made;
}

Result<Combined> ellipsoidOf(const std::vector<Input>& inputs) {
  constexpr double kMmCubed_ml = 1e-3;
  double volume = std::numbers::pi / 6.0 * kMmCubed_ml;
  std::vector<double> slopes;
  for (const Input& input : inputs) {
    if (!areComparable(input.figure->quantity.unit, Unit::mm))
      return passOn(cannotCombine(say<"A volume is of three lengths, but one of them is measured in %1; choose lengths.">(
          std::string(symbolOf(input.figure->quantity.unit)))));
    if (!(input.value() > 0.0)) return passOn(cannotCombine(say<"One of the three lengths is zero; choose another measurement.">()));
    volume *= input.value();
  }
  for (const Input& input : inputs) slopes.push_back(volume / input.value());
  Combined made;
  made.quantity = {volume, 0.0, Unit::ml};
  propagate(made, inputs, slopes);
  const auto isOf = [&](std::uint64_t image) { return [image](const Input& input) { return input.finding->image == image; }; };
  if (std::all_of(inputs.begin(), inputs.end(), isOf(inputs[0].finding->image)))
    made.remarks.push_back(say<"All three lengths are of one image; the third one belongs to an image at right angles to it.">());
  for (std::size_t n = 0; n < inputs.size(); ++n)
    for (std::size_t m = n + 1; m < inputs.size(); ++m)
      if (inputs[n].figure == inputs[m].figure) {
        made.remarks.push_back(say<"One length stands for two of the three; measure each of them.">());
        return made;
      }
  return made;
}

Result<Combined> biplaneOf(const std::vector<Input>& inputs) {
  Caliper both{CaliperKind::biplane, {}};
  for (const Input& input : inputs) {
    const Caliper& one = input.finding->measurement.caliper;
    if (one.kind != CaliperKind::discs)
      return passOn(cannotCombine(say<"Discs of two planes need two measurements by discs; draw them in both images first.">()));
    both.parts.push_back({static_cast<int>(both.parts.size()), one.parts[0].points});
  }
  if (inputs[0].finding->image == inputs[1].finding->image)
    return passOn(cannotCombine(say<"Both planes are of one image; the second one is that at right angles to it.">()));
  const bool isKnown = inputs[0].finding->at && inputs[1].finding->at;
  const auto at = [&](int part, const glm::dvec2& p) {
    const Finding& finding = *inputs[static_cast<std::size_t>(part)].finding;
    return finding.at(finding.measurement.caliper.parts[0].image, p);
  };
  auto measured = measure(both, isKnown ? UncertaintyAt(at) : UncertaintyAt());
  if (!measured) return passOn(measured.error());
  return Combined{measured->figures.front().quantity, 0.0, std::move(measured->remarks)};
}

}  // namespace

std::string_view wordOf(CombinationKind kind) { return infoOfCombination(kind).word; }
std::size_t inputCount(CombinationKind kind) { return infoOfCombination(kind).inputs; }

double covariance(const Finding& a, const CaliperFigure& ofA, const Finding& b, const CaliperFigure& ofB) {
  if (a.image != b.image || !a.at || !b.at) return 0.0;
  const Spreads spreads = spreadsOf(a.measurement.caliper, a.at);
  if (a.measurement.number == b.measurement.number) return covarianceWithin(ofA.gradient, ofB.gradient, spreads);
  return covarianceBetween(ofA.gradient, spreads, ofB.gradient, spreadsOf(b.measurement.caliper, b.at));
}

void Findings::measuredIn(std::uint64_t image, std::vector<Finding> now) {
  if (now.empty() && std::find(images_.begin(), images_.end(), image) == images_.end()) return;
  if (std::find(images_.begin(), images_.end(), image) == images_.end()) images_.push_back(image);
  const auto first = std::find_if(all_.begin(), all_.end(), [&](const Finding& each) { return each.image == image; });
  const auto place = first - all_.begin();
  std::erase_if(all_, [&](const Finding& each) { return each.image == image; });
  all_.insert(all_.begin() + place, std::make_move_iterator(now.begin()), std::make_move_iterator(now.end()));
}

const Finding* Findings::find(std::uint64_t image, int number) const {
  const auto found =
      std::find_if(all_.begin(), all_.end(), [&](const Finding& each) { return each.image == image && each.measurement.number == number; });
  return found == all_.end() ? nullptr : &*found;
}

int Findings::ordinalOf(std::uint64_t image) const {
  int ordinal = 0;
  for (const std::uint64_t each : images_) {
    if (each < kStripImage) ++ordinal;
    if (each == image) return ordinal;
  }
  return ordinal + 1;
}

Result<Combined> Findings::combine(CombinationKind kind, const std::vector<FigureRef>& of) const {
  if (of.size() != inputCount(kind))
    return passOn(cannotCombine(say<"This result is of %1 measurements, not of %2.">(inputCount(kind), of.size())));
  std::vector<Input> inputs;
  for (const FigureRef& ref : of) {
    const Finding* finding = find(ref.image, ref.number);
    if (finding == nullptr) return passOn(cannotCombine(say<"Measurement %1, which this result was made from, was deleted.">(ref.number)));
    const CaliperFigure* figure = finding->measured.figure(ref.figure);
    if (figure == nullptr)
      return passOn(cannotCombine(say<"Measurement %1 gives no %2; choose another one.">(ref.number, std::string(wordOf(ref.figure)))));
    inputs.push_back({finding, figure});
  }
  switch (kind) {
    case CombinationKind::ellipsoid:
      return ellipsoidOf(inputs);
    case CombinationKind::biplane:
      return biplaneOf(inputs);
    default:
      return ratioOf(kind, inputs);
  }
}

int Findings::add(CombinationKind kind, std::vector<FigureRef> of) {
  combinations_.push_back({next_, kind, std::move(of)});
  return next_++;
}

bool Findings::remove(int number) {
  return std::erase_if(combinations_, [&](const Combination& each) { return each.number == number; }) > 0;
}

void Findings::clear() {
  all_.clear();
  images_.clear();
  combinations_.clear();
  next_ = 1;
}

}  // namespace ew::measurement
