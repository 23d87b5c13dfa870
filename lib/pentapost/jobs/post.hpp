#pragma once

#include "pentapost/core/output.hpp"
#include "pentapost/core/result.hpp"
#include "pentapost/core/units.hpp"
#include "pentapost/jobs/analysis_report.hpp"
#include "pentapost/jobs/line_map.hpp"
#include "pentapost/jobs/report_head.hpp"
#include "pentapost/machine/definition.hpp"
#include "pentapost/nc/lint.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace pentapost::jobs {

enum class ClUnits { mm, inch };

/// The path as the text of a CL file.
struct ClText {
  std::string text;
  std::optional<ClUnits> units = {};        ///< overrules the file
  std::optional<std::string> dialect = {};  ///< name of a CL dialect; overrules detection
};
/// The path as points, all with one feed.
struct PointPath {
  double feed_mm_min = 0.0;  ///< > 0
  std::vector<Vec3> tip_mm;
  std::vector<Vec3> axis;  ///< any length but zero; same count
};

/// How the workpiece is clamped.
struct Setup {
  std::optional<Vec3> origin_mm =
      {};  ///< CL origin in base coordinates, all joints at zero; nullopt: not known
  double theta_x_deg = 0.0;  ///< reorientation, signs of Cripps et al. 2017 (lib/README.md section
                             ///< 7); at most largest_setup_angle_deg either way
  double theta_z_deg = 0.0;  ///< likewise
};

// A larger tolerance is a misplaced decimal point, or the part is lost.
inline constexpr double largest_tip_tolerance_mm = 1.0;
inline constexpr double largest_axis_tolerance_deg = 5.0;
inline constexpr double largest_setup_angle_deg = 360.0;
inline constexpr double largest_pole_axis_deg = 5.0;

struct Tolerances {
  double tip_mm = 0.01;    ///< > 0, at most largest_tip_tolerance_mm
  double axis_deg = 0.05;  ///< > 0, at most largest_axis_tolerance_deg
};

struct PostOptions {
  std::optional<Output> output = {};                ///< nullopt: as the definition
  std::optional<std::string> dialect = {};          ///< nullopt: as the definition
  std::optional<std::string> program_name = {};     ///< nullopt: PARTNO
  std::string default_program_name = {};            ///< where there is no PARTNO either
  std::optional<machine::Preferences> prefer = {};  ///< nullopt: as the definition
  bool zone_comments = false;  ///< the program warns of each zone and over-demand where it begins
  bool lint = false;           ///< the report says what of the program its control does not want
  bool line_map = false;       ///< the report says where every block comes from
  bool flank = false;          ///< a flank cut: the tool axis has no freedom at the pole
  /// By how much the tool axis may be changed so that a path that passes a pole leads through it
  /// (lib/README.md section 4). 0 to largest_pole_axis_deg; 0 for a flank cut.
  double pole_axis_deg = 0.0;
};

struct PostJob {
  machine::Definition machine;
  std::variant<ClText, PointPath> path;
  Setup setup = {};
  std::map<int, double> gauge_length_mm = {};  ///< by tool number
  Tolerances tolerances = {};
  PostOptions post = {};
  std::map<std::string, machine::AxisLimits> limits =
      {};  ///< fill or override the definition's (rad, mm)
};

/// How far an axis goes. mm or degrees, as printed.
struct AxisReport {
  std::string name;
  bool rotary = false;
  double min = 0.0, max = 0.0;
  std::optional<Range<double>> range = {};  ///< of the definition; nullopt: endless or not given
  std::optional<double> speed_limit = {};   ///< mm/s or deg/s
};

/// A passage of a pole that was led through it.
struct PoleBendReport {
  std::uint32_t cl_line = 0;  ///< of the move that is nearest to the pole
  double change_deg = 0.0;    ///< largest change of the tool axis
};

struct RetractReport {
  std::uint32_t cl_line = 0;
  std::string reason;
};

struct Verification {
  bool passed = false;
  double tip_deviation_mm = 0.0;  ///< largest over the whole of every block
  double axis_deviation_deg = 0.0;
  std::uint64_t blocks_read = 0;
};

struct PostReport : ReportHead {
  std::string nc;  ///< the NC program
  std::string dialect;
  Output output = Output::tcp;
  std::uint64_t blocks = 0;  ///< motion blocks
  std::uint64_t inserted_points = 0;
  std::vector<InsertedStretch> insertions;  ///< why these are there; those of pole_bends left out
  std::optional<LineMap> line_map = {};     ///< nullopt: not asked for
  double length_mm = 0.0;                   ///< of the tip's cutting path
  double programmed_time_s = 0.0;           ///< of the cutting path at the programmed feed
  std::optional<double> predicted_time_s = {};  ///< of it, slowed down to the speed limits
  ZonesReport zones, over_demands;              ///< where an axis is over its speed limit
  /// Largest change of the tool axis: by the bends, or by the freedom at the pole and at the edge
  /// of the reach.
  double pole_axis_change_deg = 0.0;
  std::vector<PoleBendReport> pole_bends;
  std::vector<AxisReport> axes;
  std::vector<RetractReport> retracts;
  Verification verification;
  nc::LintReport lint;  ///< empty too where it is not asked for
  Diagnostics diagnostics;
};

/// Whether the options of a definition's controller are those of its dialect and can be used.
///
/// @return Problem bad_option or unknown_dialect, its pointer into the definition.
Status check_options(const machine::Definition& definition);

/// CL data in, proven NC program out. No program without a passed proof.
///
/// @return the program and its report, or the Problem: CL data (400), this machine can't (422), or
///         Code::proof_failed (500), which names the block. What the text of the CL data or of the
///         controller's options keeps from being proven is not_in_dialect.
Result<PostReport> post(const PostJob& job);

}  // namespace pentapost::jobs
