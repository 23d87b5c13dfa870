#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>

namespace pentapost::server {

/// The bytes of a file ("-": standard input); nullopt: not readable, said on stderr.
std::optional<std::string> read_file(const std::string& name);

/// Whether two names are those of one file, which need not exist yet. An empty name is none; what
/// is no file, such as a pipe or /dev/null, can be named twice.
bool is_same_file(const std::string& one, const std::string& other);

/// A text on its way to a file, or to a stream where the file has no name. A file gets the whole
/// text or keeps what it has: prepare() writes the text beside it, finish() puts it into its place.
/// What is no file is written to by finish(); a symbolic link stays one. Failures are said on
/// stderr.
class TextOutput {
 public:
  TextOutput(std::string name, std::ostream& stream, std::string text)
      : name_{std::move(name)}, stream_{stream}, text_{std::move(text)} {}
  ~TextOutput();
  TextOutput(const TextOutput&) = delete;
  TextOutput& operator=(const TextOutput&) = delete;

  /// False: the file cannot be written.
  bool prepare();
  /// After a prepare() that was true.
  bool finish();

 private:
  bool refuse() const;

  std::string name_;
  std::ostream& stream_;
  std::string text_;
  std::filesystem::path place_ = {};  ///< of the file; empty: the stream
  std::filesystem::path part_ = {};   ///< beside it; empty: there is none
};

}  // namespace pentapost::server
