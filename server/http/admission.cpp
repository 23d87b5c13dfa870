#include "server/http/admission.hpp"

namespace pentapost::server {

std::optional<Admission::Ticket> Admission::enter() {
  const std::lock_guard lock{mutex_};
  if (free_tickets_ == 0) return std::nullopt;
  --free_tickets_;
  return Ticket{this};
}

Admission::Slot Admission::start() {
  std::unique_lock lock{mutex_};
  slot_is_free_.wait(lock, [this] { return free_slots_ > 0; });
  --free_slots_;
  return Slot{this};
}

void Admission::leave() {
  const std::lock_guard lock{mutex_};
  ++free_tickets_;
}

void Admission::stop() {
  {
    const std::lock_guard lock{mutex_};
    ++free_slots_;
  }
  slot_is_free_.notify_one();
}

}  // namespace pentapost::server
