#pragma once

#include "machines/bundled.hpp"

#include "pentapost/jobs/post.hpp"
#include "pentapost/nc/dialect.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

/// Jobs for tests: bundled machines and CL text.
namespace pentapost::sample {

inline std::string file_text(const std::filesystem::path& file) {
  std::ifstream in{file, std::ios::binary};
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

inline std::string papers_text(const std::string& name) {
  return file_text(std::filesystem::path{PENTAPOST_TESTS_DIR} / "data/papers" / name);
}

inline jobs::PostJob cl_job(const std::string& machine, std::string cl_text) {
  return {.machine = bundled_machine(machine), .path = jobs::ClText{.text = std::move(cl_text)}};
}

/// A CL program of feed moves at 1000 mm/min through `goto_lines`, after a rapid to the first.
inline std::string cl_program(const std::string& goto_lines) {
  return "UNITS/MM\nLOADTL/1\nSPINDL/RPM,8000,CLW\nFEDRAT/1000,MMPM\n" + goto_lines + "FINI\n";
}

/// The blocks of an NC text that hold axis words, without number, G01, F and block end.
inline std::vector<std::string> motion_words(const std::string& nc) {
  std::vector<std::string> found;
  std::istringstream lines{nc};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words{line};
    std::string kept, word;
    bool moves = false;
    while (words >> word) {
      if (word == "*" || word[0] == 'N' || word == "G01" || word == "G00" || word[0] == 'F')
        continue;
      if (std::string{"XYZABC"}.find(word[0]) == std::string::npos) {
        moves = false;
        kept.clear();
        break;
      }
      moves = true;
      kept += (kept.empty() ? "" : " ") + word;
    }
    if (moves) found.push_back(kept);
  }
  return found;
}

/// Values of one word letter in the order of the NC text.
inline std::vector<double> words(const std::string& nc, char letter) {
  std::vector<double> found;
  for (const std::string& block : motion_words(nc)) {
    const auto place = block.find(letter);
    if (place != std::string::npos)
      found.push_back(std::strtod(block.c_str() + place + 1, nullptr));
  }
  return found;
}

inline double span(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return *most - *least;
}

}  // namespace pentapost::sample
