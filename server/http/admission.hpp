#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

namespace pentapost::server {

/// Bounds the jobs under way: so many run, so many wait, and a further one is refused before
/// anything of it was started or held. Must outlive its tickets.
class Admission {
 public:
  /// @param running  jobs that compute at once, >= 1.
  /// @param waiting  jobs admitted beyond these, >= 0.
  Admission(int running, int waiting) : free_slots_{running}, free_tickets_{running + waiting} {}

  /// The right to one job, given back on destruction.
  class Ticket {
   public:
    Ticket(Ticket&& other) noexcept : admission_{std::exchange(other.admission_, nullptr)} {}
    Ticket& operator=(Ticket&&) = delete;
    ~Ticket() {
      if (admission_ != nullptr) admission_->leave();
    }

   private:
    friend class Admission;
    explicit Ticket(Admission* admission) : admission_{admission} {}
    Admission* admission_;
  };

  /// A place among the running ones, given back on destruction.
  class Slot {
   public:
    Slot(Slot&& other) noexcept : admission_{std::exchange(other.admission_, nullptr)} {}
    Slot& operator=(Slot&&) = delete;
    ~Slot() {
      if (admission_ != nullptr) admission_->stop();
    }

   private:
    friend class Admission;
    explicit Slot(Admission* admission) : admission_{admission} {}
    Admission* admission_;
  };

  /// nullopt: the bound is reached.
  std::optional<Ticket> enter();
  /// Waits for a place. Call it with a ticket, when all input is at hand.
  Slot start();

 private:
  void leave();
  void stop();

  std::mutex mutex_;
  std::condition_variable slot_is_free_;
  int free_slots_;
  int free_tickets_;
};

}  // namespace pentapost::server
