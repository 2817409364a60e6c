#include "ew/controls/keys_file.h"

#include <nlohmann/json.hpp>

#include "ew/core/data_file.h"
#include "ew/core/json_fields.h"
#include "ew/core/word_table.h"
#include "ew/io/json_files.h"
#include "ew/io/safe_file.h"

namespace ew::controls {
namespace {

using nlohmann::json;

constexpr std::size_t kMostActions = 2000, kMostKeys = 8, kMostControls = 1000, kLongestName = 200;

constexpr WordTable<ControlKind, 7> kKinds{{{"control", ControlKind::midiControl},
                                            {"control_14", ControlKind::midiControl14},
                                            {"parameter", ControlKind::midiParameter},
                                            {"note", ControlKind::midiNote},
                                            {"bend", ControlKind::midiBend},
                                            {"report_byte", ControlKind::hidByte},
                                            {"report_bit", ControlKind::hidBit}}};
constexpr WordTable<Encoding, 6> kEncodings{{{"absolute", Encoding::absolute},
                                             {"twos_complement", Encoding::twosComplement},
                                             {"offset_64", Encoding::offset64},
                                             {"sign_bit", Encoding::signBit},
                                             {"counter", Encoding::counter},
                                             {"button", Encoding::button}}};

Binding bindingIn(const JsonFields& fields) {
  fields.only({"device", "kind", "channel", "number", "encoding", "setting", "action", "reversed"});
  Binding binding;
  binding.control.device = fields.text("device", {}, 1, kLongestName);
  binding.control.kind = fields.word("kind", kKinds);
  binding.control.channel = static_cast<int>(fields.whole("channel", 0, 255, 0));
  binding.control.number = static_cast<int>(fields.whole("number", 0, highestNumber(binding.control.kind)));
  binding.encoding = fields.word("encoding", kEncodings);
  binding.reversed = fields.flag("reversed", false);
  const bool isAction = fields.has("action");
  if (isAction == fields.has("setting")) fields.refuse("setting", say<"a setting, or 'action' in its place">());
  binding.target.kind = isAction ? Target::Kind::action : Target::Kind::setting;
  binding.target.id = fields.text(isAction ? "action" : "setting", {}, 1, kLongestName);
  if (fields.good() && (!fits(binding.encoding, binding.control.kind) || (isAction != (binding.encoding == Encoding::button))))
    fields.refuse("encoding", say<"one that this kind of control and what it does can have">());
  return binding;
}

}  // namespace

Result<KeysAndControls> keysFromJson(const json& document, const Message& where) {
  JsonReading reading(where, {"note"});
  const JsonFields fields(document, reading);
  requireFormat(fields, kKeysFormat);
  fields.only({"format", "keys", "controls"});
  KeysAndControls read;
  const JsonFields keys = fields.object("keys");
  if (fields.good() && fields.has("keys")) {
    if (keys.value().size() > kMostActions) fields.refuse("keys", say<"an object of at most %1 actions">(kMostActions));
    for (const auto& [action, unused] : keys.value().items()) {
      if (action == "note") continue;
      read.keys[action] = keys.texts(action, 0, kMostKeys);
    }
  }
  for (const JsonFields& each : fields.objects("controls", 0, kMostControls)) read.controls.push_back(bindingIn(each));
  if (reading.problem()) return passOn(*reading.problem());
  return read;
}

json toJson(const KeysAndControls& keys) {
  json actions = json::object();
  for (const auto& [action, its] : keys.keys) actions[action] = its;
  json controls = json::array();
  for (const Binding& binding : keys.controls) {
    json each = {{"device", binding.control.device},
                 {"kind", wordIn(kKinds, binding.control.kind)},
                 {"channel", binding.control.channel},
                 {"number", binding.control.number},
                 {"encoding", wordIn(kEncodings, binding.encoding)},
                 {binding.target.kind == Target::Kind::action ? "action" : "setting", binding.target.id}};
    if (binding.reversed) each["reversed"] = true;
    controls.push_back(std::move(each));
  }
  return {{"format", kKeysFormat}, {"keys", std::move(actions)}, {"controls", std::move(controls)}};
}

Result<KeysAndControls> readKeys(const std::filesystem::path& file) {
  const Message where = say<"the file of keys %1">(file.string());
  const auto document = readJsonFile(file, where);
  if (!document) return passOn(document.error());
  return keysFromJson(*document, where);
}

Result<void> writeKeys(const KeysAndControls& keys, const std::filesystem::path& file) {
  return writeFileSafely(file, toJson(keys).dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

}  // namespace ew::controls
