#include "pentapost/core/number_text.hpp"
#include "pentapost/core/units.hpp"
#include "pentapost/nc/dialects/heidenhain_klartext_writer.hpp"
#include "pentapost/nc/refusals.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

// TNC 640 user's manual conversational programming: circle centre CC, circular path C, helix CP
// with an incremental polar angle of the sign of DR.
namespace pentapost::nc {
namespace {

constexpr int angle_decimals = 4;  ///< of IPA
constexpr double full_turn_deg = 360.0;

}  // namespace

bool KlartextWriter::write_arc(const path::Block& block) {
  if (!centre_) throw std::logic_error{"heidenhain: an arc without a centre"};
  const std::size_t z = words_.z();
  const std::uint8_t along = z == WordColumns::none ? std::uint8_t{0} : bit(z);
  if (auto misfit = words_.arc_misfit(block, along)) return refuse(std::move(*misfit));
  start_smoothing(block);
  const WordColumns& columns = words_.columns();
  const std::size_t x = words_.x();
  const std::size_t y = words_.y();
  const std::int64_t centre_x = words_.at(x) + centre_->i;
  const std::int64_t centre_y = words_.at(y) + centre_->j;
  if (!columns.fits(x, centre_x) || !columns.fits(y, centre_y))
    return refuse(
        refusal(Code::out_of_domain, "the centre of an arc has too many digits", block.cl_line));
  std::string& pole = text_.begin_block();
  pole += "CC ";
  append_word(pole, 'X', centre_x, columns.decimals(x), words_.style());
  append_word(pole, 'Y', centre_y, columns.decimals(y), words_.style());
  text_.end_block();

  const bool is_helix = along != 0 && words_.moves(block, z);
  std::string& out = text_.begin_block();
  if (is_helix)
    write_helix(block,
                {decimal_value(centre_x, columns.decimals(x)),
                 decimal_value(centre_y, columns.decimals(y))},
                out);
  else
    write_circle(block, out);
  if (!write_feed(out, block.feed, block.cl_line)) return false;
  text_.end_block();
  centre_.reset();
  words_.place(block);
  // The end of a helix is an angle: X and Y are there to its last digit alone.
  if (is_helix) words_.restate_all();
  return true;
}

void KlartextWriter::write_circle(const path::Block& block, std::string& out) {
  out += "C ";
  words_.append(out, block, static_cast<std::uint8_t>(bit(words_.x()) | bit(words_.y())));
  out += block.kind == path::Block::Kind::arc_clockwise ? "DR- " : "DR+ ";
  behind_helix_.reset();
}

/// The angle leads from where the block before really ended, so that its last digits do not add up.
void KlartextWriter::write_helix(const path::Block& block, PlanePoint centre, std::string& out) {
  const std::size_t x = words_.x();
  const std::size_t y = words_.y();
  const int decimals = words_.columns().decimals(x);
  const PlanePoint start = place_in_plane();
  const double from_x = start.x - centre.x;
  const double from_y = start.y - centre.y;
  const double to_x = decimal_value(block.word[x], decimals) - centre.x;
  const double to_y = decimal_value(block.word[y], decimals) - centre.y;
  const bool clockwise = block.kind == path::Block::Kind::arc_clockwise;
  const bool is_full = block.word[x] == words_.at(x) && block.word[y] == words_.at(y);
  double angle_deg =
      std::atan2(from_x * to_y - from_y * to_x, from_x * to_x + from_y * to_y) * deg_per_rad;
  if (is_full || (clockwise ? angle_deg > 0.0 : angle_deg < 0.0))
    angle_deg += clockwise ? -full_turn_deg : full_turn_deg;
  const std::int64_t angle = decimal_count(angle_deg, angle_decimals);
  out += "CP IPA";
  append_decimal(out, angle, angle_decimals, words_.style());
  out += ' ';
  words_.append(out, block, bit(words_.z()));
  out += clockwise ? "DR- " : "DR+ ";
  const double printed_rad = decimal_value(angle, angle_decimals) * rad_per_deg;
  const double cosine = std::cos(printed_rad);
  const double sine = std::sin(printed_rad);
  behind_helix_ = PlanePoint{centre.x + from_x * cosine - from_y * sine,
                             centre.y + from_x * sine + from_y * cosine};
}

KlartextWriter::PlanePoint KlartextWriter::place_in_plane() const {
  if (behind_helix_) return *behind_helix_;
  const WordColumns& columns = words_.columns();
  return {decimal_value(words_.at(words_.x()), columns.decimals(words_.x())),
          decimal_value(words_.at(words_.y()), columns.decimals(words_.y()))};
}

}  // namespace pentapost::nc
