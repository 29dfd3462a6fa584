// The operations, a line each: their files have what they read.
#pragma once

#include "operations/operation.h"

namespace coapt {

Expected<OperationTask> read_close(const Json& request, const Context& context);
Expected<OperationTask> read_scene(const Json& request, const Context& context);
Expected<OperationTask> read_open(const Json& request, const Context& context);
Expected<OperationTask> read_compare(const Json& request, const Context& context);
Expected<OperationTask> read_diagnose(const Json& request, const Context& context);
Expected<OperationTask> read_check(const Json& request, const Context& context);
Expected<OperationTask> read_training_case(const Json& request, const Context& context);
Expected<OperationTask> read_training_exam(const Json& request, const Context& context);
Expected<OperationTask> read_training_score(const Json& request, const Context& context);

Expected<OperationTask> read_observe(const Json& request, const Context& context);
Expected<OperationTask> read_information(const Json& request, const Context& context);
Expected<OperationTask> read_plan(const Json& request, const Context& context);
Expected<OperationTask> read_evaluate(const Json& request, const Context& context);
Expected<OperationTask> read_report(const Json& request, const Context& context);
Expected<OperationTask> read_prefer(const Json& request, const Context& context);
Expected<OperationTask> read_physiology(const Json& request, const Context& context);
Expected<OperationTask> read_export(const Json& request, const Context& context);
Expected<OperationTask> read_export_files(const Json& request, const Context& context);
Expected<OperationTask> read_fit(const Json& request, const Context& context);
Expected<OperationTask> read_import(const Json& request, const Context& context);
Expected<OperationTask> read_model(const Json& request, const Context& context);
Expected<OperationTask> read_picture(const Json& request, const Context& context);

}  // namespace coapt
