#pragma once
// ROM contents, tabulated once and shared by every evaluator that reads the table: contents live as long as one of their readers. Keyed on
// the identity of the shared table, never on its address alone, so that a new table in old memory gets contents of its own. Safe to call
// from several threads.

#include <memory>

#include "datapath/table.h"

namespace bump {

std::shared_ptr<const TableContents> contents_of(const TablePtr& table);

}  // namespace bump
