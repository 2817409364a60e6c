#include "keys/control_words.h"

namespace ew::ui {

using controls::ControlKind;
using controls::Encoding;
using controls::Learner;

QString ControlWords::nameOf(const controls::ControlId& control) {
  switch (control.kind) {
    case ControlKind::midiControl:
      return tr("control %1, channel %2").arg(control.number).arg(control.channel);
    case ControlKind::midiControl14:
      return tr("control %1 (14 bits), channel %2").arg(control.number).arg(control.channel);
    case ControlKind::midiParameter:
      return tr("parameter %1, channel %2").arg(control.number).arg(control.channel);
    case ControlKind::midiNote:
      return tr("note %1, channel %2").arg(control.number).arg(control.channel);
    case ControlKind::midiBend:
      return tr("fader (pitch bend), channel %1").arg(control.channel);
    case ControlKind::hidByte:
      return tr("axis or wheel %1").arg(control.number + 1);
    case ControlKind::hidBit:
      return tr("button %1.%2").arg(control.number / 8 + 1).arg(control.number % 8 + 1);
  }
  return {};
}

QString ControlWords::nameOf(Encoding encoding) {
  switch (encoding) {
    case Encoding::absolute:
      return tr("knob or fader");
    case Encoding::twosComplement:
      return tr("encoder (1, 127)");
    case Encoding::offset64:
      return tr("encoder (65, 63)");
    case Encoding::signBit:
      return tr("encoder (1, 65)");
    case Encoding::counter:
      return tr("jog wheel");
    case Encoding::button:
      return tr("button");
  }
  return {};
}

QString ControlWords::sentenceOf(Learner::Needs needs, controls::Target::Kind wanted) {
  switch (wanted) {
    case controls::Target::Kind::action:
      return tr("Press the button that shall do it.");
    case controls::Target::Kind::setting:
      break;
  }
  switch (needs) {
    case Learner::Needs::move:
      return tr("Turn the knob, or move the fader, that shall do it.");
    case Learner::Needs::moveOn:
      return tr("Turn it on, a good way.");
    case Learner::Needs::turnBack:
      return tr("Now turn it back a little to the other side.");
    case Learner::Needs::knobInsteadOfButton:
      return tr("That is a button, and this setting needs a knob. Turn a knob, or bind the button to an action instead.");
  }
  return {};
}

}  // namespace ew::ui
