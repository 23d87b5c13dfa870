#include "pentapost/cl/dialects.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace pentapost::cl {
namespace {

TEST(ClDialects, HaveDifferentNames) {
  std::set<std::string_view> names;
  for (const ClDialect& dialect : cl_dialects()) names.insert(dialect.name);
  EXPECT_EQ(names.size(), cl_dialects().size());
  EXPECT_EQ(cl_dialects().back().name, "apt");
}

TEST(FindClDialect, KnowsEachByItsName) {
  for (const ClDialect& dialect : cl_dialects()) EXPECT_EQ(find_cl_dialect(dialect.name), &dialect);
  EXPECT_EQ(find_cl_dialect("NX"), nullptr);
}

TEST(DetectClDialect, FindsEachByItsMarks) {
  const std::pair<const char*, const char*> cases[] = {
      {"TOOL PATH/A,TOOL,B\n", "nx-clsf"},
      {"\n\tInformation listing created by\tme\n", "nx-clsf"},
      {"GOTO/1,2,3\nEND-OF-PATH\n", "nx-clsf"},
      {"$$     Generated on\n$$     CATIA APT VERSION 1.0\n", "catia-apt"},
      {"$$*          Pro/CLfile  Version 8.0\n", "creo-ncl"},
      {"PARTNO / X\n$$-> FEATNO / 3\n", "creo-ncl"},
      {"PPRINT/APTCL-SPEC,MAKINO-FF,1\n", "makino-aptcl"},
      {"PARTNO/X\nTRNTYP/WORLD\n", "solidworks-cam-apt"},
      {"PARTNO/X\nCIRCLE/0,0,0,0,0,1,5,COUNTERCLOCKWISE\n", "solidworks-cam-clt"},
      {"$$ NCCS N-SEE 2000\n", "nccs-apt"},
      {"MODE/MILL\nPARTNO/'X'\n", "fusion-apt"},
      {"PARTNO/X\nUNITS/MM\n", "apt"},
      {"PARTNO/'X'\nPPRINT/'Y'\nMOVARC/0,0,0,0,0,1,5,ANGLE,90\n", "apt"},
      {"", "apt"}};
  for (const auto& [text, name] : cases) EXPECT_EQ(detect_cl_dialect(text).name, name) << text;
}

TEST(DetectClDialect, LooksAtTheFirstLinesOnly) {
  std::string text(400, '\n');
  EXPECT_EQ(detect_cl_dialect(text + "END-OF-PATH").name, "apt");
  EXPECT_EQ(detect_cl_dialect(text.substr(1) + "END-OF-PATH").name, "nx-clsf");
}

}  // namespace
}  // namespace pentapost::cl
