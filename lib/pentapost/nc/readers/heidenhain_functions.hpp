#pragma once

namespace pentapost::nc::readers {

/// Whether an M function of a TNC neither moves an axis nor changes what the words mean, and needs
/// no attention beyond that.
bool is_harmless_heidenhain_function(int code);

}  // namespace pentapost::nc::readers
