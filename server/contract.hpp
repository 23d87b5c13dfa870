#pragma once

#include <span>
#include <string_view>

namespace pentapost::server {

/// A file of api/, as it was when the program was built.
struct ContractFile {
  std::string_view name;  ///< "machine.schema.json"
  std::string_view text;
};

/// api/openapi.yaml.
std::string_view openapi_text();
/// api/schemas/, sorted by name.
std::span<const ContractFile> schema_files();

}  // namespace pentapost::server
