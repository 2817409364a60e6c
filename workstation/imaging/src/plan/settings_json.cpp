#include "ew/imaging/settings_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "ew/core/foreign_json.h"
#include "ew/core/json_fields.h"
#include "ew/core/numbers.h"
#include "settings_fields.h"

namespace ew {
namespace {

using nlohmann::json;

constexpr double kRadPerDegree = std::numbers::pi / 180.0;
constexpr std::size_t kLongestList = 256;

double degreesGiving(double angle_rad) { return factorGiving(angle_rad, kRadPerDegree); }

/// What each kind of field may be, in words; the same in error sentences and in the manual.
struct Wording {
  static Message number(double lowest, double highest, detail::Meaning meaning) {
    return say<"%1 (%2)">(rangeText(lowest, highest), meaning());
  }
  static Message numberOrZero(double lowest, double highest, detail::Meaning meaning) {
    return say<"%1, or 0 for %2">(rangeText(lowest, highest), meaning());
  }
  static Message angle(double lowest_deg, double highest_deg) { return rangeText(lowest_deg, highest_deg); }
  static Message count(int lowest, int highest) { return wholeRangeText(lowest, highest); }
  static Message oddCount(int lowest, int highest) { return say<"an odd number from %1 to %2">(lowest, highest); }
  static Message factors(std::size_t count) { return say<"a list of %1 factors of at least 0, near to far (1 is neutral)">(count); }
  static Message decibels(std::size_t count, double lowest_db, double highest_db) {
    return say<"a list of %1 numbers of decibels, each %2, near to far (0 is neutral)">(count, rangeText(lowest_db, highest_db));
  }
  static Message foci(std::size_t most) { return say<"a depth in mm, 0 for half of the depth, or a list of up to %1 depths">(most); }
  template <class E, std::size_t N>
  static Message choice(const WordTable<E, N>& words) {
    std::array<std::string_view, N> all;
    for (std::size_t n = 0; n < N; ++n) all[n] = words[n].first;
    return wordsText(all);
  }
  static Message flag() { return say<"true or false">(); }
  static Message text(std::size_t longest) { return say<"a text of at most %1 bytes">(longest); }
  static Message effect() { return say<"true, false or an object of its parameters">(); }
  static Message list() { return say<"a list of objects, each with its own label">(); }
};

/// Takes the fields of `setting` from a JSON object.
template <class T>
class Reader {
 public:
  Reader(T& setting, const JsonFields& fields, bool keepsUnknown) : setting_(setting), fields_(fields), keepsUnknown_(keepsUnknown) {}

  void number(const char* key, double T::*field, double lowest, double highest, detail::Meaning meaning) {
    setting_.*field = fields_.number(known(key), lowest, highest, setting_.*field, Wording::number(lowest, highest, meaning));
  }
  void numberOrZero(const char* key, double T::*field, double lowest, double highest, detail::Meaning meaning) {
    const json* value = fields_.find(known(key));
    if (value != nullptr && numberWithin(*value, 0.0, 0.0))
      setting_.*field = 0.0;
    else
      setting_.*field = fields_.number(key, lowest, highest, setting_.*field, Wording::numberOrZero(lowest, highest, meaning));
  }
  void angle(const char* key, double T::*field, double lowest_deg, double highest_deg) {
    if (fields_.has(known(key))) setting_.*field = fields_.number(key, lowest_deg, highest_deg) * kRadPerDegree;
  }
  void count(const char* key, int T::*field, int lowest, int highest) {
    setting_.*field = static_cast<int>(fields_.whole(known(key), lowest, highest, setting_.*field));
  }
  void oddCount(const char* key, int T::*field, int lowest, int highest) {
    setting_.*field = static_cast<int>(fields_.whole(known(key), lowest, highest, setting_.*field, Wording::oddCount(lowest, highest)));
    if (setting_.*field % 2 == 0) fields_.refuse(key, Wording::oddCount(lowest, highest));
  }
  template <std::size_t N>
  void factors(const char* key, std::array<double, N> T::*field, double lowest, double highest) {
    const auto values = fields_.numbers(known(key), N, N, lowest, highest, false, Wording::factors(N));
    std::copy(values.begin(), values.end(), (setting_.*field).begin());
  }
  template <std::size_t N>
  void decibels(const char* key, std::array<double, N> T::*field, double lowest_db, double highest_db) {
    const Message expected = Wording::decibels(N, lowest_db, highest_db);
    const auto values = fields_.numbers(known(key), N, N, lowest_db, highest_db, false, expected);
    std::copy(values.begin(), values.end(), (setting_.*field).begin());
  }
  template <std::size_t N>
  void foci(const char* key, double T::*first, std::array<double, N> T::*more, double lowest, double highest) {
    const json* value = fields_.find(known(key));
    if (value != nullptr && value->is_array()) {
      const auto values = fields_.numbers(key, 1, N + 1, lowest, highest, true, Wording::foci(N + 1));
      for (std::size_t n = 0; n < values.size(); ++n) (n == 0 ? setting_.*first : (setting_.*more)[n - 1]) = values[n];
    } else {
      setting_.*first = fields_.number(key, lowest, highest, setting_.*first, Wording::foci(N + 1));
    }
  }
  template <class E, std::size_t N>
  void choice(const char* key, E T::*field, const WordTable<E, N>& words) {
    setting_.*field = fields_.word(known(key), words, std::optional(setting_.*field));
  }
  void flag(const char* key, bool T::*field) { setting_.*field = fields_.flag(known(key), setting_.*field); }
  void text(const char* key, std::string T::*field, std::size_t longest) {
    setting_.*field = fields_.text(known(key), setting_.*field, 0, longest, Wording::text(longest));
  }
  template <class Effect>
  void effect(const char* key, std::optional<Effect> T::*field) {
    const json* value = fields_.find(known(key));
    if (value == nullptr) return;
    if (value->is_boolean()) {
      if (value->get<bool>())
        (setting_.*field).emplace();
      else
        (setting_.*field).reset();
    } else if (value->is_object()) {
      json unknown = readObject((setting_.*field).emplace(), fields_.object(key), keepsUnknown_);
      if (!unknown.empty()) unknown_[key] = std::move(unknown);
    } else {
      fields_.refuse(key, Wording::effect());
    }
  }
  void list(const char* key, std::vector<TissueAcoustics> T::*field) {
    const json& items = fields_.list(known(key), 0, kLongestList, Wording::list());
    for (std::size_t n = 0; n < items.size(); ++n) {
      const std::string place = key + ("[" + std::to_string(n) + "]");
      if (!items[n].is_object() || !items[n].contains("label"))
        return fields_.refuse(place, shown(items[n]), say<"an object with a label">());
      TissueAcoustics item;
      const JsonFields object(items[n], fields_.reading(), fields_.placeOf(place));
      json unknown = readObject(item, object, keepsUnknown_);
      const auto sameLabel = [&](const TissueAcoustics& other) { return other.label == item.label; };
      if (std::any_of((setting_.*field).begin(), (setting_.*field).end(), sameLabel))
        object.refuse("label", say<"a label that no other tissue of the list has">());
      if (!unknown.empty()) {
        unknown["label"] = item.label;
        unknown_[key].push_back(std::move(unknown));
      }
      (setting_.*field).push_back(std::move(item));
    }
  }

  /// Once every field was asked for: what else is there.
  json rest() {
    if (!keepsUnknown_) fields_.only(known_);
    for (const auto& [key, value] : fields_.value().items())
      if (std::find(known_.begin(), known_.end(), key) == known_.end()) unknown_[key] = value;
    return std::move(unknown_);
  }

  template <class Inner>
  static json readObject(Inner& inner, const JsonFields& fields, bool keepsUnknown) {
    Reader<Inner> reader(inner, fields, keepsUnknown);
    detail::visitFields(reader, &inner);
    return reader.rest();
  }

 private:
  const char* known(const char* key) {
    known_.emplace_back(key);
    return key;
  }

  T& setting_;
  JsonFields fields_;
  bool keepsUnknown_;
  std::vector<std::string> known_;
  json unknown_ = json::object();
};

/// Every field of a setting as JSON.
template <class T>
class Writer {
 public:
  explicit Writer(const T& setting, const json* unknown = nullptr) : setting_(setting), unknown_(unknown) {}
  json object = json::object();

  void number(const char* key, double T::*field, double, double, detail::Meaning) { object[key] = setting_.*field; }
  void numberOrZero(const char* key, double T::*field, double, double, detail::Meaning) { object[key] = setting_.*field; }
  void angle(const char* key, double T::*field, double, double) { object[key] = degreesGiving(setting_.*field); }
  void count(const char* key, int T::*field, int, int) { object[key] = setting_.*field; }
  void oddCount(const char* key, int T::*field, int, int) { object[key] = setting_.*field; }
  template <std::size_t N>
  void factors(const char* key, std::array<double, N> T::*field, double, double) {
    object[key] = setting_.*field;
  }
  template <std::size_t N>
  void decibels(const char* key, std::array<double, N> T::*field, double, double) {
    object[key] = setting_.*field;
  }
  template <std::size_t N>
  void foci(const char* key, double T::*first, std::array<double, N> T::*more, double, double) {
    std::vector<double> all{setting_.*first};
    all.insert(all.end(), (setting_.*more).begin(), (setting_.*more).end());
    while (all.size() > 1 && all.back() == 0.0) all.pop_back();
    if (all.size() == 1)
      object[key] = all.front();
    else
      object[key] = all;
  }
  template <class E, std::size_t N>
  void choice(const char* key, E T::*field, const WordTable<E, N>& words) {
    object[key] = wordIn(words, setting_.*field);
  }
  void flag(const char* key, bool T::*field) { object[key] = setting_.*field; }
  void text(const char* key, std::string T::*field, std::size_t) { object[key] = setting_.*field; }
  template <class Effect>
  void effect(const char* key, std::optional<Effect> T::*field) {
    const json* more = unknownOf(key);
    if (!(setting_.*field)) return;
    json parameters = differing(*(setting_.*field));
    if (more != nullptr) parameters.update(*more);
    object[key] = parameters.empty() ? json(true) : std::move(parameters);
  }
  void list(const char* key, std::vector<TissueAcoustics> T::*field) {
    const json* all = unknownOf(key);
    for (const TissueAcoustics& item : setting_.*field) {
      json written = differing(item);
      written["label"] = item.label;
      if (all != nullptr)
        for (const json& more : *all)
          if (memberOf(more, "label") == item.label) written.update(more);
      object[key].push_back(std::move(written));
    }
  }

  /// Keys that no field has, as they were.
  void addUnknown() {
    if (unknown_ == nullptr || !unknown_->is_object()) return;
    for (const auto& [key, value] : unknown_->items())
      if (std::find(nested_.begin(), nested_.end(), key) == nested_.end() && !object.contains(key)) object[key] = value;
  }

  template <class Inner>
  static json differing(const Inner& inner) {
    Writer<Inner> writer(inner), usual(kUsual<Inner>);
    detail::visitFields(writer, &inner);
    detail::visitFields(usual, &inner);
    for (const auto& [key, value] : usual.object.items())
      if (writer.object[key] == value) writer.object.erase(key);
    return std::move(writer.object);
  }

 private:
  template <class Inner>
  static inline const Inner kUsual{};

  /// What was not known within the effect or list `key`.
  const json* unknownOf(const char* key) {
    nested_.emplace_back(key);
    if (unknown_ == nullptr || !unknown_->is_object()) return nullptr;
    const auto found = unknown_->find(key);
    return found == unknown_->end() ? nullptr : &*found;
  }

  const T& setting_;
  const json* unknown_;
  std::vector<std::string> nested_;
};

/// The manual: what each key may be.
template <class T>
class Manual {
 public:
  explicit Manual(std::string indent) : indent_(std::move(indent)) {}
  std::string text_;

  void number(const char* key, double T::*, double lowest, double highest, detail::Meaning meaning) {
    add(key, Wording::number(lowest, highest, meaning));
  }
  void numberOrZero(const char* key, double T::*, double lowest, double highest, detail::Meaning meaning) {
    add(key, Wording::numberOrZero(lowest, highest, meaning));
  }
  void angle(const char* key, double T::*, double lowest_deg, double highest_deg) { add(key, Wording::angle(lowest_deg, highest_deg)); }
  void count(const char* key, int T::*, int lowest, int highest) { add(key, Wording::count(lowest, highest)); }
  void oddCount(const char* key, int T::*, int lowest, int highest) { add(key, Wording::oddCount(lowest, highest)); }
  template <std::size_t N>
  void factors(const char* key, std::array<double, N> T::*, double, double) {
    add(key, Wording::factors(N));
  }
  template <std::size_t N>
  void decibels(const char* key, std::array<double, N> T::*, double lowest_db, double highest_db) {
    add(key, Wording::decibels(N, lowest_db, highest_db));
  }
  template <std::size_t N>
  void foci(const char* key, double T::*, std::array<double, N> T::*, double, double) {
    add(key, Wording::foci(N + 1));
  }
  template <class E, std::size_t N>
  void choice(const char* key, E T::*, const WordTable<E, N>& words) {
    add(key, Wording::choice(words));
  }
  void flag(const char* key, bool T::*) { add(key, Wording::flag()); }
  void text(const char* key, std::string T::*, std::size_t longest) { add(key, Wording::text(longest)); }
  template <class Effect>
  void effect(const char* key, std::optional<Effect> T::*) {
    addNested<Effect>(key, Wording::effect());
  }
  void list(const char* key, std::vector<TissueAcoustics> T::*) { addNested<TissueAcoustics>(key, Wording::list()); }

 private:
  void add(const std::string& key, const Message& words) { text_ += indent_ + key + ": " + words.english() + "\n"; }
  template <class Inner>
  void addNested(const char* key, const Message& words) {
    add(key, words);
    Manual<Inner> inner(indent_ + "  ");
    detail::visitFields(inner, static_cast<const Inner*>(nullptr));
    text_ += inner.text_;
  }

  std::string indent_;
};

template <class T>
Result<T> settingFrom(const json& document, const Message& where, json* unknown) {
  if (!document.is_object())
    return failure(ErrorCode::badHeader, say<"%1 is not a JSON object; write it as { \"name\": value, ... }.">(where),
                   {{"document", where.english()}});
  JsonReading reading(where);
  T setting;
  json rest = Reader<T>::readObject(setting, JsonFields(document, reading), unknown != nullptr);
  if (reading.problem()) return passOn(*reading.problem());
  if (unknown != nullptr) *unknown = std::move(rest);
  return setting;
}

template <class T>
std::string manualOf() {
  Manual<T> manual("  ");
  detail::visitFields(manual, static_cast<const T*>(nullptr));
  return manual.text_;
}

}  // namespace

namespace {

/// The law that a document means which names none: that of the values it gives. Files of before there were two give factors.
GainLaw gainLawMeantBy(const json& document) {
  const bool factors = document.contains("gain") || document.contains("dgc");
  const bool decibels = document.contains("gain_db") || document.contains("tgc_db");
  if (factors == decibels) return GainLaw::automatic;
  return factors ? GainLaw::paper : GainLaw::decibel;
}

}  // namespace

Result<Knobs> knobsFromJson(const json& document, const Message& where, json* unknown) {
  auto knobs = settingFrom<Knobs>(document, where, unknown);
  if (knobs && !document.contains("gain_law")) knobs->gainLaw = gainLawMeantBy(document);
  return knobs;
}

Result<Scene> sceneFromJson(const json& document, const Message& where, json* unknown) {
  return settingFrom<Scene>(document, where, unknown);
}

json toJson(const Knobs& knobs) {
  Writer<Knobs> writer(knobs);
  detail::visitFields(writer, &knobs);
  return std::move(writer.object);
}

json toJson(const Scene& scene, const json* unknown) {
  Writer<Scene> writer(scene, unknown);
  detail::visitFields(writer, &scene);
  if (scene.recordedDynamicRange_db == Scene{}.recordedDynamicRange_db) writer.object.erase("recorded_dynamic_range_db");
  writer.addUnknown();
  return std::move(writer.object);
}

std::string knobsManual() { return manualOf<Knobs>(); }
std::string sceneManual() { return manualOf<Scene>(); }

}  // namespace ew
