#include "server/http/gzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace pentapost::server {
namespace {

constexpr int gzip_window_bits = 15 + 16;  // + 16: gzip's header rather than zlib's
constexpr int memory_level = 8;

struct Deflater {
  Deflater() {
    if (deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, gzip_window_bits, memory_level,
                     Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::runtime_error("zlib could not be started");
  }
  ~Deflater() { deflateEnd(&stream); }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;
  z_stream stream = {};
};

}  // namespace

std::string gzip(std::string_view text) {
  constexpr std::size_t input_step = 1 << 20;
  Deflater deflater;
  auto& stream = deflater.stream;
  std::string result;
  int state = Z_OK;
  while (state != Z_STREAM_END) {
    const auto part = text.substr(0, input_step);
    text.remove_prefix(part.size());
    // zlib does not write to its input; the interface predates const.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(part.data()));
    stream.avail_in = static_cast<uInt>(part.size());
    do {
      char output[1 << 16];
      stream.next_out = reinterpret_cast<Bytef*>(output);
      stream.avail_out = sizeof output;
      state = deflate(&stream, text.empty() ? Z_FINISH : Z_NO_FLUSH);
      if (state == Z_STREAM_ERROR) throw std::runtime_error("zlib refused its input");
      result.append(output, sizeof output - stream.avail_out);
    } while (stream.avail_out == 0 && state != Z_STREAM_END);
  }
  return result;
}

}  // namespace pentapost::server
