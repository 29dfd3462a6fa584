// Cases of the trainer as JSON: coapt.training_case/1, of the command line and the browser's engine alike.
#pragma once

#include "io/json/json.h"
#include "search/training/exam_a.h"
#include "search/training/exam_b.h"

namespace coapt {

/// Choices are counted from 1. `rules`, by which it was made, are its limits.
Json to_json(const ExamACase& made, const Valve& from, const ExamARules& rules = {});
Json to_json(const ExamBCase& made, const Valve& from, const ExamBRules& rules = {});

/// Adds what a page needs to show the case: "valve" (coapt.valve/1), arrested(), that is pulled; its "flaccid_mm"; of exam B
/// "pressed_valve", the same with its tips under pressure; of each choice "closed_mm". Shapes are flat lists [x, y, z, x, ...] of
/// vertices, rounded to 0.001 mm.
void add_shapes(Json& json, const ExamACase& made);
void add_shapes(Json& json, const ExamBCase& made);

}  // namespace coapt
