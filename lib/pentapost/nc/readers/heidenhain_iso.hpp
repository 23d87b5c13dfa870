#pragma once

#include "pentapost/nc/reader.hpp"

namespace pentapost::nc::readers {

/// DIN/ISO programs of Heidenhain TNC controls.
/// Source: HEIDENHAIN user's manuals DIN/ISO programming, TNC 426/430, iTNC 530 and TNC 640.
///
/// Fails on every word that moves the machine in a way not modelled (cycles, labels, polar
/// coordinates, Q parameters, radius compensation, mirroring, tilted planes ...), and where the
/// program relies on a state that it has not set itself (G90/G91, G17 for arcs, motion, feed).
Status read_heidenhain_iso(std::string_view text, const ReaderSetup& setup, const ItemSink& sink);

}  // namespace pentapost::nc::readers
