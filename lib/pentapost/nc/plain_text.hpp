#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pentapost::nc {

/// `utf8` as printable ASCII: accented Latin letters become plain ones (a umlaut: "ae"), control
/// characters (line ends too) a blank, everything else "?".
std::string printable_ascii(std::string_view utf8);

/// `text` as printable ASCII without the characters `forbidden`, cut at blanks into lines of at
/// most `width` characters. Without a word in it: no lines.
std::vector<std::string> comment_lines(std::string_view text, std::string_view forbidden,
                                       std::size_t width);

/// `name` in upper case, with only letters, digits, "_" and "-", at most `longest` characters;
/// what is left out becomes one "_". Nothing left: "PROGRAM".
std::string clean_program_name(std::string_view name, std::size_t longest);

/// ASCII letters in upper case.
std::string upper_case(std::string text);

/// `line` with every `{name}` replaced, trailing blanks trimmed.
std::string filled(std::string line, std::string_view placeholder, std::string_view replacement);

}  // namespace pentapost::nc
