#pragma once

#include "pentapost/nc/reader.hpp"

namespace pentapost::nc::readers {

/// Milling programs of Fanuc 30i/31i (G code system of the M series, increment system IS-B).
/// Source: FANUC Series 30i operator's manual, Common and Machining Center System.
///
/// Fails on every word that moves the machine in a way not modelled (macros, subprograms, cutter
/// compensation, tilted planes, polar coordinates, block skip ...), and where the program relies on
/// a state that it has not set itself (G90/G91, G20/G21, G17, feed mode, motion).
Status read_fanuc_30i(std::string_view text, const ReaderSetup& setup, const ItemSink& sink);

}  // namespace pentapost::nc::readers
