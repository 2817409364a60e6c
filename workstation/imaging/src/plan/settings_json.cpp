#include "ew/imaging/settings_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "ew/core/numbers.h"
#include "settings_fields.h"

namespace ew {
namespace {

using nlohmann::json;

constexpr double kRadPerDegree = std::numbers::pi / 180.0;
constexpr std::size_t kLongestList = 256;

double degreesGiving(double angle_rad) { return factorGiving(angle_rad, kRadPerDegree); }

std::string rangeWords(double lowest, double highest) { return "a number from " + textOf(lowest) + " to " + textOf(highest); }
std::string withMeaning(std::string range, const char* meaning) { return range + " (" + meaning + ")"; }

/// What each kind of field may be, in words; the same in error sentences and in the manual.
struct Wording {
  static std::string number(double lowest, double highest, const char* meaning) {
    return withMeaning(rangeWords(lowest, highest), meaning);
  }
  static std::string numberOrZero(double lowest, double highest, const char* meaning) {
    return rangeWords(lowest, highest) + ", or 0 for " + meaning;
  }
  static std::string angle(double lowest_deg, double highest_deg) { return rangeWords(lowest_deg, highest_deg); }
  static std::string count(int lowest, int highest) {
    return "a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest);
  }
  static std::string oddCount(int lowest, int highest) {
    return "an odd number from " + std::to_string(lowest) + " to " + std::to_string(highest);
  }
  static std::string factors(std::size_t count) {
    return "a list of " + std::to_string(count) + " factors of at least 0, near to far (1 is neutral)";
  }
  static std::string foci(std::size_t most) {
    return "a depth in mm, 0 for half of the depth, or a list of up to " + std::to_string(most) + " depths";
  }
  template <class E, std::size_t N>
  static std::string choice(const detail::Words<E, N>& words) {
    std::string all;
    for (std::size_t n = 0; n < N; ++n) all += std::string(n == 0 ? "" : n + 1 == N ? " or " : ", ") + '"' + words[n].first + '"';
    return all;
  }
  static std::string flag() { return "true or false"; }
  static std::string text(std::size_t longest) { return "a text of at most " + std::to_string(longest) + " bytes"; }
  static std::string effect() { return "true, false or an object of its parameters"; }
  static std::string list() { return "a list of objects, each with its own label"; }
};

/// What a document has told so far.
struct Reading {
  const std::string& where;
  bool keepsUnknown = false;
  std::optional<Error> complaint = std::nullopt;  // the first one is told

  void complain(const std::string& key, const json& found, const std::string& expected) {
    if (complaint) return;
    std::string shown = found.dump(-1, ' ', false, json::error_handler_t::replace);
    if (shown.size() > 60) shown = shown.substr(0, 57) + "...";
    complaint = Error{ErrorCode::badField,
                      "'" + key + "' in " + where + " is " + shown + ", expected is " + expected + ".",
                      {{"field", key}, {"found", shown}, {"expected", expected}}};
  }
  void complainOfUnknown(const std::string& key, const std::vector<std::string>& known) {
    if (complaint) return;
    std::string all;
    for (const std::string& each : known) all += (all.empty() ? "" : ", ") + each;
    complaint = Error{
        ErrorCode::badField, where + " has the unknown key '" + key + "'; known are " + all + ".", {{"field", key}, {"expected", all}}};
  }
};

/// Takes the fields of `setting` from a JSON object.
template <class T>
class Reader {
 public:
  Reader(T& setting, const json& object, std::string path, Reading& reading)
      : setting_(setting), object_(object), path_(std::move(path)), reading_(reading) {}

  void number(const char* key, double T::*field, double lowest, double highest, const char* meaning) {
    if (const json* value = valueOf(key))
      if (!take(*value, lowest, highest, setting_.*field)) complain(key, *value, Wording::number(lowest, highest, meaning));
  }
  void numberOrZero(const char* key, double T::*field, double lowest, double highest, const char* meaning) {
    if (const json* value = valueOf(key))
      if (!take(*value, 0.0, 0.0, setting_.*field) && !take(*value, lowest, highest, setting_.*field))
        complain(key, *value, Wording::numberOrZero(lowest, highest, meaning));
  }
  void angle(const char* key, double T::*field, double lowest_deg, double highest_deg) {
    double angle_deg = 0.0;
    if (const json* value = valueOf(key)) {
      if (take(*value, lowest_deg, highest_deg, angle_deg))
        setting_.*field = angle_deg * kRadPerDegree;
      else
        complain(key, *value, Wording::angle(lowest_deg, highest_deg));
    }
  }
  void count(const char* key, int T::*field, int lowest, int highest) {
    if (const json* value = valueOf(key))
      if (!take(*value, lowest, highest, setting_.*field)) complain(key, *value, Wording::count(lowest, highest));
  }
  void oddCount(const char* key, int T::*field, int lowest, int highest) {
    if (const json* value = valueOf(key))
      if (!take(*value, lowest, highest, setting_.*field) || (setting_.*field) % 2 == 0)
        complain(key, *value, Wording::oddCount(lowest, highest));
  }
  template <std::size_t N>
  void factors(const char* key, std::array<double, N> T::*field, double lowest, double highest) {
    const json* value = valueOf(key);
    if (value == nullptr) return;
    bool good = value->is_array() && value->size() == N;
    for (std::size_t n = 0; good && n < N; ++n) good = take((*value)[n], lowest, highest, (setting_.*field)[n]);
    if (!good) complain(key, *value, Wording::factors(N));
  }
  template <std::size_t N>
  void foci(const char* key, double T::*first, std::array<double, N> T::*more, double lowest, double highest) {
    const json* value = valueOf(key);
    if (value == nullptr) return;
    bool good = true;
    if (value->is_array()) {
      good = !value->empty() && value->size() <= N + 1;
      for (std::size_t n = 0; good && n < value->size(); ++n)
        good = take((*value)[n], lowest, highest, n == 0 ? setting_.*first : (setting_.*more)[n - 1]);
    } else {
      good = take(*value, lowest, highest, setting_.*first);
    }
    if (!good) complain(key, *value, Wording::foci(N + 1));
  }
  template <class E, std::size_t N>
  void choice(const char* key, E T::*field, const detail::Words<E, N>& words) {
    const json* value = valueOf(key);
    if (value == nullptr) return;
    for (const auto& [word, meaning] : words)
      if (*value == word) {
        setting_.*field = meaning;
        return;
      }
    complain(key, *value, Wording::choice(words));
  }
  void flag(const char* key, bool T::*field) {
    const json* value = valueOf(key);
    if (value == nullptr) return;
    if (value->is_boolean())
      setting_.*field = value->get<bool>();
    else
      complain(key, *value, Wording::flag());
  }
  void text(const char* key, std::string T::*field, std::size_t longest) {
    const json* value = valueOf(key);
    if (value == nullptr) return;
    if (value->is_string() && value->get_ref<const std::string&>().size() <= longest)
      setting_.*field = value->get<std::string>();
    else
      complain(key, *value, Wording::text(longest));
  }
  template <class Effect>
  void effect(const char* key, std::optional<Effect> T::*field) {
    const json* value = valueOf(key);
    if (value == nullptr) return;
    if (value->is_boolean()) {
      if (value->get<bool>())
        (setting_.*field).emplace();
      else
        (setting_.*field).reset();
    } else if (value->is_object()) {
      json unknown = readObject((setting_.*field).emplace(), *value, path_ + key + ".", reading_);
      if (!unknown.empty()) unknown_[key] = std::move(unknown);
    } else {
      complain(key, *value, Wording::effect());
    }
  }
  void list(const char* key, std::vector<TissueAcoustics> T::*field) {
    const json* value = valueOf(key);
    if (value == nullptr) return;
    if (!value->is_array() || value->size() > kLongestList) return complain(key, *value, Wording::list());
    for (std::size_t n = 0; n < value->size(); ++n) {
      const json& object = (*value)[n];
      const std::string path = key + ("[" + std::to_string(n) + "]");
      if (!object.is_object() || !object.contains("label")) return complain(path, object, "an object with a label");
      TissueAcoustics item;
      json unknown = readObject(item, object, path_ + path + ".", reading_);
      const auto sameLabel = [&](const TissueAcoustics& other) { return other.label == item.label; };
      if (std::any_of((setting_.*field).begin(), (setting_.*field).end(), sameLabel))
        complain(path + ".label", object["label"], "a label that no other tissue of the list has");
      if (!unknown.empty()) {
        unknown["label"] = item.label;
        unknown_[key].push_back(std::move(unknown));
      }
      (setting_.*field).push_back(std::move(item));
    }
  }

  /// Once every field was asked for: what else is there.
  json rest() {
    for (const auto& [key, value] : object_.items()) {
      if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
      if (!reading_.keepsUnknown) reading_.complainOfUnknown(path_ + key, known_);
      unknown_[key] = value;
    }
    return std::move(unknown_);
  }

  template <class Inner>
  static json readObject(Inner& inner, const json& object, const std::string& path, Reading& reading) {
    Reader<Inner> reader(inner, object, path, reading);
    detail::visitFields(reader, &inner);
    return reader.rest();
  }

 private:
  const json* valueOf(const char* key) {
    known_.emplace_back(key);
    const auto found = object_.find(key);
    return found == object_.end() ? nullptr : &*found;
  }
  static bool take(const json& value, double lowest, double highest, double& target) {
    if (!value.is_number()) return false;
    const double number = value.get<double>();
    if (!(number >= lowest && number <= highest)) return false;
    target = number;
    return true;
  }
  static bool take(const json& value, int lowest, int highest, int& target) {
    double number = 0.0;
    if (!take(value, static_cast<double>(lowest), static_cast<double>(highest), number) || number != std::floor(number)) return false;
    target = static_cast<int>(number);
    return true;
  }
  void complain(const std::string& key, const json& found, const std::string& expected) { reading_.complain(path_ + key, found, expected); }

  T& setting_;
  const json& object_;
  std::string path_;
  Reading& reading_;
  std::vector<std::string> known_;
  json unknown_ = json::object();
};

/// Every field of a setting as JSON.
template <class T>
class Writer {
 public:
  explicit Writer(const T& setting, const json* unknown = nullptr) : setting_(setting), unknown_(unknown) {}
  json object = json::object();

  void number(const char* key, double T::*field, double, double, const char*) { object[key] = setting_.*field; }
  void numberOrZero(const char* key, double T::*field, double, double, const char*) { object[key] = setting_.*field; }
  void angle(const char* key, double T::*field, double, double) { object[key] = degreesGiving(setting_.*field); }
  void count(const char* key, int T::*field, int, int) { object[key] = setting_.*field; }
  void oddCount(const char* key, int T::*field, int, int) { object[key] = setting_.*field; }
  template <std::size_t N>
  void factors(const char* key, std::array<double, N> T::*field, double, double) {
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
  void choice(const char* key, E T::*field, const detail::Words<E, N>& words) {
    for (const auto& [word, meaning] : words)
      if (meaning == setting_.*field) object[key] = word;
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
          if (more.is_object() && more.value("label", json()) == item.label) written.update(more);
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

  void number(const char* key, double T::*, double lowest, double highest, const char* meaning) {
    add(key, Wording::number(lowest, highest, meaning));
  }
  void numberOrZero(const char* key, double T::*, double lowest, double highest, const char* meaning) {
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
  void foci(const char* key, double T::*, std::array<double, N> T::*, double, double) {
    add(key, Wording::foci(N + 1));
  }
  template <class E, std::size_t N>
  void choice(const char* key, E T::*, const detail::Words<E, N>& words) {
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
  void add(const std::string& key, const std::string& words) { text_ += indent_ + key + ": " + words + "\n"; }
  template <class Inner>
  void addNested(const char* key, const std::string& words) {
    add(key, words);
    Manual<Inner> inner(indent_ + "  ");
    detail::visitFields(inner, static_cast<const Inner*>(nullptr));
    text_ += inner.text_;
  }

  std::string indent_;
};

template <class T>
Result<T> settingFrom(const json& document, const std::string& where, json* unknown) {
  if (!document.is_object())
    return failure(ErrorCode::badHeader, where + " is not a JSON object; write it as { \"name\": value, ... }.", {{"document", where}});
  Reading reading{.where = where, .keepsUnknown = unknown != nullptr};
  T setting;
  json rest = Reader<T>::readObject(setting, document, "", reading);
  if (reading.complaint) return passOn(std::move(*reading.complaint));
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

Result<Knobs> knobsFromJson(const json& document, const std::string& where, json* unknown) {
  return settingFrom<Knobs>(document, where, unknown);
}

Result<Scene> sceneFromJson(const json& document, const std::string& where, json* unknown) {
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
