#include "server/text_files.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

namespace pentapost::server {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> read_stream(std::istream& stream) {
  std::string text{std::istreambuf_iterator<char>{stream}, {}};
  if (stream.bad()) return std::nullopt;
  return text;
}

/// True where there is something at this place that is no file: a pipe, a device, a folder.
bool is_no_file(const fs::path& place) {
  std::error_code error;
  return fs::exists(place, error) && !fs::is_regular_file(place, error);
}

/// Where a name leads; empty: nowhere. A link counts as what it points to, there or not.
fs::path place_of(const std::string& name) {
  std::error_code error;
  constexpr int most_links = 40;
  fs::path place{name};
  for (int i = 0; i < most_links && fs::is_symlink(place, error); ++i) {
    const auto target = fs::read_symlink(place, error);
    if (error) return {};
    place = place.parent_path() / target;
  }
  // Absolute first: a relative name that does not exist would stay relative.
  place = fs::weakly_canonical(fs::absolute(place, error), error);
  return error ? fs::path{} : place;
}

/// Writes a new file; false: not possible; `exists`: there is one already.
bool write_new(const fs::path& file, std::string_view text, bool& exists) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream{std::fopen(file.c_str(), "wbx"),
                                                               std::fclose};
  exists = stream == nullptr && errno == EEXIST;
  if (stream == nullptr) return false;
  const bool written = std::fwrite(text.data(), 1, text.size(), stream.get()) == text.size() &&
                       std::fflush(stream.get()) == 0;
  std::error_code error;
  if (!written) fs::remove(file, error);
  return written;
}

/// Writes `text` beside `place`, to a name that nothing has; empty: not possible.
fs::path write_beside(const fs::path& place, std::string_view text) {
  constexpr int most_names = 100;
  for (int i = 0; i < most_names; ++i) {
    const fs::path part = place.string() + ".part" + (i == 0 ? "" : std::to_string(i));
    bool exists = false;
    if (write_new(part, text, exists)) return part;
    if (!exists) break;
  }
  return {};
}

}  // namespace

std::optional<std::string> read_file(const std::string& name) {
  if (name == "-") return read_stream(std::cin);
  std::ifstream file{name, std::ios::binary};
  std::error_code error;
  const auto size = fs::file_size(name, error);
  std::string text;
  if (file && !error) {
    text.resize(size);
    file.read(text.data(), static_cast<std::streamsize>(size));
  } else if (file && !fs::is_directory(name, error)) {  // a pipe has no size
    auto piped = read_stream(file);
    if (piped) return piped;
  } else {
    file.setstate(std::ios::failbit);
  }
  if (file) return text;
  std::cerr << "pentapost: cannot read " << name << '\n';
  return std::nullopt;
}

bool is_same_file(const std::string& one, const std::string& other) {
  if (one.empty() || other.empty()) return false;
  const auto place = place_of(one);
  if (place.empty() || is_no_file(place)) return false;
  std::error_code error;
  return place == place_of(other) || fs::equivalent(one, other, error);
}

TextOutput::~TextOutput() {
  std::error_code error;
  if (!part_.empty()) fs::remove(part_, error);
}

bool TextOutput::refuse() const {
  std::cerr << "pentapost: cannot write " << (name_.empty() ? "to standard output" : name_) << '\n';
  return false;
}

bool TextOutput::prepare() {
  if (name_.empty()) return true;
  place_ = place_of(name_);
  if (place_.empty()) return refuse();
  std::error_code error;
  // Opening a pipe would wait for its reader.
  if (is_no_file(place_))
    return (!fs::is_directory(place_, error) && ::access(place_.c_str(), W_OK) == 0) || refuse();
  part_ = write_beside(place_, text_);
  return !part_.empty() || refuse();
}

bool TextOutput::finish() {
  if (place_.empty()) {
    stream_ << text_ << std::flush;
    return static_cast<bool>(stream_) || refuse();
  }
  if (part_.empty()) {
    std::ofstream other{place_, std::ios::binary};
    other << text_ << std::flush;
    return static_cast<bool>(other) || refuse();
  }
  std::error_code error;
  fs::rename(part_, place_, error);
  if (error) return refuse();
  part_.clear();
  return true;
}

}  // namespace pentapost::server
