#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/tool_path.hpp"
#include "pentapost/plan/axis_path.hpp"
#include "pentapost/plan/branches.hpp"
#include "pentapost/plan/candidates.hpp"
#include "pentapost/plan/pole_passage.hpp"
#include "pentapost/plan/settings.hpp"
#include "pentapost/plan/state_space.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace pentapost::plan {

/// What a state costs, and where its endless axes are.
struct Reached {
  double cost_s = std::numeric_limits<double>::infinity();
  int first_turns = 0;
  int second_turns = 0;
};

/// The dynamic programming behind choose_branches: forward over the points off the pole with the
/// cost of every state (state_search.cpp), then back along the cheapest sequence (state_trace.cpp).
class StateSearch {
 public:
  StateSearch(const kinematics::Model& model, const JointRanges& ranges,
              const path::ToolPath& tool_path, const Candidates& candidates,
              const Settings& settings, double gauge_length_mm, bool check_linear);

  Result<AxisPath> run();

 private:
  std::uint8_t pole_of(std::uint32_t point) const;
  Vec3 tip_table(std::uint32_t point) const;
  RotaryPair pair_of(std::size_t state, const Reached& reached, std::uint32_t point) const;
  Reached with_turns(std::size_t state, std::uint32_t point, double cost_s) const;
  /// Linear values of both branches at a point, and whether their ranges hold.
  void look_at(std::uint32_t point);
  bool admissible(std::size_t state, const Reached& reached, std::uint32_t point) const;
  bool in_rotary_ranges(const RotaryPair& pair) const;
  /// A cutting sequence starts: here the preferences decide.
  void begin(std::uint32_t point);
  /// Drops the states that cannot follow the path from its last point off the pole to the pole.
  void end_at_pole(std::uint32_t before);
  /// A state at the first point off the pole, by the preferences.
  Reached started(std::size_t state, std::uint32_t point) const;
  Status go_on(std::uint32_t before, std::uint32_t point);
  double step_time_s(std::uint32_t before, std::uint32_t point, int branch) const;
  double retract_s(std::uint32_t point) const;
  /// Every state goes on along its branch; where that ends at a limit of the first axis, a state
  /// with other turns takes over inside the move.
  void step(std::uint32_t before, std::uint32_t point);
  void take_over_inside(std::uint32_t before, std::uint32_t point, std::vector<Reached>& next);
  /// Between the points lies the pole, where the first axis may turn.
  void pass_pole(std::uint32_t before, std::uint32_t point);
  /// Values at the pole before going on to `point` in a state; endless axes by the nearest turn.
  RotaryPair near_endless(std::size_t to, Reached& there, const PolePassage& passage,
                          std::uint32_t point, const RotaryPair& in) const;
  /// A rapid turns the tool axis about: only a repositioning leads on.
  void turn_about(std::uint32_t point);
  /// At a point any state can follow on the cheapest one by way of a retract; where the branches
  /// meet, on the other branch without.
  void reposition(std::uint32_t point);
  bool any_reached() const;
  void push_back_row();
  Problem out_of_range(std::uint32_t point) const;
  Result<AxisPath> path_at_pole() const;
  AxisPath trace_back();
  /// In a predecessor: the change of states took place inside the move.
  static constexpr std::uint8_t inside_bit = 0x80;
  struct Repositioned {
    std::uint32_t row;
    std::uint8_t to, from;
  };
  /// The chosen states at one off-pole point.
  struct Chosen {
    std::uint8_t arrival;    ///< state in which the path comes
    std::uint8_t departure;  ///< state in which it goes on
    bool inside;             ///< it came by way of a cut inside the move
  };
  std::vector<Chosen> chosen_states() const;
  AxisPath empty_path() const;

  const kinematics::Model& model_;
  const JointRanges& ranges_;
  const path::ToolPath& tool_path_;
  const Candidates& candidates_;
  const Settings& settings_;
  const double gauge_length_mm_;
  const bool check_linear_;
  const OrderingSpeeds speeds_;
  const StateSpace space_;

  std::vector<Reached> reached_, next_;
  std::vector<std::uint8_t> from_;          ///< predecessor of each state at the point in hand
  std::vector<std::uint8_t> rows_;          ///< from_ of every off-pole point
  std::vector<Repositioned> repositioned_;  ///< in order of their rows
  std::vector<std::uint32_t> off_pole_;
  std::array<Vec3, 2> linear_{Vec3::Zero(), Vec3::Zero()}, linear_before_{linear_};
  std::array<bool, 2> linear_ok_{true, true};
};

}  // namespace pentapost::plan
