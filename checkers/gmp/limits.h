// SPDX-License-Identifier: Apache-2.0
// Limits of memory and time. Reaching one ends the process at once, with the right last line:
// nothing has been written to standard output before the verdict.
#pragma once

#include <cstddef>

void installMemoryAccounting();            // routes GMP's allocations through the accounting
void setMemoryLimit(std::size_t bytes);    // 0: none
std::size_t memoryLimit();
void accountForeignMemory(std::size_t before, std::size_t after);  // memory that zstd allocated by itself
void setTimeLimit(double seconds);
void disarmTimeLimit();                    // before the verdict is written
void installSignalHandlers();
void announceJson(bool json);              // the form of the last words
