#include <algorithm>
#include <cmath>
#include <numbers>

#include "ew/imaging/effect_info.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/scene.h"
#include "settings_fields.h"

namespace ew {
namespace {

/// Brings each field of `setting` into its range.
template <class T>
class Limiter {
 public:
  explicit Limiter(T& setting) : setting_(setting) {}

  void number(const char*, double T::*field, double lowest, double highest, detail::Meaning) {
    limit(setting_.*field, kDefault.*field, lowest, highest);
  }
  void numberOrZero(const char*, double T::*field, double lowest, double highest, detail::Meaning) {
    if (setting_.*field != 0.0) limit(setting_.*field, kDefault.*field, lowest, highest);
  }
  void angle(const char*, double T::*field, double lowest_deg, double highest_deg) {
    constexpr double kPerDegree = std::numbers::pi / 180.0;
    limit(setting_.*field, kDefault.*field, lowest_deg * kPerDegree, highest_deg * kPerDegree);
  }
  void count(const char*, int T::*field, int lowest, int highest) { setting_.*field = std::clamp(setting_.*field, lowest, highest); }
  void oddCount(const char* key, int T::*field, int lowest, int highest) {
    count(key, field, lowest, highest);
    setting_.*field |= 1;
  }
  template <std::size_t N>
  void factors(const char*, std::array<double, N> T::*field, double lowest, double highest) {
    for (std::size_t n = 0; n < N; ++n) limit((setting_.*field)[n], (kDefault.*field)[n], lowest, highest);
  }
  template <std::size_t N>
  void decibels(const char* key, std::array<double, N> T::*field, double lowest_db, double highest_db) {
    factors(key, field, lowest_db, highest_db);
  }
  template <std::size_t N>
  void foci(const char*, double T::*first, std::array<double, N> T::*more, double lowest, double highest) {
    limit(setting_.*first, kDefault.*first, lowest, highest);
    for (double& focus : setting_.*more) limit(focus, 0.0, lowest, highest);
  }
  template <class E, std::size_t N>
  void choice(const char*, E T::*field, const WordTable<E, N>& words) {
    if (std::none_of(words.begin(), words.end(), [&](const auto& word) { return word.second == setting_.*field; }))
      setting_.*field = kDefault.*field;
  }
  void flag(const char*, bool T::*) {}
  void text(const char*, std::string T::*, std::size_t) {}
  template <class Effect>
  void effect(const char*, std::optional<Effect> T::*field) {
    if (setting_.*field) limitFields(*(setting_.*field));
  }
  template <class Item>
  void list(const char*, std::vector<Item> T::*field) {
    for (Item& item : setting_.*field) limitFields(item);
  }

 private:
  static void limit(double& value, double fallback, double lowest, double highest) {
    value = std::isnan(value) ? fallback : std::clamp(value, lowest, highest);
  }
  template <class Inner>
  static void limitFields(Inner& inner) {
    Limiter<Inner> limiter(inner);
    detail::visitFields(limiter, &inner);
  }

  T& setting_;
  const T kDefault{};
};

}  // namespace

Knobs limited(const Knobs& knobs) {
  Knobs result = knobs;
  Limiter<Knobs> limiter(result);
  detail::visitFields(limiter, &result);
  return result;
}

Scene limited(const Scene& scene) {
  Scene result = scene;
  Limiter<Scene> limiter(result);
  detail::visitFields(limiter, &result);
  return result;
}

Scene sceneWithEverything() {
  Scene scene;
  for (const EffectInfo& effect : sceneEffects()) effect.switchTo(scene, true);
  return scene;
}

}  // namespace ew
