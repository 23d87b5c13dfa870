#include "pentapost/nc/axis_words.hpp"

#include "pentapost/nc/refusals.hpp"

#include <stdexcept>
#include <utility>

namespace pentapost::nc {

std::optional<Problem> AxisWords::misfit(const path::Block& block) const {
  if ((block.stated & columns_.all()) == 0)
    throw std::logic_error{"AxisWords: a motion block without a word"};
  for (std::size_t column = 0; column < columns_.count(); ++column) {
    const std::int64_t count = block.word[column];
    if ((block.stated & bit(column)) == 0 || columns_.fits(column, count)) continue;
    std::string message(1, columns_.letter(column));
    message += " = ";
    append_decimal(message, count, columns_.decimals(column), {});
    message.append(" has more than the ").append(std::to_string(whole_digits_));
    message += " digits before the decimal point that the control takes";
    return refusal(Code::out_of_domain, std::move(message), block.cl_line);
  }
  return std::nullopt;
}

std::optional<Problem> AxisWords::arc_misfit(const path::Block& block, std::uint8_t also) const {
  const std::size_t none = WordColumns::none;
  if (x_ == none || y_ == none || (placed_ & bit(x_)) == 0 || (placed_ & bit(y_)) == 0)
    throw std::logic_error{"AxisWords: an arc without a start point"};
  if (block.feed_mode != path::Block::Feed::per_minute)
    throw std::logic_error{"AxisWords: an arc whose feed is not per minute"};
  const auto allowed = static_cast<std::uint8_t>(bit(x_) | bit(y_) | also);
  for (const std::size_t column : columns_) {
    if ((allowed & bit(column)) != 0 || !moves(block, column)) continue;
    return refusal(Code::not_in_dialect,
                   std::string{"an arc cannot move "} + columns_.letter(column) +
                       " as well; the option arcs can be set to false",
                   block.cl_line);
  }
  return std::nullopt;
}

void AxisWords::lose_linear() {
  for (std::size_t column = 0; column < columns_.count(); ++column) {
    if (columns_.is_linear(column)) lose(column);
  }
}

}  // namespace pentapost::nc
