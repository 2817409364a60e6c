#include "ew/measurement/package.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "ew/core/contract.h"
#include "ew/core/find_entry.h"
#include "ew/io/json_files.h"

namespace ew::measurement {
namespace {

template <class Labelled>
const Labelled* labelled(const std::vector<Labelled>& all, std::string_view label) {
  return entryWith(all, &Labelled::label, label);
}

double at(const Expression& expression, double weeks) { return expression.evaluate(std::array{weeks}); }

/// Between the rows of a table by straight lines.
PackageChart::Row rowAt(const PackageChart& chart, double weeks) {
  const auto next = std::find_if(chart.rows.begin() + 1, chart.rows.end() - 1, [&](const auto& row) { return row.weeks >= weeks; });
  const PackageChart::Row &b = *next, &a = *(next - 1);
  const double t = (weeks - a.weeks) / (b.weeks - a.weeks);
  return {weeks, std::lerp(a.low, b.low, t), std::lerp(a.median, b.median, t), std::lerp(a.high, b.high, t)};
}

}  // namespace

double FormulaError::of(double result) const { return percent > 0.0 ? 0.01 * percent * std::abs(result) : absolute; }

const PackageItem* Package::item(std::string_view label) const { return labelled(items, label); }
const PackageFormula* Package::formula(std::string_view label) const { return labelled(formulas, label); }

double percentileOf(double z) { return 50.0 * std::erfc(-z / std::numbers::sqrt2); }

double zOfPercentile(double percentile) {
  EW_EXPECTS(percentile > 0.0 && percentile < 100.0);
  // Bisection: a percentile is asked for by a person, and the inverse then agrees with percentileOf to the last digit.
  double low = -40.0, high = 40.0;
  for (int n = 0; n < 200; ++n) {
    const double middle = 0.5 * (low + high);
    (percentileOf(middle) < percentile ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double zScore(const PackageChart& chart, double weeks, double value) {
  EW_EXPECTS(value > 0.0);
  if (!chart.rows.empty()) {
    const auto row = rowAt(chart, weeks);
    const double oneSide = value < row.median ? row.median - row.low : row.high - row.median;
    return (row.median - value) / oneSide * zOfPercentile(chart.lowPercentile);
  }
  if (!chart.isLms) return (value / at(chart.median, weeks) - 1.0) / (0.01 * chart.spread_percent);
  const double L = at(chart.L, weeks), M = at(chart.M, weeks), S = at(chart.S, weeks);
  const double y = chart.ofLogarithm ? std::log(value) : value;
  return L == 0.0 ? std::log(y / M) / S : (std::pow(y / M, L) - 1.0) / (L * S);
}

double valueAt(const PackageChart& chart, double weeks, double z) {
  if (!chart.rows.empty()) {
    const auto row = rowAt(chart, weeks);
    return row.median - (z < 0.0 ? row.median - row.low : row.high - row.median) * z / zOfPercentile(chart.lowPercentile);
  }
  if (!chart.isLms) return at(chart.median, weeks) * (1.0 + 0.01 * chart.spread_percent * z);
  const double L = at(chart.L, weeks), M = at(chart.M, weeks), S = at(chart.S, weeks);
  const double y = L == 0.0 ? M * std::exp(S * z) : M * std::pow(1.0 + L * S * z, 1.0 / L);
  return chart.ofLogarithm ? std::exp(y) : y;
}

Result<Package> readPackage(const std::filesystem::path& file) {
  const Message where = say<"the measurement package %1">(file.string());
  const auto document = readJsonFile(file, where);
  if (!document) return passOn(document.error());
  return packageFromJson(*document, file.stem().string(), where);
}

Result<std::vector<Package>> readPackages(const std::filesystem::path& folder) {
  return readEvery<Package>(folder, say<"measurement packages">(), readPackage);
}

}  // namespace ew::measurement
