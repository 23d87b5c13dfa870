#include "pentapost/cl/cycle_words.hpp"

#include "pentapost/core/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pentapost::cl {
namespace {

using Kind = path::CycleStart::Kind;

struct KindWord {
  std::string_view word;
  Kind kind;
};
constexpr std::array kind_words{
    KindWord{"DRILL", Kind::drill},  KindWord{"THRU", Kind::drill},
    KindWord{"SPOT", Kind::drill},   KindWord{"CDRILL", Kind::drill},
    KindWord{"CENTER", Kind::drill}, KindWord{"FACE", Kind::face},
    KindWord{"CSINK", Kind::face},   KindWord{"CBORE", Kind::face},
    KindWord{"BORE", Kind::bore},    KindWord{"BORE7", Kind::bore},
    KindWord{"BORE8", Kind::bore},   KindWord{"BORE9", Kind::bore},
    KindWord{"REAM", Kind::ream},    KindWord{"TAP", Kind::tap},
    KindWord{"RIGID", Kind::tap},    KindWord{"FLOAT", Kind::tap},
    KindWord{"DEEP", Kind::deep},    KindWord{"DEEP2", Kind::deep},
    KindWord{"DEEPHL", Kind::deep},  KindWord{"BRKCHP", Kind::break_chip},
};

std::optional<Kind> kind_of(const Word& word) {
  for (const KindWord& row : kind_words)
    if (word.is(row.word)) return row.kind;
  return std::nullopt;
}

/// The numbers of a CYCLE statement, in the statement's unit.
struct CycleNumbers {
  std::optional<double> depth, clearance, rapid_to, retract, peck, dwell, dwell_turns, feed, pitch;
  FeedUnit feed_unit = {};
  std::vector<double> positional;
  std::optional<std::size_t> positional_before_unit;  ///< count of them when the unit word came
};

/// Word that gives the number behind it to one of the members.
struct NamedNumber {
  std::string_view word;
  std::optional<double> CycleNumbers::*member;
};
constexpr std::array named_numbers{
    NamedNumber{"DEPTH", &CycleNumbers::depth},     NamedNumber{"FEDTO", &CycleNumbers::depth},
    NamedNumber{"CLEAR", &CycleNumbers::clearance}, NamedNumber{"RAPTO", &CycleNumbers::rapid_to},
    NamedNumber{"RTRCTO", &CycleNumbers::retract},  NamedNumber{"RETURN", &CycleNumbers::retract},
    NamedNumber{"RETRCT", &CycleNumbers::retract},  NamedNumber{"STEP", &CycleNumbers::peck},
    NamedNumber{"STEP1", &CycleNumbers::peck},      NamedNumber{"INCR", &CycleNumbers::peck},
    NamedNumber{"PECK", &CycleNumbers::peck},       NamedNumber{"DWELL", &CycleNumbers::dwell},
    NamedNumber{"PITCH", &CycleNumbers::pitch},
};
constexpr std::array words_without_number{"ON",     "AUTO",  "MANUAL", "DRAG", "NODRAG",
                                          "LEFT",   "RIGHT", "CLW",    "CCLW", "NONE",
                                          "NOMORE", "RAPID", "NODWELL"};

/// Takes the words one after the other.
class CycleReader {
 public:
  CycleReader(const Words& words, CycleStatement& statement)
      : words_{words}, statement_{statement} {}

  CycleNumbers read(std::size_t first) {
    for (at_ = first; at_ < words_.size(); ++at_) take(words_[at_]);
    return std::move(numbers_);
  }

 private:
  bool number_follows() const { return at_ + 1 < words_.size() && words_[at_ + 1].is_number(); }

  void take(const Word& word) {
    if (word.is_number()) {
      numbers_.positional.push_back(word.number);
    } else if (const auto unit = feed_unit(word)) {
      numbers_.feed_unit = *unit;
      numbers_.positional_before_unit = numbers_.positional.size();
    } else if (word.is("1STPECK")) {
      if (number_follows() && !numbers_.peck) numbers_.peck = words_[at_ + 1].number;
      if (number_follows()) ++at_;
    } else if (!take_named(word) && !take_plain(word)) {
      statement_.remarks.push_back("The word " + quoted_excerpt(word.text) +
                                   " of the cycle is not known and was left out.");
      if (number_follows()) ++at_;
    }
  }

  bool take_named(const Word& word) {
    for (const NamedNumber& row : named_numbers) {
      if (!word.is(row.word)) continue;
      const bool is_dwell = row.member == &CycleNumbers::dwell;
      if (is_dwell && at_ + 2 < words_.size() && words_[at_ + 1].is("REV") &&
          words_[at_ + 2].is_number()) {
        numbers_.dwell_turns = words_[at_ + 2].number;
        at_ += 2;
      } else if (number_follows()) {
        numbers_.*row.member = words_[++at_].number;
        if (is_dwell && at_ + 1 < words_.size() && words_[at_ + 1].is("REV")) {
          std::swap(numbers_.dwell, numbers_.dwell_turns);
          ++at_;
        }
      }
      return true;
    }
    return false;
  }

  bool take_plain(const Word& word) {
    if (kind_of(word)) return true;
    return std::any_of(words_without_number.begin(), words_without_number.end(),
                       [&](std::string_view known) { return word.is(known); });
  }

  const Words& words_;
  CycleStatement& statement_;
  CycleNumbers numbers_;
  std::size_t at_ = 0;
};

/// Gives the numbers without a name their meaning.
void name_positional(CycleNumbers& numbers) {
  auto& left = numbers.positional;
  const auto take = [&](std::size_t i) {
    const double number = left[i];
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
    return number;
  };
  const std::size_t needed_before = numbers.depth ? 1 : 2;
  if (numbers.positional_before_unit && !left.empty()) {
    // "depth, feed, IPM, clearance" or "depth, IPM, feed, clearance".
    const std::size_t before = *numbers.positional_before_unit;
    const bool feed_is_before = before >= needed_before || before == left.size();
    if (feed_is_before && before > 0)
      numbers.feed = take(before - 1);
    else if (before < left.size())
      numbers.feed = take(before);
  }
  if (!numbers.depth && !left.empty()) numbers.depth = take(0);
  if (!numbers.feed && !numbers.positional_before_unit && left.size() >= 2) numbers.feed = take(0);
  if (!numbers.clearance && !left.empty()) numbers.clearance = take(0);
}

class CycleMaker {
 public:
  CycleMaker(const CycleNumbers& numbers, const CycleContext& context, CycleStatement& statement)
      : numbers_{numbers}, context_{context}, statement_{statement}, mm_{mm_per(context.units)} {}

  void make() {
    if (!depth() || !heights() || !peck() || !feed()) return;
    dwell();
    statement_.action = CycleStatement::Action::start;
  }

 private:
  bool fault(std::string why, Code code = Code::bad_cycle) {
    statement_.fault = std::move(why);
    statement_.fault_code = code;
    return false;
  }

  bool depth() {
    if (!numbers_.depth || *numbers_.depth == 0.0) return fault("it has no depth");
    if (context_.dialect->depth_is_signed && *numbers_.depth > 0.0)
      statement_.remarks.emplace_back(
          "The depth of the cycle is positive, which would be above the hole: it was taken as "
          "depth below.");
    statement_.cycle.depth_mm = std::abs(*numbers_.depth) * mm_;
    return statement_.cycle.depth_mm <= 1e6 || fault("its depth is more than 1e6 mm");
  }

  bool heights() {
    auto& cycle = statement_.cycle;
    const double clear_mm = numbers_.clearance.value_or(0.0) * mm_;
    if (context_.dialect->clearance_is_height) {
      if (!numbers_.clearance) return fault("it has no clearance");
      statement_.retract_height_mm = clear_mm;
      statement_.feed_below_retract_mm = std::max(0.0, numbers_.rapid_to.value_or(0.0) * mm_);
      return true;
    }
    const auto start = numbers_.rapid_to ? numbers_.rapid_to : numbers_.clearance;
    if (!start)
      statement_.remarks.emplace_back(
          "The cycle has no clearance: feed starts at the hole's reference point.");
    cycle.clearance_mm = start.value_or(0.0) * mm_;
    if (cycle.clearance_mm < 0.0) return fault("its clearance is below the hole's reference point");
    double retract_mm = cycle.clearance_mm;
    if (numbers_.clearance) retract_mm = std::max(retract_mm, clear_mm);
    if (numbers_.retract) retract_mm = std::max(retract_mm, *numbers_.retract * mm_);
    if (retract_mm > cycle.clearance_mm) cycle.retract_mm = retract_mm;
    return true;
  }

  bool peck() {
    auto& cycle = statement_.cycle;
    if (cycle.kind != Kind::deep && cycle.kind != Kind::break_chip) return true;
    if (!numbers_.peck || !(*numbers_.peck > 0.0)) {
      statement_.remarks.emplace_back("The cycle has no depth of peck: one peck was taken.");
      return true;
    }
    cycle.peck_mm = *numbers_.peck * mm_;
    return cycle.depth_mm <= most_pecks * *cycle.peck_mm ||
           fault("it needs more than 1000 pecks a hole", Code::too_large);
  }

  bool feed() {
    auto& cycle = statement_.cycle;
    if (numbers_.pitch) cycle.pitch_mm = std::abs(*numbers_.pitch) * mm_;
    if (!numbers_.feed) return true;
    if (!(*numbers_.feed > 0.0)) return fault("its feed is not above 0");
    const FeedUnit unit = numbers_.positional_before_unit ? numbers_.feed_unit : context_.feed_unit;
    const double feed_mm = *numbers_.feed * mm_per(unit.length.value_or(context_.units));
    if (!unit.per_revolution) {
      cycle.feed_mm_min = feed_mm;
      return true;
    }
    if (cycle.kind == Kind::tap || cycle.kind == Kind::tap_left) cycle.pitch_mm = feed_mm;
    if (!context_.speed_rpm || !(*context_.speed_rpm > 0.0))
      return fault("its feed is per revolution and no spindle speed is known",
                   Code::feed_per_revolution);
    cycle.feed_mm_min = feed_mm * *context_.speed_rpm;
    return true;
  }

  void dwell() {
    double time_s = numbers_.dwell.value_or(0.0);
    if (numbers_.dwell_turns && context_.speed_rpm.value_or(0.0) > 0.0)
      time_s = *numbers_.dwell_turns * 60.0 / *context_.speed_rpm;
    else if (numbers_.dwell_turns)
      statement_.remarks.emplace_back(
          "The dwell of the cycle is in revolutions and no spindle speed is known: it was left "
          "out.");
    statement_.cycle.dwell_s = std::clamp(time_s, 0.0, 86400.0);
  }

  const CycleNumbers& numbers_;
  const CycleContext& context_;
  CycleStatement& statement_;
  double mm_;
};

/// Kind of the cycle from all its words: "DRILL,DEEP" is deep, "BORE,DRAG" is bore_drag.
std::optional<Kind> kind_of(const Words& words, const CycleContext& context) {
  std::optional<Kind> found;
  for (const Word& word : words) {
    const auto kind = kind_of(word);
    if (kind && (!found || *found == Kind::drill)) found = kind;
  }
  if (found == Kind::bore && words.has("DRAG")) return Kind::bore_drag;
  const bool left = words.has("LEFT") || words.has("CCLW");
  if (found == Kind::tap && (left || context.spindle_counterclockwise)) return Kind::tap_left;
  return found;
}

}  // namespace

CycleStatement read_cycle(const Words& words, const CycleContext& context) {
  CycleStatement statement;
  if (words.has_damage()) {
    statement.fault = "a number is damaged";
    return statement;
  }
  const bool is_empty = words.size() == 0;
  if (!is_empty && (words[0].is("OFF") || words[0].is("NOMORE") || words[0].is("END"))) {
    statement.action = CycleStatement::Action::off;
    return statement;
  }
  if (words.size() == 1 && words[0].is("ON")) {
    statement.action = CycleStatement::Action::resume;
    return statement;
  }
  if (!is_empty && words[0].is("INIT")) {
    statement.action = CycleStatement::Action::none;
    return statement;
  }
  const auto kind = kind_of(words, context);
  if (!kind) {
    statement.fault = "its kind is not known";
    return statement;
  }
  if (words.has("BACK")) {
    statement.fault = "it bores from below, which has no counterpart here";
    return statement;
  }
  statement.cycle.kind = *kind;
  for (const std::string_view exit : {"MANUAL", "NODRAG"})
    if (*kind == Kind::bore && words.has(exit))
      statement.remarks.push_back("The word " + std::string{exit} +
                                  " asks for a way out of the hole that the cycle does not take: "
                                  "it was left out.");
  CycleNumbers numbers = CycleReader{words, statement}.read(0);
  name_positional(numbers);
  CycleMaker{numbers, context, statement}.make();
  return statement;
}

}  // namespace pentapost::cl
