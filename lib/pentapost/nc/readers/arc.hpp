#pragma once

#include "pentapost/nc/readers/axis_columns.hpp"
#include "pentapost/nc/readers/circle.hpp"
#include "pentapost/nc/readers/item_stream.hpp"

namespace pentapost::nc::readers {

/// An arc across Z from where the axes are to the end of its motion, which has its sense already.
/// Its functions give false on a Problem.
class ArcBlock {
 public:
  /// All must outlive it.
  /// @param largest_radius_mismatch_mm  by so much start and end may differ in their distance from
  /// the centre.
  ArcBlock(const AxisColumns& columns, double largest_radius_mismatch_mm, ReadMotion& motion,
           ItemStream& items)
      : columns_{columns},
        largest_radius_mismatch_mm_{largest_radius_mismatch_mm},
        motion_{motion},
        items_{items} {}

  /// Problem bad_arc where the place of X or Y is not known, not_in_dialect where an axis other
  /// than X, Y and Z moves. To be called first.
  bool open();
  PlanePoint start() const { return start_; }
  /// @param radius_mm  > 0: the arc is at most 180 deg; < 0: at least 180 deg.
  bool set_radius(double radius_mm);
  bool set_centre(PlanePoint centre);

 private:
  const AxisColumns& columns_;
  double largest_radius_mismatch_mm_;
  ReadMotion& motion_;
  ItemStream& items_;
  PlanePoint start_, end_;
};

}  // namespace pentapost::nc::readers
