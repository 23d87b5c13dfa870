#include "lib/nc/read_items.hpp"
#include "lib/nc/writer_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace pentapost {
namespace {

using nc::ReadMotion;
using path::Block;
using sample::MotionCase;

/// Blocks and actions as a planner may order them, from a seed.
path::Motion random_motion(std::uint64_t seed) {
  std::mt19937_64 random{seed};
  const auto below = [&random](std::int64_t bound) {
    return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(bound));
  };
  const bool tcp = seed % 2 == 0;
  MotionCase made{seed % 3 == 0 ? "XYZBC" : "XYZAC", tcp ? Output::tcp : Output::axes};
  const auto approach = [&] {
    if (tcp) made.act(path::TcpOn{});
    made.rapid({0, 0, 100, 0, 0});
  };
  const auto leave = [&] {
    if (tcp) made.act(path::TcpOff{});
    made.act(path::SafeRetract{});
  };
  path::ToolCall call;
  call.number = 5;
  made.act(path::SafeRetract{}).act(call);
  approach();
  for (int i = 0; i < 40; ++i) {
    switch (below(14)) {
      case 0:
        made.act(path::Dwell{0.5});
        continue;
      case 1:
        made.act(path::Comment{"G0 X5 (\"; 7"});
        continue;
      case 2:
        made.act(path::Stop{});
        continue;
      case 3:
        leave();
        made.act(call);
        approach();
        continue;
      case 4:
        made.rapid({0, 0, 0, 0, 0});
        break;
      case 5:
      case 6:
        if (tcp) continue;
        made.inverse({0, 0, 0, 0, 0}, 0.001 * static_cast<double>(1 + below(90'000'000)));
        break;
      default:
        made.line({0, 0, 0, 0, 0}, 0.001 * static_cast<double>(1 + below(9'000'000)));
    }
    const Block& before = made.motion.blocks[made.motion.blocks.size() - 2];
    Block& block = made.motion.blocks.back();
    for (std::size_t column = 0; column < 5; ++column)
      block.word[column] =
          below(3) == 0 ? before.word[column] : below(1'999'999) * (below(2) == 0 ? 1 : -1);
  }
  leave();
  return made.act(path::ProgramEnd{}).motion;
}

void expect_same(const path::Motion& motion, const std::string& text) {
  const auto read = sample::read_items("siemens-840d", text, motion.letters);
  ASSERT_EQ(read.message(), "") << text;
  std::vector<ReadMotion> found;
  for (const auto& one : read.motions())
    if (!one.machine_frame) found.push_back(one);
  ASSERT_EQ(found.size(), motion.blocks.size()) << text;
  for (std::size_t i = 0; i < found.size(); ++i) {
    SCOPED_TRACE(i);
    const Block& block = motion.blocks[i];
    ASSERT_EQ(found[i].tcp, motion.output == Output::tcp);
    ASSERT_NE(found[i].tool_length_offset, found[i].tcp);
    ASSERT_EQ(found[i].known, 0b11111);
    for (std::size_t column = 0; column < 5; ++column)
      ASSERT_EQ(found[i].position[column],
                decimal_value(block.word[column], motion.decimals(column)));
    if (block.kind == Block::Kind::rapid) {
      ASSERT_EQ(found[i].kind, ReadMotion::Kind::rapid);
      continue;
    }
    ASSERT_EQ(found[i].feed_mode, block.feed_mode == Block::Feed::inverse_time
                                      ? ReadMotion::Feed::inverse_time
                                      : ReadMotion::Feed::per_minute);
    ASSERT_LE(found[i].feed, block.feed * (1.0 + 1e-9));
    ASSERT_GE(found[i].feed, block.feed - 0.001 - block.feed * 1e-9);
  }
}

TEST(Siemens840dRoundTrip, ReadsBackTheWordsThatItWrites) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    const auto motion = random_motion(seed);
    machine::Options options;
    options["modal_words"] = seed % 5 != 0;
    options["block_numbers"] = seed % 7 == 0;
    options["messages"] = seed % 4 == 0;
    expect_same(motion, sample::program("siemens-840d", motion, options));
    if (HasFatalFailure()) return;
  }
}

TEST(Siemens840dRoundTrip, SurvivesEveryProgramThatIsCutOff) {
  const std::string text = sample::program("siemens-840d", random_motion(7));
  for (std::size_t length = 0; length + 4 < text.size(); ++length)
    ASSERT_FALSE(sample::read_items("siemens-840d", text.substr(0, length)).status.has_value())
        << length;
}

TEST(Siemens840dRoundTrip, SurvivesDamagedPrograms) {
  const std::string text =
      sample::program("siemens-840d", random_motion(8)) +
      "MCALL CYCLE84(10,0,2,-15,,0,4,,-0.8,0,477,477)\nMSG(\"A\")\nC=DC(5) CR=5 TURN=1\n";
  std::mt19937_64 random{11};
  const std::string alphabet = "GXYZACIJTDFSM0123456789.-+=(),;\"[]$%/: \n\r\t\xFF_abc";
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = text;
    for (int k = 0; k < 4; ++k)
      damaged[random() % damaged.size()] = alphabet[random() % alphabet.size()];
    for (const auto& motion : sample::read_items("siemens-840d", damaged).motions())
      for (const double position : motion.position) ASSERT_TRUE(std::isfinite(position));
  }
}

}  // namespace
}  // namespace pentapost
