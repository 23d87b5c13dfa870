#pragma once

#include "pentapost/nc/reader.hpp"

namespace pentapost::nc::readers {

/// Conversational programs of Heidenhain TNC controls.
/// Source: HEIDENHAIN user's manuals conversational programming and cycle programming, iTNC 530 and
/// TNC 640.
///
/// Fails on every word that moves the machine in a way not modelled (labels, Q parameters, radius
/// compensation, surface normals, approach and departure, tilted planes ...), and where the program
/// relies on a state that it has not set itself (feed, pole, tool axis for arcs).
Status read_heidenhain_klartext(std::string_view text, const ReaderSetup& setup,
                                const ItemSink& sink);

}  // namespace pentapost::nc::readers
