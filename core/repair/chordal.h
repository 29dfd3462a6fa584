// What is done to chordae: new ones, other lengths, excision, transfer.
#pragma once

#include <string>

#include "core/repair/plan.h"
#include "core/valve/problem_list.h"

namespace coapt {

bool check_neochorda(const Neochorda& step, const Valve& valve, const std::string& path,
                     ProblemList& problems);
bool check_length_change(const ChordalLengthChange& step, const Valve& valve,
                         const std::string& path, ProblemList& problems);
bool check_excision(const ChordalExcision& step, const Valve& valve, const std::string& path,
                    ProblemList& problems);
bool check_transfer(const ChordalTransfer& step, const Valve& valve, const std::string& path,
                    ProblemList& problems);

/// What a neochorda is, as text: equal for equal steps, and an order for those that differ.
std::string text_key(const Neochorda& step);

/// Appends a chorda of one segment, called "neochorda-1" or the next free number. It is as stiff as
/// a native chorda of 1 mm (an assumption; ePTFE sutures are thinner and stiffer).
void apply_neochorda(const Neochorda& step, const LeafletCoordinates& coordinates, Valve& valve);

/// Changes the rest length of the segments that leave the papillary head.
void apply_length_change(const ChordalLengthChange& step, Valve& valve);

void apply_excision(const ChordalExcision& step, Valve& valve);

/// All insertions of the chorda go to the new point. Rest lengths are kept; branch points follow in
/// proportion to their distance from the head.
void apply_transfer(const ChordalTransfer& step, const LeafletCoordinates& coordinates,
                    Valve& valve);

}  // namespace coapt
