#pragma once
// How often this thread of the test program has allocated: tests/allocations.cpp replaces the global operator new.
namespace ordo::test {

long allocations();

}  // namespace ordo::test
