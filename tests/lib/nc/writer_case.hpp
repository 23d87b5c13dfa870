#pragma once

#include "pentapost/core/number_text.hpp"
#include "pentapost/nc/dialect.hpp"
#include "pentapost/path/motion.hpp"

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pentapost::sample {

/// Builds a Motion block by block, in millimetres and degrees.
class MotionCase {
 public:
  explicit MotionCase(std::string letters = "XYZAC", Output output = Output::tcp) {
    motion.letters = std::move(letters);
    motion.output = output;
  }
  MotionCase& line(std::initializer_list<double> words, double feed_mm_min) {
    return add(path::Block::Kind::line, words, path::Block::Feed::per_minute, feed_mm_min);
  }
  MotionCase& inverse(std::initializer_list<double> words, double feed_per_min) {
    return add(path::Block::Kind::line, words, path::Block::Feed::inverse_time, feed_per_min);
  }
  MotionCase& rapid(std::initializer_list<double> words) {
    return add(path::Block::Kind::rapid, words, path::Block::Feed::none, 0.0);
  }
  MotionCase& hole(std::initializer_list<double> words) {
    return add(path::Block::Kind::drill, words, path::Block::Feed::none, 0.0);
  }
  MotionCase& arc(path::Block::Kind kind, std::initializer_list<double> words, double i_mm,
                  double j_mm, double feed_mm_min) {
    act(path::ArcCentre{decimal_count(i_mm, 3), decimal_count(j_mm, 3)});
    return add(kind, words, path::Block::Feed::per_minute, feed_mm_min);
  }
  /// The last block states only these columns.
  MotionCase& stating(std::uint8_t mask) {
    motion.blocks.back().stated = mask;
    return *this;
  }
  MotionCase& act(path::ActionKind what) {
    motion.actions.push_back(
        {static_cast<std::uint32_t>(motion.blocks.size()), next_line, std::move(what)});
    return *this;
  }

  path::Motion motion;
  std::uint32_t next_line = 0;  ///< CL line of what is added

 private:
  MotionCase& add(path::Block::Kind kind, std::initializer_list<double> words,
                  path::Block::Feed mode, double feed) {
    path::Block block;
    std::size_t column = 0;
    for (const double word : words) {
      block.word.at(column) = decimal_count(word, motion.decimals(column));
      ++column;
    }
    block.kind = kind;
    block.feed_mode = mode;
    block.feed = feed;
    block.cl_line = next_line;
    motion.blocks.push_back(block);
    return *this;
  }
};

inline path::ProgramHeader named(std::string program_name, std::string machine = {},
                                 std::string machine_hash = {}) {
  path::ProgramHeader header;
  header.program_name = std::move(program_name);
  header.machine = std::move(machine);
  header.machine_hash = std::move(machine_hash);
  return header;
}

/// The whole program; throws where the dialect refuses it.
inline std::string program(std::string_view dialect, const path::Motion& motion,
                           const machine::Options& options = {},
                           const path::ProgramHeader& header = {}) {
  std::string out;
  const Status status = nc::find_dialect(dialect)->write(motion, header, options, out);
  if (!status) throw std::runtime_error{status.error().message};
  return out;
}

/// The Problem that writing gives; throws where there is none.
inline Problem refused(std::string_view dialect, const path::Motion& motion,
                       const machine::Options& options = {}) {
  std::string out;
  const Status status = nc::find_dialect(dialect)->write(motion, {}, options, out);
  if (status) throw std::runtime_error{"the program was written: " + out};
  return status.error();
}

/// Options of a program that is its blocks alone.
inline const machine::Options bare{{"comments", false},
                                   {"start_lines", std::vector<std::string>{}}};

inline machine::Options bare_with(const std::string& name, machine::OptionValue value) {
  machine::Options options = bare;
  options[name] = std::move(value);
  return options;
}

namespace fanuc {

/// What stands between the program number and the last %.
inline std::string body(const path::Motion& motion, const machine::Options& options = bare) {
  const std::string nc = program("fanuc-30i", motion, options);
  const auto first = nc.find('\n', 2) + 1;
  return nc.substr(first, nc.rfind('%') - first);
}

}  // namespace fanuc

namespace heidenhain {

/// What stands between the first and the last line.
inline std::string body(const path::Motion& motion, const machine::Options& options = bare) {
  const std::string nc = program("heidenhain-iso", motion, options);
  const auto first = nc.find('\n') + 1;
  return nc.substr(first, nc.rfind('N') - first);
}

}  // namespace heidenhain

namespace klartext {

/// Options of a program that is its blocks alone, without their numbers.
inline machine::Options options_with(const std::string& name, machine::OptionValue value) {
  return {{"comments", false}, {"block_numbers", false}, {name, std::move(value)}};
}

/// What stands between the first and the last line.
inline std::string body(const path::Motion& motion,
                        const machine::Options& options = {{"comments", false},
                                                           {"block_numbers", false}}) {
  const std::string nc = program("heidenhain", motion, options);
  const auto first = nc.find('\n') + 1;
  return nc.substr(first, nc.rfind("END PGM") - first);
}

}  // namespace klartext

namespace siemens {

/// What stands behind the first line.
inline std::string body(const path::Motion& motion, const machine::Options& options = bare) {
  const std::string nc = program("siemens-840d", motion, options);
  return nc.substr(nc.find('\n') + 1);
}

}  // namespace siemens
}  // namespace pentapost::sample
