#include "pentapost/machine/library.hpp"

#include "sample/chains.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace pentapost::machine {
namespace {

LibraryEntry entry(std::string name, std::string version) {
  return {.definition = {.name = std::move(name),
                         .version = std::move(version),
                         .title = "demo",
                         .sources = {"a test"},
                         .chain = sample::trunnion_ac(),
                         .limits = {},
                         .preferences = {},
                         .controller = {},
                         .sha256 = {}},
          .bytes = {}};
}

Library two_machines() {
  std::vector<LibraryEntry> entries;
  entries.push_back(entry("mill", "1.9.0"));
  entries.push_back(entry("lathe", "0.1.0"));
  entries.push_back(entry("mill", "1.10.0"));
  entries.push_back(entry("mill", "1.2.0"));
  return Library{std::move(entries)};
}

TEST(Library, GivesTheNewestVersion) {
  const auto library = two_machines();

  ASSERT_NE(library.find("mill"), nullptr);
  EXPECT_EQ(library.find("mill")->definition.version, "1.10.0");
}

TEST(Library, GivesAPinnedVersion) {
  const auto library = two_machines();

  ASSERT_NE(library.find("mill", "1.2.0"), nullptr);
  EXPECT_EQ(library.find("mill", "1.2.0")->definition.version, "1.2.0");
}

TEST(Library, HasNoneForUnknownNamesAndVersions) {
  const auto library = two_machines();

  EXPECT_EQ(library.find("mil"), nullptr);
  EXPECT_EQ(library.find("mill", "1.0.0"), nullptr);
  EXPECT_EQ(library.find("mil", "1.2.0"), nullptr);
  EXPECT_EQ(library.find(""), nullptr);
}

TEST(Library, ListsNamesSorted) {
  EXPECT_EQ(two_machines().names(), (std::vector<std::string>{"lathe", "mill"}));
}

TEST(Library, ListsVersionsNewestFirst) {
  EXPECT_EQ(two_machines().versions("mill"),
            (std::vector<std::string>{"1.10.0", "1.9.0", "1.2.0"}));
  EXPECT_TRUE(two_machines().versions("mil").empty());
}

TEST(Library, OffersNearNames) {
  EXPECT_EQ(two_machines().near_names("mil"), std::vector<std::string>{"mill"});
}

TEST(Library, ThrowsWhereAVersionStandsTwice) {
  std::vector<LibraryEntry> entries;
  entries.push_back(entry("mill", "1.0.0"));
  entries.push_back(entry("mill", "1.0.0"));

  EXPECT_THROW(Library{std::move(entries)}, std::logic_error);
}

TEST(Library, ThrowsWhereAVersionIsNone) {
  std::vector<LibraryEntry> entries;
  entries.push_back(entry("mill", "newest"));
  entries.push_back(entry("mill", "1.0.0"));

  EXPECT_THROW(Library{std::move(entries)}, std::logic_error);
}

TEST(Library, IsEmptyByDefault) {
  EXPECT_TRUE(Library{}.empty());
  EXPECT_TRUE(Library{}.names().empty());
}

}  // namespace
}  // namespace pentapost::machine
