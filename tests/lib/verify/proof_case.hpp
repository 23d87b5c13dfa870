#pragma once

#include "pentapost/core/units.hpp"
#include "sample_program.hpp"

#include <cmath>
#include <string>

/// The proof of `program` fails, and says `part`.
#define EXPECT_FAILURE(program, part) \
  EXPECT_NE((program).failure().find(part), std::string::npos) << (program).failure()

namespace pentapost::sample {

/// Tool axis of hermle-c600u: Rz(-C) Rx(-A) z (Cripps et al. 2017 eq. (1)).
inline Vec3 hermle_axis(double c_deg, double a_deg) {
  const double c = c_deg * rad_per_deg, a = a_deg * rad_per_deg;
  return {std::sin(a) * std::sin(c), std::sin(a) * std::cos(c), std::cos(a)};
}

/// Three cuts with TCP, a rapid to their start, tool 2, spindle clockwise, feed 500.
inline Program right_program() {
  Program program{trunnion_ac(), "XYZAC"};
  program.cl.add_event(1, path::ToolChange{.number = 2});
  program.cl.add_event(2, path::Spindle{path::Spindle::State::clockwise, 3000.0});
  program.point({0, 0, 50}, hermle_axis(10, 20), path::Move::rapid);
  program.cl.add_event(15, path::FeedRate{500.0});
  program.point({0, 0, 0}, hermle_axis(10, 20));
  program.point({10, 0, 0}, hermle_axis(11, 21));
  program.point({20, 5, 1}, hermle_axis(12, 23));
  program.line("T2");
  program.line("S3000");
  program.off("G0 A20 C10", 0);
  program.line("TCP1");
  program.block("G0 X0 Y0 Z50 A20 C10", 0);
  program.block("G1 X0 Y0 Z0 A20 C10 F500", 1);
  program.block("G1 X5 Y0 Z0 A20.5 C10.5", 2, 0.5);
  program.block("G1 X10 Y0 Z0 A21 C11", 2);
  program.block("G1 X20 Y5 Z1 A23 C12", 3);
  program.line("TCP0");
  program.line("RETRACT");
  program.line("S0");
  program.line("END");
  return program;
}

}  // namespace pentapost::sample
