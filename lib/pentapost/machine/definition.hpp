#pragma once

#include "pentapost/core/output.hpp"
#include "pentapost/core/units.hpp"
#include "pentapost/machine/chain.hpp"
#include "pentapost/machine/clearance.hpp"

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace pentapost::machine {

/// What an axis can do. mm or rad, seconds. nullopt: no source gives it.
struct AxisLimits {
  std::optional<double> max_speed = {};
  std::optional<double> max_acceleration = {};
  std::optional<double> max_jerk = {};
};

/// Which of equal solutions a cutting sequence starts with; continuity decides from there.
struct Preferences {
  enum class Tilt { positive, negative };
  std::optional<Tilt> tilt = {};                ///< sign of the tool-side rotary axis
  std::optional<Range<Angle>> first_turn = {};  ///< window for the workpiece-side rotary axis
};

using OptionValue = std::variant<bool, double, std::string, std::vector<std::string>>;
using Options = std::map<std::string, OptionValue>;

struct Controller {
  std::string dialect;
  Output output = Output::tcp;
  Options options = {};  ///< the dialect says which there are; checked against it
};

/// One version of one machine. Immutable.
struct Definition {
  std::string name;
  std::string version;
  std::string title;
  std::vector<std::string> sources;
  Chain chain;
  std::map<std::string, AxisLimits> limits;  ///< by joint name
  Preferences preferences;
  Controller controller;
  std::string sha256;        ///< of the file's bytes
  Clearance clearance = {};  ///< for the check for collisions
};

}  // namespace pentapost::machine
