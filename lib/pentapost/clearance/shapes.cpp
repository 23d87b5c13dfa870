#include "pentapost/clearance/shapes.hpp"

#include <ccd/ccd.h>

#include <algorithm>
#include <cmath>

namespace pentapost::clearance {
namespace {

/// std::hypot() guards against overflow, which lengths in mm don't need.
double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

/// Half the length of a body's projection onto `direction` (unit).
double half_extent_mm(const Cylinder& body, const Vec3& direction) {
  const double cosine = body.axis.dot(direction);
  return body.half_length_mm * std::abs(cosine) +
         body.radius_mm * std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
}
double half_extent_mm(const Box& body, const Vec3& direction) {
  return (body.directions.transpose() * direction).cwiseAbs().dot(body.half_size_mm);
}

/// Gaps along the axis of `round` and along the radius towards the other body, which are at right
/// angles: the distance is no shorter than their sum as vectors.
template <class Other>
double gap_about_axis_mm(const Cylinder& round, const Other& other) {
  const Vec3 way = other.centre_mm - round.centre_mm;
  const double along_mm = way.dot(round.axis);
  const double gap_along_mm =
      std::abs(along_mm) - round.half_length_mm - half_extent_mm(other, round.axis);
  const Vec3 across = way - along_mm * round.axis;
  const double across_mm = across.norm();
  const double gap_across_mm = across_mm > 0.0 ? across_mm - round.radius_mm -
                                                     half_extent_mm(other, Vec3{across / across_mm})
                                               : 0.0;
  return length_of(std::max(gap_along_mm, 0.0), std::max(gap_across_mm, 0.0));
}

double gap_along_edges_mm(const Cylinder& tool, const Box& box) {
  const Vec3 way = box.directions.transpose() * (tool.centre_mm - box.centre_mm);
  const Vec3 cosines = box.directions.transpose() * tool.axis;
  Vec3 gap;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosines[i] * cosines[i]));
    gap[i] = std::abs(way[i]) - box.half_size_mm[i] - tool.half_length_mm * std::abs(cosines[i]) -
             tool.radius_mm * sine;
  }
  return gap.cwiseMax(0.0).norm();
}

/// Gap in the directions of the obstacle's own faces: tells most pairs apart.
double gap_about_obstacle_mm(const Cylinder& tool, const Cylinder& obstacle) {
  return gap_about_axis_mm(obstacle, tool);
}
double gap_about_obstacle_mm(const Cylinder& tool, const Box& obstacle) {
  return gap_along_edges_mm(tool, obstacle);
}

double ball_radius_mm(const Cylinder& body) {
  return length_of(body.half_length_mm, body.radius_mm);
}
double ball_radius_mm(const Box& body) { return body.half_size_mm.norm(); }

/// Whether the gaps show more than `margin_mm` between the bodies; the cheapest are tried first.
template <class Body>
bool gap_exceeds(const Cylinder& tool, const Body& obstacle, double margin_mm) {
  const double balls_mm = ball_radius_mm(tool) + ball_radius_mm(obstacle) + margin_mm;
  return (obstacle.centre_mm - tool.centre_mm).squaredNorm() > balls_mm * balls_mm ||
         gap_about_obstacle_mm(tool, obstacle) > margin_mm ||
         gap_about_axis_mm(tool, obstacle) > margin_mm;
}

// The real shapes, by the Gilbert-Johnson-Keerthi algorithm of libccd. It asks whether two bodies
// overlap; a distance is asked for by growing one of them. Coordinates are relative to the tool.

/// A direction is asked this often at most.
constexpr unsigned long most_iterations = 1000;

/// A body as libccd sees it: `body` with a skin of `skin_mm`, seen from `origin_mm`.
template <class Body>
struct Grown {
  const Body& body;
  Vec3 origin_mm;
  double skin_mm = 0.0;
  Vec3 first_direction = Vec3::UnitX();
  unsigned long asked = 0;
};

Vec3 farthest_mm(const Cylinder& body, const Vec3& direction) {
  const double along = direction.dot(body.axis);
  const Vec3 across = direction - along * body.axis;
  const double across_length = across.norm();
  Vec3 point = body.centre_mm + std::copysign(body.half_length_mm, along) * body.axis;
  if (across_length > 0.0) point += body.radius_mm / across_length * across;
  return point;
}
Vec3 farthest_mm(const Box& body, const Vec3& direction) {
  const Vec3 sides = body.directions.transpose() * direction;
  Vec3 corner;
  for (Eigen::Index i = 0; i < 3; ++i) corner[i] = std::copysign(body.half_size_mm[i], sides[i]);
  return body.centre_mm + body.directions * corner;
}

template <class Body>
void support(const void* object, const ccd_vec3_t* towards, ccd_vec3_t* point) {
  // libccd hands back the pointer that it was given, which is not one to a const object.
  auto& grown = *static_cast<Grown<Body>*>(const_cast<void*>(object));
  ++grown.asked;
  const Vec3 direction{towards->v[0], towards->v[1], towards->v[2]};
  Vec3 farthest = farthest_mm(grown.body, direction) - grown.origin_mm;
  const double length = direction.norm();
  if (grown.skin_mm > 0.0 && length > 0.0) farthest += grown.skin_mm / length * direction;
  ccdVec3Set(point, farthest.x(), farthest.y(), farthest.z());
}

void first_direction(const void* object, const void* /*other*/, ccd_vec3_t* direction) {
  const Vec3& first = static_cast<const Grown<Cylinder>*>(object)->first_direction;
  ccdVec3Set(direction, first.x(), first.y(), first.z());
}

template <class Body>
bool overlap(Grown<Cylinder>& tool, Grown<Body>& obstacle) {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.first_dir = first_direction;
  ccd.support1 = support<Cylinder>;
  ccd.support2 = support<Body>;
  ccd.max_iterations = most_iterations;
  tool.asked = 0;
  // Out of iterations it says no; within 1e-4 mm of touching, that is a yes here.
  return ccdGJKIntersect(&tool, &obstacle, &ccd) != 0 || tool.asked >= most_iterations;
}

// In places of symmetry the algorithm may stop at a simplex that it takes for one about the origin.
// Directions that are parallel to nothing avoid nearly all of them, and two do so in different
// ways.
const Vec3 irregular_direction{0.347, -0.513, 0.785}, second_direction{-0.621, 0.137, -0.772};

bool overlap_from(const Cylinder& tool, const Obstacle& obstacle, double margin_mm,
                  const Vec3& direction) {
  Grown<Cylinder> grown_tool{.body = tool,
                             .origin_mm = tool.centre_mm,
                             .skin_mm = margin_mm,
                             .first_direction = direction};
  return std::visit(
      [&](const auto& body) {
        Grown<std::decay_t<decltype(body)>> grown{.body = body, .origin_mm = tool.centre_mm};
        return overlap(grown_tool, grown);
      },
      obstacle);
}

}  // namespace

double distance_bound_mm(const Cylinder& tool, const Obstacle& obstacle) {
  return std::visit(
      [&](const auto& body) {
        return std::max(gap_about_obstacle_mm(tool, body), gap_about_axis_mm(tool, body));
      },
      obstacle);
}

bool bound_exceeds(const Cylinder& tool, const Obstacle& obstacle, double margin_mm) {
  return std::visit([&](const auto& body) { return gap_exceeds(tool, body, margin_mm); }, obstacle);
}

bool may_be_within(const Cylinder& tool, const Obstacle& obstacle, double margin_mm) {
  return !bound_exceeds(tool, obstacle, margin_mm) &&
         overlap_from(tool, obstacle, margin_mm, irregular_direction);
}

bool is_within(const Cylinder& tool, const Obstacle& obstacle, double margin_mm) {
  return may_be_within(tool, obstacle, margin_mm) &&
         overlap_from(tool, obstacle, margin_mm, second_direction);
}

double distance_within_mm(const Cylinder& tool, const Obstacle& obstacle, double margin_mm) {
  if (is_within(tool, obstacle, 0.0)) return 0.0;
  constexpr double resolution_mm = 1e-3;
  double apart_mm = 0.0, within_mm = margin_mm;
  while (within_mm - apart_mm > resolution_mm) {
    const double middle_mm = 0.5 * (apart_mm + within_mm);
    (is_within(tool, obstacle, middle_mm) ? within_mm : apart_mm) = middle_mm;
  }
  return within_mm;
}

}  // namespace pentapost::clearance
