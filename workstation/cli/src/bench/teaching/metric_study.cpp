#include "bench/teaching/metric_study.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace ew {
namespace {

using Values = std::vector<std::optional<double>>;
using Drawn = std::vector<std::size_t>;  // persons by their places

const Values& valuesOf(const StudyCell& cell, SkillLevel level) { return cell.values[static_cast<std::size_t>(level)]; }

/// Of every pair of persons, over all steps: how often the higher was better, and how many steps both have.
struct Pairs {
  std::size_t lower = 0, higher = 0;
  std::vector<double> won, of;

  Pairs(const std::vector<const StudyCell*>& cells, SkillLevel low, SkillLevel high, double sign) {
    lower = valuesOf(*cells.front(), low).size();
    higher = valuesOf(*cells.front(), high).size();
    won.assign(lower * higher, 0.0);
    of.assign(lower * higher, 0.0);
    for (const StudyCell* cell : cells)
      for (std::size_t i = 0; i < lower; ++i)
        for (std::size_t j = 0; j < higher; ++j) {
          const auto &a = valuesOf(*cell, low)[i], &b = valuesOf(*cell, high)[j];
          if (!a || !b) continue;
          const double better = sign * (*b - *a);
          won[i * higher + j] += better > 0.0 ? 1.0 : better == 0.0 ? 0.5 : 0.0;
          of[i * higher + j] += 1.0;
        }
  }
  [[nodiscard]] std::optional<double> area(const Drawn& low, const Drawn& high) const {
    double sum = 0.0, count = 0.0;
    for (const std::size_t i : low)
      for (const std::size_t j : high) {
        sum += won[i * higher + j];
        count += of[i * higher + j];
      }
    return count > 0.0 ? std::optional(sum / count) : std::nullopt;
  }
};

struct Moments {
  double count = 0.0, mean = 0.0, squares = 0.0;
};
Moments momentsOf(const Values& values, const Drawn& drawn) {
  Moments found;
  for (const std::size_t n : drawn) {
    if (!values[n]) continue;
    found.count += 1.0;
    const double away = *values[n] - found.mean;
    found.mean += away / found.count;
    found.squares += away * (*values[n] - found.mean);
  }
  return found;
}

/// Mean over the steps of Hedges' g.
std::optional<double> effect(const std::vector<const StudyCell*>& cells, SkillLevel low, SkillLevel high, double sign, const Drawn& lower,
                             const Drawn& higher) {
  double sum = 0.0;
  int count = 0;
  for (const StudyCell* cell : cells) {
    const Moments a = momentsOf(valuesOf(*cell, low), lower), b = momentsOf(valuesOf(*cell, high), higher);
    const double freedom = a.count + b.count - 2.0;
    if (a.count < 2.0 || b.count < 2.0) continue;
    const double deviation = std::sqrt((a.squares + b.squares) / freedom);
    if (!(deviation > 1e-12 * (std::abs(a.mean) + std::abs(b.mean)))) continue;
    sum += sign * (b.mean - a.mean) / deviation * (1.0 - 3.0 / (4.0 * freedom - 1.0));
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

Drawn everybody(std::size_t count) {
  Drawn all(count);
  for (std::size_t n = 0; n < count; ++n) all[n] = n;
  return all;
}

std::optional<Estimate> estimate(const std::optional<double>& value, std::vector<double> draws) {
  if (!value || draws.empty()) return std::nullopt;
  std::sort(draws.begin(), draws.end());
  const auto at = [&](double share) { return draws[static_cast<std::size_t>(share * static_cast<double>(draws.size() - 1) + 0.5)]; };
  return Estimate{*value, at(0.025), at(0.975)};
}

}  // namespace

Discrimination discriminationOf(const std::vector<const StudyCell*>& cells, SkillLevel lower, SkillLevel higher, bool moreIsBetter,
                                const Bootstrap& bootstrap) {
  Discrimination found;
  if (cells.empty()) return found;
  const double sign = moreIsBetter ? 1.0 : -1.0;
  const Pairs pairs(cells, lower, higher, sign);
  found.steps = static_cast<int>(cells.size());
  found.persons = static_cast<int>(std::min(pairs.lower, pairs.higher));
  if (pairs.lower == 0 || pairs.higher == 0) return found;
  std::mt19937_64 random(bootstrap.seed);  // its numbers, unlike those of distributions, are the same everywhere
  const auto drawn = [&](std::size_t count) {
    Drawn persons(count);
    for (std::size_t& each : persons) each = static_cast<std::size_t>(random() % count);
    return persons;
  };
  std::vector<double> areas, effects;
  for (int n = 0; n < bootstrap.draws; ++n) {
    const Drawn low = drawn(pairs.lower), high = drawn(pairs.higher);
    if (const auto area = pairs.area(low, high)) areas.push_back(*area);
    if (const auto size = effect(cells, lower, higher, sign, low, high)) effects.push_back(*size);
  }
  const Drawn all = everybody(pairs.lower), others = everybody(pairs.higher);
  found.area = estimate(pairs.area(all, others), std::move(areas));
  found.effect = estimate(effect(cells, lower, higher, sign, all, others), std::move(effects));
  return found;
}

}  // namespace ew
