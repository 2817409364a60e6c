#pragma once

#include "../effects/registry.h"
#include "ew/core/message.h"
#include "ew/core/word_table.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/scene.h"
#include "ew/imaging/tissue_name.h"

namespace ew::detail {

inline constexpr WordTable<Quality, 3> kQualityWords{{{"weave", Quality::weave}, {"linear", Quality::linear}, {"cubic", Quality::cubic}}};
inline constexpr WordTable<FocusMethod, 2> kFocusMethodWords{
    {{"row_stretch", FocusMethod::rowStretch}, {"lateral_kernel", FocusMethod::lateralKernel}}};
inline constexpr WordTable<GainLaw, 3> kGainLawWords{
    {{"automatic", GainLaw::automatic}, {"decibel", GainLaw::decibel}, {"paper", GainLaw::paper}}};
inline constexpr WordTable<GreyMap, 6> kGreyMapWords{{{"automatic", GreyMap::automatic},
                                                      {"linear", GreyMap::linear},
                                                      {"soft", GreyMap::soft},
                                                      {"contrast", GreyMap::contrast},
                                                      {"bright", GreyMap::bright},
                                                      {"clinical", GreyMap::clinical}}};
inline constexpr WordTable<DisplayMode, 4> kModeWords{
    {{"b", DisplayMode::bMode}, {"m", DisplayMode::mMode}, {"both", DisplayMode::both}, {"spectrum", DisplayMode::spectrum}}};

inline constexpr WordTable<ColourShows, 4> kColourShowsWords{{{"velocity", ColourShows::velocity},
                                                              {"variance", ColourShows::variance},
                                                              {"power", ColourShows::power},
                                                              {"directional_power", ColourShows::directionalPower}}};
inline constexpr WordTable<WallFilterSetting, 3> kWallFilterWords{
    {{"low", WallFilterSetting::low}, {"medium", WallFilterSetting::medium}, {"high", WallFilterSetting::high}}};

inline constexpr double kLargestSteering_deg = 60.0;  // probes allow less

/// What a number of a setting is, in words that are only made for those who ask.
using Meaning = Message (*)();

// Every field of a setting once: its key in files, where it is kept, and what it may be. Reading, writing and limiting are visitors of
// these lists, so that they cannot disagree.

template <class Visitor>
void visitFields(Visitor& field, const ColourDoppler*) {
  field.choice("shows", &ColourDoppler::shows, kColourShowsWords);
  field.number("box_middle", &ColourDoppler::boxMiddle, -1.0, 1.0, say<"the face's -x end to its +x end">);
  field.number("box_width", &ColourDoppler::boxWidth, 0.1, 1.0, say<"share of the face">);
  field.number("box_middle_mm", &ColourDoppler::boxMiddle_mm, 0.0, 1000.0, say<"0 for half of the depth">);
  field.number("box_height_mm", &ColourDoppler::boxHeight_mm, 0.0, 1000.0, say<"0 for two fifths of the depth">);
  field.angle("steering_deg", &ColourDoppler::steering_rad, -20.0, 20.0);
  field.numberOrZero("carrier_hz", &ColourDoppler::carrier_hz, 1e6, 2e7, say<"two thirds of the image's">);
  field.number("prf_hz", &ColourDoppler::prf_hz, 100.0, 20000.0, say<"pulses a second">);
  field.count("packet", &ColourDoppler::packet, 2, kMostPacket);
  field.choice("wall_filter", &ColourDoppler::wallFilter, kWallFilterWords);
  field.number("baseline", &ColourDoppler::baseline, -0.9, 0.9, say<"of the range; 0 is neutral">);
  field.number("gain_db", &ColourDoppler::gain_db, -30.0, 30.0, say<"decibels; 0 is neutral">);
  field.number("priority", &ColourDoppler::priority, 0.0, 1.0, say<"of white: brighter echoes stay grey">);
  field.number("reject", &ColourDoppler::reject, 0.0, 0.5, say<"of the Nyquist velocity: slower blood has no colour">);
  field.number("persistence", &ColourDoppler::persistence, 0.0, 0.95, say<"0 is neutral">);
  field.count("every_line", &ColourDoppler::everyLine, 1, 4);
  field.count("smoothing", &ColourDoppler::smoothing, 0, 3);
  field.flag("invert", &ColourDoppler::invert);
}

template <class Visitor>
void visitFields(Visitor& field, const SpectralDoppler*) {
  field.number("line", &SpectralDoppler::line, -1.0, 1.0, say<"the face's -x end to its +x end">);
  field.number("depth_mm", &SpectralDoppler::depth_mm, 0.0, 1000.0, say<"0 for half of the depth">);
  field.number("gate_mm", &SpectralDoppler::gate_mm, 0.5, 20.0, say<"along the line">);
  field.angle("steering_deg", &SpectralDoppler::steering_rad, -20.0, 20.0);
  field.angle("angle_deg", &SpectralDoppler::angle_rad, -80.0, 80.0);
  field.numberOrZero("carrier_hz", &SpectralDoppler::carrier_hz, 1e6, 2e7, say<"two thirds of the image's">);
  field.number("prf_hz", &SpectralDoppler::prf_hz, 100.0, 52000.0, say<"pulses a second">);
  field.flag("high_prf", &SpectralDoppler::highPrf);
  field.number("baseline", &SpectralDoppler::baseline, -0.9, 0.9, say<"of the range; 0 is neutral">);
  field.number("wall_filter_hz", &SpectralDoppler::wallFilter_hz, 20.0, 1600.0, say<"Doppler shifts below are taken out">);
  field.number("gain_db", &SpectralDoppler::gain_db, -30.0, 30.0, say<"decibels; 0 is neutral">);
  field.number("dynamic_range_db", &SpectralDoppler::dynamicRange_db, 20.0, 80.0, say<"from black to white">);
  field.flag("invert", &SpectralDoppler::invert);
  field.flag("broadens", &SpectralDoppler::broadens);
}

template <class Visitor>
void visitFields(Visitor& field, const Knobs*) {
  field.number("gain", &Knobs::gain, 0.0, 1e6, say<"a factor; 1 is neutral">);
  field.factors("dgc", &Knobs::dgc, 0.0, 1e6);
  field.choice("gain_law", &Knobs::gainLaw, kGainLawWords);
  field.number("gain_db", &Knobs::gain_db, -30.0, 30.0, say<"decibels; 0 is neutral">);
  field.decibels("tgc_db", &Knobs::tgc_db, -20.0, 20.0);
  field.number("depth_mm", &Knobs::depth_mm, 0.0, 1000.0, say<"0 for the probe's own">);
  field.foci("focus_mm", &Knobs::focus_mm, &Knobs::moreFoci_mm, 0.0, 1000.0);
  field.choice("focus_method", &Knobs::focusMethod, kFocusMethodWords);
  field.numberOrZero("carrier_hz", &Knobs::carrier_hz, 1e5, 1e8, say<"the probe's own">);
  field.flag("harmonic", &Knobs::harmonic);
  field.oddCount("compound_angles", &Knobs::compoundAngles, 1, kMostCompoundAngles);
  field.numberOrZero("dynamic_range_db", &Knobs::dynamicRange_db, 20.0, 120.0, say<"the range the volume was recorded with">);
  field.choice("grey_map", &Knobs::greyMap, kGreyMapWords);
  field.number("edge_enhancement", &Knobs::edgeEnhancement, 0.0, 1.0, say<"0 is neutral">);
  field.number("persistence", &Knobs::persistence, 0.0, 0.95, say<"0 is neutral">);
  field.oddCount("elevation_planes", &Knobs::elevationPlanes, 3, 9);
  field.angle("steering_deg", &Knobs::steering_rad, -kLargestSteering_deg, kLargestSteering_deg);
  field.flag("trapezoid", &Knobs::trapezoid);
  field.number("zoom", &Knobs::zoom, 1.0, 8.0, say<"a magnification">);
  field.choice("quality", &Knobs::quality, kQualityWords);
  field.choice("mode", &Knobs::mode, kModeWords);
  field.number("m_line", &Knobs::mLine, -1.0, 1.0, say<"the face's -x end to its +x end">);
  field.number("m_sweep_s", &Knobs::mSweep_s, 1.0, 16.0, say<"seconds across the strip">);
  field.effect("spectral", &Knobs::spectral);
  field.effect("colour", &Knobs::colour);
  field.flag("marker_left", &Knobs::markerLeft);
  field.flag("upside_down", &Knobs::upsideDown);
}

template <class Visitor>
void visitFields(Visitor& field, const LiveEchoesEffect*) {
  field.count("looks", &LiveEchoesEffect::looks, 1, 5);
  field.number("pulse_cycles", &LiveEchoesEffect::pulseCycles, 0.5, 6.0, say<"of the carrier">);
  field.number("scatterers_per_cell", &LiveEchoesEffect::scatterersPerCell, 1.0, 10.0, say<"in the smallest resolution cell">);
  field.number("samples_per_pulse", &LiveEchoesEffect::samplesPerPulse, 3.0, 10.0, say<"along a line">);
  field.number("reach", &LiveEchoesEffect::reach, 1.0, 3.0, say<"of the slice, in standard deviations">);
  field.number("aperture_share", &LiveEchoesEffect::apertureShare, 0.2, 1.0, say<"of the probe's widest aperture">);
  field.number("receive_f_number", &LiveEchoesEffect::receiveFNumber, 1.0, 4.0, say<"depth over aperture, near the face">);
  field.number("line_filter_width", &LiveEchoesEffect::lineFilterWidth, 1.0, 3.0, say<"1 without a filter across lines">);
  field.number("line_average", &LiveEchoesEffect::lineAverage, 0.0, 0.3, say<"of each neighbouring line">);
  field.number("gain_db", &LiveEchoesEffect::gain_db, -30.0, 30.0, say<"decibels; 0 is neutral">);
  field.number("texture_db", &LiveEchoesEffect::texture_db, 0.0, 6.0, say<"scatter of the scatterers' strength">);
  field.number("fragments_per_cm3", &LiveEchoesEffect::fragmentsPerCm3, 0.0, 37.0, say<"little walls of all directions">);
  field.number("fragment_db", &LiveEchoesEffect::fragment_db, -20.0, 40.0, say<"above the tissue around them">);
  field.number("speckle_reduction", &LiveEchoesEffect::speckleReduction, 0.0, 0.8, say<"0 without a filter of speckle">);
  field.number("haze_db", &LiveEchoesEffect::haze_db, -80.0, -10.0, say<"below the echoes beside a line">);
  field.number("own_grain", &LiveEchoesEffect::ownGrain, 0.0, 1.0, say<"of a recorded volume; 0 forms all grain anew">);
}

template <class Visitor>
void visitFields(Visitor& field, const FocusEffect*) {
  field.number("strength", &FocusEffect::strength, 0.0, 3.0, say<"1 as physics has it">);
}

template <class Visitor>
void visitFields(Visitor& field, const SliceThicknessEffect*) {
  field.number("scale", &SliceThicknessEffect::scale, 0.1, 4.0, say<"of the probe's own thickness">);
}

template <class Visitor>
void visitFields(Visitor& field, const AttenuationEffect*) {
  field.number("expected_db_per_cm_mhz", &AttenuationEffect::expected_dbPerCmMhz, 0.0, 3.0, say<"what the machine compensates">);
  field.number("interface_level", &AttenuationEffect::interfaceLevel, 1.0, 256.0, say<"grey levels from here on reflect">);
  field.number("interface_db_per_mm", &AttenuationEffect::interface_dbPerMm, 0.0, 60.0, say<"lost in them">);
  field.number("fluid_level", &AttenuationEffect::fluidLevel, 0.0, 255.0, say<"grey levels up to here take nothing">);
  field.number("largest_enhancement_db", &AttenuationEffect::largestEnhancement_db, 0.0, 60.0, say<"where the amplifier ends">);
}

template <class Visitor>
void visitFields(Visitor& field, const ReverberationEffect*) {
  field.number("interface_level", &ReverberationEffect::interfaceLevel, 1.0, 256.0, say<"grey levels from here on are strong interfaces">);
  field.number("loss_db_per_bounce", &ReverberationEffect::loss_dbPerBounce, 0.0, 60.0, say<"there and back">);
  field.count("bounces", &ReverberationEffect::bounces, 1, 6);
  field.flag("mirror", &ReverberationEffect::mirror);
  field.number("mirror_loss_db", &ReverberationEffect::mirrorLoss_db, 0.0, 60.0, say<"of mirror images">);
  field.number("ring_down_db", &ReverberationEffect::ringDown_db, -60.0, 20.0, say<"of live gas, below its front; -60 is none">);
  field.number("ring_down_fall_db_per_mm", &ReverberationEffect::ringDownFall_dbPerMm, 0.05, 10.0, say<"with depth">);
  field.number("clutter_db", &ReverberationEffect::clutter_db, -60.0, 0.0, say<"of live layers, copied deeper; -60 is none">);
  field.number("shadow_haze_db", &ReverberationEffect::shadowHaze_db, -60.0, 0.0, say<"of live echoes, what fills shadows; -60 is none">);
}

template <class Visitor>
void visitFields(Visitor& field, const NoiseEffect*) {
  field.number("at_face_db", &NoiseEffect::atFace_db, -150.0, 0.0, say<"below full white">);
  field.number("growth_db_per_cm_mhz", &NoiseEffect::growth_dbPerCmMhz, 0.0, 3.0, say<"with depth">);
  field.number("largest_db", &NoiseEffect::largest_db, -150.0, 0.0, say<"where the compensation ends">);
}

template <class Visitor>
void visitFields(Visitor& field, const ContactEffect*) {
  field.number("gel_mm", &ContactEffect::gel_mm, 0.0, 50.0, say<"gaps that gel fills">);
  field.number("ring_down_mm", &ContactEffect::ringDown_mm, 0.5, 100.0, say<"length of the lines under air">);
}

template <class Visitor>
void visitFields(Visitor& field, const MotionEffect*) {
  field.number("strength", &MotionEffect::strength, 0.0, 1.0, say<"of the patient's own motion">);
}

template <class Visitor>
void visitFields(Visitor& field, const TissueAcoustics*) {
  field.count("label", &TissueAcoustics::label, 0, 255);
  field.text("name", &TissueAcoustics::name, kLongestTissueName_bytes);
  field.number("attenuation_db_per_cm_mhz", &TissueAcoustics::attenuation_dbPerCmMhz, 0.0, 100.0, say<"one way">);
  field.number("reflection_db", &TissueAcoustics::reflection_db, 0.0, 100.0, say<"lost on entering">);
  field.number("impedance_mrayl", &TissueAcoustics::impedance_mrayl, 0.0, 20.0, say<"below 0.05 gas, below 0.5 lung">);
}

template <class Visitor>
void visitEffect(Visitor& field, const PlainEffect& effect) {
  field.flag(effect.texts.key, effect.field);
}

template <class Visitor, class Effect>
void visitEffect(Visitor& field, const EffectOf<Effect>& effect) {
  field.effect(effect.texts.key, effect.field);
}

template <class Visitor>
void visitFields(Visitor& field, const Scene*) {
  std::apply([&](const auto&... effect) { (visitEffect(field, effect), ...); }, kSceneEffects);
  field.number("recorded_dynamic_range_db", &Scene::recordedDynamicRange_db, 20.0, 120.0, say<"what grey 0 to 255 spans">);
  field.list("tissues", &Scene::tissues);
}

}  // namespace ew::detail
