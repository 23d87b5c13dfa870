#include "pentapost/json/definition_json.hpp"
#include "pentapost/json/machine_files.hpp"

#include "lib/json/demo_definition.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace pentapost::json {
namespace {

/// The machines of this repository.
LoadReport bundled() {
  return load_machines(std::filesystem::path{PENTAPOST_SOURCE_DIR} / "machines", sample::dialects);
}

machine::Definition definition(const std::string& name) {
  const auto report = bundled();
  const auto* const entry = report.library.find(name);
  if (entry == nullptr) throw std::runtime_error{"no machine " + name};
  return entry->definition;
}

/// The chain as ISO 10791-6 writes it: "w C A b Y X Z t".
std::string chain_text(const machine::Definition& definition) {
  std::string text = "w";
  for (const auto& joint : definition.chain.table()) text += " " + joint.name;
  text += " b";
  for (const auto& joint : definition.chain.head()) text += " " + joint.name;
  return text + " t";
}

TEST(BundledMachines, AllLoad) {
  for (const auto& bad : bundled().bad) ADD_FAILURE() << text_of(bad);
}

TEST(BundledMachines, AreTheSeventeen) {
  EXPECT_EQ(
      bundled().library.names(),
      (std::vector<std::string>{"dmu-125p", "dmu-50-evolution", "dmu-70-evo", "dmu-80-monoblock",
                                "dmu-80p-duoblock", "generic-3axis", "generic-4axis-a",
                                "generic-ca-head", "haas-umc-750", "hermle-c600u", "huron-kx100",
                                "linuxcnc-bridgemill", "linuxcnc-xyzac-trt", "linuxcnc-xyzbc-trt",
                                "makino-mag3", "mazak-variaxis-630", "pocket-nc-v2"}));
}

TEST(BundledMachines, PostBackAsInlineDefinitions) {
  const auto report = bundled();
  for (const auto& name : report.library.names()) {
    const auto* const entry = report.library.find(name);
    const auto inline_definition = definition_from_text(entry->bytes, sample::dialects, "/machine");

    ASSERT_TRUE(inline_definition) << name;
    EXPECT_EQ(inline_definition->sha256, entry->definition.sha256) << name;
  }
}

TEST(BundledMachines, HaveTheChainsOfTheirSources) {
  const std::vector<std::pair<std::string, std::string>> chains{
      {"hermle-c600u", "w C A b Y X Z t"},        {"dmu-50-evolution", "w C B b X Y Z t"},
      {"dmu-70-evo", "w C B b X Y Z t"},          {"haas-umc-750", "w C B b X Y Z t"},
      {"mazak-variaxis-630", "w C A b X Y Z t"},  {"dmu-125p", "w C Y b X Z B t"},
      {"dmu-80p-duoblock", "w C Y b X Z B t"},    {"dmu-80-monoblock", "w C Z b X Y B t"},
      {"huron-kx100", "w X b Y Z C B t"},         {"makino-mag3", "w X b Z Y C A t"},
      {"linuxcnc-xyzac-trt", "w C A b X Y Z t"},  {"linuxcnc-xyzbc-trt", "w C B b X Y Z t"},
      {"linuxcnc-bridgemill", "w b X Y Z C B t"}, {"pocket-nc-v2", "w B A b X Y Z t"},
      {"generic-ca-head", "w b X Y Z C A t"},     {"generic-3axis", "w b X Y Z t"},
      {"generic-4axis-a", "w A b X Y Z t"}};
  for (const auto& [name, chain] : chains) EXPECT_EQ(chain_text(definition(name)), chain) << name;
}

// Seen from the workpiece, a positive command of a linear joint moves the tool along its letter.
TEST(BundledMachines, MoveTheToolAlongTheLettersOfTheirLinearAxes) {
  const auto report = bundled();
  for (const auto& name : report.library.names()) {
    const auto& chain = report.library.find(name)->definition.chain;
    const auto look_at = [&](const machine::Joint& joint, double sign) {
      if (joint.is_rotary()) return;
      Vec3 expected = Vec3::Zero();
      expected[joint.name.front() - 'X'] = sign;
      EXPECT_EQ(std::get<machine::LinearJoint>(joint.kind).direction.vec(), expected)
          << name << " " << joint.name;
    };
    for (const auto& joint : chain.table()) look_at(joint, -1.0);
    for (const auto& joint : chain.head()) look_at(joint, 1.0);
  }
}

// Cripps et al. 2017, section 2.1: both rotary axes turn at 25 rpm at most.
TEST(BundledMachines, GiveTheHermle25Rpm) {
  const auto hermle = definition("hermle-c600u");

  EXPECT_NEAR(hermle.limits.at("A").max_speed.value() * 60.0 / (2.0 * pi), 25.0, 1e-12);
  EXPECT_NEAR(hermle.limits.at("C").max_speed.value() * 60.0 / (2.0 * pi), 25.0, 1e-12);
  EXPECT_EQ(hermle.limits.at("C").max_acceleration, std::nullopt);
}

// 25.4, 40 and 25 m/min.
TEST(BundledMachines, GiveLinearSpeedsInMillimetresPerSecond) {
  EXPECT_NEAR(definition("mazak-variaxis-630").limits.at("X").max_speed.value(), 423.3333333, 1e-6);
  EXPECT_NEAR(definition("huron-kx100").limits.at("Y").max_speed.value(), 666.6666667, 1e-6);
  EXPECT_NEAR(definition("makino-mag3").limits.at("Z").max_speed.value(), 416.6666667, 1e-6);
}

TEST(BundledMachines, NameTheirSources) {
  const auto report = bundled();
  for (const auto& name : report.library.names())
    for (const auto& source : report.library.find(name)->definition.sources)
      EXPECT_GT(source.size(), 10u) << name;
}

TEST(MachinesReadme, ShowsADefinitionThatLoads) {
  std::ifstream file{std::filesystem::path{PENTAPOST_SOURCE_DIR} / "machines/README.md"};
  const std::string readme{std::istreambuf_iterator<char>{file}, {}};
  const std::string_view fence = "```json\n";
  const auto begin = readme.find(fence);
  ASSERT_NE(begin, std::string::npos);
  const auto text = readme.substr(begin + fence.size(),
                                  readme.find("```", begin + fence.size()) - begin - fence.size());

  const auto example = definition_from_text(text, sample::dialects);

  ASSERT_TRUE(example) << example.error().message << " at " << example.error().pointer;
  EXPECT_EQ(chain_text(*example), "w C A b X Y Z t");
}

TEST(MachinesReadme, NamesEveryMachine) {
  std::ifstream file{std::filesystem::path{PENTAPOST_SOURCE_DIR} / "machines/README.md"};
  const std::string readme{std::istreambuf_iterator<char>{file}, {}};

  for (const auto& name : bundled().library.names())
    EXPECT_NE(readme.find("`" + name + "`"), std::string::npos) << name;
}

}  // namespace
}  // namespace pentapost::json
