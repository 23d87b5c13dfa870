#pragma once

#include "pentapost/kinematics/model.hpp"
#include "pentapost/plan/branches.hpp"
#include "pentapost/reorient/axis_rates.hpp"
#include "pentapost/reorient/branch_rule.hpp"
#include "pentapost/reorient/clamping.hpp"
#include "pentapost/reorient/piece.hpp"
#include "pentapost/reorient/piece_tree.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace pentapost::reorient {

/// Which of the two branches come into question.
using Branches = std::array<bool, 2>;

/// A clamping, and those about it at the accuracy of the setup.
struct Clampings {
  Clamping nominal;
  std::vector<Clamping> about;  ///< poles evenly round the nominal one; empty: exact
  double accuracy_rad = 0.0;
};

/// The place of the path, and the clamping among those about a setup, that a ratio comes from.
struct PeakPlace {
  std::uint32_t tool = 0, piece = 0;
  std::uint32_t clamping = 0;  ///< 0: the nominal one; i: about[i - 1]
};

struct Peak {
  double ratio = 0.0;  ///< infinite: a singularity can be met
  std::optional<PeakPlace> place;
};

/// The angles between pole and tool axis over a path.
struct Extremes {
  double least_rad = pi, most_rad = 0.0;
  /// Tools and pieces there.
  std::uint32_t least_tool = 0, least_piece = 0, most_tool = 0, most_piece = 0;
};

/// What a path asks of the axes in any clamping, found without going along all of it.
class PathLoads {
 public:
  struct Limits {
    SpeedShares shares;
    plan::JointRanges ranges;
    bool check_linear = false;
    /// Tool axes may be changed by this at a singularity.
    double slack_rad = 0.0;
    /// The branch that is taken where both serve.
    int preferred_branch = 0;
    BranchRule rule = {};
  };
  /// For two rotary joints.
  PathLoads(const kinematics::Model& model, std::vector<ToolPieces> tools, const Limits& limits);

  Clampings clampings(const Clamping& nominal, double accuracy_rad) const;

  /// @param likely  whose places are tried first.
  Extremes extremes(const Clamping& clamping, const Extremes& likely) const;
  /// Branches that keep the second rotary axis within its range all along; both false: the path
  /// is out of reach or range but for a change of branch on the way.
  Branches branches(const Extremes& extremes) const;
  int branch_of(const Branches& branches) const;
  /// Branches on which the path may be in a clamping within the spread.
  /// @param extremes  of the clamping.
  Branches possible_branches(const Clamping& clamping, const Extremes& extremes,
                             const Spread& spread) const;
  /// By how much the linear axes leave their ranges at most; 0: they don't.
  double linear_excess_mm(const Clamping& clamping, int branch) const {
    return worst_place(clamping, branch).excess_mm;
  }

  /// Largest ratio to a limit over path and clampings; at most by the tolerance too low.
  /// @param tolerance  of the ratio, as its share.
  /// @param likely  places tried first: good ones save most of the search.
  Peak peak(const Clampings& clampings, int branch, double tolerance,
            std::span<const PeakPlace> likely) const;
  /// Time of the cutting path, slowed down to the limits; the largest over the clampings.
  /// @param tolerance  by which it may be wrong, as its share.
  double time_s(const Clampings& clampings, int branch, double tolerance) const;
  /// Way of both rotary axes over the cutting path; likewise.
  double travel_rad(const Clampings& clampings, int branch, double tolerance) const;

  /// Whether all clampings within the spread are out of reach or range.
  bool is_impossible(const Clamping& clamping, const Extremes& extremes,
                     const Spread& spread) const;
  /// No clamping within the spread has a lower ratio at that place of the path on those branches.
  double least_ratio(const PeakPlace& place, const Clamping& clamping, const Spread& spread,
                     const Branches& branches) const;
  /// Whether the tool axis comes so near to a singularity there while it turns.
  bool meets_singularity(const PeakPlace& place, const Clamping& clamping, double within_rad) const;
  /// The same for a setup whose clampings about it, that far from it, keep off the path of the tool
  /// axis: where the path passes the pole, the first rotary axis turns by the angle that both ends
  /// of the passage are seen under from the pole. 0 where that tells nothing.
  double least_passage_ratio(const Clampings& clampings, const Extremes& extremes,
                             const Spread& spread) const;
  double least_time_s(const Clamping& clamping, const Spread& spread,
                      const Branches& branches) const;
  double least_travel_rad(const Clamping& clamping, const Spread& spread,
                          const Branches& branches) const;

  const ToolMotion& motion(const PeakPlace& place) const {
    return tools_[place.tool].tree.pieces()[place.piece].middle;
  }
  double programmed_time_s() const { return programmed_time_s_; }
  /// Whether any linear axis is held to a speed, or to a range.
  bool has_linear_speeds() const { return limits_.shares.has_linear; }
  bool has_linear_ranges() const;

  /// Whether the path comes so near to a singularity in all clampings whose poles are within
  /// `change_rad` of the one that has the extremes.
  bool is_near_singularity(const Extremes& extremes, double within_rad, double change_rad) const;
  /// Of the accuracy of a setup: farther from a singularity it does not change times and ways.
  static constexpr double near_accuracies = 3.0;
  /// Of a bound, for what the analysis of a path may leave out between its places.
  static constexpr double sure_share = 0.998;

 private:
  struct Tool {
    AxisRates rates;
    PieceTree tree;
    std::vector<Station> stations;
  };
  static constexpr int directions = 8;  ///< of the clampings about a setup
  static Clamping moved(const Clamping& nominal, double away_rad, double direction_rad);
  double largest_about(const PeakPlace& place, const Clampings& clampings, int branch) const;
  struct PieceRatio {
    double ratio = 0.0, from_middle_s = 0.0;
  };
  double passage_rate(const Tool& tool, std::uint32_t nearest, const Vec3& pole,
                      double about_rad) const;
  /// Where the linear axes are farthest out of their ranges.
  struct WorstPlace {
    double excess_mm = 0.0;
    std::uint32_t tool = 0, piece = 0;
  };
  WorstPlace worst_place(const Clamping& clamping, int branch) const;
  /// On both branches, all over the spread.
  bool is_out_of_linear_range(const WorstPlace& place, const Clamping& clamping,
                              const Spread& spread) const;
  bool may_be_within(int branch, Range<double> opening_rad) const;
  bool keeps_to_linear_ranges(const Clamping& clamping, int branch, const Spread& spread) const;
  double ratio(const PerAxis& rates) const;
  double least_ratio(const RateBounds& bounds) const;
  PieceRatio ratio_of_piece(const Tool& tool, const Piece& piece, const Clamping& clamping,
                            int branch, double at_least) const;
  bool meets_singularity(const Tool& tool, const Piece& piece, const Clamping& clamping,
                         double within_rad) const;
  double excess_mm(const Vec3& linear_mm, const Vec3& change_mm) const;

  Branches one_if_equal(const Branches& branches) const;
  template <class Part>
  double least_sum(const Clamping& clamping, const Spread& spread, const Branches& branches,
                   const Part& part) const;
  template <class Part>
  double sum(const Clamping& clamping, int branch, double tolerance, const Part& part) const;
  template <class Part>
  double largest_sum(const Clampings& clampings, int branch, double tolerance,
                     const Part& part) const;

  kinematics::Model model_;
  bool has_pole_, has_two_poles_;  ///< at the least angle that is within reach; and at the largest
  Limits limits_;
  std::vector<Tool> tools_;
  double programmed_time_s_ = 0.0;
};

}  // namespace pentapost::reorient
