#include "pentapost/nc/readers/klartext_cycle.hpp"

#include "pentapost/core/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

namespace pentapost::nc::readers::klartext {
namespace {

using Hole = ReadMotion::Hole;

constexpr double largest_length_mm = 99'999.9999;
constexpr double longest_dwell_s = 3600.0;
constexpr double largest_feed_mm_min = 99'999.999;

/// What a Q parameter must be for the cycle to be understood.
enum class Use : std::uint8_t {
  needed,    ///< a number that says what the cycle does
  optional,  ///< the same; 0 where it is missing
  any,       ///< says nothing that matters here
  zero,      ///< anything but 0 changes the cycle in a way not modelled
};

struct Rule {
  int number;
  Use use;
};

struct CycleRules {
  int number;
  std::string_view word;
  std::span<const Rule> rules;
};

// User's manuals cycle programming, fixed cycles: drilling, tapping. What newer software versions
// have added is optional.
constexpr std::array drilling_rules{
    Rule{200, Use::needed}, Rule{201, Use::needed},   Rule{206, Use::needed},
    Rule{202, Use::needed}, Rule{210, Use::any},      Rule{203, Use::needed},
    Rule{204, Use::needed}, Rule{211, Use::optional}, Rule{395, Use::zero}};
constexpr std::array reaming_rules{Rule{200, Use::needed}, Rule{201, Use::needed},
                                   Rule{206, Use::needed}, Rule{211, Use::optional},
                                   Rule{208, Use::any},    Rule{203, Use::needed},
                                   Rule{204, Use::needed}};
constexpr std::array boring_rules{
    Rule{200, Use::needed},   Rule{201, Use::needed},   Rule{206, Use::needed},
    Rule{211, Use::optional}, Rule{208, Use::any},      Rule{203, Use::needed},
    Rule{204, Use::needed},   Rule{214, Use::optional}, Rule{336, Use::any}};
constexpr std::array universal_drilling_rules{
    Rule{200, Use::needed}, Rule{201, Use::needed},   Rule{206, Use::needed},
    Rule{202, Use::needed}, Rule{210, Use::any},      Rule{203, Use::needed},
    Rule{204, Use::needed}, Rule{212, Use::zero},     Rule{213, Use::optional},
    Rule{205, Use::any},    Rule{211, Use::optional}, Rule{208, Use::any},
    Rule{256, Use::any},    Rule{395, Use::zero}};
constexpr std::array universal_pecking_rules{
    Rule{200, Use::needed},   Rule{201, Use::needed},   Rule{206, Use::needed},
    Rule{202, Use::needed},   Rule{203, Use::needed},   Rule{204, Use::needed},
    Rule{212, Use::zero},     Rule{205, Use::any},      Rule{258, Use::any},
    Rule{259, Use::any},      Rule{257, Use::optional}, Rule{256, Use::any},
    Rule{211, Use::optional}, Rule{379, Use::zero},     Rule{253, Use::any},
    Rule{208, Use::any},      Rule{395, Use::zero}};
constexpr std::array tapping_rules{Rule{200, Use::needed}, Rule{201, Use::needed},
                                   Rule{206, Use::needed}, Rule{211, Use::any},
                                   Rule{203, Use::needed}, Rule{204, Use::needed}};
constexpr std::array rigid_tapping_rules{Rule{200, Use::needed}, Rule{201, Use::needed},
                                         Rule{239, Use::needed}, Rule{203, Use::needed},
                                         Rule{204, Use::needed}};
constexpr std::array chip_breaking_tapping_rules{
    Rule{200, Use::needed}, Rule{201, Use::needed}, Rule{239, Use::needed},
    Rule{203, Use::needed}, Rule{204, Use::needed}, Rule{257, Use::optional},
    Rule{256, Use::any},    Rule{336, Use::any},    Rule{403, Use::any}};
constexpr std::array centring_rules{Rule{200, Use::needed}, Rule{343, Use::zero},
                                    Rule{201, Use::needed}, Rule{344, Use::any},
                                    Rule{206, Use::needed}, Rule{211, Use::optional},
                                    Rule{203, Use::needed}, Rule{204, Use::needed},
                                    Rule{342, Use::any},    Rule{253, Use::any}};

constexpr std::array all_rules{
    CycleRules{200, "CYCL DEF 200", drilling_rules},
    CycleRules{201, "CYCL DEF 201", reaming_rules},
    CycleRules{202, "CYCL DEF 202", boring_rules},
    CycleRules{203, "CYCL DEF 203", universal_drilling_rules},
    CycleRules{205, "CYCL DEF 205", universal_pecking_rules},
    CycleRules{206, "CYCL DEF 206", tapping_rules},
    CycleRules{207, "CYCL DEF 207", rigid_tapping_rules},
    CycleRules{209, "CYCL DEF 209", chip_breaking_tapping_rules},
    CycleRules{240, "CYCL DEF 240", centring_rules},
};

const CycleRules* find_rules(int number) {
  const auto found = std::ranges::find(all_rules, number, &CycleRules::number);
  return found == all_rules.end() ? nullptr : &*found;
}

std::string q_name(int number) { return "Q" + std::to_string(number); }

bool fail(ItemStream& items, const CycleRules& rules, const std::string& what) {
  return items.fail(Code::bad_cycle, std::string{rules.word} + ": " + what);
}

bool is_understood(const CycleRules& rules, const CycleParameters& parameters, ItemStream& items) {
  for (const CycleParameters::One& one : parameters) {
    const auto rule = std::ranges::find(rules.rules, one.number, &Rule::number);
    if (rule == rules.rules.end())
      return fail(items, rules, q_name(one.number) + " is not understood");
    if (rule->use == Use::zero && one.value != 0.0)
      return fail(items, rules, q_name(one.number) + " is understood as 0 only");
    if (rule->use != Use::any && !one.value)
      return fail(items, rules, q_name(one.number) + " is no number");
  }
  for (const Rule& rule : rules.rules)
    if (rule.use == Use::needed && !parameters.value(rule.number))
      return fail(items, rules, q_name(rule.number) + " is missing");
  return true;
}

bool is_in_range(const CycleRules& rules, const Cycle& cycle, ItemStream& items) {
  const bool lengths = std::abs(cycle.surface_z_mm) <= largest_length_mm &&
                       cycle.depth_mm <= largest_length_mm && cycle.clearance_mm >= 0.0 &&
                       cycle.clearance_mm <= largest_length_mm && cycle.retract_mm >= 0.0 &&
                       cycle.retract_mm <= largest_length_mm && cycle.peck_mm <= largest_length_mm;
  if (!lengths || !(cycle.dwell_s >= 0.0 && cycle.dwell_s <= longest_dwell_s))
    return fail(items, rules, "a number is out of the control's range");
  if (!(cycle.depth_mm > 0.0)) return fail(items, rules, "Q201 is understood below 0 only");
  if (cycle.feed_mm_min < 0.0 || cycle.feed_mm_min > largest_feed_mm_min ||
      (cycle.feed_mm_min == 0.0 && cycle.pitch_mm == 0.0))
    return fail(items, rules, "Q206 is no feed");
  return true;
}

/// Pecks and hand of the cycle; false: they are not understood.
bool set_hole(Cycle& cycle, const CycleParameters& parameters) {
  const double infeed_mm = parameters.value(202).value_or(0.0);
  const double break_mm = parameters.value(257).value_or(0.0);
  const double breaks = parameters.value(213).value_or(0.0);
  const bool in_one = infeed_mm >= cycle.depth_mm;
  switch (cycle.number) {
    case 200:
    case 203:
      if (!(infeed_mm > 0.0)) return false;
      if (breaks > 0.0) {
        // Every break that is left over keeps the tool in the hole.
        cycle.hole = breaks + 1.0 >= cycle.depth_mm / infeed_mm ? Hole::break_chip : Hole::other;
        cycle.peck_mm = infeed_mm;
      } else {
        cycle.hole = in_one ? Hole::drill : Hole::deep;
        cycle.peck_mm = in_one ? 0.0 : infeed_mm;
      }
      return true;
    case 205:
      if (!(infeed_mm > 0.0) || break_mm < 0.0) return false;
      cycle.hole = break_mm == 0.0 ? Hole::deep : in_one ? Hole::break_chip : Hole::other;
      cycle.peck_mm = break_mm == 0.0 ? infeed_mm : break_mm;
      return true;
    case 201:
      cycle.hole = Hole::feed_out;
      return true;
    case 202:
      cycle.hole = parameters.value(214).value_or(0.0) == 0.0 ? Hole::spindle_stop : Hole::other;
      return true;
    case 206:
      cycle.hole = Hole::tap;
      return true;
    case 207:
    case 209: {
      constexpr double largest_pitch_mm = 99.9999;
      const double pitch_mm = *parameters.value(239);
      cycle.hole = pitch_mm < 0.0 ? Hole::tap_left : Hole::tap;
      cycle.pitch_mm = std::abs(pitch_mm);
      cycle.peck_mm = break_mm < cycle.depth_mm ? break_mm : 0.0;
      return cycle.pitch_mm > 0.0 && cycle.pitch_mm <= largest_pitch_mm && break_mm >= 0.0;
    }
    default:
      cycle.hole = Hole::drill;
      return true;
  }
}

}  // namespace

bool CycleParameters::read(Scanner& scanner, ItemStream& items) {
  const auto fail = [&](std::string_view what) {
    return items.fail(Code::not_in_dialect, std::string{"CYCL DEF: "}.append(what));
  };
  while (!scanner.at_end()) {
    Decimal number;
    Decimal value;
    constexpr std::uint64_t largest_number = 1999;
    if (!scanner.take("Q") || !scanner.number(number) || !number.is_plain_integer() ||
        number.mantissa > largest_number || !scanner.take("="))
      return fail("Q parameters with their values are expected behind the name");
    One one{.number = static_cast<int>(number.mantissa), .value = {}};
    const char first = scanner.ahead();
    if (first == 'Q') return fail(q_name(one.number) + ": Q parameters are not evaluated");
    if ((first >= 'A' && first <= 'Z') || first == '"')
      scanner.word();
    else if (!scanner.number(value))
      return fail(q_name(one.number) + " has no value");
    else
      one.value = value.value();
    if (count_ == most ||
        std::any_of(begin(), end(), [&](const One& other) { return other.number == one.number; }))
      return fail(q_name(one.number) + " stands twice, or there are too many");
    all_[count_++] = one;
  }
  return true;
}

std::optional<double> CycleParameters::value(int number) const {
  const auto* const found =
      std::find_if(begin(), end(), [number](const One& one) { return one.number == number; });
  return found == end() ? std::nullopt : found->value;
}

bool is_drilling_cycle(int number) { return find_rules(number) != nullptr; }

std::optional<Cycle> drilling_cycle(int number, const CycleParameters& parameters,
                                    ItemStream& items) {
  const CycleRules& rules = *find_rules(number);
  if (!is_understood(rules, parameters, items)) return std::nullopt;
  Cycle cycle;
  cycle.word = rules.word;
  cycle.number = number;
  cycle.surface_z_mm = *parameters.value(203);
  cycle.depth_mm = -*parameters.value(201);
  cycle.clearance_mm = *parameters.value(200);
  // A 2nd set-up clearance below the first one has no effect.
  cycle.retract_mm = std::max(cycle.clearance_mm, *parameters.value(204));
  cycle.dwell_s = number == 206 ? 0.0 : parameters.value(211).value_or(0.0);
  cycle.feed_mm_min = parameters.value(206).value_or(0.0);
  if (!set_hole(cycle, parameters)) {
    fail(items, rules, "its infeeds or its pitch are not understood");
    return std::nullopt;
  }
  if (!is_in_range(rules, cycle, items)) return std::nullopt;
  return cycle;
}

}  // namespace pentapost::nc::readers::klartext
