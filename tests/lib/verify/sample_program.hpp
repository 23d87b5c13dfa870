#pragma once

#include "pentapost/nc/reader.hpp"
#include "pentapost/verify/proof.hpp"
#include "sample/chains.hpp"

#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

/// A CL path, a witness and a program, put together by hand for tests. The program is in a small
/// language of its own, whose reader is below: independent of dialects and of their readers.
///
///   T2            tool            S3000 / S-3000 / S0   spindle clockwise / counterclockwise / off
///   TCP1 / TCP0   TCP on / off    LEN1 / LEN0           length offset       H2   length register
///   RETRACT       safe retract    END                   end of the program
///   G0 X1 Y2 ...                  rapid                 G1 X1 ... F500   line
///   G93 X1 ... F12                line, inverse time
///   G2 X Y Z I J F, G3 ...        arc; I J: centre, absolute; N: whole turns
///   DRILL X Y Z R W Q P K F       hole: bottom Z, clearance R, retract W, peck Q, dwell P, kind K
///                                 (number of ReadMotion::Hole), reached at level V, or where the
///                                 tool is
namespace pentapost::sample {

/// Where the words of the small language are kept between its lines.
class SmallReader {
 public:
  SmallReader(const nc::ReaderSetup& setup, const nc::ItemSink& sink)
      : letters_{setup.letters}, sink_{sink} {}

  Status read(std::string_view text) {
    std::istringstream lines{std::string{text}};
    std::string line;
    for (item_.text_line = 1; std::getline(lines, line); ++item_.text_line) {
      const Status taken = read_line(line);
      if (!taken) return taken;
    }
    return ok();
  }

 private:
  Status send(const decltype(nc::ReadItem::what)& what) {
    item_.what = what;
    return sink_(item_);
  }

  Status read_line(const std::string& line) {
    std::istringstream words{line};
    std::string word;
    if (!(words >> word)) return ok();
    const double number = std::strtod(word.c_str() + 1, nullptr);
    if (word == "END") return send(nc::ReadEnd{});
    if (word == "RETRACT") {
      known_ &= 0b11000;
      return send(nc::ReadSafeRetract{});
    }
    if (word == "TCP1" || word == "TCP0") {
      motion_.tcp = word == "TCP1";
      return ok();
    }
    if (word == "LEN1" || word == "LEN0") {
      motion_.tool_length_offset = word == "LEN1";
      return ok();
    }
    if (word[0] == 'H') {
      motion_.length_register = static_cast<int>(number);
      return ok();
    }
    if (word[0] == 'T') return send(nc::ReadTool{static_cast<int>(number)});
    if (word[0] == 'S') {
      using State = nc::ReadSpindle::State;
      return send(nc::ReadSpindle{number > 0   ? State::clockwise
                                  : number < 0 ? State::counterclockwise
                                               : State::off,
                                  std::abs(number)});
    }
    return read_motion(word, words);
  }

  Status read_motion(const std::string& code, std::istringstream& words) {
    using Kind = nc::ReadMotion::Kind;
    using Feed = nc::ReadMotion::Feed;
    nc::ReadMotion motion = motion_;
    motion.kind = code == "G0"                   ? Kind::rapid
                  : code == "G2" || code == "G3" ? Kind::arc
                  : code == "DRILL"              ? Kind::drill
                                                 : Kind::line;
    motion.clockwise = code == "G2";
    motion.feed_mode = code == "G0"    ? Feed::none
                       : code == "G93" ? Feed::inverse_time
                                       : Feed::per_minute;
    motion.position = position_;
    if ((known_ & 0b100) != 0) motion.travel_z_mm = position_[2];
    std::string word;
    while (words >> word) set_word(motion, word[0], std::strtod(word.c_str() + 1, nullptr));
    motion.feed = feed_;
    known_ = static_cast<std::uint8_t>(known_ | motion.stated);
    motion.known = known_;
    position_ = motion.position;
    if (motion.kind == Kind::drill) position_[2] = motion.retract_z_mm;
    return send(motion);
  }

  void set_word(nc::ReadMotion& motion, char letter, double number) {
    const std::size_t column = letters_.find(letter);
    if (column != std::string::npos) {
      motion.position[column] = number;
      motion.stated = static_cast<std::uint8_t>(motion.stated | 1U << column);
    }
    if (letter == 'F') feed_ = number;
    if (letter == 'I') motion.centre_x_mm = number;
    if (letter == 'J') motion.centre_y_mm = number;
    if (letter == 'N') motion.whole_turns = static_cast<int>(number);
    if (letter == 'V') motion.travel_z_mm = number;
    if (letter == 'R') motion.clearance_z_mm = number;
    if (letter == 'W') motion.retract_z_mm = number;
    if (letter == 'Q') motion.peck_mm = number;
    if (letter == 'P') motion.dwell_s = number;
    if (letter == 'K') motion.hole = static_cast<nc::ReadMotion::Hole>(static_cast<int>(number));
    if (letter == 'D') motion.datum_shift[0] = number;
    if (letter == 'M') motion.machine_frame = number != 0.0;
  }

  std::string letters_;
  const nc::ItemSink& sink_;
  nc::ReadItem item_;
  nc::ReadMotion motion_;
  std::array<double, 5> position_{};
  std::uint8_t known_ = 0;
  double feed_ = 0.0;
};

inline const nc::Reader small_reader{
    "small", [](std::string_view text, const nc::ReaderSetup& setup, const nc::ItemSink& sink) {
      return SmallReader{setup, sink}.read(text);
    }};

/// All that a proof needs, changeable before it is run.
struct Program {
  kinematics::Model model;
  path::ToolPath cl = {};
  path::Motion motion = {};
  std::vector<std::string> lines = {};
  Output output = Output::tcp;
  Vec3 origin_mm = Vec3::Zero();
  std::map<int, double> gauge_length_mm = {};
  double tip_mm = 0.01, axis_deg = 0.05;

  Program(const machine::Chain& chain, std::string letters) : model{chain} {
    motion.letters = std::move(letters);
  }

  /// A CL point; its line number is ten times its place, counted from 1.
  void point(const Vec3& tip_mm_given, const Vec3& axis, path::Move move = path::Move::feed) {
    cl.add_point(tip_mm_given, axis, static_cast<std::uint32_t>(10 * (cl.size() + 1)), move);
  }
  void line(const std::string& text) { lines.push_back(text); }
  /// A motion block and its witness.
  void block(const std::string& text, std::uint32_t point_index, double fraction = 1.0,
             bool is_on_path = true) {
    line(text);
    path::Block witness;
    witness.point = point_index;
    witness.fraction = fraction;
    witness.on_path = is_on_path;
    if (text.starts_with("G0")) witness.kind = path::Block::Kind::rapid;
    motion.blocks.push_back(witness);
  }
  void off(const std::string& text, std::uint32_t point_index) {
    block(text, point_index, 1.0, false);
  }
  /// Replaces a part of a program line; the first line that holds it.
  void change(const std::string& found, const std::string& replacement) {
    for (std::string& text : lines) {
      const std::size_t at = text.find(found);
      if (at == std::string::npos) continue;
      text.replace(at, found.size(), replacement);
      return;
    }
    std::abort();
  }

  Result<verify::Proof> prove() {
    std::string text;
    for (const std::string& each : lines) text += each + '\n';
    const verify::Claim claim{.tool_path = cl,
                              .model = model,
                              .motion = motion,
                              .reader_setup = {.letters = motion.letters},
                              .output = output,
                              .origin_mm = origin_mm,
                              .gauge_length_mm = gauge_length_mm,
                              .tip_tolerance_mm = tip_mm,
                              .axis_tolerance_rad = axis_deg * rad_per_deg};
    return verify::prove(text, small_reader, claim);
  }
  /// The message of the failure; empty where the proof passes.
  std::string failure() {
    const auto proof = prove();
    return proof ? std::string{} : proof.error().message;
  }
};

}  // namespace pentapost::sample
