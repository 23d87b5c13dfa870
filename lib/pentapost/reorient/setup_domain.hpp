#pragma once

#include "pentapost/core/units.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace pentapost::reorient {

/// A way to clamp the workpiece.
struct SetupPoint {
  double theta_x_deg = 0.0, theta_z_deg = 0.0;  ///< signs of path::setup_turn()
  Vec3 origin_mm = Vec3::Zero();                ///< CL origin in the table frame
  bool operator==(const SetupPoint&) const = default;
  /// By the dimensions of a SetupDomain.
  double operator[](std::size_t dimension) const {
    return dimension == 0   ? theta_x_deg
           : dimension == 1 ? theta_z_deg
                            : origin_mm[static_cast<Eigen::Index>(dimension) - 2];
  }
  double& operator[](std::size_t dimension) {
    return dimension == 0   ? theta_x_deg
           : dimension == 1 ? theta_z_deg
                            : origin_mm[static_cast<Eigen::Index>(dimension) - 2];
  }
};

/// Values that one number of a setup may take.
class Coordinate {
 public:
  static Coordinate interval(double lower, double upper);
  /// @param values  at least one; any order.
  static Coordinate list(std::vector<double> values);

  /// A part of it: of an interval the numbers, of a list the places.
  struct Part {
    double lower, upper;
    std::size_t begin = 0, end = 0;
  };
  Part whole() const;
  double middle(const Part& part) const;
  /// The value of the part that is nearest to `wanted`.
  double nearest(const Part& part, double wanted) const;
  /// Of any value of the part from its middle.
  double reach(const Part& part) const;
  bool can_be_split(const Part& part) const;
  std::array<Part, 2> split(const Part& part) const;
  bool is_list() const { return !values_.empty(); }
  const std::vector<double>& values() const { return values_; }

 private:
  double lower_ = 0.0, upper_ = 0.0;
  std::vector<double> values_;  ///< in order; empty: an interval
};

/// Values of both angles that exclude a setup, ends included; nullopt: any.
struct ForbiddenSetups {
  std::optional<Range<double>> theta_x_deg, theta_z_deg;
};

/// All setups that come into question.
struct SetupDomain {
  static constexpr std::size_t dimensions = 5;  ///< theta_x, theta_z, origin x, y, z
  std::array<Coordinate, dimensions> coordinates;
  std::vector<ForbiddenSetups> forbidden;

  bool allows(const SetupPoint& point) const;
  /// The setup whose numbers the coordinates have that is nearest to `wanted`, whole turns apart;
  /// it may be forbidden.
  SetupPoint nearest(const SetupPoint& wanted) const;
};

/// A part of the domain.
struct SetupCell {
  std::array<Coordinate::Part, SetupDomain::dimensions> parts;
};

SetupCell whole(const SetupDomain& domain);
SetupPoint middle(const SetupDomain& domain, const SetupCell& cell);
/// Whether every setup of the cell is forbidden.
bool is_forbidden(const SetupDomain& domain, const SetupCell& cell);

}  // namespace pentapost::reorient
