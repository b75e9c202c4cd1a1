// Replaces the global operator new of the whole test program by one that counts.
#include "tests/allocations.hpp"

#include <cstdlib>
#include <new>

namespace {

thread_local long count = 0;

void* counted(std::size_t size, std::size_t alignment) noexcept {
    ++count;
    const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
    return std::aligned_alloc(alignment, rounded == 0 ? alignment : rounded);
}

void* or_throw(void* memory) {
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

constexpr std::size_t ordinary = __STDCPP_DEFAULT_NEW_ALIGNMENT__;
constexpr std::size_t number_of(std::align_val_t alignment) { return static_cast<std::size_t>(alignment); }

}  // namespace

// Every form that pairs with a delete below, so that a sanitizer sees one allocator; the array forms call these.
// Not inlined: g++ 12 takes an inlined pair for a mismatch of new and free.
[[gnu::noinline]] void* operator new(std::size_t size) { return or_throw(counted(size, ordinary)); }
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
    return or_throw(counted(size, number_of(alignment)));
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return counted(size, ordinary);
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
    return counted(size, number_of(alignment));
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

long ordo::test::allocations() { return count; }
