#pragma once

#include <optional>
#include <tuple>

#include "ew/core/translatable.h"
#include "ew/imaging/scene.h"

namespace ew::detail {

/// Texts, key and key stroke of an effect or of a part of one (effect_info.h).
struct EffectTexts {
  const char *key, *name, *shortName, *tip, *keyStroke;
};

/// The slider of an effect; numbers in the unit of `field` (effect_info.h).
template <class Effect>
struct StrengthOf {
  double Effect::*field;
  const char *tip, *pattern;
  double shownFactor;
  int decimals;
  double lowest, highest, step, page;
};

template <class Effect>
struct OptionOf {
  bool Effect::*field;
  EffectTexts texts;
};

/// An effect that a scene has or does not have.
template <class Effect>
struct EffectOf {
  std::optional<Effect> Scene::*field;
  EffectTexts texts;
  StrengthOf<Effect> strength;
  std::optional<OptionOf<Effect>> option = std::nullopt;
};

/// An effect without parameters.
struct PlainEffect {
  bool Scene::*field;
  EffectTexts texts;
};

/// Every effect once. Reading, writing and limiting scenes (settings_fields.h), and all who offer, name or switch effects (effect_info.h),
/// go through this list; what an effect does to a frame is in plan.cpp and beam_path.cpp.
inline constexpr std::tuple kSceneEffects{
    PlainEffect{&Scene::gainAndDgc,
                {"gain_and_dgc", EW_TRANSLATE_NOOP("ew::EffectInfo", "Gain and TGC"), EW_TRANSLATE_NOOP("ew::EffectInfo", "gain and TGC"),
                 EW_TRANSLATE_NOOP("ew::EffectInfo", "Gain and depth compensation act on the image"), ""}},
    EffectOf<LiveEchoesEffect>{
        &Scene::liveEchoes,
        {"live_echoes", EW_TRANSLATE_NOOP("ew::EffectInfo", "Live echoes"), EW_TRANSLATE_NOOP("ew::EffectInfo", "live echoes"),
         EW_TRANSLATE_NOOP("ew::EffectInfo", "Speckle is formed anew for every image, where the tissue is known"), "Shift+F2"},
        {&LiveEchoesEffect::haze_db, EW_TRANSLATE_NOOP("ew::EffectInfo", "Side lobes: what echoes beside a line add to it"),
         EW_TRANSLATE_NOOP("ew::EffectInfo", "−%1 dB"), -1.0, 0, -80.0, -10.0, 1.0, 5.0}},
    EffectOf<FocusEffect>{
        &Scene::focus,
        {"focus", EW_TRANSLATE_NOOP("ew::EffectInfo", "Beam width and focus"), EW_TRANSLATE_NOOP("ew::EffectInfo", "beam width"),
         EW_TRANSLATE_NOOP("ew::EffectInfo", "The beam is narrow at the focus and wide elsewhere"), "F2"},
        {&FocusEffect::strength, EW_TRANSLATE_NOOP("ew::EffectInfo", "How much wider than recorded the beam is away from its focus"),
         EW_TRANSLATE_NOOP("ew::EffectInfo", "%1 %"), 100.0, 0, 0.0, 3.0, 0.01, 0.25}},
    EffectOf<SliceThicknessEffect>{
        &Scene::sliceThickness,
        {"slice_thickness", EW_TRANSLATE_NOOP("ew::EffectInfo", "Slice thickness"), EW_TRANSLATE_NOOP("ew::EffectInfo", "slice thickness"),
         EW_TRANSLATE_NOOP("ew::EffectInfo", "The image is an average over the thickness of the beam"), "F3"},
        {&SliceThicknessEffect::scale, EW_TRANSLATE_NOOP("ew::EffectInfo", "Thickness of the slice, as a multiple of the probe's own"),
         EW_TRANSLATE_NOOP("ew::EffectInfo", "%1 x"), 1.0, 1, 0.1, 4.0, 0.1, 0.5}},
    EffectOf<AttenuationEffect>{
        &Scene::attenuation,
        {"attenuation", EW_TRANSLATE_NOOP("ew::EffectInfo", "Shadow and enhancement"),
         EW_TRANSLATE_NOOP("ew::EffectInfo", "shadow and enhancement"),
         EW_TRANSLATE_NOOP("ew::EffectInfo", "Dark behind stone, bone and gas, bright behind fluid"), "F4"},
        {&AttenuationEffect::interface_dbPerMm,
         EW_TRANSLATE_NOOP("ew::EffectInfo", "What each millimetre of strong echoes takes from the sound behind it"),
         EW_TRANSLATE_NOOP("ew::EffectInfo", "%1 dB/mm"), 1.0, 1, 0.0, 20.0, 0.5, 1.0}},
    EffectOf<ReverberationEffect>{
        &Scene::reverberation,
        {"reverberation", EW_TRANSLATE_NOOP("ew::EffectInfo", "Reverberation"), EW_TRANSLATE_NOOP("ew::EffectInfo", "reverberation"),
         EW_TRANSLATE_NOOP("ew::EffectInfo", "Echoes repeated between the face and strong interfaces"), "F5"},
        {&ReverberationEffect::loss_dbPerBounce, EW_TRANSLATE_NOOP("ew::EffectInfo", "What the sound loses on each way there and back"),
         EW_TRANSLATE_NOOP("ew::EffectInfo", "−%1 dB"), 1.0, 0, 3.0, 40.0, 1.0, 3.0},
        OptionOf<ReverberationEffect>{
            &ReverberationEffect::mirror,
            {"mirror", EW_TRANSLATE_NOOP("ew::EffectInfo", "Mirror images"), EW_TRANSLATE_NOOP("ew::EffectInfo", "mirror images"),
             EW_TRANSLATE_NOOP("ew::EffectInfo", "Mirror images beyond smooth strong interfaces"), "F6"}}},
    EffectOf<NoiseEffect>{
        &Scene::noise,
        {"noise", EW_TRANSLATE_NOOP("ew::EffectInfo", "Electronic noise"), EW_TRANSLATE_NOOP("ew::EffectInfo", "noise"),
         EW_TRANSLATE_NOOP("ew::EffectInfo", "Noise of the amplifier, which depth compensation lifts"), "F7"},
        {&NoiseEffect::atFace_db, EW_TRANSLATE_NOOP("ew::EffectInfo", "Noise at the face, below full white; it grows with depth"),
         EW_TRANSLATE_NOOP("ew::EffectInfo", "−%1 dB"), -1.0, 0, -120.0, -60.0, 1.0, 5.0}},
    EffectOf<ContactEffect>{
        &Scene::contact,
        {"contact", EW_TRANSLATE_NOOP("ew::EffectInfo", "Skin contact"), EW_TRANSLATE_NOOP("ew::EffectInfo", "skin contact"),
         EW_TRANSLATE_NOOP("ew::EffectInfo", "Where the face is off the skin the image goes dark and rings down"), "F8"},
        {&ContactEffect::gel_mm, EW_TRANSLATE_NOOP("ew::EffectInfo", "Gaps up to here are filled by gel"),
         EW_TRANSLATE_NOOP("ew::EffectInfo", "%1 mm"), 1.0, 1, 0.0, 10.0, 0.5, 1.0}},
    EffectOf<MotionEffect>{
        &Scene::motion,
        {"motion", EW_TRANSLATE_NOOP("ew::EffectInfo", "Motion of the body"), EW_TRANSLATE_NOOP("ew::EffectInfo", "motion"),
         EW_TRANSLATE_NOOP("ew::EffectInfo", "The patient breathes, the pulse beats and the bowel moves"), "Shift+F4"},
        {&MotionEffect::strength, EW_TRANSLATE_NOOP("ew::EffectInfo", "How far tissue moves, of what the patient's own motion is"),
         EW_TRANSLATE_NOOP("ew::EffectInfo", "%1 %"), 100.0, 0, 0.0, 1.0, 0.05, 0.25}},
};

}  // namespace ew::detail
