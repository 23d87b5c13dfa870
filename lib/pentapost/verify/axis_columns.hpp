#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/kinematics/model.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace pentapost::verify {

/// Words of one block as printed (mm, degrees), in the order of the letters.
using Words = std::array<double, 5>;

/// Which joint of the model each word letter commands.
class AxisColumns {
 public:
  /// @param letters  one a joint: linear names A to Z, then rotary names A to Z.
  /// @return Problem proof_failed unless every letter is a joint and every joint has its letter.
  static Result<AxisColumns> make(std::string_view letters, const kinematics::Model& model);

  std::size_t count() const { return 3 + rotary_count_; }
  std::uint8_t all() const { return static_cast<std::uint8_t>((1U << count()) - 1U); }
  static constexpr std::uint8_t linear = 0b111;  ///< columns of linear joints
  std::uint8_t rotary() const { return static_cast<std::uint8_t>(all() & ~linear); }
  /// Column of the letter; nullopt: there is none.
  std::optional<std::size_t> find(char letter) const;

  /// Joint values that the words command.
  kinematics::Joints joints(const Words& words) const {
    return {.linear_mm = {words[0], words[1], words[2]},
            .first_rad = rotary_count_ > 0 ? words[first_] * rad_per_deg : 0.0,
            .second_rad = rotary_count_ > 1 ? words[second_] * rad_per_deg : 0.0};
  }

 private:
  std::array<char, 5> letters_{};
  std::size_t rotary_count_ = 0;
  std::size_t first_ = 3,
              second_ = 4;  ///< columns of the rotary joints, nearest the workpiece first
};

}  // namespace pentapost::verify
