#pragma once

#include "pentapost/plan/axis_path.hpp"
#include "pentapost/plan/branches.hpp"

#include <cstdint>
#include <vector>

namespace pentapost::plan {

/// One way to be at a point: a branch and whole turns of both rotary axes. On an endless axis the
/// turns follow the path instead of telling states apart. On the other first axes they are known up
/// to a multiple of StateSpace::first_modulus, and only one of these can be within the range: so
/// few states serve a path that winds without end.
struct State {
  int branch = 0;
  int first_turns = 0;
  int second_turns = 0;
};

/// The states that can serve somewhere along the candidates, at most `largest_state_count`.
struct StateSpace {
  static constexpr std::size_t largest_state_count = 120;
  std::vector<State> states;
  bool first_endless = true;
  bool second_endless = true;
  int first_modulus = 1;
  double first_centre_rad = 0.0;  ///< middle of the range of the first axis

  /// The turns of a state where its branch has this value of the first axis.
  int first_turns(const State& state, double value_rad) const;
};

StateSpace state_space(const kinematics::Model& model, const JointRanges& ranges,
                       const Candidates& candidates, const machine::Preferences& preferences);

/// Whether `value_rad` lies in the range, rounding forgiven.
bool in_range(const std::optional<Range<double>>& range, double value_rad);

/// The window in which the first axis starts: the preference, or -180 to 180 degrees.
Range<double> start_window_rad(const machine::Preferences& preferences);

/// `value_rad` moved by whole turns to the first place at or above the window's lower end.
double moved_to_window_rad(double value_rad, const Range<double>& window_rad);

}  // namespace pentapost::plan
