#pragma once
// An error in documents: the word for its kind, and its text part by part. Every JSON document of the program that reports an error uses
// these.

#include <nlohmann/json_fwd.hpp>

#include "datapath/error.h"

namespace bump {

/// "error", "deadlock", "self_check_failed", "internal_error", "interrupted".
const char* status_of(ErrorKind kind);

/// {"what", "file", "line", "column", "why", "try"}, parts that are unknown null.
nlohmann::ordered_json to_json(const ErrorText& text);

}  // namespace bump
