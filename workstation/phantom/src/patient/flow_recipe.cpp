#include "patient/flow_recipe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "ew/core/figures.h"
#include "ew/core/numbers.h"
#include "shapes/vessel_tree.h"

namespace ew::phantom {
namespace {

constexpr std::size_t kMostWaves = 50, kMostStreams = 100, kMostSamples = 400;
constexpr int kMostHarmonics = 16;
constexpr double kMostNodes = 200000.0;  // of all streams: 200 m at steps of 1 mm
constexpr double kSlowestWave_mmPerS = 500.0;
constexpr int kMostTogether = 2000;                // streams, with the branches of trees
constexpr double kFlowOfMlPerMin = 1000.0 / 60.0;  // mm^3/s
constexpr double kStep_mm = 1.0;                   // between nodes of a stream
constexpr double kStepsOfStenosis = 32.0;          // within its length
constexpr double kThroatJet = 0.95;                // a blunt profile in the throat itself
constexpr double kLeastNarrowing = 0.1;            // of the diameter: below it no jet leaves the wall
constexpr double kMostLost = 0.95;

enum class RelativeTo { mean, peak };
constexpr std::array<std::pair<const char*, RelativeTo>, 2> kRelativeWords{{{"mean", RelativeTo::mean}, {"peak", RelativeTo::peak}}};

/// By steps fine enough for harmonics.
double largestOf(const FlowWave& wave) {
  double largest = 0.0;
  constexpr int kSteps = 512;
  for (int n = 0; n < kSteps; ++n) largest = std::max(largest, std::abs(flowAtPhase(wave, static_cast<double>(n) / kSteps)));
  return largest;
}

FlowWave scaled(FlowWave wave, double by) {
  wave.mean *= by;
  for (auto& harmonic : wave.harmonics) harmonic *= by;
  return wave;
}

FlowWave added(FlowWave wave, const FlowWave& more) {
  wave.mean += more.mean;
  wave.harmonics.resize(std::max(wave.harmonics.size(), more.harmonics.size()));
  for (std::size_t n = 0; n < more.harmonics.size(); ++n) wave.harmonics[n] += more.harmonics[n];
  return wave;
}

FlowWave readWave(const JsonFields& entry) {
  entry.only({"samples", "harmonics", "mean", "relative_to"});
  const bool isSampled = entry.has("samples");
  if (isSampled == entry.has("harmonics")) {
    entry.refuseWhole(isSampled ? say<"with both samples and harmonics">() : say<"without samples or harmonics">(),
                      say<"one of the two">());
    return {};
  }
  FlowWave wave;
  if (isSampled && entry.has("mean")) entry.refuse("mean", say<"left out beside samples, which have their own">());
  if (isSampled) {
    wave = waveThrough(entry.numbers("samples", 4, kMostSamples, -1e6, 1e6), kMostHarmonics);
  } else {
    wave.mean = entry.number("mean", -1e6, 1e6, 1.0);
    std::size_t place = 0;
    for (const nlohmann::json& pair : entry.list("harmonics", 1, kMostHarmonics, say<"a list of at most %1 harmonics">(kMostHarmonics))) {
      const auto number = [&](std::size_t n) {
        return pair.is_array() && pair.size() == 2 ? numberWithin(pair[n], -1e6, 1e6) : std::nullopt;
      };
      const auto amplitude = number(0), phase_deg = number(1);
      if (!amplitude || !phase_deg) {
        entry.refuse("harmonics[" + std::to_string(place) + "]", shown(pair), say<"an amplitude and a phase in degrees">());
        return {};
      }
      wave.harmonics.push_back(std::polar(*amplitude, *phase_deg * std::numbers::pi / 180.0));
      ++place;
    }
  }
  const RelativeTo relativeTo = entry.word("relative_to", kRelativeWords, std::optional(RelativeTo::mean));
  if (!entry.good()) return {};
  const double unit = relativeTo == RelativeTo::mean ? wave.mean : largestOf(wave);
  const double least = 1e-3 * largestOf(wave);
  if (!(std::abs(unit) > least) || !(least > 0.0)) {
    entry.refuseWhole(say<"a wave that on the whole flows nowhere">(),
                      say<"one with a mean, or \"relative_to\": \"peak\" for a flow to and fro">());
    return {};
  }
  return scaled(std::move(wave), 1.0 / unit);
}

using Line = std::vector<glm::dvec4>;

struct LineFoot {
  double away_mm = 1e300;
  double at = 0.0;  ///< nodes from the first
};

LineFoot nearestOn(const Line& line, const glm::dvec3& p_mm) {
  LineFoot nearest;
  for (std::size_t n = 0; n + 1 < line.size(); ++n) {
    const glm::dvec3 a(line[n]), way = glm::dvec3(line[n + 1]) - a;
    const double length2 = glm::dot(way, way);
    const double share = length2 > 0.0 ? std::clamp(glm::dot(p_mm - a, way) / length2, 0.0, 1.0) : 0.0;
    const double away_mm = glm::distance(p_mm, a + share * way);
    if (away_mm < nearest.away_mm) nearest = {away_mm, static_cast<double>(n) + share};
  }
  return nearest;
}

glm::dvec4 placeOn(const Line& line, double at) {
  const std::size_t n = std::min(static_cast<std::size_t>(at), line.size() - 2);
  return glm::mix(line[n], line[n + 1], at - static_cast<double>(n));
}

/// The part of a line between two places of it, in the direction from the one to the other.
Line between(const Line& line, double from, double to) {
  const double first = std::min(from, to), last = std::max(from, to);
  Line part{placeOn(line, first)};
  for (std::size_t n = static_cast<std::size_t>(first) + 1; static_cast<double>(n) < last; ++n) part.push_back(line[n]);
  part.push_back(placeOn(line, last));
  if (from > to) std::reverse(part.begin(), part.end());
  return part;
}

double lengthOf_mm(const Line& line) {
  double length_mm = 0.0;
  for (std::size_t n = 1; n < line.size(); ++n) length_mm += glm::distance(glm::dvec3(line[n - 1]), glm::dvec3(line[n]));
  return length_mm;
}

/// A place at every step along a line, with the length up to it.
struct Step {
  glm::dvec4 place_mm;
  double at_mm;
};
std::vector<Step> stepsAlong(const Line& line, double step_mm) {
  std::vector<Step> steps;
  double done_mm = 0.0;
  for (std::size_t n = 0; n + 1 < line.size(); ++n) {
    const double length_mm = glm::distance(glm::dvec3(line[n]), glm::dvec3(line[n + 1]));
    const int pieces = std::max(1, static_cast<int>(std::ceil(length_mm / step_mm)));
    for (int piece = 0; piece < pieces; ++piece) {
      const double share = static_cast<double>(piece) / pieces;
      steps.push_back({glm::mix(line[n], line[n + 1], share), done_mm + share * length_mm});
    }
    done_mm += length_mm;
  }
  steps.push_back({line.back(), done_mm});
  return steps;
}

struct StenosisRecipe {
  glm::dvec3 at_mm{0.0}, shift_mm{0.0};
  double length_mm = 10.0, lost = 0.5, jet_diameters = 7.0, backflow = 0.1, turbulence = 0.15;
  std::optional<double> peak_mmPerS;
};

StenosisRecipe readStenosis(const JsonFields& entry) {
  StenosisRecipe stenosis;
  entry.only({"at_mm", "length_mm", "diameter_lost", "shift_mm", "peak_cm_per_s", "jet_diameters", "backflow", "turbulence"});
  if (!entry.good()) return stenosis;
  stenosis.at_mm = entry.point("at_mm", kFarthest_mm);
  stenosis.length_mm = entry.number("length_mm", 1.0, 200.0, 10.0);
  stenosis.lost = entry.number("diameter_lost", 0.0, kMostLost);
  stenosis.shift_mm = entry.point("shift_mm", 50.0, glm::dvec3(0.0));
  if (entry.has("peak_cm_per_s")) stenosis.peak_mmPerS = 10.0 * entry.number("peak_cm_per_s", 1.0, 1000.0);
  stenosis.jet_diameters = entry.number("jet_diameters", 0.5, 20.0, 7.0);
  stenosis.backflow = entry.number("backflow", 0.0, 0.5, 0.1);
  stenosis.turbulence = entry.number("turbulence", 0.0, 1.0, 0.15);
  return stenosis;
}

/// What a stenosis makes of a stream: narrower, and with a jet that goes on behind it.
class StenosisShape {
 public:
  /// @param stream with its flow and wave; blood goes against the line where its flow is below 0
  StenosisShape(const StenosisRecipe& recipe, const FlowStream& stream, const Line& line)
      : recipe_(recipe), downstream_(stream.flow_mm3PerS < 0.0 ? -1.0 : 1.0), lostToFlow_(recipe.lost) {
    at_ = nearestOn(line, recipe.at_mm).at;
    const glm::dvec4 throat = placeOn(line, at_);
    place_mm_ = glm::dvec3(throat);
    radius_mm_ = throat.w;
    at_mm_ = lengthOf_mm(between(line, 0.0, at_));
    const double greatest_mm3PerS = std::abs(stream.flow_mm3PerS) * largestOf(stream.wave), overMean = axisOverMean(kThroatJet, 0.0);
    if (recipe.peak_mmPerS)
      lostToFlow_ = 1.0 - std::sqrt(overMean * greatest_mm3PerS / (std::numbers::pi * *recipe.peak_mmPerS)) / radius_mm_;
    peak_mmPerS_ = overMean * greatest_mm3PerS / (std::numbers::pi * std::pow(radius_mm_ * (1.0 - lostToFlow_), 2.0));
  }
  [[nodiscard]] double at() const { return at_; }  ///< nodes of the line, from the first
  [[nodiscard]] double lostToFlow() const { return lostToFlow_; }
  [[nodiscard]] double peak_mmPerS() const { return peak_mmPerS_; }
  [[nodiscard]] double radius_mm() const { return radius_mm_; }  ///< of the vessel, as if nothing were narrow
  [[nodiscard]] const glm::dvec3& place_mm() const { return place_mm_; }

  [[nodiscard]] FlowNode nodeAt(const Step& step) const {
    const double past_mm = downstream_ * (step.at_mm - at_mm_), half_mm = 0.5 * recipe_.length_mm;
    const double narrow = std::abs(past_mm) < half_mm ? 0.5 + 0.5 * std::cos(std::numbers::pi * past_mm / half_mm) : 0.0;
    FlowNode node;
    node.place_mm = glm::dvec3(step.place_mm) + narrow * recipe_.shift_mm;
    node.radius_mm = step.place_mm.w * (1.0 - lostToFlow_ * narrow);
    const bool hasJet = lostToFlow_ >= kLeastNarrowing;
    if (past_mm < 0.0 || !hasJet) {  // the profile goes flat on the way in; without a jet it is itself again on the way out
      const double t = std::clamp(1.0 - std::abs(past_mm) / half_mm, 0.0, 1.0);
      node.jet = 1.0 - (1.0 - kThroatJet) * t * t * (3.0 - 2.0 * t);
      return node;
    }
    const double reach_mm = 2.0 * radius_mm_ * recipe_.jet_diameters, throat_mm = radius_mm_ * (1.0 - lostToFlow_);
    const double jet_mm = throat_mm + std::min(past_mm / reach_mm, 1.0) * (radius_mm_ - throat_mm);
    // Behind the reach what is left of the jet gives way to the undisturbed profile.
    const double most = std::min(1.0, kThroatJet + (1.0 - kThroatJet) * std::max(0.0, past_mm / reach_mm - 1.0));
    node.jet = std::min(jet_mm / node.radius_mm, most);
    node.backflow = recipe_.backflow * std::clamp((0.9 - node.jet) / std::max(lostToFlow_ - 0.1, 0.05), 0.0, 1.0);
    // Eddies are strongest a few diameters behind the throat.
    const double eddies = (past_mm / (2.0 * radius_mm_) - 3.0) / 2.5, risen = std::clamp(past_mm / (2.0 * radius_mm_), 0.0, 1.0);
    node.turbulence = recipe_.turbulence * risen * std::exp(-eddies * eddies);
    return node;
  }

 private:
  const StenosisRecipe& recipe_;
  double downstream_;
  glm::dvec3 place_mm_{0.0};
  double at_ = 0.0, radius_mm_ = 1.0, at_mm_ = 0.0, lostToFlow_, peak_mmPerS_ = 0.0;
};

/// One entry of "streams", as it stands there.
struct StreamRecipe {
  JsonFields entry;
  FlowStream stream;
  Line line;
  const VesselTree* tree = nullptr;
  const std::vector<CentreLine>* branches = nullptr;  ///< of the tree
  bool towardsRoots = false;
  std::vector<std::string> feeds;
  std::optional<StenosisRecipe> stenosis;

  [[nodiscard]] glm::dvec3 begin_mm() const { return glm::dvec3(tree ? branches->front().points_mm.front() : line.front()); }
  [[nodiscard]] glm::dvec3 end_mm() const { return glm::dvec3(line.back()); }  ///< of a tube
};

enum class TreeWay { toTheEnds, toTheRoots };
constexpr std::array<std::pair<const char*, TreeWay>, 2> kTreeWords{
    {{"to the ends", TreeWay::toTheEnds}, {"to the roots", TreeWay::toTheRoots}}};

class FlowReading {
 public:
  FlowReading(const JsonFields& flow, const ShapesByName& shapes, const BodyRhythms& rhythms) : flow_(flow), shapes_(shapes) {
    made_.field.rhythms = rhythms;
  }
  [[nodiscard]] Flow read();

 private:
  void readWaves();
  void readStream(const JsonFields& entry);
  void readLine(StreamRecipe& recipe);
  void feedParents();
  void sumOf(StreamRecipe& parent, std::vector<std::size_t>& above);
  [[nodiscard]] StreamRecipe* named(const std::string& name);
  void addStream(StreamRecipe& recipe);
  void addTree(const StreamRecipe& recipe);

  const JsonFields& flow_;
  const ShapesByName& shapes_;
  std::map<std::string, FlowWave> waves_;
  std::vector<StreamRecipe> recipes_;
  std::vector<char> isSummed_;
  double nodes_ = 0.0;  ///< of all streams so far
  Flow made_;
};

void FlowReading::readWaves() {
  for (const JsonFields& entry : flow_.objects("waves", 0, kMostWaves)) {
    const std::string name = entry.text("name");
    const JsonFields called = entry.called(entry.place() + " (" + name.substr(0, 60) + ")");
    if (waves_.contains(name)) called.refuse("name", say<"a name of its own">());
    waves_[name] = readWave(called);
  }
}

void FlowReading::readLine(StreamRecipe& recipe) {
  const JsonFields& entry = recipe.entry;
  const std::string name = entry.text("of");
  const auto found = shapes_.find(name);
  const Shape* shape = found == shapes_.end() ? nullptr : found->second.get();
  if (shape && shape->vessels() && shape->branchLines()) {
    recipe.tree = shape->vessels();
    recipe.branches = shape->branchLines();
    for (const char* field : {"from_mm", "to_mm", "stenosis", "feeds"})
      if (entry.has(field)) entry.refuse(field, say<"left out for a tree of vessels">());
    recipe.towardsRoots = entry.word("way", kTreeWords, std::optional(TreeWay::toTheEnds)) == TreeWay::toTheRoots;
    return;
  }
  if (entry.has("way")) entry.refuse("way", say<"left out for a tube: from_mm and to_mm say which way blood goes">());
  if (shape && shape->centreLine()) recipe.line = shape->centreLine()->points_mm;
  if (recipe.line.size() < 2) {
    entry.refuse("of", verbatim('"' + name + '"'), say<"the name of a shape or organ that is a tube, or a tree of vessels">());
    return;
  }
  double from = 0.0, to = static_cast<double>(recipe.line.size() - 1);
  for (const auto& [field, at] : {std::pair{"from_mm", &from}, std::pair{"to_mm", &to}}) {
    if (!entry.has(field)) continue;
    const LineFoot nearest = nearestOn(recipe.line, entry.point(field, kFarthest_mm));
    const double radius_mm = placeOn(recipe.line, nearest.at).w;
    if (entry.good() && nearest.away_mm > radius_mm)
      entry.refuse(field, say<"%1 mm from the middle of the tube">(fixedText(nearest.away_mm, 1)), say<"a place inside of it">());
    *at = nearest.at;
  }
  if (!entry.good()) return;
  if (!(std::abs(to - from) > 1e-6)) return entry.refuse("to_mm", say<"another place than from_mm">());
  recipe.line = between(recipe.line, from, to);
}

void FlowReading::readStream(const JsonFields& entry) {
  entry.only({"of", "way", "from_mm", "to_mm", "flow_ml_per_min", "wave", "bluntness", "pulse_wave_m_per_s", "delay_s", "breath", "feeds",
              "stenosis"});
  if (!entry.good()) return;
  StreamRecipe recipe{.entry = entry.called(entry.place() + " (" + entry.text("name").substr(0, 60) + ")"),
                      .stream = {},
                      .line = {},
                      .tree = nullptr,
                      .branches = nullptr,
                      .towardsRoots = false,
                      .feeds = {},
                      .stenosis = {}};
  const JsonFields& fields = recipe.entry;
  FlowStream& stream = recipe.stream;
  stream.name = fields.text("name");
  if (named(stream.name)) fields.refuse("name", say<"a name of its own">());
  recipe.feeds = fields.texts("feeds", 0, 10);
  if (recipe.feeds.empty()) {
    stream.flow_mm3PerS = kFlowOfMlPerMin * fields.number("flow_ml_per_min", -30000.0, 30000.0);
    if (fields.has("wave")) {
      const std::string wave = fields.text("wave");
      const auto known = waves_.find(wave);
      if (known == waves_.end())
        fields.refuse("wave", verbatim('"' + wave + '"'), say<"the name of one of the waves">());
      else if (!made_.field.rhythms.pulse)
        fields.refuse("wave", say<"in a recipe whose motion has no pulse">(), say<"left out, or a pulse described under motion">());
      else
        stream.wave = known->second;
    }
    stream.breathShare = fields.number("breath", -1.0, 1.0, 0.0);
    if (stream.breathShare != 0.0 && !made_.field.rhythms.breathing)
      fields.refuse("breath", say<"in a recipe whose motion has no breathing">(), say<"left out, or breathing described under motion">());
  } else {
    for (const char* field : {"flow_ml_per_min", "wave", "breath"})
      if (fields.has(field)) fields.refuse(field, say<"left out in a stream that feeds others: it carries what they do">());
  }
  stream.bluntness = fields.number("bluntness", 2.0, 50.0, 2.0);
  stream.pulseWave_mmPerS = 1000.0 * fields.number("pulse_wave_m_per_s", 0.0, 30.0, 0.0);
  if (stream.pulseWave_mmPerS > 0.0 && stream.pulseWave_mmPerS < kSlowestWave_mmPerS)
    fields.refuse("pulse_wave_m_per_s", say<"0 (everywhere at once) or a number from %1 to 30">(textOf(1e-3 * kSlowestWave_mmPerS)));
  stream.delay_s = fields.number("delay_s", -1.0, 1.0, 0.0);
  readLine(recipe);
  if (fields.has("stenosis")) recipe.stenosis = readStenosis(fields.object("stenosis"));
  if (fields.good()) recipes_.push_back(std::move(recipe));
}

StreamRecipe* FlowReading::named(const std::string& name) {
  const auto found = std::find_if(recipes_.begin(), recipes_.end(), [&](const StreamRecipe& each) { return each.stream.name == name; });
  return found == recipes_.end() ? nullptr : &*found;
}

/// A parent carries what its children do, each wave at the time it leaves the parent: children's delays follow from its own.
void FlowReading::sumOf(StreamRecipe& parent, std::vector<std::size_t>& above) {
  const auto index = static_cast<std::size_t>(&parent - recipes_.data());
  if (isSummed_[index] || parent.feeds.empty()) return;
  if (std::find(above.begin(), above.end(), index) != above.end())
    return parent.entry.refuse("feeds", say<"streams that do not feed one another in a circle">());
  above.push_back(index);
  FlowWave sum{.mean = 0.0};
  double mean_mm3PerS = 0.0;
  std::optional<double> breathShare;  // of the first, and so of all
  for (const std::string& name : parent.feeds) {
    StreamRecipe* child = named(name);
    if (!child) return parent.entry.refuse("feeds", verbatim('"' + name + '"'), say<"names of other streams">());
    if (child->entry.has("delay_s"))
      return child->entry.refuse("delay_s", say<"left out: \"%1\" feeds this stream, and the wave comes from there">(parent.stream.name));
    sumOf(*child, above);
    if (!flow_.good()) return;
    if (child->stream.breathShare != breathShare.value_or(child->stream.breathShare))
      return child->entry.refuse("breath", say<"the same as in the others that \"%1\" feeds">(parent.stream.name));
    if (const double apart_mm = glm::distance(parent.end_mm(), child->begin_mm()); apart_mm > parent.line.back().w)
      return parent.entry.refuse("feeds", say<"\"%1\", which begins %2 mm from where this stream ends">(name, fixedText(apart_mm, 1)),
                                 say<"streams that begin where it ends">());
    breathShare = child->stream.breathShare;
    const double flow_mm3PerS = child->towardsRoots ? -child->stream.flow_mm3PerS : child->stream.flow_mm3PerS;
    sum = added(std::move(sum), scaled(child->stream.wave, flow_mm3PerS));
    mean_mm3PerS += flow_mm3PerS;
  }
  above.pop_back();
  const double unit_mm3PerS = std::abs(mean_mm3PerS) > 1e-9 ? mean_mm3PerS : 1.0;
  parent.stream.flow_mm3PerS = unit_mm3PerS;
  parent.stream.wave = scaled(std::move(sum), 1.0 / unit_mm3PerS);
  parent.stream.breathShare = breathShare.value_or(0.0);
  isSummed_[index] = 1;
}

void FlowReading::feedParents() {
  isSummed_.assign(recipes_.size(), 0);
  std::map<std::string, std::string> fedBy;
  for (StreamRecipe& recipe : recipes_) {
    for (const std::string& child : recipe.feeds) {
      if (const auto other = fedBy.find(child); other != fedBy.end())
        return recipe.entry.refuse("feeds", verbatim('"' + child + '"'), say<"streams that \"%1\" does not feed already">(other->second));
      fedBy[child] = recipe.stream.name;
    }
    std::vector<std::size_t> above;
    sumOf(recipe, above);
    if (!flow_.good()) return;
  }
  // From the roots down, so that each delay is known before it is handed on.
  std::vector<StreamRecipe*> ready;
  for (StreamRecipe& recipe : recipes_)
    if (!fedBy.contains(recipe.stream.name)) ready.push_back(&recipe);
  for (std::size_t n = 0; n < ready.size(); ++n) {
    const FlowStream& parent = ready[n]->stream;
    const double along_s = parent.pulseWave_mmPerS > 0.0 ? lengthOf_mm(ready[n]->line) / parent.pulseWave_mmPerS : 0.0;
    for (const std::string& name : ready[n]->feeds) {
      StreamRecipe* child = named(name);
      child->stream.delay_s = parent.delay_s + along_s;
      ready.push_back(child);
    }
  }
}

void FlowReading::addStream(StreamRecipe& recipe) {
  std::optional<StenosisShape> shape;
  double step_mm = kStep_mm;
  Line line = recipe.line;
  if (recipe.stenosis) {
    const JsonFields entry = recipe.entry.object("stenosis");
    const LineFoot nearest = nearestOn(line, recipe.stenosis->at_mm);
    const double radius_mm = placeOn(line, nearest.at).w;
    if (nearest.away_mm > radius_mm)
      return entry.refuse("at_mm", say<"%1 mm from the middle of the vessel">(fixedText(nearest.away_mm, 1)),
                          say<"a place inside of it">());
    shape.emplace(*recipe.stenosis, recipe.stream, line);
    if (!(shape->lostToFlow() >= 0.0 && shape->lostToFlow() <= kMostLost))
      return entry.refuse("peak_cm_per_s", verbatim(textOf(0.1 * *recipe.stenosis->peak_mmPerS)),
                          say<"a velocity that this flow has in a lumen of 5 to 100 % of the vessel's diameter">());
    if (glm::length(recipe.stenosis->shift_mm) > radius_mm * recipe.stenosis->lost)
      return entry.refuse("shift_mm", say<"so long that blood would leave the vessel">(),
                          say<"at most %1 mm: what the diameter loses on one side">(fixedText(radius_mm * recipe.stenosis->lost, 1)));
    step_mm = std::min(step_mm, recipe.stenosis->length_mm / kStepsOfStenosis);
    // The throat itself is a node.
    line = between(recipe.line, 0.0, shape->at());
    const Line behind = between(recipe.line, shape->at(), static_cast<double>(recipe.line.size() - 1));
    line.insert(line.end(), behind.begin() + 1, behind.end());
    made_.stenoses.push_back({static_cast<int>(made_.field.streams.size()), shape->place_mm(), recipe.stenosis->lost, shape->lostToFlow(),
                              shape->peak_mmPerS()});
  }
  nodes_ += lengthOf_mm(line) / step_mm + static_cast<double>(line.size());
  if (nodes_ > kMostNodes)
    return recipe.entry.refuseWhole(say<"with the streams before it too long to follow in steps of %1 mm">(textOf(step_mm)),
                                    say<"shorter, or with a longer stenosis">());
  for (const Step& step : stepsAlong(line, step_mm))
    recipe.stream.line.push_back(shape ? shape->nodeAt(step)
                                       : FlowNode{.place_mm = glm::dvec3(step.place_mm), .radius_mm = step.place_mm.w});
  made_.field.streams.push_back(recipe.stream);
}

/// Flow divides at forks as the cubes of the radii, which by Murray's law add up.
void FlowReading::addTree(const StreamRecipe& recipe) {
  const std::vector<VesselBranch>& branches = recipe.tree->branches;
  const auto fedBy = [&](std::size_t n) { return std::pow(branches[n].radius_mm, 3.0); };
  double roots = 0.0;
  std::vector<double> children(branches.size(), 0.0), share(branches.size(), 0.0), delay_s(branches.size(), recipe.stream.delay_s);
  for (std::size_t n = 0; n < branches.size(); ++n)
    (branches[n].parent < 0 ? roots : children[static_cast<std::size_t>(branches[n].parent)]) += fedBy(n);
  for (std::size_t n = 0; n < branches.size(); ++n) {
    const int parent = branches[n].parent;
    const auto above = static_cast<std::size_t>(std::max(parent, 0));
    share[n] = parent < 0 ? fedBy(n) / roots : share[above] * fedBy(n) / children[above];
    const double length_mm = lengthOf_mm((*recipe.branches)[n].points_mm);
    const double along_s = recipe.stream.pulseWave_mmPerS > 0.0 ? length_mm / recipe.stream.pulseWave_mmPerS : 0.0;
    if (parent >= 0) delay_s[n] = delay_s[above];
    FlowStream stream = recipe.stream;
    stream.flow_mm3PerS *= recipe.towardsRoots ? -share[n] : share[n];
    stream.delay_s = delay_s[n];
    delay_s[n] += along_s;
    for (const glm::dvec4& place : (*recipe.branches)[n].points_mm)
      stream.line.push_back({.place_mm = glm::dvec3(place), .radius_mm = place.w});
    made_.field.streams.push_back(std::move(stream));
  }
}

Flow FlowReading::read() {
  flow_.only({"density_kg_per_m3", "viscosity_mpa_s", "waves", "streams"});
  if (!flow_.good()) return {};
  made_.field.density_kgPerM3 = flow_.number("density_kg_per_m3", 900.0, 1200.0, 1060.0);
  made_.field.viscosity_mPaS = flow_.number("viscosity_mpa_s", 1.0, 20.0, 3.5);
  readWaves();
  recipes_.reserve(kMostStreams);
  for (const JsonFields& entry : flow_.objects("streams", 1, kMostStreams))
    if (flow_.good()) readStream(entry);
  if (!flow_.good()) return {};
  feedParents();
  for (StreamRecipe& recipe : recipes_) {
    if (!flow_.good()) return {};
    const std::size_t more = recipe.tree ? recipe.tree->branches.size() : 1;
    if (made_.field.streams.size() + more > kMostTogether) {
      recipe.entry.refuseWhole(say<"with those before it more than %1 vessels">(kMostTogether), say<"fewer, or a tree of fewer ends">());
      return {};
    }
    if (recipe.tree)
      addTree(recipe);
    else
      addStream(recipe);
  }
  return flow_.good() ? std::move(made_) : Flow{};
}

}  // namespace

Flow readFlow(const JsonFields& flow, const ShapesByName& shapes, const BodyRhythms& rhythms) {
  return FlowReading(flow, shapes, rhythms).read();
}

}  // namespace ew::phantom
