#include "ew/imaging/effect_info.h"

#include <array>
#include <cstddef>
#include <utility>

#include "registry.h"

namespace ew {
namespace {

template <std::size_t N>
inline constexpr const auto& kEffectAt = std::get<N>(detail::kSceneEffects);

template <std::size_t N, class Effect>
EffectStrength strengthAt(const detail::EffectOf<Effect>& effect) {
  const auto& s = effect.strength;
  return {s.tip,
          s.pattern,
          s.shownFactor,
          s.decimals,
          s.lowest,
          s.highest,
          s.step,
          s.page,
          [](const Scene& scene) { return (*(scene.*kEffectAt<N>.field)).*kEffectAt<N>.strength.field; },
          [](Scene& scene, double value) {
            if (auto& effectOfScene = scene.*kEffectAt<N>.field) (*effectOfScene).*kEffectAt<N>.strength.field = value;
          }};
}

template <std::size_t N, class Effect>
std::optional<EffectOption> optionAt(const detail::EffectOf<Effect>& effect) {
  if (!effect.option) return std::nullopt;
  const detail::EffectTexts& t = effect.option->texts;
  return EffectOption{t.key,
                      t.name,
                      t.shortName,
                      t.tip,
                      t.keyStroke,
                      [](const Scene& scene) {
                        const auto& present = scene.*kEffectAt<N>.field;
                        return present && (*present).*(kEffectAt<N>.option->field);
                      },
                      [](Scene& scene, bool on) {
                        if (auto& present = scene.*kEffectAt<N>.field) (*present).*(kEffectAt<N>.option->field) = on;
                      }};
}

template <std::size_t N>
void copyAt(const Scene& from, Scene& to) {
  to.*kEffectAt<N>.field = from.*kEffectAt<N>.field;
}

template <std::size_t N, class Effect>
EffectInfo infoAt(const detail::EffectOf<Effect>& effect) {
  const detail::EffectTexts& t = effect.texts;
  return {t.key,
          t.name,
          t.shortName,
          t.tip,
          t.keyStroke,
          [](const Scene& scene) { return (scene.*kEffectAt<N>.field).has_value(); },
          [](Scene& scene, bool on) {
            auto& present = scene.*kEffectAt<N>.field;
            if (!on)
              present.reset();
            else if (!present)
              present.emplace();
          },
          copyAt<N>,
          strengthAt<N>(effect),
          optionAt<N>(effect)};
}

template <std::size_t N>
EffectInfo infoAt(const detail::PlainEffect& effect) {
  const detail::EffectTexts& t = effect.texts;
  return {t.key,
          t.name,
          t.shortName,
          t.tip,
          t.keyStroke,
          [](const Scene& scene) { return scene.*kEffectAt<N>.field; },
          [](Scene& scene, bool on) { scene.*kEffectAt<N>.field = on; },
          copyAt<N>,
          std::nullopt,
          std::nullopt};
}

}  // namespace

std::span<const EffectInfo> sceneEffects() {
  static const auto infos = []<std::size_t... N>(std::index_sequence<N...>) { return std::array{infoAt<N>(kEffectAt<N>)...}; }
  (std::make_index_sequence<std::tuple_size_v<decltype(detail::kSceneEffects)>>());
  return infos;
}

}  // namespace ew
