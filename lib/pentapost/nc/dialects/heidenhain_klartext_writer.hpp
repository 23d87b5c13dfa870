#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/nc/axis_words.hpp"
#include "pentapost/nc/common_blocks.hpp"
#include "pentapost/nc/common_options.hpp"
#include "pentapost/nc/program_text.hpp"
#include "pentapost/path/motion.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pentapost::nc {

/// What shops change on this control, beside the options that all controls share.
struct KlartextSettings {
  CommonSettings common;
  std::size_t program_name_length = 0;
  std::vector<std::string> blank_form;    ///< behind BEGIN PGM
  std::vector<std::string> speed_change;  ///< of the spindle without a tool change; {speed}
  std::vector<std::string> program_stop;
  bool modal_words = true;              ///< leave out axis words that do not change
  bool depth_reference = false;         ///< write Q395
  double chip_break_mm = 0.0;           ///< Q256: back so far to break the chip
  double advanced_stop_mm = 0.0;        ///< Q258, Q259: rapid down to so far above the last depth
  double retraction_feed_mm_min = 0.0;  ///< Q208 of cycle 203
};

/// Writes one program; what the control holds modal at each block is kept here.
/// Blocks are in heidenhain_klartext_writer.cpp, arcs in .._arcs.cpp, cycles in .._cycles.cpp,
/// actions in .._actions.cpp.
class KlartextWriter {
 public:
  /// All must outlive the writer.
  KlartextWriter(const path::Motion& motion, const KlartextSettings& settings, std::string& out);

  void start(const path::ProgramHeader& header);
  void finish();

  /// False: problem() says why, and nothing more is to be written.
  bool write(const path::Block& block);
  bool act(const path::ToolCall& call, std::uint32_t cl_line);
  bool act(const path::Spindle& spindle, std::uint32_t cl_line);
  bool act(const path::Coolant& coolant, std::uint32_t cl_line);
  bool act(const path::Dwell& dwell, std::uint32_t cl_line);
  bool act(const path::Stop& stop, std::uint32_t cl_line);
  bool act(const path::Comment& said, std::uint32_t cl_line);
  bool act(const path::InsertedText& inserted, std::uint32_t cl_line);
  bool act(const path::ArcCentre& centre, std::uint32_t cl_line);
  bool act(const path::TcpOn& on, std::uint32_t cl_line);
  bool act(const path::TcpOff& off, std::uint32_t cl_line);
  bool act(const path::SafeRetract& retract, std::uint32_t cl_line);
  bool act(const path::NativeCycle& cycle, std::uint32_t cl_line);
  bool act(const path::NativeCycleEnd& end, std::uint32_t cl_line);
  bool act(const path::ProgramEnd& end, std::uint32_t cl_line);

  const std::optional<Problem>& problem() const noexcept { return problem_; }

 private:
  enum class CycleState : std::uint8_t { off, ordered, written };
  struct Parameter {
    int number = 0;
    std::string value;
    std::string_view name;
  };
  using Parameters = std::vector<Parameter>;
  struct PlanePoint {
    double x = 0.0, y = 0.0;
  };

  // heidenhain_klartext_writer.cpp
  bool write_rapid(const path::Block& block);
  bool write_line(const path::Block& block, double feed_mm_min);
  std::uint8_t words_of(const path::Block& block) const;
  void start_smoothing(const path::Block& block);
  /// Held to what the control takes.
  bool write_feed(std::string& out, double feed_mm_min, std::uint32_t cl_line);

  // heidenhain_klartext_arcs.cpp
  bool write_arc(const path::Block& block);
  void write_circle(const path::Block& block, std::string& out);
  void write_helix(const path::Block& block, PlanePoint centre, std::string& out);
  PlanePoint place_in_plane() const;

  // heidenhain_klartext_cycles.cpp
  bool write_hole(const path::Block& block);
  bool write_cycle(std::uint32_t cl_line);
  bool cycle_fits() const;
  bool feed_parameter(Parameters& parameters, std::uint32_t cl_line);
  bool pitch_parameter(Parameters& parameters, std::uint32_t cl_line);
  bool drilling(std::uint32_t cl_line);
  bool chip_breaking(std::uint32_t cl_line);
  bool pecking(std::uint32_t cl_line);
  bool reaming(std::uint32_t cl_line);
  bool boring(std::uint32_t cl_line);
  bool tapping(std::uint32_t cl_line);
  Parameters levels() const;
  Parameter surface() const;
  Parameter second_clearance() const;
  Parameter dwell_at_depth() const;
  std::string length(std::int64_t count) const;
  void define(std::string_view head, Parameters parameters, bool has_depth_reference);
  void end_cycle();

  // heidenhain_klartext_actions.cpp
  bool change_speed(double speed_rpm, std::uint32_t cl_line);
  void restart_spindle();
  void restart_coolant();
  void comment(std::string_view said);
  void forget();
  void lose_linear_position();
  bool refuse(Problem problem);
  /// Whether there is no Problem; keeps one.
  bool done(std::optional<Problem> problem);

  const path::Motion& motion_;
  const KlartextSettings& settings_;
  AxisWords words_;
  FeedWord feed_;
  ProgramText text_;
  CommonBlocks blocks_;
  std::optional<Problem> problem_;

  std::string name_;                  ///< "NAME MM", as in the first and the last block
  bool compensation_is_off_ = false;  ///< R0 was written
  std::optional<double> speed_rpm_;   ///< that the control holds
  path::Spindle spindle_;             ///< as it turns, with the last speed that was stated
  path::Coolant coolant_;
  bool tcp_is_on_ = false;
  std::optional<path::ArcCentre> centre_;
  std::optional<PlanePoint> behind_helix_;  ///< where the angle of a helix ended, mm
  bool inserted_goes_on_ = false;           ///< ~ at its end joins the next text to it
  path::NativeCycle cycle_;
  CycleState cycle_state_ = CycleState::off;
};

}  // namespace pentapost::nc
