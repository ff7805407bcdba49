#pragma once
// How many threads or processes are worth having side by side. No model of hardware.

namespace bump {

/// Cores that this process may run on (its affinity), at least 1.
int cores_of_process();

}  // namespace bump
