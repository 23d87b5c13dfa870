#include "pentapost/cl/interpreter.hpp"

#include <cmath>

namespace pentapost::cl {
namespace {

constexpr double nurbs_chord_error_mm = 0.001;

/// The numbers behind `word` up to the next word.
std::vector<double> numbers_behind(const Words& words, std::size_t at) {
  std::vector<double> numbers;
  for (++at; at < words.size() && words[at].is_number(); ++at) numbers.push_back(words[at].number);
  return numbers;
}

/// Index of the last `word`; words.size(): none.
std::size_t last_of(const Words& words, std::string_view word) {
  std::size_t found = words.size();
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i].is(word)) found = i;
  return found;
}

}  // namespace

void Interpreter::circle(const Major& major) {
  drop_arc();
  words_.read(major.rest);
  std::string fault;
  arc_ = read_arc(words_, dialect_.arc_sense, mm_, fault);
  if (!arc_) return report_damage(Severity::error, Code::damaged_motion, fault);
  arc_->line = line_;
}

void Interpreter::drop_arc() {
  if (!arc_) return;
  report_at(Severity::error, Code::bad_arc, arc_->line,
            [] { return std::string{"The arc has no end point: expected a GOTO behind it."}; });
  arc_.reset();
}

void Interpreter::finish_arc(const Vec3& tip_mm) {
  const ArcStatement statement = *arc_;
  arc_.reset();
  add_arc(statement, tip_mm);
}

void Interpreter::add_arc(const ArcStatement& statement, const Vec3& tip_mm) {
  if (path_.size() == 0 || !tip_is_known_ || path_.tip_wp_mm.back() != tip_mm_) {
    report_at(Severity::error, Code::bad_arc, statement.line,
              [] { return std::string{"The arc has no start point: expected a GOTO before it."}; });
    return;
  }
  const MadeArc made = make_arc(statement, tip_mm_, tip_mm, resolution_mm());
  if (!made.remark.empty())
    report_at(made.is_error ? Severity::error : Severity::warning, Code::bad_arc, statement.line,
              [&] { return made.remark; });
  if (!made.arc) return;
  if (rapid_) {
    rapid_ = false;
    report_at(Severity::warning, Code::bad_arc, statement.line, [] {
      return std::string{"An arc cannot be run at rapid rate: it runs at the feed that is on."};
    });
  }
  if (made.sense_is_open) open_arcs_.push_back(path_.events.size());
  path_.add_event(statement.line, *made.arc);
}

void Interpreter::start_tangent(const Major& major) {
  const Coordinates found = read_coordinates(major.rest);
  start_tangent_.reset();
  if (found.fault == Coordinates::Fault::none && found.count == 3)
    start_tangent_ = Vec3{found.value[0], found.value[1], found.value[2]};
}

/// "TLON,GOFWD/(CIRCLE/c,r),ON,(LINE/c,end)" and its form with CYLNDR/c,axis,r and POINT/end: the
/// tangent at the start is in the INDIRV before it.
std::optional<ArcStatement> Interpreter::catia_arc(Vec3& end_mm) {
  const std::size_t circle_at = last_of(words_, "CIRCLE"), cylinder_at = last_of(words_, "CYLNDR");
  const bool is_cylinder = circle_at == words_.size();
  const auto numbers = numbers_behind(words_, is_cylinder ? cylinder_at : circle_at);
  auto end = numbers_behind(words_, last_of(words_, is_cylinder ? "POINT" : "LINE"));
  if (words_.has_damage() || !start_tangent_ || numbers.size() != (is_cylinder ? 7U : 4U) ||
      end.size() != (is_cylinder ? 3U : 6U))
    return std::nullopt;
  ArcStatement statement;
  statement.line = line_;
  statement.centre_mm = mm_ * Vec3{numbers[0], numbers[1], numbers[2]};
  statement.radius_mm = mm_ * numbers.back();
  if (is_cylinder) statement.vector = Vec3{numbers[3], numbers[4], numbers[5]};
  if (!(statement.vector.stableNorm() > 1e-6)) return std::nullopt;
  statement.vector.stableNormalize();
  end_mm = mm_ * Vec3{end[end.size() - 3], end[end.size() - 2], end[end.size() - 1]};
  const double right = start_tangent_->dot(statement.vector.cross(tip_mm_ - statement.centre_mm));
  statement.sense = right >= 0.0 ? ArcSense::right_handed : ArcSense::left_handed;
  return statement;
}

void Interpreter::tool_on_curve(const Major& major) {
  drop_arc();
  words_.read(major.rest);
  Vec3 end_mm = Vec3::Zero();
  const auto statement = catia_arc(end_mm);
  start_tangent_.reset();
  if (!statement)
    return report_damage(Severity::error, Code::damaged_motion,
                         "INDIRV/ and TLON,GOFWD/(CIRCLE/4 numbers),ON,(LINE/6 numbers)");
  if (!is_in_range(end_mm) || !is_in_range(statement->centre_mm)) return;
  if (!cycle_is_on_) add_arc(*statement, end_mm);
  move_to(end_mm);
}

void Interpreter::nurbs(const Major& major) {
  drop_arc();
  nurbs_.emplace();
  nurbs_->line = line_;
  nurbs_->add_header(major.rest);
}

void Interpreter::knots(const Major& major) {
  if (!nurbs_) return report_damage(Severity::error, Code::bad_nurbs, "NURBS/ before it");
  nurbs_->add_knots(major.rest);
}

void Interpreter::controls(const Major& major) {
  if (!nurbs_) return report_damage(Severity::error, Code::bad_nurbs, "NURBS/ before it");
  nurbs_->add_controls(major.rest);
}

void Interpreter::finish_nurbs() {
  const NurbsBlock block = std::move(*nurbs_);
  nurbs_.reset();
  const DividedCurve curve = divide_nurbs(block, mm_, nurbs_chord_error_mm, curve_points_left_);
  if (!curve.fault.empty()) {
    report_at(Severity::error, Code::bad_nurbs, block.line,
              [&] { return "The NURBS block is not readable: " + curve.fault + "."; });
    return;
  }
  curve_points_left_ -= curve.points.size();
  const std::uint32_t line = line_;
  line_ = block.line;
  rapid_ = false;
  const bool starts_here =
      tip_is_known_ && (curve.points.front().tip_mm - tip_mm_).norm() <= resolution_mm();
  for (std::size_t i = starts_here ? 1 : 0; i < curve.points.size(); ++i) {
    if (curve.points[i].axis) axis_ = *curve.points[i].axis;
    add_feed_point(curve.points[i].tip_mm);
  }
  tip_mm_ = curve.points.back().tip_mm;
  tip_is_known_ = true;
  report(Severity::info, Code::nurbs_linearised, [&] {
    return "The NURBS curve was divided into " + std::to_string(curve.points.size() - 1) +
           " straight moves with a chord error of at most 0.001 mm.";
  });
  line_ = line;
}

}  // namespace pentapost::cl
