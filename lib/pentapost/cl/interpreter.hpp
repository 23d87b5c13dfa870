#pragma once

#include "pentapost/cl/arcs.hpp"
#include "pentapost/cl/cycle_words.hpp"
#include "pentapost/cl/dialects.hpp"
#include "pentapost/cl/length_unit.hpp"
#include "pentapost/cl/nurbs.hpp"
#include "pentapost/cl/reader.hpp"
#include "pentapost/cl/statements.hpp"
#include "pentapost/cl/words.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pentapost::cl {

/// Turns statements, one after the other, into points, events and diagnostics.
class Interpreter {
 public:
  /// @param result  filled; must outlive the interpreter.
  Interpreter(const ClDialect& dialect, const UnitStatements& units, const ReadOptions& options,
              ReadResult& result);

  void read(const Statement& statement);
  void finish();

  using Handler = void (Interpreter::*)(const Major&);

  // Motion: motion_statements.cpp
  void go_to(std::string_view coordinates);
  void go_to_statement(const Major& major);
  void from(const Major& major);
  void go_delta(const Major& major);
  void go_home(const Major& major);
  void rapid(const Major& major);
  void tool_axis(const Major& major);
  void multax(const Major& major);
  void unreadable_motion(const Major& major);
  void clearance_motion(const Major& major);
  void frame_change(const Major& major);
  void coordinate_mode(const Major& major);
  // Curves: curve_statements.cpp
  void circle(const Major& major);
  void start_tangent(const Major& major);
  void tool_on_curve(const Major& major);
  void nurbs(const Major& major);
  void knots(const Major& major);
  void controls(const Major& major);
  // Holes: hole_statements.cpp
  void cycle(const Major& major);
  // Tool, spindle, feed: tool_statements.cpp
  void load_tool(const Major& major);
  void load(const Major& major);
  void select(const Major& major);
  void tool_path(const Major& major);
  void end_of_path(const Major& major);
  void cutter(const Major& major);
  void spindle(const Major& major);
  void feed(const Major& major);
  // All others: other_statements.cpp
  void coolant(const Major& major);
  void unit_statement(const Major& major);
  void part_name(const Major& major);
  void print(const Major& major);
  void tool_name(const Major& major);
  void insert(const Major& major);
  void auxiliary_function(const Major& major);
  void delay(const Major& major);
  void stop(const Major& major);
  void optional_stop(const Major& major);
  void cutter_compensation(const Major& major);
  void without_effect(const Major& major);
  void silent(const Major& major);

 private:
  void dispatch(const Statement& statement);
  void unknown(const Statement& statement);
  void comment(const Statement& statement);
  void data_comment(const Statement& statement);

  /// Reports at the line of the statement that is being read; the text is made only if it is kept.
  template <class MakeText>
  void report(Severity severity, Code code, MakeText&& make_text) {
    report_at(severity, code, line_, std::forward<MakeText>(make_text));
  }
  template <class MakeText>
  void report_at(Severity severity, Code code, std::uint32_t line, MakeText&& make_text) {
    if (diagnostics_.keeps(severity))
      diagnostics_.add({severity, code, line, make_text()});
    else
      diagnostics_.count(severity);
  }
  void report_damage(Severity severity, Code code, std::string_view expected);
  void report_coordinates(const Coordinates& found, std::string_view expected);

  bool set_axis(const Vec3& written);
  bool is_in_range(const Vec3& tip_mm);
  void move_to(const Vec3& tip_mm);
  void add_feed_point(const Vec3& tip_mm);
  void finish_arc(const Vec3& tip_mm);
  void drop_arc();
  void add_arc(const ArcStatement& statement, const Vec3& tip_mm);
  std::optional<ArcStatement> catia_arc(Vec3& end_mm);
  void finish_nurbs();
  void add_hole(const Vec3& tip_mm);
  bool place_hole(const Vec3& tip_mm, Vec3& top_mm);
  void end_cycle();
  void change_tool(int number, std::optional<int> length_register);
  void change_tool_as_written(std::optional<int> number);
  void add_tool_data(std::optional<double> diameter, std::optional<double> corner_radius,
                     std::optional<double> length);
  void check_feed_unit(const FeedUnit& unit, std::string_view word);
  void check_low_feed(double feed_mm_min);
  double resolution_mm() const;
  double axis_rounding_rad() const;

  const ClDialect& dialect_;
  ReadResult& result_;
  path::ToolPath& path_;
  Diagnostics& diagnostics_;

  const Statement* statement_ = nullptr;  ///< that is being read
  std::uint32_t line_ = 0;                ///< its line
  Words words_;

  UnitStatements units_found_;
  bool units_are_given_ = false;  ///< by the request
  Units units_ = Units::mm;
  double mm_ = 1.0;  ///< mm per unit of the file
  std::uint32_t units_line_ = 0;
  bool unit_conflict_reported_ = false;

  Vec3 tip_mm_ = Vec3::Zero();
  Vec3 axis_ = Vec3::UnitZ();
  bool tip_is_known_ = false;
  bool rapid_ = false;
  bool feed_is_known_ = false;
  bool no_feed_reported_ = false;
  bool low_feed_reported_ = false;
  int tip_decimals_ = 0, axis_decimals_ = 0;
  bool axis_written_ = false;
  double axis_length_error_ = 0.0;  ///< largest seen

  std::optional<ArcStatement> arc_;
  std::optional<Vec3> start_tangent_;
  std::vector<std::size_t> open_arcs_;  ///< events whose sense their neighbours decide
  std::optional<NurbsBlock> nurbs_;
  std::size_t curve_points_left_ = 5'000'000;

  bool cycle_is_on_ = false;
  bool cycle_is_written_ = false;  ///< the event of cycle_ is in the path
  std::optional<CycleStatement> cycle_;
  std::uint32_t cycle_line_ = 0;
  double expanded_moves_ = 0.0;  ///< that all holes would need

  path::Spindle spindle_;
  path::Spindle::State last_direction_ = path::Spindle::State::clockwise;
  FeedUnit feed_unit_;
  path::Coolant::State last_coolant_ = path::Coolant::State::flood;
  std::string tool_name_;         ///< for the next tool change
  std::string loaded_tool_name_;  ///< of the TOOL PATH in which the tool in use was loaded
  std::string path_tool_name_;    ///< of the TOOL PATH that is being read
  std::uint32_t path_tool_line_ = 0;
  std::optional<int> selected_tool_;

  bool in_text_ = false;  ///< lines that are no statement are text around the file's data
};

}  // namespace pentapost::cl
