#include "server/request_ids.hpp"

#include <cstdint>
#include <memory>
#include <mutex>
#include <random>

namespace pentapost::server {
namespace {

struct Source {
  std::mutex mutex;
  std::mt19937_64 random;
};

void append_hexadecimal(std::string& out, std::uint64_t number) {
  for (int shift = 60; shift >= 0; shift -= 4) out += "0123456789abcdef"[(number >> shift) & 15];
}

}  // namespace

std::function<std::string()> random_request_ids() {
  auto source = std::make_shared<Source>();
  std::random_device device;
  std::seed_seq seed{device(), device(), device(), device()};
  source->random.seed(seed);
  return [source] {
    std::string id;
    const std::lock_guard lock{source->mutex};
    append_hexadecimal(id, source->random());
    append_hexadecimal(id, source->random());
    return id;
  };
}

}  // namespace pentapost::server
