#include "logic/keeping_aside.h"

namespace ew::case_authoring {

void KeepingAside::keep(Painted painted, Done told) {
  then_ = Then::goOn;
  if (isBusy_)
    waiting_ = Next{std::move(painted), std::move(told)};
  else
    begin({std::move(painted), std::move(told)});
}

void KeepingAside::begin(Next next) {
  isBusy_ = true;
  start_([self = shared_from_this(), painted = std::move(next.painted)](
             Progress& progress) { return self->kept_.keep(painted.labels, painted.caseFolder, painted.before, progress); },
         [self = shared_from_this(), told = std::move(next.told)](const Result<void>& outcome) {
           self->isBusy_ = false;
           if (!self->waiting_) self->ended();
           if (told) told(outcome);
           if (!self->isBusy_)
             if (auto waiting = std::exchange(self->waiting_, std::nullopt)) self->begin(std::move(*waiting));
         });
}

void KeepingAside::ended() {
  switch (std::exchange(then_, Then::goOn)) {
    case Then::goOn:
      return;
    case Then::forget:
      return kept_.forget();
    case Then::leave:
      return kept_.leave();
  }
}

void KeepingAside::forget() {
  waiting_.reset();
  then_ = Then::forget;
  if (!isBusy_) ended();
}

void KeepingAside::leave() {
  then_ = Then::leave;
  if (!isBusy_) ended();
}

}  // namespace ew::case_authoring
