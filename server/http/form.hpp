#pragma once

#include "pentapost/core/result.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace pentapost::server {

/// One field of a web form. Views into the body.
struct FormField {
  std::string name;
  std::string_view content;
  std::string file_name = {};  ///< as the client calls the file; empty: none
};

/// Takes a multipart/form-data body (RFC 7578) apart.
///
/// @param content_type  the request's Content-Type, which holds the boundary.
/// @return the fields in order; Problem bad_form where it is damaged or has more than 16 fields.
Result<std::vector<FormField>> read_form(std::string_view content_type, std::string_view body);

}  // namespace pentapost::server
