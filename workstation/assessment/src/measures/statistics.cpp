#include "ew/assessment/statistics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "ew/assessment/random_numbers.h"
#include "ew/core/contract.h"

namespace ew {
namespace {

using Values = std::vector<double>;

double meanOf(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Sum of squares about the mean.
double spreadOf(std::span<const double> values) {
  const double mean = meanOf(values);
  return std::accumulate(values.begin(), values.end(), 0.0, [&](double sum, double each) { return sum + (each - mean) * (each - mean); });
}

template <class Item>
std::vector<Item> drawn(std::span<const Item> from, assessment::RandomNumbers& random) {
  std::vector<Item> again;
  again.reserve(from.size());
  for (std::size_t n = 0; n < from.size(); ++n) again.push_back(from[static_cast<std::size_t>(random.bits() % from.size())]);
  return again;
}

/// @param draw gives the estimate of one drawing, or nothing where it has none: that drawing is left out
template <class Draw>
Estimate withInterval(double value, const Bootstrap& bootstrap, const Draw& draw) {
  EW_EXPECTS(bootstrap.draws > 0);
  assessment::RandomNumbers random(bootstrap.seed);
  Values found;
  for (int n = 0; n < bootstrap.draws; ++n)
    if (const std::optional<double> each = draw(random)) found.push_back(*each);
  if (found.empty()) return {value, value, value};
  std::sort(found.begin(), found.end());
  const auto at = [&](double share) { return found[static_cast<std::size_t>(std::lround(share * static_cast<double>(found.size() - 1)))]; };
  return {value, at(0.025), at(0.975)};
}

/// Of two groups, each drawn by itself.
template <class Of>
std::optional<Estimate> ofGroups(std::span<const double> a, std::span<const double> b, const Bootstrap& bootstrap, const Of& of) {
  const std::optional<double> value = of(a, b);
  if (!value) return std::nullopt;
  return withInterval(*value, bootstrap, [&](assessment::RandomNumbers& random) {
    const Values first = drawn(a, random), second = drawn(b, random);
    return of(std::span<const double>(first), std::span<const double>(second));
  });
}

using Pairs = std::span<const std::pair<int, int>>;

std::optional<double> kappaOf(Pairs ratings, KappaWeights weights) {
  if (ratings.empty()) return std::nullopt;
  const auto apart = [&](int a, int b) {
    const double far = std::abs(static_cast<double>(a) - b);
    return weights == KappaWeights::linear ? far : far * far;
  };
  std::map<int, double> first, second;
  double observed = 0.0, expected = 0.0;
  for (const auto& [a, b] : ratings) {
    ++first[a];
    ++second[b];
    observed += apart(a, b);
  }
  const auto count = static_cast<double>(ratings.size());
  for (const auto& [a, timesA] : first)
    for (const auto& [b, timesB] : second) expected += timesA * timesB * apart(a, b) / count;
  if (!(expected > 0.0)) return std::nullopt;
  return 1.0 - observed / expected;
}

struct Agreement {
  double single, mean;
};

std::optional<Agreement> agreementOf(std::span<const Values> table) {
  const std::size_t rows = table.size();
  if (rows < 2 || table.front().size() < 2) return std::nullopt;
  const std::size_t columns = table.front().size();
  const auto n = static_cast<double>(rows), k = static_cast<double>(columns);
  Values all, byRow, byColumn(columns, 0.0);
  for (const Values& row : table) {
    EW_EXPECTS(row.size() == columns);
    all.insert(all.end(), row.begin(), row.end());
    byRow.push_back(meanOf(row));
    for (std::size_t column = 0; column < columns; ++column) byColumn[column] += row[column] / n;
  }
  const double total = spreadOf(all), rowSquares = k * spreadOf(byRow), columnSquares = n * spreadOf(byColumn);
  const double rowMean = rowSquares / (n - 1.0), columnMean = columnSquares / (k - 1.0);
  const double error = std::max(0.0, total - rowSquares - columnSquares) / ((n - 1.0) * (k - 1.0));
  const double single = rowMean + (k - 1.0) * error + k * (columnMean - error) / n, mean = rowMean + (columnMean - error) / n;
  if (!(single > 0.0) || !(mean > 0.0)) return std::nullopt;
  return Agreement{(rowMean - error) / single, (rowMean - error) / mean};
}

std::optional<double> crossingOf(std::span<const double> failing, std::span<const double> passing) {
  if (failing.size() < 2 || passing.size() < 2) return std::nullopt;
  const double low = meanOf(failing), high = meanOf(passing);
  if (!(high > low)) return std::nullopt;
  const double lowDeviation = std::sqrt(spreadOf(failing) / static_cast<double>(failing.size() - 1)),
               highDeviation = std::sqrt(spreadOf(passing) / static_cast<double>(passing.size() - 1));
  if (!(lowDeviation + highDeviation > 0.0)) return std::nullopt;
  // One curve falls and the other rises between the means: where their difference changes its sign.
  const auto lead = [&](double x) {
    const auto logDensity = [x](double mean, double deviation) {
      const double z = (x - mean) / deviation;
      return -0.5 * z * z - std::log(deviation);
    };
    const double least = 1e-9 * (high - low);
    return logDensity(high, std::max(highDeviation, least)) - logDensity(low, std::max(lowDeviation, least));
  };
  double left = low, right = high;
  if (lead(left) >= 0.0) return left;  // so wide is the one that the other never leads
  if (lead(right) <= 0.0) return right;
  for (int n = 0; n < 100; ++n) {
    const double middle = 0.5 * (left + right);
    (lead(middle) < 0.0 ? left : right) = middle;
  }
  return 0.5 * (left + right);
}

}  // namespace

std::optional<Estimate> contrastingGroups(std::span<const double> failing, std::span<const double> passing, const Bootstrap& bootstrap) {
  return ofGroups(failing, passing, bootstrap, crossingOf);
}

std::optional<Estimate> weightedKappa(Pairs ratings, KappaWeights weights, const Bootstrap& bootstrap) {
  const auto value = kappaOf(ratings, weights);
  if (!value) return std::nullopt;
  return withInterval(*value, bootstrap, [&](assessment::RandomNumbers& random) { return kappaOf(drawn(ratings, random), weights); });
}

std::optional<RaterAgreement> intraclassCorrelation(const RatingTable& table, const Bootstrap& bootstrap) {
  const std::span<const Values> rows(table);
  const auto value = agreementOf(rows);
  if (!value) return std::nullopt;
  const auto interval = [&](double Agreement::*which) {
    return withInterval((*value).*which, bootstrap, [&](assessment::RandomNumbers& random) {
      const auto again = agreementOf(drawn(rows, random));
      return again ? std::optional((*again).*which) : std::nullopt;
    });
  };
  return RaterAgreement{interval(&Agreement::single), interval(&Agreement::mean)};
}

}  // namespace ew
